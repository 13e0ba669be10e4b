// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "nazori/devices/workspace_mapping.h"
#include "pantograph_kinematics.h"
#include "pantograph_messages.h"

namespace nazori::devices::pantograph {

/// A version of the mechanism.
struct Model {
  std::string_view version;  ///< "3"
  std::string_view name;     ///< for people
  BoardSetup setup;          ///< first joint: the right motor, seen by the learner
  Linkage linkage;
};

/// The versions of the 2diy, newest first. @source README of HaplyHAPI 1.0.1 on PyPI: ports, directions, rest
/// and encoder steps; its class Pantograph: distance of the motors.
constexpr std::array<Model, 2> kModels{{
    {"3",
     "Haply 2diy, version 3 (plastic)",
     {{{{2, Turn::anticlockwise, Turn::anticlockwise, 168, 4880},
        {1, Turn::anticlockwise, Turn::anticlockwise, 12, 4880}}},
      false},
     {0.07, 0.09, 0.038}},
    {"2",
     "Haply 2diy, version 2 (metal plate)",
     {{{{2, Turn::anticlockwise, Turn::anticlockwise, 241, 10752},
        {1, Turn::clockwise, Turn::clockwise, -61, 10752}}},
      false},
     {0.07, 0.09, 0}},
}};

/// The part of the plane that is used: a square around a point in front of the motors, where no arm is nearly
/// stretched and every direction has kMostForce_n.
constexpr double kReach_m = 0.040;   ///< to each side
constexpr double kMiddle_m = 0.100;  ///< from the line of the motors
constexpr double kMostForce_n = 1.5;

/// Device frame: x right, y up on the tablet, which is away from the learner; the plane has no depth.
[[nodiscard]] inline Vec2 to_device_frame(const Linkage& linkage, const Vec2& handle_m) noexcept {
  return {linkage.motors_m / 2 - handle_m.x, kMiddle_m - handle_m.y};
}
/// The inverse, for forces.
[[nodiscard]] inline Vec2 to_linkage_frame(const haptics::Vec3& device_n) noexcept {
  return {-device_n.x, -device_n.y};
}

[[nodiscard]] DeviceWorkspace plane_workspace();

/// At the handle; without the delay, which is measured.
[[nodiscard]] haptics::DeviceLimits plane_limits();

}  // namespace nazori::devices::pantograph
