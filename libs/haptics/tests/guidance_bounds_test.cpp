// SPDX-License-Identifier: Apache-2.0
// Where a lesson changes its mind: each bound from both sides.
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <tuple>
#include <utility>

#include "guidance_tip.h"

namespace nazori::haptics {
namespace {

using test::kDepth_m;
using test::kLength_m;
using test::line_of;
using test::Tip;

constexpr Vec3 kAbove{0, 0, 0.005};

TEST(GuidanceBounds, TheTipIsDownInContactOrAQuarterMillimetreDeep) {
  for (const auto& [z, touching, down] : {std::tuple{0.0003, true, true},
                                          {-0.00026, false, true},
                                          {-0.00024, false, false},
                                          {0.004, false, false}}) {
    Tip tip(GuidingMode::lesson);
    tip.at(kAbove, Vec3(0), false);
    tip.at({0, 0, z}, Vec3(0), touching);
    EXPECT_EQ(tip.guidance.writing(), down) << z;
  }
}

TEST(GuidanceBounds, TheTipIsUpHalfAMillimetreAboveThePlateau) {
  for (const double z : {0.00049, 0.00051}) {
    Tip tip(GuidingMode::lesson);
    tip.write(0, 0.02);
    tip.at({0.02, 0, z}, Vec3(0), false);
    EXPECT_EQ(tip.guidance.writing(), z < 0.0005);
  }
}

TEST(GuidanceBounds, AStrokeBeginsWithinFourMillimetresOfItsStart) {
  for (const double away : {0.0039, 0.0041}) {
    Tip tip(GuidingMode::lesson);
    tip.at({-away, 0, 0.005}, Vec3(0), false);
    tip.at({-away, 0, -kDepth_m});
    EXPECT_EQ(tip.guidance.writing(), away < 0.004);
    EXPECT_FALSE(tip.saw(ServoEvent::wrong_start)) << "farther off it is on no stroke at all";
  }
  EXPECT_DOUBLE_EQ(Guidance::start_reach_m(0.0075), 0.003) << "two fifths of a short stroke";
  EXPECT_DOUBLE_EQ(Guidance::start_reach_m(0.001), 0.002) << "and two millimetres at least";
}

TEST(GuidanceBounds, WithinFourMillimetresOfAWrongPlaceIsAWrongStart) {
  for (const double away : {0.0039, 0.0041}) {
    Tip tip(GuidingMode::lesson);
    tip.at({0.03, away, 0.005}, Vec3(0), false);
    tip.at({0.03, away, -kDepth_m});
    EXPECT_EQ(tip.saw(ServoEvent::wrong_start), away < 0.004);
    EXPECT_FALSE(tip.guidance.writing());
    tip.at({0.03, away, -kDepth_m});
    EXPECT_FALSE(tip.saw(ServoEvent::wrong_start)) << "told once";
  }
}

TEST(GuidanceBounds, WhoCameDownBesideTheStartMaySlideToIt) {
  Tip tip(GuidingMode::lesson);
  tip.at({0.03, 0, 0.005}, Vec3(0), false);
  tip.at({0.03, 0, -kDepth_m});
  ASSERT_TRUE(tip.saw(ServoEvent::wrong_start));
  for (double x = 0.03; x > 0.0041; x -= 5e-5) tip.at({x, 0, -kDepth_m});
  EXPECT_FALSE(tip.guidance.writing());
  tip.at({0.0039, 0, -kDepth_m});
  EXPECT_TRUE(tip.guidance.writing());
}

TEST(GuidanceBounds, ABrokenOffStrokeGoesOnWhereItWasOrBeginsAgain) {
  for (const double from : {0.0195, 0.0}) {
    Tip tip(GuidingMode::lesson);
    tip.write(0, 0.02);
    tip.at({0.02, 0, 0.005}, Vec3(0), false);
    ASSERT_FALSE(tip.guidance.writing());
    EXPECT_NEAR(tip.guidance.progress_m(), 0.02, 1e-9);
    tip.at({from, 0, 0.005}, Vec3(0), false);
    tip.at({from, 0, -kDepth_m});
    EXPECT_TRUE(tip.guidance.writing());
    EXPECT_NEAR(tip.guidance.progress_m(), from > 0 ? 0.02 : 0, 1e-9);
  }
}

TEST(GuidanceBounds, SevenMillimetresBesideTheLineTheStrokeIsLeft) {
  for (const double away : {0.0069, 0.0071}) {
    Tip tip(GuidingMode::lesson);
    tip.write(0, 0.02);
    tip.at({0.02, away, -kDepth_m});
    EXPECT_EQ(tip.guidance.writing(), away < 0.007);
    EXPECT_NEAR(tip.guidance.off_m(), away < 0.007 ? away : 0, 1e-12);
    EXPECT_FALSE(tip.saw(ServoEvent::resisted)) << "nobody leads";
  }
}

TEST(GuidanceBounds, WhoIsLedAndLeavesTheStrokeStopsTheTeacher) {
  for (const bool lifted : {true, false})
    for (const double strength : {1.0, 0.0}) {
      Tip tip(GuidingMode::lead);
      tip.settings.strength = strength;
      tip.write(0, 0.02);
      tip.at({0.02, lifted ? 0 : 0.008, lifted ? 0.005 : -kDepth_m}, Vec3(0), !lifted);
      EXPECT_FALSE(tip.guidance.writing());
      EXPECT_EQ(tip.saw(ServoEvent::resisted), strength > 0);
    }
}

TEST(GuidanceBounds, ThreeMillimetresBackIsTheWrongDirectionOnceUntilOneIsLeft) {
  Tip tip(GuidingMode::lesson);
  tip.write(0, 0.03);
  const auto back = [&](double way) {
    tip.at({0.03 - way, 0, -kDepth_m});
    return tip.saw(ServoEvent::wrong_direction);
  };
  EXPECT_FALSE(back(0.0029));
  EXPECT_TRUE(back(0.0031));
  EXPECT_FALSE(back(0.004));
  EXPECT_FALSE(back(0.0011));
  EXPECT_FALSE(back(0.0031)) << "it never came forwards again";
  EXPECT_FALSE(back(0.0009));
  EXPECT_TRUE(back(0.0031));
}

TEST(GuidanceBounds, AStrokeIsDoneAMillimetreAndAHalfOrATenthBeforeItsEnd) {
  for (const auto& [length, before] : {std::pair{kLength_m, 0.0015}, {0.01, 0.001}}) {
    Tip tip(GuidingMode::lesson, line_of(length));
    tip.write(0, length - before - 1e-4);
    EXPECT_TRUE(tip.guidance.writing());
    tip.at({length - before + 1e-4, 0, -kDepth_m});
    EXPECT_FALSE(tip.guidance.writing());
    EXPECT_TRUE(tip.saw(ServoEvent::stroke_done));
    EXPECT_TRUE(tip.saw(ServoEvent::lesson_done));
    EXPECT_EQ(tip.guidance.done_stroke(), 1);
    EXPECT_EQ(tip.guidance.stroke(), 0);
  }
}

TEST(GuidanceBounds, LiftedAStrokeIsDoneFiveMillimetresOrAQuarterBeforeItsEnd) {
  enum class How { lifted, lost_lifted, lost };
  for (const auto& [length, before] : {std::pair{kLength_m, 0.005}, {0.012, 0.003}})
    for (const double short_of : {1e-4, -1e-4})
      for (const How how : {How::lifted, How::lost_lifted, How::lost}) {
        Tip tip(GuidingMode::lesson, line_of(length));
        const double x = length - before - short_of;
        tip.write(0, x);
        ASSERT_TRUE(tip.guidance.writing());
        if (how == How::lifted)
          tip.at({x, 0, 0.002}, Vec3(0), false);
        else
          tip.guidance.lose(tip.plan, tip.settings, how == How::lost_lifted);
        EXPECT_FALSE(tip.guidance.writing());
        EXPECT_EQ(tip.saw(ServoEvent::stroke_done), short_of < 0 && how != How::lost);
        EXPECT_EQ(tip.guidance.done_stroke(), short_of < 0 && how != How::lost ? 1 : 0);
      }
}

TEST(GuidanceBounds, OnlyTheLastStrokeEndsTheLesson) {
  Tip tip(GuidingMode::lesson);
  tip.write(0, kLength_m);
  EXPECT_TRUE(tip.guidance.stroke() == 2 && tip.guidance.progress_m() == 0);
  tip.at({0, 0.03, 0.005}, Vec3(0), false);
  EXPECT_EQ(tip.guidance.done_stroke(), 0);
  for (double x = 0; x < kLength_m - 0.0016; x += 5e-5) {
    tip.at({x, 0.03, -kDepth_m});
    ASSERT_FALSE(tip.saw(ServoEvent::lesson_done));
  }
  tip.at({kLength_m - 0.0014, 0.03, -kDepth_m});
  EXPECT_TRUE(tip.saw(ServoEvent::lesson_done));
  EXPECT_EQ(tip.guidance.done_stroke(), 2);
}

TEST(GuidanceBounds, ThePullOfAStrokeGrowsOverATenthOfASecond) {
  Tip tip(GuidingMode::lesson);
  tip.at(kAbove, Vec3(0), false);
  tip.settings.cap_n = 0.5;
  for (int tick = 1; tick <= 150; ++tick) {
    // 1 mm beside the line and 2 mm below its depth: it is pulled aside but never up.
    tip.at({0, 0.001, -kDepth_m - 0.002});
    ASSERT_NEAR(tip.guidance.force_n().y, -0.1 * std::min(1.0, tick / 100.0), 1e-9) << tick;
    ASSERT_EQ(tip.guidance.force_n().z, 0);
  }
  for (int tick = 0; tick < 100; ++tick) tip.at({0, 0.001, -kDepth_m + 0.001});
  EXPECT_NEAR(tip.guidance.force_n().z, -0.1, 1e-9);
  for (int tick = 0; tick < 100; ++tick) tip.at({0, 0.001, -kDepth_m + 0.005});
  EXPECT_NEAR(tip.guidance.force_n().z, -0.4 * 0.5, 1e-9) << "two fifths of the cap press down";
  EXPECT_EQ(tip.guidance.guide_m(), Vec3(0, 0, -kDepth_m));
}

TEST(GuidanceBounds, WhoIsLedIsTakenUpAsWellAsDown) {
  for (const double below : {0.001, 0.02, -0.001, -0.02}) {
    Tip tip(GuidingMode::lead);
    tip.settings.cap_n = 0.3;
    tip.at(kAbove, Vec3(0), false);
    for (int tick = 0; tick < 400; ++tick) tip.at({0, 0, -kDepth_m - below}, {0.01, 0, 0});
    // The target waits 3 mm ahead and pulls with the full cap. The sum of both forces stays within the cap.
    const double up = std::clamp(100 * below, -0.4 * 0.3, 0.4 * 0.3);
    EXPECT_NEAR(tip.guidance.force_n().z, up * 0.3 / glm::length(Vec3(0.3, 0, up)), 1e-6);
  }
}

TEST(GuidanceBounds, WhoIsLedAndHardlyMovesForAFifteenHundredthsIsLetGo) {
  for (const double speed : {0.0049, 0.0051}) {
    Tip tip(GuidingMode::lead);
    tip.write(0, 0.02);
    int pulled = 0;
    bool let_go = false;
    for (int tick = 0; tick < 1000 && !let_go; ++tick) {
      tip.at({0.02, 0, -kDepth_m}, {speed, 0, 0});
      let_go = tip.saw(ServoEvent::resisted);
      // Four fifths of the pull of the teacher 8 mm ahead, where it waits.
      if (!let_go && tip.guidance.force_n().x > 0.8 * 0.8) ++pulled;
    }
    EXPECT_EQ(let_go, speed < 0.005);
    if (let_go) {
      EXPECT_NEAR(pulled, 150, 1);
    }
  }
}

TEST(GuidanceBounds, TheTeacherGoesOnWhenTheLearnerCameTwoMillimetresAlong) {
  Tip tip(GuidingMode::lead);
  tip.write(0, 0.02);
  for (int tick = 0; tick < 1000 && !tip.saw(ServoEvent::resisted); ++tick) tip.at({0.02, 0, -kDepth_m});
  ASSERT_TRUE(tip.saw(ServoEvent::resisted));
  tip.at({0.02, 0, -kDepth_m});
  for (int tick = 0; tick < 100; ++tick) tip.at({0.0219, 0, -kDepth_m});
  EXPECT_EQ(tip.guidance.force_n(), Vec3(0));
  tip.at({0.0221, 0, -kDepth_m});
  EXPECT_TRUE(tip.saw(ServoEvent::resumed));
  // It pulls with full force after three tenths of a second.
  for (int tick = 1; tick < 300; ++tick) tip.at({0.0221, 0, -kDepth_m}, {0.01, 0, 0});
  EXPECT_NEAR(tip.guidance.force_n().x, 0.8, 1e-3);
}

TEST(GuidanceBounds, TheLearnerIsCarriedWithinReachOfTheStartAndDownOnIt) {
  const auto smooth = [](double t) { return t * t * (3 - 2 * t); };
  for (const auto& [away, over] :
       {std::pair{0.02, 0.0}, {0.0041, 0.0}, {0.0025, smooth(0.5)}, {0.00325, smooth(0.25)}, {0.0009, 1.0}}) {
    Tip tip(GuidingMode::lesson);
    tip.at({-away, 0, 0.005}, Vec3(0), false);
    EXPECT_EQ(tip.guidance.guide_m().x, 0);
    EXPECT_NEAR(tip.guidance.guide_m().z, 0.005 - over * (0.005 + kDepth_m), 1e-12) << away;
  }
}

TEST(GuidanceBounds, TheLearnerIsCarriedUpFirstAndFreelyAcrossThreeMillimetresUp) {
  for (const auto& [z, freed] : {std::pair{0.0, 0.0}, {0.0015, 0.5}, {0.003, 1.0}, {0.004, 1.0}}) {
    Tip tip(GuidingMode::lesson);
    for (int tick = 0; tick < 600; ++tick) tip.at({-0.009, 0, z}, Vec3(0), false);
    EXPECT_NEAR(tip.guidance.force_n().x, 100 * freed * 0.009, 1e-9) << z;
    EXPECT_NEAR(tip.guidance.force_n().z, 100 * (0.005 - z), 1e-9) << z;
  }
}

TEST(GuidanceBounds, CarryingGrowsOverHalfASecondAndIsDamped) {
  Tip tip(GuidingMode::lesson);
  tip.settings.damping_n_s_m = 1.5;
  for (int tick = 1; tick <= 700; ++tick) {
    tip.at({-0.009, 0, 0.005}, {0.1, 0.2, 0}, false);
    const double gain = std::min(1.0, tick / 500.0);
    ASSERT_NEAR(tip.guidance.force_n().x, gain * (0.9 - 0.15), 1e-9) << tick;
    ASSERT_NEAR(tip.guidance.force_n().y, gain * -0.3, 1e-9) << tick;
  }
}

TEST(GuidanceBounds, WhoHoldsAgainstTheCarryingForFourTenthsIsLetGo) {
  for (const double away : {0.0115, 0.03}) {
    Tip tip(GuidingMode::lesson);
    tip.settings.cap_n = 2.0;  // 1.2 N carry
    int pulled = 0;
    bool let_go = false;
    for (int tick = 0; tick < 3000 && !let_go; ++tick) {
      tip.at({-away, 0, 0.005}, Vec3(0), false);
      let_go = tip.saw(ServoEvent::resisted);
      if (!let_go && glm::length(tip.guidance.force_n()) > 0.8 * 1.2) ++pulled;
    }
    EXPECT_TRUE(let_go) << "1.15 N is over four fifths";
    EXPECT_NEAR(pulled, 400, 1);
  }
  Tip gentle(GuidingMode::lesson);
  for (int tick = 0; tick < 3000; ++tick) {
    gentle.at({-0.0095, 0, 0.005}, Vec3(0), false);
    ASSERT_FALSE(gentle.saw(ServoEvent::resisted)) << "0.95 N is not";
  }
}

TEST(GuidanceBounds, WhoIsCarriedAndDisappearsIsNotPulledAtOnceAfterwards) {
  for (const bool pulled : {true, false}) {
    Tip tip(GuidingMode::lesson);
    if (!pulled) tip.settings.strength = 0;
    for (int tick = 0; tick < 100; ++tick) tip.at({-0.02, 0, 0.005}, Vec3(0), false);
    tip.guidance.lose(tip.plan, tip.settings, true);
    EXPECT_EQ(tip.guidance.force_n(), Vec3(0));
    EXPECT_EQ(tip.guidance.granted_j(), 0);
    EXPECT_EQ(tip.saw(ServoEvent::resisted), pulled);
  }
}

TEST(GuidanceBounds, AForceChangesByNoMoreThanATickMay) {
  Tip tip(GuidingMode::lesson);
  tip.settings.stiffness_n_m = 1e5;
  tip.settings.cap_n = 1;
  tip.at(kAbove, Vec3(0), false);
  tip.at({0, 0, -kDepth_m});
  for (int tick = 0; tick < 200; ++tick) tip.at({0, 0.005, -kDepth_m});
  double before = tip.guidance.force_n().y;
  EXPECT_NEAR(before, -1, 1e-9);
  for (int tick = 0; tick < 50; ++tick) {
    tip.at({0, -0.005, -kDepth_m});
    ASSERT_NEAR(tip.guidance.force_n().y - before, 0.04, 1e-9) << tick;
    before = tip.guidance.force_n().y;
  }
  EXPECT_NEAR(before, 1, 1e-9);
}

TEST(GuidanceBounds, CarryingIsGrantedItsForceTimesTheWayUpAcrossAndDown) {
  Tip tip(GuidingMode::lesson);
  const double most = 0.6 * 2;
  const double allowed_j = most * (0.02 + 0.004 + 0.005 + kDepth_m);
  tip.at({-0.02, 0, 0.001}, Vec3(0), false);
  tip.granted_j = 0;
  double most_j = 0;
  // The hand moves back with the force and away again before the force can follow.
  for (int round = 0; round < 400; ++round) {
    for (int i = 0; i <= 50; ++i) tip.at({-0.02 + 0.0002 * i, 0, 0.005}, {0.2, 0, 0}, false);
    most_j = std::max(most_j, tip.granted_j);
    tip.at({-0.02, 0, 0.005}, {0.2, 0, 0}, false);
  }
  EXPECT_LE(most_j, allowed_j + 1e-12);
  EXPECT_GT(most_j, 0.99 * allowed_j);
}

TEST(GuidanceBounds, WhereNothingIsWantedTheTipIsWhereItIsWanted) {
  Tip tip(GuidingMode::lesson, line_of(kLength_m));
  tip.write(0, kLength_m);
  ASSERT_EQ(tip.guidance.stroke(), 0);
  for (const double x : {0.01, 0.02}) {
    tip.at({x, 0, 0.004}, Vec3(0), false);
    EXPECT_EQ(tip.guidance.guide_m(), Vec3(x, 0, 0.004));
  }
  Tip disturbed(GuidingMode::disturb);
  disturbed.write(0, 0.02);
  EXPECT_EQ(disturbed.guidance.guide_m(), Vec3(0.02, 0, -kDepth_m));
}

}  // namespace
}  // namespace nazori::haptics
