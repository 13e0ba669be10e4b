// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "nazori/geometry/frames.h"
#include "stroke_geometry.h"

namespace nazori::view {

/// Lines of one colour hide each other where thousands cross one spot. No character has so many pieces that
/// it matters, but a file of strokes may have millions, and without a graphics card each of them takes time.
/// Moves lines to the end that are covered along their whole length; the others keep their order.
/// @return number of lines to draw when all strokes are shown: all of them, unless there are very many.
[[nodiscard]] std::size_t put_hidden_last(std::vector<LinePiece>& lines, const geometry::TabletShape& shape);
/// The same for arrowheads, by the position of their tips.
[[nodiscard]] std::size_t put_hidden_last(std::vector<ArrowHead>& heads, const geometry::TabletShape& shape);

}  // namespace nazori::view
