// SPDX-License-Identifier: Apache-2.0
#include "taylor.h"

#include <boost/math/special_functions/trigamma.hpp>
#include <cmath>
#include <numbers>
#include <utility>

#include "nazori/functions/dual.h"
#include "taylor_terms.h"

namespace nazori::functions {
namespace {

using taylor::chain, taylor::chosen, taylor::constant, taylor::exponential, taylor::is_constant,
    taylor::kCount, taylor::negated, taylor::one_over, taylor::one_plus, taylor::product, taylor::quotient,
    taylor::rational_power, taylor::root, taylor::size, taylor::smaller, taylor::step, taylor::sum,
    taylor::tangent, taylor::Terms, taylor::unknown, taylor::unknown_from, taylor::vanishes, taylor::waves,
    taylor::whole_power;

/// The derivative of digamma. Falls from infinity to 0 for positive numbers; unknown for others.
Interval trigamma(const Interval& u) {
  using Quiet = boost::math::policies::policy<
      boost::math::policies::domain_error<boost::math::policies::ignore_error>,
      boost::math::policies::pole_error<boost::math::policies::ignore_error>,
      boost::math::policies::overflow_error<boost::math::policies::ignore_error>>;
  if (u.is_empty() || !(u.lower > 0) || !u.is_bounded()) return unknown();
  const double most = boost::math::trigamma(u.lower, Quiet());
  const double least = boost::math::trigamma(u.upper, Quiet());
  // As much wider as digamma.
  constexpr double kSlack = 1e-13;
  if (!std::isfinite(most) || !std::isfinite(least)) return unknown();
  return {least * (1 - kSlack) - kSlack, most * (1 + kSlack) + kSlack};
}

/// Of a function that vanishes at the place: that function over (t - place).
void divide_by_distance(Terms& u) {
  for (std::size_t k = 0; k + 1 < kCount; ++k) u[k] = u[k + 1];
  u[kCount - 1] = unknown();
}

template <class F>
Taylor both(const Taylor& a, const F& f) {
  Taylor r;
  r.box = f(a.box);
  r.place = f(a.place);
  return r;
}

template <class F>
Taylor both(const Taylor& a, const Taylor& b, const F& f) {
  Taylor r;
  r.box = f(a.box, b.box);
  r.place = f(a.place, b.place);
  return r;
}

}  // namespace

Taylor Taylor::of_variable(const Interval& box, double place) {
  Taylor r;
  r.box[0] = box;
  r.place[0] = Interval(place);
  r.box[1] = r.place[1] = Interval(1.0);
  return r;
}

Taylor operator-(const Taylor& a) { return both(a, negated); }
Taylor operator+(const Taylor& a, const Taylor& b) { return both(a, b, sum); }
Taylor operator-(const Taylor& a, const Taylor& b) { return a + (-b); }
Taylor operator*(const Taylor& a, const Taylor& b) { return both(a, b, product); }

Taylor operator/(Taylor a, Taylor b) {
  for (int i = 0; i < 4 && b.box[0].contains(0) && vanishes(b.place[0]) && vanishes(a.place[0]); ++i) {
    for (Terms* u : {&a.box, &a.place, &b.box, &b.place}) divide_by_distance(*u);
  }
  return both(a, b, quotient);
}

Taylor square(const Taylor& a) {
  return both(a, [](const Terms& u) {
    Terms r = product(u, u);
    r[0] = square(u[0]);
    return r;
  });
}
Taylor sqrt(const Taylor& a) { return both(a, root); }
Taylor exp(const Taylor& a) {
  return both(a, [](const Terms& u) { return exponential(exp(u[0]), u); });
}
Taylor log(const Taylor& a) {
  return both(a, [](const Terms& u) { return chain(log(u[0]), one_over(u), u); });
}
Taylor log2(const Taylor& a) {
  return both(a, [](const Terms& u) {
    return chain(log2(u[0]), quotient(constant(Interval(1.0) / log(Interval(2.0))), u), u);
  });
}
Taylor log10(const Taylor& a) {
  return both(a, [](const Terms& u) {
    return chain(log10(u[0]), quotient(constant(Interval(1.0) / log(Interval(10.0))), u), u);
  });
}
Taylor sin(const Taylor& a) {
  return both(a, [](const Terms& u) { return waves(u, -1).first; });
}
Taylor cos(const Taylor& a) {
  return both(a, [](const Terms& u) { return waves(u, -1).second; });
}
Taylor sinh(const Taylor& a) {
  return both(a, [](const Terms& u) { return waves(u, 1).first; });
}
Taylor cosh(const Taylor& a) {
  return both(a, [](const Terms& u) { return waves(u, 1).second; });
}
Taylor tan(const Taylor& a) {
  return both(a, [](const Terms& u) { return tangent(u, 1); });
}
Taylor tanh(const Taylor& a) {
  return both(a, [](const Terms& u) { return tangent(u, -1); });
}
Taylor asin(const Taylor& a) {
  return both(a, [](const Terms& u) {
    return chain(asin(u[0]), one_over(root(one_plus(negated(product(u, u))))), u);
  });
}
Taylor acos(const Taylor& a) {
  return both(a, [](const Terms& u) {
    return chain(acos(u[0]), negated(one_over(root(one_plus(negated(product(u, u)))))), u);
  });
}
Taylor atan(const Taylor& a) {
  return both(a, [](const Terms& u) { return chain(atan(u[0]), one_over(one_plus(product(u, u))), u); });
}
Taylor asinh(const Taylor& a) {
  return both(a,
              [](const Terms& u) { return chain(asinh(u[0]), one_over(root(one_plus(product(u, u)))), u); });
}
Taylor acosh(const Taylor& a) {
  return both(a, [](const Terms& u) {
    return chain(acosh(u[0]), one_over(root(sum(product(u, u), constant(Interval(-1.0))))), u);
  });
}
Taylor atanh(const Taylor& a) {
  return both(
      a, [](const Terms& u) { return chain(atanh(u[0]), one_over(one_plus(negated(product(u, u)))), u); });
}
Taylor erf(const Taylor& a) {
  return both(a, [](const Terms& u) {
    const Terms power = negated(product(u, u));
    const Interval pi(Rounding<double>::down(std::numbers::pi), Rounding<double>::up(std::numbers::pi));
    const Terms factor = constant(Interval(2.0) / sqrt(pi));
    return chain(erf(u[0]), product(factor, exponential(exp(power[0]), power)), u);
  });
}
Taylor gamma(const Taylor& a) {
  return both(a, [](const Terms& u) {
    const Interval value = gamma(u[0]);
    if (is_constant(u)) return constant(value);
    Terms r = constant(value);
    const Interval slope = digamma(u[0]);
    r[1] = value * slope * u[1];
    r[2] = value * slope * u[2] + value * (square(slope) + trigamma(u[0])) * square(u[1]) / Interval(2.0);
    return unknown_from(3, r);
  });
}
Taylor abs(const Taylor& a) { return both(a, size); }
Taylor floor(const Taylor& a) {
  return both(a, [](const Terms& u) { return step(floor(u[0])); });
}
Taylor ceil(const Taylor& a) {
  return both(a, [](const Terms& u) { return step(ceil(u[0])); });
}
Taylor sign(const Taylor& a) {
  return both(a, [](const Terms& u) { return step(sign(u[0])); });
}
Taylor min(const Taylor& a, const Taylor& b) { return both(a, b, smaller); }
Taylor max(const Taylor& a, const Taylor& b) { return -min(-a, -b); }

Taylor atan2(const Taylor& y, const Taylor& x) {
  return both(y, x, [](const Terms& v, const Terms& u) {
    Terms radius = sum(product(u, u), product(v, v));
    radius[0] = square(u[0]) + square(v[0]);
    const Interval value = atan2(v[0], u[0]);
    // It jumps on the negative side of x.
    if (!value.is_continuous()) return unknown_from(1, constant(value));
    return sum(chain(value, quotient(u, radius), v), negated(chain(Interval(0.0), quotient(v, radius), u)));
  });
}

Taylor power(const Taylor& base, const Taylor& exponent) {
  return both(base, exponent, [](const Terms& u, const Terms& v) {
    const Interval value = power(u[0], v[0]);
    if (is_constant(u) && is_constant(v)) return constant(value);
    return exponential(value, product(v, chain(log(u[0]), one_over(u), u)));
  });
}
Taylor power_integer(const Taylor& base, int exponent) {
  return both(base, [exponent](const Terms& u) {
    Terms r = whole_power(u, exponent);
    r[0] = power_integer(u[0], exponent);
    return r;
  });
}
Taylor power_rational(const Taylor& base, int p, int q) {
  return both(base, [p, q](const Terms& u) { return rational_power(power_rational(u[0], p, q), u, p, q); });
}
Taylor at_least_zero(const Taylor& a) {
  return both(a, [](const Terms& u) { return step(at_least_zero(u[0])); });
}
Taylor above_zero(const Taylor& a) {
  return both(a, [](const Terms& u) { return step(above_zero(u[0])); });
}
Taylor where(const Taylor& condition, const Taylor& a) {
  return both(condition, a, [](const Terms& c, const Terms& u) {
    Terms r = u;
    r[0] = where(c[0], u[0]);
    return r;
  });
}
Taylor choose(const Taylor& condition, const Taylor& a, const Taylor& b) {
  Taylor r;
  r.box = chosen(condition.box, a.box, b.box);
  r.place = chosen(condition.place, a.place, b.place);
  return r;
}

Taylor chained(const Taylor& values, const Taylor& slope, const Taylor& inner) {
  Taylor r;
  r.box = chain(values.box[0], slope.box, inner.box);
  r.place = chain(values.place[0], slope.place, inner.place);
  return r;
}

}  // namespace nazori::functions
