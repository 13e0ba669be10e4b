// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>

#include "nazori/study/time.h"

/// Times and days as the numbers in the store's columns.
namespace nazori::study {

inline std::int64_t number_of(Time time) {
  return static_cast<std::int64_t>(time.time_since_epoch().count());
}
inline std::int64_t number_of(Day day) { return static_cast<std::int64_t>(day.time_since_epoch().count()); }
inline Time time_of(std::int64_t number) { return Time(std::chrono::milliseconds(number)); }
inline Day day_of(std::int64_t number) { return Day(std::chrono::days(number)); }

}  // namespace nazori::study
