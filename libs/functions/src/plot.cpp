// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/plot.h"

#include <array>
#include <cmath>
#include <utility>

#include "algebra.h"
#include "nazori/functions/curve_kinds.h"
#include "parser.h"

namespace nazori::functions {
namespace {

constexpr std::size_t kMostStatements = 32;

bool is_variable(const Expression& e, Variable v) {
  return e->kind == NodeKind::variable && e->variable == v;
}

tl::unexpected<SyntaxError> refuse(const Relation& r, SyntaxFault fault, std::string subject = {}) {
  return tl::unexpected(SyntaxError{r.column, fault, std::move(subject)});
}

bool is_equation(const Relation& r) {
  return r.comparisons.size() == 1 && r.comparisons[0] == Comparison::equal;
}

bool falls(Comparison c) { return c == Comparison::greater || c == Comparison::greater_equal; }

/// "0 <= t <= 2pi" or its mirror image.
bool is_range_of(const Relation& r, Variable v) {
  if (r.terms.size() != 3) return false;
  for (const Comparison c : r.comparisons) {
    if (c == Comparison::equal || falls(c) != falls(r.comparisons[0])) return false;
  }
  return is_variable(r.terms[1], v) && variables_of(r.terms[0]).empty() && variables_of(r.terms[2]).empty();
}

/// Turns relations into statements, one after the other.
class Reader {
 public:
  tl::expected<Plot, SyntaxError> run(const std::vector<Relation>& relations) {
    for (std::size_t i = 0; i < relations.size();) {
      const auto used = read(std::span(relations).subspan(i));
      if (!used) return tl::unexpected(used.error());
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

  /// @return how many relations the statement took.
  tl::expected<std::size_t, SyntaxError> read(std::span<const Relation> rest) {
    const Relation& r = rest[0];
    if (is_range_of(r, Variable::t) || is_range_of(r, Variable::theta)) {
      return refuse(r, SyntaxFault::range_misplaced);
    }
    if (auto used = parametric(rest); !used || *used > 0) return used;
    std::set<Variable> all;
    for (const Expression& e : r.terms) all.merge(variables_of(e));
    if (all.contains(Variable::t)) {
      return refuse(r, SyntaxFault::parameter_alone);
    }
    if (all.contains(Variable::theta) || all.contains(Variable::r)) return polar(rest, all);
    if (all.contains(Variable::z)) return surface(r);
    return plane(r, all);
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
    Statement& s = add(StatementKind::parametric, rest[0],
                       x_first ? std::vector{first, second} : std::vector{second, first});
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
      s = &add(StatementKind::polar, r, {r.terms[0]});
    } else if (is_variable(r.terms[0], Variable::r) && !depends_on(r.terms[1], Variable::r)) {
      s = &add(StatementKind::polar, r, {r.terms[1]});
    } else if (is_variable(r.terms[1], Variable::r) && !depends_on(r.terms[0], Variable::r)) {
      s = &add(StatementKind::polar, r, {r.terms[0]});
    } else {
      s = &add(StatementKind::polar_implicit, r, r.terms);
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
          add(StatementKind::surface, r, {r.terms[1 - i]});
          return 1;
        }
      }
    }
    return refuse(r, SyntaxFault::height_misplaced);
  }

  tl::expected<std::size_t, SyntaxError> plane(const Relation& r, const std::set<Variable>& all) {
    if (r.comparisons.empty()) {
      const bool has_x = all.contains(Variable::x);
      const bool has_y = all.contains(Variable::y);
      const StatementKind kind = has_x && has_y ? StatementKind::surface
                                 : has_y        ? StatementKind::explicit_x
                                                : StatementKind::explicit_y;
      add(kind, r, {r.terms[0]});
      return 1;
    }
    if (is_equation(r)) {
      for (const std::size_t i : {0U, 1U}) {
        if (is_variable(r.terms[i], Variable::y) && !depends_on(r.terms[1 - i], Variable::y)) {
          add(StatementKind::explicit_y, r, {r.terms[1 - i]});
          return 1;
        }
        if (is_variable(r.terms[i], Variable::x) && !depends_on(r.terms[1 - i], Variable::x)) {
          add(StatementKind::explicit_x, r, {r.terms[1 - i]});
          return 1;
        }
      }
      add(StatementKind::implicit, r, r.terms).comparisons = r.comparisons;
      return 1;
    }
    add(StatementKind::inequality, r, r.terms).comparisons = r.comparisons;
    return 1;
  }

  Plot plot_;
};

std::string sign_of(Comparison c) {
  constexpr std::array<const char*, 5> kSigns{" = ", " < ", " <= ", " > ", " >= "};
  return kSigns[static_cast<std::size_t>(c)];
}

std::string range_text(const Statement& s, Variable v) {
  return "; " + to_text(s.from) + (s.from_is_open ? " < " : " <= ") + std::string(name_of(v)) +
         (s.to_is_open ? " < " : " <= ") + to_text(s.to);
}

}  // namespace

tl::expected<Plot, SyntaxError> parse(std::string_view text, const ParseOptions& options) {
  const auto tokens = tokenize(text, options);
  if (!tokens) return tl::unexpected(tokens.error());
  const auto relations = Parser(*tokens).run();
  if (!relations) return tl::unexpected(relations.error());
  return Reader().run(*relations);
}

std::string canonical(const Statement& s) {
  const CurveKind& kind = curve_kind(s.kind);
  std::string text;
  for (std::size_t i = 0; i < s.terms.size(); ++i) {
    if (kind.left[0])
      text += (i > 0 ? "; " : "") + std::string(name_of(*kind.left[i])) + " = ";
    else if (i > 0)
      text += sign_of(s.comparisons[i - 1]);
    text += to_text(s.terms[i]);
  }
  return kind.says_range(s) ? text + range_text(s, kind.parameter) : text;
}

std::string canonical(const Plot& plot) {
  std::string text;
  for (const Statement& s : plot.statements) text += (text.empty() ? "" : "; ") + canonical(s);
  return text;
}

std::size_t part_count(const Plot& plot) {
  std::size_t n = 0;
  for (const Statement& s : plot.statements) {
    for (const Expression& e : s.terms) n += node_count(e);
  }
  return n;
}

}  // namespace nazori::functions
