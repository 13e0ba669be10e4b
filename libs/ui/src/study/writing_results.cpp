// SPDX-License-Identifier: Apache-2.0
#include "study/writing_results.h"

#include "nazori/geometry/frames.h"

namespace nazori::ui {
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

study::Ink to_study_ink(const std::vector<HandStroke>& strokes) {
  study::Ink ink;
  if (strokes.empty() || strokes.front().empty()) return ink;
  const double zero_s = strokes.front().front().time_s;
  double latest_ms = 0;
  std::size_t points = 0;
  for (const auto& stroke : strokes) {
    if (ink.strokes.size() == study::kMostInkStrokes || points + stroke.size() > study::kMostInkPoints) break;
    points += stroke.size();
    study::InkStroke kept;
    for (const auto& point : stroke) {
      // The servo's clock begins anew when another device takes the tablet.
      latest_ms = std::max(latest_ms, (point.time_s - zero_s) * 1000);
      kept.push_back(study::ink_point(geometry::tablet_to_glyph(point.at, geometry::TabletShape{}), latest_ms,
                                      point.pressure));
    }
    if (!kept.empty()) ink.strokes.push_back(std::move(kept));
  }
  return ink;
}

}  // namespace nazori::ui
