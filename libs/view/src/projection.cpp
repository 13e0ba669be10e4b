// SPDX-License-Identifier: Apache-2.0
#include "projection.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace nazori::view {
namespace {

/// Half the vertical field of view. Classic: 40 degrees as in 2005; otherwise a calmer 26.
constexpr double kClassicHalfView = 20.0 * std::numbers::pi / 180.0;
constexpr double kHalfView = 13.0 * std::numbers::pi / 180.0;
/// Share of the view's smaller side that the board fills at zoom 1, seen from above.
constexpr double kFill = 0.87;

/// The view shows the full field of view across its smaller side, so that a tall window does not cut the
/// tablet off. Zooming is a crop around the middle: the perspective does not change.
glm::dmat4 lens(double half_view, double zoom, int width, int height, double near_m, double far_m) {
  const double focal = zoom / std::tan(half_view);
  const double smaller = std::min(width, height);
  glm::dmat4 clip(0);
  clip[0][0] = focal * smaller / width;
  clip[1][1] = focal * smaller / height;
  clip[2][2] = -(far_m + near_m) / (far_m - near_m);
  clip[2][3] = -1;
  clip[3][2] = -2 * far_m * near_m / (far_m - near_m);
  return clip;
}

/// Turns the tablet so that the camera's azimuth and tilt look straight down the view's -z.
glm::dmat4 turned(const Camera& camera) {
  const glm::dmat4 tilt = glm::rotate(glm::dmat4(1), -camera.tilt, glm::dvec3(1, 0, 0));
  return glm::rotate(tilt, -camera.azimuth, glm::dvec3(0, 0, 1));
}

/// The model transform of 2005, translate(-1, -1, -0.5) then scale(2/124), for a grid of 128 samples whose
/// vertices are (x, 128 - y, 0.05 * height).
glm::dmat4 classic_world_from_tablet(const geometry::TabletShape& shape) {
  constexpr double kScale = 2.0 / 124.0;
  constexpr double kPlateau = 255 * 0.05;
  const double grid_per_m = 127.0 / shape.width_m;
  const double levels_per_m = kPlateau / shape.depth_m;
  glm::dmat4 world(1);
  world[0][0] = world[1][1] = grid_per_m * kScale;
  world[2][2] = levels_per_m * kScale;
  world[3] = {63.5 * kScale - 1, 64.5 * kScale - 1, kPlateau * kScale - 0.5, 1};
  return world;
}

}  // namespace

glm::dvec2 Projection::pixel(glm::dvec3 point_m) const {
  const glm::dvec4 clip = clip_from_tablet * glm::dvec4(point_m, 1);
  return {(clip.x / clip.w + 1) / 2 * width, (1 - clip.y / clip.w) / 2 * height};
}

std::optional<geometry::TabletPoint> Projection::on_plane(glm::dvec2 pixel, double z_m) const {
  const glm::dmat4 tablet_from_clip = glm::inverse(clip_from_tablet);
  const glm::dvec4 far_clip(pixel.x / width * 2 - 1, 1 - pixel.y / height * 2, 1, 1);
  const glm::dvec4 far_point = tablet_from_clip * far_clip;
  const glm::dvec3 along = glm::dvec3(far_point) / far_point.w - eye_m;
  if (along.z >= 0) return std::nullopt;
  const double t = (z_m - eye_m.z) / along.z;
  if (t < 0) return std::nullopt;
  return geometry::TabletPoint{eye_m.x + along.x * t, eye_m.y + along.y * t};
}

double Projection::pixels_per_metre(glm::dvec3 point_m) const {
  const glm::dvec4 clip = clip_from_tablet * glm::dvec4(point_m, 1);
  const glm::dvec3 row{clip_from_tablet[0][0], clip_from_tablet[1][0], clip_from_tablet[2][0]};
  return glm::length(row) * width / 2 / clip.w;
}

Projection make_projection(const Camera& camera, Style style, const geometry::TabletShape& shape, int width,
                           int height) {
  Projection projection;
  projection.width = std::max(width, 1);
  projection.height = std::max(height, 1);
  const glm::dvec3 pan(camera.pan.x, camera.pan.y, 0);
  glm::dmat4 view(1);
  if (style == Style::classic) {
    const glm::dmat4 world = classic_world_from_tablet(shape);
    const glm::dvec3 middle(world[3]);
    const glm::dvec3 pivot(world * glm::dvec4(pan, 1));
    const double near_m = 1 / std::tan(kClassicHalfView);
    view = glm::translate(glm::dmat4(1), glm::dvec3(0, 0, -(near_m + 1)));
    view = glm::translate(view, middle) * turned(camera) * glm::translate(glm::dmat4(1), -pivot) * world;
    // In 2005 the depth range was [near, near + 2]; a tablet that can be tilted needs a little more. Depth
    // planes do not change the picture.
    projection.clip_from_tablet =
        lens(kClassicHalfView, camera.zoom, projection.width, projection.height, near_m - 1.2, near_m + 4) *
        view;
  } else {
    const double half_m = shape.width_m * (0.5 + kRimFraction);
    const double distance_m = half_m / (kFill * std::tan(kHalfView));
    const double reach_m = half_m * 2 + shape.width_m + shape.depth_m;
    view = glm::translate(glm::dmat4(1), glm::dvec3(0, 0, -distance_m)) * turned(camera) *
           glm::translate(glm::dmat4(1), -pan);
    projection.clip_from_tablet =
        lens(kHalfView, camera.zoom, projection.width, projection.height,
             std::max(distance_m - reach_m, distance_m * 0.05), distance_m + reach_m) *
        view;
  }
  projection.eye_m = glm::dvec3(glm::inverse(view) * glm::dvec4(0, 0, 0, 1));
  return projection;
}

}  // namespace nazori::view
