// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/font_picture.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace nazori::author {
namespace {

const std::string kFamily = "Klee One";  // of fonts-klee, which the worksheets need, too

/// The columns and rows that have ink.
struct Extent {
  int left = 1 << 20, right = -1, top = 1 << 20, bottom = -1;
  [[nodiscard]] int width() const { return right - left + 1; }
  [[nodiscard]] int height() const { return bottom - top + 1; }
};
Extent ink_of(const scan::Photo& picture) {
  Extent ink;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      if (picture.at(x, y) > 127) continue;
      ink.left = std::min(ink.left, x);
      ink.right = std::max(ink.right, x);
      ink.top = std::min(ink.top, y);
      ink.bottom = std::max(ink.bottom, y);
    }
  }
  return ink;
}

TEST(FontPicture, ABarIsWideFlatAndInTheMiddle) {
  const auto picture = font_picture(U'一', kFamily, 512);
  ASSERT_TRUE(picture) << picture.error().what;
  EXPECT_EQ(picture->width, 512);
  EXPECT_EQ(picture->height, 512);
  const Extent ink = ink_of(*picture);
  EXPECT_GT(ink.width(), 350);
  EXPECT_LT(ink.height(), 60);
  EXPECT_NEAR((ink.left + ink.right) / 2.0, 256, 20);
  EXPECT_NEAR((ink.top + ink.bottom) / 2.0, 256, 60);
}

TEST(FontPicture, ASmallKanaStaysSmallAndLow) {
  const Extent large = ink_of(*font_picture(U'ツ', kFamily, 512));
  const Extent small = ink_of(*font_picture(U'ッ', kFamily, 512));
  EXPECT_LT(small.width(), 0.9 * large.width());
  EXPECT_LT(small.height(), 0.9 * large.height());
  EXPECT_GT(small.top, large.top + 20);
}

TEST(FontPicture, GrowsWithItsSide) {
  const Extent small = ink_of(*font_picture(U'口', kFamily, 256));
  const Extent large = ink_of(*font_picture(U'口', kFamily, 1024));
  EXPECT_NEAR(large.width(), 4 * small.width(), 6);
  EXPECT_NEAR(large.left, 4 * small.left, 6);
  EXPECT_NEAR(large.top, 4 * small.top, 6);
}

TEST(FontPicture, WhatIsNotInstalledIsNotFound) {
  const auto no_font = font_picture(U'一', "No Such Family");
  ASSERT_FALSE(no_font);
  EXPECT_EQ(no_font.error().code, base::Errc::not_found);
  EXPECT_EQ(no_font.error().where, "font No Such Family");
  const auto no_character = font_picture(U'\U0010FFFD', kFamily);
  ASSERT_FALSE(no_character);
  EXPECT_EQ(no_character.error().code, base::Errc::not_found);
  EXPECT_NE(no_character.error().what.find("U+10FFFD"), std::string::npos);
}

TEST(FontPicture, ItsSideHasLimits) {
  EXPECT_TRUE(font_picture(U'一', kFamily, kLeastFontPicture));
  EXPECT_TRUE(font_picture(U'一', kFamily, kMostFontPicture));
  for (const int side : {kLeastFontPicture - 1, kMostFontPicture + 1}) {
    const auto refused = font_picture(U'一', kFamily, side);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, base::Errc::bad_argument);
  }
}

TEST(FontFamilies, AreThoseThatHaveTheCharacterEachOnceInOrder) {
  const auto families = font_families(U'永');
  EXPECT_NE(std::find(families.begin(), families.end(), kFamily), families.end());
  EXPECT_TRUE(std::is_sorted(families.begin(), families.end()));
  EXPECT_EQ(std::adjacent_find(families.begin(), families.end()), families.end());
  EXPECT_TRUE(font_families(U'\U0010FFFD').empty());
}

}  // namespace
}  // namespace nazori::author
