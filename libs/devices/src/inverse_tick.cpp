// SPDX-License-Identifier: Apache-2.0
#include "inverse_servo.h"

namespace nazori::devices::inverse {
namespace {

using haptics::DeviceState;
using haptics::DeviceTrouble;

}  // namespace

void ArmServo::tick() noexcept {
  if (lost_) return;
  const ArmPose& pose = poses.latest();
  const auto now = Clock::now();
  ArmForce answer;
  answer.answers = pose.number;
  answer.at = now;
  const bool is_old = std::chrono::duration<double>(now - pose.at).count() > kTooSlow_s;
  if (pose.trouble != DeviceTrouble::none) {
    lost_ = pose.state == DeviceState::lost;
    link_.pause(pose.state, pose.trouble, 0, pose.buttons);
  } else if (is_old || pose.delay_s > kTooSlow_s) {
    link_.pause(DeviceState::paused, DeviceTrouble::too_slow, 0, pose.buttons);
  } else {
    link_.set_delay_s(pose.delay_s);
    answer.force_n =
        softened(kPeriod_s, planned_delay_s_, pose.delay_s) * link_.feel(pose.position_m, pose.buttons);
  }
  forces.back() = answer;
  forces.publish();
}

}  // namespace nazori::devices::inverse
