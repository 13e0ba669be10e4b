// SPDX-License-Identifier: Apache-2.0
#include "nazori/haptics/servo.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "../src/guidance.h"
#include "alloc_guard.h"
#include "relief.h"
#include "servo_hand.h"

namespace nazori::haptics {
namespace {

using test::Hand;
using test::kAbove;
using test::plate;
using test::Relief;

TEST(Servo, WithoutASceneThereIsNothingToFeel) {
  Hand hand;
  EXPECT_EQ(hand.rest({0, 0, -0.01}, 10), Vec3(0));
  EXPECT_FALSE(hand.servo.latest().touching);
  hand.servo.set_scene(nullptr);
  EXPECT_EQ(hand.rest({0, 0, -0.01}, 10), Vec3(0));
}

TEST(Servo, PressingAPlateGivesStiffnessTimesDepth) {
  const Relief flat(64, 0.01, plate);
  Hand hand;
  hand.servo.set_scene(flat.scene());
  hand.rest(kAbove, 400);
  hand.go(kAbove, {0, 0, -0.001}, 200);
  const Vec3 force = hand.rest({0, 0, -0.001}, 50);
  EXPECT_NEAR(force.z, 0.8 * 500 * 0.001, 1e-6);
  EXPECT_NEAR(std::hypot(force.x, force.y), 0, 1e-9);
  const ServoSample& s = hand.servo.latest();
  EXPECT_TRUE(s.touching);
  EXPECT_EQ(s.force_n, force);
  EXPECT_NEAR(s.proxy_m.z, 0, 1e-12);
}

TEST(Servo, TouchAndUntouchAreReportedOnce) {
  const Relief flat(64, 0.01, plate);
  Hand hand;
  hand.servo.set_scene(flat.scene());
  hand.rest(kAbove, 3);
  hand.at({0, 0, -1e-4});
  EXPECT_TRUE(hand.saw(ServoEvent::touch));
  hand.at({0, 0, -2e-4});
  EXPECT_EQ(hand.servo.latest().events, 0);
  hand.at({0, 0, 1e-4});
  EXPECT_TRUE(hand.saw(ServoEvent::untouch));
  hand.at({0, 0, 2e-4});
  EXPECT_EQ(hand.servo.latest().events, 0);
}

TEST(Servo, ForceRisesSlowlyAfterTheStartAndIsThereAtOnceLater) {
  const Relief flat(64, 0.01, plate);
  Hand hand;
  hand.servo.set_scene(flat.scene());
  EXPECT_LT(hand.at({0, 0, -0.002}).z, 0.01);
  EXPECT_LT(hand.rest({0, 0, -0.002}, 100).z, 0.35 * 0.8);
  EXPECT_NEAR(hand.rest({0, 0, -0.002}, 300).z, 0.8, 1e-6);
  hand.go({0, 0, -0.002}, kAbove, 100);
  hand.rest(kAbove, 10);
  hand.at({0, 0, 1e-5});
  EXPECT_GT(hand.at({0, 0, -1e-5}).z, 0.5 * 400 * 1e-5);
}

TEST(Servo, ANewKanjiUnderAPressedStylusLiftsTheProxyWithoutAKick) {
  const Relief deep(64, 0.01, [](double, double) { return -0.008; });
  const Relief flat(64, 0.01, plate);
  Hand hand;
  hand.servo.set_scene(deep.scene());
  hand.rest(kAbove, 400);
  hand.go(kAbove, {0, 0, -0.009}, 200);
  Vec3 before = hand.rest({0, 0, -0.009}, 50);
  EXPECT_NEAR(before.z, 0.4, 1e-3);
  hand.servo.set_scene(flat.scene());
  for (int i = 0; i < 400; ++i) {
    const Vec3 now = hand.at({0, 0, -0.009});
    EXPECT_LE(glm::length(now - before), 0.2 + 1e-9);
    if (i > 0) {
      EXPECT_LE(now.z, 0.8 * 500 * 0.009 * (i + 1) / 300 + 0.4);
    }
    before = now;
    ASSERT_NEAR(hand.servo.latest().proxy_m.z, 0, 1e-12);
    ASSERT_TRUE(hand.servo.latest().touching);
  }
  EXPECT_NEAR(before.z, 3.3, 0.31);  // 3.6 N wanted, the peak is 3.3
}

TEST(Servo, WhatIsNotFiniteIsAFaultWithoutForceAndTheProxyStaysOut) {
  const Relief flat(64, 0.01, plate);
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const Vec3 bad : {Vec3(nan, 0, 0), Vec3(0, inf, 0), Vec3(0, 0, -inf), Vec3(0, 0, 1e300)}) {
    Hand hand;
    hand.servo.set_scene(flat.scene());
    hand.rest(kAbove, 400);
    hand.go(kAbove, {0, 0, -0.002}, 100);
    EXPECT_EQ(hand.at(bad), Vec3(0));
    EXPECT_TRUE(hand.saw(ServoEvent::fault));
    EXPECT_TRUE(hand.saw(ServoEvent::untouch));
    EXPECT_TRUE(std::isfinite(hand.servo.latest().device_m.x));
    EXPECT_GE(hand.servo.latest().proxy_m.z, 0);
    EXPECT_LT(hand.at({0, 0, -0.002}).z, 0.01);  // ramps in again
    EXPECT_GE(hand.servo.latest().proxy_m.z, -1e-12);
  }
  Hand hand;
  hand.servo.set_scene(flat.scene());
  hand.rest(kAbove, 10);
  EXPECT_EQ(hand.servo.tick({nan, {0, 0, -0.001}, 0, true}), Vec3(0));
  EXPECT_TRUE(hand.saw(ServoEvent::fault));
}

TEST(Servo, ALiftedPenFeelsNothing) {
  const Relief flat(64, 0.01, plate);
  Hand hand;
  hand.servo.set_scene(flat.scene());
  hand.rest(kAbove, 400);
  hand.go(kAbove, {0, 0, -0.002}, 100);
  EXPECT_EQ(hand.at({0, 0, -0.002}, false), Vec3(0));
  EXPECT_TRUE(hand.saw(ServoEvent::untouch));
  EXPECT_FALSE(hand.saw(ServoEvent::fault));
  EXPECT_FALSE(hand.servo.latest().touching);
}

std::shared_ptr<HapticScene> groove_with_stroke(const Relief& groove) {
  auto scene = groove.scene();
  scene->strokes.push_back({{{-0.04, 0, -0.01}, {0.04, 0, -0.01}}});
  scene->snapping.enabled = true;
  return scene;
}

TEST(Servo, SnappingHoldsTheProxyOnTheStrokeByTheRuleOf2005) {
  const Relief groove(128, 0.01, [](double, double y) { return -0.01 * std::exp(-1e5 * y * y); });
  Hand hand;  // 500 N/m: the snap distance is 5 N / 500 N/m = 10 mm
  hand.servo.set_scene(groove_with_stroke(groove));
  hand.rest({0, 0, 0.001}, 400);
  EXPECT_EQ(hand.servo.latest().stroke, 0);
  hand.at({0, 0, -0.0005});
  EXPECT_EQ(hand.servo.latest().stroke, 1);
  EXPECT_TRUE(hand.saw(ServoEvent::capture));
  const Vec3 force = hand.rest({0.01, 0, -0.005}, 300);
  EXPECT_NEAR(force.z, -0.2 * 500 * 0.005, 1e-6);
  const ServoSample& s = hand.servo.latest();
  EXPECT_NEAR(s.proxy_m.x, 0.01, 1e-12);
  EXPECT_GE(s.proxy_m.z, groove.tablet.height(0.01, 0) - 1e-12);
  EXPECT_NEAR(s.proxy_m.z, -0.01, 2e-3);
  EXPECT_FALSE(s.touching) << "held in the air, above the bottom of the groove";
  hand.at({0.01, 0, 0.001});
  EXPECT_TRUE(hand.saw(ServoEvent::release));
  EXPECT_EQ(hand.servo.latest().stroke, 0);
}

TEST(Servo, SwitchingSnappingOffLetsGo) {
  const Relief groove(128, 0.01, [](double, double y) { return -0.01 * std::exp(-1e5 * y * y); });
  Hand hand;
  auto scene = groove_with_stroke(groove);
  hand.servo.set_scene(scene);
  hand.rest({0, 0, -0.004}, 400);
  ASSERT_EQ(hand.servo.latest().stroke, 1);
  auto off = std::make_shared<HapticScene>(*scene);
  off->snapping.enabled = false;
  hand.servo.set_scene(off);
  Vec3 before = hand.servo.latest().force_n;
  for (int i = 0; i < 200; ++i) {
    const Vec3 now = hand.at({0, 0, -0.004});
    EXPECT_LT(glm::length(now - before), 0.05);
    before = now;
  }
  EXPECT_EQ(hand.servo.latest().stroke, 0);
  EXPECT_EQ(before, Vec3(0));
}

TEST(Servo, PopThroughIsOffUnlessAskedForAndThenGivesWay) {
  const Relief flat(64, 0.01, plate);
  for (const double popthrough : {0.0, 0.3}) {  // 0.3 of 3.3 N: 2.5 mm at 400 N/m
    Hand hand;
    auto scene = flat.scene();
    scene->material.popthrough = popthrough;
    hand.servo.set_scene(scene);
    hand.rest(kAbove, 400);
    hand.go(kAbove, {0, 0, -0.003}, 200);
    EXPECT_EQ(hand.servo.latest().touching, popthrough == 0);
    EXPECT_EQ(hand.servo.latest().proxy_m.z<-1e-6, popthrough> 0);
    hand.go({0, 0, -0.003}, kAbove, 100);
    hand.go(kAbove, {0, 0, -0.001}, 100);
    EXPECT_TRUE(hand.servo.latest().touching);  // back outside, the surface is solid again
  }
}

TEST(Servo, WhoHasPushedThroughOneSurfaceFeelsTheNextAtOnce) {
  const Relief flat(64, 0.01, plate);
  const Relief other(64, 0.01, plate);
  Hand hand;
  auto scene = flat.scene();
  scene->material.popthrough = 0.3;
  hand.servo.set_scene(scene);
  hand.rest(kAbove, 400);
  hand.go(kAbove, {0, 0, -0.003}, 200);
  ASSERT_FALSE(hand.servo.latest().touching);
  // The same surface passed again does not end the break-through.
  auto again = flat.scene();
  again->material.popthrough = 0.3;
  hand.servo.set_scene(again);
  hand.rest({0, 0, -0.003}, 10);
  EXPECT_FALSE(hand.servo.latest().touching);
  hand.servo.set_scene(other.scene());
  hand.rest({0, 0, -0.003}, 10);
  EXPECT_TRUE(hand.servo.latest().touching);
}

TEST(Servo, BrakingTakesAForceAwayButNeverTurnsItRound) {
  // A late and stiff device, pressed in and released fast, gives back more than it received: it is braked
  // hard.
  const Relief flat(64, 0.01, plate);
  DeviceDescription device;
  device.limits.delay_s = 0.004;
  device.limits.max_damping_n_s_m = 50;
  device.limits.max_slew_n_s = 1e6;
  Hand hand(device);
  hand.servo.set_scene(flat.scene());
  hand.rest(kAbove, 400);
  int all_taken = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vec3 force = hand.at({0, 0, -0.0006 + 0.0005 * std::sin(0.7 * i)});
    EXPECT_GE(force.z, 0) << i;
    all_taken += hand.servo.latest().touching && force.z == 0 ? 1 : 0;
  }
  EXPECT_GT(all_taken, 10) << "else it was never braked so hard";
}

