// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nazori/functions/plot.h"

namespace nazori::functions {

/// A statement as it is typed with conditions behind it: y = x^2 {x > 0}.
struct RestrictedStatement {
  Statement plain;
  std::vector<Expression> conditions;  ///< in the order of their braces
};
[[nodiscard]] RestrictedStatement without_conditions(const Statement& s);

/// The comparison that a node of a condition makes; of another function `equal`.
[[nodiscard]] Comparison comparison_of(Function f);

}  // namespace nazori::functions
