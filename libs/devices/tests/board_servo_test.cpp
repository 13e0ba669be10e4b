// SPDX-License-Identifier: Apache-2.0
// The servo's side of a pantograph, tick by tick, without a board and without a clock thread.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "felt_plane.h"
#include "pantograph_servo.h"
#include "pantograph_truth.h"

namespace nazori::devices::pantograph {
namespace {

using haptics::DeviceState;
using haptics::DeviceTrouble;
using test::Vec3;

/// Pushes to the right, and keeps the newest sample.
class Right final : public haptics::ServoCallback {
 public:
  Vec3 tick(const haptics::DeviceSample& sample) noexcept override {
    last = sample;
    ++ticks;
    return {0.5, 0, 0};
  }
  haptics::DeviceSample last;
  int ticks = 0;
};

constexpr double kScale = 2;  // of the tablet to the plane
constexpr double kHalfWidth_m = 0.050, kDepth_m = 0.010;

class BoardServoTicks : public testing::TestWithParam<bool> {
 protected:
  BoardServoTicks() {
    link.start(right);
    servo.start();
  }
  ~BoardServoTicks() override { link.stop(); }

  static Model model() {
    Model m = kModels[0];
    m.setup.has_button = GetParam();
    return m;
  }
  static WorkspaceMapping mapping() {
    WorkspaceCalibration c;
    c.scale = kScale;
    return *WorkspaceMapping::create(c);
  }
  /// The handle there, device frame; it does not expire when the machine pauses.
  static BoardPose at(double x_m, double y_m) {
    const Linkage& linkage = kModels[0].linkage;
    BoardPose pose;
    pose.number = 7;
    pose.angle_deg = *truth::angles_at(linkage, {linkage.motors_m / 2 - x_m, kMiddle_m - y_m});
    pose.state = DeviceState::running;
    pose.trouble = DeviceTrouble::none;
    pose.at = Clock::now() + std::chrono::hours(1);
    return pose;
  }
  BoardTorques answer_to(const BoardPose& pose) {
    servo.exchange.poses.back() = pose;
    servo.exchange.poses.publish();
    servo.tick();
    return servo.exchange.commands.latest();
  }
  haptics::DeviceStatus status_of(const BoardPose& pose) {
    return test::status_after(link, [&] { (void)answer_to(pose); });
  }
  [[nodiscard]] static bool is_limp(const BoardTorques& answer) {
    return answer.torque_n_m[0] == 0 && answer.torque_n_m[1] == 0;
  }
  /// Height of the tip above the plateau a number of ticks after it went from hovering to `to_m`: two
  /// low-pass filters of 8 ms in a row, each of which leaves 8/9 of the way in a tick of 1 ms.
  static double height_m(double to_m, int ticks) {
    constexpr double kHover_m = 0.005;
    const double left = std::pow(8.0 / 9, ticks) * (1 + ticks / 9.0);
    return to_m + (kHover_m - to_m) * left;
  }

