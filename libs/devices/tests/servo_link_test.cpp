// SPDX-License-Identifier: Apache-2.0
#include "servo_link.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "felt_plane.h"

namespace nazori::devices {
namespace {

using haptics::DeviceState;
using haptics::DeviceTrouble;
using test::Push;
using test::Vec3;

/// Keeps the newest sample, and pushes.
class Witness final : public haptics::ServoCallback {
 public:
  explicit Witness(const Vec3& force_n) : force_n_(force_n) {}
  Vec3 tick(const haptics::DeviceSample& sample) noexcept override {
    last = sample;
    ++ticks;
    return force_n_;
  }
  haptics::DeviceSample last;
  int ticks = 0;

 private:
  Vec3 force_n_;
};

WorkspaceMapping upright(double scale = 1) {
  WorkspaceCalibration c;
  c.scale = scale;
  return *WorkspaceMapping::create(c);
}
haptics::DeviceLimits up_to(double force_n) {
  haptics::DeviceLimits limits;
  limits.max_force_n = force_n;
  return limits;
}

TEST(ServoLink, AForceOverThePeakIsHeldToItInItsDirection) {
  ServoLink link("Arm", upright(), up_to(2));
  Push strong({3, 0, -4});
  link.start(strong);
  const Vec3 force = link.feel({0, 0, 0}, 0);
  EXPECT_NEAR(force.x, 1.2, 1e-12);
  EXPECT_NEAR(force.z, -1.6, 1e-12);
  link.stop();
  Push weak({0.6, 0, -0.8});
  link.start(weak);
  EXPECT_EQ(link.feel({0, 0, 0}, 0), Vec3(0.6, 0, -0.8));
  link.stop();
}

TEST(ServoLink, AForceThatIsNoNumberIsNone) {
  for (const double odd :
       {std::nan(""), std::numeric_limits<double>::infinity(), std::numeric_limits<double>::max()}) {
    ServoLink link("Arm", upright(), up_to(2));
    Push push({odd, 0, 0});
    link.start(push);
    EXPECT_EQ(link.feel({0, 0, 0}, 0), Vec3(0)) << odd;
    link.stop();
  }
}

TEST(ServoLink, APositionThatIsNoNumberIsAnAbsentStylusWhereItWasLast) {
  ServoLink link("Arm", upright(0.5), up_to(2));
  Witness servo({0, 0, 1});
  link.start(servo);
  (void)link.feel({0.02, 0.04, 0.06}, 5);
  EXPECT_TRUE(servo.last.present);
  EXPECT_EQ(servo.last.position_m, Vec3(0.01, 0.02, 0.03));
  EXPECT_EQ(servo.last.buttons, 5U);
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 odd(0.1, 0.1, 0.1);
    odd[axis] = std::nan("");
    const int ticks = servo.ticks;
    EXPECT_EQ(link.feel(odd, 2), Vec3(0));
    EXPECT_EQ(servo.ticks, ticks + 1);
    EXPECT_FALSE(servo.last.present);
    EXPECT_EQ(servo.last.position_m, Vec3(0.01, 0.02, 0.03));
    EXPECT_EQ(servo.last.buttons, 2U);
    const haptics::DeviceStatus now = test::status_after(link, [&] { (void)link.feel(odd, 2); });
    EXPECT_EQ(now.state, DeviceState::paused);
    EXPECT_EQ(now.trouble, DeviceTrouble::bad_message);
  }
  link.stop();
}

TEST(ServoLink, TheStatusIsThatOfTheLastTick) {
  ServoLink link("Arm", upright(), up_to(2));
  EXPECT_EQ(link.status().state, DeviceState::stopped);
  Push push({0, 0, 1});
  EXPECT_EQ(test::status_after(link, [&] { link.start(push); }).state, DeviceState::running);
  link.set_delay_s(0.003);
  haptics::DeviceStatus now = test::status_after(link, [&] { (void)link.feel({0, 0, 0}, 6); });
  EXPECT_EQ(now.state, DeviceState::running);
  EXPECT_EQ(now.trouble, DeviceTrouble::none);
  EXPECT_EQ(now.message, "");
  EXPECT_EQ(now.buttons, 6U);
  EXPECT_EQ(now.delay_s, 0.003);
  EXPECT_GT(now.rate_hz, 0);
  now = test::status_after(link,
                           [&] { link.pause(DeviceState::paused, DeviceTrouble::warm_motors, 0x301, 1); });
  EXPECT_EQ(now.state, DeviceState::paused);
  EXPECT_EQ(now.message,
            "Arm: its motors are too warm (code 0x301) (put the stylus down for a few minutes; it resumes by "
            "itself)");
  EXPECT_EQ(now.buttons, 1U);
  EXPECT_EQ(now.delay_s, 0.003);
  link.stop();
  EXPECT_EQ(link.status().state, DeviceState::stopped);
  EXPECT_EQ(link.status().trouble, DeviceTrouble::none);
  link.start(push);
  EXPECT_EQ(link.status().delay_s, 0) << "that of the run before";
  link.stop();
}

TEST(ServoLink, ALostDeviceStaysLostWhenItIsStopped) {
  ServoLink link("Arm", upright(), up_to(2));
  Push push({0, 0, 1});
  link.start(push);
  link.pause(DeviceState::lost, DeviceTrouble::device_fault, -3, 0);
  link.stop();
  EXPECT_EQ(link.status().state, DeviceState::lost);
  EXPECT_EQ(link.status().message,
            "Arm: it reports a fault (code -3) (switch it off and on, then select it again)");
  EXPECT_EQ(test::status_after(link, [&] { link.start(push); }).state, DeviceState::running);
  link.stop();
}

TEST(ServoLink, AServoThatTicksNoMoreIsToldByItsStatus) {
  ServoLink link("Arm", upright(), up_to(2));
  Push push({0, 0, 1});
  for (const bool paused : {false, true}) {
    link.start(push);
    if (paused)
      link.pause(DeviceState::paused, DeviceTrouble::docked, 0, 0);
    else
      (void)link.feel({0, 0, 0}, 0);
    haptics::DeviceStatus seen;
    EXPECT_TRUE(test::comes_true([&] {
      seen = link.status();
      return seen.trouble == DeviceTrouble::stalled;
    }));
    EXPECT_EQ(seen.state, DeviceState::lost);
    EXPECT_EQ(seen.rate_hz, 0);
    link.stop();
    EXPECT_EQ(link.status().state, DeviceState::stopped);
  }
}

TEST(ServoLink, ADelayIsSmoothedOverSomeTwentyMeasurements) {
  EXPECT_EQ(smoothed_delay_s(0, 0.004), 0.004) << "the first";
  EXPECT_NEAR(smoothed_delay_s(0.004, 0.006), 0.0041, 1e-15);
  // After twenty measurements 0.95^20 of a step remains, about 1/e.
  double delay_s = 0.010;
  for (int i = 0; i < 20; ++i) delay_s = smoothed_delay_s(delay_s, 0.002);
  EXPECT_NEAR((delay_s - 0.002) / 0.008, std::exp(-1), 0.01);
  ServoLink link("Arm", upright(), up_to(2));
  Push push({0, 0, 1});
  link.start(push);
  link.note_delay_s(0.004);
  link.note_delay_s(0.006);
  (void)link.feel({0, 0, 0}, 0);
  EXPECT_NEAR(link.status().delay_s, 0.0041, 1e-15);
  link.stop();
}

TEST(ServoLink, ALongerDelayThanPlannedLeavesTheStiffnessThatItAllows) {
  // b > K (T / 2 + delay): at 1 kHz with no delay half a millisecond counts, with 1 ms three times as much.
  EXPECT_NEAR(softened(0.001, 0, 0.001), 1.0 / 3, 1e-12);
  EXPECT_NEAR(softened(0.001, 0.001, 0.004), 1.0 / 3, 1e-12);
  EXPECT_NEAR(softened(0.001, 0.0045, 0.0095), 0.5, 1e-12);
  EXPECT_EQ(softened(0.001, 0.004, 0.004), 1);
  EXPECT_EQ(softened(0.001, 0.004, 0.001), 1) << "never more than planned";
}

TEST(TroubleError, CodesAreWrittenAsInTheMakersManuals) {
  const auto line = [](DeviceTrouble trouble, std::int32_t code) {
    return base::to_line(trouble_error(trouble, "Arm", code));
  };
  EXPECT_EQ(line(DeviceTrouble::init_failed, 0), "Arm: it does not start (switch it off and on again)");
  EXPECT_NE(line(DeviceTrouble::init_failed, 0x10).find("(code 0x10)"), std::string::npos);
  EXPECT_NE(line(DeviceTrouble::init_failed, 0x1a2f).find("(code 0x1a2f)"), std::string::npos);
  EXPECT_NE(line(DeviceTrouble::init_failed, -12).find("(code -12)"), std::string::npos);
}

TEST(TroubleError, EveryTroubleAndEveryCauseOfForcesOffHasASentenceOfItsOwn) {
  std::set<std::string> lines;
  int count = 0;
  for (auto t = static_cast<int>(DeviceTrouble::none); t <= static_cast<int>(DeviceTrouble::bad_message);
       ++t) {
    if (t == static_cast<int>(DeviceTrouble::forces_off)) continue;
    const std::string line = base::to_line(trouble_error(static_cast<DeviceTrouble>(t), "Arm", 0));
    EXPECT_EQ(line.find("unknown"), std::string::npos) << t;
    lines.insert(line);
    ++count;
  }
  for (auto c = static_cast<int>(ForcesOff::unknown); c <= static_cast<int>(ForcesOff::grip_switch); ++c) {
    const std::string line = base::to_line(trouble_error(DeviceTrouble::forces_off, "Arm", c));
    EXPECT_EQ(line.find("code"), std::string::npos) << "it has been said in words";
    lines.insert(line);
    ++count;
  }
  EXPECT_EQ(lines.size(), static_cast<std::size_t>(count));
}

}  // namespace
}  // namespace nazori::devices
