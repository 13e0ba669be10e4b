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

PairMoments moments_of(const FitPair& pair) {
  const auto& d = *pair.drawn;
  const auto& m = *pair.model;
  float xx = 0, xy = 0, yy = 0, xu = 0, yu = 0, xv = 0, yv = 0;
  for (std::size_t k = 0; k < kSamples; ++k) {
    const std::size_t j = pair.reversed ? kSamples - 1 - k : k;
    const float x = d.x[j] - d.centre_x, y = d.y[j] - d.centre_y;
    const float u = m.x[k] - m.centre_x, v = m.y[k] - m.centre_y;
    xx += x * x;
    xy += x * y;
    yy += y * y;
    xu += x * u;
    yu += y * u;
    xv += x * v;
    yv += y * v;
  }
  const auto mean = [](float sum) { return static_cast<double>(sum) / static_cast<double>(kSamples); };
  return {static_cast<double>(d.centre_x),
          static_cast<double>(d.centre_y),
          static_cast<double>(m.centre_x),
          static_cast<double>(m.centre_y),
          mean(xx),
          mean(xy),
          mean(yy),
          mean(xu),
          mean(yu),
          mean(xv),
          mean(yv)};
}

void FitSums::add(const PairMoments& p, double w) {
  weight += w;
  sum.x += w * p.x;
  sum.y += w * p.y;
  sum.u += w * p.u;
  sum.v += w * p.v;
  sum.xx += w * (p.xx + p.x * p.x);
  sum.xy += w * (p.xy + p.x * p.y);
  sum.yy += w * (p.yy + p.y * p.y);
  sum.xu += w * (p.xu + p.x * p.u);
  sum.yu += w * (p.yu + p.y * p.u);
  sum.xv += w * (p.xv + p.x * p.v);
  sum.yv += w * (p.yv + p.y * p.v);
}

void FitSums::add(const FitSums& other, double times) {
  const auto& p = other.sum;
  weight += times * other.weight;
  sum.x += times * p.x;
  sum.y += times * p.y;
  sum.u += times * p.u;
  sum.v += times * p.v;
  sum.xx += times * p.xx;
  sum.xy += times * p.xy;
  sum.yy += times * p.yy;
  sum.xu += times * p.xu;
  sum.yu += times * p.yu;
  sum.xv += times * p.xv;
  sum.yv += times * p.yv;
}

Affine fit(std::span<const FitPair> pairs, double expected_scale) {
  if (pairs.empty()) return {};
  // Sums of large coordinates would lose their small differences.
  const double x = static_cast<double>(pairs.front().drawn->centre_x);
  const double y = static_cast<double>(pairs.front().drawn->centre_y);
  FitSums sums;
  for (const auto& pair : pairs) {
    auto moments = moments_of(pair);
    moments.x -= x;
    moments.y -= y;
    sums.add(moments, pair.weight);
  }
  if (sums.weight <= 0) return {};
  auto map = fit(sums, expected_scale);
  map.tx -= map.a * x + map.b * y;
  map.ty -= map.c * x + map.d * y;
  return map;
}

Affine fit(const FitSums& sums, double expected_scale) {
  if (sums.weight <= 0) return {};
  const auto& of = sums.sum;
  const double px = of.x / sums.weight, py = of.y / sums.weight;
  const double qx = of.u / sums.weight, qy = of.v / sums.weight;
  const double xx = of.xx - of.x * px, xy = of.xy - of.x * py, yy = of.yy - of.y * py;
  const double xu = of.xu - of.x * qx, yu = of.yu - of.y * qx;
  const double xv = of.xv - of.x * qy, yv = of.yv - of.y * qy;
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
