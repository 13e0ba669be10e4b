// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/functions/expression.h"

namespace nazori::functions {

/// The derivative with respect to `v`, with products by 0 and 1 left out: its domain can be larger than that
/// of `e`. Steps have the derivative 0 where they are level. Null where it has no closed form (gamma) or
/// would grow over some thousand parts.
[[nodiscard]] Expression derivative(const Expression& e, Variable v);

/// The derivative as a function of its own: defined only where it exists, so not in the corner of |x|, at the
/// jumps of floor(x), or where ln(x) itself is undefined. Null as above.
[[nodiscard]] Expression slope_where_defined(const Expression& e, Variable v);

}  // namespace nazori::functions
