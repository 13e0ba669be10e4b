// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/functions/expression.h"

namespace nazori::functions {

/// The derivative with respect to `v`, with products by 0 and 1 left out: its domain can be larger than that
/// of `e`. Steps have the derivative 0 where they are level. Null where it has no closed form (gamma) or
/// would grow over some thousand parts.
[[nodiscard]] Expression derivative(const Expression& e, Variable v);

}  // namespace nazori::functions
