// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "groove_line.h"
#include "ridge.h"

namespace nazori::author {

using GlyphLine = geometry::Polyline<geometry::GlyphFrame>;

/// The lines of a character over middle lines of ink.
struct LaidOver {
  std::vector<GlyphLine> as_a_whole;  ///< moved, stretched and turned together
  std::vector<GlyphLine> bent;        ///< then bent smoothly, neighbours together
};

/// Lays lines over the middle lines of ink that they are meant to be.
/// @param lines  points about a unit apart.
/// @param is_in_place  whether the lines may lie there already; else their boxes are brought together first.
/// @source A. Myronenko, X. Song, "Point set registration: coherent point drift", IEEE PAMI 32, 2010; the
/// direction of lines counts as two more coordinates here.
[[nodiscard]] LaidOver laid_over(std::vector<GlyphLine> lines, const Ridge& ridge, bool is_in_place);

}  // namespace nazori::author