TEST(Servo, GuidancePullsNoMoreThanTheDeviceCanWhateverItsCap) {
  const Relief flat(64, 0.01, plate);
  DeviceDescription device;
  device.limits.max_force_n = 0.5;
  Hand hand(device);
  auto scene = flat.scene();
  StrokePath far;
  for (int i = 0; i <= 20; ++i) far.points.emplace_back(0.04, 0.001 * i, -0.005);
  scene->strokes = {far};
  scene->guiding.mode = GuidingMode::lesson;
  scene->guiding.strength = 1;
  scene->guiding.cap_n = 1;
  hand.servo.set_scene(scene);
  double most = 0;
  for (int i = 0; i < 1500; ++i) most = std::max(most, glm::length(hand.at({-0.04, 0, 0.005})));
  EXPECT_GT(most, 0.9 * Guidance::kCarry * 0.5);
  EXPECT_LE(most, Guidance::kCarry * 0.5 + 1e-9) << "lifted it is carried with 0.6 of what the device can";
}

TEST(Servo, StiffnessStaysWithinWhatTheDeviceAndTheDelayAllow) {
  const Relief flat(64, 0.01, plate);
  DeviceDescription device;
  device.limits.max_stiffness_n_m = 100'000;
  device.limits.max_force_n = 100;
  device.limits.continuous_force_n = 100;
  device.limits.max_slew_n_s = 1e6;
  for (const double delay : {0.0, 0.001}) {
    device.limits.delay_s = delay;
    Hand hand(device);
    hand.servo.set_scene(flat.scene());
    hand.rest(kAbove, 400);
    hand.go(kAbove, {0, 0, -0.0005}, 3000);
    const double allowed = 2.05 / (0.0005 + delay);  // b = 0.05 of the device and 2 of the hand
    EXPECT_NEAR(hand.rest({0, 0, -0.0005}, 10).z, allowed * 0.0005, 1e-3);
  }
}

