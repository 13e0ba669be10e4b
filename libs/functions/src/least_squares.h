// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "nazori/functions/fit.h"
#include "regression_model.h"

namespace nazori::functions {

/// How a search for the letters of a model ended.
enum class FitOutcome : std::uint8_t {
  found,
  undefined,     ///< the model has no value at LeastSquares::where
  undetermined,  ///< other letters fit as well
  not_converged
};

/// The letters of a model with the smallest sum of squared residuals.
struct LeastSquares {
  FitOutcome outcome = FitOutcome::found;
  std::vector<double> values;  ///< of all letters
  double residual_sum = 0;
  double where = 0;  ///< x
};

/// Fits a model. A linear one is solved by a QR decomposition in long double; of another one the nonlinear
/// letters are searched from a fixed set of starts, each improved by the method of Levenberg and Marquardt.
/// The same input always gives the same result.
/// @param points  at least as many as letters.
[[nodiscard]] LeastSquares fit(const RegressionModel& model, std::span<const DataPoint> points);

/// Values to start the search for a nonlinear letter from: rates, frequencies and places that suit the
/// points.
[[nodiscard]] std::vector<double> starts_for(std::span<const DataPoint> points);

}  // namespace nazori::functions
