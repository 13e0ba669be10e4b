// SPDX-License-Identifier: Apache-2.0
#include "ink_match.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace nazori::writing {
namespace {

/// For each point of both, the square of the distance to the nearest of the other, with its index in the last
/// bits: so that the least of them can be found several at a time.
struct Nearest {
  alignas(32) std::array<float, kInkPoints> of_drawn;
  alignas(32) std::array<float, kInkPoints> of_model;
};

constexpr std::uint32_t kIndex = kInkPoints - 1;
static_assert((kInkPoints & kIndex) == 0);

float marked(float square, std::uint32_t index) {
  return std::bit_cast<float>((std::bit_cast<std::uint32_t>(square) & ~kIndex) | index);
}

std::size_t index_in(float marked) { return std::bit_cast<std::uint32_t>(marked) & kIndex; }

void find_nearest(const InkPoints& a, const InkPoints& b, Nearest& found) {
  constexpr float kSlant = 0.3F;  // the square of the distance that slants at right angles are worth
  constexpr float kFar = 1e9F;
  constexpr float kLeast = 1e-3F;  // marks would make tiny numbers, which are slow, of 0
  found.of_model.fill(kFar);
  alignas(32) std::array<float, kInkPoints> row;
  for (std::size_t i = 0; i < kInkPoints; ++i) {
    for (std::size_t j = 0; j < kInkPoints; ++j) {
      const float dx = a.x[i] - b.x[j];
      const float dy = a.y[i] - b.y[j];
      const float square = kLeast + dx * dx + dy * dy +
                           kSlant * 0.5F * (1.0001F - a.cosine[i] * b.cosine[j] - a.sine[i] * b.sine[j]);
      row[j] = marked(square, static_cast<std::uint32_t>(j));
      const float from_model = marked(square, static_cast<std::uint32_t>(i));
      found.of_model[j] = from_model < found.of_model[j] ? from_model : found.of_model[j];
    }
    std::array<float, 8> least;
    std::copy_n(row.begin(), least.size(), least.begin());
    for (std::size_t j = least.size(); j < kInkPoints; j += least.size())
      for (std::size_t k = 0; k < least.size(); ++k) least[k] = row[j + k] < least[k] ? row[j + k] : least[k];
    found.of_drawn[i] = *std::min_element(least.begin(), least.end());
  }
}

float truncated(float square) {
  constexpr float kMost = 0.16F;  // ink farther away has none that belongs to it
  return std::min(square, kMost) / kMost;
}

/// Sums for the least squares of u = a x + b y + c.
struct Sums {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0, u = 0, ux = 0, uy = 0, v = 0, vx = 0, vy = 0;

  void add(float px, float py, float pu, float pv, float weight) {
    const double w = weight;
    const double dx = px, dy = py, du = pu - px, dv = pv - py;
    n += w, x += w * dx, y += w * dy, xx += w * dx * dx, xy += w * dx * dy, yy += w * dy * dy;
    u += w * du, ux += w * du * dx, uy += w * du * dy, v += w * dv, vx += w * dv * dx, vy += w * dv * dy;
  }
};

/// Moves the points by the affine map that brings them nearest to their partners; it is held back.
void fit(InkPoints& a, const InkPoints& b, const Nearest& found) {
  Sums s;
  const auto add = [&](std::size_t i, std::size_t j, float square) {
    s.add(a.x[i], a.y[i], b.x[j], b.y[j], 1 - truncated(square));
  };
  for (std::size_t k = 0; k < kInkPoints; ++k) {
    add(k, index_in(found.of_drawn[k]), found.of_drawn[k]);
    add(index_in(found.of_model[k]), k, found.of_model[k]);
  }
  if (s.n < 1) return;
  constexpr double kHeld = 25;  // points that speak for no change
  const double mx = s.x / s.n, my = s.y / s.n, mu = s.u / s.n, mv = s.v / s.n;
  const double xx = s.xx - s.n * mx * mx + kHeld;
  const double yy = s.yy - s.n * my * my + kHeld;
  const double xy = s.xy - s.n * mx * my;
  const double det = xx * yy - xy * xy;
  const double ux = s.ux - s.n * mu * mx, uy = s.uy - s.n * mu * my;
  const double vx = s.vx - s.n * mv * mx, vy = s.vy - s.n * mv * my;
  const auto p = static_cast<float>((ux * yy - uy * xy) / det);
  const auto q = static_cast<float>((uy * xx - ux * xy) / det);
  const auto r = static_cast<float>((vx * yy - vy * xy) / det);
  const auto t = static_cast<float>((vy * xx - vx * xy) / det);
  const auto cx = static_cast<float>(mu - static_cast<double>(p) * mx - static_cast<double>(q) * my);
  const auto cy = static_cast<float>(mv - static_cast<double>(r) * mx - static_cast<double>(t) * my);
  for (std::size_t k = 0; k < kInkPoints; ++k) {
    const float x = a.x[k];
    const float y = a.y[k];
    a.x[k] = x + p * x + q * y + cx;
    a.y[k] = y + r * x + t * y + cy;
  }
}

}  // namespace

