// SPDX-License-Identifier: Apache-2.0
#include "camera_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nazori::ui::camera_motion {
namespace {

constexpr double kTurnPerPixel = 0.006;
constexpr double kPanLimit_m = 0.06;

view::Camera held(view::Camera camera) {
  camera.tilt = std::clamp(camera.tilt, 0.0, kMaxTilt);
  camera.azimuth = std::remainder(camera.azimuth, 2 * std::numbers::pi);
  camera.zoom = std::clamp(camera.zoom, kMinZoom, kMaxZoom);
  camera.pan.x = std::clamp(camera.pan.x, -kPanLimit_m, kPanLimit_m);
  camera.pan.y = std::clamp(camera.pan.y, -kPanLimit_m, kPanLimit_m);
  return camera;
}

}  // namespace

view::Camera orbit(view::Camera camera, glm::dvec2 drag) {
  camera.azimuth += drag.x * kTurnPerPixel;
  camera.tilt -= drag.y * kTurnPerPixel;
  return held(camera);
}

view::Camera pan(view::Camera camera, geometry::TabletPoint grabbed, geometry::TabletPoint now) {
  camera.pan = camera.pan + (grabbed - now);
  return held(camera);
}

view::Camera zoom(view::Camera camera, double factor) {
  camera.zoom *= factor;
  return held(camera);
}

view::Camera between(const view::Camera& from, const view::Camera& to, double share) {
  const auto mix = [share](double a, double b) { return a + (b - a) * share; };
  view::Camera camera;
  // The short way round.
  camera.azimuth = from.azimuth + std::remainder(to.azimuth - from.azimuth, 2 * std::numbers::pi) * share;
  camera.tilt = mix(from.tilt, to.tilt);
  camera.zoom = std::exp(mix(std::log(from.zoom), std::log(to.zoom)));
  camera.pan = {mix(from.pan.x, to.pan.x), mix(from.pan.y, to.pan.y)};
  return camera;
}

view::Camera home() { return {}; }

}  // namespace nazori::ui::camera_motion
