// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nazori/base/result.h"
#include "nazori/functions/plot.h"

namespace nazori::functions {

/// One row of a table of values.
struct ValueRow {
  double parameter = 0;  ///< x of y = f(x), y of x = g(y), else t or theta; of points their number from 0
  double x = 0;          ///< NaN where undefined
  double y = 0;          ///< NaN where undefined
};

/// The places of parameters in a table.
struct ValueSteps {
  double from = -5;
  double to = 5;
  double step = 1;
  static constexpr double kMostRows = 10'000;
};

/// The values of a curve with a course at from, from + step, ... up to `to`. Each parameter is computed by
/// one multiplication, so that steps of 0.1 do not add up their rounding. Of points, the points themselves.
/// @return bad_argument where the steps do not lead from `from` to `to` in at most 10,000 rows, or the
/// statement
///         is an equation, a region or a surface.
[[nodiscard]] base::Result<std::vector<ValueRow>> value_table(const Statement& statement,
                                                              const ValueSteps& steps);

}  // namespace nazori::functions
