// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/parameter_scale.h"

#include <algorithm>
#include <cmath>

namespace nazori::functions {

ParameterScale::ParameterScale(const Parameter& parameter) : from_(parameter.from), to_(parameter.to) {
  // Halves, so that the width of the widest range is not infinite.
  const double least = (to_ / 2 - from_ / 2) / (kMostSteps / 2.0);
  if (!(least > 0)) return;
  const int power = static_cast<int>(std::floor(std::log10(least)));
  for (const double digit : {1.0, 2.0, 5.0, 10.0}) {
    // A negative power is divided by: 0.2 is 2 / 10, but not 2 * 0.1.
    step_ = power < 0 ? digit / std::pow(10.0, -power) : digit * std::pow(10.0, power);
    if (step_ >= least * (1 - 1e-12)) break;
  }
  steps_ = static_cast<int>(std::ceil((to_ / step_ - from_ / step_) * (1 - 1e-12)));
  decimals_ = std::max(0, step_ >= 1 ? 0 : static_cast<int>(std::ceil(-std::log10(step_) - 1e-9)));
}

double ParameterScale::value_at(int place) const {
  if (place <= 0) return from_;
  if (place >= steps_) return to_;
  const double multiple = std::round(from_ / step_ + place);
  // Divided for the same reason as above: 3 * 0.1 is not 0.3.
  const double tens = std::pow(10.0, decimals_);
  const double value = decimals_ > 0 ? std::round(multiple * step_ * tens) / tens : multiple * step_;
  return std::clamp(value, from_, to_);
}

int ParameterScale::place_of(double value) const {
  if (steps_ == 0 || value <= from_) return 0;
  if (value >= to_) return steps_;
  return static_cast<int>(std::lround(value / step_ - from_ / step_));
}

}  // namespace nazori::functions
