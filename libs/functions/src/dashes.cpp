// SPDX-License-Identifier: Apache-2.0
#include "dashes.h"

#include <algorithm>
#include <cmath>

namespace nazori::functions {

void add_dashes(DistanceGrid& grid, const Branch& branch, std::span<const double> lengths) {
  std::size_t part = 0;
  double left = lengths[0];
  const std::size_t count = branch.points.size();
  for (std::size_t i = 0; i + 1 < count + (branch.closed ? 1 : 0); ++i) {
    const CurvePoint& a = branch.points[i];
    const CurvePoint& b = branch.points[(i + 1) % count];
    const double length = std::hypot(b.u - a.u, b.v - a.v);
    for (double from = 0; from < length;) {
      const double step = std::min(length - from, left);
      const auto at = [&](double s) {
        return PlatePoint{a.u + (b.u - a.u) * s / length, a.v + (b.v - a.v) * s / length};
      };
      if (part % 2 == 0) grid.add_segment(at(from), at(from + step), branch.statement);
      from += step;
      left -= step;
      if (left > 0) continue;
      part = (part + 1) % lengths.size();
      left = lengths[part];
    }
  }
}

std::vector<std::uint8_t> regions_of(const Tracing& tracing, int size) {
  std::vector<std::uint8_t> inside;
  if (tracing.fills.empty()) return inside;
  inside.assign(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), 0);
  const double n = size;
  for (const Fill& f : tracing.fills) {
    const int left = std::max(0, static_cast<int>(std::ceil(f.low.u * n - 0.5)));
    const int right = std::min(size - 1, static_cast<int>(std::floor(f.high.u * n - 0.5)));
    const int top = std::max(0, static_cast<int>(std::ceil((1 - f.high.v) * n - 0.5)));
    const int bottom = std::min(size - 1, static_cast<int>(std::floor((1 - f.low.v) * n - 0.5)));
    for (int row = top; row <= bottom; ++row) {
      const std::size_t base = static_cast<std::size_t>(row) * static_cast<std::size_t>(size);
      for (int column = left; column <= right; ++column)
        inside[base + static_cast<std::size_t>(column)] = static_cast<std::uint8_t>(f.statement + 1);
    }
  }
  return inside;
}

}  // namespace nazori::functions
