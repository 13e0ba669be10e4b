// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "nazori/view/tablet_view.h"

namespace nazori::view {

/// The point of the plateau under a pixel (y down), nothing where the line of sight misses its plane. The
/// same as TabletView::pick(), but without drawing. Thread-safe: yes.
[[nodiscard]] std::optional<geometry::TabletPoint> point_under(const Camera& camera, Style style,
                                                               const geometry::TabletShape& shape,
                                                               glm::dvec2 pixel, int width, int height);

}  // namespace nazori::view
