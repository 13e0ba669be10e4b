// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace nazori::author {

/// A pixel of a square picture.
struct Pixel {
  int x = 0;
  int y = 0;
  friend bool operator==(const Pixel&, const Pixel&) = default;
};

/// For each pixel of a square picture the nearest pixel without ink. Outside of the picture is no ink, but a
/// frame of one pixel around it counts.
struct DistanceMap {
  int side = 0;
  std::vector<float> distance;  ///< between the centres of pixels, 0 where there is no ink
  std::vector<Pixel> nearest;   ///< the pixel without ink

  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x);
  }
};

/// The exact Euclidean distances.
/// @param ink  side x side values, 0: no ink.
/// @cost in proportion to the number of pixels.
/// @source P. F. Felzenszwalb, D. P. Huttenlocher, "Distance transforms of sampled functions", Theory of
/// Computing 8, 2012.
[[nodiscard]] DistanceMap distance_map(const std::vector<std::uint8_t>& ink, int side);

}  // namespace nazori::author
