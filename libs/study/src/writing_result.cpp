// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/writing_result.h"

#include <algorithm>
#include <array>

namespace nazori::study {

std::string_view name_of(RatingReason reason) {
  constexpr std::array<std::string_view, 12> kNames{
      "not-accepted", "strokes-shown", "many-hints", "much-help", "hint",  "missed-strokes",
      "some-help",    "mistake",       "form",       "slow",      "quick", "usual"};
  const auto at = static_cast<std::size_t>(reason);
  return at < kNames.size() ? kNames[at] : std::string_view();
}

SuggestedRating suggested_rating(const WritingResult& result, const UsualWriting& usual,
                                 const RatingRule& rule) {
  using Reason = RatingReason;
  if (!result.accepted && result.shown_strokes == 0) return {Rating::again, Reason::not_accepted};
  if (result.shown_strokes > 0) return {Rating::again, Reason::strokes_shown};
  if (result.hints > rule.most_hints) return {Rating::again, Reason::many_hints};
  if (result.help > rule.most_help) return {Rating::again, Reason::much_help};
  const bool duration_counts = usual.count >= rule.usual_needs && usual.duration.count() > 0;
  const double pace = duration_counts ? static_cast<double>(result.duration.count()) /
                                            static_cast<double>(usual.duration.count())
                                      : 1;
  const bool structural =
      std::any_of(result.mistakes.begin(), result.mistakes.end(),
                  [](const StrokeMistake& mistake) { return mistake.kind != kanji::MistakeKind::ending; });
  if (result.hints > 0) return {Rating::hard, Reason::hint};
  if (result.misses > 0) return {Rating::hard, Reason::missed_strokes};
  if (result.help > rule.free_help) return {Rating::hard, Reason::some_help};
  if (structural) return {Rating::hard, Reason::mistake};
  if (result.score < rule.score_for_good) return {Rating::hard, Reason::form};
  if (pace > rule.slow) return {Rating::hard, Reason::slow};
  if (result.mistakes.empty() && result.score >= rule.score_for_easy && duration_counts &&
      pace <= rule.quick) {
    return {Rating::easy, Reason::quick};
  }
  return {Rating::good, Reason::usual};
}

Rating proposed_rating(const WritingResult& result, const UsualWriting& usual, const RatingRule& rule) {
  return suggested_rating(result, usual, rule).rating;
}

}  // namespace nazori::study
