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

}  // namespace nazori::functions
