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

}  // namespace nazori::view
