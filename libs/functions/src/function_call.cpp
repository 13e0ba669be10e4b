// SPDX-License-Identifier: Apache-2.0
// What follows the name of a function: a base, a power, arguments with or without parentheses.
#include <utility>

#include "parser.h"

namespace nazori::functions {
namespace {

int arity(Function f) {
  switch (f) {
    case Function::mod:
    case Function::atan2:
    case Function::root:
    case Function::log_base:
    case Function::hypot:
      return 2;
    case Function::min:
    case Function::max:
      return -2;  // two or more
    default:
      return 1;
  }
}

/// The inverse that sin^-1 means, or nothing.
std::optional<Function> inverse_of(Function f) {
  switch (f) {
    case Function::sin:
      return Function::asin;
    case Function::cos:
      return Function::acos;
    case Function::tan:
      return Function::atan;
    case Function::cot:
      return Function::acot;
    case Function::sinh:
      return Function::asinh;
    case Function::cosh:
      return Function::acosh;
    case Function::tanh:
      return Function::atanh;
    default:
      return std::nullopt;
  }
}

}  // namespace

tl::expected<std::vector<Expression>, SyntaxError> Parser::argument_list() {
  const Token open = now();
  ++at_;
  const int bars_outside = std::exchange(open_bars_, 0);
  std::vector<Expression> arguments;
  while (true) {
    Parsed one = sum();
    if (!one) return tl::unexpected(std::move(one.error()));
    arguments.push_back(std::move(*one));
    if (!is(TokenKind::comma) && !is(TokenKind::semicolon)) break;
    ++at_;
  }
  open_bars_ = bars_outside;
  if (auto closed = close(open); !closed) return tl::unexpected(std::move(closed.error()));
  return arguments;
}

/// The product after a function name without parentheses; the next function begins a new factor.
Parser::Parsed Parser::bare_argument() {
  const Nesting nesting(depth_);
  if (depth_ > kMostDepth) return refuse(SyntaxFault::nested_too_deep);
  if (is(TokenKind::minus) || is(TokenKind::plus)) {
    const bool negative = is(TokenKind::minus);
    ++at_;
    Parsed inner = bare_argument();
    if (inner && negative) return negate(std::move(*inner));
    return inner;
  }
  Parsed left = raised();
  while (left && starts_operand() && !is(TokenKind::function)) {
    if (is(TokenKind::number) && tokens_[at_ - 1].kind == TokenKind::number)
      return refuse(SyntaxFault::no_operator, now().text);
    Parsed right = raised();
    if (!right) return right;
    left = binary(NodeKind::multiply, std::move(*left), std::move(*right));
  }
  return left;
}

Parser::Parsed Parser::function_call() {
  const Token name = now();
  ++at_;
  Expression base;
  Expression power;
  if (is(TokenKind::underscore) && name.function == Function::log10) {
    ++at_;
    Parsed b = operand();
    if (!b) return b;
    base = std::move(*b);
  }
  if (is(TokenKind::superscript)) {
    power = number(now().value);
    ++at_;
  } else if (is(TokenKind::power)) {
    ++at_;
    const bool negative = is(TokenKind::minus);
    if (negative) ++at_;
    Parsed p = operand();
    if (!p) return p;
    power = negative ? negate(std::move(*p)) : std::move(*p);
  }
  if (is(TokenKind::open)) {
    auto arguments = argument_list();
    if (!arguments) return tl::unexpected(std::move(arguments.error()));
    return finish_call(name, std::move(*arguments), base, power);
  }
  if (!starts_operand() && !is(TokenKind::minus) && !is(TokenKind::plus) && !(is(TokenKind::bar))) {
    return refuse(SyntaxFault::argument_missing, name.text);
  }
  Parsed argument = bare_argument();
  if (!argument) return argument;
  return finish_call(name, {std::move(*argument)}, base, power);
}

Parser::Parsed Parser::finish_call(const Token& name, std::vector<Expression> arguments,
                                   const Expression& base, const Expression& power) {
  const int wanted = arity(name.function);
  const int given = static_cast<int>(arguments.size());
  if ((wanted > 0 && given != wanted) || (wanted < 0 && given < -wanted)) {
    SyntaxError error{name.column, SyntaxFault::argument_count, name.text};
    error.number = given;
    error.wanted = wanted;
    return tl::unexpected(std::move(error));
  }
  Expression e;
  if (base) {
    e = call(Function::log_base, {base, arguments[0]});
  } else if (wanted < 0) {
    e = arguments[0];
    for (std::size_t i = 1; i < arguments.size(); ++i) e = call(name.function, {e, arguments[i]});
  } else {
    e = call(name.function, std::move(arguments));
  }
  if (!power) return e;
  const auto value = rational_value(power);
  if (value && *value == Rational{-1, 1}) {
    if (const auto inverse = inverse_of(name.function)) return call(*inverse, e->arguments);
  }
  return binary(NodeKind::power, std::move(e), power);
}

}  // namespace nazori::functions
