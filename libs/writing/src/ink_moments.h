// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "stroke_picture.h"

namespace nazori::writing {

/// Mean and standard deviation of the ink, each bit of line counted by its length.
struct InkMoments {
  float x = 0, y = 0, spread_x = 0, spread_y = 0;
};

/// Spreads 1 at the origin for strokes without length.
[[nodiscard]] InkMoments ink_moments(std::span<const FlatLine> strokes);

/// The larger side of the bounding box; 0 without points.
[[nodiscard]] float extent_of(std::span<const FlatLine> strokes);

}  // namespace nazori::writing
