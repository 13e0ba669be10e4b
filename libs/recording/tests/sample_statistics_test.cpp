// SPDX-License-Identifier: Apache-2.0
#include "nazori/recording/sample_statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nazori::recording {
namespace {

using haptics::ServoSample;
using haptics::Vec3;

ServoSample at(double time_s, const Vec3& device_m, const Vec3& force_n, bool touching) {
  ServoSample sample;
  sample.time_s = time_s;
  sample.device_m = device_m;
  sample.proxy_m = {device_m.x, device_m.y, std::max(device_m.z, 0.0)};
  sample.force_n = force_n;
  sample.touching = touching;
  return sample;
}

TEST(SampleStatistics, OfNothingIsNothing) {
  const SampleStatistics none;
  EXPECT_EQ(none.duration_s(), 0);
  EXPECT_EQ(none.first_s, 0);
  EXPECT_EQ(none.samples + none.touching + none.held, 0U);
  EXPECT_EQ(none.peak_force_n + none.max_depth_m + none.longest_period_s, 0);
  EXPECT_EQ(none.dissipated_j(), 0);
  EXPECT_EQ(none.mean_force_n(), 0);
  EXPECT_EQ(none.mean_contact_force_n(), 0);
}

TEST(SampleStatistics, AreThoseOfTheSamples) {
  SampleStatistics got;
  got.add(at(1.0, {0, 0, 0.001}, {0, 0, 0}, false));
  got.add(at(1.1, {0, 0, -0.002}, {0, 3, 4}, true));
  ServoSample last = at(1.4, {0, 0, -0.001}, {0, 0, 1}, true);
  last.stroke = 2;
  last.events = static_cast<std::uint16_t>(haptics::ServoEvent::fault) |
                static_cast<std::uint16_t>(haptics::ServoEvent::resumed);
  got.add(last);
  EXPECT_EQ(got.samples, 3U);
  EXPECT_EQ(got.touching, 2U);
  EXPECT_EQ(got.held, 1U);
  EXPECT_NEAR(got.duration_s(), 0.4, 1e-12);
  EXPECT_NEAR(got.longest_period_s, 0.3, 1e-12);
  EXPECT_EQ(got.peak_force_n, 5);
  EXPECT_DOUBLE_EQ(got.mean_force_n(), 2);
  EXPECT_DOUBLE_EQ(got.mean_contact_force_n(), 3);
  EXPECT_DOUBLE_EQ(got.max_depth_m, 0.002);
  EXPECT_EQ(got.events[4], 1U);
  EXPECT_EQ(got.events[10], 1U);
  EXPECT_EQ(got.events[0], 0U);
}

// A spring pressed in by 2 mm and let go gives back what was put in: k d^2 / 2.
TEST(SampleStatistics, AnIdealSpringGivesBackWhatTheHandPutIn) {
  SampleStatistics got;
  constexpr double kStiffness = 500, kDepth = 0.002;
  constexpr int kSteps = 20'000;
  for (int i = 0; i <= kSteps; ++i) {
    const double depth = kDepth * (i <= kSteps / 2 ? i : kSteps - i) / (kSteps / 2);
    got.add(at(i * 1e-3, {0, 0, -depth}, {0, 0, kStiffness * depth}, true));
  }
  const double energy = kStiffness * kDepth * kDepth / 2;
  EXPECT_NEAR(got.put_in_j(), energy, 1e-3 * energy);
  EXPECT_NEAR(got.got_back_j(), energy, 1e-3 * energy);
  EXPECT_NEAR(got.dissipated_j(), 0, 1e-3 * energy);
}

TEST(SampleStatistics, WorkIsTheForceOfOneSampleTimesTheWayToTheNext) {
  SampleStatistics got;
  got.add(at(0, {5, 5, 5}, {2, 0, 1}, false));
  got.add(at(1, {5.5, 7, 4}, {0, 3, 0}, false));   // 2 * 0.5 - 1 * 1
  got.add(at(2, {5.5, 6, 4}, {-1, 0, 0}, false));  // -3
  got.add(at(3, {5.25, 6, 4}, {9, 9, 9}, false));  // 0.25
  EXPECT_DOUBLE_EQ(got.put_in_j(), 3);
  EXPECT_DOUBLE_EQ(got.got_back_j(), 0.25);
  EXPECT_DOUBLE_EQ(got.dissipated_j(), 2.75);
}

TEST(SampleStatistics, DepthAndContactForceAreThoseOfContactAndAHeldStrokeIsAnyButNone) {
  SampleStatistics got;
  got.add(at(2, {0, 0, -0.003}, {0, 0, 9}, false));
  got.add(at(2.5, {0, 0, -0.001}, {0, 0, 2}, true));
  ServoSample last = at(2.75, {0, 0, -0.002}, {0, 0, 4}, true);
  last.stroke = -1;
  last.events = 0x8001;
  got.add(last);
  EXPECT_DOUBLE_EQ(got.max_depth_m, 0.002);
  EXPECT_EQ(got.peak_force_n, 9);
  EXPECT_DOUBLE_EQ(got.mean_contact_force_n(), 3);
  EXPECT_DOUBLE_EQ(got.mean_force_n(), 5);
  EXPECT_EQ(got.held, 1U);
  EXPECT_EQ(got.first_s, 2);
  EXPECT_EQ(got.last_s, 2.75);
  EXPECT_EQ(got.longest_period_s, 0.5);
  for (std::size_t bit = 0; bit < 16; ++bit)
    EXPECT_EQ(got.events[bit], bit == 0 || bit == 15 ? 1U : 0U) << bit;
}

// Sliding 50 mm against 0.3 N of friction takes 15 mJ.
TEST(SampleStatistics, FrictionKeepsForceTimesWay) {
  SampleStatistics got;
  for (int i = 0; i <= 500; ++i) got.add(at(i * 1e-3, {i * 1e-4, 0, -0.001}, {-0.3, 0, 0.5}, true));
  EXPECT_NEAR(got.dissipated_j(), 0.015, 1e-9);
  EXPECT_EQ(got.got_back_j(), 0);
}

}  // namespace
}  // namespace nazori::recording
