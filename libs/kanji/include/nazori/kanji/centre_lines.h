// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "nazori/geometry/point.h"
#include "nazori/kanji/stroke.h"

namespace nazori::kanji {

/// The centre lines of strokes, in their order: for what draws or saves them without their endings.
[[nodiscard]] inline std::vector<geometry::Polyline<geometry::GlyphFrame>> centre_lines(
    std::span<const StrokeLine> strokes) {
  std::vector<geometry::Polyline<geometry::GlyphFrame>> lines;
  lines.reserve(strokes.size());
  for (const StrokeLine& stroke : strokes) lines.push_back(stroke.points);
  return lines;
}

}  // namespace nazori::kanji
