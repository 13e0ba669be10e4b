// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/functions/expression.h"

namespace nazori::functions {

/// Precedence of a tree, written or spoken: 1 sums, 2 products, 3 signs (also negative numbers), 4 powers, 5
/// everything else. A part with a lower precedence inside one with a higher needs parentheses.
[[nodiscard]] int strength(const Node& n);

}  // namespace nazori::functions
