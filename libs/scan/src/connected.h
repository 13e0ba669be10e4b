// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace nazori::scan {

/// A place in a picture, from the upper left corner.
struct Pixel {
  int x = 0;
  int y = 0;
};

/// Takes the pixels that are connected with a set one, also over corners; they are no longer set.
/// @param picture  0: not set, row by row. @param pixels  cleared first; its room is used again.
inline void take_connected(std::vector<std::uint8_t>& picture, int width, int height, Pixel start,
                           std::vector<Pixel>& pixels) {
  const auto at = [&](int x, int y) -> std::uint8_t& {
    return picture[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(x)];
  };
  pixels.assign(1, start);
  at(start.x, start.y) = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const auto [x, y] = pixels[i];
    for (int v = std::max(0, y - 1); v <= std::min(height - 1, y + 1); ++v)
      for (int u = std::max(0, x - 1); u <= std::min(width - 1, x + 1); ++u)
        if (at(u, v) != 0) {
          at(u, v) = 0;
          pixels.push_back({u, v});
        }
  }
}

}  // namespace nazori::scan
