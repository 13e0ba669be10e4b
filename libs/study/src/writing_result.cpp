// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/writing_result.h"

#include <algorithm>

#include "named_values.h"

namespace nazori::study {
std::string_view name_of(FaultKind kind) {
  switch (kind) {
    case FaultKind::order:
      return "order";
    case FaultKind::reversed:
      return "reversed";
    case FaultKind::missing:
      return "missing";
    case FaultKind::extra:
      return "extra";
    case FaultKind::joined:
      return "joined";
    case FaultKind::split:
      return "split";
    case FaultKind::wrong:
      return "wrong";
    case FaultKind::other:
      return "other";
    case FaultKind::ending:
      return "ending";
  }
  return {};
}

std::optional<FaultKind> fault_named(std::string_view name) { return value_named<FaultKind>(name); }

Rating proposed_rating(const WritingResult& result, const UsualWriting& usual, const RatingRule& rule) {
  if (!result.accepted || result.shown_strokes > 0 || result.hints > rule.most_hints ||
      result.help > rule.most_help) {
    return Rating::again;
  }
  const bool duration_counts = usual.count >= rule.usual_needs && usual.duration.count() > 0;
  const double pace = duration_counts ? static_cast<double>(result.duration.count()) /
                                            static_cast<double>(usual.duration.count())
                                      : 1;
  const bool structural =
      std::any_of(result.faults.begin(), result.faults.end(),
                  [](const StrokeFault& fault) { return fault.kind != FaultKind::ending; });
  if (result.hints > 0 || result.misses > 0 || result.help > rule.free_help || structural ||
      result.score < rule.score_for_good || pace > rule.slow) {
    return Rating::hard;
  }
  if (result.faults.empty() && result.score >= rule.score_for_easy && duration_counts && pace <= rule.quick) {
    return Rating::easy;
  }
  return Rating::good;
}

}  // namespace nazori::study
