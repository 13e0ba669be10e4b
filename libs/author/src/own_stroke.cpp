// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/own_stroke.h"

namespace nazori::author {

std::vector<kanji::StrokeLine> stroke_lines(std::span<const OwnStroke> strokes) {
  std::vector<kanji::StrokeLine> lines;
  lines.reserve(strokes.size());
  for (const OwnStroke& stroke : strokes) {
    kanji::StrokeLine line;
    line.points.reserve(stroke.points.size());
    for (const GroovePoint& point : stroke.points) line.points.push_back(point.at);
    line.ending = stroke.ending;
    line.number_position = stroke.number_position;
    lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<carving::Groove> grooves_of(std::span<const OwnStroke> strokes) {
  std::vector<carving::Groove> grooves;
  grooves.reserve(strokes.size());
  for (const OwnStroke& stroke : strokes) grooves.push_back(stroke.points);
  return grooves;
}

}  // namespace nazori::author
