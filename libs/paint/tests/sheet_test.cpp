// SPDX-License-Identifier: Apache-2.0
// Conservation, soundness and repeatability of a sheet.
#include "nazori/paint/sheet.h"

#include <gtest/gtest.h>

#include <limits>

#include "nazori/paint/sheet_file.h"
#include "sheet_under_test.h"

namespace nazori::paint {
namespace {

using namespace test;

Paper gasenshi() { return find_paper("gasenshi").value(); }

/// A cross of sumi with a stroke of thin vermilion over it.
void write_something(Sheet& sheet, InkLoad& black, InkLoad& red, const StepOptions& options) {
  const auto step = [&] { sheet.step(options); };
  write(sheet, black, {}, step);
  write(sheet, black, {.from = {0.01, 0.03}, .to = {0.012, -0.03}, .width_m = 0.005}, step);
  for (int i = 0; i < 60; ++i) step();
  write(sheet, red, {.from = {-0.02, -0.02}, .to = {0.03, 0.02}, .width_m = 0.004, .speed_m_s = 0.3}, step);
}

TEST(Sheet, ASheetIsMadeOfWhatWasAskedFor) {
  const Sheet sheet = sheet_of(128);
  EXPECT_EQ(sheet.size(), 128);
  EXPECT_DOUBLE_EQ(sheet.cell_m(), 0.0008);
  EXPECT_EQ(sheet.area(), 64);
  EXPECT_FALSE(sheet.is_wet());
  EXPECT_EQ(sheet.at(5, 7).surface, 0);
  EXPECT_EQ(Sheet::create(100, {}, palette()).error().code, base::Errc::bad_argument);
  Paper wrong;
  wrong.film = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(Sheet::create(128, wrong, palette()).error().where, "film");
  auto pigments = palette();
  pigments[1].mobility = 1.5;
  EXPECT_EQ(Sheet::create(128, {}, pigments).error().where, "vermilion");
}

TEST(Sheet, PaperThatSpreadsTooFastForTheSizeOfTheCellsIsRefused) {
  Paper paper;
  paper.spread_m2_s = 7.4e-8;
  EXPECT_TRUE(Sheet::create(1024, paper, palette()));
  paper.spread_m2_s = 7.6e-8;
  EXPECT_FALSE(Sheet::create(1024, paper, palette()));
  EXPECT_TRUE(Sheet::create(512, paper, palette()));
}

TEST(Sheet, WaterAndPigmentAreConservedToTheLastUnit) {
  for (const std::string_view name : paper_names()) {
    Sheet sheet = sheet_of(256, find_paper(name).value());
    InkLoad black = full_of(0), red = full_of(1, 0.5);
    const InkLoad red_before = red;
    Everything before = everything(sheet, black);
    before.water += red.tip.water + red.root.water;
    for (std::size_t k = 0; k < kSlots; ++k) before.pigment += red.tip.pigment[k] + red.root.pigment[k];
    write_something(sheet, black, red, {});
    const auto now = [&] {
      Everything sum = everything(sheet, black);
      sum.water += red.tip.water + red.root.water;
      for (std::size_t k = 0; k < kSlots; ++k) sum.pigment += red.tip.pigment[k] + red.root.pigment[k];
      return sum;
    };
    EXPECT_NE(red, red_before);
    EXPECT_EQ(now(), before) << name;
    for (int i = 0; i < 300; ++i) sheet.step();
    EXPECT_GT(sheet.evaporated(), 0) << name;
    EXPECT_EQ(now(), before) << name;
    const auto saved = parse_sheet(to_bytes(sheet, black));
    ASSERT_TRUE(saved);
    EXPECT_EQ(everything(saved->sheet, saved->load), everything(sheet, black)) << name;
    sheet.dry_now();
    EXPECT_FALSE(sheet.is_wet());
    EXPECT_EQ(now(), before) << name;
    EXPECT_TRUE(is_sound(sheet));
  }
}

TEST(Sheet, ADriedSheetHasNoWaterAndNoMovingPigment) {
  Paper paper = gasenshi();
  paper.drying_s = 2;
  Sheet sheet = sheet_of(256, paper);
  InkLoad load = full_of();
  write(sheet, load, {});
  EXPECT_TRUE(sheet.is_wet());
  for (int i = 0; i < 400 && sheet.is_wet(); ++i) sheet.step();
  ASSERT_FALSE(sheet.is_wet());
  const Holding held = sheet.holding();
  EXPECT_EQ(held.water, 0);
  EXPECT_GT(held.pigment[0], 0);
  for (int i = 0; i < 256; ++i) EXPECT_EQ(sheet.at(i, 128).moving, (PigmentAmounts{}));
  sheet.step();
  sheet.step();
  EXPECT_EQ(sheet.tiles_awake(), 0);
}

TEST(Sheet, NothingIsEverNegativeOrTooMuchWhateverIsDoneToIt) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Random random(seed);
    Paper paper = find_paper(paper_names()[seed % 5]).value();
    paper.drying_s = random.within(0.5, 10);
    paper.fixing_s = random.within(0, 0.2);
    paper.rim_drying = random.within(0, 10);
    paper.granulation = random.within(0, 1);
    paper.pinning = random.within(0, 0.3);
    paper.spread_m2_s = random.within(0, 4.8e-6);
    if (paper.spread_m2_s > 4e-6) paper.spread_m2_s = 4e-6;
    Sheet sheet = sheet_of(128, paper);
    InkLoad load = dipped(1e-5, 1, {4, 4, 4}, {4, 0, 4});
    for (int act = 0; act < 60; ++act) {
      const Everything before = everything(sheet, load);
      if (random.below(3) == 0) {
        for (int i = 0; i < 40; ++i)
          sheet.drop(random.below(128), random.below(128), static_cast<Amount>(random.next()),
                     {static_cast<Amount>(random.next()), static_cast<Amount>(random.next() >> 40U), -5});
        EXPECT_GE(everything(sheet, load).water, before.water);
      } else {
        std::vector<geometry::BristleSegment> wild;
        for (int i = 0; i < 20; ++i)
          wild.push_back({{random.within(-0.08, 0.08), random.within(-0.08, 0.08)},
                          {random.within(-0.08, 0.08), random.within(-0.08, 0.08)},
                          random.within(0, 1),
                          random.within(0, 0.01),
                          random.within(0, 0.02),
                          random.within(0, 1),
                          random.within(0, 1),
                          random.within(0, 1)});
        wild[0].speed_m_s = std::numeric_limits<double>::quiet_NaN();
        wild[1].to.x = std::numeric_limits<double>::infinity();
        wild[2].from.y = 1e300;
        wild[3].width_m = -1;
        wild[4].wetness = 1e9;
        sheet.touch(wild, load);
        EXPECT_EQ(everything(sheet, load), before);
      }
      const Everything wet = everything(sheet, load);
      for (int i = random.below(20); i >= 0; --i) sheet.step();
      EXPECT_EQ(everything(sheet, load), wet);
      if (random.below(10) == 0) sheet.dry_now();
    }
    EXPECT_TRUE(is_sound(sheet)) << seed;
    EXPECT_TRUE(parse_sheet(to_bytes(sheet, load))) << seed;
  }
}

