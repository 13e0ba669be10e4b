// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "nazori/geometry/point.h"
#include "nazori/kanji/stroke.h"

namespace nazori::tablet {

/// A line in a tablet: a stroke of a character, a line of a file, or a curve of a plot.
struct TabletLine {
  TabletLine() = default;
  explicit TabletLine(geometry::Polyline<geometry::GlyphFrame> line) : points(std::move(line)) {}
  /// Implicit on purpose: a stroke is such a line.
  TabletLine(kanji::StrokeLine stroke) : points(std::move(stroke.points)), ending(stroke.ending) {}

  geometry::Polyline<geometry::GlyphFrame> points;  ///< from its start to its end
  std::optional<kanji::StrokeEnding> ending;        ///< of a stroke; a curve has none

  friend bool operator==(const TabletLine&, const TabletLine&) = default;
};

/// Strokes of a character as lines of a tablet.
[[nodiscard]] std::vector<TabletLine> tablet_lines(std::span<const kanji::StrokeLine> strokes);

/// The lines alone, to be drawn or saved.
[[nodiscard]] std::vector<geometry::Polyline<geometry::GlyphFrame>> centre_lines(
    std::span<const TabletLine> lines);

/// The lines as strokes, to be carved: one without an ending is carved as one that stops.
[[nodiscard]] std::vector<kanji::StrokeLine> stroke_lines(std::span<const TabletLine> lines);

}  // namespace nazori::tablet
