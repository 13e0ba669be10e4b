// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "stroke_picture.h"

namespace nazori::writing {

/// Start, middle and end of a stroke: enough to exclude most characters.
struct ThreePoints {
  float x[3] = {};
  float y[3] = {};
};

[[nodiscard]] ThreePoints three_points(FlatLine line);

/// The drawn strokes, normalised: centred, with the mean square of the points 1.
struct QuickDrawing {
  std::vector<ThreePoints> strokes;
};

[[nodiscard]] QuickDrawing quick_drawing(std::span<const ThreePoints> strokes);

/// Mean squared distance of the points of strokes taken in order, both normalised; 0..4. The model must not
/// have fewer strokes; only as many as were drawn count.
[[nodiscard]] float distance_in_order(const QuickDrawing& drawn, std::span<const ThreePoints> model);

/// The same where the model has one stroke more than was drawn: leaves out the one without which they are
/// nearest.
[[nodiscard]] float distance_with_a_gap(const QuickDrawing& drawn, std::span<const ThreePoints> model);

/// The same where the model has one stroke less, but not none.
[[nodiscard]] float distance_with_one_too_many(const QuickDrawing& drawn, std::span<const ThreePoints> model);

}  // namespace nazori::writing
