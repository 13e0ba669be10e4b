// SPDX-License-Identifier: Apache-2.0
// What makes a GuidancePlan; what the servo asks it is in guidance_query.cpp.
#include "guidance_plan.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "nazori/geometry/polyline.h"

namespace nazori::haptics {
namespace {

constexpr double kSame_m = 1e-7;         // nearer than this, seen from above, two points are one
constexpr double kStep_m = 0.001;        // from speed to speed
constexpr double kMostSpeeds = 100'000;  // a file may hold a stroke a kilometre long

}  // namespace

GuidancePlan::GuidancePlan(std::span<const StrokePath> strokes, double speed_m_s) {
  std::vector<StrokePath> flat(strokes.size());
  double total = 0;
  for (std::size_t n = 0; n < strokes.size(); ++n) {
    std::vector<double> z;
    for (const Vec3& p : strokes[n].points) {
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) continue;
      const Vec3 q{p.x, p.y, 0};
      if (!flat[n].points.empty() && glm::length(q - flat[n].points.back()) <= kSame_m) continue;
      if (!flat[n].points.empty()) total += glm::length(q - flat[n].points.back());
      flat[n].points.push_back(q);
      z.push_back(std::min(0.0, p.z));
    }
    if (z.size() == 1) depths_m_.push_back({z[0], z[0]});
    for (std::size_t i = 0; i + 1 < z.size(); ++i) depths_m_.push_back({z[i], z[i + 1]});
  }
  lines_ = StrokeIndex(flat, 0);
  const double most_step = std::max(kStep_m, total / kMostSpeeds);
  for (std::int32_t n = 1; n <= static_cast<std::int32_t>(strokes.size()); ++n) {
    const StrokeIndex::Hit start = lines_.at_length(n, 0);
    paces_.push_back(start.segment < 0
                         ? geometry::StrokePace()
                         : pace_of(n, lines_.stroke_length_m(start.segment), speed_m_s, most_step));
  }
}

geometry::StrokePace GuidancePlan::pace_of(std::int32_t stroke, double length_m, double speed_m_s,
                                           double most_step_m) const {
  const auto count = static_cast<std::size_t>(std::ceil(length_m / most_step_m)) + 1;
  const double step = count > 1 ? length_m / static_cast<double>(count - 1) : 0;
  std::vector<double> squared(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double s = std::min(length_m, step * static_cast<double>(i));
    const double w = std::min({kWindow_m, s, length_m - s});
    double part = 1;  // share of the speed that the bend allows
    if (w > kSame_m) {
      const Vec3 at = lines_.at_length(stroke, s).point;
      const Vec3 before = at - lines_.at_length(stroke, s - w).point;
      const Vec3 after = lines_.at_length(stroke, s + w).point - at;
      const double turn = geometry::angle_between(geometry::TabletPoint{before.x, before.y},
                                                  geometry::TabletPoint{after.x, after.y});
      const double radius = turn > 1e-9 ? w / turn : 1e9;
      part = std::cbrt(radius / (radius + kBend_m));
    }
    squared[i] = std::pow(speed_m_s * std::max(kSlowest, part), 2);
  }
  const double slowest = std::pow(kSlowest * speed_m_s, 2);
  squared.front() = squared.back() = slowest;
  const double gain = 2 * kAcceleration * step;
  for (std::size_t i = 1; i < count; ++i) squared[i] = std::min(squared[i], squared[i - 1] + gain);
  for (std::size_t i = count - 1; i-- > 0;) squared[i] = std::min(squared[i], squared[i + 1] + gain);
  geometry::StrokePace pace;
  if (count == 1) pace.move(0, std::sqrt(slowest));
  for (std::size_t i = 1; i < count; ++i) {
    const double to = i + 1 < count ? step * static_cast<double>(i) : length_m;
    pace.move(to, std::sqrt(squared[i - 1]), std::sqrt(squared[i]));
  }
  return pace;
}

}  // namespace nazori::haptics