TEST(Sheet, OneOrTwoThreadsAndSleepingTilesGiveTheSameBytes) {
  const auto bytes_with = [](const StepOptions& options) {
    Sheet sheet = sheet_of(256, gasenshi());
    InkLoad black = full_of(0), red = full_of(1, 0.5);
    write_something(sheet, black, red, options);
    for (int i = 0; i < 200; ++i) sheet.step(options);
    return to_bytes(sheet, black);
  };
  const auto one = bytes_with({1, true});
  EXPECT_EQ(bytes_with({2, true}), one);
  EXPECT_EQ(bytes_with({1, false}), one);
  EXPECT_EQ(bytes_with({2, false}), one);
}

TEST(Sheet, TilesWithoutWaterSleep) {
  Sheet sheet = sheet_of(1024);
  sheet.step();
  EXPECT_EQ(sheet.tiles_awake(), 0);
  sheet.drop(16, 16, kOne, {});
  sheet.step();
  EXPECT_EQ(sheet.tiles_awake(), 1);
  sheet.step({1, false});
  EXPECT_EQ(sheet.tiles_awake(), 1024);
  // A drop at a border wakes the neighbour, too, and flows into it.
  sheet.drop(63, 500, 4 * kOne, {kOne, 0, 0});
  sheet.step();
  sheet.step();
  EXPECT_GE(sheet.tiles_awake(), 3);
  for (int i = 0; i < 60; ++i) sheet.step();
  EXPECT_GT(sheet.at(64, 500).fibre, 0);
}

TEST(Sheet, AStillWetSheetFallsAsleepWhereNothingDries) {
  Sheet sheet = sheet_of(128, even_paper());
  for (int row = 0; row < 32; ++row)
    for (int column = 0; column < 32; ++column) sheet.drop(column, row, kOne / 2, {});
  for (int row = 0; row < 128; ++row)
    for (int column = row < 32 ? 32 : 0; column < 128; ++column) sheet.drop(column, row, kOne / 2, {});
  for (int i = 0; i < 3; ++i) sheet.step();
  EXPECT_EQ(sheet.tiles_awake(), 0);
  EXPECT_TRUE(sheet.is_wet());
}

