// SPDX-License-Identifier: Apache-2.0
#include "algebra.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nazori::functions {
namespace {

constexpr int kMostPower = 40;

Expression times(const Expression& a, const Expression& b) {
  if (!a) return b;
  if (!b) return a;
  return binary(NodeKind::multiply, a, b);
}

Fraction common_denominator(const Expression& e) {
  const auto& a = e->arguments;
  switch (e->kind) {
    case NodeKind::negate: {
      const Fraction f = common_denominator(a[0]);
      return {negate(f.numerator), f.denominator};
    }
    case NodeKind::add:
    case NodeKind::subtract: {
      const Fraction f = common_denominator(a[0]);
      const Fraction g = common_denominator(a[1]);
      if (!f.denominator && !g.denominator) return {binary(e->kind, f.numerator, g.numerator), nullptr};
      if (f.denominator && g.denominator && to_text(f.denominator) == to_text(g.denominator))
        return {binary(e->kind, f.numerator, g.numerator), f.denominator};
      return {binary(e->kind, times(f.numerator, g.denominator), times(g.numerator, f.denominator)),
              times(f.denominator, g.denominator)};
    }
    case NodeKind::multiply: {
      const Fraction f = common_denominator(a[0]);
      const Fraction g = common_denominator(a[1]);
      return {times(f.numerator, g.numerator), times(f.denominator, g.denominator)};
    }
    case NodeKind::divide: {
      const Fraction f = common_denominator(a[0]);
      const Fraction g = common_denominator(a[1]);
      return {times(f.numerator, g.denominator), times(f.denominator, g.numerator)};
    }
    case NodeKind::power: {
      const auto n = rational_value(a[1]);
      if (!n || n->q != 1 || n->p == 0 || std::abs(n->p) > kMostPower) break;
      const Fraction f = common_denominator(a[0]);
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

}  // namespace

Fraction over_common_denominator(const Expression& e) {
  if (node_count(e) > kMostNodesOfAlgebra) return {e, nullptr};
  return common_denominator(e);
}

namespace {

/// Where 1 - cos u, 1 + cos u, 1 - sin u or 1 + sin u (or the negative of one of them) is zero, which is
/// where it touches zero: a sine that changes its sign there. Null for all else.
Expression touching_sine(const Expression& e) {
  if (e->kind != NodeKind::add && e->kind != NodeKind::subtract) return nullptr;
  const auto& a = e->arguments;
  const bool number_first = is_number(a[0], 1) || is_number(a[0], -1);
  if (!number_first && !is_number(a[1], 1) && !is_number(a[1], -1)) return nullptr;
  const Expression& wave = a[number_first ? 1 : 0];
  if (wave->kind != NodeKind::function) return nullptr;
  if (wave->function != Function::sin && wave->function != Function::cos) return nullptr;
  // The value of the wave at which the sum is zero.
  const double one = a[number_first ? 0 : 1]->value;
  const bool at_one = (e->kind == NodeKind::subtract) == (one == 1);
  const Expression half = binary(NodeKind::divide, wave->arguments[0], number(2));
  if (wave->function == Function::cos) return call(at_one ? Function::sin : Function::cos, {half});
  const Expression eighth = binary(NodeKind::divide, constant(Constant::pi), number(4));
  return call(Function::sin, {binary(at_one ? NodeKind::subtract : NodeKind::add, half, eighth)});
}

/// Where u - floor(u) or u - c floor(u/c), which is mod(u, c), is zero: at the whole multiples of c, where it
/// jumps. A sine crosses zero there. Null for all else.
Expression sine_of_multiples(const Expression& e) {
  if (e->kind != NodeKind::subtract) return nullptr;
  const Expression& u = e->arguments[0];
  const Expression& multiple = e->arguments[1];
  const bool scaled = multiple->kind == NodeKind::multiply;
  const Expression& step = scaled ? multiple->arguments[1] : multiple;
  if (step->kind != NodeKind::function || step->function != Function::floor) return nullptr;
  const Expression c = scaled ? multiple->arguments[0] : number(1);
  const auto length = rational_value(c);
  if (!length || length->p == 0) return nullptr;
  const auto rest =
      Polynomial::of(binary(NodeKind::subtract, u, binary(NodeKind::multiply, c, step->arguments[0])));
  if (!rest || !rest->is_zero()) return nullptr;
  return call(Function::sin,
              {binary(NodeKind::divide, binary(NodeKind::multiply, constant(Constant::pi), u), c)});
}

}  // namespace

/// Some functions are zero exactly where their argument is 0, or 1.
static std::vector<Expression> zero_factors_of_function(const Expression& e) {
  const Expression& u = e->arguments[0];
  switch (e->function) {
    case Function::sqrt:
    case Function::abs:
    case Function::sign:
    case Function::cbrt:
    case Function::asin:
    case Function::atan:
    case Function::sinh:
    case Function::tanh:
    case Function::asinh:
    case Function::atanh:
    case Function::erf:
      return zero_factors(u);
    case Function::where:
      return zero_factors(e->arguments[1]);
    case Function::acos:
    case Function::acosh:
    case Function::ln:
    case Function::log10:
    case Function::log2:
      return zero_factors(reduced(binary(NodeKind::subtract, u, number(1))));
    default:
      return {e};
  }
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
      return zero_factors_of_function(e);
    case NodeKind::add:
    case NodeKind::subtract:
      if (Expression sine = touching_sine(e)) return {sine};
      if (Expression sine = sine_of_multiples(e)) return {sine};
      return {e};
    default:
      return {e};
  }
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
        case Function::integral:
          return inside;
        default:
          return false;
      }
    default:
      return inside;
  }
}

