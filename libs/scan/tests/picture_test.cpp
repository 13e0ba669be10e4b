// SPDX-License-Identifier: Apache-2.0
#include "nazori/scan/picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <turbojpeg.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

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
  EXPECT_THAT(parse_photo(pdf).error().what, testing::HasSubstr("neither a PNG nor a JPEG"));
  EXPECT_EQ(load_photo("/nonexistent.png").error().code, base::Errc::not_found);
}

TEST(Photo, ATinyPictureIsRefused) {
  surface::ColourPicture tiny{20, 20, std::vector<std::uint8_t>(1200, 255)};
  EXPECT_EQ(parse_photo(surface::to_png(tiny)).error().code, base::Errc::schema);
}

}  // namespace
}  // namespace nazori::scan
