// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "pantograph_servo.h"

namespace nazori::devices::pantograph {
namespace {

using haptics::DeviceState;
using haptics::DeviceTrouble;
using haptics::Vec3;

constexpr double kHover_m = 0.005;  // of the tip above the plateau
constexpr double kDeepest = 1.15;   // below the deepest groove: the tip touches the bottom
constexpr double kHand_s =
    0.008;  // two low-pass filters: because a button has no position between up and down

}  // namespace

void BoardServo::start() noexcept {
  halfway_m_ = height_m_ = kHover_m;
  exchange.reset();
}

Vec3 BoardServo::tip(const LinkagePose& pose, bool pressed) noexcept {
  const WorkspaceMapping& mapping = link_.mapping();
  const WorkspaceCalibration& fit = mapping.calibration();
  const Vec2 plane = to_device_frame(linkage_, pose.handle_m);
  Vec3 at(plane.x, plane.y, fit.centre_m.z);
  const Vec3 on_tablet = mapping.to_tablet_m(at);
  const bool within = std::max(std::abs(on_tablet.x), std::abs(on_tablet.y)) <= half_width_m_;
  const double target = (has_button_ ? pressed : within) ? -kDeepest * depth_m_ : kHover_m;
  constexpr double kPass = kLinkPeriod_s / (kLinkPeriod_s + kHand_s);
  halfway_m_ += (target - halfway_m_) * kPass;
  height_m_ += (halfway_m_ - height_m_) * kPass;
  at.z += height_m_ / fit.scale;
  return at;
}

void BoardServo::tick() noexcept {
  if (exchange.is_lost()) return;
  const BoardPose& pose = exchange.poses.latest();
  BoardTorques& answer = exchange.commands.back();
  answer = {};
  answer.answers = pose.number;
  answer.at = Clock::now();
  const std::uint32_t buttons = pose.pressed ? 1U : 0U;
  if (!exchange.pauses(link_, pose, answer.at, buttons)) {
    const LinkagePose arms = pose_at(linkage_, pose.angle_deg);
    if (arms.kind != PoseKind::regular) {
      // The handle cannot be here with correct angles, so it was not at rest when the board was set up.
      link_.pause(DeviceState::paused, DeviceTrouble::not_at_rest, 0, buttons);
    } else {
      link_.set_delay_s(pose.delay_s);
      const Vec3 force = link_.feel(tip(arms, pose.pressed), buttons);
      answer.torque_n_m =
          torques_for(arms, softened(kLinkPeriod_s, planned_delay_s_, pose.delay_s) * to_linkage_frame(force),
                      kMostTorque_n_m);
    }
  }
  exchange.commands.publish();
}

}  // namespace nazori::devices::pantograph