// b > K T / 2 + B: requested damping is given, with the stiffness that is then passive. A Falcon (b = 2.5
// with the hand's) renders 3,000 N/m; with the most damping, b / 2, 2,500 are passive. An Inverse3 has a
// delay of 1 ms.
TEST(Servo, DampingTakesStiffnessWhereBothWouldNotBePassive) {
  const Relief flat(64, 0.01, plate);
  DeviceDescription falcon, inverse;
  falcon.limits = {8, 8, 3000, 20, 0.5, 1200, 0, 2};
  inverse.limits = {2, 2, 1000, 5, 0.05, 400, 0.001, 2};
  struct Case {
    const DeviceDescription& device;
    double damping, stiffness_n_m;
  };
  for (const Case& c : {Case{falcon, 0, 3000}, Case{falcon, 1, 2500}, Case{inverse, 0, 1000},
                        Case{inverse, 1, 1.025 / 0.0015}}) {
    Hand hand(c.device);
    auto scene = flat.scene();
    scene->material.stiffness = 1;
    scene->material.damping = c.damping;
    hand.servo.set_scene(scene);
    hand.rest(kAbove, 400);
    hand.go(kAbove, {0, 0, -0.0005}, 3000);
    EXPECT_NEAR(hand.rest({0, 0, -0.0005}, 50).z, c.stiffness_n_m * 0.0005, 1e-3);
  }
}

