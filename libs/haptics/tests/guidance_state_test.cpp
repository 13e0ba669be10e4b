// SPDX-License-Identifier: Apache-2.0
// What guidance still knows after an interruption, a restart or a stop, and what it must have forgotten.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "guidance_tip.h"

namespace nazori::haptics {
namespace {

using test::kDepth_m;
using test::kLength_m;
using test::kTick_s;
using test::line_of;
using test::Tip;

/// Rests there, down.
void rest(Tip& tip, double x, double y, int ticks, const Vec3& velocity_m_s = Vec3(0)) {
  for (int i = 0; i < ticks; ++i) tip.at({x, y, -kDepth_m}, velocity_m_s);
}
void lift(Tip& tip, double x, double y = 0) { tip.at({x, y, 0.005}, Vec3(0), false); }
void wrong_start(Tip& tip) {
  lift(tip, 0.03);
  tip.at({0.03, 0, -kDepth_m});
  ASSERT_TRUE(tip.saw(ServoEvent::wrong_start));
}
/// Stands still, led, until the teacher gives up.
void resist(Tip& tip, double x) {
  for (int i = 0; i < 3000 && !tip.saw(ServoEvent::resisted); ++i) tip.at({x, 0, -kDepth_m});
  ASSERT_TRUE(tip.saw(ServoEvent::resisted));
}

TEST(GuidanceState, AnotherAttemptMayBeginWithTheTipDown) {
  Tip tip(GuidingMode::lesson, line_of(kLength_m));
  tip.write(0, kLength_m);
  ASSERT_EQ(tip.guidance.stroke(), 0);
  tip.guidance.begin(tip.plan, 1, Disturbance());
  tip.at({0, 0, -kDepth_m});
  EXPECT_TRUE(tip.guidance.writing()) << "the lift after the last stroke is no longer waited for";
}

// Carried with 0.6 of the cap, 1.2 N; a tip in a wrong place is pushed up by the soft wall, 1.0 N at 10 mm.
TEST(GuidanceState, AWrongPlaceIsForgottenByAnotherAttemptAndByTheRightStart) {
  Tip tip(GuidingMode::lesson);
  wrong_start(tip);
  rest(tip, 0.03, 0, 700);
  EXPECT_NEAR(tip.guidance.force_n().z, 1.0, 1e-9);
  tip.guidance.begin(tip.plan, 1, Disturbance());
  rest(tip, 0.03, 0, 700, {0, 0, 0.1});
  EXPECT_NEAR(tip.guidance.force_n().z, 1.2, 1e-9);

  Tip slid(GuidingMode::lesson);
  wrong_start(slid);
  rest(slid, 0.001, 0, 10);
  ASSERT_TRUE(slid.guidance.writing());
  rest(slid, 0.001, 0.02, 700, {0, 0, 0.1});
  ASSERT_FALSE(slid.guidance.writing());
  EXPECT_NEAR(slid.guidance.force_n().z, 1.2, 1e-9);
}

TEST(GuidanceState, ATipThatIsLostInAWrongPlaceIsLeftAlone) {
  Tip tip(GuidingMode::lesson);
  wrong_start(tip);
  rest(tip, 0.03, 0, 100);
  tip.guidance.lose(tip.plan, tip.settings, false);
  EXPECT_TRUE(tip.saw(ServoEvent::resisted));
  rest(tip, 0.03, 0, 100);
  EXPECT_EQ(tip.guidance.force_n(), Vec3(0));
}

TEST(GuidanceState, WhoAppearsInAWrongPlaceDidNotComeDownThere) {
  Tip tip(GuidingMode::lesson);
  lift(tip, 0.03);
  tip.guidance.lose(tip.plan, tip.settings, true);
  tip.at({0.03, 0, -kDepth_m});
  EXPECT_FALSE(tip.saw(ServoEvent::wrong_start));
}

TEST(GuidanceState, AnotherAttemptCarriesThoughTheLastOneWasStopped) {
  Tip tip(GuidingMode::lead);
  tip.write(0, 0.02);
  resist(tip, 0.02);
  tip.guidance.begin(tip.plan, 1, Disturbance());
  for (int i = 0; i < 100; ++i) lift(tip, -0.02);
  EXPECT_GT(tip.guidance.force_n().x, 0.1);
  EXPECT_FALSE(tip.saw(ServoEvent::resumed));
}

TEST(GuidanceState, WhoComesDownAgainIsLedAgainAndIsToldSo) {
  Tip tip(GuidingMode::lead);
  tip.write(0, 0.02);
  lift(tip, 0.02);
  ASSERT_TRUE(tip.saw(ServoEvent::resisted));
  tip.at({0.02, 0, -kDepth_m});
  EXPECT_TRUE(tip.guidance.writing());
  EXPECT_TRUE(tip.saw(ServoEvent::resumed));
  rest(tip, 0.02, 0, 300, {0.01, 0, 0});
  EXPECT_GT(tip.guidance.force_n().x, 0.2);
}

TEST(GuidanceState, ATeacherThatHasStoppedDoesNotStopASecondTime) {
  for (const bool lost : {false, true}) {
    Tip tip(GuidingMode::lead);
    tip.write(0, 0.02);
    resist(tip, 0.02);
    if (lost)
      tip.guidance.lose(tip.plan, tip.settings, false);
    else
      lift(tip, 0.02);
    EXPECT_FALSE(tip.guidance.writing());
    EXPECT_FALSE(tip.saw(ServoEvent::resisted));
  }
}

TEST(GuidanceState, EachStopWaitsForTwoMillimetresOfItsOwn) {
  Tip tip(GuidingMode::lead);
  tip.write(0, 0.02);
  resist(tip, 0.02);
  tip.at({0.02, 0, -kDepth_m});
  tip.at({0.0221, 0, -kDepth_m});
  ASSERT_TRUE(tip.saw(ServoEvent::resumed));
  for (double x = 0.0221; x < 0.03; x += 5e-5) tip.at({x, 0, -kDepth_m}, {0.05, 0, 0});
  resist(tip, 0.03);
  for (const double x : {0.03, 0.0319})
    for (int i = 0; i < 100; ++i) {
      tip.at({x, 0, -kDepth_m});
      ASSERT_FALSE(tip.saw(ServoEvent::resumed)) << i;
    }
  EXPECT_EQ(tip.guidance.force_n(), Vec3(0));
  tip.at({0.0321, 0, -kDepth_m});
  EXPECT_TRUE(tip.saw(ServoEvent::resumed));
}

TEST(GuidanceState, GoingBackIsReportedAgainAfterComingDownAgain) {
  Tip tip(GuidingMode::lesson);
  tip.write(0, 0.03);
  tip.at({0.0269, 0, -kDepth_m});
  ASSERT_TRUE(tip.saw(ServoEvent::wrong_direction));
  lift(tip, 0.03);
  tip.at({0.03, 0, -kDepth_m});
  tip.at({0.0269, 0, -kDepth_m});
  EXPECT_TRUE(tip.saw(ServoEvent::wrong_direction));
}

TEST(GuidanceState, ASecondStrokeMayBeWrittenAgainFromItsStart) {
  Tip tip(GuidingMode::lesson);
  tip.write(0, kLength_m);
  lift(tip, 0, 0.03);
  for (double x = 0; x < 0.02; x += 5e-5) tip.at({x, 0.03, -kDepth_m});
  lift(tip, 0.02, 0.03);
  ASSERT_NEAR(tip.guidance.progress_m(), 0.02, 1e-4);
  lift(tip, 0, 0.03);
  tip.at({0, 0.03, -kDepth_m});
  EXPECT_TRUE(tip.guidance.writing());
  EXPECT_EQ(tip.guidance.progress_m(), 0);
  EXPECT_FALSE(tip.saw(ServoEvent::wrong_start));
}

TEST(GuidanceState, WhatIsLostReportsNothingOfTheTickBefore) {
  Tip tip(GuidingMode::lesson);
  tip.write(0, kLength_m - 0.0016);
  tip.at({kLength_m - 0.0014, 0, -kDepth_m});
  ASSERT_EQ(tip.guidance.done_stroke(), 1);
  tip.guidance.lose(tip.plan, tip.settings, false);
  EXPECT_EQ(tip.guidance.done_stroke(), 0);
  EXPECT_FALSE(tip.saw(ServoEvent::stroke_done));
}

TEST(GuidanceState, WhatIsLostIsGrantedNoWork) {
  Tip tip(GuidingMode::lesson);
  for (int i = 0; i < 300; ++i) lift(tip, -0.02);
  lift(tip, -0.0199);
  ASSERT_GT(tip.guidance.granted_j(), 0);
  tip.guidance.lose(tip.plan, tip.settings, true);
  EXPECT_EQ(tip.guidance.granted_j(), 0);
}

TEST(GuidanceState, AForceThatFadesAfterTheLastStrokeIsNobodysResistance) {
  Tip tip(GuidingMode::lesson, line_of(kLength_m));
  tip.write(0, 0.03);
  rest(tip, 0.03, 0.005, 200);
  for (double x = 0.03; x < kLength_m; x += 5e-4) tip.at({x, 0.005, -kDepth_m});
  tip.at({kLength_m, 0.005, -kDepth_m});
  ASSERT_EQ(tip.guidance.stroke(), 0);
  ASSERT_GT(glm::length(tip.guidance.force_n()), 0.1);
  tip.guidance.lose(tip.plan, tip.settings, true);
  EXPECT_FALSE(tip.saw(ServoEvent::resisted));
}

TEST(GuidanceState, WhoIsNotHelpedAndDisappearsDoesNotResist) {
  Tip tip(GuidingMode::lead);
  tip.settings.strength = 0;
  tip.write(0, 0.02);
  tip.guidance.lose(tip.plan, tip.settings, false);
  EXPECT_FALSE(tip.saw(ServoEvent::resisted));
}

TEST(GuidanceState, ADisturbanceIsGrantedWhatItDoes) {
  Tip tip(GuidingMode::disturb);
  tip.settings.disturbance_n = 1;
  tip.guidance.begin(tip.plan, 1, Disturbance(3, kTick_s));
  tip.write(0, 0.01);
  double total = 0;
  Vec3 at{0.01, 0, -kDepth_m};
  for (int i = 1; i < 400; ++i) {
    const Vec3 force = tip.guidance.force_n();
    const Vec3 step{5e-5, (i % 3 - 1) * 2e-5, 0};
    at += step;
    tip.at(at);
    ASSERT_NEAR(tip.guidance.granted_j(), glm::dot(force, step), 1e-15) << i;
    total += std::abs(tip.guidance.granted_j());
  }
  EXPECT_GT(total, 1e-3);
}

TEST(GuidanceState, TheTeacherSlowsDownInTheLastQuarterOfItsLead) {
  Tip tip(GuidingMode::lead);
  tip.write(0, 0.03);
  double target = tip.guidance.guide_m().x;
  for (int i = 0; i < 400; ++i) {
    tip.at({0.03, 0, -kDepth_m}, {0.05, 0, 0});
    const double lead = (target - 0.03) / 0.008;
    const double step = std::clamp(4 * (1 - lead), 0.0, 1.0) * tip.plan.speed_m_s(1, target) * kTick_s;
    ASSERT_NEAR(tip.guidance.guide_m().x, target + step, 1e-12) << i;
    target = tip.guidance.guide_m().x;
  }
  EXPECT_GT(target, 0.03 + 0.95 * 0.008) << "far enough to have slowed down";
}

// Writing begins with an allowance of 2 N x 7 mm = 14 mJ; each step of the teacher adds to it.
TEST(GuidanceState, ATeacherMayDoTheWorkOfTheWholeWay) {
  Tip tip(GuidingMode::lead);
  tip.write(0, 0.005);
  tip.granted_j = 0;
  double work = 0;
  for (double x = 0.005; x < 0.055; x += 4e-5) {
    work += tip.guidance.force_n().x * 4e-5;
    tip.at({x + 4e-5, 0, -kDepth_m}, {0.04, 0, 0});
  }
  EXPECT_GT(work, 0.02);
  EXPECT_NEAR(tip.granted_j, work, 1e-6);
}

TEST(GuidancePlan, StrokesWithoutPointsArePassedOver) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const StrokePath line{{{0, 0, -0.01}, {0.02, 0, -0.02}}};
  const StrokePath dot{{{0.01, 0.01, -0.004}}};
  const std::vector<StrokePath> strokes{{}, dot, {{{0, 0, nan}, {nan, 0, 0}, {0, nan, 0}}}, line, {}};
  const GuidancePlan plan(strokes, 0.05);
  EXPECT_EQ(plan.strokes(), 5);
  EXPECT_EQ(plan.stroke_from(-3), 2);
  EXPECT_EQ(plan.stroke_from(1), 2);
  EXPECT_EQ(plan.stroke_from(2), 2);
  EXPECT_EQ(plan.stroke_from(3), 4);
  EXPECT_EQ(plan.stroke_from(5), 0);
  EXPECT_EQ(plan.stroke_from(6), 0);
  EXPECT_EQ(plan.depth_m(plan.lines().at_length(2, 0)), -0.004);
  EXPECT_EQ(plan.depth_m(plan.lines().at_length(4, 0)), -0.01);
  EXPECT_NEAR(plan.depth_m(plan.lines().at_length(4, 0.015)), -0.0175, 1e-12);
  EXPECT_EQ(plan.length_m(2), 0);
  EXPECT_NEAR(plan.length_m(4), 0.02, 1e-12);
}

TEST(GuidancePlan, ADepthThatIsNoNumberIsLeftOutAndARidgeIsThePlateau) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<StrokePath> strokes{{{{0, 0, -0.01}, {0.01, 0.005, nan}, {0.02, 0, 0.003}}}};
  const GuidancePlan plan(strokes, 0.05);
  EXPECT_NEAR(plan.length_m(1), 0.02, 1e-12);
  EXPECT_NEAR(plan.depth_m(plan.lines().at_length(1, 0.01)), -0.005, 1e-12);
  EXPECT_EQ(plan.depth_m(plan.lines().at_length(1, 1)), 0);
}

}  // namespace
}  // namespace nazori::haptics
