// SPDX-License-Identifier: Apache-2.0
#include "../src/hand_corrections.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace nazori::devices {
namespace {

using haptics::Vec3;

// A tick that binary numbers hold exactly, so that sums of ticks are exact.
constexpr double kTick_s = 1.0 / 64;
// The tip lies far off its line, and far from where the hand aims.
constexpr double kAstray_m = 0.004, kFar_m = 0.01;

/// The hand watches the tip for some ticks. @return the last lift.
double watch(HandSight& sight, int ticks, double off_m, double to_target_m = kFar_m, bool following = true) {
  double lift_m = 0;
  for (int i = 0; i < ticks; ++i) lift_m = sight.lift_m(off_m, to_target_m, following, kTick_s);
  return lift_m;
}

TEST(HandSight, LiftsOnceTheTipWasAstrayForMoreThanAFifthOfASecond) {
  HandSight sight;
  EXPECT_EQ(watch(sight, 12, kAstray_m), 0) << "0.1875 s";
  EXPECT_EQ(sight.take_slips(), 0);
  EXPECT_NEAR(watch(sight, 1, kAstray_m), 0.15 * kTick_s, 1e-15) << "0.203 s; the hand lifts at 15 cm/s";
  EXPECT_EQ(sight.take_slips(), 1);
  EXPECT_EQ(sight.take_slips(), 0) << "each slip is counted once";
  EXPECT_NEAR(watch(sight, 5, kAstray_m), 6 * 0.15 * kTick_s, 1e-15);
  EXPECT_EQ(sight.take_slips(), 0);
  EXPECT_NEAR(watch(sight, 64, kAstray_m), 0.022, 1e-15) << "and holds the tip over the plateau";
}

TEST(HandSight, ATipWithinThreeAndAHalfMillimetresIsNotAstray) {
  HandSight sight;
  EXPECT_EQ(watch(sight, 64, 0.0035), 0);
  EXPECT_EQ(sight.take_slips(), 0);
  EXPECT_GT(watch(sight, 13, 0.00351), 0);
}

TEST(HandSight, ComingBackOrNoStrokeToFollowBeginsTheTimeAgain) {
  for (const bool comes_back : {true, false}) {
    HandSight sight;
    (void)watch(sight, 12, kAstray_m);
    (void)watch(sight, 1, comes_back ? 0 : kAstray_m, kFar_m, comes_back);
    EXPECT_EQ(watch(sight, 12, kAstray_m), 0) << comes_back;
    EXPECT_GT(watch(sight, 1, kAstray_m), 0) << comes_back;
  }
}

TEST(HandSight, LowersAsFastAsItLiftedOverTheTargetOrWhereNoStrokeIsFollowed) {
  for (const bool over_target : {true, false}) {
    HandSight sight;
    (void)watch(sight, 64, kAstray_m);
    // Neither near the line nor 1.5 mm from the target: still lifted.
    EXPECT_NEAR(watch(sight, 1, 0, 0.0015), 0.022, 1e-15);
    const double to_target_m = over_target ? 0.00149 : kFar_m;
    EXPECT_NEAR(watch(sight, 1, 0, to_target_m, over_target), 0.022 - 0.15 * kTick_s, 1e-15);
    EXPECT_NEAR(watch(sight, 64, 0, to_target_m, over_target), 0, 1e-15);
    EXPECT_EQ(sight.take_slips(), 1);
  }
}

TEST(HandSight, ASecondSlipIsCountedToo) {
  HandSight sight;
  for (int slip = 0; slip < 2; ++slip) {
    (void)watch(sight, 32, kAstray_m);
    (void)watch(sight, 32, 0, 0);
  }
  EXPECT_EQ(sight.take_slips(), 2);
}

const Vec3 kAlong{0.6, 0.8, 0}, kAcross{-0.8, 0.6, 0};

void expect_near(const Vec3& a, const Vec3& b) { EXPECT_LT(glm::length(a - b), 1e-15) << a.x << " " << a.y; }

TEST(HandPull, GrowsBySixTimesTheErrorEachSecondInBothDirections) {
  HandPull pull;
  const Vec3 wrong = 0.001 * kAlong - 0.0005 * kAcross;
  const double step = 6 * kTick_s;
  expect_near(pull.lead_m(wrong, kAlong, 0, kTick_s), step * wrong);
  expect_near(pull.lead_m(wrong, kAlong, 0, kTick_s), 2 * step * wrong);
  expect_near(pull.lead_m(-wrong, kAlong, 0, kTick_s), step * wrong);
  // What is wrong with the depth is left to the pressing hand.
  expect_near(pull.lead_m(Vec3(0, 0, 1), kAlong, 0, kTick_s), step * wrong);
}

TEST(HandPull, IsAtMostSixMillimetresAheadThreeAsideAndNeverBackwards) {
  HandPull pull;
  const auto after_long = [&](double ahead_m, double aside_m) {
    Vec3 lead{0, 0, 0};
    for (int i = 0; i < 640; ++i)
      lead = pull.lead_m(ahead_m * kAlong + aside_m * kAcross, kAlong, 0, kTick_s);
    return lead;
  };
  expect_near(after_long(0.002, 0.002), 0.006 * kAlong + 0.003 * kAcross);
  expect_near(after_long(-0.002, -0.002), -0.003 * kAcross);
}

TEST(HandPull, RestartsFromZeroWithAnotherMovement) {
  HandPull pull;
  const Vec3 wrong = 0.001 * (kAlong + kAcross);
  for (int i = 0; i < 10; ++i) (void)pull.lead_m(wrong, kAlong, 3, kTick_s);
  expect_near(pull.lead_m(wrong, kAlong, 4, kTick_s), 6 * kTick_s * wrong);
  expect_near(pull.lead_m(wrong, kAlong, 4, kTick_s), 12 * kTick_s * wrong);
}

}  // namespace
}  // namespace nazori::devices
