// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "alignment.h"

namespace nazori::writing {

/// The position and length of a stroke compared with the others of the same writing.
struct Placement {
  float x = 0;  ///< glyph units from the position that its neighbours suggest
  float y = 0;
  float length_log = 0;  ///< natural logarithm of its length relative to what the other strokes suggest
};

/// The placement for each link. Handwriting moves and stretches whole parts (a wider left side), and strokes
/// near each other move together, so the mean offset of the neighbours is the better estimate of a stroke's
/// position. Where there are few strokes, a bad one biases the fit in its own favour; the lengths of the
/// others reveal it.
[[nodiscard]] std::vector<Placement> placements(const Alignment& alignment, std::span<const Shape> model);

}  // namespace nazori::writing
