// SPDX-License-Identifier: Apache-2.0
#include "parser.h"

#include <utility>

namespace nazori::functions {
namespace {

const char* closing(char32_t open) { return open == U'(' ? ")" : open == U'[' ? "]" : "}"; }

bool closes(char32_t open, char32_t close) {
  return (open == U'(' && close == U')') || (open == U'[' && close == U']') ||
         (open == U'{' && close == U'}');
}

}  // namespace

tl::expected<std::vector<Relation>, SyntaxError> Parser::run() {
  std::vector<Relation> relations;
  while (true) {
    while (is(TokenKind::semicolon)) ++at_;
    if (is(TokenKind::end)) break;
    auto one = relation();
    if (!one) return tl::unexpected(std::move(one.error()));
    relations.push_back(std::move(*one));
    if (!is(TokenKind::semicolon) && !is(TokenKind::end)) {
      return refuse(SyntaxFault::does_not_fit, now().text);
    }
  }
  if (relations.empty()) {
    return refuse(SyntaxFault::no_expression);
  }
  return relations;
}

bool Parser::starts_operand() const {
  switch (now().kind) {
    case TokenKind::number:
    case TokenKind::variable:
    case TokenKind::constant:
    case TokenKind::function:
    case TokenKind::root:
    case TokenKind::open:
      return true;
    case TokenKind::bar:
      return open_bars_ == 0;
    default:
      return false;
  }
}

tl::unexpected<SyntaxError> Parser::refuse(SyntaxFault fault, std::string subject) const {
  return tl::unexpected(SyntaxError{now().column, fault, std::move(subject)});
}

tl::unexpected<SyntaxError> Parser::missing_operand() const {
  if (at_ > 0 && tokens_[at_ - 1].kind != TokenKind::semicolon)
    return refuse(SyntaxFault::operand_missing, tokens_[at_ - 1].text);
  return refuse(SyntaxFault::not_an_operand, now().text);
}

tl::unexpected<SyntaxError> Parser::not_closed(const Token& open) const {
  return tl::unexpected(
      SyntaxError{now().column, SyntaxFault::bracket_open, open.text, closing(open.bracket), open.column, 0});
}

tl::expected<void, SyntaxError> Parser::close(const Token& open) {
  if (!is(TokenKind::close) || !closes(open.bracket, now().bracket)) return not_closed(open);
  ++at_;
  return {};
}

// "y(x) = ..." says the same as "y = ...".
void Parser::skip_definition_head() {
  if (at_ + 4 >= tokens_.size()) return;
  const auto kind = [this](std::size_t i) { return tokens_[at_ + i].kind; };
  const bool fits = kind(0) == TokenKind::variable && tokens_[at_].variable == Variable::y &&
                    kind(1) == TokenKind::open && kind(2) == TokenKind::variable &&
                    tokens_[at_ + 2].variable == Variable::x && kind(3) == TokenKind::close &&
                    kind(4) == TokenKind::comparison;
  if (fits) at_ += 3;
}

tl::expected<Relation, SyntaxError> Parser::relation() {
  Relation r;
  r.column = now().column;
  const std::size_t start = at_;
  skip_definition_head();
  if (at_ != start) {
    r.terms.push_back(variable(Variable::y));
    ++at_;
  } else {
    auto first = sum();
    if (!first) return tl::unexpected(std::move(first.error()));
    r.terms.push_back(std::move(*first));
  }
  while (is(TokenKind::comparison)) {
    r.comparisons.push_back(now().comparison);
    ++at_;
    auto next = sum();
    if (!next) return tl::unexpected(std::move(next.error()));
    r.terms.push_back(std::move(*next));
  }
  return r;
}

Parser::Parsed Parser::sum() {
  const Nesting nesting(depth_);
  if (depth_ > kMostDepth) return refuse(SyntaxFault::nested_too_deep);
  Parsed left = product();
  while (left && (is(TokenKind::plus) || is(TokenKind::minus))) {
    const NodeKind kind = is(TokenKind::plus) ? NodeKind::add : NodeKind::subtract;
    ++at_;
    Parsed right = product();
    if (!right) return right;
    left = binary(kind, std::move(*left), std::move(*right));
  }
  return left;
}

Parser::Parsed Parser::product() {
  Parsed left = signed_operand();
  while (left) {
    NodeKind kind = NodeKind::multiply;
    if (is(TokenKind::times) || is(TokenKind::divide)) {
      kind = is(TokenKind::times) ? NodeKind::multiply : NodeKind::divide;
      ++at_;
    } else if (!starts_operand()) {
      break;
    } else if (is(TokenKind::number) && at_ > 0 && tokens_[at_ - 1].kind == TokenKind::number) {
      return refuse(SyntaxFault::no_operator, now().text);
    }
    Parsed right = signed_operand();
    if (!right) return right;
    left = binary(kind, std::move(*left), std::move(*right));
  }
  return left;
}

Parser::Parsed Parser::signed_operand() {
  if (!is(TokenKind::plus) && !is(TokenKind::minus)) return raised();
  const Nesting nesting(depth_);
  if (depth_ > kMostDepth) return refuse(SyntaxFault::nested_too_deep);
  const bool negative = is(TokenKind::minus);
  ++at_;
  Parsed inner = signed_operand();
  if (inner && negative) return negate(std::move(*inner));
  return inner;
}

Parser::Parsed Parser::raised() {
  Parsed base = factored();
  if (!base || !is(TokenKind::power)) return base;
  ++at_;
  Parsed e = exponent();
  if (!e) return e;
  return binary(NodeKind::power, std::move(*base), std::move(*e));
}

/// What stands after ^: signs bind looser than a further power, 2^-x^2 = 2^(-(x^2)).
Parser::Parsed Parser::exponent() {
  const Nesting nesting(depth_);
  if (depth_ > kMostDepth) return refuse(SyntaxFault::nested_too_deep);
  if (is(TokenKind::plus) || is(TokenKind::minus)) {
    const bool negative = is(TokenKind::minus);
    ++at_;
    Parsed inner = exponent();
    if (inner && negative) return negate(std::move(*inner));
    return inner;
  }
  return raised();
}

Parser::Parsed Parser::factored() {
  Parsed e = operand();
  int raised = 0;
  while (e && (is(TokenKind::factorial) || is(TokenKind::superscript))) {
    if (depth_ + ++raised > kMostDepth) return refuse(SyntaxFault::nested_too_deep);
    if (is(TokenKind::factorial)) {
      e = call(Function::factorial, {std::move(*e)});
    } else {
      e = binary(NodeKind::power, std::move(*e), number(now().value));
    }
    ++at_;
  }
  return e;
}

Parser::Parsed Parser::operand() {
  const Token& token = now();
  switch (token.kind) {
    case TokenKind::number:
      ++at_;
      return number(token.value, token.exact);
    case TokenKind::variable:
      ++at_;
      return variable(token.variable);
    case TokenKind::constant:
      ++at_;
      return constant(token.constant);
    case TokenKind::open:
      return group();
    case TokenKind::bar:
      return bars();
    case TokenKind::function:
      return function_call();
    case TokenKind::root: {
      ++at_;
      const Nesting nesting(depth_);
      if (depth_ > kMostDepth) return refuse(SyntaxFault::nested_too_deep);
      Parsed inner = raised();
      if (!inner) return inner;
      if (token.degree == 2) return call(Function::sqrt, {std::move(*inner)});
      if (token.degree == 3) return call(Function::cbrt, {std::move(*inner)});
      return call(Function::root, {number(token.degree), std::move(*inner)});
    }
    default:
      return missing_operand();
  }
}

Parser::Parsed Parser::bars() {
  const int column = now().column;
  const Nesting nesting(depth_);
  if (depth_ > kMostDepth) return refuse(SyntaxFault::nested_too_deep);
  ++at_;
  ++open_bars_;
  Parsed inner = sum();
  --open_bars_;
  if (!inner) return inner;
  if (!is(TokenKind::bar)) {
    SyntaxError error{now().column, SyntaxFault::bar_open};
    error.number = column;
    return tl::unexpected(std::move(error));
  }
  ++at_;
  return call(Function::abs, {std::move(*inner)});
}

Parser::Parsed Parser::group() {
  const Token open = now();
  ++at_;
  const int bars_outside = std::exchange(open_bars_, 0);
  Parsed inner = sum();
  open_bars_ = bars_outside;
  if (!inner) return inner;
  if (auto closed = close(open); !closed) return tl::unexpected(std::move(closed.error()));
  return inner;
}

}  // namespace nazori::functions
