// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/functions/expression.h"

namespace nazori::functions {

/// How tightly a tree holds together, written or spoken: 1 sums, 2 products, 3 signs (negative numbers too),
/// 4 powers, 5 all else. What is looser inside something tighter needs parentheses.
[[nodiscard]] int strength(const Node& n);

}  // namespace nazori::functions
