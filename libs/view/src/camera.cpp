// SPDX-License-Identifier: Apache-2.0
#include "nazori/view/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nazori::view {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

double finite_or(double value, double otherwise) { return std::isfinite(value) ? value : otherwise; }

/// In (-pi, pi].
double wrapped(double angle) {
  const double turned = std::remainder(angle, kTurn);
  return turned <= -std::numbers::pi ? turned + kTurn : turned;
}

}  // namespace

Camera within_limits(const Camera& camera, const geometry::TabletShape& shape) {
  const Camera fallback;
  const double half_m = shape.width_m / 2;
  Camera held;
  held.azimuth = wrapped(finite_or(camera.azimuth, fallback.azimuth));
  held.tilt = std::clamp(finite_or(camera.tilt, fallback.tilt), 0.0, Camera::kMaxTilt);
  held.zoom = std::clamp(finite_or(camera.zoom, fallback.zoom), Camera::kMinZoom, Camera::kMaxZoom);
  held.pan.x = std::clamp(finite_or(camera.pan.x, 0), -half_m, half_m);
  held.pan.y = std::clamp(finite_or(camera.pan.y, 0), -half_m, half_m);
  return held;
}

Camera between(const Camera& from, const Camera& to, double t) {
  Camera camera;
  camera.azimuth = wrapped(from.azimuth + wrapped(to.azimuth - from.azimuth) * t);
  camera.tilt = std::lerp(from.tilt, to.tilt, t);
  camera.zoom = from.zoom * std::pow(to.zoom / from.zoom, t);
  camera.pan = from.pan + (to.pan - from.pan) * t;
  return camera;
}

}  // namespace nazori::view
