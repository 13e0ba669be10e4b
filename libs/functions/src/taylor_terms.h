// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "taylor.h"

/// The recurrences of Taylor coefficients: each function takes those of its arguments, over a box or at a
/// place, and its own value where that is known more tightly than by the recurrence.
namespace nazori::functions::taylor {

using Terms = Taylor::Terms;
inline constexpr std::size_t kCount = Taylor::kOrder + 1;

/// Exactly 0.
[[nodiscard]] inline bool vanishes(const Interval& v) { return v.lower == 0 && v.upper == 0; }
/// What stands for a derivative that does not exist or is not known.
[[nodiscard]] inline Interval unknown() { return Interval::entire(Decoration::partial, Cause::none); }
[[nodiscard]] bool is_constant(const Terms& u);
[[nodiscard]] Terms constant(const Interval& value);
/// A value of which no derivative from number `first` on is known.
[[nodiscard]] Terms unknown_from(std::size_t first, Terms r);

[[nodiscard]] Terms product(const Terms& u, const Terms& v);
[[nodiscard]] Terms sum(const Terms& u, const Terms& v);
[[nodiscard]] Terms negated(const Terms& u);
[[nodiscard]] Terms quotient(const Terms& u, const Terms& v);
[[nodiscard]] Terms one_plus(const Terms& u);
[[nodiscard]] Terms one_over(const Terms& u);
/// What has this value and the derivative `slope` times u'.
[[nodiscard]] Terms chain(const Interval& value, const Terms& slope, const Terms& u);
[[nodiscard]] Terms exponential(const Interval& value, const Terms& u);
/// Sine and cosine, or, with `sign` 1, those of the hyperbola.
[[nodiscard]] std::pair<Terms, Terms> waves(const Terms& u, int sign);
/// The tangent, or, with `sign` -1, that of the hyperbola: the derivative is 1 + sign tan^2.
[[nodiscard]] Terms tangent(const Terms& u, int sign);
/// u^(p/q), by u r' = (p/q) u' r.
[[nodiscard]] Terms rational_power(const Interval& value, const Terms& u, int p, int q);
[[nodiscard]] Terms root(const Terms& u);
[[nodiscard]] Terms whole_power(const Terms& u, int n);
/// floor, ceil, sign and conditions: level where they do not step.
[[nodiscard]] Terms step(const Interval& value);
[[nodiscard]] Terms smaller(const Terms& u, const Terms& v);
[[nodiscard]] Terms size(const Terms& u);
[[nodiscard]] Terms chosen(const Terms& condition, const Terms& u, const Terms& v);

}  // namespace nazori::functions::taylor