namespace {

Expression replaced(const Expression& e, const Expression& from, const std::string& from_text,
                    const Expression& to) {
  if (e->kind == from->kind && to_text(e) == from_text) return to;
  if (e->arguments.empty()) return e;
  Node n = *e;
  // What is under an integral is another function than outside.
  for (std::size_t i = is_integral(n) ? 1 : 0; i < n.arguments.size(); ++i)
    n.arguments[i] = replaced(n.arguments[i], from, from_text, to);
  return std::make_shared<const Node>(std::move(n));
}

/// The first |a|, min or max in the tree, or null.
Expression first_choice(const Expression& e) {
  if (e->kind == NodeKind::function &&
      (e->function == Function::abs || e->function == Function::min || e->function == Function::max))
    return e;
  for (const Expression& a : parts_at_a_place(*e)) {
    if (Expression found = first_choice(a)) return found;
  }
  return nullptr;
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

Expression replaced(const Expression& e, const Expression& from, const Expression& to) {
  return replaced(e, from, to_text(from), to);
}

std::vector<Case> cases_of(const Expression& e) {
  std::vector<Case> all;
  bool failed = false;
  split({e, {}}, 4, all, failed);
  if (failed) return {{e, {}}};
  return all;
}

Expression without_even_roots(const Expression& e) {
  if (e->arguments.empty()) return e;
  Node n = *e;
  for (Expression& a : n.arguments) a = without_even_roots(a);
  const bool root = (n.kind == NodeKind::function && n.function == Function::sqrt) ||
                    (n.kind == NodeKind::power && is_number(n.arguments[1], 0.5)) ||
                    (n.kind == NodeKind::power && to_text(n.arguments[1]) == "1/2");
  const Expression& square = n.arguments[0];
  const auto power =
      root && square->kind == NodeKind::power ? rational_value(square->arguments[1]) : std::nullopt;
  if (!power || power->q != 1 || power->p <= 0 || power->p % 2 != 0)
    return std::make_shared<const Node>(std::move(n));
  const Expression size = call(Function::abs, {square->arguments[0]});
  return power->p == 2 ? size : binary(NodeKind::power, size, number(static_cast<double>(power->p) / 2));
}

std::size_t node_count(const Expression& e) {
  std::size_t n = 1;
  for (const Expression& a : e->arguments) n += node_count(a);
  return n;
}

}  // namespace nazori::functions
