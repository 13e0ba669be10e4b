// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "nazori/geometry/point.h"
#include "nazori/kanji/stroke.h"

namespace nazori::author {

/// The groove at one point of its centre line.
struct GroovePoint {
  geometry::GlyphPoint at;
  double half_width = 0;  ///< [glyph units, of 109]
  double depth = 1;       ///< fraction of the tablet's depth, (0, 1]
  friend bool operator==(const GroovePoint&, const GroovePoint&) = default;
};

/// A stroke that somebody made: its groove from its start to its end. A stroke of a database has one width
/// for its whole body; this one has a width and a depth at each point.
struct OwnStroke {
  std::vector<GroovePoint> points;  ///< at least one
  kanji::StrokeEnding ending = kanji::StrokeEnding::stop;
  std::optional<geometry::GlyphPoint>
      number_position = {};  ///< left end of the baseline of the stroke's number; none: placed by the program
  friend bool operator==(const OwnStroke&, const OwnStroke&) = default;
};

/// The centre lines, for what draws, judges or guides along strokes.
[[nodiscard]] std::vector<kanji::StrokeLine> stroke_lines(std::span<const OwnStroke> strokes);

}  // namespace nazori::author
