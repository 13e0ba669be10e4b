// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/functions/plot.h"

namespace nazori::functions {

/// The places of a slider for the values of a parameter: from its lowest value in equal steps that are round
/// numbers (1, 2 or 5 times a power of ten), at most 200 of them.
class ParameterScale {
 public:
  static constexpr int kMostSteps = 200;

  /// @param parameter  with a range that is not empty; of an empty one the scale has a single place.
  explicit ParameterScale(const Parameter& parameter);

  /// Places behind the first one.
  [[nodiscard]] int steps() const { return steps_; }
  [[nodiscard]] double step() const { return step_; }
  /// Digits behind the decimal point that a multiple of the step has.
  [[nodiscard]] int decimals() const { return decimals_; }

  /// The value at a place: a multiple of the step, or an end of the range.
  [[nodiscard]] double value_at(int place) const;
  /// The place nearest to a value; outside of the range the first or the last one.
  [[nodiscard]] int place_of(double value) const;

 private:
  double from_, to_;
  double step_ = 1;
  int steps_ = 0;
  int decimals_ = 0;
};

}  // namespace nazori::functions
