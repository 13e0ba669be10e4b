// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "algebra.h"
#include "area.h"
#include "lists.h"
#include "nazori/base/utf8.h"
#include "nazori/functions/curve_kinds.h"
#include "parser.h"
#include "regression_model.h"
#include "restricted_statement.h"

namespace nazori::functions {
namespace {

constexpr std::size_t kMostStatements = 32;

bool is_variable(const Expression& e, Variable v) {
  return e->kind == NodeKind::variable && e->variable == v;
}

tl::unexpected<SyntaxError> refuse(const Relation& r, SyntaxFault fault, std::string subject = {}) {
  return tl::unexpected(SyntaxError{r.column, fault, std::move(subject)});
}

/// Of inequalities ";" and "or" may be meant; an area stands for itself.
bool is_region(const Statement& s) { return s.kind == StatementKind::inequality && !s.area; }

bool is_equation(const Relation& r) {
  return r.also.empty() && r.comparisons.size() == 1 && r.comparisons[0] == Comparison::equal;
}

bool falls(Comparison c) { return c == Comparison::greater || c == Comparison::greater_equal; }

/// "0 <= t <= 2pi" or its mirror image.
bool is_range_of(const Relation& r, Variable v) {
  if (r.terms.size() != 3 || !r.also.empty() || !r.conditions.empty()) return false;
  for (const Comparison c : r.comparisons) {
    if (c == Comparison::equal || falls(c) != falls(r.comparisons[0])) return false;
  }
  return is_variable(r.terms[1], v) && variables_of(r.terms[0]).empty() && variables_of(r.terms[2]).empty();
}

/// Turns relations into statements, one after the other.
class Reader {
 public:
  tl::expected<Plot, SyntaxError> run(const std::vector<Relation>& typed, Definitions definitions,
                                      std::span<const DataPoint> data) {
    plot_.parameters = std::move(definitions.parameters);
    plot_.lists = std::move(definitions.lists);
    plot_.questions = std::move(definitions.questions);
    std::vector<Relation> relations;
    for (const Relation& r : typed) {
      auto one = without_and(r);
      if (!one) return tl::unexpected(std::move(one.error()));
      relations.push_back(std::move(*one));
    }
    for (std::size_t i = 0; i < relations.size();) {
      const std::size_t before = plot_.statements.size();
      const auto used = read(std::span(relations).subspan(i));
      if (!used) return tl::unexpected(used.error());
      if (plot_.statements.size() > before) {
        Statement& added = plot_.statements.back();
        added.name = relations[i].name;
        const bool both_are_regions =
            before > 0 && is_region(added) && is_region(plot_.statements[before - 1]);
        if (both_are_regions && !relations[i].either)
          plot_.questions.push_back({added.column, SyntaxFault::ask_both});
      }
      i += *used;
    }
    for (const Statement& s : plot_.statements) {
      if (s.kind == StatementKind::surface && plot_.statements.size() > 1) {
        return tl::unexpected(SyntaxError{s.column, SyntaxFault::surface_not_alone});
      }
    }
    if (plot_.statements.size() > kMostStatements) {
      return tl::unexpected(
          SyntaxError{plot_.statements[kMostStatements].column, SyntaxFault::too_many_statements});
    }
    if (auto expanded = expand_lists(plot_, kMostStatements); !expanded)
      return tl::unexpected(std::move(expanded.error()));
    if (auto fitted = fit_models(plot_, data); !fitted) return tl::unexpected(std::move(fitted.error()));
    return std::move(plot_);
  }

 private:
  Statement& add(StatementKind kind, const Relation& r, std::vector<Expression> terms) {
    Statement s;
    s.kind = kind;
    s.terms = std::move(terms);
    s.column = r.column;
    plot_.statements.push_back(std::move(s));
    return plot_.statements.back();
  }