TEST(Sheet, AFrozenSheetDoesNotChange) {
  Sheet sheet = sheet_of(128);
  InkLoad load = full_of();
  write(sheet, load, {});
  sheet.step();
  const auto before = to_bytes(sheet, load);
  sheet.set_frozen(true);
  EXPECT_TRUE(sheet.is_frozen());
  for (int i = 0; i < 10; ++i) sheet.step();
  sheet.set_frozen(false);
  EXPECT_EQ(to_bytes(sheet, load), before);
  sheet.step();
  EXPECT_NE(to_bytes(sheet, load), before);
}

TEST(Sheet, WaterSeepsFromTheSurfaceAtTheRateOfThePaper) {
  Paper paper = even_paper();
  paper.spread_m2_s = 0;
  paper.absorption_s = 0.5;  // 30 steps
  Sheet sheet = sheet_of(128, paper);
  sheet.drop(5, 5, 3 * kOne, {});
  for (int i = 0; i < 15; ++i) sheet.step();
  EXPECT_NEAR(to_fraction(sheet.at(5, 5).fibre), 0.5, 1e-6);
  EXPECT_NEAR(to_fraction(sheet.at(5, 5).surface), 2.5, 1e-6);
  for (int i = 0; i < 30; ++i) sheet.step();
  EXPECT_EQ(sheet.at(5, 5).fibre, kOne);
  EXPECT_EQ(sheet.at(5, 5).surface, 2 * kOne);
}

TEST(Sheet, WaterDriesAtTheRateOfThePaperAndFasterAtTheRim) {
  Paper paper = even_paper();
  paper.spread_m2_s = 0;
  paper.drying_s = 10;  // 600 steps
  paper.rim_drying = 8 * 4;
  EXPECT_FALSE(check(paper));
  paper.rim_drying = 8;  // with cells of 0.8 mm one more for four dry neighbours
  Sheet sheet = sheet_of(128, paper);
  for (int column = 10; column < 20; ++column) {
    sheet.drop(column, 10, kOne / 2, {});
    sheet.drop(column, 11, kOne / 2, {});
    sheet.drop(column, 12, kOne / 2, {});
  }
  sheet.step();  // seeps
  const Amount inner = sheet.at(15, 11).fibre, edge = sheet.at(15, 10).fibre, corner = sheet.at(10, 10).fibre;
  for (int i = 0; i < 60; ++i) sheet.step();
  EXPECT_NEAR(to_fraction(inner - sheet.at(15, 11).fibre), 0.1, 1e-5);
  EXPECT_NEAR(to_fraction(edge - sheet.at(15, 10).fibre), 0.1 * 1.25, 1e-5);
  EXPECT_NEAR(to_fraction(corner - sheet.at(10, 10).fibre), 0.1 * 1.5, 1e-5);
}

TEST(Sheet, PigmentSettlesByTheTimeOfThePaperAndMoreInHollows) {
  Paper paper = even_paper();
  paper.spread_m2_s = 0;
  paper.fixing_s = 1;
  Sheet sheet = sheet_of(128, paper);
  sheet.drop(5, 5, kOne, {kOne, 0, 0});
  for (int i = 0; i < 60; ++i) sheet.step();
  EXPECT_NEAR(to_fraction(sheet.at(5, 5).moving[0]), std::pow(1 - 1.0 / 60, 60), 1e-4);
  paper.granulation = 1;
  auto grainy = palette();
  grainy[0].granulation = 1;
  Sheet rough = Sheet::create(128, paper, grainy).value();
  double hollow = 0, hill = 0;
  int hollows = 0, hills = 0;
  for (int row = 0; row < 128; ++row)
    for (int column = 0; column < 128; ++column) rough.drop(column, row, kOne, {kOne, 0, 0});
  for (int i = 0; i < 30; ++i) rough.step();
  for (int row = 0; row < 128; ++row) {
    for (int column = 0; column < 128; ++column) {
      const Cell cell = rough.at(column, row);
      if (cell.height < 0.1) hollow += to_fraction(cell.fixed[0]), ++hollows;
      if (cell.height > 0.9) hill += to_fraction(cell.fixed[0]), ++hills;
    }
  }
  // Rates of 2 - 2 h in each step.
  EXPECT_NEAR(hollow / hollows, 1 - std::pow(1 - 1.9 / 60, 30), 0.01);
  EXPECT_NEAR(hill / hills, 1 - std::pow(1 - 0.1 / 60, 30), 0.01);
}

