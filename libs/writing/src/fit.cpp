// SPDX-License-Identifier: Apache-2.0
#include "fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace nazori::writing {
namespace {

// Glyph units squared, per stroke of weight 1.
constexpr double kHoldAspect = 500;
constexpr double kHoldSlant = 1500;
constexpr double kHoldScale = 30;

/// Solves four linear equations by elimination with pivots. The matrix is positive definite.
std::array<double, 4> solve(std::array<std::array<double, 5>, 4> m) {
  for (std::size_t i = 0; i < 4; ++i) {
    std::size_t pivot = i;
    for (std::size_t r = i + 1; r < 4; ++r)
      if (std::abs(m.at(r).at(i)) > std::abs(m.at(pivot).at(i))) pivot = r;
    std::swap(m.at(i), m.at(pivot));
    for (std::size_t r = i + 1; r < 4; ++r) {
      const double f = m.at(r).at(i) / m.at(i).at(i);
      for (std::size_t c = i; c < 5; ++c) m.at(r).at(c) -= f * m.at(i).at(c);
    }
  }
  std::array<double, 4> x{};
  for (std::size_t k = 4; k-- > 0;) {
    double sum = m.at(k).at(4);
    for (std::size_t c = k + 1; c < 4; ++c) sum -= m.at(k).at(c) * x.at(c);
    x.at(k) = sum / m.at(k).at(k);
  }
  return x;
}

struct Ink {
  double x = 0, y = 0, spread = 0;
};

Ink ink_of(std::span<const Shape> shapes) {
  double length = 0;
  Ink ink;
  for (const auto& s : shapes) {
    const double w = std::max(static_cast<double>(s.whole.length), 1e-9);
    length += w;
    ink.x += w * static_cast<double>(s.whole.centre_x);
    ink.y += w * static_cast<double>(s.whole.centre_y);
  }
  ink.x /= length;
  ink.y /= length;
  for (const auto& s : shapes) {
    const double w = std::max(static_cast<double>(s.whole.length), 1e-9) / length;
    const double dx = static_cast<double>(s.whole.centre_x) - ink.x;
    const double dy = static_cast<double>(s.whole.centre_y) - ink.y;
    const double own = static_cast<double>(s.whole.inertia) / static_cast<double>(kSamples);
    ink.spread += w * (dx * dx + dy * dy + own);
  }
  ink.spread = std::sqrt(ink.spread);
  return ink;
}

}  // namespace

Affine fit(std::span<const FitPair> pairs, double expected_scale) {
  double weight = 0;
  double px = 0, py = 0, qx = 0, qy = 0;
  for (const auto& p : pairs) {
    weight += p.weight;
    px += p.weight * static_cast<double>(p.drawn->centre_x);
    py += p.weight * static_cast<double>(p.drawn->centre_y);
    qx += p.weight * static_cast<double>(p.model->centre_x);
    qy += p.weight * static_cast<double>(p.model->centre_y);
  }
  if (weight <= 0) return {};
  px /= weight;
  py /= weight;
  qx /= weight;
  qy /= weight;
  double xx = 0, xy = 0, yy = 0, xu = 0, yu = 0, xv = 0, yv = 0;
  const auto fx = static_cast<float>(px), fy = static_cast<float>(py);
  const auto gx = static_cast<float>(qx), gy = static_cast<float>(qy);
  for (const auto& p : pairs) {
    float sxx = 0, sxy = 0, syy = 0, sxu = 0, syu = 0, sxv = 0, syv = 0;
    for (std::size_t k = 0; k < kSamples; ++k) {
      const std::size_t j = p.reversed ? kSamples - 1 - k : k;
      const float x = p.drawn->x[j] - fx, y = p.drawn->y[j] - fy;
      const float u = p.model->x[k] - gx, v = p.model->y[k] - gy;
      sxx += x * x;
      sxy += x * y;
      syy += y * y;
      sxu += x * u;
      syu += y * u;
      sxv += x * v;
      syv += y * v;
    }
    const double w = p.weight / static_cast<double>(kSamples);
    xx += w * static_cast<double>(sxx);
    xy += w * static_cast<double>(sxy);
    yy += w * static_cast<double>(syy);
    xu += w * static_cast<double>(sxu);
    yu += w * static_cast<double>(syu);
    xv += w * static_cast<double>(sxv);
    yv += w * static_cast<double>(syv);
  }
  const double s = expected_scale;
  const double unit = 1 / (s * s);  // the holds are in glyph units, the drawn samples are 1/s of them
  const double aspect = kHoldAspect * unit, slant = kHoldSlant * unit, scale = kHoldScale * unit;
  // Unknown: a, b, c, d.
  auto x = solve({{{xx + aspect + scale, xy, 0, -aspect, xu + scale * s},
                   {xy, yy + slant, 0, 0, yu},
                   {0, 0, xx + slant, xy, xv},
                   {-aspect, 0, xy, yy + aspect + scale, yv + scale * s}}});
  // Writing is neither mirrored nor squashed flat: in that case use no freedom at all.
  if (x[0] < 0.4 * s || x[3] < 0.4 * s || x[0] > 2.5 * s || x[3] > 2.5 * s) x = {s, 0, 0, s};
  // Nor is it stretched beyond what hands do.
  constexpr double kMostAspect = 1.6;
  if (const double ratio = x[0] / x[3]; ratio > kMostAspect || ratio < 1 / kMostAspect) {
    const double mean = std::sqrt(x[0] * x[3]);
    const double half = std::sqrt(kMostAspect);
    x[0] = ratio > 1 ? mean * half : mean / half;
    x[3] = ratio > 1 ? mean / half : mean * half;
  }
  Affine map{x[0], x[1], 0, x[2], x[3], 0};
  map.tx = qx - map.a * px - map.b * py;
  map.ty = qy - map.c * px - map.d * py;
  return map;
}

Affine fit_by_moments(std::span<const Shape> drawn, std::span<const Shape> model) {
  const auto d = ink_of(drawn);
  const auto m = ink_of(model);
  // The spread of a point is only rounding; no ink is that small.
  constexpr double kOnePoint = 1e-12;
  const double s = d.spread > kOnePoint && m.spread > 0 ? m.spread / d.spread : 1.0;
  return {s, 0, m.x - s * d.x, 0, s, m.y - s * d.y};
}

}  // namespace nazori::writing