TEST(Servo, DampingOpposesMotionIntoTheSurfaceAndNeverPulls) {
  const Relief flat(64, 0.01, plate);
  Hand plain, damped;
  plain.servo.set_scene(flat.scene());
  auto scene = flat.scene();
  scene->material.damping = 0.4;
  damped.servo.set_scene(scene);
  for (Hand* h : {&plain, &damped}) h->rest(kAbove, 400);
  const Vec3 down{0, 0, -0.002};
  EXPECT_GT(damped.go(kAbove, down, 100).z, plain.go(kAbove, down, 100).z + 0.03);
  for (int i = 0; i < 20; ++i) EXPECT_GE(damped.at(down + Vec3(0, 0, 0.0001 * i)).z, 0);
}

TEST(Servo, DampingFollowsTheSpeedThroughAFilterOfTwoMilliseconds) {
  const Relief flat(64, 0.01, plate);
  DeviceDescription device;
  device.limits.max_slew_n_s = 1e9;
  Hand hand(device);
  auto scene = flat.scene();
  scene->material.stiffness = 0;
  scene->material.damping = 0.4;  // 1 N s/m
  hand.servo.set_scene(scene);
  hand.rest(kAbove, 400);
  hand.at({0, 0, 0});
  hand.rest({0, 0, 0}, 100);  // on the plateau, at rest
  double velocity = 0;
  for (int tick = 1; tick <= 20; ++tick) {
    const Vec3 force = hand.at({0, 0, -2e-5 * tick});
    velocity += (-0.02 - velocity) / 3;  // 1 ms of 1 + 2 ms
    ASSERT_NEAR(force.z, -velocity, 1e-9) << tick;
  }
}

