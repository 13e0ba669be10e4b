// SPDX-License-Identifier: Apache-2.0
// What a servo still knows after an interruption, and what it must have forgotten.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <tuple>
#include <utility>

#include "nazori/haptics/sample_ring.h"
#include "nazori/haptics/servo.h"
#include "relief.h"
#include "servo_hand.h"

namespace nazori::haptics {
namespace {

using test::Hand;
using test::kAbove;
using test::plate;
using test::Relief;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr Vec3 kPressed{0, 0, -0.001};
constexpr double kPress_n = 0.8 * 500 * 0.001;  // at kPressed
constexpr double kRamp = 0.001 / 0.3;           // of the force in the first tick after an interruption

const Relief& flat() {
  static const Relief made(64, 0.01, plate);
  return made;
}

std::shared_ptr<HapticScene> damped() {
  auto scene = flat().scene();
  scene->material.damping = 0.4;  // 1 N s/m
  return scene;
}

std::shared_ptr<HapticScene> snapping(const Relief& relief, double y_m, double z_m) {
  auto scene = relief.scene();
  scene->strokes = {{{{-0.04, y_m, z_m}, {0.04, y_m, z_m}}}};
  scene->snapping.enabled = true;
  return scene;
}

std::shared_ptr<HapticScene> brush() {
  auto scene = std::make_shared<HapticScene>();
  scene->soft_tip = std::make_shared<SoftTip>(SoftTip{0.005, {0, 0.1, 0.3, 0.4}});
  return scene;
}

TEST(ServoState, WhoPushedThroughFeelsNothingUntilOutside) {
  Hand hand;
  auto scene = flat().scene();
  scene->material.popthrough = 0.3;  // 0.99 N: 2.5 mm deep
  hand.servo.set_scene(scene);
  hand.rest(kAbove, 400);
  for (double z = 0; z > -0.003; z -= 1e-5) {
    hand.at({0, 0, z});
    ASSERT_EQ(hand.servo.latest().proxy_m.z, z > -0.99 / 400 ? 0 : z) << "at once";
  }
  for (int i = 0; i <= 100; ++i) {
    EXPECT_EQ(hand.at({0, 0, -0.003 + 0.0029 * i / 100}), Vec3(0)) << i;
    EXPECT_FALSE(hand.servo.latest().touching);
  }
  hand.at({0, 0, 0.0001});
  hand.at({0, 0, -0.0001});
  EXPECT_TRUE(hand.servo.latest().touching);
}

TEST(ServoState, WhoPushedThroughAndLiftedMeetsASolidSurface) {
  Hand hand;
  auto scene = flat().scene();
  scene->material.popthrough = 0.3;
  hand.servo.set_scene(scene);
  hand.rest(kAbove, 400);
  hand.go(kAbove, {0, 0, -0.003}, 100);
  ASSERT_FALSE(hand.servo.latest().touching);
  hand.at(kPressed, false);
  hand.at(kPressed);
  EXPECT_TRUE(hand.servo.latest().touching);
  EXPECT_EQ(hand.servo.latest().proxy_m.z, 0);
}

TEST(ServoState, NeitherAnAbsentPenNorAFaultLeavesSpeedBehind) {
  for (const bool fault : {false, true}) {
    Hand hand;
    hand.servo.set_scene(damped());
    hand.rest(kAbove, 400);
    hand.go(kAbove, kPressed, 20);
    if (fault)
      hand.at({kNan, 0, 0});
    else
      hand.at(kPressed, false);
    EXPECT_NEAR(hand.at(kPressed).z, kPress_n * kRamp, 1e-12) << "the spring alone, ramping in";
  }
}

TEST(ServoState, AfterAFaultTheWayFromBeforeItIsNoSpeed) {
  Hand hand;
  hand.servo.set_scene(damped());
  hand.rest(kAbove, 400);
  hand.at({0, 0, kNan});
  EXPECT_NEAR(hand.at(kPressed).z, kPress_n * kRamp, 1e-12);
}

TEST(ServoState, AHandIsAtRestUntilItHasMoved) {
  Hand hand;
  auto scene = damped();
  scene->material.static_friction = scene->material.dynamic_friction =
      0.5;  // so that it damps in each direction
  hand.servo.set_scene(scene);
  const Vec3 force = hand.at(kPressed);
  EXPECT_EQ(force.x, 0);
  EXPECT_EQ(force.y, 0);
  EXPECT_NEAR(force.z, kPress_n * kRamp, 1e-12);
}

TEST(ServoState, ARunThatBeginsAgainIsNeitherLateNorMoving) {
  Hand hand;
  hand.servo.set_scene(damped());
  hand.rest(kAbove, 400);
  hand.go(kAbove, kPressed, 20);
  hand.servo.begin_run();
  hand.time_s += 60;
  EXPECT_NEAR(hand.at(kPressed).z, kPress_n * kRamp, 1e-12);
  EXPECT_FALSE(hand.saw(ServoEvent::fault));
  EXPECT_EQ(hand.servo.timing().late_ticks, 0U);
  EXPECT_LT(hand.servo.timing().max_lateness_s, 1e-9);
}

TEST(ServoState, ADebtOfEnergyIsForgottenWithTheHand) {
  DeviceDescription late;
  late.limits.delay_s = 0.004;
  late.limits.max_damping_n_s_m = 50;
  late.limits.max_slew_n_s = 1e6;
  Hand hand(late);
  hand.servo.set_scene(flat().scene());
  hand.rest(kAbove, 400);
  for (int i = 0; i < 400; ++i) hand.at({0, 0, -0.0006 + 0.0005 * std::sin(0.7 * i)});
  hand.at(kPressed, false);
  EXPECT_NEAR(hand.at({0, 0, -0.0009}).z, 0.9 * kPress_n * kRamp, 1e-12) << "it is not braked";
}

TEST(ServoState, AHandThatIsPulledFromAStrokeAndComesBackIsNotBraked) {
  DeviceDescription device;
  device.limits.max_damping_n_s_m = 50;
  Hand hand(device);
  auto scene = snapping(flat(), 0, 0);
  scene->surface = nullptr;
  hand.servo.set_scene(scene);
  const Vec3 on{0.01, 0, 0}, off{0.01, 0.006, 0};
  hand.rest(on, 400);
  // 100 N/m. The energy that the hand put into the spring may come back whole.
  hand.go(on, off, 300);
  for (int i = 1; i <= 299; ++i) {
    const Vec3 at = off + (on - off) * (i / 300.0);
    ASSERT_NEAR(hand.at(at).y, -100 * at.y, 1e-9) << i;
  }
}

TEST(ServoState, WhatAHandPutsIntoASpringComesBackWhole) {
  DeviceDescription device;
  device.limits.own_damping_n_s_m = 1;
  device.limits.max_damping_n_s_m = 50;
  for (const bool soft : {false, true}) {
    Hand hand(device);
    hand.servo.set_scene(soft ? brush() : flat().scene());
    hand.rest(kAbove, 400);
    for (int i = 1; i <= 600; ++i) {
      const double depth = 0.001 * (i <= 300 ? i : 600 - i) / 300;
      const Vec3 force = hand.at({0, 0, -depth});
      ASSERT_NEAR(force.z, (soft ? 20 : 400) * depth, 1e-9) << i;
    }
  }
}

TEST(ServoState, AnotherSurfaceUnderAPressedStylusLeavesItInItsPlace) {
  const Relief other(64, 0.01, plate);
  Hand hand;
  const auto rough = [](const Relief& relief) {
    auto scene = relief.scene();
    scene->material.static_friction = scene->material.dynamic_friction = 0.5;
    return scene;
  };
  hand.servo.set_scene(rough(flat()));
  hand.rest({0.01, 0.03, 0.005}, 10);
  hand.go({0.01, 0.03, 0.005}, {0.01, 0.03, -0.001}, 50);
  hand.servo.set_scene(rough(other));
  hand.at({0.01, 0.03, -0.001});
  EXPECT_NEAR(hand.servo.latest().proxy_m.x, 0.01, 1e-9);
  EXPECT_NEAR(hand.servo.latest().proxy_m.y, 0.03, 1e-9);
}

TEST(ServoState, WithoutASceneNothingIsEverDone) {
  Hand hand;
  hand.rest(kAbove, 3);
  EXPECT_EQ(hand.servo.latest().done_stroke, 0);
  EXPECT_EQ(hand.servo.latest().stroke, 0);
  EXPECT_EQ(hand.servo.latest().events, 0);
}

TEST(ServoState, AnAbsentPenIsOnNoStroke) {
  Hand hand;
  auto scene = snapping(flat(), 0, 0);
  hand.servo.set_scene(scene);
  hand.rest({0, 0, 0.001}, 50);
  ASSERT_EQ(hand.servo.latest().stroke, 1);
  hand.at({0, 0, 0.001}, false);
  EXPECT_EQ(hand.servo.latest().stroke, 0);
  EXPECT_TRUE(hand.saw(ServoEvent::release));
}

TEST(ServoState, StrokesOfANewSceneDoNotTakeOverTheOldPull) {
  Hand hand;
  hand.servo.set_scene(snapping(flat(), 0, 0));
  hand.rest({0, 0.001, 0.001}, 200);
  ASSERT_EQ(hand.servo.latest().stroke, 1);
  // The first stroke of the next character is 9 mm away: near enough to capture, once the old pull is gone.
  hand.servo.set_scene(snapping(flat(), 0.009, 0));
  hand.at({0, 0.001, 0.001});
  EXPECT_EQ(hand.servo.latest().stroke, 0);
  EXPECT_TRUE(hand.saw(ServoEvent::release));
  hand.rest({0, 0.001, 0.001}, 200);
  EXPECT_EQ(hand.servo.latest().stroke, 1);
}

TEST(ServoState, TheProxyBeginsWhereThePenAppearsEvenWithFriction) {
  Hand hand;
  auto scene = flat().scene();
  scene->material.static_friction = scene->material.dynamic_friction = 0.5;
  hand.servo.set_scene(scene);
  hand.rest(kAbove, 10);
  hand.go(kAbove, kPressed, 20);
  hand.at({0, 0, -0.001}, false);
  hand.at({0.0003, 0, -0.001});
  EXPECT_NEAR(hand.servo.latest().proxy_m.x, 0.0003, 1e-9) << "friction would hold 0.5 mm";
}

TEST(ServoState, ASoftTipThatDisappearedIsNotStretchedWhenItComesBack) {
  Hand hand;
  hand.servo.set_scene(brush());
  hand.rest(kAbove, 400);
  hand.go({0, 0, -0.006}, {0.001, 0.002, -0.006}, 50);
  ASSERT_GT(std::hypot(hand.servo.latest().force_n.x, hand.servo.latest().force_n.y), 0.005);
  hand.at({0.001, 0.002, -0.006}, false);
  const Vec3 force = hand.at({0.001, 0.002, -0.006});
  EXPECT_EQ(force.x, 0);
  EXPECT_EQ(force.y, 0);
  EXPECT_NEAR(force.z, 0.14 * kRamp, 1e-12);
}

TEST(ServoState, AnotherTipBeginsWithoutStretchAndRampsIn) {
  Hand hand;
  auto scene = brush();
  hand.servo.set_scene(scene);
  hand.rest(kAbove, 400);
  const Vec3 at{0.001, 0.002, -0.006};
  hand.go({0, 0, -0.006}, at, 50);
  const Vec3 before = hand.rest(at, 400);
  hand.servo.set_scene(std::make_shared<HapticScene>(*scene));
  EXPECT_EQ(hand.at(at), before) << "the same tip goes on";
  hand.servo.set_scene(brush());
  const Vec3 force = hand.at(at);
  EXPECT_EQ(force.x, 0);
  EXPECT_EQ(force.y, 0);
  EXPECT_NEAR(force.z, 0.14 * kRamp, 1e-12);
}

TEST(ServoState, AnotherMaterialRampsInOnlyUnderAPressedStylus) {
  const auto with = [](double stiffness, double damping) {
    auto scene = flat().scene();
    scene->material.stiffness = stiffness;
    scene->material.damping = damping;
    return scene;
  };
  for (const auto& [stiffness, damping] : {std::pair{0.4, 0.0}, {0.8, 0.2}}) {
    Hand hand;
    hand.servo.set_scene(with(0.8, 0));
    hand.rest(kAbove, 400);
    hand.go(kAbove, kPressed, 50);
    hand.rest(kPressed, 50);
    hand.servo.set_scene(with(0.8, 0));
    EXPECT_NEAR(hand.at(kPressed).z, kPress_n, 1e-9) << "the same material";
    hand.servo.set_scene(with(stiffness, damping));
    hand.rest(kPressed, 2);  // the force may fall by 0.2 N a tick
    EXPECT_NEAR(hand.at(kPressed).z, 3 * kRamp * 500 * stiffness * 0.001, 1e-9);

    hand.go(kPressed, kAbove, 50);
    hand.rest(kAbove, 400);
    hand.servo.set_scene(with(0.8, 0));
    hand.rest(kAbove, 20);
    hand.at({0, 0, 1e-5});
    EXPECT_NEAR(hand.rest({0, 0, -1e-5}, 5).z, 400 * 1e-5, 1e-9) << "nobody felt the change";
  }
}

TEST(ServoState, AShallowStrokeDoesNotLiftTheTipOffWhatItRunsOver) {
  const Relief deep(64, 0.01, [](double, double) { return -0.008; });
  const Vec3 at{0, 0.002, -0.006};
  for (const bool surface : {true, false}) {
    Hand hand;
    auto scene = snapping(deep, 0, -0.002);
    if (!surface) scene->surface = nullptr;
    hand.servo.set_scene(scene);
    const Vec3 force = hand.rest(at, 500);
    EXPECT_NEAR(force.y, -100 * 0.002, 1e-9);
    EXPECT_NEAR(force.z, surface ? 0 : 100 * 0.004, 1e-9);
  }
  Hand soft;
  auto scene = snapping(deep, 0, -0.002);
  scene->soft_tip = brush()->soft_tip;
  soft.servo.set_scene(scene);
  EXPECT_NEAR(soft.rest(at, 500).z, 0.14, 1e-9) << "the push of the bent tip alone";
}

TEST(ServoState, AFaultyTickStillShowsWhereTheDeviceIs) {
  Hand hand;
  hand.servo.set_scene(flat().scene());
  hand.rest(kAbove, 10);
  hand.time_s += 0.05;
  hand.at({0.01, 0.02, 0.004});
  ASSERT_TRUE(hand.saw(ServoEvent::fault));
  EXPECT_EQ(hand.servo.latest().device_m, Vec3(0.01, 0.02, 0.004));
  hand.at({kNan, 0, 0});
  EXPECT_EQ(hand.servo.latest().device_m, Vec3(0.01, 0.02, 0.004)) << "the newest that is known";
}

TEST(ServoState, ATickIsTooLateAfterFiveMilliseconds) {
  for (const double late : {0.0049, 0.0051}) {
    Hand hand;
    hand.rest(kAbove, 10);
    hand.time_s += late;
    hand.at(kAbove);
    EXPECT_EQ(hand.saw(ServoEvent::fault), late > 0.005);
    // A clock that goes back by less is not a fault.
    hand.time_s -= 0.001 + late;
    hand.at(kAbove);
    EXPECT_EQ(hand.saw(ServoEvent::fault), late > 0.005);
  }
}

TEST(ServoState, FartherThanAHundredMetresNoHandCanBe) {
  for (const Vec3 axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
    for (const double metres : {-101.0, -99.0, 99.0, 101.0}) {
      Hand hand;
      hand.at(metres * axis);
      EXPECT_EQ(hand.saw(ServoEvent::fault), std::abs(metres) > 100);
    }
}

TEST(ServoState, HalfAPeriodIsLateAndAWholeOneIsMissed) {
  // Of lateness in periods: whether it counts, and how many ticks are missing.
  for (const auto& [periods, late, missed] :
       {std::tuple{0.45, 0U, 0U}, {0.55, 1U, 0U}, {0.988, 1U, 0U}, {0.992, 1U, 1U}, {2.5, 1U, 2U}}) {
    Hand hand;
    hand.rest(kAbove, 10);
    hand.time_s += 0.001 * periods;
    hand.at(kAbove);
    EXPECT_EQ(hand.servo.timing().late_ticks, late) << periods;
    EXPECT_EQ(hand.servo.timing().missed_ticks, missed) << periods;
  }
}

TEST(ServoState, ATimeThatIsRepeatedCountsAsOnePeriod) {
  DeviceDescription device;
  device.limits.max_slew_n_s = 1e9;
  Hand hand(device);
  auto scene = damped();
  scene->material.stiffness = 0;
  hand.servo.set_scene(scene);
  hand.rest(kAbove, 400);
  hand.rest({0, 0, -1e-5}, 200);
  const Vec3 force = hand.servo.tick({hand.time_s, {0, 0, -3e-5}, 0, true});
  EXPECT_NEAR(force.z, 0.02 / 3, 1e-9) << "20 mm/s through the filter: 1 ms of 1 + 2 ms";
}

TEST(ServoState, AnAbsentPenIsGuidedNowhere) {
  Hand hand;
  auto scene = snapping(flat(), 0, -0.001);
  scene->guiding.mode = GuidingMode::lesson;
  hand.servo.set_scene(scene);
  hand.rest(kAbove, 5);
  EXPECT_NE(hand.servo.latest().guide_m, kAbove);
  hand.at(kAbove, false);
  EXPECT_EQ(hand.servo.latest().guide_m, kAbove);
}

TEST(ServoState, EverySampleIsRecordedWhileARingIsThere) {
  const auto ring = std::make_unique<SampleRing>();
  Hand hand;
  hand.at(kAbove);
  hand.servo.set_recording(ring.get());
  for (int i = 0; i < 3; ++i) hand.at({0, 0, 0.001 * i});
  EXPECT_EQ(ring->pushed, 3U);
  EXPECT_EQ(ring->slots[0].tick, 1U);
  EXPECT_EQ(ring->slots[2].device_m, Vec3(0, 0, 0.002));
  hand.servo.set_recording(nullptr);
  hand.at(kAbove);
  EXPECT_EQ(ring->pushed, 3U);
}

}  // namespace
}  // namespace nazori::haptics
