// SPDX-License-Identifier: Apache-2.0
// Where the numbers of strokes stand, and how long a line sinks.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "nazori/model/raised.h"

namespace nazori::model {
namespace {

TEST(SinkingLine, SinksOverTwoFifthsOfItsLengthButEightMillimetresAtMost) {
  EXPECT_DOUBLE_EQ(sinking_mm(10), 4);
  EXPECT_DOUBLE_EQ(sinking_mm(20), 8);
  EXPECT_DOUBLE_EQ(sinking_mm(30), 8);
}

TEST(StrokeNumbers, StandBehindTheStartClearOfItsDot) {
  const std::array stroke{RaisedStroke{{{30, 30}, {50, 30}}, LineEnd::full}};
  // The dot reaches 1.5 mm around the start, the line 1.01 mm; a number is 1.2 mm farther, in steps of a
  // half.
  const auto with_dot = stroke_numbers(stroke, 60, 60);
  ASSERT_EQ(with_dot.numbers.size(), 1U);
  EXPECT_NEAR(with_dot.numbers[0].lower_left.x, 30 - 3 - 3.75, 1e-9);
  EXPECT_NEAR(with_dot.numbers[0].lower_left.y, 30 - 3.125, 1e-9);
  EXPECT_EQ(with_dot.numbers[0].cells, (std::vector<BrailleCell>{1}));
  RaisedStrokeSettings settings;
  settings.start_dots = false;
  const auto without = stroke_numbers(stroke, 60, 60, settings);
  ASSERT_EQ(without.numbers.size(), 1U);
  EXPECT_NEAR(without.numbers[0].lower_left.x, 30 - 2.5 - 3.75, 1e-9);
  settings.numbers = false;
  EXPECT_TRUE(stroke_numbers(stroke, 60, 60, settings).numbers.empty());
}

TEST(StrokeNumbers, TurnFromBehindTheStartByFifteenDegreesToOneSideThenToTheOther) {
  // The stroke goes to the right; where another one lies behind its start decides how far.
  const RaisedStroke stroke{{{40, 40}, {60, 40}}, LineEnd::full};
  RaisedStrokeSettings settings;
  settings.start_dots = false;
  settings.line.width_mm = 0.1;
  settings.clear_mm = 0.5;
  const auto place = [&](const std::vector<RaisedStroke>& others) {
    std::vector<RaisedStroke> all{stroke};
    all.insert(all.end(), others.begin(), others.end());
    return stroke_numbers(all, 80, 80, settings).numbers.at(0).lower_left;
  };
  const auto beside = [](double degrees, double distance) {
    const double angle = degrees * std::numbers::pi / 180;
    return PlatePoint{40 + std::cos(angle) * (distance + 3.75 / 2) - 3.75 / 2,
                      40 + std::sin(angle) * (distance + 6.25 / 2) - 6.25 / 2};
  };
  const auto expect_place = [&](const std::vector<RaisedStroke>& others, PlatePoint wanted) {
    const PlatePoint found = place(others);
    EXPECT_NEAR(found.x, wanted.x, 1e-9);
    EXPECT_NEAR(found.y, wanted.y, 1e-9);
  };
  expect_place({}, beside(180, 2));
  // A point just above the box: 15 degrees is up and left of 180 - 15, so first it goes down, by 195 - 180.
  const auto point = [](double x, double y) { return RaisedStroke{{{x, y}}, LineEnd::full}; };
  expect_place({point(37, 36.4)}, beside(165, 2));
  expect_place({point(37, 43.4)}, beside(195, 2));
}

TEST(StrokeNumbers, StandSixteenMillimetresFromTheStartAtMost) {
  // All around the start the line rises as far as this.
  const std::array point{RaisedStroke{{{40, 40}}, LineEnd::full}};
  const auto placed = [&](double rises) {
    RaisedStrokeSettings settings;
    settings.start_dots = false;
    settings.clear_mm = 0.5;
    settings.line.width_mm = rises / 0.92;
    return stroke_numbers(point, 80, 80, settings);
  };
  const StrokeNumbers far = placed(15.4);
  ASSERT_EQ(far.numbers.size(), 1U);
  EXPECT_NEAR(far.numbers[0].lower_left.x, 40 - 16 - 3.75, 1e-9);
  EXPECT_NEAR(far.numbers[0].lower_left.y, 40 - 3.125, 1e-9);
  EXPECT_EQ(placed(15.6).without_room, (std::vector<int>{1}));
}

TEST(StrokeNumbers, StayOnThePageWithTheirClearance) {
  // Each begins 2 mm from an edge, from which it comes.
  for (const PlatePoint way : {PlatePoint{1, 0}, PlatePoint{-1, 0}, PlatePoint{0, 1}, PlatePoint{0, -1}}) {
    const PlatePoint start{30 - 28 * way.x, 30 - 28 * way.y};
    const std::array stroke{RaisedStroke{{start, start + way * 30}, LineEnd::full}};
    const auto made = stroke_numbers(stroke, 60, 60);
    ASSERT_EQ(made.numbers.size(), 1U);
    const PlatePoint at = made.numbers[0].lower_left;
    EXPECT_GE(at.x, 1.2);
    EXPECT_GE(at.y, 1.2);
    EXPECT_LE(at.x + 3.75, 60 - 1.2);
    EXPECT_LE(at.y + 6.25, 60 - 1.2);
  }
}

}  // namespace
}  // namespace nazori::model
