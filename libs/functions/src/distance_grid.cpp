// SPDX-License-Identifier: Apache-2.0
#include "distance_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace nazori::functions {

DistanceGrid::DistanceGrid(int size, double reach)
    : size_(size),
      reach_(reach),
      squares_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size),
               std::numeric_limits<float>::infinity()),
      statements_(squares_.size(), 0) {}

float DistanceGrid::distance(std::size_t sample) const { return std::sqrt(squares_[sample]); }

void DistanceGrid::add_segment(PlatePoint p, PlatePoint q, int statement) {
  const double n = size_;
  if (p.v > q.v) std::swap(p, q);
  if (p.v > 1 + reach_ || q.v < -reach_ || std::max(p.u, q.u) < -reach_ || std::min(p.u, q.u) > 1 + reach_)
    return;
  // Row i has its centre at v = 1 - (i + 0.5)/n.
  const double top = std::min(1.0, q.v + reach_);
  const double bottom = std::max(0.0, p.v - reach_);
  const int first_row = std::max(0, static_cast<int>(std::ceil((1 - top) * n - 0.5)));
  const int last_row = std::min(size_ - 1, static_cast<int>(std::floor((1 - bottom) * n - 0.5)));
  const double du = q.u - p.u;
  const double dv = q.v - p.v;
  const double length2 = du * du + dv * dv;
  const double inverse = length2 > 0 ? 1 / length2 : 0;
  const auto most = static_cast<float>(reach_ * reach_);
  for (int row = first_row; row <= last_row; ++row) {
    const double v = 1 - (row + 0.5) / n;
    // The part of the segment that can be near this row bounds the columns.
    double from = 0;
    double to = 1;
    if (dv > 1e-300) {
      from = std::clamp((v - reach_ - p.v) / dv, 0.0, 1.0);
      to = std::clamp((v + reach_ - p.v) / dv, 0.0, 1.0);
    }
    const double ua = p.u + from * du;
    const double ub = p.u + to * du;
    const double left = std::max(0.0, std::min(ua, ub) - reach_);
    const double right = std::min(1.0, std::max(ua, ub) + reach_);
    const int first = std::max(0, static_cast<int>(std::ceil(left * n - 0.5)));
    const int last = std::min(size_ - 1, static_cast<int>(std::floor(right * n - 0.5)));
    const std::size_t base = static_cast<std::size_t>(row) * static_cast<std::size_t>(size_);
    const double wv = v - p.v;
    for (int column = first; column <= last; ++column) {
      const double wu = (column + 0.5) / n - p.u;
      const double t = std::clamp((wu * du + wv * dv) * inverse, 0.0, 1.0);
      const double eu = wu - t * du;
      const double ev = wv - t * dv;
      const auto square = static_cast<float>(eu * eu + ev * ev);
      float& best = squares_[base + static_cast<std::size_t>(column)];
      if (square < best && square <= most) {
        best = square;
        statements_[base + static_cast<std::size_t>(column)] = static_cast<std::uint8_t>(statement + 1);
      }
    }
  }
}

void DistanceGrid::add_line(const std::vector<CurvePoint>& points, bool closed, int statement) {
  if (points.empty()) return;
  const double tolerance = 1.0 / (32.0 * size_);
  const auto at = [&](std::size_t i) { return PlatePoint{points[i].u, points[i].v}; };
  if (points.size() == 1) return add_segment(at(0), at(0), statement);
  std::size_t start = 0;
  while (start + 1 < points.size()) {
    std::size_t end = start + 1;
    // Grows the chord while every point between lies close to it.
    while (end + 1 < points.size() && end - start < 64) {
      const PlatePoint a = at(start);
      const PlatePoint b = at(end + 1);
      const double du = b.u - a.u;
      const double dv = b.v - a.v;
      const double length2 = du * du + dv * dv;
      bool fits = length2 > 0;
      for (std::size_t i = start + 1; fits && i <= end; ++i) {
        const double wu = points[i].u - a.u;
        const double wv = points[i].v - a.v;
        const double along = (wu * du + wv * dv) / length2;
        const double off = std::abs(wu * dv - wv * du);
        fits = off * off <= tolerance * tolerance * length2 && along >= 0 && along <= 1;
      }
      if (!fits) break;
      ++end;
    }
    add_segment(at(start), at(end), statement);
    start = end;
  }
  if (closed) add_segment(at(points.size() - 1), at(0), statement);
}

}  // namespace nazori::functions
