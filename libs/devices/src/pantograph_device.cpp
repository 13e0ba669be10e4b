// SPDX-License-Identifier: Apache-2.0
#include "pantograph_device.h"

#include <string>
#include <utility>

#include "linked_device.h"
#include "pantograph_link.h"

namespace nazori::devices::pantograph {
DeviceWorkspace plane_workspace() {
  return {{-kReach_m, -kReach_m, -kReach_m}, {kReach_m, kReach_m, kReach_m}};
}

haptics::DeviceLimits plane_limits() {
  haptics::DeviceLimits limits;
  limits.max_force_n = kMostForce_n;
  // The maker publishes neither the continuous force nor the stable stiffness: cautious estimates.
  limits.continuous_force_n = kMostForce_n / 2;
  limits.max_stiffness_n_m = 400;
  limits.max_damping_n_s_m = 1;
  return limits;
}

std::unique_ptr<haptics::HapticDevice> pantograph_device(OpenBoard board, const WorkspaceMapping& mapping,
                                                         const geometry::TabletShape& shape) {
  return std::make_unique<LinkedDevice<BoardServo, BoardLink>>(
      std::string(board.model.name), board.limits, mapping,
      [&](ServoLink& feeling) {
        return BoardServo(feeling, board.model, board.limits.delay_s, shape.width_m / 2, shape.depth_m);
      },
      [&](ServoLink& feeling, BoardServo& servo) {
        return BoardLink(std::move(board.port), board.model.setup, board.give_up_s, feeling, servo);
      });
}

}  // namespace nazori::devices::pantograph
