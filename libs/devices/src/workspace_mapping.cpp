// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/workspace_mapping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace nazori::devices {
namespace {

using haptics::Vec3;

constexpr double kUpright = std::numbers::pi / 2;
constexpr double kLeastScale = 0.02, kMostScale = 50;
constexpr double kFarthestCentre_m = 2.0;
constexpr double kTiltSlack = 0.2;
constexpr double kMargin = 1.1;
constexpr double kLeastSide_m = 0.020;

bool finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// The tablet's axes in the device frame: R = Ry(yaw) Rx(tilt - upright) Rz(roll), one axis a column.
std::array<Vec3, 3> axes(const TabletPosture& posture, double roll) {
  const double yaw = posture.hand == WritingHand::right ? posture.yaw_rad : -posture.yaw_rad;
  const double lean = posture.tilt_rad - kUpright;
  const double ca = std::cos(yaw), sa = std::sin(yaw);
  const double cb = std::cos(lean), sb = std::sin(lean);
  const double cc = std::cos(roll), sc = std::sin(roll);
  const auto turned = [&](const Vec3& v) { return Vec3(ca * v.x + sa * v.z, v.y, -sa * v.x + ca * v.z); };
  return {turned({cc, cb * sc, sb * sc}), turned({-sc, cb * cc, sb * cc}), turned({0, -sb, cb})};
}

}  // namespace

base::Result<WorkspaceMapping> WorkspaceMapping::create(const WorkspaceCalibration& calibration) {
  const TabletPosture& posture = calibration.posture;
  const auto refuse = [](std::string what) {
    return base::fail(base::Errc::bad_argument, std::move(what), "calibration of the workspace",
                      "calibrate the device again, or use the automatic fit");
  };
  if (!std::isfinite(calibration.scale) || !finite(calibration.centre_m) ||
      !std::isfinite(posture.tilt_rad) || !std::isfinite(posture.yaw_rad) ||
      !std::isfinite(calibration.roll_rad))
    return refuse("it contains a value that is not a number");
  if (calibration.scale < kLeastScale || calibration.scale > kMostScale)
    return refuse("the scale must be between 0.02 and 50");
  if (glm::length(calibration.centre_m) > kFarthestCentre_m)
    return refuse("the tablet is more than 2 m away from the device");
  if (posture.tilt_rad < -kTiltSlack || posture.tilt_rad > kUpright + kTiltSlack)
    return refuse("the tilt must be between flat and upright");
  return WorkspaceMapping(calibration);
}

WorkspaceMapping::WorkspaceMapping(const WorkspaceCalibration& calibration) : calibration_(calibration) {
  const std::array<Vec3, 3> axis = axes(calibration.posture, calibration.roll_rad);
  x_ = axis[0];
  y_ = axis[1];
  z_ = axis[2];
}

Vec3 WorkspaceMapping::to_tablet_m(const Vec3& device_m) const noexcept {
  return calibration_.scale * to_tablet_n(device_m - calibration_.centre_m);
}
Vec3 WorkspaceMapping::to_device_m(const Vec3& tablet_m) const noexcept {
  return calibration_.centre_m + to_device_n(tablet_m) / calibration_.scale;
}
Vec3 WorkspaceMapping::to_tablet_n(const Vec3& device_n) const noexcept {
  return {glm::dot(x_, device_n), glm::dot(y_, device_n), glm::dot(z_, device_n)};
}
Vec3 WorkspaceMapping::to_device_n(const Vec3& tablet_n) const noexcept {
  return tablet_n.x * x_ + tablet_n.y * y_ + tablet_n.z * z_;
}

haptics::DeviceLimits WorkspaceMapping::to_tablet(haptics::DeviceLimits device) const noexcept {
  const double s = calibration_.scale;
  device.max_stiffness_n_m /= s;
  device.max_damping_n_s_m /= s;
  device.own_damping_n_s_m /= s;
  device.hand_damping_n_s_m /= s;
  return device;
}

