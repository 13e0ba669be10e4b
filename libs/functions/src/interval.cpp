// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/interval.h"

#include <numbers>

namespace nazori::functions {
namespace {

// glibc documents at most 1 to 2 units in the last place for these (manual, "Known Maximum Errors in Math
// Functions"); one more for the hyperbolic ones.
constexpr int kUlps = 3;

/// Bounds of a value that libm computed at `argument`; at 0 all of these functions are exact.
template <class R>
R below(R value, R argument, int ulps = kUlps) {
  return argument == 0 ? value : Rounding<R>::down_by(value, ulps);
}
template <class R>
R above(R value, R argument, int ulps = kUlps) {
  return argument == 0 ? value : Rounding<R>::up_by(value, ulps);
}

/// Rising function, defined everywhere.
template <class R, class F>
BasicInterval<R> rising(const BasicInterval<R>& a, F f, R least, R most, int ulps = kUlps) {
  if (a.is_empty()) return a;
  return detail::marked(detail::with_proof_of({std::max(least, below(f(a.lower), a.lower, ulps)),
                                               std::min(most, above(f(a.upper), a.upper, ulps))},
                                              a),
                        a.is_bounded());
}

/// The argument without its part outside [least, most].
template <class R>
BasicInterval<R> cut(BasicInterval<R> a, R least, R most) {
  if (a.is_empty()) return a;
  if (a.upper < least || a.lower > most) return BasicInterval<R>::empty(a.cause | Cause::domain);
  if (a.lower < least || a.upper > most) a = a.weakened(Decoration::partial, Cause::domain);
  a.lower = std::max(a.lower, least);
  a.upper = std::min(a.upper, most);
  return a;
}

template <class R>
constexpr R kInf = std::numeric_limits<R>::infinity();

/// Whether some offset + k * period (k whole) may lie in the interval; never wrongly false.
template <class R>
bool may_hit(const BasicInterval<R>& a, R offset, R period) {
  constexpr R kSlack = 8 * std::numeric_limits<R>::epsilon();
  const R first = (a.lower - offset) / period;
  const R last = (a.upper - offset) / period;
  return std::floor(last + kSlack * (std::abs(last) + 1)) >=
         std::ceil(first - kSlack * (std::abs(first) + 1));
}

constexpr long double kPi = std::numbers::pi_v<long double>;
// Beyond this the position within a period is lost in the argument's own last place.
constexpr double kLargestAngle = 1e12;

template <class R>
BasicInterval<R> logarithm(const BasicInterval<R>& argument, R (*f)(R)) {
  if (!argument.is_empty() && argument.upper <= 0)
    return BasicInterval<R>::empty(argument.cause | Cause::domain);
  BasicInterval<R> a = cut(argument, R(0), kInf<R>);
  if (a.is_empty()) return a;
  // Goes to -infinity towards 0: the end of the domain is also a pole.
  if (a.lower == 0) a = a.weakened(Decoration::partial, Cause::domain | Cause::pole);
  // Exact at 1.
  const R low = a.lower == 0 ? -kInf<R> : below(f(a.lower), a.lower - 1);
  return detail::with_proof_of({low, above(f(a.upper), a.upper - 1)}, a);
}

}  // namespace

template <class R>
BasicInterval<R> sqrt(const BasicInterval<R>& argument) {
  const BasicInterval<R> a = cut(argument, R(0), kInf<R>);
  if (a.is_empty()) return a;
  using Q = Rounding<R>;
  // The processor's square root is correctly rounded: exact where its square gives the argument back exactly.
  const auto is_exact = [](R v, R s) { return s == std::floor(s) && s < R(67108864) && s * s == v; };
  const R low = std::sqrt(a.lower);
  const R high = std::sqrt(a.upper);
  return detail::with_proof_of({is_exact(a.lower, low) ? low : std::max(R(0), Q::down(low)),
                                is_exact(a.upper, high) ? high : Q::up(high)},
                               a);
}

template <class R>
BasicInterval<R> exp(const BasicInterval<R>& a) {
  return rising(
      a, [](R v) { return std::exp(v); }, R(0), kInf<R>);
}

template <class R>
BasicInterval<R> log(const BasicInterval<R>& a) {
  return logarithm<R>(a, [](R v) { return std::log(v); });
}
template <class R>
BasicInterval<R> log2(const BasicInterval<R>& a) {
  return logarithm<R>(a, [](R v) { return std::log2(v); });
}
template <class R>
BasicInterval<R> log10(const BasicInterval<R>& a) {
  return logarithm<R>(a, [](R v) { return std::log10(v); });
}

template <class R>
BasicInterval<R> sin(const BasicInterval<R>& a) {
  if (a.is_empty()) return a;
  constexpr R kTwoPi = static_cast<R>(2 * kPi);
  if (!a.is_bounded() || a.magnitude() > R(kLargestAngle) || a.width() >= kTwoPi)
    return detail::with_proof_of({R(-1), R(1)}, a);
  const R first = std::sin(a.lower);
  const R last = std::sin(a.upper);
  const R low = may_hit(a, static_cast<R>(-kPi / 2), kTwoPi)
                    ? R(-1)
                    : std::max(R(-1), std::min(below(first, a.lower), below(last, a.upper)));
  const R high = may_hit(a, static_cast<R>(kPi / 2), kTwoPi)
                     ? R(1)
                     : std::min(R(1), std::max(above(first, a.lower), above(last, a.upper)));
  return detail::with_proof_of({low, high}, a);
}

template <class R>
BasicInterval<R> cos(const BasicInterval<R>& a) {
  if (a.is_empty()) return a;
  constexpr R kTwoPi = static_cast<R>(2 * kPi);
  if (!a.is_bounded() || a.magnitude() > R(kLargestAngle) || a.width() >= kTwoPi)
    return detail::with_proof_of({R(-1), R(1)}, a);
  const R first = std::cos(a.lower);
  const R last = std::cos(a.upper);
  const R low = may_hit(a, static_cast<R>(kPi), kTwoPi)
                    ? R(-1)
                    : std::max(R(-1), std::min(below(first, a.lower), below(last, a.upper)));
  const R high =
      may_hit(a, R(0), kTwoPi) ? R(1) : std::min(R(1), std::max(above(first, a.lower), above(last, a.upper)));
  return detail::with_proof_of({low, high}, a);
}

template <class R>
BasicInterval<R> tan(const BasicInterval<R>& a) {
  if (a.is_empty()) return a;
  constexpr R kThePi = static_cast<R>(kPi);
  if (!a.is_bounded() || a.magnitude() > R(kLargestAngle) || a.width() >= kThePi ||
      may_hit(a, kThePi / 2, kThePi))
    return BasicInterval<R>::entire(std::min(a.decoration, Decoration::partial), a.cause | Cause::pole);
  return rising(
      a, [](R v) { return std::tan(v); }, -kInf<R>, kInf<R>);
}

template <class R>
BasicInterval<R> asin(const BasicInterval<R>& a) {
  return rising(
      cut(a, R(-1), R(1)), [](R v) { return std::asin(v); }, -kInf<R>, kInf<R>);
}
template <class R>
BasicInterval<R> acos(const BasicInterval<R>& a) {
  const BasicInterval<R> inside = cut(a, R(-1), R(1));
  if (inside.is_empty()) return inside;
  using Q = Rounding<R>;
  return detail::with_proof_of(
      {std::max(R(0), Q::down_by(std::acos(inside.upper), kUlps)), Q::up_by(std::acos(inside.lower), kUlps)},
      inside);
}
template <class R>
BasicInterval<R> atan(const BasicInterval<R>& a) {
  return rising(
      a, [](R v) { return std::atan(v); }, -kInf<R>, kInf<R>);
}

template <class R>
BasicInterval<R> sinh(const BasicInterval<R>& a) {
  return rising(
      a, [](R v) { return std::sinh(v); }, -kInf<R>, kInf<R>);
}
template <class R>
BasicInterval<R> cosh(const BasicInterval<R>& a) {
  return rising(
      abs(a), [](R v) { return std::cosh(v); }, R(1), kInf<R>);
}
template <class R>
BasicInterval<R> tanh(const BasicInterval<R>& a) {
  return rising(
      a, [](R v) { return std::tanh(v); }, R(-1), R(1));
}
template <class R>
BasicInterval<R> asinh(const BasicInterval<R>& a) {
  return rising(
      a, [](R v) { return std::asinh(v); }, -kInf<R>, kInf<R>);
}
template <class R>
BasicInterval<R> acosh(const BasicInterval<R>& a) {
  return rising(
      cut(a, R(1), kInf<R>), [](R v) { return std::acosh(v); }, R(0), kInf<R>);
}
template <class R>
BasicInterval<R> atanh(const BasicInterval<R>& a) {
  if (!a.is_empty() && (a.upper <= -1 || a.lower >= 1))
    return BasicInterval<R>::empty(a.cause | Cause::domain);
  BasicInterval<R> inside = cut(a, R(-1), R(1));
  if (inside.is_empty()) return inside;
  if (inside.lower == -1 || inside.upper == 1) inside = inside.weakened(Decoration::partial, Cause::domain);
  return rising(
      inside, [](R v) { return std::atanh(v); }, -kInf<R>, kInf<R>);
}
template <class R>
BasicInterval<R> erf(const BasicInterval<R>& a) {
  return rising(
      a, [](R v) { return std::erf(v); }, R(-1), R(1));
}

template <class R>
BasicInterval<R> atan2(const BasicInterval<R>& y, const BasicInterval<R>& x) {
  using Q = Rounding<R>;
  using I = BasicInterval<R>;
  if (y.is_empty() || x.is_empty()) return I::empty(x.cause | y.cause);
  if (y.is_point() && y.lower == 0 && x.is_point() && x.lower == 0) return I::empty();
  const R pi_up = Q::up_by(static_cast<R>(kPi), 1);
  if (y.contains(0) && x.lower <= 0) {
    if (x.upper >= 0) {
      const R low = y.lower < 0 ? -pi_up : R(0);
      return detail::with_proof_of({low, pi_up, Decoration::partial, Cause::domain}, x, y);
    }
    // Only the negative axis: a step from -pi to pi, none if the box is on the upper side only.
    if (y.lower < 0) return detail::with_proof_of({-pi_up, pi_up, Decoration::defined, Cause::jump}, x, y);
  }
  R low = kInf<R>;
  R high = -kInf<R>;
  for (const R cy : {y.lower, y.upper}) {
    for (const R cx : {x.lower, x.upper}) {
      const R v = std::atan2(cy == 0 ? R(0) : cy, cx);
      low = std::min(low, v);
      high = std::max(high, v);
    }
  }
  return detail::with_proof_of({Q::down_by(low, kUlps), Q::up_by(high, kUlps)}, x, y);
}

#define NAZORI_INTERVAL_FUNCTIONS(R)                        \
  template BasicInterval<R> sqrt(const BasicInterval<R>&);  \
  template BasicInterval<R> exp(const BasicInterval<R>&);   \
  template BasicInterval<R> log(const BasicInterval<R>&);   \
  template BasicInterval<R> log2(const BasicInterval<R>&);  \
  template BasicInterval<R> log10(const BasicInterval<R>&); \
  template BasicInterval<R> sin(const BasicInterval<R>&);   \
  template BasicInterval<R> cos(const BasicInterval<R>&);   \
  template BasicInterval<R> tan(const BasicInterval<R>&);   \
  template BasicInterval<R> asin(const BasicInterval<R>&);  \
  template BasicInterval<R> acos(const BasicInterval<R>&);  \
  template BasicInterval<R> atan(const BasicInterval<R>&);  \
  template BasicInterval<R> sinh(const BasicInterval<R>&);  \
  template BasicInterval<R> cosh(const BasicInterval<R>&);  \
  template BasicInterval<R> tanh(const BasicInterval<R>&);  \
  template BasicInterval<R> asinh(const BasicInterval<R>&); \
  template BasicInterval<R> acosh(const BasicInterval<R>&); \
  template BasicInterval<R> atanh(const BasicInterval<R>&); \
  template BasicInterval<R> erf(const BasicInterval<R>&);   \
  template BasicInterval<R> atan2(const BasicInterval<R>&, const BasicInterval<R>&);

NAZORI_INTERVAL_FUNCTIONS(double)
NAZORI_INTERVAL_FUNCTIONS(long double)

}  // namespace nazori::functions
