// SPDX-License-Identifier: Apache-2.0
#include "derivative.h"

#include <cmath>
#include <utility>
#include <vector>

#include "algebra.h"
#include "complete_cases.h"

namespace nazori::functions {
namespace {

constexpr std::size_t kMostNodes = 3000;

// Sums and products that leave out 0 and 1. Null, which stands for "no closed form", stays null.
Expression plus(const Expression& a, const Expression& b) {
  if (!a || !b) return nullptr;
  if (is_number(a, 0)) return b;
  if (is_number(b, 0)) return a;
  return binary(NodeKind::add, a, b);
}

Expression minus(const Expression& a) {
  if (!a) return nullptr;
  if (a->kind == NodeKind::number) return number(a->value == 0 ? 0 : -a->value, a->exact);
  return a->kind == NodeKind::negate ? a->arguments[0] : negate(a);
}

Expression minus(const Expression& a, const Expression& b) {
  if (!a || !b) return nullptr;
  if (is_number(b, 0)) return a;
  return is_number(a, 0) ? minus(b) : binary(NodeKind::subtract, a, b);
}

Expression times(const Expression& a, const Expression& b) {
  if (!a || !b) return nullptr;
  if (is_number(a, 0) || is_number(b, 0)) return number(0);
  if (is_number(a, 1)) return b;
  if (is_number(b, 1)) return a;
  if (is_number(a, -1)) return minus(b);
  if (is_number(b, -1)) return minus(a);
  return binary(NodeKind::multiply, a, b);
}

Expression over(const Expression& a, const Expression& b) {
  if (!a || !b) return nullptr;
  if (is_number(a, 0)) return a;
  return is_number(b, 1) ? a : binary(NodeKind::divide, a, b);
}

Expression squared(const Expression& a) { return binary(NodeKind::power, a, number(2)); }

/// p/q as parse() would read it, so that rational_value() finds it again.
Expression fraction(Rational r) {
  const Expression top = number(static_cast<double>(r.p));
  return r.q == 1 ? top : binary(NodeKind::divide, top, number(static_cast<double>(r.q)));
}

class Differentiator {
 public:
  /// @param exact  the result is defined only where the derivative exists: not for ln(x) below 0, nor in the
  ///               corner of |x|.
  Differentiator(Variable v, bool exact) : variable_(v), exact_(exact) {}

  Expression of(const Expression& e) {
    if (!e || !depends_on(e, variable_)) return number(0);
    if (++steps_ > kMostNodes) return nullptr;
    const auto& a = e->arguments;
    switch (e->kind) {
      case NodeKind::number:
      case NodeKind::constant:
        return number(0);
      case NodeKind::variable:
        return number(1);
      case NodeKind::negate:
        return minus(of(a[0]));
      case NodeKind::add:
        return plus(of(a[0]), of(a[1]));
      case NodeKind::subtract:
        return minus(of(a[0]), of(a[1]));
      case NodeKind::multiply:
        return plus(times(of(a[0]), a[1]), times(a[0], of(a[1])));
      case NodeKind::divide:
        if (!depends_on(a[1], variable_)) return over(of(a[0]), a[1]);
        return over(minus(times(of(a[0]), a[1]), times(a[0], of(a[1]))), squared(a[1]));
      case NodeKind::power:
        return of_power(a[0], a[1]);
      case NodeKind::function:
        return of_call(*e);
    }
    return nullptr;
  }

 private:
  Expression of_power(const Expression& base, const Expression& exponent) {
    const Expression whole = binary(NodeKind::power, base, exponent);
    if (!depends_on(exponent, variable_)) {
      const auto n = rational_value(exponent);
      if (n && n->p == 0) return number(0);
      Expression lower;
      if (n && n->p == 2 * n->q) {
        lower = base;
      } else if (n) {
        lower = n->p == n->q ? number(1) : binary(NodeKind::power, base, fraction({n->p - n->q, n->q}));
      } else {
        lower = over(whole, base);
      }
      return times(times(n ? fraction(*n) : exponent, lower), of(base));
    }
    const bool natural = base->kind == NodeKind::constant && base->constant == Constant::e;
    const Expression log = natural ? number(1) : call(Function::ln, {base});
    if (!depends_on(base, variable_)) return times(times(whole, log), of(exponent));
    return times(whole, plus(times(of(exponent), log), times(exponent, over(of(base), base))));
  }

