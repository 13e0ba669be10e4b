// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/expression.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "antiderivative.h"
#include "nazori/functions/tape.h"
#include "strength.h"

namespace nazori::functions {
namespace {

constexpr std::int64_t kMostRational = 1'000'000'000'000;

constexpr std::array<std::string_view, 54> kFunctionNames{
    "sin",  "cos",   "tan",       "cot",  "sec",  "csc",   "asin",   "acos",  "atan",  "acot",    "sinh",
    "cosh", "tanh",  "coth",      "sech", "csch", "asinh", "acosh",  "atanh", "exp",   "ln",      "log",
    "log2", "log_b", "sqrt",      "cbrt", "root", "abs",   "sign",   "floor", "ceil",  "round",   "trunc",
    "frac", "gamma", "factorial", "erf",  "min",  "max",   "mod",    "atan2", "hypot", "<",       "<=",
    ">",    ">=",    "=",         "and",  "or",   "where", "choose", "list",  "range", "integral"};

std::string wrapped(const Expression& e, int least) {
  std::string text = to_text(e);
  return strength(*e) < least ? fmt::format("({})", text) : text;
}

std::optional<Rational> lowest(std::int64_t p, std::int64_t q) {
  if (q == 0) return std::nullopt;
  const std::int64_t g = std::gcd(p, q);
  if (g > 1) p /= g, q /= g;
  if (q < 0) p = -p, q = -q;
  if (std::abs(p) > kMostRational || q > kMostRational) return std::nullopt;
  return Rational{p, q};
}

std::optional<std::int64_t> product(std::int64_t a, std::int64_t b) {
  std::int64_t r = 0;
  if (__builtin_mul_overflow(a, b, &r)) return std::nullopt;
  return r;
}

/// The shortest digits that are read back as the number, but never in the form 1e24, which would be read as
/// 1*e*24.
std::string decimal(double v) {
  std::string text = fmt::format("{}", v);
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  const int exponent = std::stoi(text.substr(e + 1));
  std::string sign = text[0] == '-' ? "-" : "";
  std::string digits = text.substr(sign.size(), e - sign.size());
  const std::size_t point = digits.find('.');
  const int fraction = point == std::string::npos ? 0 : static_cast<int>(digits.size() - point - 1);
  if (point != std::string::npos) digits.erase(point, 1);
  const int zeros = exponent - fraction;
  if (zeros >= 0) return sign + digits + std::string(static_cast<std::size_t>(zeros), '0');
  return sign + "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + digits;
}

/// A typed decimal as an exact fraction.
std::optional<Rational> from_decimal(double v) {
  if (!std::isfinite(v) || std::abs(v) > 1e12) return std::nullopt;
  std::int64_t scale = 1;
  for (int digits = 0; digits <= 9; ++digits, scale *= 10) {
    const double scaled = v * static_cast<double>(scale);
    const double whole = std::round(scaled);
    if (std::abs(whole) < 1e12 && whole / static_cast<double>(scale) == v)
      return lowest(static_cast<std::int64_t>(whole), scale);
  }
  return std::nullopt;
}

std::optional<Rational> whole_power(Rational base, std::int64_t n) {
  if (n < 0) {
    const auto inverse = lowest(base.q, base.p);
    return inverse && n > -64 ? whole_power(*inverse, -n) : std::nullopt;
  }
  if (n > 64) return std::nullopt;
  std::optional<Rational> r = Rational{1, 1};
  for (std::int64_t i = 0; i < n && r; ++i) {
    const auto p = product(r->p, base.p);
    const auto q = product(r->q, base.q);
    r = p && q ? lowest(*p, *q) : std::nullopt;
  }
  return r;
}

std::optional<Rational> combine(NodeKind kind, Rational a, Rational b) {
  if (kind == NodeKind::power) return b.q == 1 ? whole_power(a, b.p) : std::nullopt;
  if (kind == NodeKind::subtract) b.p = -b.p;
  if (kind == NodeKind::divide) {
    if (b.p == 0) return std::nullopt;
    std::swap(b.p, b.q);
  }
  if (kind == NodeKind::multiply || kind == NodeKind::divide) {
    const auto p = product(a.p, b.p);
    const auto q = product(a.q, b.q);
    return p && q ? lowest(*p, *q) : std::nullopt;
  }
  const auto left = product(a.p, b.q);
  const auto right = product(b.p, a.q);
  const auto q = product(a.q, b.q);
  std::int64_t p = 0;
  if (!left || !right || !q || __builtin_add_overflow(*left, *right, &p)) return std::nullopt;
  return lowest(p, *q);
}

Expression over(Expression a, Expression b) { return binary(NodeKind::divide, std::move(a), std::move(b)); }
Expression plus(Expression a, Expression b) { return binary(NodeKind::add, std::move(a), std::move(b)); }
Expression minus(Expression a, Expression b) {
  return binary(NodeKind::subtract, std::move(a), std::move(b));
}
Expression times(Expression a, Expression b) {
  return binary(NodeKind::multiply, std::move(a), std::move(b));
}
Expression to_the(Expression a, Expression b) { return binary(NodeKind::power, std::move(a), std::move(b)); }

Expression reduced_call(Function f, const std::vector<Expression>& a) {
  const Expression one = number(1);
  const Expression two = number(2);
  switch (f) {
    case Function::cot:
      return over(call(Function::cos, {a[0]}), call(Function::sin, {a[0]}));
    case Function::sec:
      return over(one, call(Function::cos, {a[0]}));
    case Function::csc:
      return over(one, call(Function::sin, {a[0]}));
    case Function::coth:
      return over(one, call(Function::tanh, {a[0]}));
    case Function::sech:
      return over(one, call(Function::cosh, {a[0]}));
    case Function::csch:
      return over(one, call(Function::sinh, {a[0]}));
    case Function::acot:
      return minus(over(constant(Constant::pi), two), call(Function::atan, {a[0]}));
    case Function::log_base:
      return over(call(Function::ln, {a[1]}), call(Function::ln, {a[0]}));
    case Function::root:
      return to_the(a[1], over(one, a[0]));
    case Function::cbrt:
      return to_the(a[0], over(one, number(3)));
    case Function::exp:
      return to_the(constant(Constant::e), a[0]);
    case Function::round:
      return call(Function::floor, {plus(a[0], number(0.5))});
    case Function::trunc:
      return times(call(Function::sign, {a[0]}), call(Function::floor, {call(Function::abs, {a[0]})}));
    case Function::fraction:
      return minus(a[0], call(Function::floor, {a[0]}));
    case Function::mod:
      return minus(a[0], times(a[1], call(Function::floor, {over(a[0], a[1])})));
    case Function::factorial:
      return call(Function::gamma, {plus(a[0], one)});
    case Function::hypot:
      return call(Function::sqrt, {plus(to_the(a[0], two), to_the(a[1], two))});
    default:
      return call(f, a);
  }
}

}  // namespace

int strength(const Node& n) {
  if (is_degrees(n)) return 5;
  switch (n.kind) {
    case NodeKind::add:
    case NodeKind::subtract:
      return 1;
    case NodeKind::multiply:
    case NodeKind::divide:
      return 2;
    case NodeKind::negate:
      return 3;
    case NodeKind::power:
      return 4;
    default:
      return n.kind == NodeKind::number && n.name.empty() && n.value < 0 ? 3 : 5;
  }
}

Expression number(double value, bool exact) {
  Node n;
  n.value = value;
  n.exact = exact;
  return std::make_shared<const Node>(std::move(n));
}

Expression parameter(std::string name, double value, bool exact) {
  Node n;
  n.value = value;
  n.exact = exact;
  n.name = std::move(name);
  return std::make_shared<const Node>(std::move(n));
}

Expression degrees(Expression a) {
  return binary(NodeKind::multiply, std::move(a),
                binary(NodeKind::divide, constant(Constant::pi), number(180)));
}

bool is_degrees(const Node& n) {
  if (n.kind != NodeKind::multiply || n.arguments[1]->kind != NodeKind::divide) return false;
  const auto& a = n.arguments[1]->arguments;
  return a[0]->kind == NodeKind::constant && a[0]->constant == Constant::pi &&
         a[1]->kind == NodeKind::number && a[1]->name.empty() && a[1]->value == 180;
}

Expression constant(Constant which) {
  Node n;
  n.kind = NodeKind::constant;
  n.constant = which;
  return std::make_shared<const Node>(std::move(n));
}

Expression variable(Variable which) {
  Node n;
  n.kind = NodeKind::variable;
  n.variable = which;
  return std::make_shared<const Node>(std::move(n));
}

Expression negate(Expression a) {
  Node n;
  n.kind = NodeKind::negate;
  n.arguments = {std::move(a)};
  return std::make_shared<const Node>(std::move(n));
}

Expression binary(NodeKind kind, Expression a, Expression b) {
  Node n;
  n.kind = kind;
  n.arguments = {std::move(a), std::move(b)};
  return std::make_shared<const Node>(std::move(n));
}

Expression call(Function function, std::vector<Expression> arguments) {
  Node n;
  n.kind = NodeKind::function;
  n.function = function;
  n.arguments = std::move(arguments);
  return std::make_shared<const Node>(std::move(n));
}

Expression integral(Expression integrand, Variable v, Expression from, Expression to) {
  Node n;
  n.kind = NodeKind::function;
  n.function = Function::integral;
  n.variable = v;
  n.antiderivative = std::make_shared<const Antiderivative>(integrand, v);
  n.arguments = {std::move(integrand), std::move(from), std::move(to)};
  return std::make_shared<const Node>(std::move(n));
}

bool is_call(const Node& n, Function function) {
  return n.kind == NodeKind::function && n.function == function;
}

bool is_integral(const Node& n) { return is_call(n, Function::integral); }

bool is_list(const Node& n) { return n.kind == NodeKind::function && is_list(n.function); }

std::span<const Expression> parts_at_a_place(const Node& n) {
  return std::span(n.arguments).subspan(is_integral(n) ? 1 : 0);
}

Expression with_arguments(const Node& n, std::vector<Expression> arguments) {
  if (is_integral(n) && arguments[0] != n.arguments[0])
    return integral(std::move(arguments[0]), n.variable, std::move(arguments[1]), std::move(arguments[2]));
  Node other = n;
  other.arguments = std::move(arguments);
  return std::make_shared<const Node>(std::move(other));
}

std::set<Variable> variables_of(const Expression& e) {
  if (e->kind == NodeKind::variable) return {e->variable};
  std::set<Variable> all;
  for (const Expression& a : parts_at_a_place(*e)) all.merge(variables_of(a));
  return all;
}

bool depends_on(const Expression& e, Variable v) {
  if (e->kind == NodeKind::variable) return e->variable == v;
  for (const Expression& a : parts_at_a_place(*e)) {
    if (depends_on(a, v)) return true;
  }
  return false;
}

Expression substitute(const Expression& e, Variable from, const Expression& to) {
  if (e->kind == NodeKind::variable) return e->variable == from ? to : e;
  if (!depends_on(e, from)) return e;
  Node n = *e;
  for (Expression& a : std::span(n.arguments).subspan(is_integral(n) ? 1 : 0)) a = substitute(a, from, to);
  return std::make_shared<const Node>(std::move(n));
}

std::string_view name_of(Variable v) {
  constexpr std::array<std::string_view, 6> kNames{"x", "y", "z", "t", "theta", "r"};
  return kNames[static_cast<std::size_t>(v)];
}

std::string_view name_of(Constant c) {
  constexpr std::array<std::string_view, 3> kNames{"pi", "e", "tau"};
  return kNames[static_cast<std::size_t>(c)];
}

std::string_view name_of(Function f) { return kFunctionNames[static_cast<std::size_t>(f)]; }

namespace {

/// The right side of the last comparison of a condition.
const Expression& last_term(const Node& condition) {
  const Expression& last = condition.arguments[1];
  return is_condition(last->function) && last->kind == NodeKind::function ? last_term(*last) : last;
}

std::string condition_text(const Node& n) {
  const auto& a = n.arguments;
  const std::string sign(name_of(n.function));
  if (n.function != Function::both) return to_text(a[0]) + " " + sign + " " + to_text(a[1]);
  // 0 < x and x < 2 is written as it is mostly typed, 0 < x < 2: it is the same tree.
  const Node& next = *a[1];
  if (to_text(last_term(*a[0])) == to_text(next.arguments[0]))
    return to_text(a[0]) + " " + std::string(name_of(next.function)) + " " + to_text(next.arguments[1]);
  return to_text(a[0]) + " and " + to_text(a[1]);
}

/// What stands between the braces.
std::string cases_text(const Node& n) {
  std::string text = to_text(n.arguments[0]) + ": " + to_text(n.arguments[1]);
  if (n.function == Function::where) return text;
  const Node& rest = *n.arguments[2];
  const bool more = rest.kind == NodeKind::function &&
                    (rest.function == Function::choose || rest.function == Function::where);
  return text + ", " + (more ? cases_text(rest) : to_text(n.arguments[2]));
}

/// [1, 2, 3], [1, 3...9]
std::string list_text(const Node& n) {
  if (!n.name.empty()) return n.name;
  std::string text = "[";
  for (std::size_t i = 0; i < n.arguments.size(); ++i) {
    const bool is_last = i + 1 == n.arguments.size();
    if (i > 0) text += n.function == Function::range && is_last ? "..." : ", ";
    text += to_text(n.arguments[i]);
  }
  return text + "]";
}

}  // namespace

std::string to_text(const Expression& e) {
  const Node& n = *e;
  switch (n.kind) {
    case NodeKind::number:
      return n.name.empty() ? decimal(n.value) : n.name;
    case NodeKind::constant:
      return std::string(name_of(n.constant));
    case NodeKind::variable:
      return std::string(name_of(n.variable));
    case NodeKind::negate:
      return fmt::format("-{}", wrapped(n.arguments[0], 3));
    case NodeKind::add:
      return wrapped(n.arguments[0], 1) + " + " + wrapped(n.arguments[1], 2);
    case NodeKind::subtract:
      return wrapped(n.arguments[0], 1) + " - " + wrapped(n.arguments[1], 2);
    case NodeKind::multiply: {
      if (is_degrees(n)) return wrapped(n.arguments[0], 5) + "°";
      // (1/2)*x rather than 1/2*x: the same tree, but unambiguous for people.
      const bool quotient = n.arguments[0]->kind == NodeKind::divide;
      return wrapped(n.arguments[0], quotient ? 3 : 2) + "*" + wrapped(n.arguments[1], 3);
    }
    case NodeKind::divide:
      return wrapped(n.arguments[0], 2) + "/" + wrapped(n.arguments[1], 3);
    case NodeKind::power: {
      const bool plain = strength(*n.arguments[1]) >= 5;
      return wrapped(n.arguments[0], 5) + "^" +
             (plain ? to_text(n.arguments[1]) : fmt::format("({})", to_text(n.arguments[1])));
    }
    case NodeKind::function:
      break;
  }
  if (is_condition(n.function)) return condition_text(n);
  if (n.function == Function::where || n.function == Function::choose) return "{" + cases_text(n) + "}";
  if (is_list(n.function)) return list_text(n);
  if (n.function == Function::abs) return fmt::format("|{}|", to_text(n.arguments[0]));
  if (n.function == Function::factorial) return wrapped(n.arguments[0], 5) + "!";
  std::string text(name_of(n.function));
  text += "(";
  for (std::size_t i = 0; i < n.arguments.size(); ++i) {
    text += (i == 0 ? "" : ", ") + to_text(n.arguments[i]);
    if (i == 0 && is_integral(n)) text += ", " + std::string(name_of(n.variable));
  }
  return text + ")";
}

std::optional<Rational> rational_value(const Expression& e) {
  const Node& n = *e;
  switch (n.kind) {
    case NodeKind::number:
      return from_decimal(n.value);
    case NodeKind::negate: {
      auto r = rational_value(n.arguments[0]);
      if (r) r->p = -r->p;
      return r;
    }
    case NodeKind::add:
    case NodeKind::subtract:
    case NodeKind::multiply:
    case NodeKind::divide:
    case NodeKind::power: {
      const auto a = rational_value(n.arguments[0]);
      const auto b = a ? rational_value(n.arguments[1]) : std::nullopt;
      return b ? combine(n.kind, *a, *b) : std::nullopt;
    }
    default:
      return std::nullopt;
  }
}

double constant_value(const Expression& e) {
  const Tape tape = Tape::compile({&e, 1}, {});
  return tape.evaluate_one<double>({});
}

Expression reduced(const Expression& e) {
  if (e->arguments.empty()) return e;
  std::vector<Expression> arguments;
  arguments.reserve(e->arguments.size());
  for (const Expression& a : e->arguments) arguments.push_back(reduced(a));
  if (e->kind == NodeKind::function && !is_integral(*e)) return reduced_call(e->function, arguments);
  Node n = *e;
  n.arguments = std::move(arguments);
  return std::make_shared<const Node>(std::move(n));
}

}  // namespace nazori::functions
