// SPDX-License-Identifier: Apache-2.0
#include "algebra.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace nazori::functions {
namespace {

constexpr std::size_t kMostTerms = 300;
constexpr int kMostPower = 40;

Expression times(const Expression& a, const Expression& b) {
  if (!a) return b;
  if (!b) return a;
  return binary(NodeKind::multiply, a, b);
}

bool is_number(const Expression& e, double v) { return e->kind == NodeKind::number && e->value == v; }

}  // namespace

/// Multiplies out; throws nothing, remembers failure.
class PolynomialBuilder {
 public:
  std::optional<Polynomial> build(const Expression& e) {
    auto terms = visit(e);
    if (!terms) return std::nullopt;
    Polynomial p;
    p.terms_ = std::move(*terms);
    p.atoms_ = std::move(atoms_);
    return p;
  }

 private:
  using Terms = std::map<Polynomial::Monomial, double>;

  static bool add_to(Terms& terms, const Polynomial::Monomial& m, double c) {
    double& sum = terms[m];
    const double before = sum;
    sum += c;
    if (sum - before != c || sum - c != before) return false;
    if (sum == 0) terms.erase(m);
    return terms.size() <= kMostTerms;
  }

  static std::optional<Terms> product(const Terms& a, const Terms& b) {
    Terms r;
    for (const auto& [ma, ca] : a) {
      for (const auto& [mb, cb] : b) {
        const double c = ca * cb;
        if (std::fma(ca, cb, -c) != 0 || !std::isfinite(c)) return std::nullopt;
        Polynomial::Monomial m = ma;
        for (const auto& [atom, power] : mb) {
          int& sum = m[atom];
          sum += power;
          if (sum == 0) m.erase(atom);
        }
        if (!add_to(r, m, c)) return std::nullopt;
      }
    }
    return r;
  }

  Terms atom(const Expression& e) {
    std::string key = to_text(e);
    atoms_.emplace(key, e);
    return {{{{std::move(key), 1}}, 1.0}};
  }

  static bool is_exponential(const Expression& e) {
    const Expression& base = e->arguments[0];
    return (base->kind == NodeKind::constant || (base->kind == NodeKind::number && base->value > 0)) &&
           !variables_of(e->arguments[1]).empty();
  }

  /// b^-u and b^(2u) as powers of b^u.
  Terms exponential(const Expression& base, const Expression& exponent) {
    Expression u = exponent;
    int times_u = 1;
    while (true) {
      if (u->kind == NodeKind::negate) {
        times_u = -times_u;
        u = u->arguments[0];
        continue;
      }
      const auto factor = u->kind == NodeKind::multiply ? rational_value(u->arguments[0]) : std::nullopt;
      if (!factor || factor->q != 1 || factor->p == 0 || std::abs(factor->p) > 16 || std::abs(times_u) > 16)
        break;
      times_u *= static_cast<int>(factor->p);
      u = u->arguments[1];
    }
    Terms t = atom(binary(NodeKind::power, base, u));
    Polynomial::Monomial m = t.begin()->first;
    m.begin()->second = times_u;
    return {{std::move(m), 1.0}};
  }

  std::optional<Terms> visit(const Expression& e) {
    const auto& a = e->arguments;
    switch (e->kind) {
      case NodeKind::number:
        if (!e->exact) return atom(e);
        if (e->value == 0) return Terms{};
        return Terms{{{}, e->value}};
      case NodeKind::negate: {
        auto r = visit(a[0]);
        if (r) {
          for (auto& [m, c] : *r) c = -c;
        }
        return r;
      }
      case NodeKind::add:
      case NodeKind::subtract: {
        auto left = visit(a[0]);
        const auto right = left ? visit(a[1]) : std::nullopt;
        if (!right) return std::nullopt;
        for (const auto& [m, c] : *right) {
          if (!add_to(*left, m, e->kind == NodeKind::add ? c : -c)) return std::nullopt;
        }
        return left;
      }
      case NodeKind::multiply: {
        const auto left = visit(a[0]);
        const auto right = left ? visit(a[1]) : std::nullopt;
        return right ? product(*left, *right) : std::nullopt;
      }
      case NodeKind::divide: {
        const auto left = visit(a[0]);
        const auto right = left ? visit(a[1]) : std::nullopt;
        if (!right) return std::nullopt;
        if (right->size() == 1 && right->begin()->first.empty()) {
          const double d = right->begin()->second;
          Terms r = *left;
          for (auto& [m, c] : r) {
            const double q = c / d;
            if (std::fma(q, d, -c) != 0) return std::nullopt;
            c = q;
          }
          return r;
        }
        return atom(e);
      }
      case NodeKind::power: {
        const auto n = rational_value(a[1]);
        if (is_exponential(e)) return exponential(a[0], a[1]);
        if (!n || n->q != 1 || n->p < 0 || n->p > kMostPower) return atom(e);
        const auto base = visit(a[0]);
        std::optional<Terms> r = Terms{{{}, 1.0}};
        for (std::int64_t i = 0; i < n->p && r && base; ++i) r = product(*r, *base);
        return base ? r : std::nullopt;
      }
      default:
        return atom(e);
    }
  }

