// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace nazori::functions {

enum class Variable : std::uint8_t { x, y, z, t, theta, r };
enum class Constant : std::uint8_t { pi, e, tau };

/// Functions that can be typed, all real: where the real value does not exist the function is undefined.
/// Those from `less` to `choose` are the conditions and cases in braces: a comparison is 1 where it holds
/// and 0 where it does not. Lists are written out before anything is drawn: they stay only in what was typed.
enum class Function : std::uint8_t {
  sin,
  cos,
  tan,
  cot,
  sec,
  csc,
  asin,
  acos,
  atan,
  acot,
  sinh,
  cosh,
  tanh,
  coth,
  sech,
  csch,
  asinh,
  acosh,
  atanh,
  exp,
  ln,
  log10,
  log2,
  log_base,
  sqrt,
  cbrt,
  root,
  abs,
  sign,
  floor,
  ceil,
  round,
  trunc,
  fraction,
  gamma,
  factorial,
  erf,
  min,
  max,
  mod,
  atan2,
  hypot,
  less,           ///< of two: a < b
  less_equal,     ///< of two: a <= b
  greater,        ///< of two: a > b
  greater_equal,  ///< of two: a >= b
  equal,          ///< of two: a = b
  both,           ///< of two conditions: "and"
  either,         ///< of two conditions: "or"
  where,          ///< of a condition and a value: the value where the condition holds, else undefined
  choose,         ///< of a condition and two values: the first where it holds, else the second
  list,           ///< of its elements: [1, 2, 3]
  range,          ///< of the first one or ones and the last: [1...5], [1, 3...9]
  integral        ///< of a function of Node::variable, and the two ends: see integral()
};

/// The functions that stand for several values.
[[nodiscard]] constexpr bool is_list(Function f) { return f == Function::list || f == Function::range; }

/// The functions that are conditions.
[[nodiscard]] constexpr bool is_condition(Function f) { return f >= Function::less && f <= Function::either; }

enum class NodeKind : std::uint8_t {
  number,
  constant,
  variable,
  negate,
  add,
  subtract,
  multiply,
  divide,
  power,
  function
};

class Antiderivative;
struct Node;
/// An expression: an immutable tree, shared freely between threads.
using Expression = std::shared_ptr<const Node>;

/// One node of an expression. Never changed after it was made.
struct Node {
  NodeKind kind = NodeKind::number;
  double value = 0;   ///< of a number: the double nearest to the typed one
  bool exact = true;  ///< whether `value` equals the typed number exactly (0.5 does, 0.1 does not)
  /// Of a number that is a parameter, and of a list: the letter it was typed as; else empty.
  std::string name{};
  Constant constant = Constant::pi;
  Variable variable = Variable::x;  ///< itself, or that of an integral
  Function function = Function::sin;
  std::vector<Expression> arguments;
  /// Of an integral: its values, computed when needed.
  std::shared_ptr<const Antiderivative> antiderivative{};
};

[[nodiscard]] Expression number(double value, bool exact = true);
/// The number that a parameter stands for now. It is written and spoken by its name.
[[nodiscard]] Expression parameter(std::string name, double value, bool exact);
[[nodiscard]] Expression constant(Constant which);
[[nodiscard]] Expression variable(Variable which);
[[nodiscard]] Expression negate(Expression a);
[[nodiscard]] Expression binary(NodeKind kind, Expression a, Expression b);
[[nodiscard]] Expression call(Function function, std::vector<Expression> arguments);

/// The integral of `integrand` over `v` from one end to the other, a function of what its ends depend on.
/// @param integrand  depends on no other variable than `v`; arguments[0] of the node.
[[nodiscard]] Expression integral(Expression integrand, Variable v, Expression from, Expression to);
/// Whether the node is a call of this function.
[[nodiscard]] bool is_call(const Node& n, Function function);
[[nodiscard]] bool is_integral(const Node& n);
/// Whether the node stands for several values.
[[nodiscard]] bool is_list(const Node& n);
/// What the value of the node at a place is computed from: its arguments, of an integral only the two ends.
[[nodiscard]] std::span<const Expression> parts_at_a_place(const Node& n);
/// The node with other arguments. An integral of another function is computed anew.
[[nodiscard]] Expression with_arguments(const Node& n, std::vector<Expression> arguments);

/// The angle `a` of degrees in radians: a*(pi/180).
[[nodiscard]] Expression degrees(Expression a);
/// Whether the tree has the form that degrees() makes; arguments[0] is then the number of degrees.
[[nodiscard]] bool is_degrees(const Node& n);

/// The variables that occur, without those that an integral runs over.
[[nodiscard]] std::set<Variable> variables_of(const Expression& e);
[[nodiscard]] bool depends_on(const Expression& e, Variable v);

/// The tree with every `from` replaced. Parts without `from` are shared, not copied.
[[nodiscard]] Expression substitute(const Expression& e, Variable from, const Expression& to);

/// Text that the parser reads back to the same tree; equal for equal trees. Example: "(1/2)*x".
[[nodiscard]] std::string to_text(const Expression& e);
[[nodiscard]] std::string_view name_of(Variable v);
[[nodiscard]] std::string_view name_of(Constant c);
/// The name that to_text writes: "sin", "ln", "log".
[[nodiscard]] std::string_view name_of(Function f);

/// A fraction of whole numbers in lowest terms, denominator positive.
struct Rational {
  std::int64_t p = 0;
  std::int64_t q = 1;
  friend bool operator==(const Rational&, const Rational&) = default;
};

/// The value of a tree of numbers joined by + - * / and whole powers, where numerator and denominator stay
/// under 10^12. A typed 0.2 counts as 1/5.
[[nodiscard]] std::optional<Rational> rational_value(const Expression& e);

/// Value of an expression without variables, NaN where undefined.
[[nodiscard]] double constant_value(const Expression& e);

/// The same function written with fewer kinds: sec, cot, round, mod, ... become quotients, floors and sums of
/// sin, cos, exp, ... The domain is kept, and cancellations such as x/x are never made.
[[nodiscard]] Expression reduced(const Expression& e);

}  // namespace nazori::functions
