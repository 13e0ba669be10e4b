// SPDX-License-Identifier: Apache-2.0
#include "nazori/haptics/fading.h"

#include <algorithm>
#include <cmath>

namespace nazori::haptics {
namespace {

double unit(double value) noexcept { return std::isfinite(value) ? std::clamp(value, 0.0, 1.0) : 0.0; }

}  // namespace

double next_help(double help, double error, double f, double g) noexcept {
  return unit(unit(f) * unit(help) + unit(g) * unit(std::abs(error)));
}

}  // namespace nazori::haptics
