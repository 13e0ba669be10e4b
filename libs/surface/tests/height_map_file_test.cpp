// SPDX-License-Identifier: Apache-2.0
#include "nazori/surface/height_map_file.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "nazori/base/file.h"

namespace nazori::surface {
namespace {

namespace fs = std::filesystem;

class HeightMapFiles : public testing::Test {
 protected:
  HeightMapFiles() {
    std::string pattern = (fs::temp_directory_path() / "nazori-map-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
    slope_ = *HeightMap::create(4);
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 4; ++column)
        slope_.set(column, row, static_cast<float>(4 * row + column) * 17 / 255.0F);
    }
  }
  ~HeightMapFiles() override { fs::remove_all(folder_); }

  fs::path folder_;
  HeightMap slope_;
};

TEST_F(HeightMapFiles, AreKnownByWhatTheyHoldAndNotByTheirName) {
  ASSERT_TRUE(save_png(slope_, folder_ / "a.raw", PngDepth::bits_8));
  ASSERT_TRUE(save_raw(slope_, folder_ / "b.png"));
  ASSERT_TRUE(save_png(slope_, folder_ / "c", PngDepth::bits_8));
  for (const char* name : {"a.raw", "b.png", "c"}) {
    const auto map = load_height_map(folder_ / name);
    ASSERT_TRUE(map) << name << ": " << base::to_line(map.error());
    EXPECT_EQ(*map, slope_) << name;
  }
}

TEST_F(HeightMapFiles, TakeTheirSizeFromTheFileAndRefuseAnother) {
  ASSERT_TRUE(save_png(slope_, folder_ / "a.png", PngDepth::bits_8));
  ASSERT_TRUE(save_raw(slope_, folder_ / "b.raw"));
  EXPECT_TRUE(load_height_map(folder_ / "a.png", 4));
  EXPECT_TRUE(load_height_map(folder_ / "b.raw", 4));
  const auto png = load_height_map(folder_ / "a.png", 8);
  ASSERT_FALSE(png);
  EXPECT_EQ(png.error().code, base::Errc::bad_argument);
  EXPECT_EQ(png.error().where, (folder_ / "a.png").string());
  EXPECT_NE(png.error().what.find("4 x 4, not 8 x 8"), std::string::npos);
  const auto raw = load_height_map(folder_ / "b.raw", 8);
  ASSERT_FALSE(raw);
  EXPECT_EQ(raw.error().code, base::Errc::parse);
  EXPECT_EQ(raw.error().where.find((folder_ / "b.raw").string()), 0U);
}

TEST_F(HeightMapFiles, ThatAreMissingOrCutOffAreNamed) {
  EXPECT_EQ(load_height_map(folder_ / "none.raw").error().code, base::Errc::not_found);
  ASSERT_TRUE(base::write_file(folder_ / "cut.png", std::string("\x89PNG\r\n\x1A\n", 8)));
  const auto cut = load_height_map(folder_ / "cut.png");
  ASSERT_FALSE(cut);
  EXPECT_EQ(cut.error().where, (folder_ / "cut.png").string());
  EXPECT_NE(cut.error().what.find("PNG"), std::string::npos) << "eight bytes are a signature";
  ASSERT_TRUE(base::write_file(folder_ / "short", std::string("\x89PNG", 4)));
  EXPECT_TRUE(load_height_map(folder_ / "short"))
      << "four bytes that only begin like the signature are a RAW";
}

TEST_F(HeightMapFiles, OfAWrongSizeNameTheFileAndTheArgument) {
  ASSERT_TRUE(save_raw(slope_, folder_ / "b.raw"));
  EXPECT_EQ(load_height_map(folder_ / "b.raw", 1).error().where, (folder_ / "b.raw").string() + ": size");
}

TEST_F(HeightMapFiles, ThatCannotBeOneAreNotRead) {
  ASSERT_TRUE(base::write_file(folder_ / "large", std::string_view()));
  // 16 bits for each sample of the largest map, and 16 mebibytes.
  fs::resize_file(folder_ / "large", 2 * 8192 * 8192 + 16 * 1048576 + 1);
  EXPECT_EQ(load_height_map(folder_ / "large").error().code, base::Errc::io);
}

}  // namespace
}  // namespace nazori::surface
