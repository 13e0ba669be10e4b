// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace nazori::view {

/// A picture at half its size, rounded down to at least 1: each texel is the rounded mean of four. The last
/// column or row of an odd size is left out.
/// @param rgba  width * height texels of four bytes.
[[nodiscard]] std::vector<std::uint8_t> halved_picture(std::span<const std::uint8_t> rgba, int width,
                                                       int height);

}  // namespace nazori::view