  Right right;
  ServoLink link{"Arm", mapping(), {}};
  BoardServo servo{link, model(), 0.004, kHalfWidth_m, kDepth_m};  // planned with 4 ms
};

TEST_P(BoardServoTicks, TheTipComesDownThroughTwoLowPassFilters) {
  BoardPose pose = at(0.01, -0.02);
  pose.pressed = true;
  for (int i = 1; i <= 100; ++i) {
    (void)answer_to(pose);
    ASSERT_TRUE(right.last.present);
    // 15 % below the deepest groove.
    ASSERT_NEAR(right.last.position_m.z, height_m(-1.15 * kDepth_m, i), 1e-12) << i;
  }
  EXPECT_NEAR(right.last.position_m.x, kScale * 0.01, 1e-12);
  EXPECT_NEAR(right.last.position_m.y, kScale * -0.02, 1e-12);
  EXPECT_EQ(right.last.buttons, 1U);
  servo.start();
  (void)answer_to(pose);
  EXPECT_NEAR(right.last.position_m.z, height_m(-1.15 * kDepth_m, 1), 1e-12) << "it starts above";
}

TEST_P(BoardServoTicks, WithoutAButtonTheTipIsDownWithinTheTabletsEdges) {
  const bool has_button = GetParam();
  for (const auto& [x_m, y_m, within] : {std::tuple{0.0249, 0.0, true},
                                         {0.0251, 0.0, false},
                                         {-0.0249, 0.0, true},
                                         {-0.0251, 0.0, false},
                                         {0.0, 0.0249, true},
                                         {0.0, -0.0251, false}}) {
    servo.start();
    BoardPose pose = at(x_m, y_m);
    pose.pressed = false;
    for (int i = 0; i < 200; ++i) (void)answer_to(pose);
    EXPECT_NEAR(right.last.position_m.z, within && !has_button ? -1.15 * kDepth_m : 0.005, 1e-6)
        << x_m << " " << y_m;
    EXPECT_EQ(right.last.buttons, 0U);
  }
}

TEST_P(BoardServoTicks, AnswersWithTheTorquesThatTheDelayAllows) {
  BoardPose pose = at(0.01, 0.02);
  const Linkage& linkage = kModels[0].linkage;
  const PerJoint full =
      truth::torques_for(linkage, {linkage.motors_m / 2 - 0.01, kMiddle_m - 0.02}, {-0.5, 0});
  BoardTorques answer = answer_to(pose);
  EXPECT_EQ(answer.answers, 7U);
  EXPECT_NEAR(answer.torque_n_m[0], full[0], 1e-8);
  EXPECT_NEAR(answer.torque_n_m[1], full[1], 1e-8);
  // (T / 2 + 4 ms) / (T / 2 + 17.5 ms) is a quarter.
  pose.delay_s = 0.0175;
  answer = answer_to(pose);
  EXPECT_NEAR(answer.torque_n_m[0], full[0] / 4, 1e-8);
  EXPECT_NEAR(answer.torque_n_m[1], full[1] / 4, 1e-8);
  EXPECT_EQ(link.status().delay_s, 0.0175);
}

TEST_P(BoardServoTicks, APoseOfMoreThanTwentyMillisecondsIsNotFelt) {
  BoardPose pose = at(0, 0);
  pose.at = Clock::now() - std::chrono::microseconds(20'100);
  EXPECT_TRUE(is_limp(answer_to(pose)));
  EXPECT_EQ(servo.exchange.commands.latest().answers, 7U);
  EXPECT_FALSE(right.last.present);
  EXPECT_EQ(status_of(pose).trouble, DeviceTrouble::too_slow);
  EXPECT_EQ(status_of(pose).message.find("code"), std::string::npos);
  pose = at(0, 0);
  pose.delay_s = 0.0201;
  EXPECT_TRUE(is_limp(answer_to(pose)));
  EXPECT_EQ(status_of(pose).trouble, DeviceTrouble::too_slow);
  pose.delay_s = 0.0199;
  EXPECT_FALSE(is_limp(answer_to(pose)));
}

TEST_P(BoardServoTicks, AnglesThatNoHandleHasAreNotFelt) {
  BoardPose pose = at(0, 0);
  pose.angle_deg = {60, 120};  // crossed arms
  EXPECT_TRUE(is_limp(answer_to(pose)));
  EXPECT_EQ(status_of(pose).state, DeviceState::paused);
  EXPECT_EQ(status_of(pose).trouble, DeviceTrouble::not_at_rest);
  EXPECT_EQ(status_of(pose).message.find("code"), std::string::npos);
  EXPECT_FALSE(is_limp(answer_to(at(0, 0))));
}

TEST_P(BoardServoTicks, TroublePausesAndALossIsForEver) {
  BoardPose pose = at(0, 0);
  pose.state = DeviceState::paused;
  pose.trouble = DeviceTrouble::bad_message;
  pose.pressed = true;
  EXPECT_TRUE(is_limp(answer_to(pose)));
  EXPECT_EQ(status_of(pose).trouble, DeviceTrouble::bad_message);
  EXPECT_EQ(status_of(pose).buttons, 1U);
  EXPECT_FALSE(is_limp(answer_to(at(0, 0)))) << "it goes on by itself";
  pose.state = DeviceState::lost;
  EXPECT_TRUE(is_limp(answer_to(pose)));
  const int ticks = right.ticks;
  (void)answer_to(at(0, 0));
  EXPECT_EQ(right.ticks, ticks);
  EXPECT_EQ(link.status().state, DeviceState::lost);
  servo.start();
  EXPECT_EQ(servo.exchange.commands.latest().answers, 0U)
      << "an answer of the run before would be taken for a new one";
  EXPECT_FALSE(is_limp(answer_to(at(0, 0))));
}

INSTANTIATE_TEST_SUITE_P(Of, BoardServoTicks, testing::Bool(),
                         [](const auto& one) { return one.param ? "OneWithAButton" : "OneWithout"; });

}  // namespace
}  // namespace nazori::devices::pantograph
