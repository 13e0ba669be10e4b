// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "nazori/view/tablet_view.h"

namespace nazori::view {

/// The rim of wood or stone around the carved square, as a fraction of its width.
inline constexpr double kRimFraction = 0.0625;
/// Thickness of the board under the deepest groove, as a fraction of its width.
inline constexpr double kBaseFraction = 0.03;

/// From the tablet frame to clip space and to pixels (y down) of one viewport.
struct Projection {
  glm::dmat4 clip_from_tablet{1};
  glm::dvec3 eye_m{0};  ///< in the tablet frame
  int width = 0;
  int height = 0;

  /// The position of a point of the tablet frame in the picture; the point must lie in front of the eye.
  [[nodiscard]] glm::dvec2 pixel(glm::dvec3 point_m) const;
  /// Where the line of sight through a pixel meets the plane z = z_m, nothing where it misses it.
  [[nodiscard]] std::optional<geometry::TabletPoint> on_plane(glm::dvec2 pixel, double z_m) const;
  /// Pixels per metre across the line of sight at a point.
  [[nodiscard]] double pixels_per_metre(glm::dvec3 point_m) const;
};

/// @param camera  within its limits.
[[nodiscard]] Projection make_projection(const Camera& camera, Style style,
                                         const geometry::TabletShape& shape, int width, int height);

}  // namespace nazori::view
