// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "nazori/base/file.h"
#include "nazori/surface/height_map.h"
#include "temporary_folder.h"

namespace nazori::surface {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(RawFile, ReadsTheFirstRowAsTheTopAnd255AsThePlateau) {
  const auto map = parse_raw(Bytes{0, 255, 51, 102});
  ASSERT_TRUE(map);
  EXPECT_EQ(map->size(), 2);
  EXPECT_EQ(map->at(0, 0), 0.0F);
  EXPECT_EQ(map->at(1, 0), 1.0F);
  EXPECT_FLOAT_EQ(map->at(0, 1), 0.2F);
  EXPECT_FLOAT_EQ(map->at(1, 1), 0.4F);
}

TEST(RawFile, Scales2005sBytesAsItDid) {
  // z = height x 0.05, height a byte, for the whole range.
  Bytes bytes(256);
  for (std::size_t i = 0; i < 256; ++i) bytes[i] = static_cast<std::uint8_t>(i);
  const auto map = parse_raw(bytes).value();
  for (int i = 0; i < 256; ++i) EXPECT_NEAR(map.scaled(i % 16, i / 16, 12.75), i * 0.05, 1e-6) << i;
}

TEST(RawFile, EveryByteSurvivesARoundTrip) {
  Bytes bytes(128 * 128);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i * 7 + i / 128);
  EXPECT_EQ(to_raw(parse_raw(bytes).value()), bytes);
}

TEST(RawFile, RoundsToTheNearestLevel) {
  auto map = HeightMap::create(2).value();
  map.set(0, 0, 0.5F);  // 127.5
  map.set(1, 0, 100.4F / 255);
  map.set(0, 1, 100.6F / 255);
  EXPECT_EQ(to_raw(map), (Bytes{128, 100, 101, 255}));
}

TEST(RawFile, InfersTheSizeOfAPerfectSquareOnly) {
  EXPECT_EQ(parse_raw(Bytes(128 * 128))->size(), 128);
  EXPECT_EQ(parse_raw(Bytes(8192 * 8192))->size(), 8192);
  for (const std::size_t length : {1U, 2U, 3U, 5U, 128U * 128U - 1U, 128U * 128U + 1U}) {
    const auto map = parse_raw(Bytes(length));
    ASSERT_FALSE(map) << length;
    EXPECT_EQ(map.error().code, base::Errc::parse);
    EXPECT_NE(map.error().what.find(std::to_string(length)), std::string::npos);
  }
}

TEST(RawFile, ALengthThatIsNoSquareNamesTheSquaresAroundIt) {
  const auto remedy = [](std::size_t length) { return parse_raw(Bytes(length)).error().remedy; };
  const std::string smallest = "a whole file has 4 (2 x 2) or 9 (3 x 3) bytes";
  for (const std::size_t length : {1U, 2U, 3U, 5U, 6U, 7U, 8U}) EXPECT_EQ(remedy(length), smallest) << length;
  EXPECT_EQ(remedy(10), "a whole file has 9 (3 x 3) or 16 (4 x 4) bytes");
  EXPECT_EQ(remedy(15), "a whole file has 9 (3 x 3) or 16 (4 x 4) bytes");
  EXPECT_EQ(remedy(128 * 128 - 1), "a whole file has 16129 (127 x 127) or 16384 (128 x 128) bytes");
  EXPECT_EQ(remedy(8192 * 8192 - 1),
            "a whole file has 67092481 (8191 x 8191) or 67108864 (8192 x 8192) bytes");
  EXPECT_EQ(parse_raw(Bytes(8192 * 8192 + 1)).error().what,
            "has 67108865 bytes; the limit is 67108864 (8192 x 8192)");
}

TEST(RawFile, OfAGivenSizeTheSamplesAreRead) {
  for (const int size : {2, 8192}) {
    const auto map =
        parse_raw(Bytes(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), 51), size);
    ASSERT_TRUE(map) << size;
    EXPECT_FLOAT_EQ(map->at(0, 0), 0.2F);
    EXPECT_FLOAT_EQ(map->at(size - 1, size - 1), 0.2F);
  }
}

