// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>
#include <optional>

#include "pantograph_kinematics.h"

/// Inverse kinematics of the pantograph: angles by the law of cosines from the position of the handle. It
/// shares only the lengths with the code under test.
namespace nazori::devices::pantograph::truth {

constexpr double kDegree = std::numbers::pi / 180;

/// The angle of one inner arm that reaches to the handle with its elbow outwards; nothing out of reach.
/// @param outwards  +1: the elbow lies to the left of the way from the motor to the handle.
inline std::optional<double> arm_deg(const Linkage& linkage, const Vec2& from_motor_m, int outwards) {
  const double l = linkage.inner_m, o = linkage.outer_m, r = std::hypot(from_motor_m.x, from_motor_m.y);
  const double cosine = (l * l + r * r - o * o) / (2 * l * r);
  if (!(std::abs(cosine) <= 1)) return std::nullopt;
  return (std::atan2(from_motor_m.y, from_motor_m.x) + outwards * std::acos(cosine)) / kDegree;
}

/// The angles with which the handle is at `handle_m`.
inline std::optional<PerJoint> angles_at(const Linkage& linkage, const Vec2& handle_m) {
  const auto first = arm_deg(linkage, handle_m, +1);
  const auto second = arm_deg(linkage, handle_m - Vec2(linkage.motors_m, 0), -1);
  if (!first || !second) return std::nullopt;
  return PerJoint{*first, *second};
}

/// The torques that hold `force_n` at `handle_m`, by virtual work: how far the angles turn when the handle is
/// moved a little along x and along y says how far it moves when they turn.
inline PerJoint torques_for(const Linkage& linkage, const Vec2& handle_m, const Vec2& force_n) {
  constexpr double kStep_m = 1e-6;
  const auto turn = [&](const Vec2& step) {
    const PerJoint after = *angles_at(linkage, handle_m + step),
                   before = *angles_at(linkage, handle_m - step);
    return Vec2(after[0] - before[0], after[1] - before[1]) * (kDegree / (2 * kStep_m));
  };
  const Vec2 by_x = turn({kStep_m, 0}), by_y = turn({0, kStep_m});
  // f . dP = t . dA for every dP: by_x . t = f.x and by_y . t = f.y.
  const double determinant = by_x.x * by_y.y - by_x.y * by_y.x;
  return {(force_n.x * by_y.y - by_x.y * force_n.y) / determinant,
          (by_x.x * force_n.y - force_n.x * by_y.x) / determinant};
}

}  // namespace nazori::devices::pantograph::truth
