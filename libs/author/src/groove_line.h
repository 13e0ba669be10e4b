// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "ink_map.h"
#include "nazori/author/own_stroke.h"

namespace nazori::author {

using GridLine = geometry::Polyline<geometry::GridFrame>;

/// Without the stairs of pixels: points about `spacing` samples apart. Ends and corners stay where they are.
[[nodiscard]] GridLine smoothed(const GridLine& line, double spacing = 2.0);

/// A bend of a line that is sharp compared with the width of the ink.
struct Corner {
  std::size_t point = 0;  ///< of the line
  double turn = 0;        ///< [rad], 0..pi
};

/// The corners of a smoothed line, in its order.
/// @param reach  how far on both sides of a point directions are taken [samples].
[[nodiscard]] std::vector<Corner> corners_of(const GridLine& line, double reach);

/// Moves ends of a line to the centre of the round end of the ink: as far from the rim ahead as the line is
/// from the rims beside it. Ends in other ink and those that thin out stay where they are.
void centre_ends(GridLine& line, const InkMap& map, bool front, bool back);

/// The line with width and depth of the ink along it. Where other ink crosses, the width goes on from one
/// side to the other.
/// @param line  at least one point. @return points in glyph units; the ending is stop.
[[nodiscard]] OwnStroke groove_along(const GridLine& line, const InkMap& map);

/// Lengthens a stroke that thins out to where its width would be nothing: the last part of a sweep is too
/// narrow to be seen.
void lengthen_tips(OwnStroke& stroke);

}  // namespace nazori::author
