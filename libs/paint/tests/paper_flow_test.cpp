// SPDX-License-Identifier: Apache-2.0
// How the grain of the paper holds water back, and what tells two sheets apart.
#include <gtest/gtest.h>

#include <algorithm>

#include "nazori/paint/sheet_picture.h"
#include "sheet_under_test.h"

namespace nazori::paint {
namespace {

using namespace test;

/// Even paper on which water goes into the fibres at once.
Paper flowing() {
  Paper paper = even_paper();
  paper.spread_m2_s = 1e-6;
  return paper;
}

constexpr int kEvery = 6;  // cells between two drops, so that they do not meet

/// Drops `water` on every sixth cell of a sheet and lets it seep and flow once.
Sheet dropped(const Paper& paper, double water) {
  Sheet sheet = sheet_of(256, paper);
  for (int row = 3; row < 252; row += kEvery)
    for (int column = 3; column < 252; column += kEvery) sheet.drop(column, row, to_amount(water), {});
  sheet.step();
  sheet.step();
  return sheet;
}

/// Calls `look` with the four cells beside each drop.
template <class Look>
void beside_drops(const Sheet& sheet, const Look& look) {
  for (int row = 3; row < 252; row += kEvery)
    for (int column = 3; column < 252; column += kEvery)
      for (const auto& [x, y] : {std::pair(-1, 0), std::pair(1, 0), std::pair(0, -1), std::pair(0, 1)})
        look(sheet.at(column + x, row + y));
}

TEST(PaperFlow, WaterWaitsAtDryCellsThatAreHigherThanItReaches) {
  Paper paper = flowing();
  paper.pinning = 0.05;
  paper.pinning_height = 0.8;
  const double water = 0.45;
  const Sheet sheet = dropped(paper, water);
  int wet = 0, dry = 0;
  beside_drops(sheet, [&](const Cell& cell) {
    const double pinned = 0.05 + 0.8 * cell.height;
    if (std::abs(pinned - water) < 1e-4) return;
    EXPECT_EQ(cell.fibre > 0, pinned < water) << cell.height;
    ++(cell.fibre > 0 ? wet : dry);
  });
  EXPECT_GT(wet, 1000);
  EXPECT_GT(dry, 1000);
}

TEST(PaperFlow, WaterWaitsAtDenseFibresInTheShareThatTheirDensitySays) {
  // The density of fibres is equally frequent over 0..1, so 0.1 + 0.8 d < 0.5 for half of the cells.
  Paper paper = flowing();
  paper.pinning = 0.1;
  paper.pinning_fibre = 0.8;
  const Sheet sheet = dropped(paper, 0.5);
  int wet = 0, all = 0;
  beside_drops(sheet, [&](const Cell& cell) {
    wet += cell.fibre > 0 ? 1 : 0;
    ++all;
  });
  EXPECT_NEAR(static_cast<double>(wet) / all, 0.5, 0.03);
}

TEST(PaperFlow, DenseFibresConductLessByTheVariationOfThePaper) {
  Paper paper = flowing();
  const Sheet even = dropped(paper, 0.5);
  const double most = to_fraction(even.at(4, 3).fibre);
  // Cells^2 a step times the difference of the squares of the fillings.
  const double cell_m = 0.1024 / 256;
  EXPECT_NEAR(most, 1e-6 / 60 / (cell_m * cell_m) * 0.5 * 0.5, 1e-4 * most);
  paper.spread_variation = 0.8;
  const Sheet sheet = dropped(paper, 0.5);
  double sum = 0, least = 1;
  int all = 0;
  beside_drops(sheet, [&](const Cell& cell) {
    const double share = to_fraction(cell.fibre) / most;
    EXPECT_GE(share, 0.2 - 1e-3);
    EXPECT_LE(share, 1 + 1e-3);
    least = std::min(least, share);
    sum += share;
    ++all;
  });
  // In the mean a density of a half.
  EXPECT_NEAR(sum / all, 1 - 0.8 / 2, 0.02);
  EXPECT_LT(least, 0.3);
}

TEST(PaperFlow, TwoWetCellsFlowWhateverTheirHeight) {
  Paper paper = flowing();
  paper.pinning = 0.9;
  Sheet sheet = sheet_of(128, paper);
  sheet.drop(10, 10, to_amount(0.8), {});
  sheet.drop(11, 10, to_amount(0.2), {});
  sheet.step();
  sheet.step();
  EXPECT_GT(sheet.at(11, 10).fibre, to_amount(0.2));
  EXPECT_LT(sheet.at(10, 10).fibre, to_amount(0.8));
  EXPECT_EQ(sheet.at(9, 10).fibre, 0);
  EXPECT_EQ(sheet.at(12, 10).fibre, 0);
}

TEST(PaperFlow, ACellFullOfPigmentTakesNoMoreFromItsNeighbours) {
  Paper paper = flowing();
  Sheet sheet = sheet_of(128, paper);
  // Water flows from the left cell into the right one, which has as much pigment as it takes.
  sheet.drop(10, 10, to_amount(0.9), {8 * kOne, 0, 0});
  sheet.drop(11, 10, to_amount(0.1), {8 * kOne, 0, 0});
  for (int i = 0; i < 200; ++i) {
    sheet.step();
    EXPECT_LE(sheet.at(11, 10).moving[0], 8 * kOne + kOne / 2) << i;
  }
  EXPECT_EQ(sheet.holding().pigment[0], TotalAmount{16} * kOne);
}

TEST(SetPigment, WhatIsPaintedKeepsItsColourWhenTheSlotGetsAnotherPigment) {
  Sheet sheet = sheet_of(128);
  InkLoad red = full_of(1);
  write(sheet, red, {});
  sheet.dry_now();
  const ScreenColour painted = colour_of(sheet, 64, 64), bare = colour_of(sheet, 5, 5);
  ASSERT_NE(painted, bare);
  SheetPicture picture;
  picture.update(sheet);
  ASSERT_TRUE(sheet.set_pigment(1, find_pigment("cerulean-blue").value()));
  const ScreenColour after = colour_of(sheet, 64, 64);
  EXPECT_NEAR(after.red, painted.red, 1);
  EXPECT_NEAR(after.green, painted.green, 1);
  EXPECT_NEAR(after.blue, painted.blue, 1);
  EXPECT_EQ(colour_of(sheet, 5, 5), bare);
  picture.update(sheet);
  const std::uint8_t* pixel = picture.picture().rgb.data() + 3 * (64 * 128 + 64);
  EXPECT_NEAR(pixel[0], painted.red, 2);
  EXPECT_NEAR(pixel[1], painted.green, 2);
  EXPECT_NEAR(pixel[2], painted.blue, 2);
}

TEST(SetPigment, TheSamePigmentIsTakenEvenWhereItIsWet) {
  Sheet sheet = sheet_of(128);
  InkLoad black = full_of();
  write(sheet, black, {});
  EXPECT_TRUE(sheet.set_pigment(0, sheet.palette()[0]));
  Pigment heavy = sheet.palette()[2];
  heavy.mobility = 0.1;
  EXPECT_TRUE(sheet.set_pigment(2, heavy));
  EXPECT_EQ(sheet.palette()[2].mobility, 0.1);
}

TEST(SetPigment, EachValueHasItsRange) {
  Sheet sheet = sheet_of(128);
  const auto takes = [&](auto change) {
    Pigment pigment = find_pigment("sumi-blue").value();
    change(pigment);
    const auto set = sheet.set_pigment(0, pigment);
    return set.has_value();
  };
  for (const double value : {0.0, 1.0}) {
    EXPECT_TRUE(takes([&](Pigment& p) { p.mobility = value; })) << value;
    EXPECT_TRUE(takes([&](Pigment& p) { p.granulation = value; })) << value;
  }
  for (const double value : {-0.01, 1.01}) {
    EXPECT_FALSE(takes([&](Pigment& p) { p.mobility = value; })) << value;
    EXPECT_FALSE(takes([&](Pigment& p) { p.granulation = value; })) << value;
  }
  for (std::size_t band = 0; band < 3; ++band) {
    for (const double value : {0.0, 100.0}) {
      EXPECT_TRUE(takes([&](Pigment& p) { p.absorption[band] = value; })) << value;
      EXPECT_TRUE(takes([&](Pigment& p) { p.scattering[band] = value; })) << value;
    }
    for (const double value : {-0.01, 100.1}) {
      EXPECT_FALSE(takes([&](Pigment& p) { p.absorption[band] = value; })) << value;
      EXPECT_FALSE(takes([&](Pigment& p) { p.scattering[band] = value; })) << value;
    }
  }
}

TEST(Sheet, EveryDifferenceTellsTwoSheetsApart) {
  const auto with = [](auto change) {
    Sheet sheet = sheet_of(128);
    sheet.drop(9, 9, kOne, {kOne, 0, 0});
    sheet.dry_now();
    change(sheet);
    return sheet;
  };
  const Sheet plain = with([](Sheet&) {});
  EXPECT_TRUE(plain.is_same_as(with([](Sheet&) {})));
  EXPECT_FALSE(plain.is_same_as(sheet_of(256)));
  Paper other;
  other.seed = 9;
  Sheet grainy = sheet_of(128, other);
  grainy.drop(9, 9, kOne, {kOne, 0, 0});
  grainy.dry_now();
  EXPECT_FALSE(plain.is_same_as(grainy));
  EXPECT_FALSE(plain.is_same_as(with([](Sheet& s) { s.set_frozen(true); })));
  EXPECT_FALSE(
      plain.is_same_as(with([](Sheet& s) { (void)s.set_pigment(2, find_pigment("white").value()); })));
  EXPECT_FALSE(plain.is_same_as(with([](Sheet& s) { s.drop(100, 100, kOne, {}); })));
  // Water that came and went: only the air knows it.
  EXPECT_FALSE(plain.is_same_as(with([](Sheet& s) {
    s.drop(100, 100, kOne, {});
    s.dry_now();
  })));
  EXPECT_FALSE(plain.is_same_as(with([](Sheet& s) { s.drop(9, 9, kOne, {}); })));
}

TEST(DryNow, WhatACellCannotHoldBesideItsLayerCoversTheLayerAndNothingIsLost) {
  Paper paper = even_paper();
  paper.spread_m2_s = 0;
  paper.fixing_s = 0.1;
  Sheet sheet = sheet_of(128, paper);
  sheet.drop(20, 20, kOne, {7 * kOne, 0, 0});
  for (int i = 0; i < 120; ++i) sheet.step();
  ASSERT_GT(sheet.at(20, 20).fixed[0], 6 * kOne);
  // Wet paint on wet paint mixes, but a cell holds only ten fillings of pigment that is fixed.
  sheet.drop(20, 20, 0, {7 * kOne, 0, 0});
  EXPECT_EQ(sheet.holding().covered, 0);
  sheet.dry_now();
  const Cell cell = sheet.at(20, 20);
  EXPECT_EQ(cell.surface, 0);
  EXPECT_EQ(cell.fibre, 0);
  EXPECT_EQ(cell.moving[0], 0);
  EXPECT_GT(cell.covered, 6 * kOne);
  EXPECT_EQ(TotalAmount{cell.covered} + cell.fixed[0], TotalAmount{14} * kOne);
  EXPECT_EQ(sheet.evaporated(), kOne);
  EXPECT_FALSE(sheet.is_wet());
}

}  // namespace
}  // namespace nazori::paint
