// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "ink_graph.h"

namespace nazori::author {

/// A point of the middle lines.
struct RidgePoint {
  geometry::GlyphPoint at;
  geometry::GlyphPoint along;  ///< unit direction of the line, one of two
  bool is_sure = true;  ///< not beside a junction, where the middle of the ink is the middle of no line
};

/// Where a middle line ends freely.
struct RidgeEnd {
  geometry::GlyphPoint at;
  geometry::GlyphPoint out;  ///< unit direction in which the line ends
  bool touches = false;      ///< another stroke, which may hide the true end
};

struct Ridge {
  std::vector<RidgePoint> points;  ///< about 0.6 glyph units apart
  std::vector<RidgeEnd> ends;
};

/// @param map  from which the graph was made. @param reach  as of arms_of().
[[nodiscard]] Ridge ridge_of(const InkGraph& graph, const InkMap& map, double reach);

}  // namespace nazori::author
