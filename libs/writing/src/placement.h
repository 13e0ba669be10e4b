// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "alignment.h"

namespace nazori::writing {

/// How far a stroke lies from where its neighbours lead one to expect it, glyph units.
struct Placement {
  float x = 0;
  float y = 0;
};

/// Of each link. Handwriting moves and stretches whole parts (a wider left side); strokes near each other
/// move together, so the mean offset of the neighbours is the better guess of where a stroke belongs.
[[nodiscard]] std::vector<Placement> placements(const Alignment& alignment, std::span<const Shape> model);

}  // namespace nazori::writing
