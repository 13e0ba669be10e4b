// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "nazori/functions/plot.h"

namespace nazori::functions {

/// How the points of a kind are found.
enum class DrawnBy : std::uint8_t {
  course,          ///< by CurveKind::course, in the parameter
  polar_equation,  ///< zeros of an equation in r and theta
  equation,        ///< zeros of an equation in x and y
  region,          ///< where comparisons hold
  heights,         ///< a relief instead of a curve
};

/// The source of the parameter's range.
enum class RangeFrom : std::uint8_t {
  nothing,         ///< there is no parameter
  window,          ///< the parameter is x or y: what is visible of that axis
  statement,       ///< Statement::from and to, typed or by default
  if_it_is_given,  ///< the same, but without a typed range there is no limit
};

/// x and y of a curve as expressions in its parameter.
struct Course {
  Expression x;
  Expression y;
};

/// All properties of a kind of statement that the rest of the program needs: one row of curve_kinds().
/// parse() says how a kind is typed; docs/extending.md shows how a kind is added.
struct CurveKind {
  StatementKind kind;
  std::string_view name;  ///< in the output of the command line; several kinds may share one name
  /// The left side of a term: y of y = f(x). Nothing: the terms are compared with each other.
  std::array<std::optional<Variable>, 2> left;
  DrawnBy drawn_by;
  RangeFrom range;
  Variable parameter;  ///< x where there is none
  /// Of DrawnBy::course, else null.
  Course (*course)(const Statement& statement);
  /// F if the curve consists of the points with F(x, y) = 0; null where no such F is known.
  Expression (*equation)(const Statement& statement);

  /// y = f(x): at most one point above each x, so it is followed and played from left to right.
  [[nodiscard]] bool is_graph_of_x() const { return course != nullptr && parameter == Variable::x; }
  /// x = g(y).
  [[nodiscard]] bool is_graph_of_y() const { return course != nullptr && parameter == Variable::y; }
  /// A curve with a direction of its own: it is followed in the direction of the growing parameter, and may
  /// cross itself.
  [[nodiscard]] bool has_own_parameter() const { return course != nullptr && range == RangeFrom::statement; }
  /// Whether the range of the parameter is part of the text of `statement`.
  [[nodiscard]] bool says_range(const Statement& statement) const {
    return range == RangeFrom::statement || (range == RangeFrom::if_it_is_given && statement.range_given);
  }
};

/// Every kind once, in the order of StatementKind.
[[nodiscard]] std::span<const CurveKind> curve_kinds();
[[nodiscard]] const CurveKind& curve_kind(StatementKind kind);

}  // namespace nazori::functions
