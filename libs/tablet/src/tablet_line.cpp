// SPDX-License-Identifier: Apache-2.0
#include "nazori/tablet/tablet_line.h"

namespace nazori::tablet {

std::vector<TabletLine> tablet_lines(std::span<const kanji::StrokeLine> strokes) {
  return {strokes.begin(), strokes.end()};
}

std::vector<geometry::Polyline<geometry::GlyphFrame>> centre_lines(std::span<const TabletLine> lines) {
  std::vector<geometry::Polyline<geometry::GlyphFrame>> all;
  all.reserve(lines.size());
  for (const TabletLine& line : lines) all.push_back(line.points);
  return all;
}

std::vector<kanji::StrokeLine> stroke_lines(std::span<const TabletLine> lines) {
  std::vector<kanji::StrokeLine> strokes;
  strokes.reserve(lines.size());
  for (const TabletLine& line : lines)
    strokes.push_back({line.points, line.ending.value_or(kanji::StrokeEnding::stop), {}});
  return strokes;
}

}  // namespace nazori::tablet
