// SPDX-License-Identifier: Apache-2.0
#include "convex_outline.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace nazori::scan {
namespace {

/// Positive where the way from a over b to c turns clockwise, as it is seen.
double turn(PhotoPoint a, PhotoPoint b, PhotoPoint c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Where the sides before and after the side from `b` to `c` meet without it.
std::optional<PhotoPoint> meeting(PhotoPoint a, PhotoPoint b, PhotoPoint c, PhotoPoint d) {
  const double ux = b.x - a.x, uy = b.y - a.y;
  const double vx = c.x - d.x, vy = c.y - d.y;
  const double across = ux * vy - uy * vx;
  if (across >= 0) return std::nullopt;
  const double along = ((c.x - b.x) * vy - (c.y - b.y) * vx) / across;
  return PhotoPoint{b.x + along * ux, b.y + along * uy};
}

}  // namespace

ConvexOutline outline_of(const std::vector<Pixel>& pixels) {
  std::vector<PhotoPoint> points;
  points.reserve(pixels.size());
  for (const auto [x, y] : pixels) points.push_back({static_cast<double>(x), static_cast<double>(y)});
  std::sort(points.begin(), points.end(),
            [](PhotoPoint a, PhotoPoint b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  ConvexOutline outline;
  // The upper side from the left, then the lower side from the right.
  for (int side = 0; side < 2; ++side) {
    const std::size_t first = outline.size();
    for (const PhotoPoint p : points) {
      while (outline.size() >= first + 2 && turn(outline[outline.size() - 2], outline.back(), p) <= 0)
        outline.pop_back();
      outline.push_back(p);
    }
    outline.pop_back();
    std::reverse(points.begin(), points.end());
  }
  if (outline.empty()) outline.push_back(points.front());
  return outline;
}

double area_of(const ConvexOutline& outline) {
  double twice = 0;
  for (std::size_t i = 2; i < outline.size(); ++i) twice += turn(outline[0], outline[i - 1], outline[i]);
  return twice / 2;
}

std::optional<std::array<PhotoPoint, 4>> quadrilateral_in(const ConvexOutline& outline, double share) {
  ConvexOutline sides = outline;
  const double area = area_of(outline);
  // The side goes without which the outline becomes least larger.
  while (sides.size() > 4) {
    const std::size_t n = sides.size();
    double least = std::numeric_limits<double>::infinity();
    std::size_t gone = 0;
    PhotoPoint corner;
    for (std::size_t i = 0; i < n; ++i) {
      const PhotoPoint b = sides[i], c = sides[(i + 1) % n];
      const auto met = meeting(sides[(i + n - 1) % n], b, c, sides[(i + 2) % n]);
      if (!met) continue;
      const double more = turn(b, *met, c) / 2;
      if (more >= least) continue;
      least = more;
      gone = i;
      corner = *met;
    }
    if (area + least > 2 * area) return std::nullopt;
    sides[gone] = corner;
    sides.erase(sides.begin() + static_cast<std::ptrdiff_t>(gone + 1 < n ? gone + 1 : 0));
  }
  if (sides.size() != 4 || area < share * area_of(sides)) return std::nullopt;
  const auto upper_left = std::min_element(sides.begin(), sides.end(),
                                           [](PhotoPoint a, PhotoPoint b) { return a.x + a.y < b.x + b.y; });
  std::rotate(sides.begin(), upper_left, sides.end());
  return std::array<PhotoPoint, 4>{sides[0], sides[1], sides[2], sides[3]};
}

std::vector<RowInside> rows_inside(const ConvexOutline& outline, int width, int height) {
  std::vector<RowInside> rows;
  for (int row = 0; row < height; ++row) {
    double first = std::numeric_limits<double>::infinity();
    double last = -first;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const PhotoPoint a = outline[i], b = outline[(i + 1) % outline.size()];
      if (std::min(a.y, b.y) > row || std::max(a.y, b.y) < row) continue;
      const double part = a.y == b.y ? 0 : (row - a.y) / (b.y - a.y);
      for (const double x : {a.x + part * (b.x - a.x), a.y == b.y ? b.x : a.x + part * (b.x - a.x)}) {
        first = std::min(first, x);
        last = std::max(last, x);
      }
    }
    if (first > last) continue;
    const int from = std::max(0, static_cast<int>(std::ceil(std::max(first, -1.0))));
    const int to =
        std::min(width - 1, static_cast<int>(std::floor(std::min(last, static_cast<double>(width)))));
    if (from <= to) rows.push_back({row, from, to});
  }
  return rows;
}

}  // namespace nazori::scan
