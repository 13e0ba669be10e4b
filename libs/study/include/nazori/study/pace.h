// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

#include "nazori/study/learner_store.h"

namespace nazori::study {

/// How much time one learner needs for a day's work on one character, all its writings of that day together.
/// Each number is the median of the last 200 such days if there are at least `kPaceNeeds`, else an assumption
/// (docs/study.md gives the reasons).
struct Pace {
  std::chrono::milliseconds recalled{20'000};     ///< a review that succeeded
  std::chrono::milliseconds failed{60'000};       ///< a failed review, including writing it again
  std::chrono::milliseconds introduced{180'000};  ///< the day on which a character is introduced
  int recalled_days = 0;                          ///< number of days of each kind in the history
  int failed_days = 0;
  int introduced_days = 0;

  friend bool operator==(const Pace&, const Pace&) = default;
};

/// Number of days that are needed to replace an assumption.
inline constexpr int kPaceNeeds = 10;

/// The pace of a learner, from the sums that the store keeps of each study day.
/// @return Errc::io, Errc::parse as with every function of the store.
[[nodiscard]] base::Result<Pace> pace_of(const LearnerStore& learner);

}  // namespace nazori::study
