// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/writing_result.h"

#include <algorithm>

namespace nazori::study {

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
      std::any_of(result.mistakes.begin(), result.mistakes.end(),
                  [](const StrokeMistake& mistake) { return mistake.kind != kanji::MistakeKind::ending; });
  if (result.hints > 0 || result.misses > 0 || result.help > rule.free_help || structural ||
      result.score < rule.score_for_good || pace > rule.slow) {
    return Rating::hard;
  }
  if (result.mistakes.empty() && result.score >= rule.score_for_easy && duration_counts &&
      pace <= rule.quick) {
    return Rating::easy;
  }
  return Rating::good;
}

}  // namespace nazori::study
