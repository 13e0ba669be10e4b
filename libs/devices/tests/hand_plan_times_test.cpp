// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>
#include <vector>

#include "../src/hand_plan.h"

namespace nazori::devices {
namespace {

using haptics::StrokePath;
using haptics::Vec3;

// The share of the way after a quarter of the time with minimum jerk: 10 t^3 - 15 t^4 + 6 t^5.
constexpr double kAtAQuarter = 10.0 / 64 - 15.0 / 256 + 6.0 / 1024;
constexpr double kPress_m = 0.006, kHover_m = 0.006, kDepth_m = 0.008;
constexpr double kTravel_s = 0.30, kLower_s = 0.20, kHalt_s = 0.15, kLift_s = 0.15;

/// 5 cm/s, without straying.
HandHabits steady() { return {.speed_m_s = 0.05, .wander_m = 0, .press_m = kPress_m, .hover_m = kHover_m}; }

StrokePath line(std::vector<Vec3> points) {
  StrokePath path;
  path.points = std::move(points);
  return path;
}

/// Two strokes: 40 mm to the right, then 50 mm down from another place.
std::vector<StrokePath> two_strokes() {
  return {line({{-0.02, 0.01, -kDepth_m}, {0.02, 0.01, -kDepth_m}}),
          line({{0.03, 0.03, -kDepth_m}, {0.03, -0.02, -kDepth_m}})};
}
// A movement from rest to rest takes 1.5 times as long as at constant speed.
constexpr double kFirst_s = 1.5 * 0.04 / 0.05 + kHalt_s, kSecond_s = 1.5 * 0.05 / 0.05 + kHalt_s;
constexpr double kSecondBegins_s = kTravel_s + kLower_s + kFirst_s + kLift_s;

void expect_target(const HandPlan& plan, double time_s, const Vec3& target_m) {
  EXPECT_LT(glm::length(plan.at(time_s).target_m - target_m), 1e-12)
      << time_s << ": " << plan.at(time_s).target_m.x << " " << plan.at(time_s).target_m.y << " "
      << plan.at(time_s).target_m.z;
}

TEST(HandPlan, TravelsLowersFollowsHaltsAndLiftsAtItsTimes) {
  const HandPlan plan(two_strokes(), steady());
  EXPECT_NEAR(plan.following_s(1), kFirst_s, 1e-12);
  EXPECT_NEAR(plan.duration_s(), kSecondBegins_s + kTravel_s + kLower_s + kSecond_s + kLift_s, 1e-12);
  const double floor_m = -kDepth_m - kPress_m;
  const Vec3 start{-0.02, 0.01, floor_m}, end{0.02, 0.01, floor_m}, next{0.03, 0.03, floor_m};
  const auto over = [](const Vec3& p) { return Vec3(p.x, p.y, kHover_m); };
  const auto between = [](const Vec3& a, const Vec3& b, double t) { return a + t * (b - a); };

  const Vec3 rest{0, 0, kHover_m};
  expect_target(plan, 0, rest);
  expect_target(plan, kTravel_s / 4, between(rest, over(start), kAtAQuarter));
  double t = kTravel_s;
  expect_target(plan, t, over(start));
  expect_target(plan, t + kLower_s / 4, between(over(start), start, kAtAQuarter));
  t += kLower_s;
  expect_target(plan, t, start);
  expect_target(plan, t + 1.2 / 4, between(start, end, kAtAQuarter));
  expect_target(plan, t + 1.2, end);
  expect_target(plan, t + kFirst_s - 1e-6, end);
  t += kFirst_s;
  expect_target(plan, t + kLift_s / 4, between(end, over(end), kAtAQuarter));
  EXPECT_NEAR(t + kLift_s, kSecondBegins_s, 1e-12);
  expect_target(plan, kSecondBegins_s + kTravel_s / 4, between(over(end), over(next), kAtAQuarter));
  expect_target(plan, plan.duration_s(), {0.03, -0.02, kHover_m});
}

TEST(HandPlan, TellsWhichStrokeItFollowsAndWhichItGoesTo) {
  const HandPlan plan(two_strokes(), steady());
  const auto expect_numbers = [&](double time_s, int stroke, int next) {
    EXPECT_EQ(plan.at(time_s).stroke, stroke) << time_s;
    EXPECT_EQ(plan.at(time_s).next, next) << time_s;
  };
  constexpr double kEps = 1e-6;
  expect_numbers(0, 0, 1);
  expect_numbers(kTravel_s + kLower_s - kEps, 0, 1);
  expect_numbers(kTravel_s + kLower_s + kEps, 1, 1);
  expect_numbers(kTravel_s + kLower_s + kFirst_s - kEps, 1, 1);
  expect_numbers(kTravel_s + kLower_s + kFirst_s + kEps, 0, 1);
  expect_numbers(kSecondBegins_s - kEps, 0, 1);
  expect_numbers(kSecondBegins_s + kEps, 0, 2);
  expect_numbers(kSecondBegins_s + kTravel_s + kLower_s + kEps, 2, 2);
  EXPECT_EQ(plan.at(kSecondBegins_s + 1).movement, 1) << "movements are counted through all strokes";
}

TEST(HandPlan, EvenADotTakesAFifthOfASecond) {
  const HandPlan plan(std::vector{line({{0, 0, -kDepth_m}, {0.001, 0, -kDepth_m}})}, steady());
  EXPECT_NEAR(plan.following_s(1), 0.2 + kHalt_s, 1e-12);
}

/// The halts on two straight legs that meet at an angle.
int halts(double degrees, double first_m = 0.02, double second_m = 0.02) {
  const double turn = degrees * std::numbers::pi / 180;
  HandHabits habits = steady();
  habits.speed_m_s = 1e9;  // so that each movement takes the shortest time
  const HandPlan plan(
      std::vector{line(
          {{0, 0, 0}, {first_m, 0, 0}, {first_m + second_m * std::cos(turn), second_m * std::sin(turn), 0}})},
      habits);
  return static_cast<int>(std::lround(plan.following_s(1) / (0.2 + kHalt_s)));
}

TEST(HandPlan, ATurnOfFiftyDegreesIsSharpToEitherSide) {
  for (const double side : {1.0, -1.0}) {
    EXPECT_EQ(halts(side * 49), 1);
    EXPECT_EQ(halts(side * 51), 2);
    EXPECT_EQ(halts(side * 150), 2);
  }
}

TEST(HandPlan, ATurnWithinOneAndAHalfMillimetresOfAnEndIsNone) {
  EXPECT_EQ(halts(90, 0.00145), 1);
  EXPECT_EQ(halts(90, 0.00155), 2);
  EXPECT_EQ(halts(90, 0.02, 0.00145), 1);
  EXPECT_EQ(halts(90, 0.02, 0.00155), 2);
}

/// Two turns, some way apart: the first to the left, the second to the right. @return the number of each turn
/// at which the hand halts.
std::vector<int> halts_at_two_turns(double apart_m, double first_degrees, double second_degrees) {
  const auto direction = [](double degrees) {
    const double turn = degrees * std::numbers::pi / 180;
    return Vec3(std::cos(turn), std::sin(turn), 0);
  };
  const Vec3 a{0.02, 0, 0}, b = a + apart_m * direction(first_degrees);
  const Vec3 end = b + 0.02 * direction(first_degrees - second_degrees);
  const HandPlan plan(std::vector{line({{0, 0, 0}, a, b, end})}, steady());
  std::vector<int> found;
  HandIntent before = plan.at(kTravel_s + kLower_s);
  for (double t = kTravel_s + kLower_s; t < plan.duration_s() - kLift_s; t += 0.0005) {
    const HandIntent now = plan.at(t);
    if (now.movement != before.movement)
      found.push_back(glm::length(before.line_m - a) < 1e-9   ? 1
                      : glm::length(before.line_m - b) < 1e-9 ? 2
                                                              : 0);
    before = now;
  }
  return found;
}

TEST(HandPlan, TurnsWithinThreeMillimetresAreOneHaltAtTheSharper) {
  EXPECT_EQ(halts_at_two_turns(0.0035, 70, 90), (std::vector{1, 2}));
  EXPECT_EQ(halts_at_two_turns(0.0031, 90, 70), (std::vector{1, 2}));
  EXPECT_EQ(halts_at_two_turns(0.0029, 70, 90), (std::vector{2}));
  EXPECT_EQ(halts_at_two_turns(0.0029, 90, 70), (std::vector{1}));
}

TEST(HandPlan, HeadsAlongTheLineAndAtACornerStillAlongTheLegThatEnds) {
  const HandPlan plan(std::vector{line({{0, 0, -kDepth_m}, {0.04, 0, -kDepth_m}, {0.04, 0.03, -kDepth_m}})},
                      steady());
  const double begin_s = kTravel_s + kLower_s;
  const auto expect_along = [&](double since_s, double x, double y) {
    const HandIntent intent = plan.at(begin_s + since_s);
    EXPECT_NEAR(intent.along.x, x, 1e-9) << since_s;
    EXPECT_NEAR(intent.along.y, y, 1e-9) << since_s;
  };
  expect_along(0.6, 1, 0);
  expect_along(1.2 + kHalt_s / 2, 1, 0);
  EXPECT_NEAR(plan.at(begin_s + 1.2 + kHalt_s / 2).line_m.x, 0.04, 1e-9);
  expect_along(1.2 + kHalt_s + 0.3, 0, 1);
  expect_along(1.2 + kHalt_s + 0.9 + kHalt_s / 2, 0, 1);
}

TEST(HandPlan, ThePressureFallsWithTheDepthToAQuarter) {
  // From the floor up to the plateau.
  const HandPlan rising(std::vector{line({{0, 0, -0.01}, {0.04, 0, 0}})}, steady());
  int seen = 0;
  for (double t = 0; t < rising.duration_s(); t += 0.01) {
    const HandIntent intent = rising.at(t);
    if (intent.stroke == 0) continue;
    ++seen;
    EXPECT_NEAR(intent.line_m.z - intent.target_m.z, kPress_m * (0.25 + 0.75 * intent.line_m.z / -0.01),
                1e-12);
  }
  EXPECT_GT(seen, 100);
  // On a level line there is no depth to lose.
  const HandPlan level(std::vector{line({{0, 0, 0}, {0.04, 0, 0}})}, steady());
  EXPECT_NEAR(level.at(1).target_m.z, -kPress_m, 1e-12);
}

/// How far the hand is to the left of a line along x, at 1 mm/s.
struct SlowHand {
  explicit SlowHand(int number = 1) : stroke(number) {
    HandHabits habits = steady();
    habits.speed_m_s = 0.001;
    habits.wander_m = 0.0008;
    plan = std::make_unique<HandPlan>(
        std::vector(static_cast<std::size_t>(number), line({{0, 0, -kDepth_m}, {0.06, 0, -kDepth_m}})),
        habits);
    begin_s = (number - 1) * (plan->duration_s() / number) + kTravel_s + kLower_s;
  }
  [[nodiscard]] double left_m(double since_s) const { return plan->at(begin_s + since_s).target_m.y; }
  int stroke;
  std::unique_ptr<HandPlan> plan;
  double begin_s = 0;
};

TEST(HandPlan, StraysByTheHabitInThreeSlowWavesAfterTheStart) {
  const SlowHand hand;
  EXPECT_NEAR(hand.left_m(0), 0, 1e-15);
  double squared = 0;
  std::array<double, 3> sine{}, cosine{};
  constexpr std::array<double, 3> kHz{0.9, 1.7, 2.9};
  int count = 0;
  for (double t = 30; t < 60; t += 0.002, ++count) {
    ASSERT_GT(hand.plan->at(hand.begin_s + t).line_m.x, 0.005);
    const double left = hand.left_m(t);
    squared += left * left;
    for (std::size_t i = 0; i < kHz.size(); ++i) {
      sine[i] += left * std::sin(2 * std::numbers::pi * kHz[i] * (hand.begin_s + t));
      cosine[i] += left * std::cos(2 * std::numbers::pi * kHz[i] * (hand.begin_s + t));
    }
  }
  EXPECT_NEAR(std::sqrt(squared / count), 0.0008, 0.00002);
  constexpr std::array<double, 3> kWaves{1, 1, 0.8};
  for (std::size_t i = 0; i < kHz.size(); ++i)
    EXPECT_NEAR(2 * std::hypot(sine[i], cosine[i]) / count, 0.0008 * kWaves[i] / std::sqrt(1.32), 0.00002)
        << i;
}

TEST(HandPlan, TheWavesOfAStrokeBeginWhereItsNumberSays) {
  // The figures of the documentation come from this hand: it must stay the same. Angles at the time 0.
  struct Begin {
    int stroke;
    std::array<double, 3> rad;
  };
  for (const auto& [stroke, rad] : {Begin{1, {1.7, 4.91, 7.27}}, Begin{2, {3.4, 8.82, 12.54}}}) {
    const SlowHand hand(stroke);
    for (double t = 30; t < 31; t += 0.013) {
      const double turns = 2 * std::numbers::pi * (hand.begin_s + t);
      const double waves = std::sin(0.9 * turns + rad[0]) + std::sin(1.7 * turns + rad[1]) +
                           0.8 * std::sin(2.9 * turns + rad[2]);
      ASSERT_NEAR(hand.left_m(t), 0.0008 * waves / std::sqrt(1.32), 1e-9) << stroke << " " << t;
    }
  }
}

TEST(HandPlan, StraysLessInTheFirstFiveMillimetresAndToTheLeftOfTheLine) {
  // The same moment of the same stroke, once along x and once along y: the deviation turns with the line.
  HandHabits habits = steady();
  habits.wander_m = 0.001;
  const HandPlan x(std::vector{line({{0, 0, -kDepth_m}, {0.06, 0, -kDepth_m}})}, habits);
  const HandPlan y(std::vector{line({{0, 0, -kDepth_m}, {0, 0.06, -kDepth_m}})}, habits);
  const HandPlan longer(std::vector{line({{-0.02, 0, -kDepth_m}, {0.1, 0, -kDepth_m}})}, habits);
  double most = 0;
  for (double t = kTravel_s + kLower_s; t < x.duration_s() - kLift_s; t += 0.01) {
    const HandIntent to_right = x.at(t), upwards = y.at(t);
    EXPECT_NEAR(to_right.target_m.y, -upwards.target_m.x, 1e-12) << t;
    const double arc_m = to_right.line_m.x;
    // All of the habit from 5 mm on, and a proportional part before.
    const double longer_arc_m = longer.at(t).line_m.x + 0.02;
    const double share = std::min(1.0, arc_m / 0.005), longer_share = std::min(1.0, longer_arc_m / 0.005);
    EXPECT_NEAR(to_right.target_m.y * longer_share, longer.at(t).target_m.y * share, 1e-9) << t;
    most = std::max(most, std::abs(to_right.target_m.y));
  }
  EXPECT_GT(most, 0.001);
}

TEST(HandPlan, EachStrokeStraysInItsOwnWay) {
  const SlowHand first(1), second(2);
  double product = 0, squares = 0;
  for (double t = 30; t < 60; t += 0.01) {
    product += first.left_m(t) * second.left_m(t);
    squares += first.left_m(t) * first.left_m(t);
  }
  EXPECT_LT(std::abs(product), 0.9 * squares);
}

}  // namespace
}  // namespace nazori::devices
