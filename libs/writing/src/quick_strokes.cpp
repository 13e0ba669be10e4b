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

namespace {

/// Sums over the points of strokes.
struct Sums {
  float x = 0, y = 0, squares = 0;

  void add(const ThreePoints& s, float sign = 1) {
    for (std::size_t k = 0; k < 3; ++k) {
      x += sign * s.x[k];
      y += sign * s.y[k];
      squares += sign * (s.x[k] * s.x[k] + s.y[k] * s.y[k]);
    }
  }
  [[nodiscard]] float spread(float count) const {
    return std::sqrt(std::max(squares / count - x / count * (x / count) - y / count * (y / count), 1e-12F));
  }
};

float product(const ThreePoints& a, const ThreePoints& b) {
  float sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += a.x[k] * b.x[k] + a.y[k] * b.y[k];
  return sum;
}

/// Both brought to mean square 1 about their centres, |d - m|^2 = 2 - 2 dm. `both` sums the products.
float distance(float both, const Sums& drawn, const Sums& model, std::size_t strokes) {
  const auto count = static_cast<float>(3 * strokes);
  const float centred = both - (drawn.x * model.x + drawn.y * model.y) / count;
  return std::max(0.0F, 2 - 2 * centred / (count * drawn.spread(count) * model.spread(count)));
}

/// `longer` has one stroke more than `shorter`: leaves out the one without which they are nearest.
float distance_but_one(std::span<const ThreePoints> shorter, std::span<const ThreePoints> longer) {
  const std::size_t n = shorter.size();
  // First the gap is at 0, then it moves up stroke by stroke.
  Sums whole, all;
  float both = 0;
  for (const auto& s : shorter) whole.add(s);
  for (const auto& s : longer) all.add(s);
  for (std::size_t i = 0; i < n; ++i) both += product(shorter[i], longer[i + 1]);
  float least = 4;
  for (std::size_t gap = 0; gap <= n; ++gap) {
    auto others = all;
    others.add(longer[gap], -1);
    least = std::min(least, distance(both, whole, others, n));
    if (gap < n) both += product(shorter[gap], longer[gap]) - product(shorter[gap], longer[gap + 1]);
  }
  return least;
}

}  // namespace

float distance_in_order(const QuickDrawing& drawn, std::span<const ThreePoints> model) {
  Sums whole, sums;
  float both = 0;
  for (std::size_t i = 0; i < drawn.strokes.size(); ++i) {
    whole.add(drawn.strokes[i]);
    sums.add(model[i]);
    both += product(drawn.strokes[i], model[i]);
  }
  return distance(both, whole, sums, drawn.strokes.size());
}

float distance_with_a_gap(const QuickDrawing& drawn, std::span<const ThreePoints> model) {
  return distance_but_one(drawn.strokes, model);
}

float distance_with_one_too_many(const QuickDrawing& drawn, std::span<const ThreePoints> model) {
  return distance_but_one(model, drawn.strokes);
}

}  // namespace nazori::writing
