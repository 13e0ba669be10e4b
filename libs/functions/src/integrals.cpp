// SPDX-License-Identifier: Apache-2.0
// Integrals: integral(t^2, t, 0, x), integral(f, 0, x) of a defined function, and ∫_0^x t^2 dt. Areas:
// area(x^2, 0, 2) and area(x^2, x, 0, 1).
#include <cmath>
#include <set>
#include <utility>

#include "parser.h"

namespace nazori::functions {

Parser::Parsed Parser::integral_between(int column, const Expression& integrand, Variable v, Expression from,
                                        Expression to) {
  for (const Variable other : variables_of(integrand)) {
    if (other != v)
      return tl::unexpected(SyntaxError{column, SyntaxFault::other_variable_in_integral,
                                        std::string(name_of(v)), std::string(name_of(other))});
  }
  return integral(integrand, v, std::move(from), std::move(to));
}

Parser::Parsed Parser::integral_argument() {
  if (!is(TokenKind::comma) && !is(TokenKind::semicolon)) return refuse(SyntaxFault::integral_form);
  ++at_;
  return sum();
}

Parser::Parsed Parser::integral_call() {
  const int column = now().column;
  const Nesting nesting(depth_);
  if (depth_ > kMostDepth) return refuse(SyntaxFault::nested_too_deep);
  ++at_;
  if (!is(TokenKind::open)) return refuse(SyntaxFault::integral_form);
  const Token open = now();
  ++at_;
  const int bars_outside = std::exchange(open_bars_, 0);
  Expression integrand;
  Variable v = Variable::x;
  if (stands_alone()) {
    const Token name = now();
    ++at_;
    Parsed body = function_body(name);
    if (!body) return body;
    integrand = std::move(*body);
    v = definition(name.text)->variable;
  } else {
    Parsed body = sum();
    if (!body) return body;
    integrand = std::move(*body);
    if (!is(TokenKind::comma) && !is(TokenKind::semicolon)) return refuse(SyntaxFault::integral_form);
    ++at_;
    if (!is(TokenKind::variable)) return refuse(SyntaxFault::integral_form);
    v = now().variable;
    ++at_;
  }
  Parsed from = integral_argument();
  if (!from) return from;
  Parsed to = integral_argument();
  if (!to) return to;
  open_bars_ = bars_outside;
  if (auto closed = close(open); !closed) return tl::unexpected(std::move(closed.error()));
  return integral_between(column, integrand, v, std::move(*from), std::move(*to));
}

/// Whether the name of a defined function, f or f', stands here without an argument.
bool Parser::stands_alone() {
  if (!is(TokenKind::name)) return false;
  const Definition* const d = definition(now().text);
  if (d == nullptr || !d->is_function) return false;
  std::size_t next = at_ + 1;
  while (tokens_[next].kind == TokenKind::prime) ++next;
  return tokens_[next].kind == TokenKind::comma || tokens_[next].kind == TokenKind::semicolon;
}

/// An end behind _ or ^: one operand with its signs.
Parser::Parsed Parser::integral_end() {
  const Nesting nesting(depth_);
  if (depth_ > kMostDepth) return refuse(SyntaxFault::nested_too_deep);
  if (!is(TokenKind::minus) && !is(TokenKind::plus)) return operand();
  const bool negative = is(TokenKind::minus);
  ++at_;
  Parsed inner = integral_end();
  if (inner && negative) return negate(std::move(*inner));
  return inner;
}

Parser::Parsed Parser::integral_sign() {
  const int column = now().column;
  const Nesting nesting(depth_);
  if (depth_ > kMostDepth) return refuse(SyntaxFault::nested_too_deep);
  ++at_;
  if (!is(TokenKind::underscore)) return refuse(SyntaxFault::integral_form);
  ++at_;
  Parsed from = integral_end();
  if (!from) return from;
  Parsed to;
  if (is(TokenKind::superscript)) {
    to = number(now().value);
    ++at_;
  } else {
    if (!is(TokenKind::power)) return refuse(SyntaxFault::integral_form);
    ++at_;
    to = integral_end();
  }
  if (!to) return to;
  const int bars_outside = std::exchange(open_bars_, 0);
  Parsed integrand = is(TokenKind::differential) ? number(1) : sum();
  open_bars_ = bars_outside;
  if (!integrand) return integrand;
  if (!is(TokenKind::differential)) return refuse(SyntaxFault::integral_form);
  const Variable v = now().variable;
  ++at_;
  return integral_between(column, *integrand, v, std::move(*from), std::move(*to));
}

Parser::Parsed Parser::area_border() {
  if (!stands_alone()) return sum();
  const Token name = now();
  ++at_;
  Parsed body = function_body(name);
  if (!body) return body;
  return substitute(*body, definition(name.text)->variable, variable(Variable::x));
}

tl::expected<Relation, SyntaxError> Parser::area() {
  Relation r;
  r.column = now().column;
  ++at_;
  const Token open = now();
  if (!is(TokenKind::open)) return refuse(SyntaxFault::area_form);
  ++at_;
  std::vector<Expression> all;
  while (true) {
    Parsed one = area_border();
    if (!one) return tl::unexpected(std::move(one.error()));
    all.push_back(std::move(*one));
    if (!is(TokenKind::comma) && !is(TokenKind::semicolon)) break;
    ++at_;
  }
  if (auto closed = close(open); !closed) return tl::unexpected(std::move(closed.error()));
  const auto wrong = tl::unexpected(SyntaxError{r.column, SyntaxFault::area_form});
  if (all.size() != 3 && all.size() != 4) return wrong;
  Area area{all[0], all.size() == 4 ? all[1] : nullptr, all[all.size() - 2], all.back()};
  for (const Expression& border : {area.first, area.second}) {
    for (const Variable v : border ? variables_of(border) : std::set<Variable>{}) {
      if (v != Variable::x) return wrong;
    }
  }
  for (const Expression& end : {area.from, area.to}) {
    if (!variables_of(end).empty() || !std::isfinite(constant_value(end))) return wrong;
  }
  if (constant_value(area.from) == constant_value(area.to)) return wrong;
  r.terms = std::move(all);
  r.area = std::move(area);
  return r;
}

}  // namespace nazori::functions
