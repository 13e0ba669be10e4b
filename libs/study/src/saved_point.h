// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "nazori/study/handwriting.h"

namespace nazori::study {

/// A point in the units in which it is saved.
struct SavedPoint {
  static constexpr std::int32_t kFarthest = static_cast<std::int32_t>(kFarthestSaved) * kSavedStepsPerUnit;
  static constexpr std::int32_t kLatest = static_cast<std::int32_t>(kLatestSaved_s) * 1'000;
  std::int32_t x = 0;         ///< right
  std::int32_t y = 0;         ///< down
  std::int32_t time_ms = 0;   ///< since the first point of the handwriting
  std::uint8_t pressure = 0;  ///< 0 where it was not known
};

/// The point rounded and limited to the range.
[[nodiscard]] SavedPoint in_steps(const HandwritingPoint& point);
[[nodiscard]] HandwritingPoint from_steps(const SavedPoint& point);

}  // namespace nazori::study