  Expression of_call(const Node& n) {
    const auto& a = n.arguments;
    const Expression& u = a[0];
    const Expression one = number(1);
    const auto f = [&u](Function which) { return call(which, {u}); };
    const auto below_one = [&] { return binary(NodeKind::subtract, one, squared(u)); };
    switch (n.function) {
      case Function::sin:
        return times(f(Function::cos), of(u));
      case Function::cos:
        return times(minus(f(Function::sin)), of(u));
      case Function::tan:
        return over(of(u), squared(f(Function::cos)));
      case Function::asin:
        return over(of(u), call(Function::sqrt, {below_one()}));
      case Function::acos:
        return minus(over(of(u), call(Function::sqrt, {below_one()})));
      case Function::atan:
        return over(of(u), binary(NodeKind::add, squared(u), one));
      case Function::sinh:
        return times(f(Function::cosh), of(u));
      case Function::cosh:
        return times(f(Function::sinh), of(u));
      case Function::tanh:
        return over(of(u), squared(f(Function::cosh)));
      case Function::asinh:
        return over(of(u), call(Function::sqrt, {binary(NodeKind::add, squared(u), one)}));
      case Function::acosh:
        return where_above(u, one,
                           over(of(u), call(Function::sqrt, {binary(NodeKind::subtract, squared(u), one)})));
      case Function::atanh:
        return where_above(one, f(Function::abs), over(of(u), below_one()));
      case Function::ln:
        return where_above(u, number(0), over(of(u), u));
      case Function::log10:
        return where_above(u, number(0), over(of(u), times(u, call(Function::ln, {number(10)}))));
      case Function::log2:
        return where_above(u, number(0), over(of(u), times(u, call(Function::ln, {number(2)}))));
      case Function::sqrt:
        return over(of(u), times(number(2), f(Function::sqrt)));
      case Function::abs:
        return times(sign_of(u), of(u));
      case Function::sign:
        return where_above(f(Function::abs), number(0), number(0));
      case Function::floor:
        return where_above(u, f(Function::floor), number(0));
      case Function::ceil:
        return where_above(f(Function::ceil), u, number(0));
      case Function::where:
        return of_where(a[0], a[1]);
      case Function::choose:
        return of_choice(a[0], a[1], a[2]);
      case Function::erf:
        return times(over(of(u), call(Function::sqrt, {constant(Constant::pi)})),
                     times(number(2), binary(NodeKind::power, constant(Constant::e), negate(squared(u)))));
      case Function::min:
      case Function::max: {
        if (a.size() != 2) return nullptr;
        // min(a, b) = (a + b - |a - b|)/2
        const Expression gap = sign_of(binary(NodeKind::subtract, a[0], a[1]));
        const Expression bend = times(gap, minus(of(a[0]), of(a[1])));
        const Expression sum = plus(of(a[0]), of(a[1]));
        return over(n.function == Function::min ? minus(sum, bend) : plus(sum, bend), number(2));
      }
      case Function::integral:
        return minus(at_end(n, a[2]), at_end(n, a[1]));
      case Function::atan2:
        return over(minus(times(a[1], of(a[0])), times(a[0], of(a[1]))),
                    binary(NodeKind::add, squared(a[0]), squared(a[1])));
      default:
        return nullptr;
    }
  }

  /// The slope of an integral that comes from one of its ends.
  Expression at_end(const Node& n, const Expression& end) {
    Expression height = with_complete_cases(n.arguments[0], n.variable);
    if (exact_) height = without_steps(height, n.variable);
    return times(substitute(height, n.variable, end), of(end));
  }

  /// An integral has a corner where the function under it jumps: without these places.
  Expression without_steps(const Expression& e, Variable v) const {
    if (e->arguments.empty() || is_integral(*e)) return e;
    Node n = *e;
    for (Expression& a : n.arguments) a = without_steps(a, v);
    if (n.kind != NodeKind::function) return std::make_shared<const Node>(std::move(n));
    const Expression& u = n.arguments[0];
    Expression plain = std::make_shared<const Node>(n);
    switch (n.function) {
      case Function::sign:
        return where_above(call(Function::abs, {u}), number(0), plain);
      case Function::floor:
        return where_above(u, plain, plain);
      case Function::ceil:
        return where_above(plain, u, plain);
      case Function::where:
        return call(Function::where, {inside(u), n.arguments[1]});
      case Function::choose: {
        const Expression border = ordered_border(u, v);
        if (border && agree(n.arguments[1], n.arguments[2], v, border)) return plain;
        return call(Function::choose, {inside(u), n.arguments[1],
                                       call(Function::where, {inside(opposite(u)), n.arguments[2]})});
      }
      default:
        return plain;
    }
  }

