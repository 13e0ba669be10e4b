// SPDX-License-Identifier: Apache-2.0
#include "nazori/scan/picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <turbojpeg.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "nazori/surface/colour_picture.h"

namespace nazori::scan {
namespace {

/// A ramp from black to white with a colour that has the same brightness everywhere.
surface::ColourPicture ramp() {
  surface::ColourPicture picture{128, 64, {}};
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 128; ++x) picture.rgb.insert(picture.rgb.end(), 3, static_cast<std::uint8_t>(2 * x));
  return picture;
}

std::vector<std::uint8_t> jpeg_of(const surface::ColourPicture& picture) {
  tjhandle writer = tjInitCompress();
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  EXPECT_EQ(tjCompress2(writer, picture.rgb.data(), picture.width, 0, picture.height, TJPF_RGB, &bytes, &size,
                        TJSAMP_420, 90, 0),
            0);
  std::vector<std::uint8_t> all(bytes, bytes + size);
  tjFree(bytes);
  tjDestroy(writer);
  return all;
}

TEST(Photo, PngAndJpegAreReadAsBrightness) {
  for (const auto& bytes : {surface::to_png(ramp()), jpeg_of(ramp())}) {
    const auto photo = parse_photo(bytes);
    ASSERT_TRUE(photo) << base::to_line(photo.error());
    EXPECT_EQ(photo->width, 128);
    EXPECT_EQ(photo->height, 64);
    for (const int x : {0, 40, 127}) EXPECT_NEAR(photo->at(x, 30), 2 * x, 4);
    EXPECT_NEAR(photo->sample(40.5, 30.25), 81, 4);
    EXPECT_NEAR(photo->sample(-100, 1e9), 0, 4) << "outside";
  }
}

/// The same JPEG with an Exif part that says how the camera was held.
std::vector<std::uint8_t> held(std::vector<std::uint8_t> jpeg, std::uint8_t orientation, bool big_endian) {
  std::vector<std::uint8_t> tiff = big_endian ? std::vector<std::uint8_t>{'M', 'M', 0, 42, 0, 0, 0, 8, 0, 2}
                                              : std::vector<std::uint8_t>{'I', 'I', 42, 0, 8, 0, 0, 0, 2, 0};
  // The tag ImageWidth before it, as in the files of cameras.
  const std::vector<std::uint8_t> big{1, 0, 0, 3, 0, 0, 0, 1,           0, 99, 0, 0, 1, 0x12,
                                      0, 3, 0, 0, 0, 1, 0, orientation, 0, 0,  0, 0, 0, 0};
  const std::vector<std::uint8_t> little{0, 1, 3, 0, 1, 0, 0,           0, 99, 0, 0, 0, 0x12, 1,
                                         3, 0, 1, 0, 0, 0, orientation, 0, 0,  0, 0, 0, 0,    0};
  tiff.insert(tiff.end(), (big_endian ? big : little).begin(), (big_endian ? big : little).end());
  std::vector<std::uint8_t> part{0xFF, 0xE1, 0, static_cast<std::uint8_t>(tiff.size() + 8), 'E', 'x', 'i',
                                 'f',  0,    0};
  part.insert(part.end(), tiff.begin(), tiff.end());
  jpeg.insert(jpeg.begin() + 2, part.begin(), part.end());
  return jpeg;
}

TEST(Photo, APhotographStandsUprightHoweverTheCameraWasHeld) {
  // A ramp to the right with a dark lower edge, as the file has it.
  surface::ColourPicture picture = ramp();
  for (std::size_t i = 3 * 128 * 48; i < picture.rgb.size(); ++i) picture.rgb[i] = 0;
  const auto jpeg = jpeg_of(picture);
  // The places where the bright ends of both edges are expected. @source the pictures of Exif 2.3.
  struct Case {
    std::uint8_t orientation;
    double bright_x, bright_y, dark_x, dark_y;  // shares of the sides
  };
  const Case cases[] = {{1, 0.95, 0.1, 0.95, 0.9}, {2, 0.05, 0.1, 0.05, 0.9}, {3, 0.05, 0.9, 0.05, 0.1},
                        {4, 0.95, 0.9, 0.95, 0.1}, {5, 0.1, 0.95, 0.9, 0.95}, {6, 0.9, 0.95, 0.1, 0.95},
                        {7, 0.9, 0.05, 0.1, 0.05}, {8, 0.1, 0.05, 0.9, 0.05}, {9, 0.95, 0.1, 0.95, 0.9}};
  for (const Case& c : cases) {
    for (const bool big_endian : {false, true}) {
      const auto photo = parse_photo(held(jpeg, c.orientation, big_endian));
      ASSERT_TRUE(photo) << base::to_line(photo.error());
      const bool is_turned = c.orientation >= 5 && c.orientation <= 8;
      EXPECT_EQ(photo->width, is_turned ? 64 : 128) << int(c.orientation);
      EXPECT_EQ(photo->height, is_turned ? 128 : 64) << int(c.orientation);
      EXPECT_GT(photo->sample(c.bright_x * photo->width, c.bright_y * photo->height), 220)
          << int(c.orientation);
      EXPECT_LT(photo->sample(c.dark_x * photo->width, c.dark_y * photo->height), 30) << int(c.orientation);
    }
  }
  // Cut anywhere, the part says nothing.
  const auto whole = held(jpeg, 6, true);
  for (std::size_t size = 0; size < 60; ++size) (void)parse_photo(std::span(whole).first(size));
}

std::vector<std::uint8_t> bytes_of(std::string_view text) { return {text.begin(), text.end()}; }

TEST(Photo, ADrawingInSvgIsDrawnOnWhitePaper) {
  const auto photo = parse_photo(
      bytes_of("<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 200 100\">"
               "<rect x=\"100\" y=\"0\" width=\"100\" height=\"50\"/>"
               "<rect x=\"100\" y=\"50\" width=\"100\" height=\"50\" fill=\"#00f\"/></svg>"));
  ASSERT_TRUE(photo) << base::to_line(photo.error());
  EXPECT_EQ(photo->width, 1024);
  EXPECT_EQ(photo->height, 512);
  EXPECT_EQ(photo->at(200, 256), 255);
  EXPECT_EQ(photo->at(800, 100), 0);
  EXPECT_EQ(photo->at(800, 400), 29) << "0.114 of 255";
  EXPECT_EQ(photo->at(500, 100), 255);
  EXPECT_EQ(photo->at(524, 100), 0);
  const auto upright = parse_photo(
      bytes_of("\xEF\xBB\xBF<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"2cm\" height=\"8cm\"/>"));
  ASSERT_TRUE(upright) << base::to_line(upright.error());
  EXPECT_EQ(upright->width, 256);
  EXPECT_EQ(upright->height, 1024);
  EXPECT_THAT(upright->grey, testing::Each(255));
}

TEST(Photo, ADrawingThatIsDamagedIsRefused) {
  for (const char* text : {"<svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"><rect", "<html><svg></html>"}) {
    const auto photo = parse_photo(bytes_of(text));
    ASSERT_FALSE(photo) << text;
    EXPECT_EQ(photo.error().code, base::Errc::parse) << text;
  }
  EXPECT_FALSE(parse_photo(bytes_of("a text about <svg>")));
}

TEST(Photo, CutAndForeignFilesAreRefused) {
  for (auto bytes : {surface::to_png(ramp()), jpeg_of(ramp())}) {
    for (const std::size_t size : {bytes.size() / 2, std::size_t{9}, std::size_t{4}}) {
      const auto photo = parse_photo(std::span(bytes).first(size));
      ASSERT_FALSE(photo);
      EXPECT_EQ(photo.error().code, base::Errc::parse) << size << " " << base::to_line(photo.error());
    }
  }
  EXPECT_EQ(parse_photo({}).error().code, base::Errc::parse);
  const std::vector<std::uint8_t> pdf{'%', 'P', 'D', 'F', '-', '1', '.', '5'};
  EXPECT_THAT(parse_photo(pdf).error().what,
              testing::HasSubstr("neither a PNG nor a JPEG picture, nor a drawing in SVG"));
  EXPECT_EQ(load_photo("/nonexistent.png").error().code, base::Errc::not_found);
}

TEST(Photo, ATinyPictureIsRefused) {
  surface::ColourPicture tiny{20, 20, std::vector<std::uint8_t>(1200, 255)};
  EXPECT_EQ(parse_photo(surface::to_png(tiny)).error().code, base::Errc::schema);
}

}  // namespace
}  // namespace nazori::scan
