// SPDX-License-Identifier: Apache-2.0
#include "nazori/scan/picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <turbojpeg.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "../src/orientation.h"
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

surface::ColourPicture white(int width, int height) {
  return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height), 255)};
}

TEST(Photo, SixtyFourPixelsASideAreEnough) {
  for (const auto& [width, height, fits] :
       {std::tuple{64, 64, true}, {63, 64, false}, {64, 63, false}, {63, 200, false}}) {
    const auto photo = parse_photo(surface::to_png(white(width, height)));
    EXPECT_EQ(photo.has_value(), fits) << width << " " << height;
    if (!photo) {
      EXPECT_EQ(photo.error().code, base::Errc::schema);
      EXPECT_EQ(photo.error().what,
                "is " + std::to_string(width) + " x " + std::to_string(height) + " pixels");
    }
  }
}

/// A JPEG file whose header names another size than it has pixels for.
std::vector<std::uint8_t> jpeg_that_says(int width, int height) {
  std::vector<std::uint8_t> bytes = jpeg_of(white(64, 64));
  const std::array<std::uint8_t, 2> frame{0xFF, 0xC0};
  const auto at = std::search(bytes.begin(), bytes.end(), frame.begin(), frame.end()) - bytes.begin();
  const auto put = [&](std::ptrdiff_t place, int value) {
    bytes[static_cast<std::size_t>(at + place)] = static_cast<std::uint8_t>(value / 256);
    bytes[static_cast<std::size_t>(at + place + 1)] = static_cast<std::uint8_t>(value % 256);
  };
  put(5, height);
  put(7, width);
  return bytes;
}

