// SPDX-License-Identifier: Apache-2.0
// What a tick says of itself: its sample, its events, its time.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "relief.h"
#include "servo_hand.h"

namespace nazori::haptics {
namespace {

using test::Hand;
using test::kAbove;
using test::plate;
using test::Relief;

TEST(Servo, ASampleSaysWhatTheDeviceSaidEvenWhereItWasAFault) {
  Servo servo{DeviceDescription{}};
  (void)servo.tick({0.001, kAbove, 5, true});
  EXPECT_EQ(servo.latest().buttons, 5U);
  EXPECT_EQ(servo.latest().time_s, 0.001);
  EXPECT_EQ(servo.latest().device_m, kAbove);
  EXPECT_EQ(servo.latest().guide_m, kAbove);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  (void)servo.tick({nan, {0, 0, 0.001}, 2, true});
  EXPECT_EQ(servo.latest().buttons, 2U);
  EXPECT_EQ(servo.latest().time_s, 0.001) << "the newest that is one";
  EXPECT_EQ(servo.latest().device_m, kAbove) << "what came with it is not believed";
  EXPECT_EQ(servo.events(), static_cast<std::uint16_t>(ServoEvent::fault));
  (void)servo.tick({0.003, {0, 0, 0.002}, 0, false});
  EXPECT_EQ(servo.latest().device_m, Vec3(0, 0, 0.002));
  EXPECT_EQ(servo.events(), 0);
}

TEST(Servo, AHundredMetresAwayIsInNobodysHand) {
  for (const int axis : {0, 1, 2})
    for (const double far : {99.0, -99.0, 101.0, -101.0}) {
      Servo servo{DeviceDescription{}};
      Vec3 p(0, 0, 0.01);
      p[axis] = far;
      (void)servo.tick({0.001, p, 0, true});
      EXPECT_EQ(has(servo.events(), ServoEvent::fault), std::abs(far) > 100) << axis << " " << far;
    }
}

TEST(Servo, AClockMayStandStillOrGoBackByLessThanFiveMilliseconds) {
  for (const auto& [step_s, fault] : {std::pair{0.0, false}, {-0.0049, false}, {-0.0051, true}}) {
    Servo servo{DeviceDescription{}};
    (void)servo.tick({1.0, kAbove, 0, true});
    (void)servo.tick({1.0 + step_s, kAbove, 0, true});
    EXPECT_EQ(has(servo.events(), ServoEvent::fault), fault) << step_s;
  }
}

TEST(Servo, TimingCountsEveryTickAndHowLateTheLatestWas) {
  Servo servo{DeviceDescription{}};
  (void)servo.tick({1.0, kAbove, 0, true});
  (void)servo.tick({1.001, kAbove, 0, true});
  EXPECT_NEAR(servo.timing().max_lateness_s, 0, 1e-12);
  (void)servo.tick({1.0035, kAbove, 0, true});
  (void)servo.tick({1.0045, kAbove, 0, true});
  const ServoTiming timing = servo.timing();
  EXPECT_EQ(timing.ticks, 4U);
  EXPECT_EQ(timing.late_ticks, 1U);
  EXPECT_EQ(timing.missed_ticks, 1U);
  EXPECT_NEAR(timing.max_lateness_s, 0.0015, 1e-12);
  EXPECT_GT(timing.mean_tick_s, 0);
  EXPECT_GE(timing.max_tick_s, timing.mean_tick_s);
  EXPECT_LE(timing.max_tick_s, 4 * timing.mean_tick_s) << "four ticks took the sum";
}

TEST(Servo, ATickThatComesTooLateGetsNoForceAndIsCounted) {
  const Relief flat(64, 0.01, plate);
  Hand hand;
  hand.servo.set_scene(flat.scene());
  hand.rest(kAbove, 400);
  hand.go(kAbove, {0, 0, -0.002}, 100);
  hand.time_s += 0.004;  // late, but too little for a hand to notice
  EXPECT_GT(hand.at({0, 0, -0.002}).z, 0.1);
  hand.time_s += 0.1;
  EXPECT_EQ(hand.at({0, 0, -0.003}), Vec3(0));
  EXPECT_TRUE(hand.saw(ServoEvent::fault));
  EXPECT_NEAR(hand.servo.latest().proxy_m.z, 0, 1e-12);
  EXPECT_LT(hand.at({0, 0, -0.003}).z, 0.01);
  const ServoTiming t = hand.servo.timing();
  EXPECT_EQ(t.late_ticks, 2U);
  EXPECT_EQ(t.missed_ticks, 104U);
  EXPECT_NEAR(t.max_lateness_s, 0.1, 1e-9);
  EXPECT_EQ(t.ticks, 503U);
  hand.time_s -= 1;
  EXPECT_EQ(hand.at({0, 0, -0.003}), Vec3(0));
  EXPECT_TRUE(hand.saw(ServoEvent::fault));
}

TEST(Servo, FiveMillisecondsLateIsTheLimit) {
  const Relief flat(64, 0.01, plate);
  for (const double late_s : {0.0049, 0.0051}) {
    Hand hand;
    hand.servo.set_scene(flat.scene());
    hand.rest(kAbove, 400);
    hand.go(kAbove, {0, 0, -0.002}, 100);
    hand.time_s += late_s;
    EXPECT_EQ(hand.at({0, 0, -0.002}) == Vec3(0), late_s > 0.005);
    EXPECT_EQ(hand.saw(ServoEvent::fault), late_s > 0.005);
  }
}

TEST(Servo, ATickLateByLessThanAPeriodIsNotLost) {
  Hand hand;
  hand.rest(kAbove, 10);
  hand.time_s += 0.0007;
  hand.at(kAbove);
  EXPECT_EQ(hand.servo.timing().late_ticks, 1U);
  EXPECT_EQ(hand.servo.timing().missed_ticks, 0U);
  hand.time_s += 0.001;
  hand.at(kAbove);
  EXPECT_EQ(hand.servo.timing().missed_ticks, 1U);
}

TEST(Servo, ATickThatCameEarlyOrLateIsCountedAsHalfOrTwoPeriodsAtMost) {
  // Visible in the velocity that damping uses.
  for (const auto& [elapsed_s, counted_s] : {std::pair{0.0002, 0.0005}, {0.0015, 0.0015}, {0.004, 0.002}}) {
    const Relief flat(64, 0.01, plate);
    DeviceDescription device;
    device.limits.max_slew_n_s = 1e9;
    auto scene = flat.scene();
    scene->material.stiffness = 0;
    scene->material.damping = 0.4;
    Hand hand(device);
    hand.servo.set_scene(scene);
    hand.rest(kAbove, 400);
    hand.rest({0, 0, 0}, 100);
    hand.time_s += elapsed_s - 0.001;
    const Vec3 force = hand.at({0, 0, -2e-5});
    EXPECT_NEAR(force.z, 2e-5 / counted_s * counted_s / (counted_s + 0.002), 1e-9) << elapsed_s;
  }
}

TEST(Servo, SamplesComeOutCompleteInOrderAndLossesAreCounted) {
  Hand hand;
  std::vector<ServoSample> taken(300);
  std::uint64_t next = 0;
  for (int i = 0; i < 100; ++i) {
    hand.rest(kAbove, 100);
    const std::size_t count = hand.servo.take_samples(taken);
    for (std::size_t k = 0; k < count; ++k) EXPECT_EQ(taken[k].tick, next++);
  }
  EXPECT_EQ(next, 10'000U);
  EXPECT_EQ(hand.servo.timing().dropped_samples, 0U);
  hand.rest(kAbove, 20'000);
  EXPECT_GT(hand.servo.timing().dropped_samples, 0U);
}

}  // namespace
}  // namespace nazori::haptics
