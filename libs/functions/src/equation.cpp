// SPDX-License-Identifier: Apache-2.0
#include "equation.h"

#include "algebra.h"
#include "roots.h"

namespace nazori::functions {
namespace {

// A common denominator is not used if it makes the equation larger than this.
constexpr std::size_t kMostGrowth = 12;

/// The value of `e`, undefined where `guard` is.
Expression guarded(const Expression& e, const Expression& guard) {
  if (is_total(guard)) return e;
  return binary(NodeKind::add, e, binary(NodeKind::multiply, number(0), guard));
}

class Solver {
 public:
  /// @param plain      what is zero
  /// @param conditions  where it counts
  Solver(Expression plain, const std::vector<Expression>& conditions, const std::array<double, 2>& low,
         const std::array<double, 2>& high)
      : plain_(std::move(plain)), low_(low), high_(high) {
    parts_.whole = plain_;
    for (const Expression& c : conditions) parts_.whole = call(Function::where, {c, parts_.whole});
  }

  EquationParts run() {
    const std::vector<Case> cases = cases_of(plain_);
    for (const Case& c : cases) {
      const auto p = Polynomial::of(over_common_denominator(c.expression).numerator);
      if (p && p->is_zero()) parts_.areas.push_back(c.not_negative);
    }
    if (!parts_.areas.empty()) {
      add_plane(plain_);
      return std::move(parts_);
    }
    if (cases.size() > 1 && add_cases(cases)) return std::move(parts_);
    const Expression numerator = over_common_denominator(plain_).numerator;
    const bool fits = node_count(numerator) <= kMostGrowth * node_count(plain_) + 40;
    for (const Expression& factor : zero_factors(fits ? numerator : plain_)) add(factor);
    return std::move(parts_);
  }

 private:
  /// Straight pieces: where every case of |a|, min and max is linear in x or in y, each is solved and kept
  /// where its conditions hold. |x| + |y| = max(|x|, |y|) changes its sign nowhere, but its cases do.
  bool add_cases(const std::vector<Case>& cases) {
    std::vector<Arc> arcs;
    for (const Case& c : cases) {
      for (const Expression& factor : zero_factors(over_common_denominator(c.expression).numerator)) {
        const auto p = Polynomial::of(factor);
        if (!p) return false;
        if (p->constant()) continue;
        Variable v = Variable::y;
        auto slope = p->linear_factor(v);
        if (!slope) {
          v = Variable::x;
          slope = p->linear_factor(v);
        }
        if (!slope) return false;
        const Expression solved = solved_for(factor, v, *slope);
        Expression value = guarded(solved, substitute(whole_where_zero(factor), v, solved));
        for (const Expression& condition : c.not_negative) {
          const Expression root = call(Function::sqrt, {substitute(condition, v, solved)});
          value = binary(NodeKind::add, value, binary(NodeKind::multiply, number(0), root));
        }
        const bool over_x = v == Variable::y;
        const std::size_t axis = over_x ? 0 : 1;
        const Variable parameter = over_x ? Variable::x : Variable::y;
        arcs.push_back({over_x ? variable(Variable::x) : value, over_x ? value : variable(Variable::y),
                        parameter, low_[axis], high_[axis], false});
      }
    }
    parts_.arcs = std::move(arcs);
    return true;
  }

  /// The expression that must be defined where `factor` is zero; rounding would make sqrt(factor) undefined
  /// on one side.
  [[nodiscard]] Expression whole_where_zero(const Expression& factor) const {
    return replaced(parts_.whole, factor, number(0));
  }

  static Expression solved_for(const Expression& factor, Variable v, double c) {
    const Expression rest = substitute(factor, v, number(0));
    return c == -1 ? rest : c == 1 ? negate(rest) : binary(NodeKind::divide, negate(rest), number(c));
  }

  void add(const Expression& factor) {
    const auto p = Polynomial::of(factor);
    if (p) {
      if (const auto value = p->constant()) {
        if (*value == 0) parts_.areas.push_back({});
        return;
      }
      if (const Expression root = p->square_root()) {
        for (const Expression& part : zero_factors(root)) add(part);
        return;
      }
      if (!p->depends_on(Variable::y))
        return add_lines(substitute(factor, Variable::y, number(0)), Variable::x);
      if (!p->depends_on(Variable::x))
        return add_lines(substitute(factor, Variable::x, number(0)), Variable::y);
      if (const auto c = p->linear_factor(Variable::y)) return add_solved(factor, Variable::y, *c);
      if (const auto c = p->linear_factor(Variable::x)) return add_solved(factor, Variable::x, *c);
    }
    add_plane(factor);
  }

  /// Lines x = root or y = root.
  void add_lines(const Expression& f, Variable fixed) {
    const std::size_t axis = fixed == Variable::x ? 0 : 1;
    const Roots found = find_roots(f, fixed, low_[axis], high_[axis]);
    parts_.undecided += found.undecided;
    if (found.has_ranges) add_plane(f);
    const Variable free = fixed == Variable::x ? Variable::y : Variable::x;
    for (const Root& r : found.roots) {
      const Expression at = guarded(number(r.at), substitute(parts_.whole, fixed, number(r.at)));
      add_arc(fixed == Variable::x ? at : variable(Variable::x),
              fixed == Variable::x ? variable(Variable::y) : at, free);
    }
  }

  /// The factor is c*v + rest: v = -rest/c.
  void add_solved(const Expression& factor, Variable v, double c) {
    const Expression solved = solved_for(factor, v, c);
    const Expression value = guarded(solved, substitute(whole_where_zero(factor), v, solved));
    if (v == Variable::y) {
      add_arc(variable(Variable::x), value, Variable::x);
    } else {
      add_arc(value, variable(Variable::y), Variable::y);
    }
  }

  void add_arc(Expression x, Expression y, Variable parameter) {
    const std::size_t axis = parameter == Variable::x ? 0 : 1;
    parts_.arcs.push_back({std::move(x), std::move(y), parameter, low_[axis], high_[axis], false});
  }

  void add_plane(const Expression& factor) {
    PlaneEquation e;
    e.function = factor;
    e.whole = whole_where_zero(factor);
    e.areas = parts_.areas;
    parts_.equations.push_back(std::move(e));
  }

  Expression plain_;
  EquationParts parts_;
  std::array<double, 2> low_;
  std::array<double, 2> high_;
};

}  // namespace

EquationParts split_equation(const Expression& left, const Expression& right,
                             const std::array<double, 2>& low, const std::array<double, 2>& high) {
  const auto is_zero = [](const Expression& e) { return e->kind == NodeKind::number && e->value == 0; };
  // The conditions of "left = right {x > 0}" are set aside, so that algebra sees the equation itself.
  std::vector<Expression> conditions;
  Expression l = left;
  for (; l->kind == NodeKind::function && l->function == Function::where; l = l->arguments[1])
    conditions.push_back(l->arguments[0]);
  const Expression whole = is_zero(right) ? l : is_zero(l) ? right : binary(NodeKind::subtract, l, right);
  return Solver(without_even_roots(reduced(whole)), conditions, low, high).run();
}

}  // namespace nazori::functions
