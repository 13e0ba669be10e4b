// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "nazori/study/fsrs.h"
#include "nazori/study/learner_store.h"

namespace nazori::study {

/// The interval a review gets where intervals may vary; nullopt where it stays as the scheduler says.
/// The same cards, settings and review always give the same answer.
/// @param after  the memory after the review, as the scheduler says. @param day  of the review.
[[nodiscard]] std::optional<int> choose_interval(const Fsrs& fsrs, const Settings& settings,
                                                 const Cards& cards, char32_t character, const Memory& after,
                                                 int elapsed_days, Day day);

}  // namespace nazori::study