TEST(Servo, SurfacesAreTheSameOnlyInTheSameSize) {
  const Relief flat(64, 0.01, plate), other(64, 0.01, plate);
  const auto in = [&](double width, double depth) { return TabletSurface(*flat.smooth, {width, depth}); };
  EXPECT_TRUE(in(0.1, 0.01) == in(0.1, 0.01));
  EXPECT_FALSE(in(0.1, 0.01) == in(0.11, 0.01));
  EXPECT_FALSE(in(0.1, 0.01) == in(0.1, 0.011));
  EXPECT_FALSE(in(0.1, 0.01) == TabletSurface(*other.smooth, {0.1, 0.01}));
}

TEST(Servo, SameInputGivesTheSameBytes) {
  const Relief groove(128, 0.01, [](double, double y) { return -0.01 * std::exp(-1e5 * y * y); });
  const auto run = [&] {
    Hand hand;
    hand.servo.set_scene(groove_with_stroke(groove));
    std::vector<Vec3> forces;
    forces.reserve(5000);
    for (int i = 0; i < 5000; ++i)
      forces.push_back(hand.at(
          {0.03 * std::sin(0.003 * i), 0.004 * std::sin(0.02 * i), -0.008 + 0.009 * std::sin(0.005 * i)}));
    return forces;
  };
  EXPECT_EQ(run(), run());
}

TEST(AllocGuard, SeesAllocations) {
  const test::AllocGuard guard;
  EXPECT_EQ(guard.calls(), 0);
  // Called by name: the compiler may omit a new-expression whose memory is freed unused.
  void* made = ::operator new(3);
  EXPECT_EQ(guard.calls(), 1);
  ::operator delete(made);
  EXPECT_EQ(guard.calls(), 2);
}

TEST(ServoTick, NeverAllocatesEvenWhenScenesChangeFaultsComeAndTheQueueIsFull) {
  const Relief groove(128, 0.01, [](double, double y) { return -0.01 * std::exp(-1e5 * y * y); });
  Hand hand;
  auto scene = groove_with_stroke(groove);
  scene->material.static_friction = 0.4;
  scene->material.dynamic_friction = 0.3;
  long calls = 0;
  for (int round = 0; round < 20; ++round) {
    hand.servo.set_scene(std::make_shared<HapticScene>(*scene));
    const test::AllocGuard guard;
    for (int i = 0; i < 1000; ++i)
      (void)hand.at(
          {0.03 * std::sin(0.01 * i), 0.01 * std::sin(0.02 * i), -0.008 + 0.01 * std::sin(0.05 * i)});
    (void)hand.at({0, 0, std::numeric_limits<double>::quiet_NaN()});
    hand.time_s += 0.1;
    (void)hand.at({0, 0, -0.01});
    calls += guard.calls();
  }
  EXPECT_EQ(calls, 0);
  EXPECT_GT(hand.servo.timing().dropped_samples, 0U);
}

}  // namespace
}  // namespace nazori::haptics
