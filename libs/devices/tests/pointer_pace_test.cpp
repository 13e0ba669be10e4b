// SPDX-License-Identifier: Apache-2.0
// How states are played, tick by tick and without a clock.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "pointer_playback.h"

namespace nazori::devices {
namespace {

using haptics::DeviceSample;
using haptics::Vec3;

PointerState pressed_at(double x_m, double y_m = 0) { return {x_m, y_m, 0.004, true, true}; }

/// Two low-pass filters of 2 ms, one after the other.
class Filtered {
 public:
  explicit Filtered(const Vec3& at) : halfway_(at), at_(at) {}
  Vec3 after(const Vec3& target, double seconds = 0.001) {
    const double pass = seconds / (seconds + 0.002);
    halfway_ += (target - halfway_) * pass;
    at_ += (halfway_ - at_) * pass;
    return at_;
  }

 private:
  Vec3 halfway_, at_;
};

void expect_near(const Vec3& found, const Vec3& wanted) {
  EXPECT_NEAR(found.x, wanted.x, 1e-12);
  EXPECT_NEAR(found.y, wanted.y, 1e-12);
  EXPECT_NEAR(found.z, wanted.z, 1e-12);
}

TEST(PointerPace, APointerThatWasNeverSeenIsNowhere) {
  PointerPlayback playback;
  const DeviceSample sample = playback.tick();
  EXPECT_FALSE(sample.present);
  EXPECT_EQ(sample.buttons, 0U);
  expect_near(sample.position_m, {0, 0, 0.005});
}

TEST(PointerPace, AStateWithoutATimeHoldsFromTheNextTickOn) {
  PointerPlayback playback;
  playback.move({0.01, 0.02, 0.004, false, true});
  DeviceSample sample = playback.tick();
  EXPECT_TRUE(sample.present);
  EXPECT_EQ(sample.buttons, 0U);
  expect_near(sample.position_m, {0.01, 0.02, 0.005});
  playback.move({0.03, 0, 0.004, true, true});
  Filtered tip({0.01, 0.02, 0.005});
  for (int i = 0; i < 10; ++i) {
    sample = playback.tick();
    EXPECT_EQ(sample.buttons, 1U);
    expect_near(sample.position_m, tip.after({0.03, 0, -0.004}));
  }
}

TEST(PointerPace, TwoStatesArePlayedInALineAtTheirPaceWithTheLastThatIsLate) {
  PointerPlayback playback;
  playback.move(pressed_at(0), 10);
  (void)playback.tick();
  // 4 ms later. At first it is late by 4 ms, so it is played half as fast again.
  playback.move(pressed_at(0.004, -0.002), 10.004);
  Filtered tip({0, 0, -0.004});
  double clock_s = 10;
  for (int i = 0; i < 6; ++i) {
    const double step_s = clock_s < 10.004 ? 0.001 * (1 + (10.004 - clock_s) / 0.008) : 0.001;
    clock_s += step_s;
    const double share = std::min(1.0, (clock_s - 10) / 0.004);
    expect_near(playback.tick().position_m, tip.after({0.004 * share, -0.002 * share, -0.004}, step_s));
  }
}

TEST(PointerPace, WhatIsVeryLateIsPlayedFourTimesAsFast) {
  PointerPlayback playback;
  playback.move(pressed_at(0), 10);
  (void)playback.tick();
  for (int i = 1; i <= 100; ++i) playback.move(pressed_at(0.0001 * i), 10 + 0.005 * i);
  Filtered tip({0, 0, -0.004});
  // 0.02 mm a millisecond, four of them in each tick.
  for (int i = 1; i <= 50; ++i)
    expect_near(playback.tick().position_m, tip.after({0.00002 * 4 * i, 0, -0.004}, 0.004));
}

TEST(PointerPace, OfAPauseTheLastTenMillisecondsArePlayed) {
  PointerPlayback playback;
  playback.move(pressed_at(0), 10);
  (void)playback.tick();
  playback.move(pressed_at(0.01), 12);
  Filtered tip({0, 0, -0.004});
  // The first tick goes to the end of the rest. Then 10 ms are late.
  expect_near(playback.tick().position_m, tip.after({0, 0, -0.004}));
  double clock_s = 11.99;
  for (int i = 0; i < 8; ++i) {
    const double step_s = clock_s < 12 ? 0.001 * (1 + (12 - clock_s) / 0.008) : 0.001;
    clock_s += step_s;
    const double share = std::min(1.0, (clock_s - 11.99) / 0.01);
    expect_near(playback.tick().position_m, tip.after({0.01 * share, 0, -0.004}, step_s));
  }
}

TEST(PointerPace, APressIsPlayedAtItsOwnTimeAndNothingIsBetweenIt) {
  PointerPlayback playback;
  playback.move({0, 0, 0, false, true}, 10);
  (void)playback.tick();
  playback.move({0.01, 0, 0.004, true, true}, 10.001);
  playback.move({0.01, 0, 0.004, false, true}, 10.0015);
  playback.move({0.02, 0, 0.004, false, true}, 10.002);
  // Each tick reaches farther than the next event, but stops at the press and at the lift.
  EXPECT_EQ(playback.tick().buttons, 1U);
  EXPECT_EQ(playback.tick().buttons, 0U);
  EXPECT_EQ(playback.tick().buttons, 0U);
  PointerPlayback slow;
  slow.move({0, 0, 0, false, true}, 10);
  (void)slow.tick();
  slow.move({0.01, 0.01, 0.004, true, true}, 10.004);
  const DeviceSample before = slow.tick();
  EXPECT_EQ(before.buttons, 0U);
  expect_near(before.position_m, {0, 0, 0.005});
}

TEST(PointerPace, AStateBeforeTheLastOneBeginsAnew) {
  PointerPlayback playback;
  playback.move(pressed_at(0), 10);
  (void)playback.tick();
  playback.move(pressed_at(0.01), 10.5);
  playback.move(pressed_at(0.02), 3);
  Filtered tip({0, 0, -0.004});
  for (int i = 0; i < 5; ++i) expect_near(playback.tick().position_m, tip.after({0.02, 0, -0.004}));
}

TEST(PointerPace, AfterARestartTheTipIsWhereThePointerIsAtOnce) {
  PointerPlayback playback;
  playback.move(pressed_at(0), 10);
  (void)playback.tick();
  playback.move(pressed_at(0.03), 10.1);
  playback.restart();
  expect_near(playback.tick().position_m, {0.03, 0, -0.004});
  // What was queued is gone; new states are played again.
  playback.move(pressed_at(0.04), 20);
  Filtered tip({0.03, 0, -0.004});
  expect_near(playback.tick().position_m, tip.after({0.04, 0, -0.004}));
}

TEST(PointerPace, APointerThatLeftAppearsWhereItComesBack) {
  PointerPlayback playback;
  playback.move(pressed_at(0));
  (void)playback.tick();
  playback.move({0.01, 0, 0.004, false, false});
  const DeviceSample away = playback.tick();
  EXPECT_FALSE(away.present);
  playback.move({0.05, 0.01, 0.004, false, true});
  const DeviceSample back = playback.tick();
  EXPECT_TRUE(back.present);
  expect_near(back.position_m, {0.05, 0.01, 0.005});
}

TEST(PointerPace, StatesWithoutNumbersAreNoStates) {
  PointerPlayback playback;
  playback.move(pressed_at(0.01), 10);
  (void)playback.tick();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const PointerState& odd : {PointerState{nan, 0, 0, false, true}, PointerState{0, nan, 0, false, true},
                                  PointerState{0, 0, nan, false, true}}) {
    playback.move(odd, 10.001);
    EXPECT_EQ(playback.tick().buttons, 1U);
    PointerPlayback untimed;
    untimed.move(pressed_at(0.01));
    (void)untimed.tick();
    untimed.move(odd);
    const DeviceSample sample = untimed.tick();
    EXPECT_EQ(sample.buttons, 0U);
    EXPECT_TRUE(sample.present);
    expect_near(sample.position_m, {0.01, 0, -0.004});
  }
  playback.move(pressed_at(0.09), nan);
  for (int i = 0; i < 20; ++i) expect_near(playback.tick().position_m, {0.01, 0, -0.004});
}

TEST(PointerPace, ADepthAboveThePlateauIsThePlateau) {
  PointerPlayback playback;
  playback.move({0, 0, -1, true, true});
  expect_near(playback.tick().position_m, {0, 0, 0});
}

TEST(PointerPace, WhereTheQueueIsFullTheNewestStateHoldsAtOnce) {
  PointerPlayback playback;
  for (int i = 0; i <= 4200; ++i) playback.move(pressed_at(0.00001 * i), 10 + 0.001 * i);
  expect_near(playback.tick().position_m, {0.042, 0, -0.004});
}

TEST(PointerPace, AfterAClockThatJumpedBackStatesArePlayedAtTheirPaceAgain) {
  PointerPlayback playback;
  playback.move(pressed_at(0), 5000);
  (void)playback.tick();
  playback.move(pressed_at(0.01), 1);
  (void)playback.tick();
  playback.move(pressed_at(0.014), 1.004);
  Filtered tip({0, 0, -0.004});
  (void)tip.after({0.01, 0, -0.004});
  expect_near(playback.tick().position_m, tip.after({0.0115, 0, -0.004}, 0.0015));
}

}  // namespace
}  // namespace nazori::devices
