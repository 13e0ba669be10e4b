// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "placement.h"
#include "shape.h"
#include "stroke_difference.h"

namespace nazori::writing {

/// What is left of a difference once place and length are taken out of it.
struct Residue {
  float turn_rad = 0;    ///< by which the drawn shape is turned from the model's, clockwise, -pi..pi
  float bend = 0;        ///< root mean square distance of both shapes of length 1, one turned onto the other
  float nearer_end = 0;  ///< glyph units by which the better of both ends is off where the neighbours put it
};

/// Of two strokes that were compared with that result. A stroke somebody meant has most often one end in its
/// place even where its slant is off: the end by which it touches another.
/// @source the turn that lays one set of points on another best: D. G. Kendall, "Shape manifolds,
/// Procrustean metrics, and complex projective spaces", Bull. London Math. Soc. 16 (1984).
[[nodiscard]] Residue residue(const Shape& drawn, const Shape& model, const StrokeDifference& difference,
                              const Placement& placement);

}  // namespace nazori::writing
