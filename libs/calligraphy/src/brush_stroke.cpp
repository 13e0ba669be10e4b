// SPDX-License-Identifier: Apache-2.0
#include "nazori/calligraphy/brush_stroke.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "nazori/geometry/point.h"

namespace nazori::calligraphy {
namespace {

constexpr double kLeast_m = 2e-5;  // shorter moves have no direction

}  // namespace

void add_point(BrushStroke& stroke, const brush::PenSample& sample,
               std::span<const geometry::BristleSegment> swept, bool guesses) {
  if (swept.empty()) return;
  BrushPoint point;
  point.time_s = sample.time_s;
  point.pen = point.at = sample.at;
  point.pressure = sample.pressure;
  point.lean_rad = sample.lean_rad;
  point.lean_to_rad = sample.lean_to_rad;
  point.width_from = sample.pressure || sample.height_m ? WidthFrom::hand
                     : guesses                          ? WidthFrom::speed
                                                        : WidthFrom::nothing;
  // Across the way of the pen; where it rests, across the way before.
  geometry::PaperPoint way{1, 0};
  double length = 0;
  for (auto before = stroke.rbegin(); before != stroke.rend() && length < kLeast_m; ++before) {
    way = sample.at - before->pen;
    length = geometry::length(way);
  }
  const bool has_way = length >= kLeast_m;
  if (!has_way) {
    way = {0, 0};
    for (const auto& band : swept) way = way + (band.to - band.from);
    length = geometry::length(way);
    if (length < kLeast_m) {
      way = {1, 0};
      length = 1;
    }
  }
  const geometry::PaperPoint across{-way.y / length, way.x / length};
  const geometry::PaperPoint along{way.x / length, way.y / length};
  // The hair lies over a part of the way. Its width is that of the section nearest to the pen, because hair
  // that was just set down points to the side.
  constexpr double kSection_m = 0.001;
  const auto off = [&](const geometry::BristleSegment& band) {
    return std::abs(geometry::dot(band.to - sample.at, along));
  };
  double nearest = off(swept.front());
  for (const auto& band : swept) nearest = std::min(nearest, off(band));
  double low = 0, high = 0;
  bool first = true;
  for (const auto& band : swept) {
    if (off(band) > nearest + kSection_m) continue;
    const double at = geometry::dot(band.to - sample.at, across);
    low = first ? at - band.width_m / 2 : std::min(low, at - band.width_m / 2);
    high = first ? at + band.width_m / 2 : std::max(high, at + band.width_m / 2);
    first = false;
  }
  point.half_width_m = (high - low) / 2;
  point.at = sample.at + across * ((high + low) / 2);
  stroke.push_back(point);
}

WidthFrom width_from(const BrushStroke& stroke) {
  std::array<std::ptrdiff_t, 3> points{};
  for (const BrushPoint& point : stroke) ++points[static_cast<std::size_t>(point.width_from)];
  return static_cast<WidthFrom>(std::max_element(points.begin(), points.end()) - points.begin());
}

ModelStroke shape_of(const BrushStroke& stroke) {
  ModelStroke shape;
  for (const BrushPoint& point : stroke) {
    shape.points.push_back(point.at);
    shape.half_width_m.push_back(point.half_width_m);
  }
  return shape;
}

}  // namespace nazori::calligraphy