WorkspaceCalibration fit_workspace(const DeviceWorkspace& workspace, const geometry::TabletShape& shape,
                                   const TabletPosture& posture) {
  DeviceWorkspace within = workspace;
  const Vec3 size = within.high_m - within.low_m;
  if (!finite(size) || size.x <= 0 || size.y <= 0 || size.z <= 0) within = {};
  const Vec3 room = within.high_m - within.low_m;
  const Vec3 middle = 0.5 * (within.low_m + within.high_m);

  const std::array<Vec3, 3> axis = axes(posture, 0);
  const Vec3 tablet(shape.width_m, shape.width_m, shape.depth_m + kRoomAbove_m);
  // The tablet's box seen along each axis of the device; the tightest one decides.
  const Vec3 needed =
      glm::abs(axis[0]) * tablet.x + glm::abs(axis[1]) * tablet.y + glm::abs(axis[2]) * tablet.z;
  const Vec3 ratio = kMargin * needed / room;

  WorkspaceCalibration fit;
  fit.posture = posture;
  fit.scale = std::clamp(std::max({ratio.x, ratio.y, ratio.z}), kLeastScale, kMostScale);
  // The plateau is not the middle of the needed space: there is more above it than below.
  fit.centre_m = middle - axis[2] * (0.5 * (kRoomAbove_m - shape.depth_m) / fit.scale);
  return fit;
}

base::Result<WorkspaceCalibration> calibrate_from_corners(const Vec3& bottom_left_m,
                                                          const Vec3& bottom_right_m, const Vec3& top_left_m,
                                                          const geometry::TabletShape& shape,
                                                          WritingHand hand) {
  const auto refuse = [](std::string what) {
    return base::fail(base::Errc::bad_argument, std::move(what), "calibration of the workspace",
                      "point at the bottom left, bottom right and top left corners of a square again");
  };
  if (!finite(bottom_left_m) || !finite(bottom_right_m) || !finite(top_left_m))
    return refuse("the device gave a position that is not a number");
  const Vec3 right = bottom_right_m - bottom_left_m, up = top_left_m - bottom_left_m;
  const double width = glm::length(right), height = glm::length(up);
  if (width < kLeastSide_m || height < kLeastSide_m) return refuse("the corners are less than 20 mm apart");
  if (std::max(width, height) > 1.5 * std::min(width, height))
    return refuse("the corners form a rectangle, not a square");
  if (std::abs(glm::dot(right, up)) > std::sin(std::numbers::pi / 9) * width * height)
    return refuse("the corners do not form a right angle");

  // The nearest right angle: both sides are turned by the same amount.
  const Vec3 along = right / width + up / height, across = right / width - up / height;
  const Vec3 x = glm::normalize(glm::normalize(along) + glm::normalize(across));
  const Vec3 y = glm::normalize(glm::normalize(along) - glm::normalize(across));
  const Vec3 z = glm::cross(x, y);

  WorkspaceCalibration found;
  found.scale = shape.width_m / (0.5 * (width + height));
  found.centre_m = bottom_left_m + 0.5 * (right + up);
  const double lean = std::asin(std::clamp(-z.y, -1.0, 1.0));
  double yaw = 0;
  if (std::abs(std::cos(lean)) > 1e-6) {
    yaw = std::atan2(z.x, z.z);
    found.roll_rad = std::atan2(x.y, y.y);
  } else {
    yaw = std::atan2(-x.z, x.x);  // lying flat, turning the tablet and turning the learner are the same
  }
  found.posture.tilt_rad = lean + kUpright;
  found.posture.yaw_rad = hand == WritingHand::right ? yaw : -yaw;
  found.posture.hand = hand;
  if (auto usable = WorkspaceMapping::create(found); !usable) return refuse(usable.error().what);
  return found;
}

}  // namespace nazori::devices
