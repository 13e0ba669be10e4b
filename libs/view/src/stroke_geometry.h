// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "nazori/geometry/frames.h"
#include "nazori/kanji/stroke.h"
#include "relief.h"

namespace nazori::view {

/// A piece of a line in the plane of the plateau [m]. Laid out for the GPU.
struct LinePiece {
  glm::vec2 from_m;
  glm::vec2 to_m;
  float stroke;  ///< number from 1
};

/// An arrowhead: the position of its tip and its direction [m, unit vector]. Laid out for the GPU.
struct ArrowHead {
  glm::vec2 tip_m;
  glm::vec2 direction;
  float stroke;
};

/// A piece of the brush's path: a disc of growing or shrinking radius moved along it. Laid out for the GPU.
struct InkPiece {
  glm::vec2 from_m;
  glm::vec2 to_m;
  glm::vec2 radius_m;  ///< at both ends
  glm::vec2 along_m;   ///< arc length from the stroke's start at both ends
};

/// The start of a stroke and the side of it on which its number hides least.
struct NumberAnchor {
  geometry::TabletPoint start;
  glm::dvec2 side{0, 1};  ///< unit vector in the plane of the plateau
};

/// One stroke's share of the ink pieces.
struct InkRange {
  std::size_t first = 0;
  std::size_t count = 0;
  double length_m = 0;
};

/// Everything that is drawn for the strokes of a character. If there are very many lines and heads, those
/// that others hide come last: "shown" is the number to draw when all strokes are shown.
struct StrokeGeometry {
  std::vector<LinePiece> lines;
  std::vector<ArrowHead> heads;
  std::vector<LinePiece> classic_heads;  ///< two lines for each head, 5 units of the grid of 128 long
  std::vector<InkPiece> ink;
  std::vector<InkRange> ink_ranges;   ///< one per stroke
  std::vector<NumberAnchor> anchors;  ///< one per stroke
  std::size_t shown_lines = 0;
  std::size_t shown_heads = 0;
  std::size_t shown_classic_heads = 0;
  float plateau = 1;  ///< height of the face from which grooves go down
};

/// Indices of the points of `line` at which a run in one direction ends: corners (a turn of more than 35
/// degrees within 5 glyph units), every bend between straight pieces of at least 6 units, and the last point.
/// Flattened curves do not count as bends. A line of fewer than two different points has none.
[[nodiscard]] std::vector<std::size_t> run_ends(std::span<const geometry::GlyphPoint> line);

/// @param relief  the carved tablet, from which the width of each groove is read; size 0 when there is none.
[[nodiscard]] StrokeGeometry make_stroke_geometry(
    std::span<const geometry::Polyline<geometry::GlyphFrame>> strokes, const Relief& relief,
    const geometry::TabletShape& shape);

}  // namespace nazori::view
