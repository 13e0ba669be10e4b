// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "nazori/functions/interval.h"

namespace nazori::functions {

// The operations of a tape on plain numbers that <cmath> lacks: NaN where undefined, the same conventions as
// intervals.
[[nodiscard]] double power_integer(double base, int exponent);
[[nodiscard]] long double power_integer(long double base, int exponent);
[[nodiscard]] double power_rational(double base, int p, int q);
[[nodiscard]] long double power_rational(long double base, int p, int q);
[[nodiscard]] double power(double base, double exponent);
[[nodiscard]] long double power(long double base, long double exponent);
[[nodiscard]] double gamma(double v);
[[nodiscard]] long double gamma(long double v);
[[nodiscard]] double digamma(double v);
[[nodiscard]] long double digamma(long double v);
[[nodiscard]] inline double square(double v) { return v * v; }
[[nodiscard]] inline long double square(long double v) { return v * v; }
[[nodiscard]] inline double sign(double v) { return std::isnan(v) ? v : (v > 0) - (v < 0); }
[[nodiscard]] inline long double sign(long double v) {
  return std::isnan(v) ? v : static_cast<long double>((v > 0) - (v < 0));
}
[[nodiscard]] inline double min(double a, double b) { return std::isnan(a) || a < b ? a : b; }
[[nodiscard]] inline long double min(long double a, long double b) { return std::isnan(a) || a < b ? a : b; }
[[nodiscard]] inline double max(double a, double b) { return std::isnan(a) || a > b ? a : b; }
[[nodiscard]] inline long double max(long double a, long double b) { return std::isnan(a) || a > b ? a : b; }

[[nodiscard]] inline double at_least_zero(double v) { return std::isnan(v) ? v : v >= 0 ? 1 : 0; }
[[nodiscard]] inline long double at_least_zero(long double v) { return std::isnan(v) ? v : v >= 0 ? 1 : 0; }
[[nodiscard]] inline double above_zero(double v) { return std::isnan(v) ? v : v > 0 ? 1 : 0; }
[[nodiscard]] inline long double above_zero(long double v) { return std::isnan(v) ? v : v > 0 ? 1 : 0; }
[[nodiscard]] inline double where(double condition, double a) {
  return condition > 0.5 ? a : std::numeric_limits<double>::quiet_NaN();
}
[[nodiscard]] inline long double where(long double condition, long double a) {
  return condition > 0.5L ? a : std::numeric_limits<long double>::quiet_NaN();
}
[[nodiscard]] inline double choose(double condition, double a, double b) {
  return std::isnan(condition) ? condition : condition > 0.5 ? a : b;
}
[[nodiscard]] inline long double choose(long double condition, long double a, long double b) {
  return std::isnan(condition) ? condition : condition > 0.5L ? a : b;
}

/// A value with its derivatives by N variables (forward mode). Over intervals the derivatives enclose every
/// slope on the box, one-sided slopes at corners included; their decorations are not used. Thread-safe.
template <class T, int N>
struct Dual {
  T value{};
  std::array<T, N> slopes{};

