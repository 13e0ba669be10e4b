// SPDX-License-Identifier: Apache-2.0
#include "nazori/surface/height_map.h"

#include <gtest/gtest.h>

#include <limits>

namespace nazori::surface {
namespace {

TEST(HeightMap, IsEmptyUntilMade) {
  HeightMap map;
  EXPECT_FALSE(map.is_loaded());
  EXPECT_EQ(map.size(), 0);
  EXPECT_TRUE(map.samples().empty());
}

TEST(HeightMap, StartsAsAPlateau) {
  const auto map = HeightMap::create(3);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->samples().size(), 9U);
  for (const float height : map->samples()) EXPECT_EQ(height, 1.0F);
}

TEST(HeightMap, TakesEverySizeFrom2To8192) {
  for (const int size : {2, 3, 127, 8192}) {
    const auto map = HeightMap::create(size, 0.5F);
    ASSERT_TRUE(map) << size;
    EXPECT_EQ(map->size(), size);
    EXPECT_EQ(map->at(size - 1, size - 1), 0.5F);
  }
}

TEST(HeightMap, RefusesOtherSizesAndSaysWhatWouldBeRight) {
  for (const int size :
       {0, 1, -1, 8193, 1'000'000, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()}) {
    const auto map = HeightMap::create(size);
    ASSERT_FALSE(map) << size;
    EXPECT_EQ(map.error().code, base::Errc::bad_argument);
    EXPECT_EQ(map.error().where, "size");
    EXPECT_NE(map.error().remedy.find("2 to 8192"), std::string::npos);
  }
}

TEST(HeightMap, GivesBackWhatWasSetTrueAndScaled) {
  auto map = HeightMap::create(5).value();
  map.set(3, 1, 0.25F);
  EXPECT_EQ(map.at(3, 1), 0.25F);
  EXPECT_EQ(map.at(1, 3), 1.0F) << "columns and rows are not exchanged";
  EXPECT_EQ(map.samples()[5 + 3], 0.25F) << "row-major";
  EXPECT_DOUBLE_EQ(map.scaled(3, 1, 12.75), 3.1875);
  EXPECT_DOUBLE_EQ(map.scaled(0, 0, 0.010), 0.010);
}

TEST(HeightMap, HoldsHeightsWithinZeroAndOne) {
  auto map = HeightMap::create(2).value();
  const float infinite = std::numeric_limits<float>::infinity();
  for (const auto& [given, held] :
       {std::pair{-0.1F, 0.0F}, std::pair{1.5F, 1.0F}, std::pair{infinite, 1.0F}, std::pair{-infinite, 1.0F},
        std::pair{std::numeric_limits<float>::quiet_NaN(), 1.0F}}) {
    map.set(0, 0, given);
    EXPECT_EQ(map.at(0, 0), held) << given;
    EXPECT_EQ(HeightMap::create(2, given)->at(1, 1), held) << given;
  }
}

TEST(HeightMap, UnloadGivesTheEmptyMapAndItsMemoryBack) {
  auto map = HeightMap::create(64).value();
  map.unload();
  EXPECT_FALSE(map.is_loaded());
  EXPECT_EQ(map, HeightMap());
}

}  // namespace
}  // namespace nazori::surface
