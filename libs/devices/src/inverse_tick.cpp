// SPDX-License-Identifier: Apache-2.0
#include "inverse_servo.h"

namespace nazori::devices::inverse {
void ArmServo::tick() noexcept {
  if (exchange.is_lost()) return;
  const ArmPose& pose = exchange.poses.latest();
  ArmForce& answer = exchange.commands.back();
  answer = {};
  answer.answers = pose.number;
  answer.at = Clock::now();
  if (!exchange.pauses(link_, pose, answer.at, pose.buttons)) {
    link_.set_delay_s(pose.delay_s);
    answer.force_n =
        softened(kLinkPeriod_s, planned_delay_s_, pose.delay_s) * link_.feel(pose.position_m, pose.buttons);
  }
  exchange.commands.publish();
}

}  // namespace nazori::devices::inverse
