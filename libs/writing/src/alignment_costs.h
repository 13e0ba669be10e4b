// SPDX-License-Identifier: Apache-2.0
// Costs of everything but a right stroke, in the units of StrokeDifference::cost.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include "alignment.h"

namespace nazori::writing {

inline constexpr float kWrong = 34;    // a wrong stroke in place of a right one
inline constexpr float kMissing = 24;  // wrong < missing + extra
inline constexpr float kExtra = 24;
inline constexpr float kJoined =
    19;  // joined < missing, or every joined pair would count as a missing stroke
inline constexpr float kSplit = 16;
inline constexpr float kOutOfOrder = 3.5F;
inline constexpr float kFar = 60;  // beyond kWrong, because the learner is told how wrong strokes differ
inline constexpr float kNever = std::numeric_limits<float>::max();

/// While the character is still being written, a wrong stroke counts as the one that is due.
[[nodiscard]] inline float extra_cost(Extent extent) {
  return extent == Extent::beginning ? kWrong + 2 : kExtra;
}

/// Cost of `count` strokes not drawn. While the character is still being written, beginning with a later
/// stroke costs the same however many are skipped; otherwise that stroke would count as extra.
[[nodiscard]] inline float missing_cost(Extent extent, std::size_t count) {
  constexpr float kPassedOver = 12;
  constexpr float kEachMore = 1;
  constexpr float kMost = 16;
  const auto strokes = static_cast<float>(count);
  if (extent == Extent::whole || count == 0) return kMissing * strokes;
  return std::min(kPassedOver + kEachMore * (strokes - 1), kMost);
}

}  // namespace nazori::writing
