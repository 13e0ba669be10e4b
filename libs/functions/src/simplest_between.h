// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace nazori::functions {

/// The number with the fewest decimals in [low, high].
[[nodiscard]] inline double simplest_between(double low, double high) {
  double scale = 1;
  for (int digits = 0; digits <= 15; ++digits, scale *= 10) {
    const double candidate = std::round(low / 2 * scale + high / 2 * scale) / scale;
    if (candidate >= low && candidate <= high) return candidate == 0 ? 0 : candidate;
  }
  return low + (high - low) / 2;
}

}  // namespace nazori::functions
