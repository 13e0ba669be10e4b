// SPDX-License-Identifier: Apache-2.0
#include "lists.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nazori::functions {
namespace {

/// The step of a range, as an expression.
Expression step_of(const Node& range) {
  const auto& a = range.arguments;
  if (a.size() > 2) return binary(NodeKind::subtract, a[1], a[0]);
  return number(constant_value(a[0]) <= constant_value(a[1]) ? 1 : -1);
}

/// A fraction as it would be typed.
Expression typed(Rational r) {
  const auto whole = [](std::int64_t v) { return number(static_cast<double>(v)); };
  Expression size = whole(std::abs(r.p));
  if (r.q != 1) size = binary(NodeKind::divide, std::move(size), whole(r.q));
  return r.p < 0 ? negate(std::move(size)) : size;
}

/// The element `i` of a range: the typed one, an exact fraction, or first + i*step.
Expression range_element(const Node& range, std::size_t i) {
  const auto& a = range.arguments;
  if (i + 1 < a.size()) return a[i];
  const auto times = static_cast<double>(i);
  const Expression step = step_of(range);
  Expression value = binary(NodeKind::add, a[0], binary(NodeKind::multiply, number(times), step));
  if (const auto exact = rational_value(value)) {
    const double nearest = static_cast<double>(exact->p) / static_cast<double>(exact->q);
    // 0.3 rather than 3/10.
    if (const auto again = rational_value(number(nearest)); again == exact && nearest >= 0)
      return number(nearest, (exact->q & (exact->q - 1)) == 0);
    return typed(*exact);
  }
  if (constant_value(a[0]) == 0) return binary(NodeKind::multiply, number(times), a.size() > 2 ? a[1] : step);
  return value;
}

std::optional<std::size_t> range_count(const Node& range) {
  const auto& a = range.arguments;
  std::vector<double> values;
  for (const Expression& e : a) {
    values.push_back(variables_of(e).empty() ? constant_value(e) : std::nan(""));
    if (!std::isfinite(values.back())) return std::nullopt;
  }
  const double step = constant_value(step_of(range));
  // A hair beside a whole number of steps is rounding.
  const double count = std::floor((values.back() - values[0]) / step + 1e-9);
  if (!(count >= static_cast<double>(a.size()) - 2) || !(count < 1e9)) return std::nullopt;
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    if (std::abs(values[i] - values[0] - static_cast<double>(i) * step) > 1e-9 * std::abs(step))
      return std::nullopt;
  }
  return static_cast<std::size_t>(count) + 1;
}

std::vector<Expression> parts_of(const Statement& s) {
  std::vector<Expression> parts = s.terms;
  for (const Expression& e : {s.from, s.to}) {
    if (e) parts.push_back(e);
  }
  return parts;
}

/// The number of elements that all parts have, or nothing where there is no list.
std::optional<std::size_t> common_count(const std::vector<Expression>& parts) {
  std::optional<std::size_t> least;
  for (const Expression& e : parts) {
    if (const auto n = shortest_list(e); n && (!least || *n < *least)) least = n;
  }
  return least;
}

/// The curves that a statement stands for.
std::vector<Statement> curves_of(const Statement& s, std::size_t count) {
  const auto whole = std::make_shared<const Statement>(s);
  std::vector<Statement> curves;
  for (std::size_t i = 0; i < count; ++i) {
    Statement one = s;
    for (Expression& e : one.terms) e = with_element(e, i);
    one.typed = whole;
    one.element = static_cast<int>(i);
    one.elements = static_cast<int>(count);
    curves.push_back(std::move(one));
  }
  return curves;
}

}  // namespace

bool has_list(const Expression& e) {
  return is_list(*e) || std::any_of(e->arguments.begin(), e->arguments.end(), has_list);
}

std::optional<std::size_t> element_count(const Node& list) {
  return list.function == Function::range ? range_count(list) : list.arguments.size();
}

std::optional<std::size_t> shortest_list(const Expression& e) {
  if (is_list(*e)) return element_count(*e).value_or(0);
  return common_count(e->arguments);
}

Expression with_element(const Expression& e, std::size_t i) {
  if (!has_list(e)) return e;
  if (is_list(*e)) return e->function == Function::range ? range_element(*e, i) : e->arguments[i];
  std::vector<Expression> arguments;
  for (const Expression& a : e->arguments) arguments.push_back(with_element(a, i));
  return with_arguments(*e, std::move(arguments));
}

tl::expected<void, SyntaxError> expand_lists(Plot& plot, std::size_t most_statements) {
  std::vector<Statement> all;
  for (Statement& s : plot.statements) {
    const auto refuse = [&s](SyntaxFault fault) { return tl::unexpected(SyntaxError{s.column, fault}); };
    const auto count = common_count(parts_of(s));
    if (!count || s.is_point) {
      all.push_back(std::move(s));
      continue;
    }
    if ((s.from && has_list(s.from)) || (s.to && has_list(s.to))) return refuse(SyntaxFault::list_misplaced);
    if (s.kind == StatementKind::surface && *count > 1) return refuse(SyntaxFault::surface_not_alone);
    if (all.size() + *count > most_statements) return refuse(SyntaxFault::too_many_curves);
    for (Statement& one : curves_of(s, *count)) all.push_back(std::move(one));
  }
  if (all.size() > most_statements)
    return tl::unexpected(SyntaxError{all[most_statements].column, SyntaxFault::too_many_curves});
  plot.statements = std::move(all);
  return {};
}

std::vector<TypedPoint> typed_points(const Statement& s) {
  if (!s.is_point) return {};
  std::vector<TypedPoint> points;
  const std::size_t count = common_count(s.terms).value_or(1);
  for (std::size_t i = 0; i < count; ++i)
    points.push_back({with_element(s.terms[0], i), with_element(s.terms[1], i)});
  return points;
}

std::vector<double> NamedList::values() const {
  std::vector<double> values;
  for (std::size_t i = 0; i < shortest_list(typed).value_or(0); ++i)
    values.push_back(constant_value(with_element(typed, i)));
  return values;
}

}  // namespace nazori::functions
