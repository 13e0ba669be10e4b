// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace nazori::functions {

/// What is proven of an operation over the whole box it was evaluated on; each grade includes those before.
/// @source IEEE Std 1788-2015, clause 8 (decorations trv, def, dac; the empty interval counts as undefined).
enum class Decoration : std::uint8_t {
  undefined,   ///< nowhere defined: the interval is empty
  partial,     ///< nothing proven: perhaps undefined or discontinuous somewhere (trv)
  defined,     ///< defined everywhere, perhaps with jumps (def)
  continuous,  ///< defined and continuous everywhere (dac)
};

/// Why an interval is not `continuous`, and whether a number overflowed its format. Bits.
enum class Cause : std::uint8_t {
  none = 0,
  pole = 1,      ///< a divisor contains zero, tan or gamma contains a pole
  domain = 2,    ///< an argument was cut to the domain of a root, logarithm, arc function or power
  jump = 4,      ///< floor, ceil, sign or atan2 steps inside
  overflow = 8,  ///< a bound is infinite only because of the format's limit
};
constexpr Cause operator|(Cause a, Cause b) {
  return static_cast<Cause>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
constexpr bool has(Cause set, Cause one) {
  return (static_cast<unsigned>(set) & static_cast<unsigned>(one)) != 0;
}

/// Outward rounding by steps of the last place, without touching the processor's rounding mode: safe on every
/// thread.
template <class R>
struct Rounding {
  static constexpr R kInf = std::numeric_limits<R>::infinity();
  static constexpr R kMax = std::numeric_limits<R>::max();
  /// A number closer to zero than this may be the result of an underflow from the next wider type.
  static constexpr R kVanishing = std::is_same_v<R, double> ? R(1e-290) : R(0);

  static R down(R v) {
    if constexpr (std::is_same_v<R, double>) {
      if (v == 0) return -std::numeric_limits<double>::denorm_min();
      if (v == -kInf || std::isnan(v)) return v;
      const auto bits = std::bit_cast<std::uint64_t>(v);
      return std::bit_cast<double>(v > 0 ? bits - 1 : bits + 1);
    } else {
      if (v == kInf) return kMax;
      return v - std::abs(v) * std::numeric_limits<R>::epsilon() - std::numeric_limits<R>::min();
    }
  }
  static R up(R v) { return -down(-v); }

  static R add_down(R a, R b) {
    const R s = a + b;
    if (!std::isfinite(s)) return s == kInf && std::isfinite(a) && std::isfinite(b) ? kMax : s;
    const R part = s - a;
    return (a - (s - part)) + (b - part) < 0 ? down(s) : s;
  }
  static R add_up(R a, R b) { return -add_down(-a, -b); }

  static R multiply_down(R a, R b) {
    if (a == 0 || b == 0) return 0;  // 0 times unbounded: the bound is not attained, the product is
    const R p = a * b;
    if (!std::isfinite(p)) return p == kInf && std::isfinite(a) && std::isfinite(b) ? kMax : p;
    if constexpr (std::is_same_v<R, double>) {
      // Below this the error of the product is itself not a double.
      if (std::abs(p) > 1e-290) return std::fma(a, b, -p) < 0 ? down(p) : p;
    }
    return down(p);
  }
  static R multiply_up(R a, R b) { return -multiply_down(-a, b); }

  /// @param b  not zero
  static R divide_down(R a, R b) {
    if (a == 0) return 0;
    const R q = a / b;
    if (std::isinf(b)) return std::isinf(a) ? R(0) : down(R(0));
    if (!std::isfinite(q)) return q == kInf && std::isfinite(a) ? kMax : q;
    if constexpr (std::is_same_v<R, double>) {
      if (std::abs(q) > 1e-290 && std::abs(a) > 1e-290) {
        const double rest = std::fma(q, b, -a);  // exact; q is too large where rest and b agree in sign
        return rest != 0 && (rest > 0) == (b > 0) ? down(q) : q;
      }
    }
    return down(q);
  }
  static R divide_up(R a, R b) { return -divide_down(-a, b); }

  /// For results of libm with an error of at most `n` units in the last place.
  static R down_by(R v, int n) {
    if (!std::isfinite(v)) return v == kInf ? kMax : v;
    return v - std::abs(v) * (static_cast<R>(n) * std::numeric_limits<R>::epsilon()) -
           std::numeric_limits<R>::min();
  }
  static R up_by(R v, int n) { return -down_by(-v, n); }
};

/// A closed interval that contains every value a function takes on a box, with the properties that are proven
/// of it.
///
/// Plain value, 24 bytes for double. Every operation is rounded outwards: the result contains the true value
/// for all arguments inside, checked in tests against MPFR. Thread-safe.
template <class R>
struct BasicInterval {
  using Real = R;
  R lower = 0;
  R upper = 0;
  Decoration decoration = Decoration::continuous;
  Cause cause = Cause::none;

  constexpr BasicInterval() = default;
  constexpr BasicInterval(R point) : lower(point), upper(point) {}  // NOLINT: a number is an interval
  constexpr BasicInterval(R low, R high, Decoration proven = Decoration::continuous, Cause why = Cause::none)
      : lower(low), upper(high), decoration(proven), cause(why) {}

  static constexpr BasicInterval empty(Cause why = Cause::domain) {
    return {Rounding<R>::kInf, -Rounding<R>::kInf, Decoration::undefined, why};
  }
  static constexpr BasicInterval entire(Decoration proven, Cause why) {
    return {-Rounding<R>::kInf, Rounding<R>::kInf, proven, why};
  }

  [[nodiscard]] bool is_empty() const { return !(lower <= upper); }
  [[nodiscard]] bool contains(R v) const { return lower <= v && v <= upper; }
  [[nodiscard]] bool is_point() const { return lower == upper; }
  [[nodiscard]] bool is_bounded() const { return std::isfinite(lower) && std::isfinite(upper); }
  [[nodiscard]] bool is_continuous() const { return decoration == Decoration::continuous; }
  [[nodiscard]] R width() const { return upper - lower; }
  [[nodiscard]] R middle() const { return lower + (upper - lower) / 2; }
  [[nodiscard]] R magnitude() const { return std::max(std::abs(lower), std::abs(upper)); }

  /// The same range with the decoration reduced to at most `proven`.
  [[nodiscard]] BasicInterval weakened(Decoration proven, Cause why) const {
    return {lower, upper, std::min(decoration, proven), cause | why};
  }
};

using Interval = BasicInterval<double>;
/// For numbers that overflow a double: exponents to 4932.
using LongInterval = BasicInterval<long double>;

namespace detail {

template <class R>
BasicInterval<R> with_proof_of(BasicInterval<R> r, const BasicInterval<R>& a) {
  r.decoration = std::min(r.decoration, a.decoration);
  r.cause = r.cause | a.cause;
  return r;
}

template <class R>
BasicInterval<R> with_proof_of(BasicInterval<R> r, const BasicInterval<R>& a, const BasicInterval<R>& b) {
  return with_proof_of(with_proof_of(r, a), b);
}

/// Marks bounds that are infinite although the arguments are not.
template <class R>
BasicInterval<R> marked(BasicInterval<R> r, bool arguments_bounded) {
  if (arguments_bounded && !r.is_bounded()) r.cause = r.cause | Cause::overflow;
  return r;
}

}  // namespace detail

template <class R>
BasicInterval<R> operator-(const BasicInterval<R>& a) {
  return {-a.upper, -a.lower, a.decoration, a.cause};
}

template <class R>
BasicInterval<R> operator+(const BasicInterval<R>& a, const BasicInterval<R>& b) {
  if (a.is_empty() || b.is_empty()) return BasicInterval<R>::empty(a.cause | b.cause);
  return detail::with_proof_of(
      {Rounding<R>::add_down(a.lower, b.lower), Rounding<R>::add_up(a.upper, b.upper)}, a, b);
}

template <class R>
BasicInterval<R> operator-(const BasicInterval<R>& a, const BasicInterval<R>& b) {
  return a + (-b);
}

template <class R>
BasicInterval<R> operator*(const BasicInterval<R>& a, const BasicInterval<R>& b) {
  using Q = Rounding<R>;
  if (a.is_empty() || b.is_empty()) return BasicInterval<R>::empty(a.cause | b.cause);
  R low;
  R high;
  if (a.lower >= 0) {
    low = Q::multiply_down(b.lower >= 0 ? a.lower : a.upper, b.lower);
    high = Q::multiply_up(b.upper >= 0 ? a.upper : a.lower, b.upper);
  } else if (a.upper <= 0) {
    low = Q::multiply_down(b.upper >= 0 ? a.lower : a.upper, b.upper);
    high = Q::multiply_up(b.lower >= 0 ? a.upper : a.lower, b.lower);
  } else if (b.lower >= 0) {
    low = Q::multiply_down(a.lower, b.upper);
    high = Q::multiply_up(a.upper, b.upper);
  } else if (b.upper <= 0) {
    low = Q::multiply_down(a.upper, b.lower);
    high = Q::multiply_up(a.lower, b.lower);
  } else {
    low = std::min(Q::multiply_down(a.lower, b.upper), Q::multiply_down(a.upper, b.lower));
    high = std::max(Q::multiply_up(a.lower, b.lower), Q::multiply_up(a.upper, b.upper));
  }
  return detail::marked(detail::with_proof_of({low, high}, a, b), a.is_bounded() && b.is_bounded());
}

template <class R>
BasicInterval<R> operator/(const BasicInterval<R>& a, const BasicInterval<R>& b) {
  using Q = Rounding<R>;
  using I = BasicInterval<R>;
  if (a.is_empty() || b.is_empty()) return I::empty(a.cause | b.cause);
  if (b.contains(0)) {
    Cause why = a.cause | b.cause | Cause::pole;
    // So close to zero that it may have underflowed in this type: 2^x/(2^x + 3^x).
    if (std::max(-b.lower, b.upper) <= Q::kVanishing) why = why | Cause::overflow;
    if (b.is_point()) return I::empty(why);
    if (a.is_point() && a.lower == 0) return {0, 0, Decoration::partial, why};
    R low = -Q::kInf;
    R high = Q::kInf;
    if (b.lower == 0) {
      if (a.lower >= 0) low = Q::divide_down(a.lower, b.upper);
      if (a.upper <= 0) high = Q::divide_up(a.upper, b.upper);
    } else if (b.upper == 0) {
      if (a.lower >= 0) high = Q::divide_up(a.lower, b.lower);
      if (a.upper <= 0) low = Q::divide_down(a.upper, b.lower);
    }
    return {low, high, Decoration::partial, why};
  }
  R low;
  R high;
  if (b.lower > 0) {
    low = Q::divide_down(a.lower, a.lower >= 0 ? b.upper : b.lower);
    high = Q::divide_up(a.upper, a.upper >= 0 ? b.lower : b.upper);
  } else {
    low = Q::divide_down(a.upper, a.upper >= 0 ? b.upper : b.lower);
    high = Q::divide_up(a.lower, a.lower >= 0 ? b.lower : b.upper);
  }
  return detail::marked(detail::with_proof_of({low, high}, a, b), a.is_bounded());
}

/// The smallest interval around both; the weaker proof of the two.
template <class R>
BasicInterval<R> hull(const BasicInterval<R>& a, const BasicInterval<R>& b) {
  if (a.is_empty()) return b;
  if (b.is_empty()) return a;
  return detail::with_proof_of({std::min(a.lower, b.lower), std::max(a.upper, b.upper)}, a, b);
}

template <class R>
BasicInterval<R> square(const BasicInterval<R>& a) {
  using Q = Rounding<R>;
  if (a.is_empty()) return a;
  const R big = a.magnitude();
  const R small = a.contains(0) ? R(0) : std::min(std::abs(a.lower), std::abs(a.upper));
  return detail::marked(
      detail::with_proof_of({std::max(R(0), Q::multiply_down(small, small)), Q::multiply_up(big, big)}, a),
      a.is_bounded());
}

template <class R>
BasicInterval<R> abs(const BasicInterval<R>& a) {
  if (a.is_empty()) return a;
  if (a.lower >= 0) return a;
  if (a.upper <= 0) return -a;
  return detail::with_proof_of({R(0), a.magnitude()}, a);
}

template <class R>
BasicInterval<R> min(const BasicInterval<R>& a, const BasicInterval<R>& b) {
  if (a.is_empty() || b.is_empty()) return BasicInterval<R>::empty(a.cause | b.cause);
  return detail::with_proof_of({std::min(a.lower, b.lower), std::min(a.upper, b.upper)}, a, b);
}

template <class R>
BasicInterval<R> max(const BasicInterval<R>& a, const BasicInterval<R>& b) {
  return -min(-a, -b);
}

namespace detail {

/// 1 where a sign is proven, 0 where its opposite is, [0, 1] with a jump where both may occur.
template <class R>
BasicInterval<R> truth(const BasicInterval<R>& a, bool always, bool never) {
  if (a.is_empty()) return a;
  const Decoration proven =
      a.decoration >= Decoration::defined ? Decoration::continuous : Decoration::partial;
  if (always) return {R(1), R(1), proven, a.cause};
  if (never) return {R(0), R(0), proven, a.cause};
  return {R(0), R(1), std::min(proven, Decoration::defined), a.cause | Cause::jump};
}

}  // namespace detail

/// 1 where a >= 0, else 0. What is constant over the box is continuous, also of an `a` that jumps.
template <class R>
BasicInterval<R> at_least_zero(const BasicInterval<R>& a) {
  return detail::truth(a, a.lower >= 0, a.upper < 0);
}
/// 1 where a > 0, else 0.
template <class R>
BasicInterval<R> above_zero(const BasicInterval<R>& a) {
  return detail::truth(a, a.lower > 0, a.upper <= 0);
}
/// `a` where the condition is 1, undefined where it is 0.
template <class R>
BasicInterval<R> where(const BasicInterval<R>& condition, const BasicInterval<R>& a) {
  if (condition.is_empty() || a.is_empty() || condition.upper < R(0.5))
    return BasicInterval<R>::empty(condition.cause | a.cause | Cause::domain);
  if (condition.lower > R(0.5) && condition.decoration >= Decoration::defined) return a;
  return a.weakened(Decoration::partial, condition.cause | Cause::domain);
}
/// `a` where the condition is 1, `b` where it is 0.
template <class R>
BasicInterval<R> choose(const BasicInterval<R>& condition, const BasicInterval<R>& a,
                        const BasicInterval<R>& b) {
  if (condition.is_empty()) return condition;
  const bool proven = condition.decoration >= Decoration::defined;
  if (condition.lower > R(0.5) || condition.upper < R(0.5)) {
    const BasicInterval<R>& only = condition.lower > R(0.5) ? a : b;
    return proven || only.is_empty() ? only : only.weakened(Decoration::partial, condition.cause);
  }
  if (a.is_empty() && b.is_empty()) return BasicInterval<R>::empty(a.cause | b.cause);
  const bool one_is_empty = a.is_empty() || b.is_empty();
  return hull(a, b).weakened(one_is_empty || !proven ? Decoration::partial : Decoration::defined,
                             condition.cause | (one_is_empty ? Cause::domain : Cause::jump));
}

// The elementary functions over double and long double (interval.cpp, interval_special.cpp). Arguments
// outside a domain are cut off and weaken the proof; `power` takes real powers of a base that is not
// negative, `power_integer` whole powers of any base, `power_rational` the real p/q-th power, q > 0, p/q in
// lowest terms, which for odd q exists for a negative base too.
template <class R>
BasicInterval<R> sqrt(const BasicInterval<R>& a);
template <class R>
BasicInterval<R> exp(const BasicInterval<R>& a);
template <class R>
BasicInterval<R> log(const BasicInterval<R>& a);
template <class R>
BasicInterval<R> log2(const BasicInterval<R>& a);
template <class R>
BasicInterval<R> log10(const BasicInterval<R>& a);
template <class R>
BasicInterval<R> sin(const BasicInterval<R>& a);
template <class R>
BasicInterval<R> cos(const BasicInterval<R>& a);
template <class R>
BasicInterval<R> tan(const BasicInterval<R>& a);
template <class R>
BasicInterval<R> asin(const BasicInterval<R>& a);
template <class R>
BasicInterval<R> acos(const BasicInterval<R>& a);
template <class R>
BasicInterval<R> atan(const BasicInterval<R>& a);
template <class R>
BasicInterval<R> atan2(const BasicInterval<R>& y, const BasicInterval<R>& x);
template <class R>
BasicInterval<R> sinh(const BasicInterval<R>& a);
template <class R>
BasicInterval<R> cosh(const BasicInterval<R>& a);
template <class R>
BasicInterval<R> tanh(const BasicInterval<R>& a);
template <class R>
BasicInterval<R> asinh(const BasicInterval<R>& a);
template <class R>
BasicInterval<R> acosh(const BasicInterval<R>& a);
template <class R>
BasicInterval<R> atanh(const BasicInterval<R>& a);
template <class R>
BasicInterval<R> erf(const BasicInterval<R>& a);
template <class R>
BasicInterval<R> gamma(const BasicInterval<R>& a);
template <class R>
BasicInterval<R> digamma(const BasicInterval<R>& a);
template <class R>
BasicInterval<R> floor(const BasicInterval<R>& a);
template <class R>
BasicInterval<R> ceil(const BasicInterval<R>& a);
template <class R>
BasicInterval<R> sign(const BasicInterval<R>& a);
template <class R>
BasicInterval<R> power(const BasicInterval<R>& base, const BasicInterval<R>& exponent);
template <class R>
BasicInterval<R> power_integer(const BasicInterval<R>& base, int exponent);
template <class R>
BasicInterval<R> power_rational(const BasicInterval<R>& base, int p, int q);

}  // namespace nazori::functions
