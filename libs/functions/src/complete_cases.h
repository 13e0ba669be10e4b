// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/functions/expression.h"

namespace nazori::functions {

/// The number that a comparison compares `v` with, or null.
[[nodiscard]] Expression border_of(const Expression& comparison, Variable v);

/// The same function without the last condition of cases that leave no number of `v` out: of
/// {v < 1: a, v >= 1: b} it is {v < 1: a, b}. Intervals then prove that it is defined around 1, too.
[[nodiscard]] Expression with_complete_cases(const Expression& e, Variable v);

}  // namespace nazori::functions