TEST(Sheet, AWashDriesWithADarkEdge) {
  Paper paper = even_paper();
  paper.spread_m2_s = 2.9e-7;
  paper.drying_s = 10;
  paper.rim_drying = 10;
  paper.pinning = 0.9;  // the wash stays where it is
  Sheet sheet = sheet_of(512, paper);
  for (int row = 40; row < 80; ++row)
    for (int column = 40; column < 80; ++column) sheet.drop(column, row, kOne * 8 / 10, {kOne / 10, 0, 0});
  while (sheet.is_wet()) sheet.step();
  EXPECT_EQ(sheet.at(39, 60).fixed[0], 0);
  double edge = 0, inside = 0;
  for (int row = 50; row < 70; ++row) {
    edge += to_fraction(sheet.at(40, row).fixed[0]) / 20;
    inside += to_fraction(sheet.at(60, row).fixed[0]) / 20;
  }
  EXPECT_GT(edge, 1.3 * inside);
}

TEST(Sheet, HeavyPigmentLagsBehindTheWater) {
  Paper paper = even_paper();
  paper.spread_m2_s = 2e-6;
  Sheet sheet = sheet_of(128, paper);
  for (int row = 0; row < 128; ++row)
    for (int column = 0; column < 20; ++column) sheet.drop(column, row, kOne, {kOne / 2, kOne / 2, 0});
  for (int i = 0; i < 300; ++i) sheet.step();
  const auto reach = [&](std::size_t slot) {
    double sum = 0, all = 0;
    for (int column = 0; column < 128; ++column) {
      sum += column * to_fraction(sheet.at(column, 64).moving[slot]);
      all += to_fraction(sheet.at(column, 64).moving[slot]);
    }
    EXPECT_NEAR(all, 10, 1e-4);
    return sum / all;
  };
  // From the middle of the wash, at 9.5; sumi has a mobility of 0.9, vermilion of 0.4.
  EXPECT_GT(reach(0) - 9.5, 2 * (reach(1) - 9.5));
  EXPECT_GT(reach(1), 9.6);
}

TEST(Sheet, PinnedWaterWaitsUntilThereIsEnoughOfIt) {
  Paper paper = even_paper();
  paper.spread_m2_s = 1e-6;
  paper.pinning = 0.5;
  Sheet sheet = sheet_of(128, paper);
  sheet.drop(10, 10, to_amount(0.49), {});
  sheet.drop(30, 30, to_amount(0.51), {});
  for (int i = 0; i < 5; ++i) sheet.step();
  EXPECT_EQ(sheet.at(11, 10).fibre, 0);
  EXPECT_EQ(sheet.at(10, 9).fibre, 0);
  EXPECT_GT(sheet.at(31, 30).fibre, 0);
  EXPECT_GT(sheet.at(29, 30).fibre, 0);
  EXPECT_GT(sheet.at(30, 31).fibre, 0);
  EXPECT_GT(sheet.at(30, 29).fibre, 0);
}

TEST(Sheet, ASpotSpreadsTheSameInAllDirectionsAlsoAcrossTiles) {
  Paper paper = even_paper();
  paper.spread_m2_s = 1e-6;
  Sheet sheet = sheet_of(128, paper);
  for (int row = 30; row < 34; ++row)
    for (int column = 30; column < 34; ++column) sheet.drop(column, row, 8 * kOne, {2 * kOne, kOne, 0});
  for (int i = 0; i < 400; ++i) sheet.step();
  EXPECT_GT(sheet.at(25, 32).fibre, 0);
  for (int row = 0; row < 64; ++row) {
    for (int column = 0; column < 64; ++column) {
      const Cell here = sheet.at(column, row);
      EXPECT_NEAR(here.fibre, sheet.at(63 - column, row).fibre, 500);
      EXPECT_NEAR(here.fibre, sheet.at(row, column).fibre, 500);
      EXPECT_NEAR(here.moving[0], sheet.at(63 - column, 63 - row).moving[0], 500);
      EXPECT_NEAR(here.moving[1], sheet.at(column, 63 - row).moving[1], 500);
    }
  }
}

