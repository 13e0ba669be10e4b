// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
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

/// How a character was written once, judged.
struct WritingResult {
  bool accepted = true;  ///< the judge takes it for the character
  int score = 100;       ///< 0..100
  std::vector<StrokeMistake> mistakes;
  int hints = 0;                          ///< hints that the learner asked for
  int misses = 0;                         ///< strokes tried and refused while writing
  int shown_strokes = 0;                  ///< strokes that were shown after too many misses
  double help = 0;                        ///< mean level of guidance by force or picture, 0 none .. 1 all
  std::chrono::milliseconds duration{0};  ///< from the task to the last stroke

  friend bool operator==(const WritingResult&, const WritingResult&) = default;
};

/// What the same learner takes for the same character.
struct UsualWriting {
  std::chrono::milliseconds duration{0};  ///< median of the last writings from memory
  int count = 0;                          ///< how many of them
};

/// Which numbers decide. docs/study.md explains each.
struct RatingRule {
  int score_for_good = 70;
  int score_for_easy = 90;
  int most_hints = 1;      ///< more of them: again
  double most_help = 0.5;  ///< more of it: again
  double free_help = 0.1;  ///< up to here guidance costs nothing
  double slow = 2.0;       ///< times the usual duration: no better than hard
  double quick = 1.0;      ///< times the usual duration: easy needs it
  int usual_needs = 3;     ///< writings before the duration counts
};

/// The rating that writing deserves; the learner may give another.
///
/// again: not accepted, a stroke had to be shown, more than `most_hints` hints, or help over `most_help`.
/// hard:  accepted, but with a hint, a miss, help over `free_help`, any mistake but an ending, a score under
///        `score_for_good`, or more than `slow` times the usual duration.
/// easy:  nothing of these, no mistake, a score from `score_for_easy` on, and not slower than `quick` times
/// the
///        usual duration, which must be known.
/// good:  all else.
[[nodiscard]] Rating proposed_rating(const WritingResult& result, const UsualWriting& usual,
                                     const RatingRule& rule = {});

}  // namespace nazori::study