  static tl::expected<void, SyntaxError> set_range(Statement& s, const Relation* range) {
    s.from = number(0);
    s.to = binary(NodeKind::multiply, number(2), constant(Constant::pi));
    if (range == nullptr) return {};
    if (std::any_of(range->terms.begin(), range->terms.end(), has_list))
      return refuse(*range, SyntaxFault::list_misplaced);
    const bool mirrored = falls(range->comparisons[0]);
    s.from = range->terms[mirrored ? 2 : 0];
    s.to = range->terms[mirrored ? 0 : 2];
    s.from_is_open = is_strict(range->comparisons[mirrored ? 1 : 0]);
    s.to_is_open = is_strict(range->comparisons[mirrored ? 0 : 1]);
    s.range_given = true;
    const double low = constant_value(s.from);
    const double high = constant_value(s.to);
    const bool has_an_end_out = s.from_is_open || s.to_is_open;
    if (!std::isfinite(low) || !std::isfinite(high) || !(has_an_end_out ? low < high : low <= high)) {
      return refuse(*range, SyntaxFault::range_empty);
    }
    return {};
  }

  /// Joins what "and" joins: inequalities become one region, and beside an equation they are conditions.
  static tl::expected<Relation, SyntaxError> without_and(const Relation& typed) {
    if (typed.also.empty() && (typed.conditions.empty() || !is_chain(typed))) return typed;
    if (typed.is_model || std::any_of(typed.also.begin(), typed.also.end(), is_model))
      return refuse(typed, SyntaxFault::model_form);
    std::vector<const Relation*> all{&typed};
    for (const Relation& r : typed.also) all.push_back(&r);
    const Relation* main = nullptr;
    for (const Relation* r : all) {
      if (is_chain(*r)) continue;
      if (main != nullptr) return refuse(*r, SyntaxFault::two_equations);
      main = r;
    }
    Relation joined = main != nullptr ? *main : Relation{};
    joined.also.clear();
    joined.column = typed.column;
    joined.either = typed.either;
    for (const Relation* r : all) {
      if (r == main) continue;
      if (main != nullptr) {
        joined.conditions.push_back(as_condition(*r));
        joined.conditions.insert(joined.conditions.end(), r->conditions.begin(), r->conditions.end());
        continue;
      }
      append(joined, r->terms, r->comparisons);
      for (const Expression& c : r->conditions) {
        if (!append_condition(joined, c)) return refuse(*r, SyntaxFault::choice_in_region);
      }
    }
    return joined;
  }

  static bool is_model(const Relation& r) { return r.is_model; }

  /// Comparisons that are no equation: a region.
  static bool is_chain(const Relation& r) {
    return !r.comparisons.empty() && !(r.comparisons.size() == 1 && r.comparisons[0] == Comparison::equal);
  }

  static void append(Relation& to, const std::vector<Expression>& terms,
                     const std::vector<Comparison>& comparisons) {
    if (!to.terms.empty()) to.comparisons.push_back(Comparison::both);
    to.terms.insert(to.terms.end(), terms.begin(), terms.end());
    to.comparisons.insert(to.comparisons.end(), comparisons.begin(), comparisons.end());
  }

  /// @return false for "or".
  static bool append_condition(Relation& to, const Expression& condition) {
    const auto& a = condition->arguments;
    switch (condition->function) {
      case Function::both:
        return append_condition(to, a[0]) && append_condition(to, a[1]);
      case Function::either:
        return false;
      default:
        break;
    }
    append(to, {a[0], a[1]}, {comparison_of(condition->function)});
    return true;
  }

  static Expression as_condition(const Relation& r) {
    constexpr std::array kFunctions{Function::equal, Function::less, Function::less_equal, Function::greater,
                                    Function::greater_equal};
    Expression all;
    for (std::size_t i = 0; i < r.comparisons.size(); ++i) {
      Expression one =
          call(kFunctions[static_cast<std::size_t>(r.comparisons[i])], {r.terms[i], r.terms[i + 1]});
      all = all ? call(Function::both, {std::move(all), std::move(one)}) : std::move(one);
    }
    return all;
  }

  /// `e` where the conditions hold. The variables of `known` are replaced in them by what they are equal to.
  static Expression restricted(Expression e, const Relation& r,
                               const std::vector<std::pair<Variable, Expression>>& known) {
    for (Expression c : r.conditions) {
      for (const auto& [v, value] : known) c = substitute(c, v, value);
      e = call(Function::where, {std::move(c), std::move(e)});
    }
    return e;
  }

