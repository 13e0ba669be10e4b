// SPDX-License-Identifier: Apache-2.0
// Rewriting for tighter intervals: what cancels on paper must not be left to rounding.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "algebra.h"

namespace nazori::functions {
namespace {

Expression improved_tree(const Expression& e);

/// c0 + c1 a + c2 a^2 + ... by Horner's rule.
Expression horner(const std::vector<double>& c, const Expression& atom) {
  Expression e = number(c.back());
  for (std::size_t i = c.size() - 1; i-- > 0;) {
    e = is_number(e, 1) ? atom : binary(NodeKind::multiply, e, atom);
    if (c[i] != 0) e = binary(NodeKind::add, e, number(c[i]));
  }
  return e;
}

/// Quotient and remainder of N/D without rounding, where both are polynomials of one atom and D has degree
/// one or more; null otherwise.
Expression divided(const Expression& numerator, const Expression& denominator) {
  const auto pn = Polynomial::of(numerator);
  const auto pd = pn ? Polynomial::of(denominator) : std::nullopt;
  const auto n = pd ? pn->in_one_atom() : std::nullopt;
  const auto d = n ? pd->in_one_atom() : std::nullopt;
  if (!d || !d->atom || (n->atom && to_text(n->atom) != to_text(d->atom))) return nullptr;
  // Exponentials are never zero: both sides may be multiplied by a power of one.
  const int lowest = std::min({n->lowest, d->lowest, 0});
  const bool exponential = d->atom->kind == NodeKind::power;
  if (lowest < 0 && !exponential) return nullptr;
  const auto shifted = [&](const Polynomial::OneAtom& p) {
    std::vector<double> c(static_cast<std::size_t>(p.lowest - lowest), 0.0);
    c.insert(c.end(), p.coefficients.begin(), p.coefficients.end());
    return c;
  };
  std::vector<double> rest = shifted(*n);
  const std::vector<double> by = shifted(*d);
  if (by.size() < 2 || rest.size() < by.size()) return nullptr;
  std::vector<double> quotient(rest.size() - by.size() + 1, 0.0);
  for (std::size_t k = quotient.size(); k-- > 0;) {
    const double q = rest[k + by.size() - 1] / by.back();
    if (std::fma(q, by.back(), -rest[k + by.size() - 1]) != 0) return nullptr;
    quotient[k] = q;
    for (std::size_t i = 0; i < by.size(); ++i) {
      const double p = q * by[i];
      const double difference = rest[k + i] - p;
      if (std::fma(q, by[i], -p) != 0 || rest[k + i] - difference != p) return nullptr;
      rest[k + i] = difference;
    }
  }
  while (rest.size() > 1 && rest.back() == 0) rest.pop_back();
  // Multiplied out, (x - 2)^2 is zero by rounding far around 2.
  Expression below = lowest == 0 ? denominator : horner(by, d->atom);
  const bool vanishes = rest.size() == 1 && rest[0] == 0;
  if (const Expression root = vanishes ? pd->square_root() : nullptr) below = root;
  return binary(NodeKind::add, horner(quotient, d->atom),
                binary(NodeKind::divide, horner(rest, d->atom), below));
}

/// asin(p/q) = atan2(p sign(q), |s|) where q^2 - p^2 is the square of s: arcsin(2x/(1+x^2)), whose argument
/// comes to 1 without passing it, but passes it by rounding. acos is pi/2 - asin. Null for all else.
Expression arc_of_square(const Node& n) {
  if (n.kind != NodeKind::function || (n.function != Function::asin && n.function != Function::acos))
    return nullptr;
  const Fraction f = over_common_denominator(n.arguments[0]);
  if (!f.denominator) return nullptr;
  const Expression& p = f.numerator;
  const Expression& q = f.denominator;
  const auto squared = [](const Expression& e) { return binary(NodeKind::power, e, number(2)); };
  const auto gap = Polynomial::of(binary(NodeKind::subtract, squared(q), squared(p)));
  const Expression s = gap ? gap->square_root() : nullptr;
  if (!s) return nullptr;
  // The root is known except for a factor.
  const auto ratio = [&]() -> std::optional<Rational> {
    for (const double factor : {1.0, 2.0, 3.0, 4.0, 0.5}) {
      const auto rest =
          Polynomial::of(binary(NodeKind::subtract, binary(NodeKind::subtract, squared(q), squared(p)),
                                binary(NodeKind::multiply, number(factor * factor), squared(s))));
      if (rest && rest->is_zero()) return rational_value(number(factor));
    }
    return std::nullopt;
  }();
  if (!ratio) return nullptr;
  const Expression size = call(Function::abs, {s});
  const double factor = static_cast<double>(ratio->p) / static_cast<double>(ratio->q);
  Expression angle =
      call(Function::atan2, {binary(NodeKind::multiply, p, call(Function::sign, {q})),
                             factor == 1 ? size : binary(NodeKind::multiply, number(factor), size)});
  if (n.function == Function::asin) return angle;
  return binary(NodeKind::subtract, binary(NodeKind::divide, constant(Constant::pi), number(2)), angle);
}

bool is_exponential(const Expression& e) {
  return e->kind == NodeKind::power && e->arguments[0]->kind == NodeKind::constant;
}

/// sinh and cosh as exponentials.
Expression with_exponentials(const Expression& e) {
  if (e->arguments.empty()) return e;
  Node n = *e;
  for (Expression& a : n.arguments) a = with_exponentials(a);
  if (n.kind == NodeKind::function && (n.function == Function::sinh || n.function == Function::cosh)) {
    const Expression up = binary(NodeKind::power, constant(Constant::e), n.arguments[0]);
    const Expression down = binary(NodeKind::power, constant(Constant::e), negate(n.arguments[0]));
    const NodeKind kind = n.function == Function::sinh ? NodeKind::subtract : NodeKind::add;
    return binary(NodeKind::divide, binary(kind, up, down), number(2));
  }
  return std::make_shared<const Node>(std::move(n));
}

/// A sum of multiples of powers of one atom, collected, where that is shorter than the sum as typed:
/// cosh x - sinh x = e^-x. Null otherwise.
Expression collected(const Expression& e) {
  if (e->kind != NodeKind::add && e->kind != NodeKind::subtract) return nullptr;
  if (!is_total(e)) return nullptr;
  const Expression plain = with_exponentials(e);
  const auto p = Polynomial::of(plain);
  if (!p) return nullptr;
  if (p->is_zero()) return number(0);
  const auto one = p->in_one_atom();
  if (!one) return nullptr;
  if (!one->atom) return number(one->coefficients[0]);
  const auto terms = static_cast<std::size_t>(
      std::count_if(one->coefficients.begin(), one->coefficients.end(), [](double c) { return c != 0; }));
  if (terms != 1) return nullptr;
  const auto place =
      std::find_if(one->coefficients.begin(), one->coefficients.end(), [](double c) { return c != 0; });
  const auto power = static_cast<int>(place - one->coefficients.begin()) + one->lowest;
  if (power == 0) return number(*place);
  if (power < 0 && !is_exponential(one->atom)) return nullptr;
  Expression r = one->atom;
  if (is_exponential(r)) {
    r = binary(NodeKind::power, r->arguments[0],
               power == 1    ? r->arguments[1]
               : power == -1 ? negate(r->arguments[1])
                             : binary(NodeKind::multiply, number(power), r->arguments[1]));
  } else if (power != 1) {
    r = binary(NodeKind::power, r, number(power));
  }
  if (*place != 1) r = binary(NodeKind::multiply, number(*place), r);
  return node_count(r) <= node_count(e) ? r : nullptr;
}

/// ln(e^u) = u and similar forms, defined wherever u is.
Expression inverse_undone(const Node& n) {
  if (n.kind != NodeKind::function || n.arguments[0]->kind != NodeKind::power) return nullptr;
  const Expression& base = n.arguments[0]->arguments[0];
  const Expression& exponent = n.arguments[0]->arguments[1];
  const bool undone =
      (n.function == Function::ln && base->kind == NodeKind::constant && base->constant == Constant::e) ||
      (n.function == Function::log10 && is_number(base, 10)) ||
      (n.function == Function::log2 && is_number(base, 2));
  return undone && !variables_of(exponent).empty() ? exponent : nullptr;
}

/// gamma(u + n)/gamma(u) = u (u + 1) ... (u + n - 1), undefined where the quotient is.
Expression gamma_ratio(const Expression& top, const Expression& bottom) {
  if (!is_call(*top, Function::gamma) || !is_call(*bottom, Function::gamma)) return nullptr;
  const auto p = Polynomial::of(binary(NodeKind::subtract, top->arguments[0], bottom->arguments[0]));
  const auto step = p ? p->constant() : std::nullopt;
  if (!step || *step != std::round(*step) || std::abs(*step) > 12 || *step == 0) return nullptr;
  const Expression& lower = *step > 0 ? bottom->arguments[0] : top->arguments[0];
  Expression r = lower;
  for (int k = 1; k < std::abs(*step); ++k)
    r = binary(NodeKind::multiply, r, binary(NodeKind::add, lower, number(k)));
  if (*step < 0) r = binary(NodeKind::divide, number(1), r);
  // gamma is never zero: the added term is 0 where it is defined.
  return binary(NodeKind::add, r, binary(NodeKind::multiply, number(0), call(Function::gamma, {lower})));
}

/// Whether it is a power of a number that is positive, so never zero.
bool is_positive_power(const Expression& e) {
  if (is_exponential(e)) return true;
  if (e->kind != NodeKind::power || variables_of(e->arguments[1]).empty()) return false;
  const auto base = rational_value(e->arguments[0]);
  return base && base->p > 0;
}

/// a^u a^v = a^(u+v) and a^u / a^v = a^(u-v) for one positive number a.
Expression exponents_joined(NodeKind kind, const Expression& left, const Expression& right) {
  if (!is_positive_power(left) || !is_positive_power(right)) return nullptr;
  if (to_text(left->arguments[0]) != to_text(right->arguments[0])) return nullptr;
  const Expression sum = improved_tree(binary(kind == NodeKind::multiply ? NodeKind::add : NodeKind::subtract,
                                              left->arguments[1], right->arguments[1]));
  // If the exponent cancels, its domain must still be kept.
  if (variables_of(sum).empty() && !is_total(left->arguments[1])) return nullptr;
  return binary(NodeKind::power, left->arguments[0], sum);
}

/// a^u b^u = (ab)^u and a^u / b^u = (a/b)^u for positive numbers a and b.
Expression powers_joined(NodeKind kind, const Expression& left, const Expression& right) {
  if (left->kind != NodeKind::power || right->kind != NodeKind::power) return nullptr;
  const auto a = rational_value(left->arguments[0]);
  const auto b = rational_value(right->arguments[0]);
  if (!a || !b || a->p <= 0 || b->p <= 0) return nullptr;
  if (variables_of(left->arguments[1]).empty()) return nullptr;
  if (to_text(left->arguments[1]) != to_text(right->arguments[1])) return nullptr;
  const auto base = rational_value(binary(kind, left->arguments[0], right->arguments[0]));
  if (!base) return nullptr;
  const Expression p = number(static_cast<double>(base->p));
  if (base->p == base->q)
    return binary(NodeKind::add, number(1), binary(NodeKind::multiply, number(0), left->arguments[1]));
  const Expression joined =
      base->q == 1 ? p : binary(NodeKind::divide, p, number(static_cast<double>(base->q)));
  return binary(NodeKind::power, joined, left->arguments[1]);
}

/// a^u / (a^u + b^u + ...) = 1 / (1 + (b/a)^u + ...): both sides vanish or overflow, their quotient does not.
Expression power_over_sum(const Expression& power, const Expression& sum) {
  if (!is_positive_power(power)) return nullptr;
  const auto over = [&power](const auto& self, const Expression& e) -> Expression {
    if (e->kind == NodeKind::add || e->kind == NodeKind::subtract) {
      const Expression a = self(self, e->arguments[0]);
      const Expression b = a ? self(self, e->arguments[1]) : nullptr;
      return b ? binary(e->kind, a, b) : nullptr;
    }
    if (to_text(e) == to_text(power)) return number(1);
    if (Expression joined = powers_joined(NodeKind::divide, e, power)) return joined;
    return exponents_joined(NodeKind::divide, e, power);
  };
  if ((sum->kind != NodeKind::add && sum->kind != NodeKind::subtract) || !is_total(power->arguments[1]))
    return nullptr;
  const Expression quotient = over(over, sum);
  return quotient ? binary(NodeKind::divide, number(1), quotient) : nullptr;
}

/// sqrt(q^2 + c) + q = c/(sqrt(q^2 + c) + |q|) + 2 max(0, q), and the same for -q: if two large numbers
/// nearly cancel, rounding destroys the result, and enclosures become useless.
Expression rationalised(const Node& n) {
  if (n.kind != NodeKind::add && n.kind != NodeKind::subtract) return nullptr;
  const bool root_first = is_call(*n.arguments[0], Function::sqrt);
  const Expression& root = n.arguments[root_first ? 0 : 1];
  if (!is_call(*root, Function::sqrt)) return nullptr;
  const Expression& other = n.arguments[root_first ? 1 : 0];
  if (!is_total(other) || variables_of(other).empty()) return nullptr;
  const auto rest = Polynomial::of(
      binary(NodeKind::subtract, root->arguments[0], binary(NodeKind::power, other, number(2))));
  const auto c = rest ? rest->constant() : std::nullopt;
  if (!c || *c == 0) return nullptr;
  const bool minus = n.kind == NodeKind::subtract;
  // q - sqrt is minus (sqrt - q).
  const Expression q = minus ? negate(other) : other;
  const Expression sum =
      binary(NodeKind::add,
             binary(NodeKind::divide, number(*c), binary(NodeKind::add, root, call(Function::abs, {other}))),
             binary(NodeKind::multiply, number(2), call(Function::max, {number(0), q})));
  return minus && !root_first ? negate(sum) : sum;
}

}  // namespace

namespace {

Expression improved_tree(const Expression& e) {
  if (e->arguments.empty()) return e;
  Node n = *reduced(e);
  if (n.kind == NodeKind::add || n.kind == NodeKind::subtract) {
    if (Expression better = collected(std::make_shared<const Node>(n))) return better;
  }
  if (Expression better = rationalised(n)) return better;
  for (Expression& a : n.arguments) a = improved_tree(a);
  if (n.kind == NodeKind::divide) {
    if (Expression better = divided(n.arguments[0], n.arguments[1])) return better;
    if (Expression better = divided(with_exponentials(n.arguments[0]), with_exponentials(n.arguments[1])))
      return better;
    if (Expression better = gamma_ratio(n.arguments[0], n.arguments[1])) return better;
    if (Expression better = power_over_sum(n.arguments[0], n.arguments[1])) return better;
  }
  if (n.kind == NodeKind::divide || n.kind == NodeKind::multiply) {
    if (Expression better = powers_joined(n.kind, n.arguments[0], n.arguments[1])) return better;
    if (Expression better = exponents_joined(n.kind, n.arguments[0], n.arguments[1])) return better;
  }
  if (Expression better = inverse_undone(n)) return better;
  if (Expression better = arc_of_square(n)) return better;
  return std::make_shared<const Node>(std::move(n));
}

}  // namespace

Expression improved(const Expression& e) {
  // Each part is compared with others: of long sums that would take as long as drawing them.
  return node_count(e) > kMostNodesOfAlgebra ? reduced(e) : improved_tree(e);
}

}  // namespace nazori::functions
