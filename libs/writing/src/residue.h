// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "placement.h"
#include "shape.h"
#include "stroke_difference.h"

namespace nazori::writing {

/// The difference that remains after removing position and length.
struct Residue {
  float turn_rad = 0;    ///< by which the drawn shape is turned from the model's, clockwise, -pi..pi
  float bend = 0;        ///< root mean square distance of both shapes of length 1, one turned onto the other
  float nearer_end = 0;  ///< distance in glyph units of the better of both ends from the position that the
                         ///< neighbours suggest
};

/// The residue of two compared strokes. An intended stroke usually has one end in the right position even if
/// its slant is wrong: the end where it touches another.
/// @source the turn that lays one set of points on another best: D. G. Kendall, "Shape manifolds, Procrustean
/// metrics, and complex projective spaces", Bull. London Math. Soc. 16 (1984).
[[nodiscard]] Residue residue(const Shape& drawn, const Shape& model, const StrokeDifference& difference,
                              const Placement& placement);

}  // namespace nazori::writing
