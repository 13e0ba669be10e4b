// SPDX-License-Identifier: Apache-2.0
#include "../src/guidance_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace nazori::haptics {
namespace {

constexpr double kSpeed = 0.1;

GuidancePlan plan_of(std::vector<Vec3> points, double speed_m_s = kSpeed) {
  return {std::vector<StrokePath>{{std::move(points)}}, speed_m_s};
}

TEST(GuidancePlan, OnAStraightTheTeacherGainsAndLosesSpeedEvenly) {
  const GuidancePlan plan = plan_of({{0, 0, 0}, {0.06, 0, 0}});
  EXPECT_DOUBLE_EQ(plan.length_m(1), 0.06);
  for (int mm = 0; mm <= 60; ++mm) {
    const double from_end = 0.001 * std::min(mm, 60 - mm);
    const double squared = std::min(kSpeed * kSpeed, std::pow(0.25 * kSpeed, 2) + 2 * 0.25 * from_end);
    EXPECT_NEAR(plan.speed_m_s(1, 0.001 * mm), std::sqrt(squared), 1e-6) << mm << " mm";
  }
  const double between = (plan.speed_m_s(1, 0.002) + plan.speed_m_s(1, 0.003)) / 2;
  EXPECT_NEAR(plan.speed_m_s(1, 0.0025), between, 1e-6);
  EXPECT_EQ(plan.speed_m_s(1, -1), plan.speed_m_s(1, 0));
  EXPECT_EQ(plan.speed_m_s(1, 1), plan.speed_m_s(1, 0.06));
}

TEST(GuidancePlan, OnAnArcTheSpeedIsThatOfTheTwoThirdsPowerLaw) {
  for (const double radius : {0.01, 0.03, 0.002}) {
    std::vector<Vec3> arc;
    for (int i = 0; i <= 4000; ++i) {
      const double turn = 1.5 * std::numbers::pi * i / 4000;
      arc.emplace_back(radius * std::cos(turn), radius * std::sin(turn), 0);
    }
    // So slow that its acceleration does not matter in the middle.
    const GuidancePlan plan = plan_of(arc, 0.02);
    const double expected = 0.02 * std::cbrt(radius / (radius + 0.01));
    EXPECT_NEAR(plan.speed_m_s(1, plan.length_m(1) / 2), expected, 1e-3 * expected) << radius;
  }
}

TEST(GuidancePlan, ACornerIsAsSharpAsAMillimetreAndAHalfBeforeAndBehindItSay) {
  const GuidancePlan plan = plan_of({{0, 0, 0}, {0.02, 0, 0}, {0.02, 0.02, 0}}, 0.02);
  const double radius = 0.0015 / (std::numbers::pi / 2);
  EXPECT_NEAR(plan.speed_m_s(1, 0.02), 0.02 * std::cbrt(radius / (radius + 0.01)), 1e-6);
  EXPECT_NEAR(plan.speed_m_s(1, 0.017), 0.02, 1e-6) << "3 mm before it is straight";
}

TEST(GuidancePlan, StrokesOfTwoHundredMetresHaveASpeedEveryTwoMillimetres) {
  const GuidancePlan plan = plan_of({{50, 0, 0}, {150, 0, 0}, {250, 0, 0}});
  const auto speed = [&](double s) { return std::sqrt(std::pow(0.25 * kSpeed, 2) + 2 * 0.25 * s); };
  EXPECT_NEAR(plan.speed_m_s(1, 0.002), speed(0.002), 1e-6);
  EXPECT_NEAR(plan.speed_m_s(1, 0.001), (speed(0) + speed(0.002)) / 2, 1e-6);
  EXPECT_NEAR(plan.speed_m_s(1, 0.003), (speed(0.002) + speed(0.004)) / 2, 1e-6);
}

TEST(GuidancePlan, DepthsFollowTheGrooveAndEndAtThePlateau) {
  const GuidancePlan plan = plan_of({{0, 0, 0.002}, {0.01, 0, -0.004}, {0.02, 0, -0.008}});
  const auto depth = [&](double arc_m) { return plan.depth_m(plan.lines().at_length(1, arc_m)); };
  EXPECT_DOUBLE_EQ(depth(0), 0) << "a line above the plateau is drawn on it";
  EXPECT_NEAR(depth(0.005), -0.002, 1e-15);
  EXPECT_NEAR(depth(0.01), -0.004, 1e-15);
  EXPECT_NEAR(depth(0.0125), -0.005, 1e-15);
  EXPECT_NEAR(depth(0.02), -0.008, 1e-15);
}

TEST(GuidancePlan, LengthsAreThoseSeenFromAboveAndPointsAboveEachOtherAreOne) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const GuidancePlan plan = plan_of({{0, 0, 0},
                                     {0, 0, -0.005},
                                     {nan, 0, 0},
                                     {0, inf, 0},
                                     {0, 0, nan},
                                     {0.003, 0.004, -0.008},
                                     {0.003, 0.004 + 5e-8, -0.002},
                                     {0.003, 0.009, -0.008}});
  EXPECT_NEAR(plan.length_m(1), 0.01, 1e-12);
  EXPECT_EQ(plan.lines().at_length(1, 0.01).segment, 1) << "two segments";
  EXPECT_NEAR(plan.depth_m(plan.lines().at_length(1, 0.0025)), -0.004, 1e-12) << "from 0 to -0.008";
  EXPECT_NEAR(plan.depth_m(plan.lines().at_length(1, 0.0075)), -0.008, 1e-12);
}

TEST(GuidancePlan, StrokesWithoutPointsAreCountedAndPassedOver) {
  const StrokePath line{{{0, 0, 0}, {0.01, 0, 0}}};
  const GuidancePlan plan(std::vector<StrokePath>{{}, line, {}, line}, kSpeed);
  EXPECT_EQ(plan.strokes(), 4);
  for (const auto& [from, first] :
       std::vector<std::pair<int, int>>{{-5, 2}, {0, 2}, {1, 2}, {2, 2}, {3, 4}, {4, 4}, {5, 0}})
    EXPECT_EQ(plan.stroke_from(from), first) << from;
  EXPECT_EQ(plan.length_m(1), 0);
  EXPECT_EQ(plan.length_m(3), 0);
  EXPECT_EQ(GuidancePlan().stroke_from(1), 0);
}

TEST(GuidancePlan, AfterADotTheDepthsOfTheNextStrokeAreStillItsOwn) {
  const GuidancePlan plan(
      std::vector<StrokePath>{{{{0, 0, -0.003}}}, {{{0, 0.01, -0.006}, {0.01, 0.01, -0.006}}}}, kSpeed);
  EXPECT_EQ(plan.length_m(1), 0);
  EXPECT_EQ(plan.depth_m(plan.lines().at_length(1, 0)), -0.003);
  EXPECT_EQ(plan.depth_m(plan.lines().at_length(2, 0.005)), -0.006);
  EXPECT_NEAR(plan.speed_m_s(1, 0), 0.25 * kSpeed, 1e-9);
}

}  // namespace
}  // namespace nazori::haptics