  std::map<std::string, Expression> atoms_;
};

std::optional<Polynomial> Polynomial::of(const Expression& e) { return PolynomialBuilder().build(e); }

std::optional<double> Polynomial::constant() const {
  if (terms_.empty()) return 0.0;
  if (terms_.size() == 1 && terms_.begin()->first.empty()) return terms_.begin()->second;
  return std::nullopt;
}

bool Polynomial::depends_on(Variable v) const {
  for (const auto& [m, c] : terms_) {
    for (const auto& [atom, power] : m) {
      if (functions::depends_on(atoms_.at(atom), v)) return true;
    }
  }
  return false;
}

std::optional<double> Polynomial::linear_factor(Variable v) const {
  const auto lone = lone_power(v);
  if (!lone || lone->power != 1) return std::nullopt;
  return lone->factor;
}

std::optional<Polynomial::OneAtom> Polynomial::in_one_atom() const {
  OneAtom one;
  std::string name;
  int highest = 0;
  bool first = true;
  for (const auto& [m, c] : terms_) {
    if (m.size() > 1) return std::nullopt;
    if (!m.empty()) {
      if (!name.empty() && name != m.begin()->first) return std::nullopt;
      name = m.begin()->first;
    }
    const int power = m.empty() ? 0 : m.begin()->second;
    one.lowest = first ? power : std::min(one.lowest, power);
    highest = first ? power : std::max(highest, power);
    first = false;
  }
  if (first || highest - one.lowest > kMostPower) return std::nullopt;
  if (!name.empty()) one.atom = atoms_.at(name);
  one.coefficients.assign(static_cast<std::size_t>(highest - one.lowest) + 1, 0.0);
  for (const auto& [m, c] : terms_)
    one.coefficients[static_cast<std::size_t>((m.empty() ? 0 : m.begin()->second) - one.lowest)] = c;
  return one;
}

std::optional<Polynomial::LonePower> Polynomial::lone_power(Variable v) const {
  std::optional<LonePower> found;
  for (const auto& [m, c] : terms_) {
    for (const auto& [atom, power] : m) {
      const Expression& e = atoms_.at(atom);
      if (!functions::depends_on(e, v)) continue;
      if (e->kind != NodeKind::variable || m.size() != 1 || found) return std::nullopt;
      found = LonePower{power, c};
    }
  }
  return found;
}

Fraction over_common_denominator(const Expression& e) {
  const auto& a = e->arguments;
  switch (e->kind) {
    case NodeKind::negate: {
      const Fraction f = over_common_denominator(a[0]);
      return {negate(f.numerator), f.denominator};
    }
    case NodeKind::add:
    case NodeKind::subtract: {
      const Fraction f = over_common_denominator(a[0]);
      const Fraction g = over_common_denominator(a[1]);
      if (!f.denominator && !g.denominator) return {binary(e->kind, f.numerator, g.numerator), nullptr};
      if (f.denominator && g.denominator && to_text(f.denominator) == to_text(g.denominator))
        return {binary(e->kind, f.numerator, g.numerator), f.denominator};
      return {binary(e->kind, times(f.numerator, g.denominator), times(g.numerator, f.denominator)),
              times(f.denominator, g.denominator)};
    }
    case NodeKind::multiply: {
      const Fraction f = over_common_denominator(a[0]);
      const Fraction g = over_common_denominator(a[1]);
      return {times(f.numerator, g.numerator), times(f.denominator, g.denominator)};
    }
    case NodeKind::divide: {
      const Fraction f = over_common_denominator(a[0]);
      const Fraction g = over_common_denominator(a[1]);
      return {times(f.numerator, g.denominator), times(f.denominator, g.numerator)};
    }
    case NodeKind::power: {
      const auto n = rational_value(a[1]);
      if (!n || n->q != 1 || n->p == 0 || std::abs(n->p) > kMostPower) break;
      const Fraction f = over_common_denominator(a[0]);
      const Expression power = number(static_cast<double>(std::abs(n->p)));
      const auto raised = [&](const Expression& b) {
        return !b || is_number(power, 1) ? b : binary(NodeKind::power, b, power);
      };
      if (n->p > 0) return {raised(f.numerator), raised(f.denominator)};
      return {f.denominator ? raised(f.denominator) : number(1), raised(f.numerator)};
    }
    case NodeKind::function:
      if (e->function == Function::tan) return {call(Function::sin, {a[0]}), call(Function::cos, {a[0]})};
      break;
    default:
      break;
  }
  return {e, nullptr};
}

