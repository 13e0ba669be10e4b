// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "nazori/geometry/polyline.h"

namespace nazori::geometry {

/// Which points of a line are needed so that it stays within `tolerance` of all of them; the first and the
/// last always are.
/// @param line  of points of any type that distance_to_segment() takes.
/// @param tolerance  at least 0, in the unit of the points.
/// @return indices, ascending. Thread-safe: yes.
/// @source Douglas and Peucker, 1973.
template <class Point>
[[nodiscard]] std::vector<std::size_t> needed_points(std::span<const Point> line, double tolerance) {
  if (line.empty()) return {};
  std::vector<bool> needed(line.size(), false);
  needed.front() = needed.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, line.size() - 1}};
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    double farthest = tolerance;
    std::size_t at = from;
    for (std::size_t i = from + 1; i < to; ++i) {
      const double away = distance_to_segment(line[i], line[from], line[to]);
      if (!(away > farthest)) continue;  // what is no number is not far
      farthest = away;
      at = i;
    }
    if (at == from) continue;
    needed[at] = true;
    open.emplace_back(from, at);
    open.emplace_back(at, to);
  }
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < line.size(); ++i)
    if (needed[i]) kept.push_back(i);
  return kept;
}

}  // namespace nazori::geometry
