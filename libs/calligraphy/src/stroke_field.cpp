// SPDX-License-Identifier: Apache-2.0
#include "stroke_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "nazori/geometry/polyline.h"

namespace nazori::calligraphy {
namespace {

constexpr int kRoom = 3;  // steps around the stroke

}  // namespace

StrokeField field_of(const ModelStroke& stroke, double step_m) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  double left = kFar, low = kFar, right = -kFar, high = -kFar;
  for (std::size_t i = 0; i < stroke.points.size(); ++i) {
    const auto at = stroke.points[i];
    const double r = stroke.half_width_m[i];
    left = std::min(left, at.x - r);
    right = std::max(right, at.x + r);
    low = std::min(low, at.y - r);
    high = std::max(high, at.y + r);
  }
  StrokeField field;
  field.step_m = step_m;
  const auto steps = [step_m](double way) { return static_cast<int>(std::floor(way / step_m)); };
  const int first_column = steps(left) - kRoom, first_row = steps(low) - kRoom;
  field.corner = {first_column * step_m, first_row * step_m};
  field.columns = steps(right) + 1 + kRoom - first_column + 1;
  field.rows = steps(high) + 1 + kRoom - first_row + 1;
  field.distance_m.assign(static_cast<std::size_t>(field.columns) * static_cast<std::size_t>(field.rows),
                          std::numeric_limits<float>::max());
  const auto add = [&](geometry::PaperPoint from, double r0, geometry::PaperPoint to, double r1) {
    const double room = std::max(r0, r1) + (kRoom - 1) * step_m;
    const auto column = [&](double x) {
      return std::clamp(static_cast<int>((x - field.corner.x) / step_m), 0, field.columns - 1);
    };
    const auto row = [&](double y) {
      return std::clamp(static_cast<int>((y - field.corner.y) / step_m), 0, field.rows - 1);
    };
    for (int y = row(std::min(from.y, to.y) - room); y <= row(std::max(from.y, to.y) + room); ++y)
      for (int x = column(std::min(from.x, to.x) - room); x <= column(std::max(from.x, to.x) + room); ++x) {
        const auto p = field.place(x, y);
        const double share = geometry::nearest_share(p, from, to);
        const double d = geometry::distance(p, from + (to - from) * share) - (r0 + (r1 - r0) * share);
        float& value =
            field.distance_m[static_cast<std::size_t>(y) * static_cast<std::size_t>(field.columns) +
                             static_cast<std::size_t>(x)];
        value = std::min(value, static_cast<float>(d));
      }
  };
  for (std::size_t i = 0; i + 1 < stroke.points.size(); ++i)
    add(stroke.points[i], stroke.half_width_m[i], stroke.points[i + 1], stroke.half_width_m[i + 1]);
  add(stroke.points.back(), stroke.half_width_m.back(), stroke.points.back(), stroke.half_width_m.back());
  return field;
}

}  // namespace nazori::calligraphy
