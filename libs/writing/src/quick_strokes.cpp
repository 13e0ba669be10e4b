// SPDX-License-Identifier: Apache-2.0
#include "quick_strokes.h"

#include <algorithm>
#include <cmath>

namespace nazori::writing {
namespace {

float length_of(float x, float y) { return std::sqrt(x * x + y * y); }

struct Frame {
  float x = 0, y = 0, scale = 1;
};

Frame frame_of(std::span<const ThreePoints> strokes) {
  float sx = 0, sy = 0, ss = 0;
  for (const auto& s : strokes)
    for (std::size_t k = 0; k < 3; ++k) {
      sx += s.x[k];
      sy += s.y[k];
      ss += s.x[k] * s.x[k] + s.y[k] * s.y[k];
    }
  const auto n = static_cast<float>(3 * strokes.size());
  Frame f{sx / n, sy / n, 1};
  const float spread = ss / n - f.x * f.x - f.y * f.y;
  f.scale = 1 / std::sqrt(std::max(spread, 1e-12F));
  return f;
}

}  // namespace

ThreePoints three_points(FlatLine line) {
  ThreePoints p;
  const std::size_t n = line.size() / 2;
  float length = 0;
  for (std::size_t i = 1; i < n; ++i)
    length += length_of(line[2 * i] - line[2 * i - 2], line[2 * i + 1] - line[2 * i - 1]);
  p.x[0] = p.x[1] = line[0];
  p.y[0] = p.y[1] = line[1];
  p.x[2] = line[2 * n - 2];
  p.y[2] = line[2 * n - 1];
  float left = length / 2;
  for (std::size_t i = 1; i < n; ++i) {
    const float dx = line[2 * i] - line[2 * i - 2];
    const float dy = line[2 * i + 1] - line[2 * i - 1];
    const float step = length_of(dx, dy);
    if (step >= left) {
      const float t = step > 0 ? left / step : 0;
      p.x[1] = line[2 * i - 2] + dx * t;
      p.y[1] = line[2 * i - 1] + dy * t;
      break;
    }
    left -= step;
  }
  return p;
}

float distance_in_order(std::span<const ThreePoints> drawn, std::span<const ThreePoints> model) {
  const auto m = model.first(drawn.size());
  const Frame a = frame_of(drawn);
  const Frame b = frame_of(m);
  float sum = 0;
  for (std::size_t i = 0; i < drawn.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const float dx = (drawn[i].x[k] - a.x) * a.scale - (m[i].x[k] - b.x) * b.scale;
      const float dy = (drawn[i].y[k] - a.y) * a.scale - (m[i].y[k] - b.y) * b.scale;
      sum += dx * dx + dy * dy;
    }
  return sum / static_cast<float>(3 * drawn.size());
}

}  // namespace nazori::writing
