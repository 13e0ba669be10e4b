// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <string_view>
#include <vector>

#include "nazori/kanji/mistake_kind.h"
#include "nazori/study/fsrs.h"

namespace nazori::study {

/// One mistake in one stroke.
struct StrokeMistake {
  kanji::MistakeKind kind = kanji::MistakeKind::wrong;
  int stroke = 0;  ///< of the model where it is known, else as drawn; from 0

  friend bool operator==(const StrokeMistake&, const StrokeMistake&) = default;
};

/// The graded result of writing a character once.
struct WritingResult {
  bool accepted = true;  ///< the writing was accepted as the character
  int score = 100;       ///< 0..100
  std::vector<StrokeMistake> mistakes;
  int hints = 0;                          ///< hints that the learner requested
  int misses = 0;                         ///< strokes that were rejected while writing
  int shown_strokes = 0;                  ///< strokes that were shown after too many rejected ones
  double help = 0;                        ///< mean level of guidance by force or picture, 0 none .. 1 all
  std::chrono::milliseconds duration{0};  ///< from the task to the last stroke

  friend bool operator==(const WritingResult&, const WritingResult&) = default;
};

/// The usual result of the same learner for the same character.
struct UsualWriting {
  std::chrono::milliseconds duration{0};  ///< median of the last writings from memory
  int count = 0;                          ///< how many of them
};

/// The thresholds of ratings. docs/study.md explains each.
struct RatingRule {
  int score_for_good = 70;
  int score_for_easy = 90;
  int most_hints = 1;      ///< more of them: again
  double most_help = 0.5;  ///< more of it: again
  double free_help = 0.1;  ///< guidance up to this level does not lower the rating
  double slow = 2.0;       ///< more than this many times the usual duration: at most hard
  double quick = 1.0;      ///< at most this many times the usual duration: required for easy
  int usual_needs = 3;     ///< number of earlier writings that are needed before the duration counts
};

/// Why a rating is suggested. For `again` and `hard` it is the first that holds, in this order.
enum class RatingReason : std::uint8_t {
  not_accepted,    ///< again, where nothing was shown
  strokes_shown,   ///< again: a stroke, or the answer, was shown
  many_hints,      ///< again
  much_help,       ///< again
  hint,            ///< hard
  missed_strokes,  ///< hard: strokes were rejected while writing
  some_help,       ///< hard
  mistake,         ///< hard: accepted with a mistake other than an ending
  form,            ///< hard: the score is low
  slow,            ///< hard
  quick,           ///< easy: without a mistake, and at least as fast as usual
  usual,           ///< good
};
/// "not-accepted", "hint", "quick": for data formats; empty for an invalid number.
[[nodiscard]] std::string_view name_of(RatingReason reason);

/// A rating with its reason.
struct SuggestedRating {
  Rating rating = Rating::good;
  RatingReason reason = RatingReason::usual;

  friend bool operator==(const SuggestedRating&, const SuggestedRating&) = default;
};

/// The suggested rating of a writing; the learner may choose another one.
///
/// - again: not accepted, a stroke had to be shown, more than `most_hints` hints, or help over `most_help`.
/// - hard: accepted, but with a hint, a miss, help over `free_help`, any mistake but an ending, a score under
///   `score_for_good`, or more than `slow` times the usual duration.
/// - easy: none of these, no mistake, a score from `score_for_easy` on, and not slower than `quick` times the
///   usual duration, which must be known.
/// - good: everything else.
[[nodiscard]] SuggestedRating suggested_rating(const WritingResult& result, const UsualWriting& usual,
                                               const RatingRule& rule = {});
/// The same without the reason.
[[nodiscard]] Rating proposed_rating(const WritingResult& result, const UsualWriting& usual,
                                     const RatingRule& rule = {});

}  // namespace nazori::study