InkPoints ink_points(std::span<const FlatLine> strokes) {
  InkPoints result;
  float ink = 0;
  for (const auto& s : strokes)
    for (std::size_t i = 2; i + 1 < s.size(); i += 2) ink += std::hypot(s[i] - s[i - 2], s[i + 1] - s[i - 1]);
  if (ink <= 0) return result;
  const float step = ink / static_cast<float>(kInkPoints);
  float next = step / 2;
  float passed = 0;
  std::size_t count = 0;
  for (const auto& s : strokes)
    for (std::size_t i = 2; i + 1 < s.size(); i += 2) {
      const float dx = s[i] - s[i - 2];
      const float dy = s[i + 1] - s[i - 1];
      const float length = std::hypot(dx, dy);
      for (; next <= passed + length && length > 0 && count < kInkPoints; next += step, ++count) {
        const float t = (next - passed) / length;
        result.x[count] = s[i - 2] + t * dx;
        result.y[count] = s[i - 1] + t * dy;
        result.cosine[count] = (dx * dx - dy * dy) / (length * length);
        result.sine[count] = 2 * dx * dy / (length * length);
      }
      passed += length;
    }
  for (; count > 0 && count < kInkPoints; ++count) {
    result.x[count] = result.x[count - 1];
    result.y[count] = result.y[count - 1];
    result.cosine[count] = result.cosine[count - 1];
    result.sine[count] = result.sine[count - 1];
  }
  float mx = 0;
  float my = 0;
  for (std::size_t k = 0; k < kInkPoints; ++k) {
    mx += result.x[k] / kInkPoints;
    my += result.y[k] / kInkPoints;
  }
  float square = 0;
  for (std::size_t k = 0; k < kInkPoints; ++k) {
    result.x[k] -= mx;
    result.y[k] -= my;
    square += (result.x[k] * result.x[k] + result.y[k] * result.y[k]) / kInkPoints;
  }
  const float scale = 1 / std::sqrt(std::max(square, 1e-12F));
  for (std::size_t k = 0; k < kInkPoints; ++k) {
    result.x[k] *= scale;
    result.y[k] *= scale;
  }
  return result;
}

InkDistance ink_distance(const InkPoints& drawn, const InkPoints& model) {
  constexpr int kRounds = 4;
  InkPoints moved = drawn;
  Nearest found;
  InkDistance least{1, 1};
  for (int round = 0;; ++round) {
    find_nearest(moved, model, found);
    InkDistance now;
    for (std::size_t k = 0; k < kInkPoints; ++k) {
      now.drawn += truncated(found.of_drawn[k]) / kInkPoints;
      now.model += truncated(found.of_model[k]) / kInkPoints;
    }
    if (now.drawn + now.model < least.drawn + least.model) least = now;
    if (round == kRounds) return least;
    fit(moved, model, found);
  }
}

}  // namespace nazori::writing
