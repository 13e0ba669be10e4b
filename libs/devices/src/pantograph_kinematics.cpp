// SPDX-License-Identifier: Apache-2.0
#include "pantograph_kinematics.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace nazori::devices::pantograph {
namespace {

/// A quarter turn from x towards y.
Vec2 turned(const Vec2& v) noexcept { return {-v.y, v.x}; }

double cross(const Vec2& a, const Vec2& b) noexcept { return a.x * b.y - a.y * b.x; }

bool finite(const Vec2& v) noexcept { return std::isfinite(v.x) && std::isfinite(v.y); }

}  // namespace

LinkagePose pose_at(const Linkage& linkage, const PerJoint& angle_deg) noexcept {
  LinkagePose pose;
  if (!std::isfinite(angle_deg[0]) || !std::isfinite(angle_deg[1])) return pose;
  const auto arm = [&](double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return linkage.inner_m * Vec2(std::cos(angle), std::sin(angle));
  };
  const Vec2 first_arm = arm(angle_deg[0]), second_arm = arm(angle_deg[1]);
  const Vec2 first_elbow = first_arm, second_elbow = Vec2(linkage.motors_m, 0) + second_arm;

  // The outer arms and the line between the elbows are an isosceles triangle.
  const Vec2 between = second_elbow - first_elbow;
  const double half = glm::length(between) / 2;
  if (half >= linkage.outer_m) return pose;
  const double height = std::sqrt(linkage.outer_m * linkage.outer_m - half * half);
  const double sine = 2 * half * height / (linkage.outer_m * linkage.outer_m);
  if (!(sine >= kLeastSine)) {
    pose.kind = PoseKind::singular;
    return pose;
  }
  const Vec2 handle = first_elbow + between / 2.0 + turned(between) * (height / (2 * half));
  if (!(handle.y > 0)) {
    pose.kind = PoseKind::behind;
    return pose;
  }
  pose.kind = PoseKind::regular;
  pose.handle_m = handle;

  // The handle moves along an outer arm as fast as that arm's elbow does: u . P' = u . A', v . P' = v . B'.
  const Vec2 u = (pose.handle_m - first_elbow) / linkage.outer_m;
  const Vec2 v = (pose.handle_m - second_elbow) / linkage.outer_m;
  const double determinant = cross(u, v);
  pose.per_first_m = Vec2(v.y, -v.x) * (glm::dot(u, turned(first_arm)) / determinant);
  pose.per_second_m = Vec2(-u.y, u.x) * (glm::dot(v, turned(second_arm)) / determinant);
  return pose;
}

PerJoint torques_for(const LinkagePose& pose, const Vec2& force_n, double most_n_m) noexcept {
  if (pose.kind != PoseKind::regular || !finite(force_n)) return {0, 0};
  const Vec2 torque(glm::dot(pose.per_first_m, force_n), glm::dot(pose.per_second_m, force_n));
  const double larger = std::max(std::abs(torque.x), std::abs(torque.y));
  if (!std::isfinite(larger)) return {0, 0};
  if (larger <= most_n_m) return {torque.x, torque.y};
  return {torque.x / larger * most_n_m, torque.y / larger * most_n_m};  // never more, not even by rounding
}

double force_in_every_direction_n(const LinkagePose& pose, double most_n_m) noexcept {
  const double longer = std::max(glm::length(pose.per_first_m), glm::length(pose.per_second_m));
  return pose.kind == PoseKind::regular && longer > 0 ? most_n_m / longer : 0;
}

}  // namespace nazori::devices::pantograph
