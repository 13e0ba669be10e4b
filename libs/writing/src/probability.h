// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/writing/grade.h"

namespace nazori::writing {

/// Deviation that stands for a stroke refused whatever its shape, as a share of the limit.
inline constexpr double kJustBeyond = 1.1;

/// The deviation, 1 at the limit of normal strictness, of a stroke that is strange with these log odds.
[[nodiscard]] double deviation_of(double log_odds);

/// The probability that a teacher accepts a writing with these mistakes. @param deviation  of its strangest
/// stroke, 1 at the limit of normal strictness
[[nodiscard]] double probability_of(const Grade& grade, double deviation);

}  // namespace nazori::writing
