// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "nazori/view/tablet_view.h"

namespace nazori::view {

// What follows needs no drawing. Thread-safe: yes.

/// The point of the plateau under a pixel (y down), nothing where the line of sight misses its plane. The
/// same as TabletView::pick().
[[nodiscard]] std::optional<geometry::TabletPoint> point_under(const Camera& camera, Style style,
                                                               const geometry::TabletShape& shape,
                                                               glm::dvec2 pixel, int width, int height);

/// The camera with the tablet moved by a drag: the point of the plateau under `from` moves to `to`.
[[nodiscard]] Camera panned(const Camera& camera, Style style, const geometry::TabletShape& shape,
                            glm::dvec2 from, glm::dvec2 to, int width, int height);

/// The camera zoomed by `factor` while the point of the plateau under `pixel` stays fixed.
[[nodiscard]] Camera zoomed(const Camera& camera, Style style, const geometry::TabletShape& shape,
                            double factor, glm::dvec2 pixel, int width, int height);

}  // namespace nazori::view
