// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

#include "pantograph_messages.h"

/// The five-bar linkage of a pantograph: two motors in a line, an inner arm on each, and two outer arms that
/// meet at the handle. All of it is real-time-safe.
namespace nazori::devices::pantograph {

/// Metres or newtons in the plane of the arms. The origin is the axis of the first motor. The x axis points
/// to the second motor, the y axis to the handle. The learner sits on the side of the handle: x points to the
/// learner's left, y towards the learner.
using Vec2 = glm::dvec2;

/// Lengths of the arms, the same on both sides. @source HaplyHAPI 1.0.1 on PyPI, class Pantograph.
struct Linkage {
  double inner_m = 0.07;
  double outer_m = 0.09;
  double motors_m = 0;  ///< from one motor's axis to the other's
};

/// Whether the handle has one position and forces in both directions.
enum class PoseKind : std::uint8_t {
  regular,
  singular,  ///< the outer arms lie in a line or on each other: torques cannot control the handle
  apart,     ///< the inner arms are too far from each other for the outer ones to meet
  behind,    ///< the handle would be behind the motors, where the arms cannot reach
};

/// The position of the handle and its derivatives by the motors' angles. All zero where the pose is not
/// regular.
struct LinkagePose {
  PoseKind kind = PoseKind::apart;
  Vec2 handle_m{0, 0};
  Vec2 per_first_m{0, 0};   ///< derivative of handle_m by the first motor's angle [m/rad]
  Vec2 per_second_m{0, 0};  ///< the same by the second's
};

/// Poses where the outer arms meet at an angle whose sine is smaller count as singular.
constexpr double kLeastSine = 0.2;

/// Forward kinematics. @param angle_deg  of the inner arms, from x towards y. Not finite: apart.
[[nodiscard]] LinkagePose pose_at(const Linkage& linkage, const PerJoint& angle_deg) noexcept;

/// The torques that give the force `force_n` at the handle: the transposed Jacobian. Where a motor would need
/// more than `most_n_m`, both are reduced in proportion, so that the direction is kept.
/// @return zero for a pose that is not regular or a force that is not finite.
[[nodiscard]] PerJoint torques_for(const LinkagePose& pose, const Vec2& force_n, double most_n_m) noexcept;

/// The largest force that the motors can give in every direction, with `most_n_m` each; 0 where the pose is
/// not regular.
[[nodiscard]] double force_in_every_direction_n(const LinkagePose& pose, double most_n_m) noexcept;

}  // namespace nazori::devices::pantograph
