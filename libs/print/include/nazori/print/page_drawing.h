// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "nazori/geometry/point.h"

namespace nazori::print {

/// A side of paper [mm]: x right, y down, origin at the upper left corner.
struct PaperFrame {};
using PaperPoint = geometry::Point2<PaperFrame>;

/// One step of a path.
struct PathStep {
  enum class Kind : std::uint8_t {
    move,   ///< to points[0]
    line,   ///< to points[0]
    curve,  ///< a cubic Bézier curve to points[2]; the others are its control points
    close,  ///< a line back to the last move
  };
  Kind kind = Kind::move;
  std::array<PaperPoint, 3> points{};
};

/// A path that is filled or drawn as a line.
struct PageMark {
  std::vector<PathStep> path;
  bool filled = false;  ///< by the non-zero winding rule; else drawn as a line
  double grey = 0;      ///< 0 black, 1 white
  double width_mm = 0;  ///< of the line
  double dash_mm = 0;   ///< length of dashes and gaps; 0: solid
  bool round = false;   ///< ends and corners of the line
};

/// One side of a document as it is printed: what a viewer of the PDF paints. Letters are outlines.
struct PageDrawing {
  double width_mm = 0;
  double height_mm = 0;
  std::vector<PageMark> marks;  ///< later ones cover earlier ones
  std::string text;             ///< what can be searched for on this side, piece by piece, one a line
};

}  // namespace nazori::print
