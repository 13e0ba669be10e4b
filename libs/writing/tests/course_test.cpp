// SPDX-License-Identifier: Apache-2.0
// How the directions of two strokes differ as they go along, by closed forms and by trying every way.
#include "course.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

namespace nazori::writing::test {
namespace {

using Line = std::vector<std::pair<double, double>>;

Samples sampled(const Line& line) {
  std::vector<double> xs;
  std::vector<double> ys;
  for (const auto& [x, y] : line) {
    xs.push_back(x);
    ys.push_back(y);
  }
  return sample_line(xs, ys);
}

Line straight(double degrees, double length = 50) {
  const double a = degrees * std::numbers::pi / 180;
  return {{40, 40}, {40 + length * std::cos(a), 40 + length * std::sin(a)}};
}

Line circle() {
  Line line;
  for (int k = 0; k <= 92; ++k) {
    const double a = 2 * std::numbers::pi * k / 92;
    line.emplace_back(50 + 20 * std::cos(a), 50 + 20 * std::sin(a));
  }
  return line;
}

/// Right for `right` units, then down for `down`.
Line corner(double right, double down) { return {{20, 20}, {20 + right, 20}, {20 + right, 20 + down}}; }

Line backwards(Line line) {
  std::reverse(line.begin(), line.end());
  return line;
}

/// The least cost of all ways through the table of directions, by trying them.
double least_cost(const Samples& drawn, const Samples& model) {
  constexpr int kSteps = static_cast<int>(kSamples) - 1;
  const auto angle = [](const Samples& s, int k) {
    const auto i = static_cast<std::size_t>(k);
    return std::atan2(static_cast<double>(s.y[i + 1] - s.y[i]), static_cast<double>(s.x[i + 1] - s.x[i]));
  };
  std::vector<std::vector<double>> known(kSteps, std::vector<double>(kSteps, -1));
  const std::function<double(int, int)> to = [&](int i, int j) -> double {
    if (i == -1 && j == -1) return 0;
    if (i < 0 || j < 0 || std::abs(i - j) > 5) return 1e9;
    auto& cost = known[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
    if (cost >= 0) return cost;
    const double difference = 1 - std::cos(angle(drawn, i) - angle(model, j));
    cost = std::min({to(i - 1, j - 1) + difference, to(i - 1, j) + difference / 2 + 0.05,
                     to(i, j - 1) + difference / 2 + 0.05});
    return cost;
  };
  return to(kSteps - 1, kSteps - 1) / kSteps;
}

TEST(Course, OfAStrokeFromItselfIsNone) {
  for (const auto& line : {straight(30), corner(40, 30), circle()}) {
    const auto c = course(sampled(line), sampled(line), false);
    EXPECT_NEAR(c.chord_turn, 0, 1e-3);
    EXPECT_NEAR(c.along, 0, 1e-5);
  }
}

TEST(Course, OfATurnedStraightLineIsTheTurn) {
  for (const double degrees : {-120.0, -40.0, 25.0, 90.0, 175.0}) {
    const auto c = course(sampled(straight(20 + degrees, 30)), sampled(straight(20, 60)), false);
    const double turn = std::abs(degrees) * std::numbers::pi / 180;
    EXPECT_NEAR(c.chord_turn, turn, 1e-3) << degrees;
    EXPECT_NEAR(c.along, 1 - std::cos(turn), 1e-3) << degrees;
  }
}

TEST(Course, OfAReversedStrokeIsTakenInTheDirectionOfTheModel) {
  const auto model = sampled(corner(40, 30));
  const auto drawn = corner(30, 40);
  const auto forward = course(sampled(drawn), model, false);
  const auto back = course(sampled(backwards(drawn)), model, true);
  EXPECT_NEAR(back.chord_turn, forward.chord_turn, 1e-3);
  EXPECT_NEAR(back.along, forward.along, 1e-3);
  EXPECT_GT(course(sampled(backwards(drawn)), model, false).along, 1);
}

TEST(Course, TheChordCountsByTheStraightnessOfTheLessStraight) {
  // A corner of equal legs: its chord lies at 45 degrees and is 1 / sqrt 2 of its length.
  const double counted = std::numbers::pi / 4 / std::numbers::sqrt2;
  EXPECT_NEAR(course(sampled(straight(0)), sampled(corner(30, 30)), false).chord_turn, counted, 0.02);
  EXPECT_NEAR(course(sampled(corner(30, 30)), sampled(straight(0)), false).chord_turn, counted, 0.02);
  EXPECT_NEAR(course(sampled(circle()), sampled(straight(0)), false).chord_turn, 0, 1e-3);
}

TEST(Course, ACornerALittleEarlierIsHardlyADifference) {
  const auto model = sampled(corner(40, 30));
  const auto drawn = sampled(corner(32, 38));
  double step_by_step = 0;
  for (std::size_t k = 0; k + 1 < kSamples; ++k) {
    const auto direction = [k](const Samples& s) {
      return std::atan2(static_cast<double>(s.y[k + 1] - s.y[k]), static_cast<double>(s.x[k + 1] - s.x[k]));
    };
    step_by_step += (1 - std::cos(direction(drawn) - direction(model))) / 23;
  }
  EXPECT_LT(course(drawn, model, false).along, 0.25 * step_by_step);
  EXPECT_GT(course(sampled(corner(8, 62)), model, false).along, 0.15) << "too far to be aligned";
  EXPECT_GT(course(drawn, model, false).along, 0.005) << "yet a shift is not free";
}

TEST(Course, IsTheCheapestOfAllWays) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> anywhere(10, 100);
  for (int n = 0; n < 60; ++n) {
    Line a;
    Line b;
    for (int k = 0; k < 4; ++k) {
      a.emplace_back(anywhere(random), anywhere(random));
      b.emplace_back(a.back().first + 0.3 * (anywhere(random) - 55),
                     a.back().second + 0.3 * (anywhere(random) - 55));
    }
    EXPECT_NEAR(course(sampled(a), sampled(b), false).along, least_cost(sampled(a), sampled(b)), 1e-4);
  }
}

TEST(Course, OfAPointIsFinite) {
  const auto point = sampled({{30, 30}, {30, 30}});
  for (const auto& c : {course(point, sampled(straight(0)), false), course(sampled(straight(0)), point, true),
                        course(point, point, false)}) {
    EXPECT_EQ(c.chord_turn, 0);
    EXPECT_NEAR(c.along, 1, 1e-3) << "a point goes nowhere";
  }
}

}  // namespace
}  // namespace nazori::writing::test
