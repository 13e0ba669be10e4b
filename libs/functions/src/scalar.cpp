// SPDX-License-Identifier: Apache-2.0
#include <boost/math/special_functions/digamma.hpp>
#include <limits>

#include "nazori/functions/dual.h"

namespace nazori::functions {
namespace {

template <class R>
constexpr R kNaN = std::numeric_limits<R>::quiet_NaN();

template <class R>
R whole_power(R base, int n) {
  if (std::isnan(base)) return base;  // pow(NaN, 0) is 1
  return std::pow(base, static_cast<R>(n));
}

template <class R>
R rational_power(R base, int p, int q) {
  if (base < 0 && q % 2 == 0) return kNaN<R>;
  if (base == 0 && p < 0) return kNaN<R>;
  const R size = std::abs(base);
  R r = 0;
  if (q == 3) {
    r = std::cbrt(size);
    r = p == 1 ? r : std::pow(r, static_cast<R>(p));
  } else if (q == 2) {
    r = std::sqrt(size);
    r = p == 1 ? r : std::pow(r, static_cast<R>(p));
  } else {
    r = std::pow(size, static_cast<R>(p) / static_cast<R>(q));
  }
  return base < 0 && p % 2 != 0 ? -r : r;
}

template <class R>
R real_power(R base, R exponent) {
  if (std::isnan(base) || std::isnan(exponent)) return kNaN<R>;  // pow(1, NaN) is 1
  if (base == 0 && exponent <= 0) return kNaN<R>;
  if (base < 0 && exponent != std::floor(exponent)) return kNaN<R>;
  return std::pow(base, exponent);
}

template <class R>
R gamma_of(R v) {
  if (v <= 0 && std::floor(v) == v) return kNaN<R>;
  return std::tgamma(v);
}

}  // namespace

double power_integer(double base, int n) { return base == 0 && n < 0 ? kNaN<double> : whole_power(base, n); }
long double power_integer(long double base, int n) {
  return base == 0 && n < 0 ? kNaN<long double> : whole_power(base, n);
}
double power_rational(double base, int p, int q) { return rational_power(base, p, q); }
long double power_rational(long double base, int p, int q) { return rational_power(base, p, q); }
double power(double base, double exponent) { return real_power(base, exponent); }
long double power(long double base, long double exponent) { return real_power(base, exponent); }
double gamma(double v) { return gamma_of(v); }
long double gamma(long double v) { return gamma_of(v); }

double digamma(double v) {
  namespace policies = boost::math::policies;
  using Quiet = policies::policy<
      policies::domain_error<policies::ignore_error>, policies::pole_error<policies::ignore_error>,
      policies::overflow_error<policies::ignore_error>, policies::evaluation_error<policies::ignore_error>>;
  if (std::isnan(v) || v == -std::numeric_limits<double>::infinity() || (v <= 0 && std::floor(v) == v))
    return kNaN<double>;
  if (v > 1e300) return std::log(v);
  return boost::math::digamma(v, Quiet());
}
long double digamma(long double v) { return digamma(static_cast<double>(v)); }

}  // namespace nazori::functions
