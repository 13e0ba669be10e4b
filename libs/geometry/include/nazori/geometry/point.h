// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

namespace nazori::geometry {

/// A point or vector in the plane whose type names its frame, so that frames cannot be mixed by accident.
template <class Frame>
struct Point2 {
  double x = 0;
  double y = 0;

  friend Point2 operator+(Point2 a, Point2 b) { return {a.x + b.x, a.y + b.y}; }
  friend Point2 operator-(Point2 a, Point2 b) { return {a.x - b.x, a.y - b.y}; }
  friend Point2 operator*(Point2 a, double s) { return {a.x * s, a.y * s}; }
  friend Point2 operator*(double s, Point2 a) { return a * s; }
  friend bool operator==(Point2, Point2) = default;
};

template <class Frame>
double dot(Point2<Frame> a, Point2<Frame> b) {
  return a.x * b.x + a.y * b.y;
}
template <class Frame>
double length(Point2<Frame> a) {
  const double squared = a.x * a.x + a.y * a.y;
  // std::hypot is slow, and needed only where the squares exceed the range of doubles.
  constexpr double kLeast = 1e-290;
  constexpr double kMost = 1e290;
  return squared > kLeast && squared < kMost ? std::sqrt(squared) : std::hypot(a.x, a.y);
}
template <class Frame>
double distance(Point2<Frame> a, Point2<Frame> b) {
  return length(b - a);
}

/// The glyph frame: KanjiVG's box of 109 x 109 units, x right, y down.
struct GlyphFrame {};
/// The grid frame: samples of a height map; x = column right, y = row down, (0, 0) the sample at the top left
/// of the picture.
struct GridFrame {};
/// The plane z = 0 of the tablet frame, in metres: x right, y up, origin at the centre of the plateau.
struct TabletFrame {};

using GlyphPoint = Point2<GlyphFrame>;
using GridPoint = Point2<GridFrame>;
using TabletPoint = Point2<TabletFrame>;

/// Points joined by straight segments, in order.
template <class Frame>
using Polyline = std::vector<Point2<Frame>>;

/// Side of KanjiVG's box in glyph units. @source viewBox of KanjiVG's SVG files.
inline constexpr double kGlyphSide = 109.0;

}  // namespace nazori::geometry
