// SPDX-License-Identifier: Apache-2.0
#include "taylor.h"

#include <boost/math/special_functions/trigamma.hpp>
#include <cmath>
#include <numbers>
#include <utility>

#include "nazori/functions/dual.h"

namespace nazori::functions {
namespace {

using Terms = Taylor::Terms;
constexpr std::size_t kCount = Taylor::kOrder + 1;

Interval whole(std::size_t k) { return {static_cast<double>(k)}; }
Interval unknown() { return Interval::entire(Decoration::partial, Cause::none); }
bool vanishes(const Interval& v) { return v.lower == 0 && v.upper == 0; }

bool is_constant(const Terms& u) {
  for (std::size_t k = 1; k < kCount; ++k) {
    if (!vanishes(u[k])) return false;
  }
  return true;
}

Terms constant(const Interval& value) {
  Terms r{};
  r[0] = value;
  return r;
}

/// A value of which no derivative from number `first` on is known.
Terms unknown_from(std::size_t first, Terms r) {
  for (std::size_t k = first; k < kCount; ++k) r[k] = unknown();
  return r;
}

Terms product(const Terms& u, const Terms& v) {
  Terms r{};
  for (std::size_t i = 0; i < kCount; ++i) {
    if (vanishes(u[i]) && i > 0) continue;
    for (std::size_t j = 0; i + j < kCount; ++j) {
      if (j > 0 && vanishes(v[j])) continue;
      r[i + j] = i == 0 ? u[0] * v[j] : r[i + j] + u[i] * v[j];
    }
  }
  return r;
}

Terms sum(const Terms& u, const Terms& v) {
  Terms r;
  for (std::size_t k = 0; k < kCount; ++k) r[k] = u[k] + v[k];
  return r;
}

Terms negated(const Terms& u) {
  Terms r;
  for (std::size_t k = 0; k < kCount; ++k) r[k] = -u[k];
  return r;
}

Terms quotient(const Terms& u, const Terms& v) {
  Terms r{};
  for (std::size_t k = 0; k < kCount; ++k) {
    Interval rest = u[k];
    for (std::size_t i = 1; i <= k; ++i) {
      if (!vanishes(v[i])) rest = rest - v[i] * r[k - i];
    }
    r[k] = rest / v[0];
  }
  return r;
}

/// The sum over i of i u_i w_(k-i), divided by k: the term k of what has the derivative w u'.
Interval next_term(const Terms& u, const Terms& w, std::size_t k) {
  Interval r(0.0);
  for (std::size_t i = 1; i <= k; ++i) {
    if (!vanishes(u[i])) r = r + whole(i) * u[i] * w[k - i];
  }
  return r / whole(k);
}

Terms chain(const Interval& value, const Terms& slope, const Terms& u) {
  Terms r = constant(value);
  for (std::size_t k = 1; k < kCount; ++k) r[k] = next_term(u, slope, k);
  return r;
}

Terms exponential(const Interval& value, const Terms& u) {
  Terms r = constant(value);
  for (std::size_t k = 1; k < kCount; ++k) r[k] = next_term(u, r, k);
  return r;
}

/// Sine and cosine, or, with `sign` 1, those of the hyperbola.
std::pair<Terms, Terms> waves(const Terms& u, int sign) {
  Terms s = constant(sign < 0 ? sin(u[0]) : sinh(u[0]));
  Terms c = constant(sign < 0 ? cos(u[0]) : cosh(u[0]));
  for (std::size_t k = 1; k < kCount; ++k) {
    const Interval slope = next_term(u, s, k);
    s[k] = next_term(u, c, k);
    c[k] = sign < 0 ? -slope : slope;
  }
  return {s, c};
}

/// The tangent, or, with `sign` -1, that of the hyperbola: the derivative is 1 + sign tan^2.
Terms tangent(const Terms& u, int sign) {
  Terms r = constant(sign > 0 ? tan(u[0]) : tanh(u[0]));
  Terms slope{};
  for (std::size_t k = 0; k < kCount; ++k) {
    if (k > 0) r[k] = next_term(u, slope, k);
    Interval squared = k == 0 ? square(r[0]) : Interval(0.0);
    for (std::size_t i = 0; k > 0 && i <= k; ++i) squared = squared + r[i] * r[k - i];
    slope[k] = Interval(k == 0 ? 1.0 : 0.0) + (sign > 0 ? squared : -squared);
  }
  return r;
}

/// u^(p/q), by u r' = (p/q) u' r.
Terms rational_power(const Interval& value, const Terms& u, int p, int q) {
  Terms r = constant(value);
  for (std::size_t k = 1; k < kCount; ++k) {
    Interval all(0.0);
    for (std::size_t i = 1; i <= k; ++i) {
      if (vanishes(u[i])) continue;
      const double factor = static_cast<double>(p) * static_cast<double>(i) -
                            static_cast<double>(k - i) * static_cast<double>(q);
      all = all + Interval(factor) / whole(static_cast<std::size_t>(q)) * u[i] * r[k - i];
    }
    r[k] = is_constant(u) ? Interval(0.0) : all / (whole(k) * u[0]);
  }
  return r;
}

Terms root(const Terms& u) { return rational_power(sqrt(u[0]), u, 1, 2); }

Terms whole_power(const Terms& u, int n) {
  if (n < 0) return quotient(constant(Interval(1.0)), whole_power(u, -n));
  Terms r = constant(Interval(1.0));
  Terms square_of = u;
  for (; n > 0; n /= 2) {
    if (n % 2 == 1) r = product(r, square_of);
    if (n > 1) square_of = product(square_of, square_of);
  }
  return r;
}

Terms one_plus(const Terms& u) { return sum(constant(Interval(1.0)), u); }
Terms one_over(const Terms& u) { return quotient(constant(Interval(1.0)), u); }

/// floor, ceil, sign and conditions: level where they do not step.
Terms step(const Interval& value) {
  return value.is_point() ? constant(value) : unknown_from(1, constant(value));
}

Terms smaller(const Terms& u, const Terms& v) {
  if (u[0].upper < v[0].lower || v[0].upper < u[0].lower) {
    Terms r = u[0].upper < v[0].lower ? u : v;
    r[0] = min(u[0], v[0]);
    return r;
  }
  Terms r = constant(min(u[0], v[0]));
  // In a corner there are slopes from one side only.
  const bool at_one_place = u[0].is_point() && v[0].is_point();
  r[1] = hull(u[1], v[1]);
  return unknown_from(at_one_place ? 1 : 2, r);
}

Terms size(const Terms& u) {
  if (u[0].lower > 0) return u;
  if (u[0].upper < 0) return negated(u);
  if (is_constant(u)) return constant(abs(u[0]));
  Terms r = negated(smaller(u, negated(u)));
  r[0] = abs(u[0]);
  return r;
}

Terms chosen(const Terms& condition, const Terms& u, const Terms& v) {
  const Interval value = choose(condition[0], u[0], v[0]);
  Terms r = constant(value);
  if (condition[0].lower > 0.5)
    r = u;
  else if (condition[0].upper < 0.5)
    r = v;
  else
    r = unknown_from(1, r);
  r[0] = value;
  return r;
}

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
    const Terms radius = sum(product(u, u), product(v, v));
    const Interval value = atan2(v[0], u[0]);
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
