// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "nazori/carving/groove.h"
#include "nazori/geometry/point.h"
#include "nazori/kanji/stroke.h"

namespace nazori::author {

/// The groove at one point of its centre line.
using GroovePoint = carving::GroovePoint;

/// A stroke that somebody made: its groove from its start to its end. A stroke of a database has one width
/// for its whole body; this one has a width and a depth at each point.
struct OwnStroke {
  std::vector<GroovePoint> points;  ///< at least one
  kanji::StrokeEnding ending = kanji::StrokeEnding::stop;
  std::optional<geometry::GlyphPoint> number_position =
      {};  ///< left end of the baseline of the stroke's number; none: placed by the program
  friend bool operator==(const OwnStroke&, const OwnStroke&) = default;
};

/// The centre lines, for what draws, judges or guides along strokes.
[[nodiscard]] std::vector<kanji::StrokeLine> stroke_lines(std::span<const OwnStroke> strokes);

/// The grooves, to be carved.
[[nodiscard]] std::vector<carving::Groove> grooves_of(std::span<const OwnStroke> strokes);

}  // namespace nazori::author