TEST(RawFile, ThatCannotBeOneIsNotRead) {
  const nazori::test::TemporaryFolder folder;
  const auto path = folder.path() / "large.raw";
  ASSERT_TRUE(base::write_file(path, std::string_view()));
  std::filesystem::resize_file(path, 8192 * 8192 + 1);
  EXPECT_EQ(load_raw(path).error().code, base::Errc::io);
}

TEST(RawFile, ALengthThatDoesNotFitTheGivenSizeNamesBoth) {
  const auto map = parse_raw(Bytes(100), 12);
  ASSERT_FALSE(map);
  EXPECT_EQ(map.error().code, base::Errc::parse);
  EXPECT_NE(map.error().what.find("100"), std::string::npos);
  EXPECT_NE(map.error().remedy.find("144 (12 x 12)"), std::string::npos);
  EXPECT_TRUE(parse_raw(Bytes(144), 12));
}

TEST(RawFile, RefusesAbsurdSizesBeforeLookingAtTheBytes) {
  for (const int size : {0, 1, -3, 8193, 1'000'000}) {
    const auto map = parse_raw(Bytes(16), size);
    ASSERT_FALSE(map) << size;
    EXPECT_EQ(map.error().code, base::Errc::bad_argument);
    EXPECT_EQ(map.error().where, "size");
  }
}

TEST(RawFile, AnEmptyFileSaysSo) {
  EXPECT_EQ(parse_raw({}).error().what, "is empty");
  EXPECT_EQ(parse_raw({}).error().remedy, "a height map has at least 4 (2 x 2) bytes");
  EXPECT_EQ(parse_raw({}, 128).error().what, "is empty");
  EXPECT_NE(parse_raw({}, 128).error().remedy.find("16384"), std::string::npos);
}

TEST(RawFile, LoadsWhatItSaved) {
  const nazori::test::TemporaryFolder folder;
  auto map = HeightMap::create(33).value();
  for (int i = 0; i < 33; ++i) map.set(i, 32 - i, static_cast<float>(i) / 255);
  ASSERT_TRUE(save_raw(map, folder.path() / "a.raw"));
  EXPECT_EQ(load_raw(folder.path() / "a.raw").value(), map);
  EXPECT_EQ(std::filesystem::file_size(folder.path() / "a.raw"), 33U * 33U);
}

TEST(RawFile, AFailedLoadLeavesTheOldMapAndNamesTheFile) {
  const nazori::test::TemporaryFolder folder;
  ASSERT_TRUE(base::write_file(folder.path() / "short.raw", std::string_view("12345")));
  ASSERT_TRUE(base::write_file(folder.path() / "empty.raw", std::string_view()));
  auto map = HeightMap::create(4, 0.5F).value();
  const HeightMap old = map;
  for (const std::string name : {"short.raw", "empty.raw", "missing.raw", "."}) {
    const std::filesystem::path path = folder.path() / name;
    auto loaded = load_raw(path);
    if (loaded) map = *loaded;
    ASSERT_FALSE(loaded) << name;
    EXPECT_EQ(loaded.error().where, path.string());
  }
  EXPECT_EQ(map, old);
  EXPECT_EQ(load_raw(folder.path()).error().code, base::Errc::io);
  EXPECT_EQ(load_raw(folder.path() / "missing.raw").error().code, base::Errc::not_found);
  EXPECT_EQ(load_raw(folder.path() / "short.raw", 1).error().where, "size") << "the argument is wrong";
}

TEST(RawFile, AnEmptyMapIsNotSaved) {
  const nazori::test::TemporaryFolder folder;
  const auto saved = save_raw({}, folder.path() / "a.raw");
  ASSERT_FALSE(saved);
  EXPECT_EQ(saved.error().code, base::Errc::bad_argument);
  EXPECT_EQ(saved.error().where, (folder.path() / "a.raw").string());
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "a.raw"));
}

}  // namespace
}  // namespace nazori::surface
