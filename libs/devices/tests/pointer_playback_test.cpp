// SPDX-License-Identifier: Apache-2.0
// How states that arrive together are played one after the other. The samples are counted, not timed.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "nazori/devices/pointer_device.h"

namespace nazori::devices {
namespace {

using haptics::DeviceSample;

/// Keeps every sample.
class PlayedSamples final : public haptics::ServoCallback {
 public:
  haptics::Vec3 tick(const DeviceSample& sample) noexcept override {
    const std::lock_guard lock(mutex_);
    samples_.push_back(sample);
    return haptics::Vec3(0);
  }
  [[nodiscard]] std::vector<DeviceSample> all() {
    const std::lock_guard lock(mutex_);
    return samples_;
  }
  /// Waits until a sample is as wished, for a minute at most.
  [[nodiscard]] bool comes(const std::function<bool(const DeviceSample&)>& wish) {
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (std::chrono::steady_clock::now() < give_up) {
      if (const auto now = all(); !now.empty() && wish(now.back())) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
  }

 private:
  std::mutex mutex_;
  std::vector<DeviceSample> samples_;
};

class PointerPlayback : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(device_.start(servo_));
    device_.move({0, 0, 0.004, true, true}, 10.0);
    ASSERT_TRUE(servo_.comes([](const DeviceSample& s) { return s.position_m.z < -0.0039; }));
  }
  void TearDown() override { device_.stop(); }
  /// Waits until the tip is there, and stops. @return all samples.
  std::vector<DeviceSample> until_at(double x_m) {
    EXPECT_TRUE(servo_.comes([x_m](const DeviceSample& s) { return std::abs(s.position_m.x - x_m) < 1e-6; }));
    device_.stop();
    return servo_.all();
  }
  PlayedSamples servo_;  // outlives the device
  PointerDevice device_;
};

TEST_F(PointerPlayback, AStraightStrokeGoesForwardOnlyAtMostFourTimesAsFastAsItWasDrawn) {
  constexpr int kEvents = 100;
  for (int i = 1; i <= kEvents; ++i)
    device_.move({0.001 * i, -0.0005 * i, 0.004, true, true}, 10 + 0.005 * i);
  const auto samples = until_at(0.1);
  int moving = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const auto step = samples[i].position_m - samples[i - 1].position_m;
    if (samples[i - 1].position_m.z > -0.0039) continue;
    EXPECT_GE(step.x, -1e-15) << i;
    // 0.2 mm a millisecond were drawn.
    EXPECT_LE(step.x, PointerDevice::kFastest * 0.0002 + 1e-6) << i;
    EXPECT_NEAR(step.y, -step.x / 2, 1e-12) << "it stays on its line";
    EXPECT_NEAR(samples[i].position_m.z, -0.004, 1e-4);
    if (step.x > 1e-9) ++moving;
  }
  EXPECT_GE(moving, kEvents * 5 / PointerDevice::kFastest);
}

TEST_F(PointerPlayback, APauseBetweenTwoStatesIsSkipped) {
  // Two seconds, of which the last ten milliseconds are played.
  device_.move({0.01, 0, 0.004, true, true}, 12.0);
  const auto samples = until_at(0.01);
  int moving = 0;
  for (std::size_t i = 1; i < samples.size(); ++i)
    if (samples[i].position_m.x > 1e-9) ++moving;
  EXPECT_GE(moving, 4) << "it is a movement, not a jump";
  EXPECT_LT(moving, 100);
}

TEST_F(PointerPlayback, EachPressAndLiftOfAQuickSeriesIsSeen) {
  for (int i = 1; i <= 20; ++i) device_.move({0, 0, 0.004, i % 2 == 0, true}, 10 + 0.001 * i);
  device_.move({0.01, 0, 0.004, true, true}, 10.5);
  const auto samples = until_at(0.01);
  int changes = 0;
  for (std::size_t i = 1; i < samples.size(); ++i)
    changes +=
        samples[i].present && samples[i - 1].present && samples[i].buttons != samples[i - 1].buttons ? 1 : 0;
  EXPECT_EQ(changes, 20);
}

TEST_F(PointerPlayback, AStateThatIsNotANumberOrHasNoTimeIsPassedOver) {
  device_.move({std::nan(""), 0, 0, true, true}, 10.1);
  device_.move({0.05, 0, 0.004, true, true}, std::nan(""));
  device_.move({0.01, 0, 0.004, true, true}, 10.2);
  for (const DeviceSample& sample : until_at(0.01)) EXPECT_LE(sample.position_m.x, 0.0101);
}

}  // namespace
}  // namespace nazori::devices
