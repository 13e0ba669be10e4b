// SPDX-License-Identifier: Apache-2.0
#include "complete_cases.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace nazori::functions {
namespace {

/// The numbers that a condition compares `v` with. @return false where it compares anything else.
bool find_borders(const Expression& condition, Variable v, std::vector<double>& borders) {
  const auto& a = condition->arguments;
  if (is_call(*condition, Function::both) || is_call(*condition, Function::either))
    return find_borders(a[0], v, borders) && find_borders(a[1], v, borders);
  if (const Expression border = border_of(condition, v)) {
    borders.push_back(constant_value(border));
    return std::isfinite(borders.back());
  }
  // 0 < 1
  return variables_of(condition).empty();
}

/// Whether at least one of the conditions holds at every number.
bool cover_all(const std::vector<Expression>& conditions, Variable v) {
  std::vector<double> borders;
  for (const Expression& c : conditions) {
    if (!find_borders(c, v, borders)) return false;
  }
  if (borders.empty()) return false;
  std::sort(borders.begin(), borders.end());
  // Between two borders nothing changes.
  std::vector<double> places{borders.front() - std::abs(borders.front()) - 1};
  for (std::size_t i = 0; i < borders.size(); ++i) {
    places.push_back(borders[i]);
    if (i + 1 < borders.size()) places.push_back(borders[i] + (borders[i + 1] - borders[i]) / 2);
  }
  places.push_back(borders.back() + std::abs(borders.back()) + 1);
  return std::all_of(places.begin(), places.end(), [&](double place) {
    return std::any_of(conditions.begin(), conditions.end(), [&](const Expression& c) {
      return constant_value(substitute(c, v, number(place))) == 1;
    });
  });
}

/// @param before  the conditions of the cases in front of this one.
Expression completed(const Expression& e, Variable v, std::vector<Expression> before) {
  if (is_call(*e, Function::where)) {
    before.push_back(e->arguments[0]);
    return before.size() > 1 && cover_all(before, v) ? e->arguments[1] : e;
  }
  if (!is_call(*e, Function::choose)) return e;
  before.push_back(e->arguments[0]);
  Expression rest = completed(e->arguments[2], v, std::move(before));
  return call(Function::choose, {e->arguments[0], e->arguments[1], std::move(rest)});
}

}  // namespace

Expression border_of(const Expression& comparison, Variable v) {
  const auto& a = comparison->arguments;
  const auto is_variable = [v](const Expression& e) {
    return e->kind == NodeKind::variable && e->variable == v;
  };
  if (!is_variable(a[0]) && !is_variable(a[1])) return nullptr;
  Expression border = a[is_variable(a[0]) ? 1 : 0];
  return variables_of(border).empty() ? border : nullptr;
}

Expression with_complete_cases(const Expression& e, Variable v) {
  // Of an integral inside, the function has its own variable and its own values.
  if (e->arguments.empty() || is_integral(*e)) return e;
  Node n = *e;
  for (Expression& a : n.arguments) a = with_complete_cases(a, v);
  return completed(std::make_shared<const Node>(std::move(n)), v, {});
}

}  // namespace nazori::functions
