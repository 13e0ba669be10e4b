// SPDX-License-Identifier: Apache-2.0
#include "nazori/view/point_under.h"

#include "projection.h"

namespace nazori::view {

std::optional<geometry::TabletPoint> point_under(const Camera& camera, Style style,
                                                 const geometry::TabletShape& shape, glm::dvec2 pixel,
                                                 int width, int height) {
  if (width < 1 || height < 1) return std::nullopt;
  return make_projection(within_limits(camera, shape), style, shape, width, height).on_plane(pixel, 0);
}

Camera panned(const Camera& camera, Style style, const geometry::TabletShape& shape, glm::dvec2 from,
              glm::dvec2 to, int width, int height) {
  Camera moved = within_limits(camera, shape);
  const auto grabbed = point_under(camera, style, shape, from, width, height);
  const auto under = point_under(camera, style, shape, to, width, height);
  if (grabbed && under) moved.pan = moved.pan + (*grabbed - *under);
  return within_limits(moved, shape);
}

Camera zoomed(const Camera& camera, Style style, const geometry::TabletShape& shape, double factor,
              glm::dvec2 pixel, int width, int height) {
  Camera nearer = within_limits(camera, shape);
  nearer.zoom *= factor;
  nearer = within_limits(nearer, shape);
  const auto before = point_under(camera, style, shape, pixel, width, height);
  const auto after = point_under(nearer, style, shape, pixel, width, height);
  if (before && after) nearer.pan = nearer.pan + (*before - *after);
  return within_limits(nearer, shape);
}

}  // namespace nazori::view
