// SPDX-License-Identifier: Apache-2.0
// The questions to a StrokeIndex that the servo asks; what builds one is in stroke_index.cpp.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "nazori/geometry/follow_line.h"
#include "nazori/haptics/stroke_index.h"

namespace nazori::haptics {
namespace {

// A tip that cuts the corner of a sharp hook continues on the other side of the hook.
constexpr geometry::LookPast kLookPast{2, 0.004};

}  // namespace

void StrokeIndex::test(const Vec3& p, std::size_t i, Hit& best) const noexcept {
  const Segment& s = segments_[i];
  // As geometry::nearest_share, with the division done when the index was made, because this runs in every
  // tick.
  const double t = std::clamp(glm::dot(p - s.from, s.along) * s.per_squared, 0.0, 1.0);
  const Vec3 point = s.from + t * s.along;
  const Vec3 away = p - point;
  const double squared = glm::dot(away, away);
  if (squared < best.squared_m2) best = {point, squared, static_cast<std::int32_t>(i), t};
}

StrokeIndex::Hit StrokeIndex::nearest(const Vec3& p, double reach_m) const noexcept {
  Hit best;
  best.squared_m2 = reach_m * reach_m;
  for (const Cluster& c : clusters_) {
    const Vec3 out = glm::max(Vec3(0), glm::max(c.low - p, p - c.high));
    if (glm::dot(out, out) >= best.squared_m2) continue;
    for (std::size_t i = c.begin; i < c.end; ++i) test(p, i, best);
  }
  return best;
}

StrokeIndex::Hit StrokeIndex::follow(const Vec3& p, std::int32_t segment) const noexcept {
  Hit best;
  const Segment& s = segments_[static_cast<std::size_t>(segment)];
  const auto nearer = [&](std::int32_t i) noexcept {
    const double before = best.squared_m2;
    test(p, static_cast<std::size_t>(i), best);
    return best.squared_m2 < before;
  };
  const auto length_m = [this](std::int32_t i) noexcept {
    return segments_[static_cast<std::size_t>(i)].length_m;
  };
  geometry::walk_to_nearest(segment, s.first, s.last, kLookPast, nearer, length_m);
  return best;
}

double StrokeIndex::arc_length_m(const Hit& hit) const noexcept {
  const Segment& s = segments_[static_cast<std::size_t>(hit.segment)];
  return s.before_m + hit.along * s.length_m;
}

double StrokeIndex::stroke_length_m(std::int32_t segment) const noexcept {
  const Segment& last =
      segments_[static_cast<std::size_t>(segments_[static_cast<std::size_t>(segment)].last)];
  return last.before_m + last.length_m;
}

StrokeIndex::Hit StrokeIndex::at_length(std::int32_t stroke, double arc_m) const noexcept {
  Hit hit;
  if (stroke < 1 || static_cast<std::size_t>(stroke) > first_.size()) return hit;
  const std::int32_t first = first_[static_cast<std::size_t>(stroke) - 1];
  if (first < 0) return hit;
  std::int32_t low = first, high = segments_[static_cast<std::size_t>(first)].last;
  // As geometry::place_at, but with the lengths stored in the segments instead of an array of their own, near
  // the data that a tick reads next.
  while (low < high) {  // the last segment that begins at or before arc_m
    const std::int32_t middle = low + (high - low + 1) / 2;
    if (segments_[static_cast<std::size_t>(middle)].before_m <= arc_m)
      low = middle;
    else
      high = middle - 1;
  }
  const Segment& s = segments_[static_cast<std::size_t>(low)];
  const double t = s.length_m > 0 ? std::clamp((arc_m - s.before_m) / s.length_m, 0.0, 1.0) : 0.0;
  return {s.from + t * s.along, 0, low, t};
}

Vec3 StrokeIndex::direction(std::int32_t segment) const noexcept {
  const Segment& s = segments_[static_cast<std::size_t>(segment)];
  return s.along * std::sqrt(s.per_squared);
}

}  // namespace nazori::haptics
