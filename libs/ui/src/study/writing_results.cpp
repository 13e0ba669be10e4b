// SPDX-License-Identifier: Apache-2.0
#include "study/writing_results.h"

#include "nazori/geometry/frames.h"

namespace nazori::ui {
namespace {

study::FaultKind to_study(writing::FaultKind kind) {
  switch (kind) {
    case writing::FaultKind::order:
      return study::FaultKind::order;
    case writing::FaultKind::reversed:
      return study::FaultKind::reversed;
    case writing::FaultKind::missing:
      return study::FaultKind::missing;
    case writing::FaultKind::extra:
      return study::FaultKind::extra;
    case writing::FaultKind::joined:
      return study::FaultKind::joined;
    case writing::FaultKind::split:
      return study::FaultKind::split;
    case writing::FaultKind::wrong:
      return study::FaultKind::wrong;
    case writing::FaultKind::other:
      return study::FaultKind::other;
    case writing::FaultKind::ending:
      return study::FaultKind::ending;
  }
  return study::FaultKind::wrong;
}

int stroke_of(const writing::Fault& fault, const writing::Grade& grade) {
  if (fault.kind == writing::FaultKind::missing) return fault.stroke;
  if (!fault.model.empty()) return fault.model.front();
  const auto drawn = static_cast<std::size_t>(fault.stroke);
  if (drawn < grade.strokes.size() && grade.strokes[drawn].matched) return *grade.strokes[drawn].matched;
  return fault.stroke;
}

}  // namespace

study::WritingResult to_result(const writing::Grade& grade) {
  study::WritingResult result;
  result.accepted = grade.accepted;
  result.score = grade.score;
  for (const auto& fault : grade.faults)
    result.faults.push_back({to_study(fault.kind), stroke_of(fault, grade)});
  for (const auto& advice : grade.advice)
    if (advice.kind == writing::FaultKind::ending)
      result.faults.push_back({study::FaultKind::ending, stroke_of(advice, grade)});
  return result;
}

study::Ink to_study_ink(const std::vector<practice::HandStroke>& strokes) {
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
