// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "nazori/geometry/frames.h"
#include "stroke_geometry.h"

namespace nazori::view {

/// Lines of one colour hide each other where thousands cross one place. No character has so many pieces that
/// it matters; a file of strokes may have millions, and without a graphics card each of them takes its time.
/// Puts those last that lie all along where enough others do; the others keep their order.
/// @return how many are worth drawing when all strokes are shown: all of them, unless there are very many.
[[nodiscard]] std::size_t put_hidden_last(std::vector<LinePiece>& lines, const geometry::TabletShape& shape);
/// The same of arrowheads, by where they point.
[[nodiscard]] std::size_t put_hidden_last(std::vector<ArrowHead>& heads, const geometry::TabletShape& shape);

}  // namespace nazori::view
