// SPDX-License-Identifier: Apache-2.0
#include <numbers>

#include "nazori/functions/dual.h"
#include "nazori/functions/interval.h"

namespace nazori::functions {
namespace {

// tgamma of glibc 2.36 is documented with up to 10 units in the last place; Boost's digamma is within a few.
constexpr int kGammaUlps = 16;
constexpr int kDigammaUlps = 64;
constexpr int kPowerUlps = 3;
// Where gamma is least on the positive axis, and that value.
// @source OEIS A030169 and A030171.
constexpr long double kGammaArgument = 1.46163214496836234126265954233L;
constexpr long double kGammaLeast = 0.88560319441088870027881590058L;

template <class R>
constexpr R kInf = std::numeric_limits<R>::infinity();

template <class R>
bool contains_gamma_pole(const BasicInterval<R>& a) {
  return a.lower <= 0 && (a.upper >= 0 || std::floor(a.upper) >= std::ceil(a.lower));
}

template <class R>
R gamma_at(R v) {
  return std::tgamma(v);
}

/// Gamma over x > 0.
template <class R>
BasicInterval<R> positive_gamma(const BasicInterval<R>& a) {
  using Q = Rounding<R>;
  const R first = gamma_at(a.lower);
  const R last = gamma_at(a.upper);
  const bool has_least =
      a.lower <= static_cast<R>(kGammaArgument) && a.upper >= static_cast<R>(kGammaArgument);
  const R low =
      has_least ? Q::down_by(static_cast<R>(kGammaLeast), 2) : Q::down_by(std::min(first, last), kGammaUlps);
  return detail::marked(detail::with_proof_of({low, Q::up_by(std::max(first, last), kGammaUlps)}, a),
                        a.is_bounded());
}

template <class R>
BasicInterval<R> stepped(const BasicInterval<R>& a, R low, R high) {
  BasicInterval<R> r = detail::with_proof_of({low, high}, a);
  return low == high ? r : r.weakened(Decoration::defined, Cause::jump);
}

/// |v| to the power p/q.
template <class R>
R root_power(R v, int p, int q) {
  if (q == 2 && p == 1) return std::sqrt(v);
  if (q == 3 && p == 1) return std::cbrt(v);
  return std::pow(v, static_cast<R>(p) / static_cast<R>(q));
}

}  // namespace

template <class R>
BasicInterval<R> gamma(const BasicInterval<R>& a) {
  if (a.is_empty()) return a;
  if (a.lower > 0) return positive_gamma(a);
  if (contains_gamma_pole(a)) {
    if (a.is_point()) return BasicInterval<R>::empty(a.cause | Cause::pole);
    return BasicInterval<R>::entire(std::min(a.decoration, Decoration::partial), a.cause | Cause::pole);
  }
  // Between two poles: reflection, gamma(x) gamma(1 - x) = pi / sin(pi x).
  using Q = Rounding<R>;
  const R pi = std::numbers::pi_v<R>;
  const BasicInterval<R> about_pi(Q::down_by(pi, 1), Q::up_by(pi, 1));
  // sin(pi x) = +-sin(pi (x - n)) with n the whole number above: exact subtraction, small angle.
  const R n = std::ceil(a.upper);
  const BasicInterval<R> s = sin(about_pi * (a - BasicInterval<R>(n)));
  const BasicInterval<R> signed_s = std::fmod(std::abs(n), R(2)) == 1 ? -s : s;
  return detail::with_proof_of(about_pi / (signed_s * positive_gamma(BasicInterval<R>(R(1)) - a)), a);
}

template <class R>
BasicInterval<R> digamma(const BasicInterval<R>& a) {
  if (a.is_empty()) return a;
  if (contains_gamma_pole(a))
    return BasicInterval<R>::entire(std::min(a.decoration, Decoration::partial), a.cause | Cause::pole);
  using Q = Rounding<R>;
  // Rises from -infinity to infinity between two poles; NaN where a double cannot hold the argument.
  const auto at = [](R v) { return v == kInf<R> ? v : static_cast<R>(digamma(static_cast<double>(v))); };
  const R first = at(a.lower);
  const R last = at(a.upper);
  const R slack = static_cast<R>(1e-13);
  const R low =
      std::isnan(first) ? -kInf<R> : Q::down_by(first, kDigammaUlps) - slack - std::abs(first) * slack;
  const R high = std::isnan(last) ? kInf<R> : Q::up_by(last, kDigammaUlps) + slack + std::abs(last) * slack;
  return detail::with_proof_of({low, high}, a);
}

template <class R>
BasicInterval<R> floor(const BasicInterval<R>& a) {
  if (a.is_empty()) return a;
  return stepped(a, std::floor(a.lower), std::floor(a.upper));
}

template <class R>
BasicInterval<R> ceil(const BasicInterval<R>& a) {
  return -floor(-a);
}

template <class R>
BasicInterval<R> sign(const BasicInterval<R>& a) {
  if (a.is_empty()) return a;
  const auto of = [](R v) { return static_cast<R>((v > 0) - (v < 0)); };
  return stepped(a, of(a.lower), of(a.upper));
}

template <class R>
BasicInterval<R> power(const BasicInterval<R>& base, const BasicInterval<R>& exponent) {
  using I = BasicInterval<R>;
  if (base.is_empty() || exponent.is_empty()) return I::empty(base.cause | exponent.cause);
  // (-1)^floor(x): integer powers exist for every base.
  if (base.lower < 0 && exponent.is_point() && exponent.lower == std::floor(exponent.lower) &&
      std::abs(exponent.lower) < R(1e6)) {
    const auto whole = detail::with_proof_of(power_integer(base, static_cast<int>(exponent.lower)), exponent);
    // With a computed exponent 0^0 is undefined, as in real_power(); only a literal x^0 is 1 at 0.
    return exponent.lower > 0 || base.upper < 0 ? whole : whole.weakened(Decoration::partial, Cause::domain);
  }
  if (base.upper < 0) {
    // A step of the exponent between two whole numbers: either power.
    if (exponent.decoration == Decoration::defined && exponent.is_bounded() &&
        has(exponent.cause, Cause::jump) && exponent.lower == std::floor(exponent.lower) &&
        exponent.upper == exponent.lower + 1 && std::abs(exponent.lower) < R(1e6)) {
      const int n = static_cast<int>(exponent.lower);
      return detail::with_proof_of(hull(power_integer(base, n), power_integer(base, n + 1)), exponent)
          .weakened(Decoration::partial, Cause::jump);
    }
    return I::empty(base.cause | exponent.cause | Cause::domain);
  }
  I b = base;
  if (b.lower < 0) b = I(0, b.upper, b.decoration, b.cause).weakened(Decoration::partial, Cause::domain);
  if (b.upper == 0) {
    if (exponent.upper <= 0) return I::empty(base.cause | exponent.cause | Cause::domain);
    const Decoration proven = exponent.lower > 0 ? Decoration::continuous : Decoration::partial;
    return detail::with_proof_of(I(0, 0, proven, Cause::none), b, exponent);
  }
  Decoration proven = Decoration::continuous;
  Cause why = Cause::none;
  if (b.lower == 0 && exponent.lower <= 0) {
    proven = Decoration::partial;
    why = exponent.lower < 0 ? Cause::pole : Cause::domain;
  }
  const I plain_log = log(I(b.lower, b.upper));
  I r = exp(I(plain_log.lower, plain_log.upper) * I(exponent.lower, exponent.upper));
  r.decoration = proven;
  r.cause = (b.is_bounded() && exponent.is_bounded() && b.lower > 0 && !r.is_bounded())
                ? why | Cause::overflow
                : why;
  return detail::with_proof_of(r, b, exponent);
}

template <class R>
BasicInterval<R> power_integer(const BasicInterval<R>& base, int n) {
  using Q = Rounding<R>;
  using I = BasicInterval<R>;
  if (base.is_empty()) return base;
  if (n == 0) return detail::with_proof_of(I(1), base);
  if (n == 1) return base;
  if (n == 2) return square(base);
  if (n < 0) return I(1) / power_integer(base, -n);
  const R e = static_cast<R>(n);
  const auto at = [e](R v) { return std::pow(v, e); };
  I r;
  if (n % 2 == 1) {
    r = I(Q::down_by(at(base.lower), kPowerUlps), Q::up_by(at(base.upper), kPowerUlps));
    if (base.lower >= 0) r.lower = std::max(R(0), r.lower);
    if (base.upper <= 0) r.upper = std::min(R(0), r.upper);
  } else {
    const R small = base.contains(0) ? R(0) : std::min(std::abs(base.lower), std::abs(base.upper));
    r = I(small == 0 ? R(0) : std::max(R(0), Q::down_by(at(small), kPowerUlps)),
          base.magnitude() == 0 ? R(0) : Q::up_by(at(base.magnitude()), kPowerUlps));
  }
  return detail::marked(detail::with_proof_of(r, base), base.is_bounded());
}

template <class R>
BasicInterval<R> power_rational(const BasicInterval<R>& base, int p, int q) {
  using Q = Rounding<R>;
  using I = BasicInterval<R>;
  if (q == 1) return power_integer(base, p);
  if (base.is_empty()) return base;
  if (p < 0) return I(1) / power_rational(base, -p, q);
  I b = base;
  if (q % 2 == 0) {
    if (b.upper < 0) return I::empty(b.cause | Cause::domain);
    if (b.lower < 0) b = I(0, b.upper, b.decoration, b.cause).weakened(Decoration::partial, Cause::domain);
  }
  // The exponent is rounded too, by at most half an epsilon of it: that error is multiplied by |ln v|, under
  // 746 for doubles (11400 beyond).
  const auto slack = [p, q](R v) {
    if (v == 0 || std::isinf(v)) return kPowerUlps;
    const R e = static_cast<R>(p) / static_cast<R>(q);
    return kPowerUlps + static_cast<int>(std::min(R(1e8), std::abs(std::log(v)) * e / 2 + 1));
  };
  const auto least = [&](R v) {
    return v == 0 ? R(0) : std::max(R(0), Q::down_by(root_power(v, p, q), slack(v)));
  };
  const auto most = [&](R v) { return v == 0 ? R(0) : Q::up_by(root_power(v, p, q), slack(v)); };
  I r;
  if (b.lower >= 0) {
    r = I(least(b.lower), most(b.upper));
  } else if (p % 2 == 0) {
    const R small = b.contains(0) ? R(0) : std::min(std::abs(b.lower), std::abs(b.upper));
    r = I(least(small), most(b.magnitude()));
  } else {
    r = I(-most(-b.lower), b.upper >= 0 ? most(b.upper) : -least(-b.upper));
  }
  return detail::marked(detail::with_proof_of(r, b), b.is_bounded());
}

#define NAZORI_SPECIAL_FUNCTIONS(R)                                                  \
  template BasicInterval<R> gamma(const BasicInterval<R>&);                          \
  template BasicInterval<R> digamma(const BasicInterval<R>&);                        \
  template BasicInterval<R> floor(const BasicInterval<R>&);                          \
  template BasicInterval<R> ceil(const BasicInterval<R>&);                           \
  template BasicInterval<R> sign(const BasicInterval<R>&);                           \
  template BasicInterval<R> power(const BasicInterval<R>&, const BasicInterval<R>&); \
  template BasicInterval<R> power_integer(const BasicInterval<R>&, int);             \
  template BasicInterval<R> power_rational(const BasicInterval<R>&, int, int);

NAZORI_SPECIAL_FUNCTIONS(double)
NAZORI_SPECIAL_FUNCTIONS(long double)

}  // namespace nazori::functions
