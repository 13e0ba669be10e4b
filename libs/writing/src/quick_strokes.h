// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "stroke_picture.h"

namespace nazori::writing {

/// Start, middle and end of a stroke: enough to sort out most characters.
struct ThreePoints {
  float x[3] = {};
  float y[3] = {};
};

[[nodiscard]] ThreePoints three_points(FlatLine line);

/// Mean squared distance of the points of strokes taken in order, both brought to one place and size; the
/// second side may have more strokes, only as many as the first has count.
[[nodiscard]] float distance_in_order(std::span<const ThreePoints> drawn, std::span<const ThreePoints> model);

}  // namespace nazori::writing
