// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/study/fsrs.h"

namespace nazori::study {

// The frequencies of ratings, first and later: the defaults of open-spaced-repetition's fsrs-optimizer (its
// simulator), which come from the collections of Anki's users.
inline constexpr double kFirstAgain = 0.24;
inline constexpr double kFirstHard = 0.094;
inline constexpr double kFirstGood = 0.495;
inline constexpr double kHardShare = 0.224;
inline constexpr double kEasyShare = 0.145;

/// The first rating of a character. @param dice  a random number 0..1, here and below.
[[nodiscard]] inline Rating first_rating(double dice) {
  if (dice < kFirstAgain) return Rating::again;
  if (dice < kFirstAgain + kFirstHard) return Rating::hard;
  return dice < kFirstAgain + kFirstHard + kFirstGood ? Rating::good : Rating::easy;
}

/// A later rating. @param chance  the probability of recall.
[[nodiscard]] inline Rating next_rating(double chance, double dice, double grade) {
  if (dice >= chance) return Rating::again;
  if (grade < kHardShare) return Rating::hard;
  return grade >= 1 - kEasyShare ? Rating::easy : Rating::good;
}

}  // namespace nazori::study
