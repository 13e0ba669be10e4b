// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <zlib.h>

#include <string>

#include "nazori/base/file.h"
#include "nazori/surface/height_map.h"
#include "temporary_folder.h"

namespace nazori::surface {
namespace {

using Bytes = std::vector<std::uint8_t>;

// Pictures are built here from the PNG specification (ISO/IEC 15948), not by the library under test.

void append_u32(Bytes& bytes, std::uint32_t value) {
  for (const unsigned shift : {24U, 16U, 8U, 0U}) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

void append_chunk(Bytes& png, const std::string& type, const Bytes& data) {
  append_u32(png, static_cast<std::uint32_t>(data.size()));
  Bytes body(type.begin(), type.end());
  body.insert(body.end(), data.begin(), data.end());
  png.insert(png.end(), body.begin(), body.end());
  append_u32(png, static_cast<std::uint32_t>(crc32(0, body.data(), static_cast<uInt>(body.size()))));
}

struct Picture {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint8_t depth = 8;
  std::uint8_t colour = 0;
  std::uint8_t interlace = 0;
  Bytes pixels;  ///< filter byte and samples of each row, not yet packed
};

Bytes png_of(const Picture& picture) {
  Bytes png{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  Bytes head;
  append_u32(head, picture.width);
  append_u32(head, picture.height);
  head.insert(head.end(), {picture.depth, picture.colour, 0, 0, picture.interlace});
  append_chunk(png, "IHDR", head);
  uLongf length = compressBound(static_cast<uLong>(picture.pixels.size()));
  Bytes packed(length);
  compress(packed.data(), &length, picture.pixels.data(), static_cast<uLong>(picture.pixels.size()));
  packed.resize(length);
  append_chunk(png, "IDAT", packed);
  append_chunk(png, "IEND", {});
  return png;
}

TEST(PngFile, ReadsEightBitGreysRowByRow) {
  const auto map = parse_png(png_of({.width = 2, .height = 2, .pixels = {0, 0, 255, 0, 51, 102}}));
  ASSERT_TRUE(map) << base::to_line(map.error());
  EXPECT_EQ(map->at(0, 0), 0.0F);
  EXPECT_EQ(map->at(1, 0), 1.0F);
  EXPECT_FLOAT_EQ(map->at(0, 1), 0.2F);
  EXPECT_FLOAT_EQ(map->at(1, 1), 0.4F);
}

TEST(PngFile, ReadsSixteenBitGreysHighByteFirst) {
  const auto map = parse_png(
      png_of({.width = 2, .height = 2, .depth = 16, .pixels = {0, 0, 1, 0x80, 0, 0, 0xFF, 0xFF, 0, 0}}));
  ASSERT_TRUE(map) << base::to_line(map.error());
  EXPECT_FLOAT_EQ(map->at(0, 0), 1.0F / 65535);
  EXPECT_FLOAT_EQ(map->at(1, 0), 32768.0F / 65535);
  EXPECT_EQ(map->at(0, 1), 1.0F);
  EXPECT_EQ(map->at(1, 1), 0.0F);
}

TEST(PngFile, ReadsFewerBitsASampleOverTheWholeRange) {
  const auto one = parse_png(png_of({.width = 2, .height = 2, .depth = 1, .pixels = {0, 0x40, 0, 0x80}}));
  ASSERT_TRUE(one);
  EXPECT_EQ(one->at(0, 0), 0.0F);
  EXPECT_EQ(one->at(1, 0), 1.0F);
  EXPECT_EQ(one->at(0, 1), 1.0F);
  const auto four = parse_png(png_of({.width = 2, .height = 2, .depth = 4, .pixels = {0, 0x0F, 0, 0x36}}));
  ASSERT_TRUE(four);
  EXPECT_EQ(four->at(1, 0), 1.0F);
  EXPECT_FLOAT_EQ(four->at(0, 1), 0.2F);
  EXPECT_FLOAT_EQ(four->at(1, 1), 0.4F);
}

TEST(PngFile, ReadsInterlacedPictures) {
  // Adam7: the passes of an 8 x 8 picture, sample = 8 row + column.
  const struct {
    int x0, y0, dx, dy;
  } passes[] = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
                {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
  for (const bool wide : {false, true}) {
    Picture picture{.width = 8,
                    .height = 8,
                    .depth = static_cast<std::uint8_t>(wide ? 16 : 8),
                    .interlace = 1,
                    .pixels = {}};
    for (const auto& pass : passes) {
      for (int y = pass.y0; y < 8; y += pass.dy) {
        picture.pixels.push_back(0);
        for (int x = pass.x0; x < 8; x += pass.dx) {
          if (wide) picture.pixels.push_back(static_cast<std::uint8_t>(8 * y + x));
          picture.pixels.push_back(static_cast<std::uint8_t>(8 * y + x));
        }
      }
    }
    const auto map = parse_png(png_of(picture));
    ASSERT_TRUE(map) << base::to_line(map.error());
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x) EXPECT_FLOAT_EQ(map->at(x, y), static_cast<float>(8 * y + x) / 255) << wide;
  }
}

TEST(PngFile, RefusesColourTransparencyAndOtherShapesAsTheWrongKind) {
  for (const std::uint8_t colour : {std::uint8_t{2}, std::uint8_t{4}, std::uint8_t{6}}) {
    const auto map = parse_png(png_of({.width = 2, .height = 2, .colour = colour, .pixels = Bytes(20)}));
    ASSERT_FALSE(map) << int{colour};
    EXPECT_EQ(map.error().code, base::Errc::schema);
    EXPECT_NE(map.error().remedy.find("greyscale"), std::string::npos);
    EXPECT_EQ(map.error().what.find("transparency") != std::string::npos, colour == 4) << int{colour};
  }
  for (const auto& [width, height] : {std::pair{2U, 3U}, std::pair{3U, 2U}, std::pair{1U, 1U},
                                      std::pair{8193U, 8193U}, std::pair{900000U, 900000U}}) {
    const auto map = parse_png(png_of({.width = width, .height = height, .pixels = Bytes(20)}));
    ASSERT_FALSE(map) << width;
    EXPECT_EQ(map.error().code, base::Errc::schema) << base::to_line(map.error());
    EXPECT_NE(map.error().what.find(std::to_string(width) + " x " + std::to_string(height)),
              std::string::npos);
  }
}

TEST(PngFile, AHeadThatPromisesMorePixelsThanTheFileCanHoldIsRefused) {
  // 8192 x 8192 samples of 16 bits in a file of a hundred bytes: refused before 256 MiB are allocated.
  const auto map = parse_png(png_of({.width = 8192, .height = 8192, .depth = 16, .pixels = Bytes(20)}));
  ASSERT_FALSE(map);
  EXPECT_EQ(map.error().code, base::Errc::parse);
}

TEST(PngFile, OfTheSmallestAndOfTheLargestSizeIsNoWrongKind) {
  EXPECT_TRUE(parse_png(png_of({.width = 2, .height = 2, .pixels = Bytes(6)})));
  // The header is accepted, the pixels are missing.
  const auto largest = parse_png(png_of({.width = 8192, .height = 8192, .depth = 1, .pixels = Bytes(20)}));
  EXPECT_EQ(largest.error().code, base::Errc::parse);
  EXPECT_NE(parse_png(png_of({.width = 8193, .height = 8193, .pixels = Bytes(20)}))
                .error()
                .remedy.find("2 to 8192"),
            std::string::npos);
}

TEST(PngFile, PackedAsTightlyAsDeflatePacksIsRead) {
  // A thousandth of its size, but complete.
  constexpr std::size_t kSide = 1024;
  const Bytes png =
      png_of({.width = kSide, .height = kSide, .depth = 16, .pixels = Bytes(kSide * (2 * kSide + 1))});
  ASSERT_LT(png.size(), kSide * kSide * 2 / 950);
  const auto map = parse_png(png);
  ASSERT_TRUE(map) << base::to_line(map.error());
  EXPECT_EQ(map->at(1023, 1023), 0.0F);
}

TEST(PngFile, SaysWhyItIsNotWhole) {
  const auto what = [](const Bytes& png) {
    const auto map = parse_png(png);
    return map ? std::string("read") : map.error().what;
  };
  EXPECT_EQ(what({}), "is empty");
  Bytes png = to_png(HeightMap::create(16).value(), PngDepth::bits_8);
  Bytes cut = png;
  cut.pop_back();
  EXPECT_EQ(what(cut), "is not a whole PNG picture: the file ends too early");
  cut.resize(20);
  EXPECT_EQ(what(cut), "is not a whole PNG picture: the file ends too early");
  png[1] = 'Q';
  EXPECT_EQ(what(png).find("is not a whole PNG picture: "), 0U);
  EXPECT_GT(what(png).size(), std::string("is not a whole PNG picture: ").size()) << "in libpng's words";
}

TEST(PngFile, ThatCannotBeAHeightMapIsNotRead) {
  const nazori::test::TemporaryFolder folder;
  const auto path = folder.path() / "large.png";
  ASSERT_TRUE(base::write_file(path, std::string_view()));
  // 16 bits for each sample of the largest map, and a mebibyte.
  std::filesystem::resize_file(path, 2 * 8192 * 8192 + 1048576 + 1);
  EXPECT_EQ(load_png(path).error().code, base::Errc::io);
}

TEST(PngFile, EveryTruncationAndEveryDamagedByteIsAnErrorOrAPicture) {
  auto map = HeightMap::create(16).value();
  for (int i = 0; i < 256; ++i) map.set(i % 16, i / 16, static_cast<float>(i) / 255);
  const Bytes png = to_png(map, PngDepth::bits_8);
  for (std::size_t length = 0; length < png.size(); ++length) {
    const auto part = parse_png(std::span(png).first(length));
    ASSERT_FALSE(part) << length;
    ASSERT_EQ(part.error().code, base::Errc::parse) << length;
  }
  for (std::size_t i = 0; i < png.size(); ++i) {
    Bytes damaged = png;
    damaged[i] = static_cast<std::uint8_t>(damaged[i] ^ 0x55U);
    const auto picture = parse_png(damaged);
    ASSERT_TRUE(!picture || picture->size() == 16) << i;
  }
}

TEST(PngFile, SixteenBitsKeepEveryLevelExactly) {
  auto map = HeightMap::create(256).value();
  for (int i = 0; i < 65536; ++i) map.set(i % 256, i / 256, static_cast<float>(i) / 65535.0F);
  const auto again = parse_png(to_png(map, PngDepth::bits_16));
  ASSERT_TRUE(again);
  EXPECT_EQ(*again, map);
}

TEST(PngFile, EightBitsKeepTheLevelsOfRaw) {
  auto map = HeightMap::create(16).value();
  for (int i = 0; i < 256; ++i) map.set(i % 16, i / 16, static_cast<float>(i) / 255.0F);
  EXPECT_EQ(parse_png(to_png(map, PngDepth::bits_8)).value(), map);
}

TEST(PngFile, AnyHeightComesBackWithinHalfALevel) {
  auto map = HeightMap::create(64).value();
  for (int i = 0; i < 4096; ++i) map.set(i % 64, i / 64, static_cast<float>(i * 997 % 4096) / 4096.0F);
  const auto wide = parse_png(to_png(map, PngDepth::bits_16)).value();
  const auto narrow = parse_png(to_png(map, PngDepth::bits_8)).value();
  for (int i = 0; i < 4096; ++i) {
    EXPECT_NEAR(wide.at(i % 64, i / 64), map.at(i % 64, i / 64), 0.5 / 65535 + 1e-7);
    EXPECT_NEAR(narrow.at(i % 64, i / 64), map.at(i % 64, i / 64), 0.5 / 255 + 1e-7);
  }
}

TEST(PngFile, LoadsWhatItSavedAndKeepsTheOldMapOtherwise) {
  const nazori::test::TemporaryFolder folder;
  auto map = HeightMap::create(20, 0.2F).value();
  ASSERT_TRUE(save_png(map, folder.path() / "a.png", PngDepth::bits_16));
  EXPECT_EQ(load_png(folder.path() / "a.png").value(), map);
  ASSERT_TRUE(base::write_file(folder.path() / "text.png", std::string_view("not a picture")));
  ASSERT_TRUE(base::write_file(folder.path() / "empty.png", std::string_view()));
  for (const std::string name : {"text.png", "empty.png", "missing.png", "."}) {
    const auto loaded = load_png(folder.path() / name);
    ASSERT_FALSE(loaded) << name;
    EXPECT_EQ(loaded.error().where, (folder.path() / name).string());
  }
  EXPECT_TRUE(to_png({}, PngDepth::bits_8).empty());
  const auto saved = save_png({}, folder.path() / "b.png", PngDepth::bits_8);
  ASSERT_FALSE(saved);
  EXPECT_EQ(saved.error().code, base::Errc::bad_argument);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "b.png"));
}

}  // namespace
}  // namespace nazori::surface
