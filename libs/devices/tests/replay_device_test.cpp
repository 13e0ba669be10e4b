// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/replay_device.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace nazori::devices {
namespace {

using haptics::DeviceSample;
using haptics::Vec3;

class Counter final : public haptics::ServoCallback {
 public:
  Vec3 tick(const DeviceSample& sample) noexcept override {
    if (sample.present) {
      ordered = ordered && sample.time_s > last;
      last = sample.time_s;
      ++present;
    } else {
      ++absent;
    }
    return sample.position_m;
  }
  std::atomic<int> present{0}, absent{0};
  double last = -1;
  bool ordered = true;
};

std::vector<DeviceSample> recording(int count) {
  std::vector<DeviceSample> samples;
  samples.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) samples.push_back({0.001 * i, {0.001 * i, 0, 0}, 0, true});
  return samples;
}

TEST(ReplayDevice, GivesEverySampleOnceInOrder) {
  ReplayDevice device(recording(50), {});
  Counter servo;
  for (int i = 0; i < 50; ++i) {
    EXPECT_FALSE(device.finished());
    EXPECT_EQ(device.step(servo).x, 0.001 * i);
  }
  EXPECT_TRUE(device.finished());
  EXPECT_EQ(device.step(servo), Vec3(0));
  EXPECT_EQ(servo.present, 50);
  EXPECT_TRUE(servo.ordered);
  device.rewind();
  EXPECT_FALSE(device.finished());
}

TEST(ReplayDevice, InRealTimeTheStylusIsGoneAfterTheEnd) {
  ReplayDevice device(recording(20), {});
  Counter servo;
  ASSERT_TRUE(device.start(servo));
  while (servo.absent < 3) {
  }
  device.stop();
  EXPECT_EQ(servo.present, 20);
  EXPECT_TRUE(device.finished());
}

TEST(ReplayDevice, AfterTheEndTimeGoesOnAPeriodATick) {
  constexpr int kMost = 3;
  struct Times final : haptics::ServoCallback {
    Vec3 tick(const DeviceSample& sample) noexcept override {
      if (!sample.present && count < kMost) gone[static_cast<std::size_t>(count++)] = sample;
      return Vec3(0);
    }
    std::array<DeviceSample, kMost> gone;
    std::atomic<int> count{0};
  };
  haptics::DeviceDescription description;
  description.rate_hz = 500;
  ReplayDevice device(recording(20), description);
  for (int again = 0; again < 2; ++again) {
    Times servo;
    ASSERT_TRUE(device.start(servo));
    while (servo.count < kMost) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    device.stop();
    for (int i = 0; i < kMost; ++i) {
      const DeviceSample& s = servo.gone[static_cast<std::size_t>(i)];
      EXPECT_NEAR(s.time_s, 0.019 + 0.002 * (i + 1), 1e-12);
      EXPECT_EQ(s.position_m.x, 0.019) << "where it was last";
    }
    device.rewind();
  }
}

TEST(ReplayDevice, AnEmptyRecordingIsFinishedAtOnce) {
  ReplayDevice device({}, {});
  Counter servo;
  EXPECT_TRUE(device.finished());
  EXPECT_EQ(device.step(servo), Vec3(0));
  EXPECT_EQ(servo.present + servo.absent, 0);
}

}  // namespace
}  // namespace nazori::devices
