// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "nazori/study/fsrs.h"
#include "nazori/study/learner_store.h"

namespace nazori::study {

/// The interval after a review where intervals may vary; nullopt where the scheduler's interval is used. The
/// same cards, settings and review always give the same answer.
/// @param after  the memory after the review, from the scheduler. @param day  of the review.
[[nodiscard]] std::optional<int> choose_interval(const Fsrs& fsrs, const Settings& settings,
                                                 const Cards& cards, char32_t character, const Memory& after,
                                                 int elapsed_days, Day day);

}  // namespace nazori::study
