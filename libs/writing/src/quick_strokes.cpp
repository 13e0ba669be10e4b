// SPDX-License-Identifier: Apache-2.0
#include "quick_strokes.h"

#include <algorithm>
#include <cmath>

namespace nazori::writing {
namespace {

float length_of(float x, float y) { return std::sqrt(x * x + y * y); }

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

QuickDrawing quick_drawing(std::span<const ThreePoints> strokes) {
  QuickDrawing drawing;
  float sx = 0, sy = 0, ss = 0;
  for (const auto& s : strokes)
    for (std::size_t k = 0; k < 3; ++k) {
      sx += s.x[k];
      sy += s.y[k];
      ss += s.x[k] * s.x[k] + s.y[k] * s.y[k];
    }
  const auto count = static_cast<float>(3 * strokes.size());
  const float x = sx / count;
  const float y = sy / count;
  const float scale = 1 / std::sqrt(std::max(ss / count - x * x - y * y, 1e-12F));
  drawing.strokes.assign(strokes.begin(), strokes.end());
  for (auto& s : drawing.strokes)
    for (std::size_t k = 0; k < 3; ++k) {
      s.x[k] = (s.x[k] - x) * scale;
      s.y[k] = (s.y[k] - y) * scale;
    }
  return drawing;
}

float distance_in_order(const QuickDrawing& drawn, std::span<const ThreePoints> model) {
  // Both of mean square 1: |d - m|^2 = 2 - 2 dm; d is centred, so m need not be.
  float x = 0, y = 0, squares = 0, both = 0;
  for (std::size_t i = 0; i < drawn.strokes.size(); ++i) {
    const auto& d = drawn.strokes[i];
    const auto& m = model[i];
    for (std::size_t k = 0; k < 3; ++k) {
      x += m.x[k];
      y += m.y[k];
      squares += m.x[k] * m.x[k] + m.y[k] * m.y[k];
      both += d.x[k] * m.x[k] + d.y[k] * m.y[k];
    }
  }
  const auto count = static_cast<float>(3 * drawn.strokes.size());
  x /= count;
  y /= count;
  const float spread = std::sqrt(std::max(squares / count - x * x - y * y, 1e-12F));
  return std::max(0.0F, 2 - 2 * both / (count * spread));
}

}  // namespace nazori::writing
