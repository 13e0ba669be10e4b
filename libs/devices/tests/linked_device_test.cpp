// SPDX-License-Identifier: Apache-2.0
// The order in which a device with a link is started and stopped, and what it reports then.
#include "../src/linked_device.h"

#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <vector>

#include "felt_plane.h"

namespace nazori::devices {
namespace {

using haptics::DeviceState;
using test::comes_true;
using test::FeltPlane;

/// What the parts of a device were asked for, and how they answer.
struct Parts {
  std::vector<std::string> asked;  ///< by the thread of the test
  std::atomic<int> ticks{0};
  bool opens = true;
};

struct CountingServo {
  explicit CountingServo(Parts& parts) : parts_(&parts) {}
  void start() const { parts_->asked.emplace_back("servo"); }
  void tick() const noexcept { ++parts_->ticks; }
  Parts* parts_;
};

struct NotingLink {
  static constexpr ForceGuard::Off kWriteZero = nullptr;
  explicit NotingLink(Parts& parts) : parts_(&parts) {}
  base::Result<void> start() {
    parts_->asked.emplace_back("link");
    if (!parts_->opens) return base::fail(base::Errc::device, "it does not open", "link");
    running_ = true;
    return {};
  }
  void stop() noexcept {
    parts_->asked.emplace_back("stop");
    running_ = false;
  }
  [[nodiscard]] bool is_running() const noexcept { return running_; }
  Parts* parts_;
  bool running_ = false;
};

class LinkedDevices : public testing::Test {
 protected:
  Parts parts_;
  FeltPlane plane_;
  LinkedDevice<CountingServo, NotingLink> device_{
      "arm", limits(), *WorkspaceMapping::create(half_size()),
      [this](ServoLink& /*feeling*/) { return CountingServo(parts_); },
      [this](ServoLink& /*feeling*/, CountingServo& /*servo*/) { return NotingLink(parts_); }};

  static haptics::DeviceLimits limits() {
    haptics::DeviceLimits limits;
    limits.max_stiffness_n_m = 300;
    return limits;
  }
  static WorkspaceCalibration half_size() {
    WorkspaceCalibration calibration;
    calibration.scale = 0.5;
    return calibration;
  }
};

using Asked = std::vector<std::string>;

TEST_F(LinkedDevices, SayWhatTheyAreInTheTabletsFrame) {
  const haptics::DeviceDescription description = device_.describe();
  EXPECT_EQ(description.name, "arm");
  EXPECT_EQ(description.rate_hz, 1000);
  EXPECT_TRUE(description.has_force);
  EXPECT_EQ(description.limits.max_stiffness_n_m, 600);
  EXPECT_EQ(device_.status().state, DeviceState::stopped);
}

TEST_F(LinkedDevices, StartTheServoBeforeTheLinkAndTickUntilTheyStop) {
  ASSERT_TRUE(device_.start(plane_));
  EXPECT_EQ(parts_.asked, (Asked{"servo", "link"}));
  EXPECT_TRUE(comes_true([&] { return parts_.ticks > 3; }));
  device_.stop();
  EXPECT_EQ(parts_.asked, (Asked{"servo", "link", "stop"}));
  EXPECT_EQ(device_.status().state, DeviceState::stopped);
  const int ticks = parts_.ticks;
  device_.stop();
  EXPECT_EQ(parts_.asked.size(), 3U) << "stopped once";
  ASSERT_TRUE(device_.start(plane_));
  EXPECT_TRUE(comes_true([&] { return parts_.ticks > ticks; })) << "and again";
}

TEST_F(LinkedDevices, RunOnceAtATime) {
  ASSERT_TRUE(device_.start(plane_));
  const auto again = device_.start(plane_);
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().what, "the device is already running");
  EXPECT_EQ(again.error().where, "arm");
  EXPECT_EQ(parts_.asked, (Asked{"servo", "link"}));
}

TEST_F(LinkedDevices, ThatDoNotOpenAreStoppedAndTickNever) {
  parts_.opens = false;
  const auto started = device_.start(plane_);
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().what, "it does not open");
  EXPECT_EQ(parts_.asked, (Asked{"servo", "link", "stop"}));
  EXPECT_EQ(device_.status().state, DeviceState::stopped);
  EXPECT_EQ(parts_.ticks, 0);
  parts_.opens = true;
  EXPECT_TRUE(device_.start(plane_)) << "it may be tried again";
}

}  // namespace
}  // namespace nazori::devices