  Expression where_above(const Expression& a, const Expression& b, const Expression& value) const {
    if (!exact_ || !value) return value;
    return call(Function::where, {call(Function::greater, {a, b}), value});
  }

  [[nodiscard]] Expression sign_of(const Expression& u) const {
    if (!exact_) return call(Function::sign, {u});
    return call(Function::choose,
                {call(Function::greater, {u, number(0)}), number(1),
                 call(Function::where, {call(Function::less, {u, number(0)}), number(-1)})});
  }

  Expression of_where(const Expression& condition, const Expression& value) {
    const Expression slope = of(value);
    return slope ? call(Function::where, {exact_ ? inside(condition) : condition, slope}) : nullptr;
  }

  Expression of_choice(const Expression& condition, const Expression& yes, const Expression& no) {
    const Expression first = of(yes);
    const Expression second = of(no);
    if (!first || !second) return nullptr;
    if (!exact_ || meets(condition, yes, no, first, second))
      return call(Function::choose, {condition, first, second});
    return call(Function::choose,
                {inside(condition), first, call(Function::where, {inside(opposite(condition)), second})});
  }

  /// The condition without its border.
  static Expression inside(const Expression& condition) {
    Node n = *condition;
    if (n.function == Function::less_equal) n.function = Function::less;
    if (n.function == Function::greater_equal) n.function = Function::greater;
    if (n.function == Function::both || n.function == Function::either) {
      for (Expression& a : n.arguments) a = inside(a);
    }
    // A single place has no slope.
    if (n.function == Function::equal)
      return call(
          Function::less,
          {call(Function::abs, {binary(NodeKind::subtract, n.arguments[0], n.arguments[1])}), number(0)});
    return std::make_shared<const Node>(std::move(n));
  }

  static Expression opposite(const Expression& condition) {
    Node n = *condition;
    switch (n.function) {
      case Function::less:
        n.function = Function::greater_equal;
        break;
      case Function::less_equal:
        n.function = Function::greater;
        break;
      case Function::greater:
        n.function = Function::less_equal;
        break;
      case Function::greater_equal:
        n.function = Function::less;
        break;
      case Function::both:
      case Function::either:
        n.function = n.function == Function::both ? Function::either : Function::both;
        for (Expression& a : n.arguments) a = opposite(a);
        break;
      default:
        return call(Function::either,
                    {call(Function::less, n.arguments), call(Function::greater, n.arguments)});
    }
    return std::make_shared<const Node>(std::move(n));
  }

  /// Whether two cases with the border "variable = number" have the same value and the same slope there, so
  /// that the slope exists.
  [[nodiscard]] bool meets(const Expression& condition, const Expression& yes, const Expression& no,
                           const Expression& first, const Expression& second) const {
    const Expression border = ordered_border(condition, variable_);
    return border && agree(yes, no, variable_, border) && agree(first, second, variable_, border);
  }

  /// The border of a comparison by order, or null: at that of "=" there are no two sides.
  static Expression ordered_border(const Expression& condition, Variable v) {
    return condition->function <= Function::greater_equal ? border_of(condition, v) : nullptr;
  }

  static bool agree(const Expression& p, const Expression& q, Variable v, const Expression& place) {
    const double at_p = constant_value(substitute(p, v, place));
    const double at_q = constant_value(substitute(q, v, place));
    return std::abs(at_p - at_q) <= 1e-12 * (1 + std::abs(at_p));
  }

  Variable variable_;
  bool exact_ = false;
  std::size_t steps_ = 0;
};

}  // namespace

Expression derivative(const Expression& e, Variable v) {
  if (!e || node_count(e) > kMostNodes) return nullptr;
  Expression d = Differentiator(v, false).of(reduced(e));
  return d && node_count(d) <= kMostNodes ? d : nullptr;
}

Expression slope_where_defined(const Expression& e, Variable v) {
  if (!e || node_count(e) > kMostNodes) return nullptr;
  Expression d = Differentiator(v, true).of(reduced(e));
  return d && node_count(d) <= kMostNodes ? d : nullptr;
}

}  // namespace nazori::functions