std::vector<Expression> zero_factors(const Expression& e) {
  const auto& a = e->arguments;
  switch (e->kind) {
    case NodeKind::number:
      if (e->value != 0) return {};
      return {e};
    case NodeKind::constant:
      return {};
    case NodeKind::negate:
      return zero_factors(a[0]);
    case NodeKind::multiply: {
      std::vector<Expression> all = zero_factors(a[0]);
      std::vector<Expression> more = zero_factors(a[1]);
      all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
      return all;
    }
    case NodeKind::divide:
      return zero_factors(a[0]);
    case NodeKind::power: {
      const auto n = rational_value(a[1]);
      if (n && n->p > 0) return zero_factors(a[0]);
      if (n && n->p == 0) return {};
      if (a[0]->kind == NodeKind::constant) return {};
      return {e};
    }
    case NodeKind::function:
      if (e->function == Function::sqrt || e->function == Function::abs) return zero_factors(a[0]);
      return {e};
    default:
      return {e};
  }
}

namespace {

/// c0 + c1 a + c2 a^2 + ... by Horner's rule.
Expression horner(const std::vector<double>& c, const Expression& atom) {
  Expression e = number(c.back());
  for (std::size_t i = c.size() - 1; i-- > 0;) {
    e = is_number(e, 1) ? atom : binary(NodeKind::multiply, e, atom);
    if (c[i] != 0) e = binary(NodeKind::add, e, number(c[i]));
  }
  return e;
}

/// Quotient and rest of N/D without rounding, where both are polynomials of one atom and D has degree one or
/// more; null otherwise.
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
  return binary(NodeKind::add, horner(quotient, d->atom),
                binary(NodeKind::divide, horner(rest, d->atom), horner(by, d->atom)));
}

}  // namespace

Expression improved(const Expression& e) {
  if (e->arguments.empty()) return e;
  Node n = *reduced(e);
  for (Expression& a : n.arguments) a = improved(a);
  if (n.kind == NodeKind::divide) {
    if (Expression better = divided(n.arguments[0], n.arguments[1])) return better;
  }
  return std::make_shared<const Node>(std::move(n));
}

bool is_total(const Expression& e) {
  const bool inside = std::all_of(e->arguments.begin(), e->arguments.end(), is_total);
  switch (e->kind) {
    case NodeKind::divide: {
      const auto d = rational_value(e->arguments[1]);
      return inside && d && d->p != 0;
    }
    case NodeKind::power: {
      const auto n = rational_value(e->arguments[1]);
      if (n) return inside && n->p >= 0 && n->q % 2 == 1;
      return inside && e->arguments[0]->kind == NodeKind::constant;
    }
    case NodeKind::function:
      switch (e->function) {
        case Function::sin:
        case Function::cos:
        case Function::atan:
        case Function::sinh:
        case Function::cosh:
        case Function::tanh:
        case Function::asinh:
        case Function::erf:
        case Function::abs:
        case Function::min:
        case Function::max:
          return inside;
        default:
          return false;
      }
    default:
      return inside;
  }
}

namespace {

/// The first |a|, min or max in the tree, or null.
Expression first_choice(const Expression& e) {
  if (e->kind == NodeKind::function &&
      (e->function == Function::abs || e->function == Function::min || e->function == Function::max))
    return e;
  for (const Expression& a : e->arguments) {
    if (Expression found = first_choice(a)) return found;
  }
  return nullptr;
}

Expression replaced(const Expression& e, const Expression& from, const std::string& from_text,
                    const Expression& to) {
  if (e->kind == from->kind && to_text(e) == from_text) return to;
  if (e->arguments.empty()) return e;
  Node n = *e;
  for (Expression& a : n.arguments) a = replaced(a, from, from_text, to);
  return std::make_shared<const Node>(std::move(n));
}

void split(const Case& c, int left, std::vector<Case>& out, bool& failed) {
  const Expression choice = first_choice(c.expression);
  if (!choice) {
    out.push_back(c);
    return;
  }
  if (left == 0) {
    failed = true;
    return;
  }
  const auto& a = choice->arguments;
  const std::string text = to_text(choice);
  const bool absolute = choice->function == Function::abs;
  const Expression condition = absolute ? a[0] : binary(NodeKind::subtract, a[0], a[1]);
  const bool largest = choice->function == Function::max;
  for (const bool positive : {true, false}) {
    Expression value;
    if (absolute) {
      value = positive ? a[0] : negate(a[0]);
    } else {
      value = positive == largest ? a[0] : a[1];
    }
    Case next{replaced(c.expression, choice, text, value), c.not_negative};
    next.not_negative.push_back(positive ? condition : negate(condition));
    split(next, left - 1, out, failed);
  }
}

}  // namespace

std::vector<Case> cases_of(const Expression& e) {
  std::vector<Case> all;
  bool failed = false;
  split({e, {}}, 4, all, failed);
  if (failed) return {{e, {}}};
  return all;
}

std::size_t node_count(const Expression& e) {
  std::size_t n = 1;
  for (const Expression& a : e->arguments) n += node_count(a);
  return n;
}

}  // namespace nazori::functions
