// SPDX-License-Identifier: Apache-2.0
// The questions to a GuidancePlan that the servo asks.
#include <algorithm>

#include "guidance_plan.h"

namespace nazori::haptics {

std::int32_t GuidancePlan::stroke_from(std::int32_t from) const noexcept {
  for (std::int32_t n = std::max(1, from); n <= strokes(); ++n) {
    if (!paces_[static_cast<std::size_t>(n) - 1].empty()) return n;
  }
  return 0;
}

}  // namespace nazori::haptics