  Dual() = default;
  Dual(T v) : value(v) { slopes.fill(T(0)); }  // NOLINT: a constant is a dual
  /// The variable number `which`.
  Dual(T v, int which) : Dual(v) { slopes[static_cast<std::size_t>(which)] = T(1); }
};

namespace detail {

template <class T, int N>
Dual<T, N> chain(const Dual<T, N>& a, T value, T slope) {
  Dual<T, N> r(value);
  for (std::size_t i = 0; i < N; ++i) r.slopes[i] = slope * a.slopes[i];
  return r;
}

inline bool is_zero(double v) { return v == 0; }
inline bool is_zero(long double v) { return v == 0; }
template <class R>
bool is_zero(const BasicInterval<R>& v) {
  return v.lower == 0 && v.upper == 0;
}

inline double slope_of_abs(double v) { return sign(v); }
inline long double slope_of_abs(long double v) { return sign(v); }
template <class R>
BasicInterval<R> slope_of_abs(const BasicInterval<R>& v) {
  if (v.lower > 0) return R(1);
  if (v.upper < 0) return R(-1);
  return {R(-1), R(1)};
}

template <class T>
T slope_of_step(const T& /*step*/) {
  return T(0);
}
template <class R>
BasicInterval<R> slope_of_step(const BasicInterval<R>& step) {
  return step.is_point() ? BasicInterval<R>(R(0))
                         : BasicInterval<R>::entire(Decoration::partial, Cause::jump);
}

/// For min and max: 1 uses the slope of a, 0 that of b, anything between is both.
template <class T>
T share_of_smaller(const T& a, const T& b) {
  return T(a < b ? 1 : 0);
}
template <class R>
BasicInterval<R> share_of_smaller(const BasicInterval<R>& a, const BasicInterval<R>& b) {
  if (a.upper < b.lower) return R(1);
  if (b.upper < a.lower) return R(0);
  return {R(0), R(1)};
}

template <class T>
T slope_of_choice(const T& condition, const T& a, const T& b) {
  return choose(condition, a, b);
}
/// Where both cases are in the box the value may jump between them.
template <class R>
BasicInterval<R> slope_of_choice(const BasicInterval<R>& condition, const BasicInterval<R>& a,
                                 const BasicInterval<R>& b) {
  if (condition.lower > R(0.5)) return a;
  if (condition.upper < R(0.5)) return b;
  return BasicInterval<R>::entire(Decoration::partial, Cause::jump);
}

template <class T>
T mixed(const T& a, const T& b, const T& share) {
  return share * a + (T(1) - share) * b;
}
template <class R>
BasicInterval<R> mixed(const BasicInterval<R>& a, const BasicInterval<R>& b, const BasicInterval<R>& share) {
  if (share.lower == R(1)) return a;
  if (share.upper == R(0)) return b;
  return hull(a, b);
}

}  // namespace detail

template <class T, int N>
Dual<T, N> operator-(const Dual<T, N>& a) {
  Dual<T, N> r(-a.value);
  for (std::size_t i = 0; i < N; ++i) r.slopes[i] = -a.slopes[i];
  return r;
}
template <class T, int N>
Dual<T, N> operator+(const Dual<T, N>& a, const Dual<T, N>& b) {
  Dual<T, N> r(a.value + b.value);
  for (std::size_t i = 0; i < N; ++i) r.slopes[i] = a.slopes[i] + b.slopes[i];
  return r;
}
template <class T, int N>
Dual<T, N> operator-(const Dual<T, N>& a, const Dual<T, N>& b) {
  Dual<T, N> r(a.value - b.value);
  for (std::size_t i = 0; i < N; ++i) r.slopes[i] = a.slopes[i] - b.slopes[i];
  return r;
}
template <class T, int N>
Dual<T, N> operator*(const Dual<T, N>& a, const Dual<T, N>& b) {
  Dual<T, N> r(a.value * b.value);
  for (std::size_t i = 0; i < N; ++i) r.slopes[i] = a.slopes[i] * b.value + a.value * b.slopes[i];
  return r;
}
template <class T, int N>
Dual<T, N> operator/(const Dual<T, N>& a, const Dual<T, N>& b) {
  Dual<T, N> r(a.value / b.value);
  for (std::size_t i = 0; i < N; ++i) r.slopes[i] = (a.slopes[i] - r.value * b.slopes[i]) / b.value;
  return r;
}

template <class T, int N>
Dual<T, N> square(const Dual<T, N>& a) {
  return detail::chain(a, square(a.value), T(2) * a.value);
}
template <class T, int N>
Dual<T, N> abs(const Dual<T, N>& a) {
  using std::abs;
  return detail::chain(a, T(abs(a.value)), T(detail::slope_of_abs(a.value)));
}
template <class T, int N>
Dual<T, N> sqrt(const Dual<T, N>& a) {
  using std::sqrt;
  const T s = sqrt(a.value);
  return detail::chain(a, s, T(1) / (T(2) * s));
}
template <class T, int N>
Dual<T, N> exp(const Dual<T, N>& a) {
  using std::exp;
  const T e = exp(a.value);
  return detail::chain(a, e, e);
}
template <class T, int N>
Dual<T, N> log(const Dual<T, N>& a) {
  using std::log;
  return detail::chain(a, T(log(a.value)), T(1) / a.value);
}
template <class T, int N>
Dual<T, N> log2(const Dual<T, N>& a) {
  using std::log, std::log2;
  return detail::chain(a, T(log2(a.value)), T(1) / (T(log(T(2))) * a.value));
}
template <class T, int N>
Dual<T, N> log10(const Dual<T, N>& a) {
  using std::log, std::log10;
  return detail::chain(a, T(log10(a.value)), T(1) / (T(log(T(10))) * a.value));
}
template <class T, int N>
Dual<T, N> sin(const Dual<T, N>& a) {
  using std::cos;
  using std::sin;
  return detail::chain(a, T(sin(a.value)), T(cos(a.value)));
}
template <class T, int N>
Dual<T, N> cos(const Dual<T, N>& a) {
  using std::cos;
  using std::sin;
  return detail::chain(a, T(cos(a.value)), T(-sin(a.value)));
}
template <class T, int N>
Dual<T, N> tan(const Dual<T, N>& a) {
  using std::tan;
  const T t = tan(a.value);
  return detail::chain(a, t, T(1) + square(t));
}
template <class T, int N>
Dual<T, N> asin(const Dual<T, N>& a) {
  using std::asin;
  using std::sqrt;
  return detail::chain(a, T(asin(a.value)), T(1) / T(sqrt(T(1) - square(a.value))));
}
template <class T, int N>
Dual<T, N> acos(const Dual<T, N>& a) {
  using std::acos;
  using std::sqrt;
  return detail::chain(a, T(acos(a.value)), T(-1) / T(sqrt(T(1) - square(a.value))));
}
template <class T, int N>
Dual<T, N> atan(const Dual<T, N>& a) {
  using std::atan;
  return detail::chain(a, T(atan(a.value)), T(1) / (T(1) + square(a.value)));
}
template <class T, int N>
Dual<T, N> sinh(const Dual<T, N>& a) {
  using std::cosh;
  using std::sinh;
  return detail::chain(a, T(sinh(a.value)), T(cosh(a.value)));
}
template <class T, int N>
Dual<T, N> cosh(const Dual<T, N>& a) {
  using std::cosh;
  using std::sinh;
  return detail::chain(a, T(cosh(a.value)), T(sinh(a.value)));
}
template <class T, int N>
Dual<T, N> tanh(const Dual<T, N>& a) {
  using std::tanh;
  const T t = tanh(a.value);
  return detail::chain(a, t, T(1) - square(t));
}
template <class T, int N>
Dual<T, N> asinh(const Dual<T, N>& a) {
  using std::asinh;
  using std::sqrt;
  return detail::chain(a, T(asinh(a.value)), T(1) / T(sqrt(T(1) + square(a.value))));
}
template <class T, int N>
Dual<T, N> acosh(const Dual<T, N>& a) {
  using std::acosh;
  using std::sqrt;
  return detail::chain(a, T(acosh(a.value)), T(1) / T(sqrt(square(a.value) - T(1))));
}
template <class T, int N>
Dual<T, N> atanh(const Dual<T, N>& a) {
  using std::atanh;
  return detail::chain(a, T(atanh(a.value)), T(1) / (T(1) - square(a.value)));
}
template <class T, int N>
Dual<T, N> erf(const Dual<T, N>& a) {
  using std::acos, std::erf, std::exp, std::sqrt;
  const T root_of_pi = sqrt(T(acos(T(-1))));
  return detail::chain(a, T(erf(a.value)), T(2) / root_of_pi * T(exp(-square(a.value))));
}
template <class T, int N>
Dual<T, N> gamma(const Dual<T, N>& a) {
  const T g = gamma(a.value);
  return detail::chain(a, g, g * digamma(a.value));
}
template <class T, int N>
Dual<T, N> floor(const Dual<T, N>& a) {
  using std::floor;
  const T step = floor(a.value);
  return detail::chain(a, step, T(detail::slope_of_step(step)));
}
template <class T, int N>
Dual<T, N> ceil(const Dual<T, N>& a) {
  using std::ceil;
  const T step = ceil(a.value);
  return detail::chain(a, step, T(detail::slope_of_step(step)));
}
template <class T, int N>
Dual<T, N> sign(const Dual<T, N>& a) {
  const T step = sign(a.value);
  return detail::chain(a, step, T(detail::slope_of_step(step)));
}
template <class T, int N>
Dual<T, N> power_integer(const Dual<T, N>& a, int n) {
  if (n == 0) return Dual<T, N>(power_integer(a.value, 0));
  return detail::chain(a, power_integer(a.value, n), T(n) * power_integer(a.value, n - 1));
}
template <class T, int N>
Dual<T, N> power_rational(const Dual<T, N>& a, int p, int q) {
  return detail::chain(a, power_rational(a.value, p, q), T(p) / T(q) * power_rational(a.value, p - q, q));
}
template <class T, int N>
Dual<T, N> power(const Dual<T, N>& a, const Dual<T, N>& b) {
  using std::log;
  Dual<T, N> r(power(a.value, b.value));
  const T base_log = log(a.value);
  for (std::size_t i = 0; i < N; ++i) {
    // A base below zero has whole, constant exponents only: no logarithm is needed.
    const T of_base = b.value * a.slopes[i] / a.value;
    r.slopes[i] = r.value * (detail::is_zero(b.slopes[i]) ? of_base : b.slopes[i] * base_log + of_base);
  }
  return r;
}
template <class T, int N>
Dual<T, N> min(const Dual<T, N>& a, const Dual<T, N>& b) {
  Dual<T, N> r(min(a.value, b.value));
  const T share = detail::share_of_smaller(a.value, b.value);
  for (std::size_t i = 0; i < N; ++i) r.slopes[i] = detail::mixed(a.slopes[i], b.slopes[i], share);
  return r;
}
template <class T, int N>
Dual<T, N> max(const Dual<T, N>& a, const Dual<T, N>& b) {
  return -min(-a, -b);
}
template <class T, int N>
Dual<T, N> atan2(const Dual<T, N>& y, const Dual<T, N>& x) {
  using std::atan2;
  Dual<T, N> r(T(atan2(y.value, x.value)));
  const T radius = square(x.value) + square(y.value);
  for (std::size_t i = 0; i < N; ++i) r.slopes[i] = (x.value * y.slopes[i] - y.value * x.slopes[i]) / radius;
  return r;
}

template <class T, int N>
Dual<T, N> at_least_zero(const Dual<T, N>& a) {
  return Dual<T, N>(at_least_zero(a.value));
}
template <class T, int N>
Dual<T, N> above_zero(const Dual<T, N>& a) {
  return Dual<T, N>(above_zero(a.value));
}
template <class T, int N>
Dual<T, N> where(const Dual<T, N>& condition, const Dual<T, N>& a) {
  Dual<T, N> r(where(condition.value, a.value));
  r.slopes = a.slopes;
  return r;
}
template <class T, int N>
Dual<T, N> choose(const Dual<T, N>& condition, const Dual<T, N>& a, const Dual<T, N>& b) {
  Dual<T, N> r(choose(condition.value, a.value, b.value));
  for (std::size_t i = 0; i < N; ++i)
    r.slopes[i] = detail::slope_of_choice(condition.value, a.slopes[i], b.slopes[i]);
  return r;
}

}  // namespace nazori::functions