TEST(Photo, AHugePictureIsRefusedBeforeItsPixelsAreRead) {
  // One that may be as large is then found to be cut off.
  for (const auto& [width, height, fits] : {std::tuple{20'000, 64, true},
                                            {20'001, 64, false},
                                            {64, 20'000, true},
                                            {64, 20'001, false},
                                            {12'001, 10'000, false},
                                            {19'000, 19'000, false}}) {
    const auto photo = parse_photo(jpeg_that_says(width, height));
    ASSERT_FALSE(photo) << width << " " << height;
    EXPECT_EQ(photo.error().code, fits ? base::Errc::parse : base::Errc::schema) << width << " " << height;
  }
}

TEST(Photo, OutsideThePictureTheNearestPixelCounts) {
  const Photo photo{3, 2, {10, 20, 40, 110, 140, 180}};
  EXPECT_EQ(photo.at(2, 0), 40);
  EXPECT_EQ(photo.at(0, 1), 110);
  EXPECT_EQ(photo.sample(0, 0), 10);
  EXPECT_EQ(photo.sample(2, 1), 180);
  EXPECT_EQ(photo.sample(1, 0), 20);
  EXPECT_EQ(photo.sample(0, 1), 110);
  EXPECT_EQ(photo.sample(0.5, 0), 15);
  EXPECT_EQ(photo.sample(0, 0.25), 35);
  EXPECT_EQ(photo.sample(1.75, 0.5), (35 + 170) / 2.0);
  EXPECT_EQ(photo.sample(-5, 0.5), 60);
  EXPECT_EQ(photo.sample(9, 0.5), 110);
  EXPECT_EQ(photo.sample(0.5, -3), 15);
  EXPECT_EQ(photo.sample(0.5, 7), 125);
  EXPECT_EQ(photo.sample(-1e300, 1e300), 110);
}

TEST(Photo, ColoursBecomeTheirBrightness) {
  surface::ColourPicture picture{96, 64, {}};
  for (int i = 0; i < 96 * 64; ++i)
    for (int part = 0; part < 3; ++part)
      picture.rgb.push_back(i % 96 / 32 == part ? std::uint8_t{255} : std::uint8_t{0});
  const auto jpeg = parse_photo(jpeg_of(picture));
  ASSERT_TRUE(jpeg);
  // @source ITU-R BT.601
  EXPECT_NEAR(jpeg->at(16, 30), 76, 6);
  EXPECT_NEAR(jpeg->at(48, 30), 150, 6);
  EXPECT_NEAR(jpeg->at(80, 30), 29, 6);
  const auto drawn =
      parse_photo(bytes_of("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 3 1\">"
                           "<rect width=\"1\" height=\"1\" fill=\"#f00\"/>"
                           "<rect x=\"1\" width=\"1\" height=\"1\" fill=\"#0f0\"/></svg>"));
  ASSERT_TRUE(drawn);
  EXPECT_EQ(drawn->at(100, 100), 76);
  EXPECT_EQ(drawn->at(500, 100), 150);
}

TEST(Photo, AJpegPictureInTheColoursOfPrintingIsRefused) {
  std::vector<std::uint8_t> pixels(std::size_t{64} * 64 * 4, 100);
  tjhandle writer = tjInitCompress();
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  ASSERT_EQ(tjCompress2(writer, pixels.data(), 64, 0, 64, TJPF_CMYK, &bytes, &size, TJSAMP_444, 90, 0), 0);
  const auto photo = parse_photo(std::span(bytes, size));
  tjFree(bytes);
  tjDestroy(writer);
  ASSERT_FALSE(photo);
  EXPECT_EQ(photo.error().code, base::Errc::schema);
  EXPECT_THAT(photo.error().what, testing::HasSubstr("in the colours of printing"));
}

TEST(Photo, TheFirstBytesSayWhatAFileIs) {
  const auto what = [](const std::vector<std::uint8_t>& bytes) {
    const auto photo = parse_photo(bytes);
    return photo ? std::string("a picture") : photo.error().what;
  };
  EXPECT_THAT(what({0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'}), testing::HasSubstr("PNG picture: "));
  EXPECT_THAT(what({0xFF, 0xD8, 0xFF, 0xD9}), testing::HasSubstr("is not a whole JPEG picture"));
  for (const auto& other : {std::vector<std::uint8_t>{0x88, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'},
                            {0x89, 'Q', 'N', 'G', '\r', '\n', 0x1A, '\n'},
                            {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A},
                            {0xFE, 0xD8, 0xFF, 0xD9},
                            {0xFF, 0xD9, 0xFF, 0xD9},
                            {0xFF, 0xD8, 0xFF}})
    EXPECT_THAT(what(other), testing::HasSubstr("neither a PNG nor a JPEG"));
}

TEST(Photo, AFileIsReadAndNamedInItsError) {
  const auto folder = std::filesystem::path(testing::TempDir());
  const auto good = folder / "white.png";
  ASSERT_TRUE(surface::save_png(white(70, 80), good));
  const auto photo = load_photo(good);
  ASSERT_TRUE(photo);
  EXPECT_EQ(photo->width, 70);
  EXPECT_EQ(photo->height, 80);
  EXPECT_THAT(photo->grey, testing::Each(255));
  const auto bad = folder / "notes.txt";
  std::ofstream(bad) << "no picture";
  const auto refused = load_photo(bad);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().where, bad.string());
  EXPECT_EQ(refused.error().code, base::Errc::parse);
}

TEST(Photo, ADrawingIsAtMostSixteenTimesAsLongAsWide) {
  const auto size_of = [](const std::string& attributes) {
    const auto photo =
        parse_photo(bytes_of("<svg xmlns=\"http://www.w3.org/2000/svg\" " + attributes + "/>"));
    EXPECT_TRUE(photo) << attributes;
    return photo ? std::pair(photo->width, photo->height) : std::pair(0, 0);
  };
  EXPECT_EQ(size_of("viewBox=\"0 0 160 10\""), (std::pair{1024, 64}));
  EXPECT_EQ(size_of("viewBox=\"0 0 400 10\""), (std::pair{1024, 64}));
  EXPECT_EQ(size_of("viewBox=\"0 0 10 160\""), (std::pair{64, 1024}));
  EXPECT_EQ(size_of("viewBox=\"0 0 10 400\""), (std::pair{64, 1024}));
  EXPECT_EQ(size_of("viewBox=\"0 0 10 40\""), (std::pair{256, 1024}));
  EXPECT_EQ(size_of("width=\"30\" height=\"10\""), (std::pair{1024, 341}));
  EXPECT_EQ(size_of(""), (std::pair{1024, 1024}));
  EXPECT_EQ(size_of("width=\"100%\" height=\"100%\" viewBox=\"5 7 40 20\""), (std::pair{1024, 512}));
}

TEST(Photo, TheRootOfADrawingMayStandBehindALongComment) {
  const std::string root = "<svg xmlns=\"http://www.w3.org/2000/svg\"/>";
  const auto behind = [&](std::size_t length) {
    const std::string comment = "<!--" + std::string(length - 7, 'x') + "-->";
    return parse_photo(bytes_of(" \n\t" + comment + root)).has_value();
  };
  EXPECT_TRUE(behind(4000));
  EXPECT_TRUE(behind(4096 - 3 - 4)) << "its name is just inside the part that is looked at";
  EXPECT_FALSE(behind(4096 - 3 - 3));
}

/// An Exif part in the order of bytes "MM" with one entry.
std::vector<std::uint8_t> exif_with(std::uint8_t tag, std::uint8_t type, std::uint8_t value,
                                    std::uint8_t entries = 1) {
  return {0xFF, 0xD8, 0xFF,    0xE1, 0,   34, 'E',  'x', 'i', 'f', 0, 0, 'M',   'M', 0, 42, 0, 0, 0,
          8,    0,    entries, 1,    tag, 0,  type, 0,   0,   0,   1, 0, value, 0,   0, 0,  0, 0, 0};
}

TEST(Orientation, IsTheShortNumberOfItsTag) {
  for (int value = 0; value <= 10; ++value)
    EXPECT_EQ(exif_orientation(exif_with(0x12, 3, static_cast<std::uint8_t>(value))),
              value >= 1 && value <= 8 ? value : 1);
  EXPECT_EQ(exif_orientation(exif_with(0x13, 3, 6)), 1) << "another tag";
  EXPECT_EQ(exif_orientation(exif_with(0x12, 4, 6)), 1) << "another type";
  EXPECT_EQ(exif_orientation(exif_with(0x12, 3, 6, 0)), 1) << "no entry";
}

TEST(Orientation, IsFoundBehindOtherParts) {
  std::vector<std::uint8_t> bytes = exif_with(0x12, 3, 6);
  const std::vector<std::uint8_t> other{0xFF, 0xE0, 0, 5, 1, 2, 3};
  const std::vector<std::uint8_t> another{0xFF, 0xE1, 0, 10, 'h', 't', 't', 'p', ':', '/', '/', 0};
  bytes.insert(bytes.begin() + 2, other.begin(), other.end());
  EXPECT_EQ(exif_orientation(bytes), 6);
  bytes.insert(bytes.begin() + 2, another.begin(), another.end());
  EXPECT_EQ(exif_orientation(bytes), 6) << "a part of another kind with the same marker";
  std::vector<std::uint8_t> behind_scan = exif_with(0x12, 3, 6);
  const std::vector<std::uint8_t> scan{0xFF, 0xDA, 0, 3, 1};
  behind_scan.insert(behind_scan.begin() + 2, scan.begin(), scan.end());
  EXPECT_EQ(exif_orientation(behind_scan), 1);
  std::vector<std::uint8_t> no_marker = exif_with(0x12, 3, 6);
  no_marker[2] = 0xFE;
  EXPECT_EQ(exif_orientation(no_marker), 1);
  std::vector<std::uint8_t> no_length{0xFF, 0xD8, 0xFF, 0xE0, 0, 1};
  const std::vector<std::uint8_t> rest = exif_with(0x12, 3, 6);
  no_length.insert(no_length.end(), rest.begin() + 2, rest.end());
  EXPECT_EQ(exif_orientation(no_length), 1) << "a part is two bytes long at least";
}

TEST(Orientation, OfAPartThatIsCutIsUpright) {
  const std::vector<std::uint8_t> whole = exif_with(0x12, 3, 6);
  ASSERT_EQ(exif_orientation(whole), 6);
  // The entry ends with its 34th byte.
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_EQ(exif_orientation(std::span(whole).first(size)), size >= 34 ? 6 : 1) << size;
  // The part says that it is shorter than the file.
  for (std::uint8_t length = 2; length < 34; ++length) {
    std::vector<std::uint8_t> shorter = whole;
    shorter[5] = length;
    EXPECT_EQ(exif_orientation(shorter), length >= 30 ? 6 : 1) << int(length);
  }
}

TEST(Orientation, TheOrderOfBytesMustBeNamed) {
  for (const auto& [first, second, expected] :
       {std::tuple{'M', 'M', 6}, {'M', 'I', 1}, {'I', 'M', 1}, {'K', 'K', 1}}) {
    std::vector<std::uint8_t> bytes = exif_with(0x12, 3, 6);
    bytes[12] = static_cast<std::uint8_t>(first);
    bytes[13] = static_cast<std::uint8_t>(second);
    EXPECT_EQ(exif_orientation(bytes), expected) << first << second;
  }
  const std::vector<std::uint8_t> little{0xFF, 0xD8, 0xFF, 0xE1, 0, 34, 'E', 'x', 'i', 'f',  0, 0, 'I',
                                         'I',  42,   0,    8,    0, 0,  0,   1,   0,   0x12, 1, 3, 0,
                                         1,    0,    0,    0,    6, 0,  0,   0,   0,   0,    0, 0};
  EXPECT_EQ(exif_orientation(little), 6);
}

TEST(Orientation, APictureIsTurnedPixelByPixel) {
  // 1 2 3
  // 4 5 6  @source the figures of Exif 2.3: where the first row and column of the file are seen.
  const Photo photo{3, 2, {1, 2, 3, 4, 5, 6}};
  const std::vector<std::vector<std::uint8_t>> seen{
      {1, 2, 3, 4, 5, 6}, {3, 2, 1, 6, 5, 4}, {6, 5, 4, 3, 2, 1}, {4, 5, 6, 1, 2, 3},
      {1, 4, 2, 5, 3, 6}, {4, 1, 5, 2, 6, 3}, {6, 3, 5, 2, 4, 1}, {3, 6, 2, 5, 1, 4}};
  for (int orientation = 1; orientation <= 8; ++orientation) {
    const Photo turned = upright(photo, orientation);
    EXPECT_EQ(turned.width, orientation >= 5 ? 2 : 3) << orientation;
    EXPECT_EQ(turned.height, orientation >= 5 ? 3 : 2) << orientation;
    EXPECT_EQ(turned.grey, seen[static_cast<std::size_t>(orientation - 1)]) << orientation;
  }
}

}  // namespace
}  // namespace nazori::scan
