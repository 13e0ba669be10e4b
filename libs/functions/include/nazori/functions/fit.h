// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace nazori::functions {

/// A measured point.
struct DataPoint {
  double x = 0;
  double y = 0;
  friend bool operator==(const DataPoint&, const DataPoint&) = default;
};

/// A letter of a model and the value that was found for it.
struct FittedLetter {
  std::string name;
  double value = 0;
};

/// How a model such as y ~ a x + b was fitted to points by least squares.
struct Fit {
  std::vector<FittedLetter> letters;  ///< in the order in which they were typed
  std::size_t points = 0;             ///< that were fitted
  double residual_sum = 0;            ///< of the squared residuals; 0 where it is no more than rounding
  /// 1 - residual_sum / sum of (y - mean of y)²; NaN where all y are equal.
  double r_squared = 0;
};

}  // namespace nazori::functions
