// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "nazori/functions/interval.h"

namespace nazori::functions {

/// The first Taylor coefficients of a function of one variable t: term k encloses the k-th derivative over
/// k!.
///
/// A number of a tape like intervals and duals, for integrals. With p the place and n at most kOrder,
/// f(t) lies in place[0] + ... + place[n-1] (t-p)^(n-1) + box[n] (t-p)^n for every t of the box, if these
/// terms are bounded. In the corner of |t| only the terms up to the first are bounded, in a jump none but the
/// value. A quotient whose parts are both exactly zero at the place, sin(t)/t at 0, is continued there.
/// @source Moore, Kearfott, Cloud, Introduction to Interval Analysis, chapter 9 (recurrences of the
/// coefficients).
struct Taylor {
  static constexpr int kOrder = 12;
  using Terms = std::array<Interval, kOrder + 1>;

  Terms box{};    ///< over the whole box; its first term has the decoration of the function
  Terms place{};  ///< at one place of the box

  Taylor() = default;
  Taylor(Interval constant) { box[0] = place[0] = constant; }  // NOLINT: a constant is a function

  /// The variable itself.
  [[nodiscard]] static Taylor of_variable(const Interval& box, double place);
};

[[nodiscard]] Taylor operator-(const Taylor& a);
[[nodiscard]] Taylor operator+(const Taylor& a, const Taylor& b);
[[nodiscard]] Taylor operator-(const Taylor& a, const Taylor& b);
[[nodiscard]] Taylor operator*(const Taylor& a, const Taylor& b);
[[nodiscard]] Taylor operator/(Taylor a, Taylor b);
[[nodiscard]] Taylor square(const Taylor& a);
[[nodiscard]] Taylor sqrt(const Taylor& a);
[[nodiscard]] Taylor exp(const Taylor& a);
[[nodiscard]] Taylor log(const Taylor& a);
[[nodiscard]] Taylor log2(const Taylor& a);
[[nodiscard]] Taylor log10(const Taylor& a);
[[nodiscard]] Taylor sin(const Taylor& a);
[[nodiscard]] Taylor cos(const Taylor& a);
[[nodiscard]] Taylor tan(const Taylor& a);
[[nodiscard]] Taylor asin(const Taylor& a);
[[nodiscard]] Taylor acos(const Taylor& a);
[[nodiscard]] Taylor atan(const Taylor& a);
[[nodiscard]] Taylor atan2(const Taylor& y, const Taylor& x);
[[nodiscard]] Taylor sinh(const Taylor& a);
[[nodiscard]] Taylor cosh(const Taylor& a);
[[nodiscard]] Taylor tanh(const Taylor& a);
[[nodiscard]] Taylor asinh(const Taylor& a);
[[nodiscard]] Taylor acosh(const Taylor& a);
[[nodiscard]] Taylor atanh(const Taylor& a);
[[nodiscard]] Taylor erf(const Taylor& a);
[[nodiscard]] Taylor gamma(const Taylor& a);
[[nodiscard]] Taylor abs(const Taylor& a);
[[nodiscard]] Taylor floor(const Taylor& a);
[[nodiscard]] Taylor ceil(const Taylor& a);
[[nodiscard]] Taylor sign(const Taylor& a);
[[nodiscard]] Taylor min(const Taylor& a, const Taylor& b);
[[nodiscard]] Taylor max(const Taylor& a, const Taylor& b);
[[nodiscard]] Taylor power(const Taylor& base, const Taylor& exponent);
[[nodiscard]] Taylor power_integer(const Taylor& base, int exponent);
[[nodiscard]] Taylor power_rational(const Taylor& base, int p, int q);
[[nodiscard]] Taylor at_least_zero(const Taylor& a);
[[nodiscard]] Taylor above_zero(const Taylor& a);
[[nodiscard]] Taylor where(const Taylor& condition, const Taylor& a);
[[nodiscard]] Taylor choose(const Taylor& condition, const Taylor& a, const Taylor& b);

/// The function with the given values whose derivative is `slope` times the derivative of `inner`.
[[nodiscard]] Taylor chained(const Taylor& values, const Taylor& slope, const Taylor& inner);

}  // namespace nazori::functions
