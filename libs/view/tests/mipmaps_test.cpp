// SPDX-License-Identifier: Apache-2.0
#include "../src/mipmaps.h"

#include <gtest/gtest.h>

namespace nazori::view {
namespace {

using Texels = std::vector<std::uint8_t>;

TEST(HalvedPicture, HasTheRoundedMeanOfFourTexelsInEachChannel) {
  const Texels four{0, 10, 20, 30, 1, 10, 40, 0, 0, 10, 60, 0, 0, 12, 80, 0};
  EXPECT_EQ(halved_picture(four, 2, 2), (Texels{0, 11, 50, 8})) << "1/4, 42/4, 200/4 and 30/4";
}

TEST(HalvedPicture, TakesEachTexelOnceAndLeavesOutTheLastOfAnOddSize) {
  Texels picture;
  for (std::uint8_t row = 0; row < 3; ++row)
    for (std::uint8_t column = 0; column < 5; ++column)
      picture.insert(picture.end(), {column, row, static_cast<std::uint8_t>(column * row), 255});
  // Columns 0 1 | 2 3, rows 0 1.
  EXPECT_EQ(halved_picture(picture, 5, 3), (Texels{1, 1, 0, 255, 3, 1, 1, 255}));
}

TEST(HalvedPicture, OfALineStaysALineAndOfATexelATexel) {
  EXPECT_EQ(halved_picture(Texels{10, 0, 0, 0, 20, 0, 0, 4}, 2, 1), (Texels{15, 0, 0, 2}));
  EXPECT_EQ(halved_picture(Texels{10, 0, 0, 0, 20, 0, 0, 4}, 1, 2), (Texels{15, 0, 0, 2}));
  EXPECT_EQ(halved_picture(Texels{7, 8, 9, 10}, 1, 1), (Texels{7, 8, 9, 10}));
}

}  // namespace
}  // namespace nazori::view
