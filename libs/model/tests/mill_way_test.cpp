// SPDX-License-Identifier: Apache-2.0
// The way of a cutter over a level floor, where each line of it is known.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "nazori/model/mill.h"

namespace nazori::model {
namespace {

constexpr double kKept_mm = 0.01;

/// A plate that is lower by a depth wherever `is_deep`.
Plate level(double side, double depth, const std::function<bool(double, double)>& is_deep) {
  constexpr double kStep_mm = 0.05;  // between two samples the ball sinks by a few ten-thousandths more
  Plate plate = Plate::create(side, side, kStep_mm, 8).value();
  const int size = static_cast<int>(std::lround(side / kStep_mm)) + 1;
  auto map = surface::HeightMap::create(size, 1.0F).value();
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column)
      if (is_deep(column * kStep_mm, side - row * kStep_mm)) map.set(column, row, 0.0F);
  plate.sink(map, {0, 0}, side, depth);
  return plate;
}

bool everywhere(double, double) { return true; }

void expect_move(const MillMove& move, double x, double y, double z, MillMove::Speed speed) {
  EXPECT_NEAR(move.x, x, 1e-6);
  EXPECT_NEAR(move.y, y, 1e-6);
  EXPECT_NEAR(move.z, z, 5e-4);
  EXPECT_EQ(move.speed, speed);
}

MillSettings settings() {
  MillSettings made;
  made.cutter_mm = 1;
  made.step_over_mm = 0.7;
  made.pass_depth_mm = 5;
  made.safe_mm = 4;
  made.feed_mm_min = 600;
  made.plunge_mm_min = 100;
  return made;
}

TEST(MillWay, GoesToAndFroBesideTheGuideAndBeyondItsEnds) {
  using Speed = MillMove::Speed;
  const Plate plate = level(20, 1, everywhere);
  // Two millimetres to each side in steps of up to 0.7: three and three lines, and that in the middle.
  const MillGuide guide{{{5, 10}, {9, 10}, {15, 10}}, 2};
  const MillPath path = mill_path(plate, {&guide, 1}, settings()).value();
  ASSERT_EQ(path.moves.size(), 1U + 2 + 13 + 1);
  expect_move(path.moves[0], 0, 0, 4, Speed::rapid);
  expect_move(path.moves[1], 3, 8, 4, Speed::rapid);
  expect_move(path.moves[2], 3, 8, -1 + kKept_mm, Speed::plunge);
  for (std::size_t i = 1; i < 14; ++i) {
    const std::size_t line = i / 2;
    const bool at_left = (i + 1) / 2 % 2 == 0;
    expect_move(path.moves[2 + i], at_left ? 3 : 17, 8 + 2.0 / 3 * static_cast<double>(line), -1 + kKept_mm,
                Speed::feed);
  }
  expect_move(path.moves.back(), 17, 12, 4, Speed::rapid);
  EXPECT_EQ(path.passes, 1);
  EXPECT_NEAR(path.deepest_mm, 1 - kKept_mm, 5e-4);
  const double down = 4 + 1 - kKept_mm, along = 7 * 14 + 4;
  EXPECT_NEAR(path.cut_length_mm, down + along, 2e-3);
  EXPECT_NEAR(path.minutes, down / 100 + along / 600, 1e-5);
}

TEST(MillWay, OfSeveralPassesEachIsDeeperByTheSameAndOnlyTheLastIsFine) {
  MillSettings deep = settings();
  deep.cutter_mm = 2;
  deep.pass_depth_mm = 1.2;
  const Plate plate = level(12, 3, everywhere);
  const MillGuide guide{{{5, 6}, {7, 6}}, 3};
  const MillPath path = mill_path(plate, {&guide, 1}, deep).value();
  EXPECT_EQ(path.passes, 3);
  // 0.8 of the radius of 1 mm between the lines of the first passes: four to each side.
  std::vector<double> heights;
  std::vector<int> lines;
  for (const MillMove& move : path.moves) {
    if (move.speed == MillMove::Speed::rapid) continue;
    if (heights.empty() || std::abs(heights.back() - move.z) > 5e-4) {
      heights.push_back(move.z);
      lines.push_back(0);
    }
    ++lines.back();
  }
  EXPECT_THAT(heights, testing::ElementsAre(testing::DoubleNear(-1.2, 1e-6), testing::DoubleNear(-2.4, 1e-6),
                                            testing::DoubleNear(-3 + kKept_mm, 5e-4)));
  EXPECT_THAT(lines, testing::ElementsAre(2 * 9, 2 * 9, 2 * 11)) << "both ends of each line";
  EXPECT_NEAR(path.deepest_mm, 3 - kKept_mm, 5e-4);
}

TEST(MillWay, AWholeNumberOfPassesIsNotOneMore) {
  const MillGuide guide{{{3, 4}, {5, 4}}, 1};
  for (const auto& [depth, passes] : {std::pair{1.5, 1}, {1.51, 2}, {3.0, 2}, {3.01, 3}}) {
    MillSettings some = settings();
    some.pass_depth_mm = 1.5;
    some.step_over_mm = 3;
    const Plate plate = level(8, depth, everywhere);
    EXPECT_EQ(mill_path(plate, {}, some)->passes, passes) << depth;
    some.pass_depth_mm = 1.502;
    EXPECT_EQ(mill_path(plate, {&guide, 1}, some)->passes, passes) << depth;
  }
}

TEST(MillWay, AroundACornerTheOuterLinesAreArcs) {
  const Plate plate = level(30, 1, everywhere);
  const PlatePoint corner{15, 15};
  for (const double side : {1.0, -1.0}) {
    // To the right and then up or down; two lines to each side.
    const MillGuide guide{{{8, 15}, corner, {15, 15 + side * 7}}, 3};
    MillSettings some = settings();
    some.step_over_mm = 1.5;
    const MillPath path = mill_path(plate, {&guide, 1}, some).value();
    std::vector<double> away;
    for (const MillMove& move : path.moves) {
      if (move.speed != MillMove::Speed::feed) continue;
      const PlatePoint p{move.x, move.y};
      if (p.x > 15 + 1e-6 && (p.y - 15) * side < -1e-6) away.push_back(geometry::distance(p, corner));
    }
    // A quarter of a circle, in steps of ten degrees at most, of both outer lines.
    for (const double radius : {1.5, 3.0}) {
      const auto count =
          std::count_if(away.begin(), away.end(), [&](double d) { return std::abs(d - radius) < 0.01; });
      EXPECT_GE(count, 7) << radius;
    }
    for (const double d : away) EXPECT_NEAR(std::min(std::abs(d - 1.5), std::abs(d - 3)), 0, 0.02);
  }
}

TEST(MillWay, IsLiftedWhereTheFloorEndsAndNotBetweenLinesBesideEachOther) {
  // Two pools with a dam between them.
  const Plate plate = level(30, 1, [](double x, double) { return x < 12 || x > 18; });
  const MillGuide guide{{{5, 15}, {25, 15}}, 1};
  const MillPath path = mill_path(plate, {&guide, 1}, settings()).value();
  int plunges = 0;
  for (const MillMove& move : path.moves) plunges += move.speed == MillMove::Speed::plunge ? 1 : 0;
  // Five lines of two parts. From the end of one line to the begin of the next it stays down.
  EXPECT_EQ(plunges, 6);
  for (std::size_t i = 1; i < path.moves.size(); ++i) {
    const MillMove& a = path.moves[i - 1];
    const MillMove& b = path.moves[i];
    if ((a.x < 15) != (b.x < 15) && i > 1) {
      EXPECT_EQ(b.speed, MillMove::Speed::rapid);
      EXPECT_EQ(b.z, 4);
    }
    if (b.speed == MillMove::Speed::feed) {
      EXPECT_TRUE(b.x < 12 || b.x > 18) << b.x;
    }
  }
}

TEST(MillWay, WhatIsLessThanAFiftiethDeepIsNotCut) {
  const MillGuide guide{{{5, 10}, {15, 10}}, 1};
  EXPECT_FALSE(mill_path(level(20, 0.019, everywhere), {&guide, 1}, settings()));
  EXPECT_TRUE(mill_path(level(20, 0.022, everywhere), {&guide, 1}, settings()));
}

TEST(MillWay, ASinglePointIsCutAsAShortLine) {
  const Plate plate = level(20, 1, everywhere);
  for (const PlateLine& line : {PlateLine{{10, 10}}, {{10, 10}, {10, 10}, {10, 10}}}) {
    const MillGuide guide{line, 2};
    const MillPath path = mill_path(plate, {&guide, 1}, settings()).value();
    double left = 20, right = 0, low = 20, high = 0;
    for (std::size_t i = 1; i < path.moves.size(); ++i) {
      left = std::min(left, path.moves[i].x);
      right = std::max(right, path.moves[i].x);
      low = std::min(low, path.moves[i].y);
      high = std::max(high, path.moves[i].y);
    }
    EXPECT_NEAR(left, 8, 1e-6);
    EXPECT_NEAR(right, 12.001, 1e-6);
    EXPECT_NEAR(low, 8, 1e-6);
    EXPECT_NEAR(high, 12, 1e-6);
  }
}

TEST(MillWay, WithoutGuidesLinesGoFromOneSideOfThePlateToTheOther) {
  const Plate plate = level(12, 1, everywhere);
  MillSettings some = settings();
  some.step_over_mm = 3;
  const MillPath path = mill_path(plate, {}, some).value();
  std::vector<double> lines;
  double left = 20, right = -20;
  for (const MillMove& move : path.moves) {
    if (move.speed != MillMove::Speed::feed) continue;
    left = std::min(left, move.x);
    right = std::max(right, move.x);
    if (lines.empty() || lines.back() != move.y) lines.push_back(move.y);
  }
  EXPECT_THAT(lines, testing::ElementsAre(0, 3, 6, 9, 12));
  EXPECT_GE(left, 0);
  EXPECT_LT(left, 0.3) << "beyond the plate there is nothing to cut";
  EXPECT_LE(right, 12);
  EXPECT_GT(right, 11.7);
}

TEST(MillProgram, HasAWordForEachMoveAndAFeedRateWhereItChanges) {
  MillPath path;
  path.passes = 2;
  path.minutes = 3.2;
  using Speed = MillMove::Speed;
  path.moves = {{0, 0, 5, Speed::rapid},         {1, 2, 5, Speed::rapid},   {1, 2, -1, Speed::plunge},
                {3.25, 2, -1.5, Speed::feed},    {4, 2, -1.5, Speed::feed}, {4, 2, 5, Speed::rapid},
                {6, -7.0625, -2, Speed::plunge}, {6, 8, -2, Speed::plunge}, {7, 8, -2, Speed::feed}};
  MillSettings s;
  s.cutter_mm = 2.5;
  s.safe_mm = 5;
  s.feed_mm_min = 700;
  s.plunge_mm_min = 200;
  s.spindle_rpm = 11'000;
  EXPECT_EQ(to_gcode(path, s, " ~a\x7f"),
            "(Nazori  ~a)\n"
            "(Ball cutter 2.500 mm, 2 passes, about 4 min)\n"
            "(Origin: lower left corner of the upper face)\n"
            "G21\nG90\nG17\nG94\nG0 Z5.000\nM3 S11000\nG4 P2\n"
            "G0 X0.000 Y0.000 Z5.000\n"
            "G0 X1.000 Y2.000 Z5.000\n"
            "G1 X1.000 Y2.000 Z-1.000 F200\n"
            "G1 X3.250 Y2.000 Z-1.500 F700\n"
            "G1 X4.000 Y2.000 Z-1.500\n"
            "G0 X4.000 Y2.000 Z5.000\n"
            "G1 X6.000 Y-7.062 Z-2.000 F200\n"
            "G1 X6.000 Y8.000 Z-2.000\n"
            "G1 X7.000 Y8.000 Z-2.000 F700\n"
            "G0 Z5.000\nM5\nG0 X0 Y0\nM30\n");
}

}  // namespace
}  // namespace nazori::model
