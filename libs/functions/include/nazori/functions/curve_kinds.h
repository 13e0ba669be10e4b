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

/// Where the range of the parameter comes from.
enum class RangeFrom : std::uint8_t {
  nothing,         ///< there is no parameter
  window,          ///< the parameter is x or y: what is visible of that axis
  statement,       ///< Statement::from and to, typed or customary
  if_it_is_given,  ///< the same, but without a typed range there is no limit
};

/// x and y of a curve as expressions in its parameter.
struct Course {
  Expression x;
  Expression y;
};

/// All that the rest of the program has to know of a kind of statement: one row of curve_kinds(). How a kind
/// is typed stands in parse(); docs/extending.md shows how a kind is added.
struct CurveKind {
  StatementKind kind;
  std::string_view name;  ///< in the answers of the command line; several kinds may have one name
  /// What each term is equal to: y of y = f(x). Nothing: the terms are compared with each other.
  std::array<std::optional<Variable>, 2> left;
  DrawnBy drawn_by;
  RangeFrom range;
  Variable parameter;  ///< x where there is none
  /// Of DrawnBy::course, else null.
  Course (*course)(const Statement& statement);
  /// F where the points of the curve are those with F(x, y) = 0; null where no such F is known.
  Expression (*equation)(const Statement& statement);

  /// y = f(x): at most one point above each x, so it is walked and heard from left to right.
  [[nodiscard]] bool is_graph_of_x() const { return course != nullptr && parameter == Variable::x; }
  /// x = g(y).
  [[nodiscard]] bool is_graph_of_y() const { return course != nullptr && parameter == Variable::y; }
  /// A curve with a direction of its own: it is walked as the parameter grows, and may cross itself.
  [[nodiscard]] bool has_own_parameter() const { return course != nullptr && range == RangeFrom::statement; }
  /// Whether the range of the parameter is part of what `statement` says.
  [[nodiscard]] bool says_range(const Statement& statement) const {
    return range == RangeFrom::statement || (range == RangeFrom::if_it_is_given && statement.range_given);
  }
};

/// Every kind once, in the order of StatementKind.
[[nodiscard]] std::span<const CurveKind> curve_kinds();
[[nodiscard]] const CurveKind& curve_kind(StatementKind kind);

}  // namespace nazori::functions