TEST(Sheet, ALayerThatIsDryIsCoveredAndOneThatIsWetMixes) {
  Sheet sheet = sheet_of(128);
  InkLoad black = full_of(0), red = full_of(1);
  const Stroke stroke;
  write(sheet, black, stroke);
  write(sheet, red, stroke);
  EXPECT_EQ(sheet.holding().covered, 0);
  EXPECT_GT(sheet.at(64, 64).moving[0], 0);
  EXPECT_GT(sheet.at(64, 64).moving[1], 0);
  sheet.dry_now();
  EXPECT_EQ(sheet.holding().covered, 0);
  write(sheet, red, stroke);
  EXPECT_GT(sheet.at(64, 64).covered, 0);
  EXPECT_EQ(sheet.at(64, 64).fixed, (PigmentAmounts{}));
  EXPECT_GT(sheet.at(64, 64).moving[1], 0);
  EXPECT_EQ(sheet.at(64, 64).moving[0], 0);
}

TEST(Sheet, WaterThatFlowsOverADryTileCoversItsLayer) {
  Paper paper = even_paper();
  paper.spread_m2_s = 3e-6;
  Sheet sheet = sheet_of(128, paper);
  sheet.drop(33, 5, kOne, {kOne, 0, 0});
  sheet.dry_now();
  ASSERT_EQ(sheet.at(33, 5).covered, 0);
  sheet.drop(30, 5, 10 * kOne, {0, kOne, 0});
  for (int i = 0; i < 100; ++i) sheet.step();
  EXPECT_GT(sheet.at(33, 5).fibre, 0);
  EXPECT_EQ(sheet.at(33, 5).covered, kOne);
  EXPECT_EQ(sheet.at(33, 5).fixed[0], 0);
}

TEST(Sheet, ASlotGetsAnotherPigmentOnlyWhenItsPaintIsDry) {
  Sheet sheet = sheet_of(128);
  InkLoad black = full_of(0);
  const Pigment rose = find_pigment("quinacridone-rose").value();
  EXPECT_TRUE(sheet.set_pigment(2, rose));
  EXPECT_FALSE(sheet.set_pigment(3, rose));
  EXPECT_FALSE(sheet.set_pigment(-1, rose));
  write(sheet, black, {});
  const TotalAmount pigment = sheet.holding().pigment[0];
  EXPECT_EQ(sheet.set_pigment(0, rose).error().code, base::Errc::bad_argument);
  EXPECT_TRUE(sheet.set_pigment(1, rose));
  sheet.dry_now();
  EXPECT_TRUE(sheet.set_pigment(0, rose));
  EXPECT_EQ(sheet.palette()[0], rose);
  EXPECT_EQ(sheet.holding().covered, pigment);
  EXPECT_EQ(sheet.holding().pigment[0], 0);
}

TEST(Sheet, ACellTakesWhatItHasRoomFor) {
  Sheet sheet = sheet_of(128);
  const auto pair = [](Amount water, const PigmentAmounts& pigment) { return std::pair(water, pigment); };
  EXPECT_EQ(sheet.drop(3, 4, 15 * kOne, {7 * kOne, -kOne, 0}), pair(15 * kOne, {7 * kOne, 0, 0}));
  EXPECT_EQ(sheet.drop(3, 4, 2 * kOne, {2 * kOne, 0, 9 * kOne}), pair(kOne, {kOne, 0, 8 * kOne}));
  EXPECT_EQ(sheet.drop(3, 4, kOne, {1, 1, 1}), pair(0, {0, 1, 0}));
  EXPECT_EQ(sheet.drop(3, 4, -kOne, {}), pair(0, {}));
  const Cell cell = sheet.at(3, 4);
  EXPECT_EQ(cell.surface, 16 * kOne);
  EXPECT_EQ(cell.moving, (PigmentAmounts{8 * kOne, 1, 8 * kOne}));
  EXPECT_EQ(sheet.holding().water, 16 * kOne);
  EXPECT_EQ(sheet.holding().pigment, (std::array<TotalAmount, kSlots>{8 * kOne, 1, 8 * kOne}));
}

TEST(Sheet, WhatDriesAtOnceIsCountedInTheAir) {
  Paper paper = even_paper();
  paper.absorption_s = 0.1;
  Sheet sheet = sheet_of(128, paper);
  sheet.drop(3, 4, 2 * kOne, {});
  for (int i = 0; i < 3; ++i) sheet.step();
  ASSERT_GT(sheet.at(3, 4).fibre, 0);
  ASSERT_GT(sheet.at(3, 4).surface, 0);
  EXPECT_EQ(sheet.evaporated(), 0);
  sheet.dry_now();
  EXPECT_EQ(sheet.evaporated(), 2 * kOne);
  EXPECT_EQ(sheet.holding().water, 0);
}

}  // namespace
}  // namespace nazori::paint
