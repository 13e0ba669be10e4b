// SPDX-License-Identifier: Apache-2.0
// The servo's side of an Inverse3, tick by tick, without a service and without a clock thread.
#include <gtest/gtest.h>

#include <chrono>

#include "felt_plane.h"
#include "inverse_servo.h"

namespace nazori::devices::inverse {
namespace {

using haptics::DeviceState;
using haptics::DeviceTrouble;
using test::FeltPlane;
using test::Vec3;

class ArmServoTicks : public testing::Test {
 protected:
  ArmServoTicks() {
    link.start(plane);
    servo.start();
  }
  ~ArmServoTicks() override { link.stop(); }

  /// A pose 3 mm below the plateau that does not expire when the machine pauses.
  static ArmPose pressed() {
    ArmPose pose;
    pose.number = 7;
    pose.position_m = {0.01, 0.02, -0.003};
    pose.buttons = 2;
    pose.state = DeviceState::running;
    pose.trouble = DeviceTrouble::none;
    pose.at = Clock::now() + std::chrono::hours(1);
    return pose;
  }
  ArmForce answer_to(const ArmPose& pose) {
    servo.exchange.poses.back() = pose;
    servo.exchange.poses.publish();
    servo.tick();
    return servo.exchange.commands.latest();
  }
  haptics::DeviceStatus status_of(const ArmPose& pose) {
    return test::status_after(link, [&] { (void)answer_to(pose); });
  }
  void expect_paused(const ArmPose& pose, DeviceTrouble trouble) {
    EXPECT_EQ(answer_to(pose).force_n, Vec3(0));
    const haptics::DeviceStatus now = status_of(pose);
    EXPECT_EQ(now.state, DeviceState::paused);
    EXPECT_EQ(now.trouble, trouble);
    EXPECT_EQ(now.buttons, 2U);
    EXPECT_EQ(now.message.find("code"), std::string::npos);
  }

  FeltPlane plane;
  ServoLink link{"Arm", *WorkspaceMapping::create({}), {}};
  ArmServo servo{link, 0.004};  // planned with 4 ms
};

TEST_F(ArmServoTicks, AnswersThePoseThatItFelt) {
  const auto before = Clock::now();
  const ArmForce answer = answer_to(pressed());
  EXPECT_EQ(answer.answers, 7U);
  EXPECT_NEAR(answer.force_n.z, 0.6, 1e-12);  // 3 mm at 200 N/m
  EXPECT_EQ(answer.force_n.x, 0);
  EXPECT_GE(answer.at, before);
  EXPECT_LE(answer.at, Clock::now());
  EXPECT_EQ(plane.x_m, 0.01);
  EXPECT_EQ(plane.y_m, 0.02);
  EXPECT_EQ(plane.buttons, 2U);
  EXPECT_EQ(status_of(pressed()).state, DeviceState::running);
}

TEST_F(ArmServoTicks, AnswersALongerDelayWithTheForceThatItAllows) {
  ArmPose pose = pressed();
  pose.delay_s = 0.0175;
  // (T / 2 + 4 ms) / (T / 2 + 17.5 ms) is a quarter.
  EXPECT_NEAR(answer_to(pose).force_n.z, 0.15, 1e-12);
  EXPECT_EQ(link.status().delay_s, 0.0175);
}

TEST_F(ArmServoTicks, APoseOfMoreThanTwentyMillisecondsIsNotFelt) {
  ArmPose pose = pressed();
  pose.at = Clock::now() - std::chrono::microseconds(20'100);
  expect_paused(pose, DeviceTrouble::too_slow);
  EXPECT_EQ(servo.exchange.commands.latest().answers, 7U);
  pose = pressed();
  pose.delay_s = 0.0201;
  expect_paused(pose, DeviceTrouble::too_slow);
  EXPECT_EQ(plane.present, 0);
  pose.delay_s = 0.0199;
  EXPECT_GT(answer_to(pose).force_n.z, 0);
}

TEST_F(ArmServoTicks, TroublePausesAndALossIsForEver) {
  ArmPose pose = pressed();
  pose.state = DeviceState::paused;
  pose.trouble = DeviceTrouble::not_calibrated;
  expect_paused(pose, DeviceTrouble::not_calibrated);
  EXPECT_GT(answer_to(pressed()).force_n.z, 0) << "it goes on by itself";
  pose.state = DeviceState::lost;
  pose.trouble = DeviceTrouble::service_gone;
  EXPECT_EQ(answer_to(pose).force_n, Vec3(0));
  EXPECT_EQ(link.status().state, DeviceState::lost);
  const int ticks = plane.ticks;
  (void)answer_to(pressed());
  EXPECT_EQ(plane.ticks, ticks);
  EXPECT_EQ(link.status().state, DeviceState::lost);
  servo.start();
  EXPECT_EQ(servo.exchange.commands.latest().answers, 0U)
      << "an answer of the run before would be taken for a new one";
  EXPECT_GT(answer_to(pressed()).force_n.z, 0);
}

}  // namespace
}  // namespace nazori::devices::inverse
