// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <utility>

#include "nazori/functions/drawing.h"
#include "nazori/functions/dual.h"

/// Where a location of a drawn curve lies: in the window, on a piece of its line, and on the curve itself.
namespace nazori::functions {

/// Curves are followed a little beyond the window, so that grooves are whole at its edge; a hand is not.
[[nodiscard]] bool is_in_window(PlatePoint p);

/// The location farthest from `from`, at most `length` along the curve, that is still in the window.
[[nodiscard]] CurvePlace last_in_window(const Tracing& tracing, const CurvePlace& from, double length);

/// The part of the straight piece from p to q that lies in the window, as shares of its length.
[[nodiscard]] std::optional<std::pair<double, double>> part_in_window(PlatePoint p, PlatePoint q);

[[nodiscard]] double distance(PlatePoint a, PlatePoint b);

/// The parameter at a location on a piece of a branch.
[[nodiscard]] double parameter_at(const Branch& branch, const CurvePlace& place);

/// x and y with their slopes by the parameter.
struct CurvePosition {
  Dual<double, 1> x;
  Dual<double, 1> y;
};

/// As the expression itself gives them; nothing for a statement without a parameter.
[[nodiscard]] std::optional<CurvePosition> position_of(const Statement& s, double parameter);

}  // namespace nazori::functions
