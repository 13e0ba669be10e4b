// SPDX-License-Identifier: Apache-2.0
// The steps in which a tuft moves, seen in the times in which its bristles make their ways.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "nazori/brush/tuft.h"
#include "sweep_times.h"

namespace nazori::brush {
namespace {

using Swept = std::vector<geometry::BristleSegment>;

TuftForm form() { return *tuft_form(4); }

HolderPose leaning(double depth, double lean_rad) {
  HolderPose pose;
  pose.depth_m = depth * form().hair_m;
  pose.lean_rad = lean_rad;
  pose.lean_to_rad = 0.4;
  return pose;
}

/// Expects a move of one second to have so many steps, three or more. Two are swept together, but for an odd
/// last one.
void expect_steps(int steps, const HolderPose& from, const std::function<void(HolderPose&)>& change) {
  Tuft tuft(form());
  Swept swept;
  HolderPose above = from;
  above.depth_m = std::min(-0.1 * form().hair_m, from.depth_m);
  tuft.move_to(above, swept);
  tuft.move_to(from, swept);
  swept.clear();
  HolderPose to = from;
  to.time_s += 1;
  change(to);
  tuft.move_to(to, swept);
  // Hair that is dragged aside sweeps in parts, which have other ways.
  const auto found = shares(swept, {2.0 / steps, 1.0 / steps, 2.0 / (steps - 1), 2.0 / (steps + 1)});
  EXPECT_GT(found[0], 0.02) << steps;
  if (steps % 2 == 1) {
    EXPECT_GT(found[1], 0.02) << steps;
  }
  EXPECT_LT(found[2], 0.005) << steps;
  EXPECT_LT(found[3], 0.005) << steps;
}

TEST(TuftSteps, AreAFiftiethOfTheHairAndATwentiethOfARadian) {
  const double hair = form().hair_m;
  const HolderPose upright = leaning(0.2, 0), slanting = leaning(0.2, 0.5);
  expect_steps(3, slanting, [&](HolderPose& to) { to.at.x += 0.059 * hair; });
  expect_steps(4, slanting, [&](HolderPose& to) { to.at.y += 0.061 * hair; });
  expect_steps(5, slanting, [&](HolderPose& to) { to.at = {0.03 * hair, -0.08 * hair}; });
  expect_steps(4, slanting, [&](HolderPose& to) { to.depth_m += 0.07 * hair; });
  expect_steps(3, slanting, [&](HolderPose& to) { to.depth_m -= 0.05 * hair; });
  expect_steps(4, slanting, [&](HolderPose& to) { to.lean_rad += 0.19; });
  expect_steps(3, slanting, [&](HolderPose& to) { to.lean_rad -= 0.14; });
  expect_steps(6, upright, [&](HolderPose& to) { to.twist_rad = 0.29; });
  expect_steps(6, upright, [&](HolderPose& to) { to.twist_rad = -0.29; });
  // The upper end goes as far as the sine of the lean says.
  expect_steps(4, slanting, [&](HolderPose& to) { to.lean_to_rad += 0.4; });
  expect_steps(4, slanting, [&](HolderPose& to) { to.lean_to_rad -= 0.4; });
  // The longest way decides, and a long one has longer steps.
  expect_steps(5, slanting, [&](HolderPose& to) {
    to.at.x += 0.05 * hair;
    to.lean_rad += 0.21;
  });
  expect_steps(32, slanting, [&](HolderPose& to) { to.at.x += 0.9 * hair; });
}

TEST(TuftSteps, OfAComingDownAreCountedFromJustAboveThePaper) {
  const double hair = form().hair_m;
  // From a fiftieth above to 0.15 deep.
  expect_steps(9, leaning(-0.1, 0.5), [&](HolderPose& to) { to.depth_m = 0.15 * hair; });
  expect_steps(8, leaning(-0.01, 0.5), [&](HolderPose& to) { to.depth_m = 0.145 * hair; });
}

TEST(TuftSteps, InTheAirAMoveIsOneStep) {
  Tuft tuft(form());
  Swept swept;
  tuft.move_to(leaning(-0.1, 0.5), swept);
  HolderPose far = leaning(-0.1, 0.5);
  far.at = {0.1, 0.2};
  tuft.move_to(far, swept);
  EXPECT_TRUE(swept.empty());
  EXPECT_EQ(tuft.patch_at(), far.at);
}

TEST(TuftSteps, ALeanOrTwistGoesTheShorterWayRound) {
  const double pi = 3.14159265358979;
  HolderPose from = leaning(0.2, 0.5);
  from.lean_to_rad = pi - 0.1;
  // By 0.3 through pi: three steps, not the 59 of the other way.
  expect_steps(3, from, [&](HolderPose& to) { to.lean_to_rad = -pi + 0.2; });
  HolderPose upright = leaning(0.2, 0);
  upright.twist_rad = -pi + 0.1;
  expect_steps(4, upright, [&](HolderPose& to) { to.twist_rad = pi - 0.09; });
}

TEST(TuftSteps, TimeThatGoesBackIsNone) {
  Tuft tuft(form());
  Swept swept;
  HolderPose pose = leaning(0.2, 0.3);
  pose.time_s = 5;
  tuft.move_to(pose, swept);
  swept.clear();
  pose.time_s = 4;
  pose.at.x += 0.001;
  tuft.move_to(pose, swept);
  ASSERT_FALSE(swept.empty());
  for (const auto& s : swept) EXPECT_EQ(s.speed_m_s, 0);
}

}  // namespace
}  // namespace nazori::brush
