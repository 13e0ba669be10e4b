// SPDX-License-Identifier: Apache-2.0
#include "taylor_terms.h"

namespace nazori::functions::taylor {
namespace {

Interval whole(std::size_t k) { return {static_cast<double>(k)}; }

/// The sum over i of i u_i w_(k-i), divided by k: the term k of what has the derivative w u'.
Interval next_term(const Terms& u, const Terms& w, std::size_t k) {
  Interval r(0.0);
  for (std::size_t i = 1; i <= k; ++i) {
    if (!vanishes(u[i])) r = r + whole(i) * u[i] * w[k - i];
  }
  return r / whole(k);
}

}  // namespace

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

}  // namespace nazori::functions::taylor
