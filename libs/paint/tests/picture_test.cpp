// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "nazori/paint/sheet_picture.h"
#include "sheet_under_test.h"

namespace nazori::paint {
namespace {

using namespace test;

ScreenColour pixel(const SheetPicture& picture, int column, int row) {
  const auto& p = picture.picture();
  const std::uint8_t* at =
      p.rgb.data() + 3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(p.width) +
                          static_cast<std::size_t>(column));
  return {at[0], at[1], at[2]};
}

int difference(ScreenColour a, ScreenColour b) {
  return std::max({std::abs(a.red - b.red), std::abs(a.green - b.green), std::abs(a.blue - b.blue)});
}

TEST(SheetPicture, BarePaperHasItsColour) {
  Paper paper;
  paper.colour = {0.5, 0.214, 0.9};
  const Sheet sheet = sheet_of(128, paper);
  SheetPicture picture;
  EXPECT_EQ(picture.update(sheet).size(), 16U);
  EXPECT_EQ(picture.picture().width, 128);
  EXPECT_EQ(picture.picture().rgb.size(), 3U * 128 * 128);
  EXPECT_LE(difference(pixel(picture, 77, 33), {188, 127, 243}), 1);
  EXPECT_EQ(difference(colour_of(sheet, 77, 33), {188, 127, 243}), 0);
}

TEST(SheetPicture, TablesAgreeWithTheFormulas) {
  auto sheet = sheet_of(128);
  Random random(3);
  for (int row = 0; row < 128; ++row) {
    for (int column = 0; column < 128; ++column) {
      const double amount = std::pow(10, random.within(-3, 0.8));
      PigmentAmounts pigment{};
      // One pigment in the upper tiles, mixtures below.
      pigment[row < 64 ? static_cast<std::size_t>(column / 32 % 3)
                       : static_cast<std::size_t>(random.below(3))] = to_amount(amount);
      if (row >= 64)
        pigment[static_cast<std::size_t>(random.below(3))] += to_amount(amount * random.within(0, 0.2));
      sheet.drop(column, row, to_amount(random.within(0, 1.5)), pigment);
    }
  }
  SheetPicture picture;
  picture.update(sheet);
  int worst_simple = 0;
  double sum = 0;
  int worst = 0;
  for (int row = 0; row < 128; ++row) {
    for (int column = 0; column < 128; ++column) {
      const int off = difference(pixel(picture, column, row), colour_of(sheet, column, row));
      if (row < 64)
        worst_simple = std::max(worst_simple, off);
      else
        worst = std::max(worst, off), sum += off;
    }
  }
  EXPECT_LE(worst_simple, 1);
  EXPECT_LE(worst, 2);
  EXPECT_LE(sum / (64 * 128), 0.5);
}

TEST(SheetPicture, OnlyTilesThatChangedAreDrawn) {
  Sheet sheet = sheet_of(256);
  SheetPicture picture;
  picture.update(sheet);
  EXPECT_TRUE(picture.update(sheet).empty());
  sheet.drop(40, 70, kOne, {kOne, 0, 0});
  EXPECT_EQ(picture.update(sheet), std::vector{2 * 8 + 1});
  EXPECT_LT(pixel(picture, 40, 70).red, 60);
  EXPECT_TRUE(picture.update(sheet).empty());
  sheet.step();
  EXPECT_FALSE(picture.update(sheet).empty());
  const Sheet other = sheet_of(128);
  EXPECT_EQ(picture.update(other).size(), 16U);
}

TEST(SheetPicture, VermilionOverDryInkCoversItAndMixedWithWetInkIsDark) {
  const auto red_over = [](bool dry) {
    Sheet sheet = sheet_of(128);
    for (int row = 32; row < 64; ++row)
      for (int column = 32; column < 64; ++column) sheet.drop(column, row, kOne, {kOne, 0, 0});
    if (dry) sheet.dry_now();
    for (int row = 32; row < 64; ++row)
      for (int column = 32; column < 64; ++column) sheet.drop(column, row, kOne, {0, 3 * kOne, 0});
    EXPECT_EQ(sheet.at(40, 40).covered, dry ? kOne : 0);
    SheetPicture picture;
    picture.update(sheet);
    EXPECT_LE(difference(pixel(picture, 40, 40), colour_of(sheet, 40, 40)), 3);
    return pixel(picture, 40, 40);
  };
  const ScreenColour layered = red_over(true), mixed = red_over(false);
  EXPECT_GT(layered.red, 140);
  EXPECT_GT(layered.red, layered.green + 80);
  EXPECT_LT(mixed.red, layered.red - 30);
}

TEST(SheetPicture, WaterOnWaterPaperDarkensItAndFadesAsItDries) {
  Paper paper = find_paper("water").value();
  paper.drying_s = 1;
  Sheet sheet = sheet_of(128, paper);
  InkLoad water = dipped(1e-6, 1, {}, {});
  SheetPicture picture;
  picture.update(sheet);
  const ScreenColour dry = pixel(picture, 64, 64);
  write(sheet, water, {});
  picture.update(sheet);
  const ScreenColour wet = pixel(picture, 64, 64);
  EXPECT_LT(wet.red, dry.red - 60);
  for (int i = 0; i < 30; ++i) sheet.step();
  picture.update(sheet);
  EXPECT_GT(pixel(picture, 64, 64).red, wet.red);
  EXPECT_LT(pixel(picture, 64, 64).red, dry.red);
  while (sheet.is_wet()) sheet.step();
  picture.update(sheet);
  EXPECT_EQ(pixel(picture, 64, 64), dry);
}

}  // namespace
}  // namespace nazori::paint
