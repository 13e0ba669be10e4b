// SPDX-License-Identifier: Apache-2.0
// What paper takes from a brush.
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "sheet_under_test.h"

namespace nazori::paint {
namespace {

using namespace test;

struct Wetted {
  int cells = 0;
  double share = 0;  // of the cells well inside the stroke
};

Wetted wetted(const Sheet& sheet, const Stroke& s) {
  Wetted result;
  int inside = 0, wet = 0;
  const double cell = sheet.cell_m();
  for (int row = 0; row < sheet.size(); ++row) {
    for (int column = 0; column < sheet.size(); ++column) {
      const bool is_wet = sheet.at(column, row).surface > 0;
      result.cells += is_wet ? 1 : 0;
      const double x = (column + 0.5) * cell - Sheet::kSide_m / 2,
                   y = Sheet::kSide_m / 2 - (row + 0.5) * cell;
      if (x < s.from.x || x > s.to.x || std::abs(y - s.from.y) > 0.45 * s.width_m) continue;
      ++inside;
      wet += is_wet ? 1 : 0;
    }
  }
  result.share = static_cast<double>(wet) / inside;
  return result;
}

/// Water to write so little of that the brush stays as full as it was.
InkLoad endless(double fullness) { return dipped(1e-5, fullness, {1, 0, 0}, {1, 0, 0}, 3e-7); }

// Reference: w 0.6, Lc 8 mm, tau0 0.12 s, gamma 1; 80, 120, 200, 400 mm/s wet .5, .333, .2, .1 of the cells.
TEST(Deposit, AFastBristleSkipsOverThePaperByTheFormula) {
  Paper paper;
  paper.kasure_s = 0.12;
  const std::array<std::pair<double, double>, 5> kCases{
      {{0.03, 1}, {0.08, 0.5}, {0.12, 1.0 / 3}, {0.2, 0.2}, {0.4, 0.1}}};
  for (const auto& [speed, share] : kCases) {
    Sheet sheet = sheet_of(512, paper);
    InkLoad load = endless(0.6);
    const Stroke stroke{.width_m = 0.03, .speed_m_s = speed};
    write(sheet, load, stroke);
    EXPECT_NEAR(wetted(sheet, stroke).share, share, 0.01) << speed;
  }
  paper.kasure_exponent = 2;
  Sheet sheet = sheet_of(512, paper);
  InkLoad load = endless(0.6);
  const Stroke stroke{.width_m = 0.03, .speed_m_s = 0.4};
  write(sheet, load, stroke);
  EXPECT_NEAR(wetted(sheet, stroke).share, std::sqrt(0.1), 0.01);
}

TEST(Deposit, SegmentsThatAreNoNumbersLeaveNothing) {
  Sheet sheet = sheet_of(128);
  InkLoad load = full_of();
  const InkLoad before = load;
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  const geometry::BristleSegment good = segments_of({}, 3).front();
  std::vector<geometry::BristleSegment> bad(9, good);
  bad[0].from.x = kNan;
  bad[1].to.y = kInfinite;
  bad[2].width_m = kNan;
  bad[3].length_m = -1;
  bad[4].speed_m_s = kInfinite;
  bad[5].wetness = 1.01;
  bad[6].pigment = kNan;
  bad[7].pressure = -0.1;
  bad[8].wetness = 0;
  sheet.touch(bad, load);
  EXPECT_EQ(load, before);
  EXPECT_FALSE(sheet.is_wet());
  sheet.touch({&good, 1}, load);
  EXPECT_TRUE(sheet.is_wet());
}

TEST(Deposit, EveryNumberOfASegmentMustBeInItsRange) {
  using geometry::BristleSegment;
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  const auto leaves_ink = [](const BristleSegment& segment) {
    Sheet sheet = sheet_of(128);
    InkLoad load = full_of();
    sheet.touch({&segment, 1}, load);
    return sheet.is_wet();
  };
  const BristleSegment good = segments_of({}, 3).front();
  ASSERT_TRUE(leaves_ink(good));
  const auto with = [&](double BristleSegment::*member, double value) {
    BristleSegment segment = good;
    segment.*member = value;
    return leaves_ink(segment);
  };
  for (double BristleSegment::*member :
       {&BristleSegment::width_m, &BristleSegment::length_m, &BristleSegment::speed_m_s,
        &BristleSegment::wetness, &BristleSegment::pigment, &BristleSegment::pressure})
    for (const double value : {kNan, kInfinite, -kInfinite, -1e-9})
      EXPECT_FALSE(with(member, value)) << value;
  for (double BristleSegment::*share :
       {&BristleSegment::wetness, &BristleSegment::pigment, &BristleSegment::pressure}) {
    EXPECT_TRUE(with(share, 1));
    EXPECT_FALSE(with(share, 1.0001));
  }
  for (double BristleSegment::*share : {&BristleSegment::width_m, &BristleSegment::speed_m_s,
                                        &BristleSegment::pigment, &BristleSegment::pressure})
    EXPECT_TRUE(with(share, 0));
  EXPECT_FALSE(with(&BristleSegment::wetness, 0));
  for (const double value : {kNan, kInfinite}) {
    for (int i = 0; i < 4; ++i) {
      BristleSegment segment = good;
      (i < 2 ? (i == 0 ? segment.from.x : segment.from.y) : (i == 2 ? segment.to.x : segment.to.y)) = value;
      EXPECT_FALSE(leaves_ink(segment)) << i;
    }
  }
}

TEST(Deposit, MoreSpeedWetsLessAndMoreInkOrPressureWetsMore) {
  Paper paper;
  paper.kasure_s = 0.12;
  const auto wet = [&](const Stroke& stroke, double fullness) {
    Sheet sheet = sheet_of(256, paper);
    InkLoad load = endless(fullness);
    write(sheet, load, stroke);
    return std::pair(wetted(sheet, stroke).cells, sheet.holding().water);
  };
  auto last = wet({.speed_m_s = 0.05}, 0.7);
  for (const double speed : {0.1, 0.2, 0.4, 0.8}) {
    const auto now = wet({.speed_m_s = speed}, 0.7);
    EXPECT_LT(now.first, last.first) << speed;
    EXPECT_LT(now.second, last.second) << speed;
    last = now;
  }
  last = {0, 0};
  for (const double fullness : {0.1, 0.3, 0.5, 0.8}) {
    const auto now = wet({.speed_m_s = 0.1}, fullness);
    EXPECT_GT(now.first, last.first) << fullness;
    EXPECT_GT(now.second, last.second) << fullness;
    last = now;
  }
  // A brush that is pressed deeper touches with more of its length, over a broader band, and with more force.
  last = {0, 0};
  for (const double depth : {0.2, 0.4, 0.6, 0.8}) {
    const auto now =
        wet({.width_m = 0.01 * depth, .speed_m_s = 0.1, .length_m = 0.01 * depth, .pressure = depth}, 0.7);
    EXPECT_GT(now.first, last.first) << depth;
    EXPECT_GT(now.second, last.second) << depth;
    last = now;
  }
  EXPECT_GT(wet({.pressure = 1}, 0.7).second, wet({.pressure = 0.5}, 0.7).second);
}

TEST(Deposit, TheBandIsAsWideAsTheBristleAndLiesWhereItWent) {
  Sheet sheet = sheet_of(1024);
  InkLoad load = full_of();
  const geometry::BristleSegment segment{{0.01, 0.02}, {0.03, 0.02}, 1, 0.002, 0.01, 0, 1, 1};
  sheet.touch({&segment, 1}, load);
  // x 61.2..81.2 mm, y 31.2 mm from the top, 1 mm to each side, with round ends.
  const auto is_wet = [&](int column, int row) { return sheet.at(column, row).surface > 0; };
  EXPECT_TRUE(is_wet(700, 312));
  EXPECT_TRUE(is_wet(700, 303));
  EXPECT_FALSE(is_wet(700, 300));
  EXPECT_TRUE(is_wet(700, 320));
  EXPECT_FALSE(is_wet(700, 323));
  EXPECT_TRUE(is_wet(603, 312));
  EXPECT_FALSE(is_wet(600, 312));
  EXPECT_FALSE(is_wet(604, 304));
  EXPECT_TRUE(is_wet(820, 312));
  EXPECT_FALSE(is_wet(823, 312));
  int cells = 0;
  for (int row = 0; row < 1024; ++row)
    for (int column = 0; column < 1024; ++column) cells += is_wet(column, row) ? 1 : 0;
  EXPECT_NEAR(cells, 200 * 20 + M_PI * 100, 60);
}

TEST(Deposit, ASlantedBandHasTheSameArea) {
  const auto cells_of = [](geometry::PaperPoint to) {
    Sheet sheet = sheet_of(512);
    InkLoad load = full_of();
    const geometry::BristleSegment segment{{0, 0}, to, 1, 0.006, 0.01, 0, 1, 1};
    sheet.touch({&segment, 1}, load);
    int cells = 0;
    for (int row = 0; row < 512; ++row)
      for (int column = 0; column < 512; ++column) cells += sheet.at(column, row).surface > 0 ? 1 : 0;
    return cells;
  };
  const double area = 30 * 200 + M_PI * 225;
  for (int i = 0; i < 12; ++i) {
    const double angle = 0.1 + i * M_PI / 6;
    EXPECT_NEAR(cells_of({0.04 * std::cos(angle), 0.04 * std::sin(angle)}), area, 0.015 * area) << i;
  }
  EXPECT_NEAR(cells_of({0, 0}), M_PI * 225, 20);
  EXPECT_NEAR(cells_of({0, 0.04}), area, 0.015 * area);
}

TEST(Deposit, HowOftenThePenIsReportedDoesNotMatter) {
  const auto written = [](int events_per_step, int size) {
    Sheet sheet = sheet_of(size, find_paper("gasenshi").value());
    InkLoad load = full_of();
    // 1.2 s at 60, 240 or 1,020 events a second.
    const int steps = 72 * events_per_step;
    int event = 0;
    write(sheet, load, {.from = {-0.03, -0.011}, .to = {0.03, 0.013}, .steps = steps}, [&] {
      if (++event % events_per_step == 0) sheet.step();
    });
    for (int i = 0; i < 120; ++i) sheet.step();
    double area = 0;
    for (int row = 0; row < size; ++row)
      for (int column = 0; column < size; ++column)
        area += sheet.at(column, row).fibre > kOne / 20 ? sheet.cell_m() * sheet.cell_m() : 0;
    const Holding held = sheet.holding();
    return std::array{area, to_fraction(held.water * sheet.area()),
                      to_fraction(held.pigment[0] * sheet.area())};
  };
  const auto seldom = written(1, 512);
  const auto often = written(4, 512), most = written(17, 512);
  const auto fine = written(4, 1024);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(often[i], seldom[i], 0.02 * seldom[i]) << i;
    EXPECT_NEAR(most[i], seldom[i], 0.02 * seldom[i]) << i;
    EXPECT_NEAR(fine[i], often[i], 0.02 * often[i]) << i;
  }
}

TEST(Deposit, ASecondPassOverWetPaperAddsNothing) {
  Sheet sheet = sheet_of(256);
  InkLoad load = endless(1);
  write(sheet, load, {});
  const Holding once = sheet.holding();
  write(sheet, load, {});
  EXPECT_NEAR(static_cast<double>(sheet.holding().water), static_cast<double>(once.water),
              1e-3 * static_cast<double>(once.water));
  EXPECT_NEAR(static_cast<double>(sheet.holding().pigment[0]), static_cast<double>(once.pigment[0]),
              1e-3 * static_cast<double>(once.pigment[0]));
}

TEST(Deposit, ACellGetsTheFilmOfThePaper) {
  Paper paper;
  paper.film = 0.8;
  Sheet sheet = sheet_of(128, paper);
  InkLoad load = endless(1);
  const Stroke stroke{.pressure = 0.5, .wetness = 0.5};
  sheet.touch(segments_of(stroke, 15), load);
  EXPECT_NEAR(to_fraction(sheet.at(64, 64).surface), 0.8 * 0.5 * 0.7, 1e-5);
  EXPECT_NEAR(to_fraction(sheet.at(64, 64).moving[0]), 0.8 * 0.5 * 0.7, 1e-5);
}

TEST(Deposit, TheBrushRunsDryAndGivesWhatThePaperTakes) {
  Sheet sheet = sheet_of(256);
  InkLoad load = dipped(5e-9, 1, {1, 0, 0}, {1, 0, 0});
  double last = load.fullness();
  EXPECT_EQ(last, 1);
  for (int i = 0; i < 6; ++i) {
    const TotalAmount before = load.tip.water + load.root.water;
    const TotalAmount held = sheet.holding().water;
    const double y = 0.03 - 0.01 * i;
    write(sheet, load, {.from = {-0.03, y}, .to = {0.03, y}});
    EXPECT_LE(load.fullness(), last);
    last = load.fullness();
    EXPECT_EQ(before - load.tip.water - load.root.water, (sheet.holding().water - held) * sheet.area());
  }
  EXPECT_LT(last, 0.1);
  EXPECT_GE(load.tip.water, 0);
}

TEST(Deposit, ABrushWithADarkTipBeginsDarkAndEndsPale) {
  Paper paper;
  paper.kasure_s = 0;
  Sheet sheet = sheet_of(256, paper);
  InkLoad load = dipped(4e-8, 1, {1, 0, 0}, {0.1, 0, 0});
  write(sheet, load, {.steps = 60});
  const auto darkness = [&](int column) {
    const Cell cell = sheet.at(column, 128);
    return to_fraction(cell.moving[0]) / to_fraction(cell.surface);
  };
  EXPECT_NEAR(darkness(56), 1, 0.15);
  EXPECT_GT(darkness(56), darkness(100));
  EXPECT_GT(darkness(100), darkness(195));
  EXPECT_GE(darkness(195), 0.1);
}

TEST(Deposit, TipAndRootStayEquallyFull) {
  InkLoad load = dipped(1e-6, 0.8, {1, 0.5, 0}, {0.2, 0, 0.3});
  const Everything before = everything(sheet_of(128), load);
  EXPECT_NEAR(load.fullness(), 0.8, 1e-9);
  EXPECT_NEAR(load.concentration()[0], 1, 1e-6);
  EXPECT_NEAR(static_cast<double>(load.root.water), 3.0 * static_cast<double>(load.tip.water), 8);
  const TotalAmount water = load.tip.water / 2, pigment = load.tip.pigment[0] / 2;
  load.give(water, {pigment, 0, 0});
  EXPECT_NEAR(static_cast<double>(load.root.water), 3.0 * static_cast<double>(load.tip.water), 8);
  const Everything after = everything(sheet_of(128), load);
  EXPECT_EQ(after.water, before.water - water);
  EXPECT_EQ(after.pigment, before.pigment - pigment);
  EXPECT_GT(load.tip.pigment[2], 0);
  EXPECT_EQ(InkLoad{}.fullness(), 0);
}

TEST(Deposit, ABristleThatFliesWetsNoCell) {
  Paper paper;
  paper.kasure_s = 0.1;
  Sheet sheet = sheet_of(128, paper);
  InkLoad load = endless(1);
  // A share of 8e-8 of the cells, less than one of all.
  write(sheet, load, {.speed_m_s = 1e6});
  EXPECT_FALSE(sheet.is_wet());
  // Without resistance the speed does not count.
  paper.kasure_s = 0;
  Sheet smooth = sheet_of(128, paper);
  write(smooth, load, {.speed_m_s = 1e6});
  EXPECT_TRUE(smooth.is_wet());
}

TEST(Deposit, ADippedBrushHoldsAQuarterInItsTip) {
  // 1e-6 m^3 are 5e6 cells of 0.1 mm and a depth of 2e-5 m.
  const InkLoad load = dipped(1e-6, 0.5, {1, 0.5, 9}, {0, 2, -1});
  EXPECT_NEAR(to_fraction(load.capacity), 5e6, 1e-3);
  EXPECT_NEAR(to_fraction(load.tip.water), 625'000, 1e-3);
  EXPECT_NEAR(to_fraction(load.root.water), 1'875'000, 1e-3);
  EXPECT_EQ(load.tip.water, (load.tip.water + load.root.water) / 4);
  EXPECT_EQ(load.tip.pigment, (std::array{load.tip.water, load.tip.water / 2, 4 * load.tip.water}));
  EXPECT_EQ(load.root.pigment, (std::array{TotalAmount{0}, 2 * load.root.water, TotalAmount{0}}));
  EXPECT_NEAR(load.fullness(), 0.5, 1e-9);
  const Concentrations ink = load.concentration();
  EXPECT_NEAR(ink[0], 1, 1e-9);
  EXPECT_NEAR(ink[1], 0.5, 1e-9);
  EXPECT_NEAR(ink[2], 4, 1e-9);
  EXPECT_EQ(dipped(1e-6, 2, {}, {}), dipped(1e-6, 1, {}, {}));
  EXPECT_EQ(dipped(1e-6, -1, {}, {}).tip.water, 0);
  EXPECT_EQ(dipped(1, 1, {}, {}), dipped(1e-5, 1, {}, {}));
  EXPECT_EQ(dipped(1e-5, 1, {}, {}, 1e-9).capacity, TotalAmount{4'000'000'000} * kOne);
  EXPECT_EQ(dipped(-1, 1, {}, {}), InkLoad{});
  EXPECT_EQ(InkLoad{}.concentration(), Concentrations{});
}

TEST(Deposit, TheRootGivesTheTipInkOfItsOwnStrength) {
  InkLoad load;
  load.capacity = 4000;
  load.tip = {1000, {1000, 0, 0}};
  load.root = {3000, {0, 1500, 300}};
  load.give(400, {400, 0, 0});
  // Of 3,600 the tip has a quarter again: 300 come down.
  EXPECT_EQ(load.tip.water, 900);
  EXPECT_EQ(load.root.water, 2700);
  EXPECT_EQ(load.tip.pigment, (std::array<TotalAmount, kSlots>{600, 150, 30}));
  EXPECT_EQ(load.root.pigment, (std::array<TotalAmount, kSlots>{0, 1350, 270}));
  // From a root that has less than its part nothing comes.
  load.root = {2, {0, 2, 0}};
  load.give(1, {0, 0, 0});
  EXPECT_EQ(load.tip.water, 899);
  EXPECT_EQ(load.root.water, 2);
}

}  // namespace
}  // namespace nazori::paint
