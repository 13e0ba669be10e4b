// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

#include "nazori/study/learner_store.h"

namespace nazori::study {

/// How long one learner takes for what a study day asks of one character, all its writings of that day
/// together. Each number is the median of the last 200 such days, once there are `kPaceNeeds` of them, and an
/// assumption until then (docs/study.md gives its reasons).
struct Pace {
  std::chrono::milliseconds recalled{20'000};     ///< a review that succeeded
  std::chrono::milliseconds failed{60'000};       ///< a review that failed, with writing it again
  std::chrono::milliseconds introduced{180'000};  ///< the day a character is met
  int recalled_days = 0;                          ///< seen; as for the other two
  int failed_days = 0;
  int introduced_days = 0;

  friend bool operator==(const Pace&, const Pace&) = default;
};

/// So many days make a number of the learner's own.
inline constexpr int kPaceNeeds = 10;

/// The pace of a learner, from the sums that the store keeps of each study day.
/// @return Errc::io, Errc::parse as every function of the store.
[[nodiscard]] base::Result<Pace> pace_of(const LearnerStore& learner);

}  // namespace nazori::study
