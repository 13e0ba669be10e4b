// SPDX-License-Identifier: Apache-2.0
#include "nazori/model/braille.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace nazori::model {
namespace {

/// The cells as Unicode braille patterns, whose bits are the same dots.
/// @source The Unicode Standard, block Braille Patterns (U+2800).
std::u32string patterns(std::string_view text) {
  std::u32string out;
  const auto cells = braille_cells(text);
  for (const BrailleCell cell : *cells) out += static_cast<char32_t>(0x2800 + cell);
  return out;
}

TEST(Braille, LettersAreThoseOfThePublishedAlphabet) {
  EXPECT_EQ(patterns("abcdefghijklmnopqrstuvwxyz"), U"⠁⠃⠉⠙⠑⠋⠛⠓⠊⠚⠅⠇⠍⠝⠕⠏⠟⠗⠎⠞⠥⠧⠺⠭⠽⠵");
}

TEST(Braille, ANumberHasOneSignBeforeAllItsDigits) {
  EXPECT_EQ(patterns("1234567890"), U"⠼⠁⠃⠉⠙⠑⠋⠛⠓⠊⠚");
  EXPECT_EQ(patterns("-12"), U"⠤⠼⠁⠃");
  EXPECT_EQ(patterns("0.5"), U"⠼⠚⠂⠑");
  EXPECT_EQ(patterns("x 2"), U"⠭⠀⠼⠃");
  EXPECT_EQ(patterns("1 2"), U"⠼⠁⠀⠼⠃");
}

TEST(Braille, WhatHasNoCellIsRefused) {
  EXPECT_FALSE(braille_cells("休"));
  EXPECT_FALSE(braille_cells("A"));
  EXPECT_FALSE(braille_cells(".5"));
  EXPECT_TRUE(braille_cells("")->empty());
}

TEST(Braille, DotsStandWhereTheCellHasThem) {
  Plate plate = Plate::create(20, 10, 0.05, 2).value();
  add_braille(plate, braille_cells("1").value(), {1, 1});  // ⠼⠁
  const auto rise = [&](double x, double y) {
    return plate.at(static_cast<int>(std::lround(x / 0.05)), static_cast<int>(std::lround(y / 0.05))) - 2;
  };
  const double left = 1 + 0.625;
  const double low = 1 + 0.625;
  EXPECT_NEAR(rise(left, low), 0.5, 0.01);              // dot 3
  EXPECT_NEAR(rise(left + 2.5, low), 0.5, 0.01);        // dot 6
  EXPECT_NEAR(rise(left + 2.5, low + 2.5), 0.5, 0.01);  // dot 5
  EXPECT_NEAR(rise(left + 2.5, low + 5), 0.5, 0.01);    // dot 4
  EXPECT_EQ(rise(left, low + 5), 0);                    // dot 1
  EXPECT_EQ(rise(left, low + 2.5), 0);                  // dot 2
  EXPECT_NEAR(rise(left + 6, low + 5), 0.5, 0.01);      // dot 1 of the second cell
  EXPECT_EQ(rise(left + 6, low), 0);
}

TEST(Braille, TheBoxHoldsAllDots) {
  EXPECT_DOUBLE_EQ(braille_width_mm(2), 6 + 2.5 + 1.25);
  EXPECT_DOUBLE_EQ(braille_width_mm(0), 0);
  EXPECT_DOUBLE_EQ(braille_height_mm(), 6.25);
}

}  // namespace
}  // namespace nazori::model
