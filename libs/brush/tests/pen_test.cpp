// SPDX-License-Identifier: Apache-2.0
#include "nazori/brush/pen.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace nazori::brush {
namespace {

TuftForm number_4() { return *tuft_form(4); }

PenSample pen(double time_s, double x, std::optional<double> pressure = {}) {
  PenSample sample;
  sample.time_s = time_s;
  sample.at = {x, 0};
  sample.pressure = pressure;
  return sample;
}

TEST(PenToHolder, PressureBecomesDepthInProportion) {
  PenToHolder holder(number_4(), {});
  EXPECT_DOUBLE_EQ(holder.next(pen(0, 0, 0.0)).depth_m, 0);
  EXPECT_DOUBLE_EQ(holder.next(pen(1, 0, 0.5)).depth_m, 0.5 * 0.35 * 0.055);
  EXPECT_DOUBLE_EQ(holder.next(pen(2, 0, 1.0)).depth_m, 0.35 * 0.055);
}

TEST(PenToHolder, TheHeightOfADeviceIsTakenAsItIs) {
  PenToHolder holder(number_4(), {});
  PenSample sample = pen(0, 0, 1.0);
  sample.height_m = 0.003;
  EXPECT_DOUBLE_EQ(holder.next(sample).depth_m, -0.003);
  sample.height_m = -0.004;
  sample.down = false;
  EXPECT_DOUBLE_EQ(holder.next(sample).depth_m, 0.004);
}

TEST(PenSample, LiftedItIsUpThoughItsDeviceWasBelowThePaper) {
  PenSample sample = pen(3, 0.01, 0.4);
  sample.height_m = -0.002;
  const PenSample up = sample.lifted();
  EXPECT_FALSE(up.is_down());
  EXPECT_FALSE(up.height_m);
  EXPECT_EQ(up.time_s, 3);
  EXPECT_EQ(up.at.x, 0.01);
  EXPECT_EQ(up.pressure, 0.4);
  EXPECT_FALSE(pen(0, 0).lifted().is_down());
}

TEST(PenSample, TheHeightOfADeviceSaysWhetherItIsDown) {
  PenSample sample = pen(0, 0);
  EXPECT_TRUE(sample.is_down());
  sample.down = false;
  EXPECT_FALSE(sample.is_down());
  sample.height_m = -1e-6;
  EXPECT_TRUE(sample.is_down());
  sample.down = true;
  sample.height_m = 0.0;
  EXPECT_FALSE(sample.is_down());
}

TEST(PenToHolder, APenThatIsNotDownIsAboveThePaper) {
  PenToHolder holder(number_4(), {});
  PenSample sample = pen(0, 0, 0.7);
  sample.down = false;
  EXPECT_DOUBLE_EQ(holder.next(sample).depth_m, -0.005);
}

TEST(PenToHolder, PlaceLeanAndTwistArePassedOn) {
  PenToHolder holder(number_4(), {});
  PenSample sample = pen(3, 0.01, 0.5);
  sample.lean_rad = 0.2;
  sample.lean_to_rad = 1.1;
  sample.twist_rad = -0.4;
  const HolderPose pose = holder.next(sample);
  EXPECT_EQ(pose.time_s, 3);
  EXPECT_EQ(pose.at, (geometry::PaperPoint{0.01, 0}));
  EXPECT_EQ(pose.lean_rad, 0.2);
  EXPECT_EQ(pose.lean_to_rad, 1.1);
  EXPECT_EQ(pose.twist_rad, -0.4);
}

/// Depth, over that at full pressure, after moving for `seconds` at a speed.
double guessed(double speed_m_s, double seconds, double per_s, const Handling& handling = {}) {
  PenToHolder holder(number_4(), handling);
  double depth = 0;
  const int count = static_cast<int>(std::lround(seconds * per_s));
  for (int i = 0; i <= count; ++i) depth = holder.next(pen(i / per_s, speed_m_s * i / per_s)).depth_m;
  return depth / (0.35 * 0.055);
}

TEST(PenToHolder, WithoutPressureASlowHandPressesAndAFastOneDoesNot) {
  EXPECT_NEAR(guessed(0.01, 1, 100), kSlowPressure, 1e-3);
  EXPECT_NEAR(guessed(0.02, 1, 100), kSlowPressure, 1e-3);
  EXPECT_NEAR(guessed(0.5, 1, 100), kFastPressure, 1e-3);
  // The middle by ratio.
  EXPECT_NEAR(guessed(std::sqrt(0.02 * 0.4), 1, 100), (kSlowPressure + kFastPressure) / 2, 1e-3);
}

TEST(PenToHolder, IsAtFirstHandledAsTheHeaderSays) {
  EXPECT_EQ(kSlowPressure, 0.75);
  EXPECT_EQ(kFastPressure, 0.15);
  const Handling handling;
  EXPECT_EQ(handling.full_depth, 0.35);
  EXPECT_EQ(handling.lifted_m, 0.005);
  EXPECT_TRUE(handling.guess_pressure);
  EXPECT_EQ(handling.steady_pressure, 0.5);
  EXPECT_EQ(handling.slow_m_s, 0.02);
  EXPECT_EQ(handling.fast_m_s, 0.40);
  EXPECT_EQ(handling.settles_s, 0.06);
  // An upright brush that just touches.
  const HolderPose pose;
  for (const double value :
       {pose.time_s, pose.at.x, pose.at.y, pose.depth_m, pose.lean_rad, pose.lean_to_rad, pose.twist_rad})
    EXPECT_EQ(value, 0);
}

TEST(PenToHolder, TheGuessBeginsAtNothingAndSettlesWhateverTheRateOfReports) {
  EXPECT_DOUBLE_EQ(guessed(0.1, 0, 100), kTouchPressure);
  EXPECT_NEAR(guessed(0.01, 0.06, 1000), kSlowPressure + (kTouchPressure - kSlowPressure) * std::exp(-1),
              1e-9);
  EXPECT_NEAR(guessed(0.1, 0.1, 60), guessed(0.1, 0.1, 1000), 1e-9);
}

TEST(PenToHolder, TheGuessBeginsAgainWhereThePenComesDownAgain) {
  PenToHolder holder(number_4(), {});
  for (int i = 0; i < 50; ++i) (void)holder.next(pen(0.01 * i, 0));
  PenSample up = pen(0.6, 0);
  up.down = false;
  (void)holder.next(up);
  EXPECT_DOUBLE_EQ(holder.next(pen(0.7, 0)).depth_m, kTouchPressure * 0.35 * 0.055);
}

TEST(PenToHolder, TheGuessGoesFromSlowToFastByTheRatioOfSpeeds) {
  Handling handling;
  handling.slow_m_s = 0.01;
  handling.fast_m_s = 0.16;
  handling.settles_s = 0;  // at once
  for (const auto& [speed, share] :
       {std::pair{0.01, 0.0}, {0.02, 0.25}, {0.04, 0.5}, {0.08, 0.75}, {0.16, 1.0}, {1.0, 1.0}})
    EXPECT_NEAR(guessed(speed, 0.1, 100, handling), 0.75 - 0.6 * share, 1e-9) << speed;
  // Speeds that are none count as the slowest there are.
  handling.slow_m_s = handling.fast_m_s = 0;
  EXPECT_NEAR(guessed(0, 0.1, 100, handling), kSlowPressure, 1e-12);
  EXPECT_NEAR(guessed(0.9e-6, 0.1, 100, handling), kSlowPressure, 1e-12);
  EXPECT_NEAR(guessed(2.1e-6, 0.1, 100, handling), kFastPressure, 1e-12);
  // Between a slow one of a millionth and a fast one of two.
  EXPECT_NEAR(guessed(1.2e-6, 0.1, 100, handling), 0.75 - 0.6 * std::log2(1.2), 1e-9);
}

TEST(PenToHolder, AReportAtTheSameTimeChangesNoGuess) {
  PenToHolder holder(number_4(), {});
  (void)holder.next(pen(0, 0));
  const double before = holder.next(pen(0.01, 0.0001)).depth_m;
  EXPECT_EQ(holder.next(pen(0.01, 0.02)).depth_m, before);
}

TEST(PenToHolder, TheGuessBeginsAgainAfterAPenThatToldItsPressure) {
  PenToHolder holder(number_4(), {});
  for (int i = 0; i < 50; ++i) (void)holder.next(pen(0.01 * i, 0));
  PenSample up = pen(0.6, 0, 0.9);
  up.down = false;
  EXPECT_EQ(holder.next(up).depth_m, -0.005);
  up.pressure.reset();
  (void)holder.next(up);
  EXPECT_DOUBLE_EQ(holder.next(pen(0.7, 0)).depth_m, kTouchPressure * 0.35 * 0.055);
}

TEST(PenToHolder, TheGuessCanBeSwitchedOff) {
  Handling handling;
  handling.guess_pressure = false;
  EXPECT_DOUBLE_EQ(guessed(0.5, 0.5, 100, handling), 0.5);
  EXPECT_DOUBLE_EQ(guessed(0.01, 0.5, 100, handling), 0.5);
}

}  // namespace
}  // namespace nazori::brush
