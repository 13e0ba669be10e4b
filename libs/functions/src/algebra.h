// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "nazori/functions/expression.h"

namespace nazori::functions {

/// A sum of products of powers of atoms (variables and expressions that cannot be multiplied out), each once,
/// with coefficients that were computed without rounding.
class Polynomial {
 public:
  /// @return nothing where a coefficient would be rounded or the sum grows over some hundred terms.
  [[nodiscard]] static std::optional<Polynomial> of(const Expression& e);

  [[nodiscard]] bool is_zero() const { return terms_.empty(); }
  /// The value where no atom is left.
  [[nodiscard]] std::optional<double> constant() const;
  [[nodiscard]] bool depends_on(Variable v) const;
  /// The factor c where the polynomial is c*v + (something without v).
  [[nodiscard]] std::optional<double> linear_factor(Variable v) const;
  /// The coefficients by rising powers where there is one atom only, and that atom. Negative powers are
  /// allowed for exponentials; `lowest` is the power of the first coefficient.
  struct OneAtom {
    Expression atom;
    int lowest = 0;
    std::vector<double> coefficients;
  };
  [[nodiscard]] std::optional<OneAtom> in_one_atom() const;
  struct LonePower {
    int power = 1;
    double factor = 1;
  };
  /// The same for c*v^n + (something without v).
  [[nodiscard]] std::optional<LonePower> lone_power(Variable v) const;
  /// The sum of at least two terms whose square this is except for a factor, if it can be found without
  /// rounding: x - y for 2x^2 - 4xy + 2y^2. Null otherwise.
  [[nodiscard]] Expression square_root() const;

 private:
  using Monomial = std::map<std::string, int>;
  friend class PolynomialBuilder;
  std::map<Monomial, double> terms_;
  std::map<std::string, Expression> atoms_;
};

struct Fraction {
  Expression numerator;
  Expression denominator;  ///< null: one
};
/// The expression over one common denominator; tan counts as sin over cos.
[[nodiscard]] Fraction over_common_denominator(const Expression& e);

/// The factors of `e`, without numbers, signs, powers and roots: together they have the zeros of e. An `e`
/// that is a number other than zero gives none; zero gives the number 0.
[[nodiscard]] std::vector<Expression> zero_factors(const Expression& e);

/// The same function in a form that intervals enclose more tightly: quotients of polynomials of one atom are
/// divided out, (x^2-1)/(x-1) = x + 1 + 0/(x-1) and e^x/(1+e^x) = 1 - 1/(1+e^x); the domain is unchanged.
[[nodiscard]] Expression improved(const Expression& e);

/// The tree with sqrt(u^2) written as |u|, and sqrt(u^4) as |u|^2: the square has no sign that could be lost.
[[nodiscard]] Expression without_even_roots(const Expression& e);

/// Whether the form of the expression alone shows that it is defined and continuous everywhere.
[[nodiscard]] bool is_total(const Expression& e);

/// The tree with every part whose text equals that of `from` replaced.
[[nodiscard]] Expression replaced(const Expression& e, const Expression& from, const Expression& to);

/// One case of every |a|, min and max: the remaining expression, and the expressions that must not be
/// negative in this case.
struct Case {
  Expression expression;
  std::vector<Expression> not_negative;
};
/// All cases of up to four such functions; just `e` itself where there are more.
[[nodiscard]] std::vector<Case> cases_of(const Expression& e);

[[nodiscard]] std::size_t node_count(const Expression& e);

/// Expressions of more parts are drawn as they are typed: simplifying them would take longer than drawing.
inline constexpr std::size_t kMostNodesOfAlgebra = 600;

/// Whether the expression is exactly this number.
[[nodiscard]] inline bool is_number(const Expression& e, double v) {
  return e->kind == NodeKind::number && e->value == v;
}

}  // namespace nazori::functions
