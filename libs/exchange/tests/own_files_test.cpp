// SPDX-License-Identifier: Apache-2.0
#include "nazori/exchange/own_files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <string>

#include "nazori/kanji/stroke_order.h"

namespace nazori::exchange {
namespace {

namespace fs = std::filesystem;

class OwnFilesTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("nazori_own_files_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  /// A stroke from one corner to (x, y).
  [[nodiscard]] fs::path strokes(int x, int y) const {
    const fs::path file = folder_ / "a.str";
    EXPECT_TRUE(kanji::StrokeOrder({{{0, 0}, {x, y}}}).save(file));
    return file;
  }
  [[nodiscard]] fs::path map(int side) const {
    const fs::path file = folder_ / "a.raw";
    EXPECT_TRUE(surface::save_raw(*surface::HeightMap::create(side, 1.0F), file));
    return file;
  }
  fs::path folder_;
};

TEST_F(OwnFilesTest, AMapHasTheSizeThatItsFileSays) {
  const auto own = load_own_tablet({map(64), {}, {}, {}, {}}, 32);
  ASSERT_TRUE(own);
  EXPECT_EQ(own->map_size, 64);
  EXPECT_EQ(own->tablet->height_map().size(), 64);
  EXPECT_TRUE(own->tablet->lines().empty());
  EXPECT_FALSE(load_own_tablet({map(64), 63, {}, {}, {}}, 32)) << "it has another size";
}

TEST_F(OwnFilesTest, StrokesAloneAreCarved) {
  const auto own = load_own_tablet({{}, {}, strokes(127, 127), {}, {}}, 32);
  ASSERT_TRUE(own);
  EXPECT_EQ(own->map_size, 0);
  EXPECT_EQ(own->tablet->height_map().size(), 32);
  EXPECT_EQ(own->tablet->lines().size(), 1U);
}

TEST_F(OwnFilesTest, StrokesLieOnTheGridOfTheirMapUnlessToldOtherwise) {
  const auto at = [](const base::Result<OwnTablet>& own) { return own->tablet->lines()[0].points.back().x; };
  const double on_map = at(load_own_tablet({map(64), {}, strokes(31, 31), {}, {}}, 32));
  const double on_large_grid = at(load_own_tablet({map(64), {}, strokes(31, 31), 1024, {}}, 32));
  EXPECT_NEAR(on_map, 109.0 * 31 / 63, 1e-9);
  EXPECT_NEAR(on_large_grid, 109.0 * 31 / 1023, 1e-9);
  EXPECT_FALSE(load_own_tablet({map(64), {}, strokes(64, 0), {}, {}}, 32)) << "outside the map";
  EXPECT_NEAR(at(load_own_tablet({{}, {}, strokes(200, 0), {}, {}}, 32)), 109.0 * 200 / 255, 1e-9)
      << "guessed";
}

TEST_F(OwnFilesTest, StrokesGoOntoAMapThatIsThere) {
  OwnFiles files;
  files.strokes = strokes(31, 31);
  files.onto = surface::HeightMap::create(32, 0.5F).value();
  const auto own = load_own_tablet(files, 1024);
  ASSERT_TRUE(own);
  EXPECT_EQ(own->map_size, 32);
  files.height_map = map(64);
  EXPECT_EQ(load_own_tablet(files, 1024)->map_size, 64) << "a file goes before it";
}

TEST_F(OwnFilesTest, TheGridOfAStrokeFileIsGuessed) {
  const auto guess = [&](int x, int y) { return guess_grid(strokes(x, y)).value(); };
  EXPECT_EQ(guess(127, 3).side, 128);
  EXPECT_TRUE(guess(3, 64).certain);
  EXPECT_FALSE(guess(63, 63).certain);
  EXPECT_EQ(guess(3, 128).side, 256);
  EXPECT_FALSE(guess(3, 128).certain);
  EXPECT_EQ(guess_grid(folder_ / "none.str").error().code, base::Errc::not_found);
}

TEST_F(OwnFilesTest, AFileThatCannotBeReadIsNamed) {
  const auto none = load_own_tablet({folder_ / "none.png", {}, {}, {}, {}}, 32);
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().where.find("none.png"), std::string::npos);
  EXPECT_FALSE(load_own_tablet({{}, {}, folder_ / "none.str", {}, {}}, 32));
}

}  // namespace
}  // namespace nazori::exchange
