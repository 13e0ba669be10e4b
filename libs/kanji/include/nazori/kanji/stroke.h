// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "nazori/geometry/point.h"

namespace nazori::kanji {

/// How a stroke ends. @source the table of KanjiVG types in docs/data.md.
enum class StrokeEnding : std::uint8_t {
  stop,    ///< tome: the brush stops and is then lifted; a blunt end
  hook,    ///< hane: the brush stops, then flicks off
  taper,   ///< harai, a sweep: the brush is lifted while it moves; the end thins out
  either,  ///< officially free: stop or another ending are both right
};

/// The line a brush follows for one stroke, and its ending: all that carving, drawing and haptics need.
struct StrokeLine {
  geometry::Polyline<geometry::GlyphFrame> points;  ///< centre line in writing direction, at least one point
  StrokeEnding ending = StrokeEnding::stop;
  std::optional<geometry::GlyphPoint>
      number_position;  ///< left end of the baseline of the printed stroke number, if the source gives it

  friend bool operator==(const StrokeLine&, const StrokeLine&) = default;
};

/// One stroke of a character as KanjiVG publishes it.
struct Stroke {
  std::string path;  ///< SVG path data, glyph frame, as published
  std::string type;  ///< kvg:type as published ("㇔/㇏"), empty where the source gives none
  StrokeLine line;   ///< the path flattened to 0.05 glyph units

  friend bool operator==(const Stroke&, const Stroke&) = default;
};

}  // namespace nazori::kanji