  /// @return how many relations the statement took.
  tl::expected<std::size_t, SyntaxError> read(std::span<const Relation> rest) {
    const Relation& r = rest[0];
    if (r.is_point) {
      Statement& point = add(StatementKind::parametric, r, r.terms);
      point.is_point = point.range_given = true;
      point.from = number(0);
      point.to = number(1);
      return 1;
    }
    if (r.is_model) return model(r);
    if (r.area) {
      plot_.statements.push_back(area_statement(*r.area, r.column));
      return 1;
    }
    if (is_range_of(r, Variable::t) || is_range_of(r, Variable::theta)) {
      return refuse(r, SyntaxFault::range_misplaced);
    }
    if (auto used = parametric(rest); !used || *used > 0) return used;
    std::set<Variable> all;
    for (const Expression& e : r.terms) all.merge(variables_of(e));
    for (const Expression& e : r.conditions) all.merge(variables_of(e));
    if (all.contains(Variable::t)) {
      return refuse(r, SyntaxFault::parameter_alone);
    }
    if (all.contains(Variable::theta) || all.contains(Variable::r)) return polar(rest, all);
    if (all.contains(Variable::z)) return surface(r);
    return plane(r);
  }

  tl::expected<std::size_t, SyntaxError> model(const Relation& r) {
    std::vector<Expression> right = r.conditions;
    right.push_back(r.terms[1]);
    for (const Expression& e : right) {
      if (has_list(e)) return refuse(r, SyntaxFault::list_misplaced);
      for (const Variable v : variables_of(e)) {
        if (v != Variable::x) return refuse(r, SyntaxFault::model_form);
      }
    }
    if (!is_variable(r.terms[0], Variable::y)) return refuse(r, SyntaxFault::model_form);
    add(StatementKind::explicit_y, r, {restricted(r.terms[1], r, {})}).is_model = true;
    return 1;
  }

  /// @return 0 where the relations are not a parametric curve.
  tl::expected<std::size_t, SyntaxError> parametric(std::span<const Relation> rest) {
    if (rest.size() < 2 || !is_equation(rest[0]) || !is_equation(rest[1])) return 0;
    const bool x_first =
        is_variable(rest[0].terms[0], Variable::x) && is_variable(rest[1].terms[0], Variable::y);
    const bool y_first =
        is_variable(rest[0].terms[0], Variable::y) && is_variable(rest[1].terms[0], Variable::x);
    if (!x_first && !y_first) return 0;
    const Expression& first = rest[0].terms[1];
    const Expression& second = rest[1].terms[1];
    for (const Expression& e : {first, second}) {
      for (const Variable v : variables_of(e)) {
        if (v != Variable::t) return 0;
      }
    }
    const bool has_range = rest.size() > 2 && is_range_of(rest[2], Variable::t);
    if (!has_range && !depends_on(first, Variable::t) && !depends_on(second, Variable::t)) return 0;
    const Expression& x = x_first ? first : second;
    Expression y = x_first ? second : first;
    const std::vector<std::pair<Variable, Expression>> known{{Variable::x, x}, {Variable::y, y}};
    for (const Relation* one : {&rest[0], &rest[1]}) {
      Expression whole = restricted(y, *one, known);
      for (const Variable v : variables_of(whole)) {
        if (v != Variable::t)
          return refuse(*one, SyntaxFault::other_variable_in_condition, std::string(name_of(v)));
      }
      y = std::move(whole);
    }
    Statement& s = add(StatementKind::parametric, rest[0], {x, std::move(y)});
    const auto ranged = set_range(s, has_range ? &rest[2] : nullptr);
    if (!ranged) return tl::unexpected(ranged.error());
    return has_range ? 3 : 2;
  }

