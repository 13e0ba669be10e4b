// SPDX-License-Identifier: Apache-2.0
// The questions to a GuidancePlan that the servo asks.
#include <algorithm>

#include "guidance_plan.h"

namespace nazori::haptics {

std::int32_t GuidancePlan::stroke_from(std::int32_t from) const noexcept {
  for (std::int32_t n = std::max(1, from); n <= strokes(); ++n) {
    const auto i = static_cast<std::size_t>(n);
    if (pace_from_[i] > pace_from_[i - 1]) return n;
  }
  return 0;
}

double GuidancePlan::speed_m_s(std::int32_t stroke, double arc_m) const noexcept {
  const auto n = static_cast<std::size_t>(stroke);
  const std::size_t first = pace_from_[n - 1], last = pace_from_[n] - 1;
  const double length = length_m(stroke);
  const double at =
      length > 0 ? std::clamp(arc_m / length, 0.0, 1.0) * static_cast<double>(last - first) : 0.0;
  const auto low = static_cast<std::size_t>(at);
  const std::size_t high = std::min(low + 1, last - first);
  const double from = static_cast<double>(pace_m_s_[first + low]);
  const double to = static_cast<double>(pace_m_s_[first + high]);
  return from + (at - static_cast<double>(low)) * (to - from);
}

}  // namespace nazori::haptics
