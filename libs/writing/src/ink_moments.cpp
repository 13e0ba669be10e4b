// SPDX-License-Identifier: Apache-2.0
#include "ink_moments.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nazori::writing {

InkMoments ink_moments(std::span<const FlatLine> strokes) {
  float length = 0, x = 0, y = 0, xx = 0, yy = 0;
  for (const auto& s : strokes) {
    for (std::size_t i = 2; i + 1 < s.size(); i += 2) {
      const float dx = s[i] - s[i - 2];
      const float dy = s[i + 1] - s[i - 1];
      const float w = std::sqrt(dx * dx + dy * dy);
      const float mx = (s[i] + s[i - 2]) / 2;
      const float my = (s[i + 1] + s[i - 1]) / 2;
      length += w;
      x += w * mx;
      y += w * my;
      xx += w * (mx * mx + dx * dx / 12);
      yy += w * (my * my + dy * dy / 12);
    }
  }
  if (length <= 0) return {0, 0, 1, 1};
  x /= length;
  y /= length;
  const float spread_x = std::sqrt(std::max(xx / length - x * x, 0.0F));
  const float spread_y = std::sqrt(std::max(yy / length - y * y, 0.0F));
  return {x, y, spread_x, spread_y};
}

float extent_of(std::span<const FlatLine> strokes) {
  constexpr float kFar = std::numeric_limits<float>::max();
  float left = kFar, top = kFar, right = -kFar, bottom = -kFar;
  for (const auto& s : strokes)
    for (std::size_t i = 0; i + 1 < s.size(); i += 2) {
      left = std::min(left, s[i]);
      right = std::max(right, s[i]);
      top = std::min(top, s[i + 1]);
      bottom = std::max(bottom, s[i + 1]);
    }
  return std::max({right - left, bottom - top, 0.0F});
}

}  // namespace nazori::writing