  tl::expected<std::size_t, SyntaxError> polar(std::span<const Relation> rest,
                                               const std::set<Variable>& all) {
    const Relation& r = rest[0];
    for (const Variable v : all) {
      if (v != Variable::r && v != Variable::theta) {
        return refuse(r, SyntaxFault::polar_mixed, std::string(name_of(v)));
      }
    }
    const bool bare = r.comparisons.empty();
    Statement* s = nullptr;
    if (!bare && !is_equation(r)) {
      s = &add(StatementKind::inequality, r, r.terms);
      s->comparisons = r.comparisons;
    } else if (bare) {
      if (depends_on(r.terms[0], Variable::r)) return refuse(r, SyntaxFault::nothing_equal);
      s = &add(StatementKind::polar, r, {restricted(r.terms[0], r, {{Variable::r, r.terms[0]}})});
    } else if (is_variable(r.terms[0], Variable::r) && !depends_on(r.terms[1], Variable::r)) {
      s = &add(StatementKind::polar, r, {restricted(r.terms[1], r, {{Variable::r, r.terms[1]}})});
    } else if (is_variable(r.terms[1], Variable::r) && !depends_on(r.terms[0], Variable::r)) {
      s = &add(StatementKind::polar, r, {restricted(r.terms[0], r, {{Variable::r, r.terms[0]}})});
    } else {
      s = &add(StatementKind::polar_implicit, r, {restricted(r.terms[0], r, {}), r.terms[1]});
      s->comparisons = r.comparisons;
    }
    const bool has_range = rest.size() > 1 && is_range_of(rest[1], Variable::theta);
    const auto ranged = set_range(*s, has_range ? &rest[1] : nullptr);
    if (!ranged) return tl::unexpected(ranged.error());
    return has_range ? 2 : 1;
  }

  tl::expected<std::size_t, SyntaxError> surface(const Relation& r) {
    if (is_equation(r)) {
      for (const std::size_t i : {0U, 1U}) {
        if (is_variable(r.terms[i], Variable::z) && !depends_on(r.terms[1 - i], Variable::z)) {
          const Expression& height = r.terms[1 - i];
          add(StatementKind::surface, r, {restricted(height, r, {{Variable::z, height}})});
          return 1;
        }
      }
    }
    return refuse(r, SyntaxFault::height_misplaced);
  }

  tl::expected<std::size_t, SyntaxError> plane(const Relation& r) {
    if (r.comparisons.empty()) {
      const bool has_x = depends_on(r.terms[0], Variable::x);
      const bool has_y = depends_on(r.terms[0], Variable::y);
      const StatementKind kind = has_x && has_y ? StatementKind::surface
                                 : has_y        ? StatementKind::explicit_x
                                                : StatementKind::explicit_y;
      const Variable left = kind == StatementKind::explicit_x ? Variable::x : Variable::y;
      add(kind, r,
          {kind == StatementKind::surface ? restricted(r.terms[0], r, {})
                                          : restricted(r.terms[0], r, {{left, r.terms[0]}})});
      return 1;
    }
    if (is_equation(r)) {
      for (const std::size_t i : {0U, 1U}) {
        const Expression& value = r.terms[1 - i];
        if (is_variable(r.terms[i], Variable::y) && !depends_on(value, Variable::y)) {
          add(StatementKind::explicit_y, r, {restricted(value, r, {{Variable::y, value}})});
          return 1;
        }
        if (is_variable(r.terms[i], Variable::x) && !depends_on(value, Variable::x)) {
          add(StatementKind::explicit_x, r, {restricted(value, r, {{Variable::x, value}})});
          return 1;
        }
      }
      add(StatementKind::implicit, r, {restricted(r.terms[0], r, {}), r.terms[1]}).comparisons =
          r.comparisons;
      return 1;
    }
    add(StatementKind::inequality, r, r.terms).comparisons = r.comparisons;
    return 1;
  }

