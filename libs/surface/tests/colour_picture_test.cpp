// SPDX-License-Identifier: Apache-2.0
// The pictures are read with libpng's simplified interface, which shares no code with the writer under test.
#include <gtest/gtest.h>
#include <png.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "nazori/base/file.h"
#include "nazori/surface/colour_picture.h"
#include "temporary_folder.h"

namespace nazori::surface {
namespace {

using Bytes = std::vector<std::uint8_t>;

// Six colours that differ in every channel.
ColourPicture three_by_two() {
  return {3, 2, {255, 0, 1, 2, 254, 3, 4, 5, 253, 10, 20, 30, 40, 50, 60, 70, 80, 90}};
}

struct Decoded {
  png_uint_32 width = 0;
  png_uint_32 height = 0;
  Bytes rgb;
};

Decoded decoded(const Bytes& file) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&image, file.data(), file.size()) == 0) return {};
  image.format = PNG_FORMAT_RGB;
  Decoded out{image.width, image.height, Bytes(PNG_IMAGE_SIZE(image))};
  if (png_image_finish_read(&image, nullptr, out.rgb.data(), 0, nullptr) == 0) return {};
  return out;
}

TEST(ColourPicture, KeepsEveryColourInItsPlace) {
  const Decoded read = decoded(to_png(three_by_two()));
  EXPECT_EQ(read.width, 3U);
  EXPECT_EQ(read.height, 2U);
  EXPECT_EQ(read.rgb, three_by_two().rgb);
}

TEST(ColourPicture, SaysThatItsColoursAreThoseOfScreens) {
  const Bytes file = to_png(three_by_two());
  EXPECT_NE(std::string(file.begin(), file.end()).find("sRGB"), std::string::npos);
}

TEST(ColourPicture, OfNoSizeOrOfTheWrongNumberOfColoursIsNone) {
  EXPECT_TRUE(to_png(ColourPicture{}).empty());
  EXPECT_TRUE(to_png(ColourPicture{0, 2, {}}).empty());
  EXPECT_TRUE(to_png(ColourPicture{3, 0, {}}).empty());
  ColourPicture short_by_one = three_by_two();
  short_by_one.rgb.pop_back();
  EXPECT_TRUE(to_png(short_by_one).empty());
  ColourPicture one_more = three_by_two();
  one_more.rgb.push_back(0);
  EXPECT_TRUE(to_png(one_more).empty());
}

TEST(ColourPicture, IsSavedAsTheFileThatItsBytesAre) {
  const nazori::test::TemporaryFolder folder;
  const auto path = folder.path() / "picture.png";
  ASSERT_TRUE(save_png(three_by_two(), path));
  const auto file = base::read_file(path, 10'000);
  ASSERT_TRUE(file);
  EXPECT_EQ(*file, to_png(three_by_two()));
}

TEST(ColourPicture, ThatIsNoneIsNotSaved) {
  const nazori::test::TemporaryFolder folder;
  const auto path = folder.path() / "picture.png";
  const auto saved = save_png(ColourPicture{}, path);
  ASSERT_FALSE(saved);
  EXPECT_EQ(saved.error().code, base::Errc::bad_argument);
  EXPECT_EQ(saved.error().where, path.string());
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace nazori::surface
