// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace nazori::functions {

/// A number and how many decimals it has.
struct RoundNumber {
  double value = 0;
  int decimals = 0;
};

/// The number with the fewest decimals in [low, high].
[[nodiscard]] inline RoundNumber roundest_between(double low, double high) {
  constexpr int kMostDecimals = 15;
  double scale = 1;
  for (int digits = 0; digits <= kMostDecimals; ++digits, scale *= 10) {
    const double candidate = std::round(low / 2 * scale + high / 2 * scale) / scale;
    if (candidate >= low && candidate <= high) return {candidate == 0 ? 0 : candidate, digits};
  }
  return {low + (high - low) / 2, kMostDecimals + 1};
}

[[nodiscard]] inline double simplest_between(double low, double high) {
  return roundest_between(low, high).value;
}

}  // namespace nazori::functions
