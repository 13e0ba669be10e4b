// SPDX-License-Identifier: Apache-2.0
// How a point is followed along a line. Nothing here allocates, locks or throws, so the servo may use it.
//
// Three questions, one answer each:
// - where on the whole line is the nearest place? nearest_point() of polyline.h;
// - where in a stretch of it, for a line that may only be followed forwards? nearest_point_between() there;
// - where near the place of last time, so that a line that comes back near itself is not jumped over to?
//   walk_to_nearest() here.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

#include "nazori/geometry/point.h"

namespace nazori::geometry {

/// A location on a line of straight segments.
struct LinePlace {
  std::size_t segment = 0;  ///< index of the point at which the segment begins
  double share = 0;         ///< 0 at that point, 1 at the next
};

/// Arc lengths of a line at each of its points, from 0 at the first.
/// @param distance  measures two neighbouring points, for example as seen from above.
template <class Point, class Distance>
[[nodiscard]] std::vector<double> arc_lengths(std::span<const Point> line, Distance distance) {
  std::vector<double> along(line.size(), 0.0);
  for (std::size_t i = 1; i < line.size(); ++i) along[i] = along[i - 1] + distance(line[i - 1], line[i]);
  return along;
}

/// Arc lengths of a line in a plane at each of its points, from 0 at the first.
template <class Frame>
[[nodiscard]] std::vector<double> arc_lengths(std::span<const Point2<Frame>> line) {
  return arc_lengths(line, [](Point2<Frame> a, Point2<Frame> b) { return distance(a, b); });
}

/// The location at an arc length, which is limited to the length of the line. At a point of the line, the
/// segment is the one that begins there; at the last point, the one that ends there. O(log points).
/// @param along  arc lengths at the points of the line, as arc_lengths() gives them; at least one.
/// @return the segment 0 with the share 0 for a line of one point.
[[nodiscard]] inline LinePlace place_at(std::span<const double> along, double arc) noexcept {
  assert(!along.empty());
  if (along.size() < 2) return {};
  const auto after = std::upper_bound(along.begin(), along.end(), arc) - along.begin();
  const std::size_t next = std::clamp<std::size_t>(static_cast<std::size_t>(after), 1, along.size() - 1);
  const double length = along[next] - along[next - 1];
  return {next - 1, length > 0 ? std::clamp((arc - along[next - 1]) / length, 0.0, 1.0) : 1.0};
}

/// The point at a location on a line. @param line  at least one point, of any type with +, - and * a number.
template <class Point>
[[nodiscard]] Point point_on(std::span<const Point> line, LinePlace place) {
  assert(!line.empty());
  if (line.size() < 2) return line[0];
  const Point& from = line[place.segment];
  return from + (line[place.segment + 1] - from) * place.share;
}

/// How far the search goes on over segments that are not nearer before it ends.
struct LookPast {
  int segments = 2;   ///< as many at least
  double length = 0;  ///< and as many as have less than this total length
};

/// Follows a point along a line: searches from the segment where it was, in both directions, for the nearest
/// segment. The search ends where segments no longer become nearer, so that it does not jump to another part
/// of a line that comes back near itself. `past` says how far it looks beyond such segments, so that a point
/// that cuts a sharp corner reaches the other leg.
/// @param segment  where the point was.  @param first,last  segments of the line, `segment` among them.
/// @param nearer  called with the number of a segment: measures the distance to it, stores it and returns
///   whether it is the shortest so far.  @param length  of the segment with a number.
template <class Number, class Nearer, class Length>
void walk_to_nearest(Number segment, Number first, Number last, const LookPast& past, Nearer nearer,
                     Length length) {
  (void)nearer(segment);
  for (const int way : {1, -1}) {
    int farther = 0;
    double farther_length = 0;
    for (Number i = segment + way;
         i >= first && i <= last && (farther < past.segments || farther_length < past.length); i += way) {
      const bool is_nearer = nearer(i);
      farther = is_nearer ? 0 : farther + 1;
      farther_length = is_nearer ? 0 : farther_length + length(i);
    }
  }
}

}  // namespace nazori::geometry
