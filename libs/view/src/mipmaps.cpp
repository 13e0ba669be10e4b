// SPDX-License-Identifier: Apache-2.0
#include "mipmaps.h"

#include <algorithm>
#include <cstddef>

namespace nazori::view {

std::vector<std::uint8_t> halved_picture(std::span<const std::uint8_t> rgba, int width, int height) {
  const auto columns = static_cast<std::size_t>(std::max(width / 2, 1));
  const auto rows = static_cast<std::size_t>(std::max(height / 2, 1));
  const std::size_t stride = static_cast<std::size_t>(width) * 4;
  const std::size_t right = width > 1 ? 4 : 0;
  const std::size_t down = height > 1 ? stride : 0;
  std::vector<std::uint8_t> half(columns * rows * 4);
  for (std::size_t row = 0; row < rows; ++row) {
    const std::uint8_t* above = rgba.data() + 2 * row * stride;
    const std::uint8_t* below = above + down;
    std::uint8_t* out = half.data() + row * columns * 4;
    for (std::size_t column = 0; column < columns; ++column) {
      for (std::size_t c = column * 8; c < column * 8 + 4; ++c)
        *out++ =
            static_cast<std::uint8_t>((above[c] + above[c + right] + below[c] + below[c + right] + 2) / 4);
    }
  }
  return half;
}

}  // namespace nazori::view
