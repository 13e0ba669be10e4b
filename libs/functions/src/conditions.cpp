// SPDX-License-Identifier: Apache-2.0
// Braces: cases {x < 0: -x, x >= 0: x} and the conditions behind an expression {0 <= x <= 2}.
#include <utility>

#include "parser.h"

namespace nazori::functions {
namespace {

Function function_of(Comparison c) {
  switch (c) {
    case Comparison::less:
      return Function::less;
    case Comparison::less_equal:
      return Function::less_equal;
    case Comparison::greater:
      return Function::greater;
    case Comparison::greater_equal:
      return Function::greater_equal;
    default:
      return Function::equal;
  }
}

}  // namespace

Parser::Brace Parser::brace() const {
  if (!is(TokenKind::open) || now().bracket != U'{') return Brace::group;
  int depth = 0;
  bool compares = false;
  for (std::size_t i = at_; i < tokens_.size(); ++i) {
    const Token& t = tokens_[i];
    if (t.kind == TokenKind::open) ++depth;
    if (t.kind == TokenKind::close && --depth == 0) break;
    if (depth != 1) continue;
    if (t.kind == TokenKind::colon) return Brace::cases;
    compares = compares || t.kind == TokenKind::comparison;
  }
  return compares ? Brace::restriction : Brace::group;
}

/// a < b < c is a < b and b < c.
Parser::Parsed Parser::comparison_chain(Expression first) {
  if (!is(TokenKind::comparison)) return refuse(SyntaxFault::condition_missing);
  Expression all;
  while (is(TokenKind::comparison)) {
    const Function f = function_of(now().comparison);
    ++at_;
    Parsed next = sum();
    if (!next) return next;
    Expression one = call(f, {first, *next});
    all = all ? call(Function::both, {std::move(all), std::move(one)}) : std::move(one);
    first = std::move(*next);
  }
  return all;
}

/// What stands behind its first term: comparisons, joined by "and" and, less tightly, by "or".
Parser::Parsed Parser::condition(Expression first) {
  Expression any;
  Parsed all = comparison_chain(std::move(first));
  while (all && (is(TokenKind::both) || is(TokenKind::either))) {
    const bool both = is(TokenKind::both);
    ++at_;
    Parsed term = sum();
    if (!term) return term;
    Parsed next = comparison_chain(std::move(*term));
    if (!next) return next;
    if (both) {
      // A chain behind "and" is joined link by link: (a and b) and c.
      all = joined(std::move(*all), *next);
    } else {
      any = any ? call(Function::either, {std::move(any), std::move(*all)}) : std::move(*all);
      all = std::move(*next);
    }
  }
  if (!all || !any) return all;
  return call(Function::either, {std::move(any), std::move(*all)});
}

Expression Parser::joined(Expression left, const Expression& right) {
  if (right->function != Function::both) return call(Function::both, {std::move(left), right});
  return call(Function::both, {joined(std::move(left), right->arguments[0]), right->arguments[1]});
}

Parser::Parsed Parser::cases() {
  const Token open = now();
  const Nesting nesting(depth_);
  if (depth_ > kMostDepth) return refuse(SyntaxFault::nested_too_deep);
  ++at_;
  const int bars_outside = std::exchange(open_bars_, 0);
  std::vector<std::pair<Expression, Expression>> all;
  Expression otherwise;
  while (true) {
    Parsed first = sum();
    if (!first) return first;
    if (is(TokenKind::comparison)) {
      Parsed when = condition(std::move(*first));
      if (!when) return when;
      if (!is(TokenKind::colon)) return refuse(SyntaxFault::value_missing);
      ++at_;
      Parsed value = sum();
      if (!value) return value;
      all.emplace_back(std::move(*when), std::move(*value));
    } else {
      if (is(TokenKind::colon) || all.empty()) return refuse(SyntaxFault::condition_missing);
      otherwise = std::move(*first);
      break;
    }
    if (!is(TokenKind::comma) && !is(TokenKind::semicolon)) break;
    ++at_;
  }
  open_bars_ = bars_outside;
  if (auto closed = close(open); !closed) return tl::unexpected(std::move(closed.error()));
  if (all.size() > kMostCases) return refuse(SyntaxFault::nested_too_deep);
  for (std::size_t i = all.size(); i-- > 0;) {
    auto& [when, value] = all[i];
    otherwise =
        otherwise ? call(Function::choose, {when, value, otherwise}) : call(Function::where, {when, value});
  }
  return otherwise;
}

tl::expected<std::vector<Expression>, SyntaxError> Parser::restrictions() {
  std::vector<Expression> all;
  while (is(TokenKind::open) && brace() == Brace::restriction) {
    const Token open = now();
    ++at_;
    Parsed first = sum();
    if (!first) return tl::unexpected(std::move(first.error()));
    Parsed one = condition(std::move(*first));
    if (!one) return tl::unexpected(std::move(one.error()));
    if (auto closed = close(open); !closed) return tl::unexpected(std::move(closed.error()));
    all.push_back(std::move(*one));
    if (all.size() > kMostCases) return refuse(SyntaxFault::nested_too_deep);
  }
  return all;
}

}  // namespace nazori::functions
