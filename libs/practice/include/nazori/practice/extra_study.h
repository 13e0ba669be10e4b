// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/practice/learner.h"

namespace nazori::practice {

/// The new characters that come next, whatever the limit of the day is, in learning order; those that are
/// suspended or postponed are left out.
/// @param most  maximum number. @return the errors of Learner::learning_order().
[[nodiscard]] base::Result<std::vector<char32_t>> new_characters(Learner& learner, std::size_t most);

/// The reviews of the coming days, the earliest first and among those of a day the least known, to be done
/// ahead. Those that are due today, in their steps, suspended, postponed beyond today or difficult are left
/// out.
/// @param most  maximum number.
[[nodiscard]] std::vector<char32_t> reviews_ahead(const study::LearnerStore& store, std::size_t most);

/// The reviews and steps of a plan that are due now, in its order, without new characters.
struct ReviewsNow {
  std::vector<char32_t> characters;
  std::chrono::milliseconds estimate{0};  ///< time for all of them

  friend bool operator==(const ReviewsNow&, const ReviewsNow&) = default;
};
/// @param plan  of today. @return the errors of study::pace_of().
[[nodiscard]] base::Result<ReviewsNow> reviews_now(const study::LearnerStore& store,
                                                   const study::DayPlan& plan);

/// The time for practising some chosen characters once from memory.
[[nodiscard]] constexpr std::chrono::minutes practice_time(std::size_t characters) {
  return std::chrono::minutes(characters);
}

}  // namespace nazori::practice
