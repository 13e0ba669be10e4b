// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace nazori::paint {

/// Water or pigment in one cell of a sheet, as a whole number of units. kOne units of water fill the fibres
/// of a cell; kOne units of pigment are in that much undiluted ink. Whole numbers make every exchange exact:
/// what one cell gives, another one takes, to the last unit, on every machine. They also know neither NaN nor
/// denormal numbers.
using Amount = std::int32_t;
/// A sum of amounts. An Amount of every cell of the largest sheet fits several times.
using TotalAmount = std::int64_t;

inline constexpr Amount kOne = Amount{1} << 26;

/// @param fraction  of kOne, within -30..30.
[[nodiscard]] constexpr Amount to_amount(double fraction) {
  return static_cast<Amount>(fraction * kOne + (fraction < 0 ? -0.5 : 0.5));
}
[[nodiscard]] constexpr double to_fraction(TotalAmount amount) { return static_cast<double>(amount) / kOne; }

}  // namespace nazori::paint
