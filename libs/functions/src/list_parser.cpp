// SPDX-License-Identifier: Apache-2.0
// Square brackets: lists [1, 2, 3], ranges [1...5], and letters that stand for a list, a = [1, 2, 3].
#include <algorithm>
#include <cmath>
#include <utility>

#include "derivative.h"
#include "lists.h"
#include "parser.h"

namespace nazori::functions {

Parser::Parsed Parser::list() {
  const Token open = now();
  const Nesting nesting(depth_);
  if (depth_ > kMostDepth) return refuse(SyntaxFault::nested_too_deep);
  ++at_;
  const int bars_outside = std::exchange(open_bars_, 0);
  std::vector<Expression> elements;
  bool is_range = false;
  while (true) {
    if (is(TokenKind::dots) && !elements.empty()) {
      is_range = true;
      ++at_;
      if (is(TokenKind::comma)) ++at_;
    }
    Parsed one = sum();
    if (!one) return one;
    elements.push_back(std::move(*one));
    if (is_range) break;
    if (is(TokenKind::dots)) continue;
    if (!is(TokenKind::comma) && !is(TokenKind::semicolon)) break;
    ++at_;
  }
  open_bars_ = bars_outside;
  if (auto closed = close(open); !closed) return tl::unexpected(std::move(closed.error()));
  if (elements.size() == 1 && !variables_of(elements[0]).empty()) {
    ask(open, SyntaxFault::ask_brackets);
    return std::move(elements[0]);
  }
  const auto wrong = [&open](SyntaxFault fault) { return tl::unexpected(SyntaxError{open.column, fault}); };
  if (std::any_of(elements.begin(), elements.end(), has_list)) return wrong(SyntaxFault::list_in_list);
  Expression all = call(is_range ? Function::range : Function::list, std::move(elements));
  const auto count = element_count(*all);
  if (!count) return wrong(SyntaxFault::list_leads_nowhere);
  if (*count > kMostElements) return wrong(SyntaxFault::too_many_elements);
  return all;
}

Parser::Parsed Parser::named_list(const Definition& d, const Expression& typed) {
  std::vector<Expression> elements;
  for (std::size_t i = 0; i < shortest_list(typed).value_or(0); ++i)
    elements.push_back(with_element(typed, i));
  const bool are_numbers = std::all_of(elements.begin(), elements.end(),
                                       [](const Expression& e) { return std::isfinite(constant_value(e)); });
  if (!are_numbers) return tl::unexpected(SyntaxError{d.column, SyntaxFault::not_a_number, d.letter});
  auto& lists = definitions_.lists;
  const bool is_known =
      std::any_of(lists.begin(), lists.end(), [&d](const NamedList& l) { return l.name == d.letter; });
  if (!is_known) lists.push_back({d.letter, typed});
  Node n = *call(Function::list, std::move(elements));
  n.name = d.letter;
  return std::make_shared<const Node>(std::move(n));
}

Expression Parser::slope_of(const Expression& e, Variable v) {
  const auto count = shortest_list(e);
  if (!count) return slope_where_defined(e, v);
  std::vector<Expression> slopes;
  for (std::size_t i = 0; i < *count; ++i) {
    Expression slope = slope_where_defined(with_element(e, i), v);
    if (!slope) return nullptr;
    slopes.push_back(std::move(slope));
  }
  return call(Function::list, std::move(slopes));
}

}  // namespace nazori::functions
