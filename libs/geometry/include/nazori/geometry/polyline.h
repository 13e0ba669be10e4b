// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "nazori/geometry/point.h"

namespace nazori::geometry {

/// The point of a polyline that is closest to a given point.
template <class Frame>
struct NearestPoint {
  Point2<Frame> point;
  double distance = std::numeric_limits<double>::infinity();
  double arc_length = 0;    ///< from the first point of the polyline to `point`, along it
  std::size_t segment = 0;  ///< index of the first point of the segment that contains `point`
};

/// Sum of the lengths of all segments. 0 for fewer than two points.
template <class Frame>
[[nodiscard]] double arc_length(std::span<const Point2<Frame>> line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += distance(line[i - 1], line[i]);
  return sum;
}

/// Angle between two directions, 0..pi; 0 where one of them has no length.
template <class Frame>
[[nodiscard]] double angle_between(Point2<Frame> a, Point2<Frame> b) {
  return std::abs(std::atan2(a.x * b.y - a.y * b.x, dot(a, b)));
}

/// The share of the segment from `from` to `to`, 0..1, at which it comes closest to `p`; 0 where the segment
/// has no length.
/// @param p,from,to  of any type with +, -, * a number and dot(), in the plane or in space.
template <class Point>
[[nodiscard]] double nearest_share(const Point& p, const Point& from, const Point& to) {
  const Point along = to - from;
  const double squared = dot(along, along);
  return squared > 0 ? std::clamp(dot(p - from, along) / squared, 0.0, 1.0) : 0.0;
}

/// Distance of `p` from the segment from `from` to `to`. @param p,from,to  as nearest_share(), with
/// distance().
template <class Point>
[[nodiscard]] double distance_to_segment(const Point& p, const Point& from, const Point& to) {
  return distance(from + (to - from) * nearest_share(p, from, to), p);
}

/// Closest point of a polyline to `p`; of several at the same distance the first. One point counts as a
/// segment of length 0.
/// @param line  at least one point.
template <class Frame>
[[nodiscard]] NearestPoint<Frame> nearest_point(std::span<const Point2<Frame>> line, Point2<Frame> p) {
  assert(!line.empty());
  NearestPoint<Frame> best{line[0], distance(line[0], p), 0, 0};
  double before = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const auto along = line[i + 1] - line[i];
    const double t = nearest_share(p, line[i], line[i + 1]);
    const auto candidate = line[i] + along * t;
    const double d = distance(candidate, p);
    const double segment = std::sqrt(dot(along, along));
    if (d < best.distance) best = {candidate, d, before + t * segment, i};
    before += segment;
  }
  return best;
}

/// As `nearest_point`, for the part of the polyline between two arc lengths.
/// @param line  at least one point.  @param from,to  arc lengths from the first point, `from` not after `to`;
///   both are limited to 0..the length.
template <class Frame>
[[nodiscard]] NearestPoint<Frame> nearest_point_between(std::span<const Point2<Frame>> line, Point2<Frame> p,
                                                        double from, double to) {
  assert(!line.empty() && from <= to);
  NearestPoint<Frame> best;
  double before = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const auto along = line[i + 1] - line[i];
    const double segment = std::sqrt(dot(along, along));
    if (segment > 0 && before + segment >= from) {
      const double begin = std::clamp((from - before) / segment, 0.0, 1.0);
      const double end = std::clamp((to - before) / segment, begin, 1.0);
      const double t = std::clamp(dot(p - line[i], along) / (segment * segment), begin, end);
      const auto candidate = line[i] + along * t;
      const double d = distance(candidate, p);
      if (d < best.distance) best = {candidate, d, before + t * segment, i};
    }
    before += segment;
    if (before > to) break;
  }
  if (best.distance == std::numeric_limits<double>::infinity())
    best = {line.back(), distance(line.back(), p), before, line.size() < 2 ? 0 : line.size() - 2};
  return best;
}

/// The point at `s` along the polyline; s is limited to 0..the length.
/// @param line  at least one point.
template <class Frame>
[[nodiscard]] Point2<Frame> point_at(std::span<const Point2<Frame>> line, double s) {
  assert(!line.empty());
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double segment = distance(line[i], line[i + 1]);
    if (s <= segment)
      return segment > 0 ? line[i] + (line[i + 1] - line[i]) * (std::max(s, 0.0) / segment) : line[i];
    s -= segment;
  }
  return line.back();
}

/// The polyline resampled: `count` points at equal distances along it, its first and last point among them.
/// @param line  at least one point.  @param count  at least 2.
template <class Frame>
[[nodiscard]] Polyline<Frame> resample(std::span<const Point2<Frame>> line, std::size_t count) {
  assert(!line.empty() && count >= 2);
  Polyline<Frame> out;
  out.reserve(count);
  const double step = arc_length(line) / static_cast<double>(count - 1);
  std::size_t i = 0;
  double before = 0;
  for (std::size_t k = 0; k + 1 < count; ++k) {
    const double s = step * static_cast<double>(k);
    while (i + 2 < line.size() && before + distance(line[i], line[i + 1]) < s) {
      before += distance(line[i], line[i + 1]);
      ++i;
    }
    const double segment = i + 1 < line.size() ? distance(line[i], line[i + 1]) : 0;
    out.push_back(segment > 0 ? line[i] + (line[i + 1] - line[i]) * std::min((s - before) / segment, 1.0)
                              : line[i]);
  }
  out.push_back(line.back());
  return out;
}

}  // namespace nazori::geometry
