// SPDX-License-Identifier: Apache-2.0
#include "nazori/writing/pen_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "drawing.h"

namespace nazori::writing::test {
namespace {

/// A stroke along x at the given place at each time, sampled at 200 Hz.
WrittenStroke motion(double duration_s, const std::function<double(double)>& place) {
  WrittenStroke s;
  for (int k = 0; k <= static_cast<int>(duration_s * 200); ++k) {
    const double t = k / 200.0;
    s.push_back({{place(t), 0}, t});
  }
  return s;
}

/// From 0 to `distance` with the speed of a minimum-jerk reach (Flash and Hogan 1985): one peak.
double reach(double t, double duration_s, double distance) {
  const double u = std::clamp(t / duration_s, 0.0, 1.0);
  return distance * u * u * u * (10 - 15 * u + 6 * u * u);
}

TEST(PenMotion, AFluentStrokeHasOnePeakAndStops) {
  const auto m = pen_motion({{motion(0.6, [](double t) { return reach(t, 0.6, 100); })}, {}});
  ASSERT_EQ(m.size(), 1U);
  EXPECT_EQ(m[0].speed_peaks, 1);
  EXPECT_TRUE(m[0].pauses.empty());
  EXPECT_EQ(m[0].lift, PenLift::stopped);
  EXPECT_NEAR(m[0].duration_s, 0.6, 1e-9);
  EXPECT_NEAR(m[0].mean_speed, 100 / 0.6, 1e-6);
}

TEST(PenMotion, PeaksAreTheSameInAnyUnitOfLength) {
  for (const double unit : {1e-3, 1.0, 1e3}) {
    const auto m = pen_motion(
        {{motion(2.0, [unit](double t) { return unit * (reach(t, 0.6, 1) + reach(t - 1.2, 0.6, 0.5)); })},
         {}});
    EXPECT_EQ(m[0].speed_peaks, 2) << unit;
  }
}

TEST(PenMotion, EachNewStartIsAPeakAndEachRestAPause) {
  const auto m =
      pen_motion({{motion(2.0, [](double t) { return reach(t, 0.6, 100) + reach(t - 1.2, 0.6, 50); })}, {}});
  EXPECT_EQ(m[0].speed_peaks, 2);
  ASSERT_EQ(m[0].pauses.size(), 2U);
  EXPECT_NEAR(m[0].pauses[0].start_s, 0.6, 0.08);
  EXPECT_NEAR(m[0].pauses[0].duration_s, 0.6, 0.16);
}

TEST(PenMotion, ASweepEndsInMotion) {
  EXPECT_EQ(pen_motion({{motion(0.5, [](double t) { return 100 * t * t; })}, {}})[0].lift, PenLift::swept);
}

TEST(PenMotion, PressureTellsWhereThereAreNoTimes) {
  WrittenStroke s;
  for (int k = 0; k <= 100; ++k) {
    s.push_back({{static_cast<double>(k), 0}, {}, k < 80 ? 0.8 : 0.8 * (100 - k) / 20.0});
  }
  const auto m = pen_motion({{s}, {}});
  EXPECT_EQ(m[0].lift, PenLift::swept);
  EXPECT_NEAR(*m[0].pressure_at_end, 0.2, 0.01);
  EXPECT_EQ(m[0].speed_peaks, 0);
}

TEST(PenMotion, WithoutTimesAndPressuresNothingIsClaimed) {
  const auto m = pen_motion({{along({{0, 0}, {1, 0}})}, {}});
  EXPECT_EQ(m[0].lift, PenLift::unknown);
  EXPECT_FALSE(m[0].pressure);
}

TEST(PenMotion, TimesThatStandStillOrRunBackwardsAreSurvived) {
  WrittenStroke s = along({{0, 0}, {5, 0}, {9, 0}}, {1, 1, 1});
  EXPECT_EQ(pen_motion({{s}, {}})[0].speed_peaks, 0);
  s = along({{0, 0}, {5, 0}, {9, 0}}, {3, 2, 1});
  EXPECT_EQ(pen_motion({{s}, {}})[0].speed_peaks, 0);
}

}  // namespace
}  // namespace nazori::writing::test
