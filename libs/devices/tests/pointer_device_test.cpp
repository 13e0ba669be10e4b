// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/pointer_device.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <mutex>
#include <thread>
#include <vector>

namespace nazori::devices {
namespace {

using haptics::DeviceSample;
using haptics::Vec3;

class Recorder final : public haptics::ServoCallback {
 public:
  Vec3 tick(const DeviceSample& sample) noexcept override {
    const std::lock_guard lock(mutex_);
    samples_.push_back(sample);
    return Vec3(0);
  }
  [[nodiscard]] std::vector<DeviceSample> samples() {
    const std::lock_guard lock(mutex_);
    return samples_;
  }
  /// Waits until a sample satisfies `wish`; false after ten seconds.
  bool wait_for(const std::function<bool(const DeviceSample&)>& wish) {
    for (int i = 0; i < 10000; ++i) {
      {
        const std::lock_guard lock(mutex_);
        if (!samples_.empty() && wish(samples_.back())) return true;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
  }

 private:
  std::mutex mutex_;
  std::vector<DeviceSample> samples_;
};

TEST(PointerDevice, HasNoForceAndSaysSo) {
  const PointerDevice device;
  EXPECT_FALSE(device.describe().has_force);
  EXPECT_EQ(device.describe().rate_hz, 1000);
}

TEST(PointerDevice, IsAbsentUntilThePointerIsOverTheTablet) {
  Recorder recorder;
  PointerDevice device;
  ASSERT_TRUE(device.start(recorder));
  EXPECT_TRUE(recorder.wait_for([](const DeviceSample& s) { return !s.present; }));
  device.move({0.01, 0.02, 0, false, true});
  EXPECT_TRUE(recorder.wait_for([](const DeviceSample& s) { return s.present; }));
  device.stop();
  // It appears where the pointer is; it does not sweep there from the middle.
  for (const DeviceSample& s : recorder.samples()) {
    if (s.present) {
      EXPECT_DOUBLE_EQ(s.position_m.x, 0.01);
      EXPECT_DOUBLE_EQ(s.position_m.z, PointerDevice::kHover_m);
    }
  }
}

TEST(PointerDevice, EveryPartOfAFastStrokeThatCameAtOnceIsPlayed) {
  Recorder recorder;
  PointerDevice device;
  ASSERT_TRUE(device.start(recorder));
  device.move({0, 0, 0.004, true, true}, 10.0);
  ASSERT_TRUE(recorder.wait_for([](const DeviceSample& s) { return s.present; }));
  // A zigzag of 30 corners, 20 ms from one to the next with a point every 5 ms, all in one moment: as when
  // the window was busy for 0.6 s.
  for (int i = 1; i <= 120; ++i) {
    const double phase = i / 4.0;
    const double up = std::abs(phase / 2 - std::floor(phase / 2 + 0.5)) * 2;  // 0 .. 1 .. 0
    device.move({0.0001 * i, 0.01 * up, 0.004, true, true}, 10.0 + 0.005 * i);
  }
  ASSERT_TRUE(
      recorder.wait_for([](const DeviceSample& s) { return std::abs(s.position_m.x - 0.012) < 1e-5; }));
  device.stop();
  int turns = 0;
  bool high = false;
  for (const DeviceSample& s : recorder.samples()) {
    if (!high && s.position_m.y > 0.006) ++turns, high = true;
    if (high && s.position_m.y < 0.004) ++turns, high = false;
  }
  EXPECT_GE(turns, 29);
}

TEST(PointerDevice, AClockThatJumpsBackHoldsNothingUp) {
  Recorder recorder;
  PointerDevice device;
  ASSERT_TRUE(device.start(recorder));
  device.move({0.001, 0, 0, false, true}, 5000);
  device.move({0.002, 0, 0, false, true}, 5000.01);
  device.move({0.003, 0, 0, false, true}, 1);
  device.move({0.004, 0, 0, false, true}, 1.01);
  EXPECT_TRUE(
      recorder.wait_for([](const DeviceSample& s) { return std::abs(s.position_m.x - 0.004) < 1e-6; }));
}

TEST(PointerDevice, PressingMovesTheTipDownWithoutAJump) {
  Recorder recorder;
  PointerDevice device;
  ASSERT_TRUE(device.start(recorder));
  device.move({0, 0, 0, false, true});
  ASSERT_TRUE(recorder.wait_for([](const DeviceSample& s) { return s.present; }));
  device.move({0.001, 0, 0.004, true, true});
  ASSERT_TRUE(recorder.wait_for([](const DeviceSample& s) {
    return std::abs(s.position_m.z + 0.004) < 1e-5 && std::abs(s.position_m.x - 0.001) < 1e-5;
  }));
  device.move({0.001, 0, 0.004, false, true});
  ASSERT_TRUE(recorder.wait_for(
      [](const DeviceSample& s) { return std::abs(s.position_m.z - PointerDevice::kHover_m) < 1e-5; }));
  device.stop();
  const std::vector<DeviceSample> samples = recorder.samples();
  for (std::size_t i = 1; i < samples.size(); ++i)
    EXPECT_LT(std::abs(samples[i].position_m.z - samples[i - 1].position_m.z), 0.003);
  EXPECT_EQ(samples.back().buttons, 0U);
}

TEST(PointerDevice, TheTipFollowsThroughTwoLowPassFilters) {
  Recorder recorder;
  PointerDevice device;
  ASSERT_TRUE(device.start(recorder));
  device.move({0.01, -0.02, 0, false, true});
  ASSERT_TRUE(recorder.wait_for([](const DeviceSample& s) { return s.present; }));
  device.move({0.03, -0.05, -1, true, true});  // no deeper than the plateau
  ASSERT_TRUE(
      recorder.wait_for([](const DeviceSample& s) { return std::abs(s.position_m.x - 0.03) < 1e-9; }));
  device.stop();
  const std::vector<DeviceSample> all = recorder.samples();
  std::size_t begun = 0;
  while (!all[begun].present || all[begun].position_m.x == 0.01) ++begun;
  ASSERT_GT(all.size(), begun + 20);
  // Each filter of 2 ms leaves two thirds of the way in a tick of 1 ms.
  for (int i = 1; i <= 20; ++i) {
    const double left = std::pow(2.0 / 3, i) * (1 + i / 3.0);
    const Vec3& at = all[begun + static_cast<std::size_t>(i) - 1].position_m;
    ASSERT_NEAR(at.x, 0.03 - 0.02 * left, 1e-12) << i;
    ASSERT_NEAR(at.y, -0.05 + 0.03 * left, 1e-12) << i;
    ASSERT_NEAR(at.z, PointerDevice::kHover_m * left, 1e-12) << i;
  }
}

TEST(PointerDevice, StartedAgainItsTipIsWhereThePointerIsNow) {
  Recorder before, after;  // they outlive the device, which stops at its end
  PointerDevice device;
  ASSERT_TRUE(device.start(before));
  device.move({-0.03, 0.01, 0.01, true, true});
  ASSERT_TRUE(before.wait_for([](const DeviceSample& s) { return s.position_m.z < -0.009; }));
  device.stop();
  device.move({0.02, 0.01, 0, false, true});
  ASSERT_TRUE(device.start(after));
  ASSERT_TRUE(after.wait_for([](const DeviceSample& s) { return s.present; }));
  for (const DeviceSample& s : after.samples()) {
    EXPECT_EQ(s.position_m.x, 0.02);
    EXPECT_EQ(s.position_m.z, PointerDevice::kHover_m);
  }
}

TEST(PointerDevice, IgnoresPositionsThatAreNotNumbers) {
  Recorder recorder;
  PointerDevice device;
  ASSERT_TRUE(device.start(recorder));
  device.move({0.01, 0.01, 0, false, true});
  ASSERT_TRUE(recorder.wait_for([](const DeviceSample& s) { return s.present; }));
  device.move({std::numeric_limits<double>::quiet_NaN(), 0, 0, true, true});
  ASSERT_TRUE(recorder.wait_for([](const DeviceSample& s) { return s.buttons == 1; }));
  device.stop();
  for (const DeviceSample& s : recorder.samples()) EXPECT_TRUE(std::isfinite(s.position_m.x));
}

}  // namespace
}  // namespace nazori::devices
