// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "centre_line.h"
#include "nazori/geometry/point.h"

namespace nazori::carving {

/// A point of the refined line.
struct Node {
  geometry::GlyphPoint at;
  double s = 0;
  bool corner = false;
  std::ptrdiff_t given = -1;  ///< index of the point that was given here
};

inline geometry::GlyphPoint unit(geometry::GlyphPoint v) {
  const double l = geometry::length(v);
  return l > 0 ? v * (1 / l) : geometry::GlyphPoint{1, 0};
}

inline double cross(geometry::GlyphPoint a, geometry::GlyphPoint b) { return a.x * b.y - a.y * b.x; }

inline double angle_between(geometry::GlyphPoint a, geometry::GlyphPoint b) {
  return std::atan2(std::abs(cross(a, b)), geometry::dot(a, b));
}

/// The smooth line through the points of a stroke, so fine that its facets do not show.
[[nodiscard]] std::vector<Node> smooth_nodes(std::span<const geometry::GlyphPoint> points, int size,
                                             Detail detail);

/// A stretch of the line over which the brush changes, and how finely it is sampled there.
struct Zone {
  double begin;
  double end;
  double step;
};

/// Adds points wherever the brush changes, so that its width is linear between two joints.
[[nodiscard]] std::vector<Node> subdivide(const std::vector<Node>& line, std::span<const Zone> zones);

}  // namespace nazori::carving
