// SPDX-License-Identifier: Apache-2.0
#include "tracing_plan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace nazori::cli {
namespace {

using haptics::Vec3;

constexpr double kTravel_s = 0.30;  // over to the next stroke
constexpr double kLower_s = 0.20;
constexpr double kLift_s = 0.15;
constexpr double kLightest = 0.25;    // of the pressing, where a groove has risen to nothing
constexpr double kHalt_s = 0.12;      // at the end, before the lift
constexpr double kShortest_s = 0.25;  // even a dot takes a moment

/// From 0 to 1 with rest at both ends and no jerk there.
double ease(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * t * (10 + t * (6 * t - 15));
}

Vec3 between(const Vec3& a, const Vec3& b, double t) { return a + (b - a) * t; }

/// A hand's straying: slow waves whose periods do not fit together, different for each stroke.
double straying(double time_s, int stroke) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const double phase = 1.7 * stroke;
  return (std::sin(kTurn * 0.9 * time_s + phase) + std::sin(kTurn * 1.7 * time_s + 2.3 * phase + 1) +
          0.8 * std::sin(kTurn * 2.9 * time_s + 3.1 * phase + 2)) /
         std::sqrt((1 + 1 + 0.64) / 2);
}

}  // namespace

TracingPlan::TracingPlan(const std::vector<haptics::StrokePath>& strokes, const Habits& habits)
    : habits_(habits) {
  for (const haptics::StrokePath& path : strokes) {
    Stroke stroke;
    stroke.points = path.points.empty() ? std::vector<Vec3>{Vec3(0)} : path.points;
    for (const Vec3& p : stroke.points) {
      if (!stroke.arc_m.empty()) {
        const Vec3& before = stroke.points[stroke.arc_m.size() - 1];
        stroke.length_m += std::hypot(p.x - before.x, p.y - before.y);
      }
      stroke.arc_m.push_back(stroke.length_m);
      stroke.deepest_m = std::max(stroke.deepest_m, -p.z);
    }
    stroke.begin_s = duration_s_;
    // Easing in and out makes the middle faster than the mean.
    stroke.tracing_s = std::max(kShortest_s, 1.5 * stroke.length_m / habits.speed_m_s) + kHalt_s;
    duration_s_ += kTravel_s + kLower_s + stroke.tracing_s + kLift_s;
    strokes_.push_back(std::move(stroke));
  }
}

Vec3 TracingPlan::on_line(const Stroke& stroke, double part, int number, double time_s) const {
  const double arc = part * stroke.length_m;
  const auto next = std::upper_bound(stroke.arc_m.begin(), stroke.arc_m.end(), arc);
  const std::size_t to =
      std::min(static_cast<std::size_t>(next - stroke.arc_m.begin()), stroke.points.size() - 1);
  const std::size_t from = to > 0 ? to - 1 : 0;
  const double gap = stroke.arc_m[to] - stroke.arc_m[from];
  Vec3 at = gap > 0 ? between(stroke.points[from], stroke.points[to], (arc - stroke.arc_m[from]) / gap)
                    : stroke.points[to];
  const Vec3 along = stroke.points[to] - stroke.points[from];
  const double length = std::hypot(along.x, along.y);
  // Sure at the start of a stroke, straying once under way.
  const double unsure = std::min(1.0, arc / 0.005);
  const double aside = unsure * habits_.wander_m * straying(time_s, number);
  if (length > 0) {
    at.x += -along.y / length * aside;
    at.y += along.x / length * aside;
  }
  // The hand lifts with the groove where a taper or a kick rises.
  const double deep = stroke.deepest_m > 0 ? std::clamp(-at.z / stroke.deepest_m, 0.0, 1.0) : 1.0;
  at.z -= habits_.press_m * (kLightest + (1 - kLightest) * deep);
  return at;
}

Intent TracingPlan::at(double time_s) const {
  const Vec3 rest{0, 0, habits_.hover_m};
  if (strokes_.empty()) return {rest, 0, 0};
  time_s = std::clamp(time_s, 0.0, duration_s_);
  const auto after = std::upper_bound(strokes_.begin(), strokes_.end(), time_s,
                                      [](double t, const Stroke& stroke) { return t < stroke.begin_s; });
  const auto now = after - 1;
  const int number = static_cast<int>(now - strokes_.begin()) + 1;
  const auto over = [this](const Vec3& p) { return Vec3{p.x, p.y, habits_.hover_m}; };

  double t = time_s - now->begin_s;
  const Vec3 start = on_line(*now, 0, number, now->begin_s);
  if (t < kTravel_s) {
    const Vec3 from = now == strokes_.begin() ? rest : over((now - 1)->points.back());
    return {between(from, over(start), ease(t / kTravel_s)), 0, number};
  }
  t -= kTravel_s;
  if (t < kLower_s) return {between(over(start), start, ease(t / kLower_s)), 0, number};
  t -= kLower_s;
  if (t < now->tracing_s)
    return {on_line(*now, ease(t / (now->tracing_s - kHalt_s)), number, time_s), number, number};
  t -= now->tracing_s;
  const Vec3 end = on_line(*now, 1, number, time_s);
  return {between(end, over(now->points.back()), ease(t / kLift_s)), 0, number};
}

}  // namespace nazori::cli
