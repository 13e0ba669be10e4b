// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/writing_results.h"

#include "nazori/geometry/frames.h"

namespace nazori::practice {
namespace {

int stroke_of(const writing::Mistake& mistake, const writing::Grade& grade) {
  if (mistake.kind == kanji::MistakeKind::missing) return mistake.stroke;
  if (!mistake.model.empty()) return mistake.model.front();
  const auto drawn = static_cast<std::size_t>(mistake.stroke);
  if (drawn < grade.strokes.size() && grade.strokes[drawn].matched) return *grade.strokes[drawn].matched;
  return mistake.stroke;
}

}  // namespace

study::WritingResult to_result(const writing::Grade& grade) {
  study::WritingResult result;
  result.accepted = grade.accepted;
  result.score = grade.score;
  for (const auto& mistake : grade.mistakes)
    result.mistakes.push_back({mistake.kind, stroke_of(mistake, grade)});
  for (const auto& advice : grade.advice)
    if (advice.kind == kanji::MistakeKind::ending)
      result.mistakes.push_back({kanji::MistakeKind::ending, stroke_of(advice, grade)});
  return result;
}

study::Handwriting to_handwriting(const std::vector<HandStroke>& strokes) {
  study::Handwriting written;
  for (const auto& stroke : strokes)
    written.push_back(geometry::in_frame<geometry::GlyphFrame>(
        stroke, [](auto at) { return geometry::tablet_to_glyph(at, geometry::TabletShape{}); }));
  return to_saved(written);
}

study::Handwriting to_saved(const study::Handwriting& strokes) {
  study::Handwriting saved;
  if (strokes.empty() || strokes.front().empty()) return saved;
  const double zero_s = strokes.front().front().time_s.value_or(0);
  double latest_s = 0;
  std::size_t points = 0;
  for (const auto& stroke : strokes) {
    if (saved.size() == study::kMostSavedStrokes || points + stroke.size() > study::kMostSavedPoints) break;
    if (stroke.empty()) continue;
    points += stroke.size();
    for (auto& point : saved.emplace_back(stroke)) {
      // The servo's clock starts again from 0 when another device takes over the tablet.
      latest_s = std::max(latest_s, point.time_s.value_or(0) - zero_s);
      point.time_s = latest_s;
      point = study::saved_point(point);
    }
  }
  return saved;
}

}  // namespace nazori::practice
