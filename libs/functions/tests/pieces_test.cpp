// SPDX-License-Identifier: Apache-2.0
// How many pieces lines, dots and areas are, of drawings that are made by hand.
#include <gtest/gtest.h>

#include "drawn_lines.h"
#include "nazori/functions/points.h"

namespace nazori::functions {
namespace {

using test::line;
using test::tracing_of;

/// A line of a curve with a parameter, as y = f(x): its ends are real.
Branch arc(std::vector<CurvePoint> points) {
  Branch made = line(std::move(points));
  made.has_parameter = true;
  return made;
}

int pieces_of(std::vector<Branch> branches) { return pieces_of(tracing_of(std::move(branches)), 0); }

TEST(Pieces, LinesThatMeetAreOne) {
  const Branch level = arc({{0.2, 0.5, 0}, {0.5, 0.5, 0}});
  EXPECT_EQ(pieces_of({}), 0);
  EXPECT_EQ(pieces_of({level}), 1);
  EXPECT_EQ(pieces_of({level, arc({{0.5, 0.5, 0}, {0.8, 0.7, 0}})}), 1) << "end to end";
  EXPECT_EQ(pieces_of({level, arc({{0.3, 0.2, 0}, {0.4, 0.8, 0}})}), 1) << "across";
  EXPECT_EQ(pieces_of({level, arc({{0.4, 0.5, 0}, {0.4, 0.8, 0}})}), 1) << "an end on the other";
  EXPECT_EQ(pieces_of({level, arc({{0.2, 0.6, 0}, {0.5, 0.6, 0}})}), 2);
  EXPECT_EQ(pieces_of({level, arc({{0.5003, 0.5, 0}, {0.8, 0.5, 0}})}), 1) << "nearer than 0.0004";
  EXPECT_EQ(pieces_of({level, arc({{0.5006, 0.5, 0}, {0.8, 0.5, 0}})}), 2);
  EXPECT_EQ(pieces_of({level, arc({{0.3, 0.5003, 0}, {0.3, 0.8, 0}})}), 1);
  EXPECT_EQ(pieces_of({level, arc({{0.3, 0.5006, 0}, {0.3, 0.8, 0}})}), 2);
}

TEST(Pieces, OnlyWhatIsInTheWindowCounts) {
  EXPECT_EQ(pieces_of({arc({{1.2, 0.5, 0}, {1.5, 0.5, 0}})}), 0);
  EXPECT_EQ(pieces_of({arc({{0.5, -0.5, 0}, {0.5, -0.1, 0}})}), 0);
  EXPECT_EQ(pieces_of({arc({{0.9, 1.2, 0}, {1.2, 0.9, 0}})}), 0) << "past the corner";
  EXPECT_EQ(pieces_of({arc({{-0.5, 0.5, 0}, {1.5, 0.5, 0}})}), 1);
  EXPECT_EQ(pieces_of({arc({{0, 0.2, 0}, {0, 0.8, 0}})}), 1) << "along the edge";
  EXPECT_EQ(pieces_of({arc({{-1e-6, 0.2, 0}, {-1e-6, 0.8, 0}})}), 0);
  // Out at the right and in again.
  EXPECT_EQ(pieces_of({arc({{0.5, 0.3, 0}, {1.5, 0.3, 0}, {1.5, 0.7, 0}, {0.5, 0.7, 0}})}), 2);
  EXPECT_EQ(pieces_of({arc({{0.5, 0.3, 0}, {1.5, 0.5, 0}, {0.5, 0.7, 0}})}), 2);
  EXPECT_EQ(pieces_of({arc({{0.5, 0.3, 0}, {0.9, 0.5, 0}, {0.5, 0.7, 0}})}), 1);
}

TEST(Pieces, DotsAndBarsAreAloneUnlessALineTouchesThem) {
  Tracing t = tracing_of({arc({{0.2, 0.5, 0}, {0.5, 0.5, 0}})});
  t.dots.push_back({0, {0.3, 0.5}});
  EXPECT_EQ(pieces_of(t, 0), 1);
  t.dots.push_back({0, {0.3, 0.51}});
  EXPECT_EQ(pieces_of(t, 0), 2);
  t.bars.push_back({0, {0.7, 0.2}, {0.7, 0.8}});
  EXPECT_EQ(pieces_of(t, 0), 3);
  t.bars.push_back({0, {0.45, 0.2}, {0.45, 0.8}});
  EXPECT_EQ(pieces_of(t, 0), 3);
  t.dots.push_back({0, {1.1, 0.5}});
  t.bars.push_back({0, {1.1, 0.2}, {1.1, 0.8}});
  EXPECT_EQ(pieces_of(t, 0), 3) << "outside the window";
  t.dots.push_back({1, {0.9, 0.9}});
  EXPECT_EQ(pieces_of(t, 0), 3) << "of another statement";
  EXPECT_EQ(pieces_of(t, 1), 1);
}

TEST(Pieces, ALineOfAnEquationGoesOnBeyondASmallGap) {
  const auto apart = [](double gap, bool has_parameter, bool boundary) {
    Branch a = line({{0.2, 0.5, 0}, {0.5, 0.5, 0}});
    Branch b = line({{0.5 + gap, 0.5, 0}, {0.8, 0.5, 0}});
    a.has_parameter = b.has_parameter = has_parameter;
    a.boundary = b.boundary = boundary;
    return pieces_of({a, b});
  };
  EXPECT_EQ(apart(0.007, false, false), 1);
  EXPECT_EQ(apart(0.009, false, false), 2);
  EXPECT_EQ(apart(0.007, true, false), 2);
  EXPECT_EQ(apart(0.007, false, true), 2);
  // A closed line has no end.
  const Branch ring = line({{0.2, 0.2, 0}, {0.4, 0.2, 0}, {0.4, 0.4, 0}, {0.2, 0.4, 0}}, 0, true);
  EXPECT_EQ(pieces_of({ring, arc({{0.1, 0.195, 0}, {0.3, 0.195, 0}})}), 2);
  // The nearest one goes on, and only that one.
  const Branch stub = line({{0.5, 0.5, 0}, {0.3, 0.5, 0}});
  const Branch near = arc({{0.504, 0.4, 0}, {0.504, 0.6, 0}});
  const Branch far = arc({{0.507, 0.4, 0}, {0.507, 0.6, 0}});
  EXPECT_EQ(pieces_of({stub, near, far}), 2);
  EXPECT_EQ(pieces_of({stub, far, near}), 2);
}

TEST(Pieces, TheShortLineInACuspBelongsToTheNearestOther) {
  const auto at = [](double gap, double length, bool has_parameter) {
    Branch tip = line({{0.5 + gap, 0.5, 0}, {0.5 + gap + length, 0.5, 0}});
    tip.has_parameter = has_parameter;
    return pieces_of({arc({{0.5, 0.2, 0}, {0.5, 0.8, 0}}), tip});
  };
  EXPECT_EQ(at(0.14, 0.0003, false), 1);
  EXPECT_EQ(at(0.16, 0.0003, false), 2);
  EXPECT_EQ(at(0.14, 0.0005, false), 2) << "no short one";
  EXPECT_EQ(at(0.14, 0.0003, true), 2) << "its ends are real";
}

/// Cells of 1/1024 of the plate.
Fill cells(double left, double low, double right, double high) {
  return {0, {left / 1024, low / 1024}, {right / 1024, high / 1024}};
}

int pieces_of_fills(std::vector<Fill> fills, std::vector<Branch> branches = {}) {
  Tracing t = tracing_of(std::move(branches));
  t.fills = std::move(fills);
  return pieces_of(t, 0);
}

TEST(Pieces, AreasInNeighbouringCellsAreOne) {
  const Branch border = arc({{0.9, 0.9, 0}, {0.95, 0.9, 0}});  // so that a border belongs to the region
  const Fill area = cells(100.5, 100.5, 200.5, 200.5);
  EXPECT_EQ(pieces_of_fills({area}, {border}), 2);
  EXPECT_EQ(pieces_of_fills({area, cells(200.7, 100.5, 300.5, 200.5)}, {border}), 2) << "the same cell";
  EXPECT_EQ(pieces_of_fills({area, cells(201.5, 100.5, 300.5, 200.5)}, {border}), 2)
      << "the next to the right";
  EXPECT_EQ(pieces_of_fills({area, cells(202.5, 100.5, 300.5, 200.5)}, {border}), 3);
  EXPECT_EQ(pieces_of_fills({area, cells(100.5, 201.5, 200.5, 300.5)}, {border}), 2) << "the next above";
  EXPECT_EQ(pieces_of_fills({area, cells(100.5, 202.5, 200.5, 300.5)}, {border}), 3);
  EXPECT_EQ(pieces_of_fills({area, cells(201.5, 201.5, 300.5, 300.5)}, {border}), 3) << "only aslant";
  EXPECT_EQ(pieces_of_fills({area, cells(1100, 100, 1200, 200)}, {border}), 2) << "outside the window";
  EXPECT_EQ(pieces_of_fills({area, cells(-200, 100, -100, 200)}, {border}), 2);
  EXPECT_EQ(pieces_of_fills({area, cells(100, -200, 200, -100)}, {border}), 2);
  EXPECT_EQ(pieces_of_fills({area, cells(100, 1100, 200, 1200)}, {border}), 2);
  Fill other = cells(500, 500, 600, 600);
  other.statement = 1;
  EXPECT_EQ(pieces_of_fills({area, other}, {border}), 2);
}

TEST(Pieces, ABorderBelongsToTheAreaUpToFourCellsAway) {
  const Fill area = cells(100.5, 100.5, 200.5, 200.5);
  const auto level = [](double row) {
    return arc({{120.5 / 1024, row / 1024, 0}, {180.5 / 1024, row / 1024, 0}});
  };
  const auto upright = [](double column) {
    return arc({{column / 1024, 120.5 / 1024, 0}, {column / 1024, 180.5 / 1024, 0}});
  };
  EXPECT_EQ(pieces_of_fills({area}, {level(204.5)}), 1);
  EXPECT_EQ(pieces_of_fills({area}, {level(205.5)}), 2);
  EXPECT_EQ(pieces_of_fills({area}, {level(96.5)}), 1);
  EXPECT_EQ(pieces_of_fills({area}, {level(95.5)}), 2);
  EXPECT_EQ(pieces_of_fills({area}, {upright(204.5)}), 1);
  EXPECT_EQ(pieces_of_fills({area}, {upright(205.5)}), 2);
  EXPECT_EQ(pieces_of_fills({area}, {upright(96.5)}), 1);
  EXPECT_EQ(pieces_of_fills({area}, {upright(95.5)}), 2);
}

TEST(Pieces, AreasThatTouchInAPointAreSeveralWhereTheirBordersDoNotBelong) {
  // x y > 0 in the middle of the window.
  const std::vector<Fill> areas{cells(513, 513, 1024, 1024), cells(0, 0, 511, 511)};
  Branch level = line({{0, 0.5, 0}, {1, 0.5, 0}});
  Branch upright = line({{0.5, 0, 0}, {0.5, 1, 0}});
  for (const bool strict : {false, true}) {
    level.boundary = upright.boundary = true;
    level.strict = upright.strict = strict;
    EXPECT_EQ(pieces_of_fills(areas, {level, upright}), strict ? 2 : 1);
  }
  // One border that belongs is enough.
  level.strict = true;
  upright.strict = false;
  EXPECT_EQ(pieces_of_fills(areas, {level, upright}), 1);
  // What is narrower than some cells is not told apart.
  upright.strict = true;
  EXPECT_EQ(pieces_of_fills({areas[0], cells(505, 505, 509, 509)}, {level, upright}), 1);
  EXPECT_EQ(pieces_of_fills({areas[0], cells(500, 500, 509, 509)}, {level, upright}), 2);
}

}  // namespace
}  // namespace nazori::functions
