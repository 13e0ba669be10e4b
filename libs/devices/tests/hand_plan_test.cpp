// SPDX-License-Identifier: Apache-2.0
#include "../src/hand_plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace nazori::devices {
namespace {

using haptics::StrokePath;
using haptics::Vec3;

constexpr double kMm = 0.001;

/// A stroke 40 mm to the right and, with a corner, 20 mm down, 8 mm deep.
StrokePath corner() {
  StrokePath path;
  for (int i = 0; i <= 80; ++i) path.points.push_back({-0.02 + i * 0.0005, 0, -0.008});
  for (int i = 1; i <= 40; ++i) path.points.push_back({0.02, -i * 0.0005, -0.008});
  return path;
}

double off_line_m(const Vec3& p) { return std::min(std::abs(p.y), std::abs(p.x - 0.02)); }

TEST(HandPlan, BeginsAndEndsAboveThePlateau) {
  const HandPlan plan(std::vector{corner()}, HandHabits{});
  for (const double t : {0.0, plan.duration_s(), -1.0, plan.duration_s() + 1}) {
    EXPECT_GT(plan.at(t).target_m.z, 5 * kMm) << t;
    EXPECT_EQ(plan.at(t).stroke, 0) << t;
  }
}

TEST(HandPlan, WithoutStrokesTheHandRests) {
  const HandPlan plan({}, HandHabits{});
  EXPECT_EQ(plan.duration_s(), 0);
  EXPECT_EQ(plan.at(0).next, 0);
}

TEST(HandPlan, MeasuresLengthFromAbove) {
  EXPECT_NEAR(HandPlan(std::vector{corner()}, HandHabits{}).length_m(1), 60 * kMm, 1e-12);
}

TEST(HandPlan, AimsNearTheLineBelowTheFloorOfTheGroove) {
  const HandHabits habits;
  const HandPlan plan(std::vector{corner()}, habits);
  int following = 0;
  double squared = 0;
  for (double t = 0; t < plan.duration_s(); t += 0.001) {
    const HandIntent intent = plan.at(t);
    if (intent.stroke == 0) continue;
    ++following;
    squared += std::pow(off_line_m(intent.target_m), 2);
    EXPECT_LT(off_line_m(intent.target_m), 3 * habits.wander_m) << t;
    EXPECT_NEAR(intent.target_m.z, -0.008 - habits.press_m, 1e-12) << t;
    EXPECT_LT(off_line_m(intent.line_m), 1e-12) << t;
  }
  EXPECT_NEAR(following * 0.001, plan.following_s(1), 0.003);
  EXPECT_GT(std::sqrt(squared / following), 0.2 * habits.wander_m);
}

TEST(HandPlan, HaltsAtASharpTurn) {
  const HandPlan plan(std::vector{corner()}, HandHabits{});
  const double step_s = 0.001;
  int still_at_corner = 0;
  int movements = 0;
  for (double t = 0; t + step_s < plan.duration_s(); t += step_s) {
    const HandIntent now = plan.at(t);
    const HandIntent next = plan.at(t + step_s);
    if (now.stroke == 0 || next.stroke == 0) continue;
    movements = next.movement + 1;
    const double moved = std::hypot(next.line_m.x - now.line_m.x, next.line_m.y - now.line_m.y);
    if (moved < 1e-9 && std::hypot(now.line_m.x - 0.02, now.line_m.y) < 1e-6) ++still_at_corner;
    // Never faster than twice the usual pace, and never a jump.
    EXPECT_LT(moved, 0.1 * step_s) << t;
  }
  EXPECT_EQ(movements, 2);
  EXPECT_GT(still_at_corner, 100);
}

TEST(HandPlan, TheTargetNeverJumps) {
  const HandPlan plan(std::vector{corner(), corner()}, HandHabits{});
  Vec3 before = plan.at(0).target_m;
  for (double t = 0.001; t < plan.duration_s(); t += 0.001) {
    const Vec3 now = plan.at(t).target_m;
    // The hand turns with the line at a corner: there its deviation changes side.
    EXPECT_LT(std::hypot(now.x - before.x, now.y - before.y, now.z - before.z), 3 * kMm) << t;
    before = now;
  }
}

TEST(HandPlan, LiftsWhereTheGrooveRises) {
  StrokePath sweep;
  for (int i = 0; i <= 80; ++i) sweep.points.push_back({-0.02 + i * 0.0005, 0, -0.01 * (1 - i / 80.0)});
  const HandHabits habits;
  const HandPlan plan(std::vector{sweep}, habits);
  double last_press = 0;
  for (double t = 0; t < plan.duration_s(); t += 0.001) {
    const HandIntent intent = plan.at(t);
    if (intent.stroke == 1) last_press = intent.line_m.z - intent.target_m.z;
  }
  EXPECT_GT(last_press, 0);
  EXPECT_LT(last_press, 0.5 * habits.press_m);
}

TEST(HandPlan, ADotIsFollowedToo) {
  const HandPlan plan(std::vector{StrokePath{{{0.01, 0.01, -0.005}}}, StrokePath{}}, HandHabits{});
  EXPECT_EQ(plan.length_m(1), 0);
  EXPECT_GT(plan.following_s(1), 0.1);
  for (double t = 0; t < plan.duration_s(); t += 0.01) {
    const Vec3 target = plan.at(t).target_m;
    EXPECT_TRUE(std::isfinite(target.x) && std::isfinite(target.y) && std::isfinite(target.z)) << t;
  }
}

}  // namespace
}  // namespace nazori::devices
