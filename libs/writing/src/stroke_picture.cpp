// SPDX-License-Identifier: Apache-2.0
#include "stroke_picture.h"

#include <algorithm>
#include <cmath>

#include "ink_moments.h"

namespace nazori::writing {

Picture make_picture(std::span<const FlatLine> strokes) {
  constexpr float kHalfWidth = 2.2F;  // of the picture, in spreads
  constexpr auto kCells = static_cast<int>(kPictureCells);
  constexpr float kStep = 0.45F;  // cells between two marks
  auto m = ink_moments(strokes);
  // A flat character stays flat.
  constexpr float kMostSquashed = 0.6F;
  const float larger = std::max({m.spread_x, m.spread_y, 1e-6F});
  m.spread_x = std::max(m.spread_x, kMostSquashed * larger);
  m.spread_y = std::max(m.spread_y, kMostSquashed * larger);
  const float scale_x = static_cast<float>(kCells) / (2 * kHalfWidth * m.spread_x);
  const float scale_y = static_cast<float>(kCells) / (2 * kHalfWidth * m.spread_y);
  constexpr float kMiddle = static_cast<float>(kCells) / 2;
  Picture p{};
  for (const auto& s : strokes) {
    for (std::size_t i = 2; i + 1 < s.size(); i += 2) {
      const float x0 = (s[i - 2] - m.x) * scale_x + kMiddle;
      const float y0 = (s[i - 1] - m.y) * scale_y + kMiddle;
      const float dx = (s[i] - s[i - 2]) * scale_x;
      const float dy = (s[i + 1] - s[i - 1]) * scale_y;
      const float length2 = dx * dx + dy * dy;
      if (length2 <= 1e-12F) continue;
      const float length = std::sqrt(length2);
      // Slants 0, 45, 90, 135 degrees share a segment by squared cosines of the doubled angle.
      const float c = (dx * dx - dy * dy) / length2;
      const float d = 2 * dx * dy / length2;
      const std::array<float, kPictureSlants> share{std::max(c, 0.0F), std::max(d, 0.0F), std::max(-c, 0.0F),
                                                    std::max(-d, 0.0F)};
      const int marks = std::max(1, static_cast<int>(length / kStep + 0.5F));
      const float weight = length / static_cast<float>(marks);
      for (int k = 0; k < marks; ++k) {
        const float t = (static_cast<float>(k) + 0.5F) / static_cast<float>(marks);
        const float x = std::clamp(x0 + dx * t, 0.5F, static_cast<float>(kCells) - 0.5F) - 0.5F;
        const float y = std::clamp(y0 + dy * t, 0.5F, static_cast<float>(kCells) - 0.5F) - 0.5F;
        const int column = std::min(static_cast<int>(x), kCells - 2);
        const int row = std::min(static_cast<int>(y), kCells - 2);
        const float fx = x - static_cast<float>(column);
        const float fy = y - static_cast<float>(row);
        const std::array<float, 4> corner{(1 - fx) * (1 - fy), fx * (1 - fy), (1 - fx) * fy, fx * fy};
        for (std::size_t q = 0; q < 4; ++q) {
          const auto cell =
              static_cast<std::size_t>((row + static_cast<int>(q / 2)) * kCells + column) + q % 2;
          for (std::size_t a = 0; a < kPictureSlants; ++a)
            p[cell * kPictureSlants + a] += weight * corner[q] * share[a];
        }
      }
    }
  }
  // Square roots keep a crowded cell from dominating the others.
  float sum = 0;
  for (auto& v : p) {
    sum += v;
    v = std::sqrt(v);
  }
  if (sum > 0)
    for (auto& v : p) v /= std::sqrt(sum);
  return p;
}

float likeness(const Picture& a, const Picture& b) {
  float sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace nazori::writing
