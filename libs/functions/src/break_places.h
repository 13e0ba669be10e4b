// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "nazori/functions/expression.h"

namespace nazori::functions {

/// A place at which an expression may break, from its parts: zeros of denominators, ends of domains, steps.
struct BreakPlace {
  double at = 0;
  bool undefined = false;  ///< a denominator is zero there, or the argument of a logarithm
  bool is_step = false;    ///< a step (floor, sign, a condition) has its edge there
  /// The value at the place itself: that of floor(x^2) at sqrt(3) is 3, although no double is sqrt(3). NaN
  /// where there is none.
  double value = 0;
};

/// The places where an expression of one variable may break, solved for exactly.
class BreakPlaces {
 public:
  BreakPlaces(const Expression& f, Variable v);

  /// The place of `f` nearest to `t`, at most `reach` away.
  [[nodiscard]] std::optional<BreakPlace> near(double t, double reach) const;
  /// All edges of steps between two places, also where the step is only touched: floor(sin(x)) at pi/2.
  /// Nothing where there are too many to be told.
  [[nodiscard]] std::vector<BreakPlace> steps(double low, double high) const;
  /// All zeros of denominators and of arguments of logarithms between two places.
  [[nodiscard]] std::vector<BreakPlace> gaps(double low, double high) const;

 private:
  enum class Cause { undefined, edge, step };
  /// Breaks where `argument` is zero, of steps where it is a whole number.
  struct Condition {
    Cause cause;
    Expression argument;
    Expression part;  ///< of steps: the part of the expression that jumps
  };
  void collect(const Expression& e);
  void collect_function(const Expression& e);
  void add(Cause cause, const Expression& argument, const Expression& part = nullptr);
  [[nodiscard]] bool holds(const Condition& c, double t, double& level) const;
  [[nodiscard]] BreakPlace place(double at) const;
  [[nodiscard]] std::vector<BreakPlace> places(std::vector<double> all, double apart) const;

  Expression f_;
  Variable v_;
  std::vector<Condition> conditions_;
};

}  // namespace nazori::functions