  Plot plot_;
};

std::string sign_of(Comparison c) {
  constexpr std::array<const char*, 6> kSigns{" = ", " < ", " <= ", " > ", " >= ", " and "};
  return kSigns[static_cast<std::size_t>(c)];
}

std::string range_text(const Statement& s, Variable v) {
  return "; " + to_text(s.from) + (s.from_is_open ? " < " : " <= ") + std::string(name_of(v)) +
         (s.to_is_open ? " < " : " <= ") + to_text(s.to);
}

}  // namespace

tl::expected<Plot, SyntaxError> parse(std::string_view text, const ParseOptions& options,
                                      std::span<const DataPoint> data) {
  const auto tokens = tokenize(text, options);
  if (!tokens) return tl::unexpected(tokens.error());
  Parser parser(*tokens);
  const auto relations = parser.run();
  if (!relations) return tl::unexpected(relations.error());
  auto plot = Reader().run(*relations, std::move(parser).definitions(), data);
  if (plot && options.decimal_comma)
    std::erase_if(plot->questions, [](const SyntaxError& q) { return q.fault == SyntaxFault::ask_point; });
  return plot;
}

Comparison comparison_of(Function f) {
  switch (f) {
    case Function::less:
      return Comparison::less;
    case Function::less_equal:
      return Comparison::less_equal;
    case Function::greater:
      return Comparison::greater;
    case Function::greater_equal:
      return Comparison::greater_equal;
    default:
      return Comparison::equal;
  }
}

RestrictedStatement without_conditions(const Statement& s) {
  RestrictedStatement parts{s, {}};
  if (s.kind == StatementKind::inequality || s.is_point) return parts;
  // Of an equation the conditions are kept on its left side.
  const bool is_equation = !curve_kind(s.kind).left[0];
  Expression& whole = is_equation ? parts.plain.terms.front() : parts.plain.terms.back();
  for (; whole->kind == NodeKind::function && whole->function == Function::where;
       whole = Expression(whole->arguments[1]))
    parts.conditions.insert(parts.conditions.begin(), whole->arguments[0]);
  return parts;
}

std::string canonical(const Statement& typed) {
  const auto [s, conditions] = without_conditions(typed);
  if (s.area) return area_text(*s.area);
  if (s.is_point) return "(" + to_text(s.terms[0]) + ", " + to_text(s.terms[1]) + ")";
  const CurveKind& kind = curve_kind(s.kind);
  std::string text;
  for (std::size_t i = 0; i < s.terms.size(); ++i) {
    if (!s.name.empty())
      text += s.name + "(x) = ";
    else if (kind.left[0])
      text += (i > 0 ? "; " : "") + std::string(name_of(*kind.left[i])) + (s.is_model ? " ~ " : " = ");
    else if (i > 0)
      text += sign_of(s.comparisons[i - 1]);
    // "a = x" would define the parameter again.
    const bool is_parameter = s.terms[i]->kind == NodeKind::number && !s.terms[i]->name.empty();
    const bool defines = is_parameter && s.name.empty() && !kind.left[0];
    text += defines ? "(" + to_text(s.terms[i]) + ")" : to_text(s.terms[i]);
  }
  for (const Expression& c : conditions) text += " {" + to_text(c) + "}";
  return kind.says_range(s) ? text + range_text(s, kind.parameter) : text;
}

std::string canonical(const Plot& plot) {
  std::string text;
  const Statement* before = nullptr;
  for (const Statement& one : plot.statements) {
    if (one.element > 0) continue;
    const Statement& s = one.typed ? *one.typed : one;
    const bool regions = before != nullptr && is_region(*before) && is_region(s);
    text += (text.empty() ? "" : regions ? " or " : "; ") + canonical(s);
    before = &one;
  }
  for (const Parameter& p : plot.parameters) {
    text += "; " + p.name + " = " + to_text(number(p.value));
    if (p.range_given)
      text += "; " + to_text(number(p.from)) + " <= " + p.name + " <= " + to_text(number(p.to));
  }
  for (const NamedList& l : plot.lists) text += "; " + l.name + " = " + to_text(l.typed);
  return text;
}

std::optional<std::string> with_parameter(std::string_view text, std::string_view name, double value,
                                          const ParseOptions& options) {
  const auto tokens = tokenize(text, options);
  if (!tokens || !std::isfinite(value)) return std::nullopt;
  Parser parser(*tokens);
  if (!parser.run()) return std::nullopt;
  const std::string letter(name);
  const std::string digits = to_text(number(value));
  if (const auto columns = parser.value_columns(letter)) {
    auto points = base::decode_utf8(text);
    const auto from = static_cast<std::size_t>((*columns)[0] - 1);
    auto to = static_cast<std::size_t>((*columns)[1] - 1);
    // The space in front of what follows stays.
    while (to > from && (*points)[to - 1] == U' ') --to;
    return base::encode_utf8(std::u32string_view(*points).substr(0, from)) + digits +
           base::encode_utf8(std::u32string_view(*points).substr(to));
  }
  const std::vector<Parameter> known = std::move(parser).definitions().parameters;
  const bool is_known =
      std::any_of(known.begin(), known.end(), [&letter](const Parameter& p) { return p.name == letter; });
  if (!is_known) return std::nullopt;
  return std::string(text) + "; " + letter + " = " + digits;
}

std::size_t part_count(const Plot& plot) {
  std::size_t n = 0;
  for (const Statement& s : plot.statements) {
    for (const Expression& e : s.terms) n += node_count(e);
  }
  return n;
}

}  // namespace nazori::functions
