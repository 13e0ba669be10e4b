// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "alignment.h"

namespace nazori::writing {

/// How a stroke lies beside the others of the same writing.
struct Placement {
  float x = 0;  ///< glyph units from where its neighbours lead one to expect it
  float y = 0;
  float length_log = 0;  ///< natural logarithm of its length by what the other strokes lead one to expect
};

/// Of each link. Handwriting moves and stretches whole parts (a wider left side); strokes near each other
/// move together, so the mean offset of the neighbours is the better guess of where a stroke belongs. Where
/// there are few strokes, a spoilt one bends the laying over to its own favour: the lengths of the others
/// tell.
[[nodiscard]] std::vector<Placement> placements(const Alignment& alignment, std::span<const Shape> model);

}  // namespace nazori::writing
