// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

#include "algebra.h"

namespace nazori::functions {
namespace {

constexpr std::size_t kMostTerms = 300;
constexpr int kMostPower = 40;

}  // namespace

/// Multiplies out; does not throw, but records failure.
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

  using Terms = std::map<Polynomial::Monomial, double>;

  /// Term by term from the highest on, like a square root by hand.
  static std::optional<Terms> square_root(const Terms& square) {
    if (square.size() < 3) return std::nullopt;
    // The highest term with the factor 1: so that 2x^2 - 4xy + 2y^2 counts as a square, too.
    const double scale = highest(square)->second;
    Terms rest = square;
    for (auto& [monomial, factor] : rest) {
      const double q = factor / scale;
      if (std::fma(q, scale, -factor) != 0) return std::nullopt;
      factor = q;
    }
    Polynomial::Monomial m = highest(rest)->first;
    for (auto& [atom, power] : m) {
      if (power % 2 != 0) return std::nullopt;
      power /= 2;
    }
    Terms root;
    double c = 1;
    for (std::size_t i = 0; i < square.size(); ++i) {
      // (root + c m)^2 = root^2 + (2 root + c m) c m
      Terms twice = root;
      for (auto& [monomial, factor] : twice) factor *= 2;
      if (!add_to(twice, m, c)) return std::nullopt;
      const auto more = product(twice, {{m, c}});
      if (!more || !add_to(root, m, c)) return std::nullopt;
      for (const auto& [monomial, factor] : *more) {
        if (!add_to(rest, monomial, -factor)) return std::nullopt;
      }
      if (rest.empty()) return root;
      const auto next = highest(rest);
      m = next->first;
      for (const auto& [atom, power] : highest(root)->first) {
        int& left = m[atom];
        left -= power;
        if (left < 0) return std::nullopt;
        if (left == 0) m.erase(atom);
      }
      c = next->second / 2;
      if (root.contains(m)) return std::nullopt;
    }
    return std::nullopt;
  }

 private:
  /// The term that comes first by the powers of the atoms in the order of their names.
  static Terms::const_iterator highest(const Terms& terms) {
    const auto power_of = [](const Polynomial::Monomial& m, const std::string& atom) {
      const auto found = m.find(atom);
      return found == m.end() ? 0 : found->second;
    };
    return std::max_element(terms.begin(), terms.end(), [&](const auto& a, const auto& b) {
      auto atoms = a.first;
      atoms.insert(b.first.begin(), b.first.end());
      for (const auto& [atom, power] : atoms) {
        const int pa = power_of(a.first, atom);
        const int pb = power_of(b.first, atom);
        if (pa != pb) return pa < pb;
      }
      return false;
    });
  }

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

Expression Polynomial::square_root() const {
  const auto root = PolynomialBuilder::square_root(terms_);
  if (!root) return nullptr;
  Expression sum;
  for (const auto& [m, c] : *root) {
    Expression term = m.empty() || c != 1 ? number(c) : nullptr;
    for (const auto& [atom, power] : m) {
      Expression e = atoms_.at(atom);
      if (power != 1) e = binary(NodeKind::power, e, number(power));
      term = term ? binary(NodeKind::multiply, term, e) : e;
    }
    sum = sum ? binary(NodeKind::add, sum, term) : term;
  }
  return sum;
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

}  // namespace nazori::functions
