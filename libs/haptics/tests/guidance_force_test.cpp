// SPDX-License-Identifier: Apache-2.0
// Guidance alone, without a servo around it: its forces and its account, tick by tick, in closed form.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "guidance_tip.h"

namespace nazori::haptics {
namespace {

using test::kDepth_m;
using test::kLength_m;
using test::Tip;

TEST(GuidanceForce, NearTheEndTheTeacherGoesThreeMillimetresBeyondIt) {
  Tip tip(GuidingMode::lead);
  const double x = kLength_m - 0.0025;
  tip.write(0, x);
  ASSERT_TRUE(tip.guidance.writing());
  for (int i = 0; i < 1000; ++i) tip.at({x, 0, -kDepth_m});
  ASSERT_TRUE(tip.guidance.writing()) << "the pull is not so strong that standing still is resisting";
  EXPECT_NEAR(tip.guidance.force_n().x, tip.settings.stiffness_n_m * (0.0025 + 0.003), 1e-6);
}

TEST(GuidanceForce, ADotLeadsNowhere) {
  Tip tip(GuidingMode::lead, GuidancePlan(std::vector<StrokePath>{{{{0.01, 0.01, -kDepth_m}}}}, 0.05));
  tip.at({0.01, 0.01, 0.005}, Vec3(0), false);
  tip.at({0.01, 0.01, -kDepth_m});
  EXPECT_EQ(tip.guidance.force_n(), Vec3(0));
}

TEST(GuidanceForce, WhereNothingPullsNobodyIsLetGoAndNobodyGoesOn) {
  Tip tip(GuidingMode::lead);
  tip.write(0, 0.02);
  for (int i = 0; i < 1000 && !tip.saw(ServoEvent::resisted); ++i) tip.at({0.02, 0, -kDepth_m});
  ASSERT_TRUE(tip.saw(ServoEvent::resisted));
  tip.settings.strength = 0;
  for (const double x : {0.02, 0.023, 0.026}) {
    tip.at({x, 0, -kDepth_m});
    EXPECT_FALSE(tip.saw(ServoEvent::resumed)) << x;
  }
  tip.settings.strength = 1;
  for (const double x : {0.026, 0.0279, 0.0281}) {
    tip.at({x, 0, -kDepth_m});
    EXPECT_EQ(tip.saw(ServoEvent::resumed), x > 0.028) << "two millimetres from where it pulls again";
  }
}

TEST(GuidanceForce, AStrengthThatComesBackGrowsAsAtTheBeginning) {
  Tip tip(GuidingMode::lesson);
  tip.settings.strength = 0;
  for (int i = 0; i < 600; ++i) tip.at({-0.009, 0, 0.005}, Vec3(0), false);
  tip.settings.strength = 1;
  for (int tick = 1; tick <= 20; ++tick) {
    tip.at({-0.009, 0, 0.005}, Vec3(0), false);
    ASSERT_NEAR(tip.guidance.force_n().x, 0.9 * tick / 500, 1e-9) << "100 N/m and 9 mm, in half a second";
  }
}

TEST(GuidanceForce, WhoIsLedAndPullsBackForThirtyMillisecondsIsLetGo) {
  Tip tip(GuidingMode::lead);
  tip.write(0, 0.02);
  // Waits until the teacher is at its largest distance.
  for (int i = 0; i < 100; ++i) tip.at({0.02, 0, -kDepth_m}, {0.01, 0, 0});
  ASSERT_GT(tip.guidance.force_n().x, 0.3 * std::min(tip.settings.cap_n, tip.settings.stiffness_n_m * 0.008));
  int ticks = 0;
  while (!tip.saw(ServoEvent::resisted) && ticks < 200) {
    tip.at({0.02, 0, -kDepth_m}, {-0.021, 0, 0});
    ++ticks;
  }
  EXPECT_GE(ticks, 30);
  EXPECT_LE(ticks, 31);
}

TEST(GuidanceForce, WhoIsLedAndGivesWaySlowlyIsNotLetGo) {
  Tip tip(GuidingMode::lead);
  tip.write(0, 0.02);
  for (int i = 0; i < 140; ++i) {
    tip.at({0.02, 0, -kDepth_m}, {-0.019, 0, 0});
    EXPECT_FALSE(tip.saw(ServoEvent::resisted)) << i;
  }
}

TEST(GuidanceForce, OnlyAgainstAQuarterOfTheFullPullItIsPullingBack) {
  for (const double lag_m : {0.0018, 0.0024}) {
    Tip tip(GuidingMode::lead);
    tip.write(0, 0.001);
    // The pull at this distance behind the teacher. It is full at 8 mm.
    bool let_go = false;
    for (int tick = 0; tick < 400 && !let_go; ++tick) {
      const double x = std::max(0.001, tip.guidance.guide_m().x - lag_m);
      tip.at({x, 0, -kDepth_m}, {tick < 350 ? 0.05 : -0.021, 0, 0});
      let_go = tip.saw(ServoEvent::resisted);
      ASSERT_TRUE(!let_go || tick >= 379);
    }
    EXPECT_EQ(let_go, lag_m > 0.25 * 0.008);
  }
}

TEST(GuidanceForce, LiftedOutOfReachAfterAStrokeTheTipMayComeDownAtOnceOnTheNext) {
  for (const bool lifted : {true, false}) {
    Tip tip(GuidingMode::lesson);
    tip.write(0, kLength_m);
    ASSERT_EQ(tip.guidance.stroke(), 2);
    ASSERT_FALSE(tip.guidance.writing());
    tip.guidance.lose(tip.plan, tip.settings, lifted);
    tip.at({0, 0.03, -kDepth_m});
    EXPECT_EQ(tip.guidance.writing(), lifted) << "a tip that never left the ground has not begun a stroke";
  }
}

TEST(GuidanceForce, ItsWorkIsLeftOutOfTheAccountOnlyUpToWhatAStrokeAllows) {
  Tip tip(GuidingMode::lesson);
  tip.write(0, 0.02);
  tip.granted_j = 0;
  // The hand moves away in one tick, before the force can follow, and slowly back with it: each time it gains
  // work.
  double won_j = 0;
  double y = 0;
  const auto move_to = [&](double to) {
    won_j += tip.guidance.force_n().y * (to - y);
    y = to;
    tip.at({0.02, y, -kDepth_m});
  };
  for (int round = 0; round < 200; ++round) {
    move_to(0.006);
    for (int i = 0; i < 50; ++i) move_to(0.006);
    for (int i = 5; i >= 0; --i) move_to(0.001 * i);
    for (int i = 0; i < 50; ++i) move_to(0);
  }
  const double allowed_j = tip.settings.cap_n * Guidance::kLeave_m;
  ASSERT_GT(won_j, 5 * allowed_j) << "else nothing was tried";
  EXPECT_LE(tip.granted_j, allowed_j + 1e-12);
  EXPECT_GT(tip.granted_j, 0.9 * allowed_j);
}

}  // namespace
}  // namespace nazori::haptics
