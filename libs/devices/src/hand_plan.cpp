// SPDX-License-Identifier: Apache-2.0
#include "hand_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "nazori/geometry/follow_line.h"
#include "nazori/geometry/polyline.h"

namespace nazori::devices {
namespace {

using geometry::minimum_jerk;
using haptics::Vec3;

constexpr double kTravel_s = 0.30;  // over to the next stroke
constexpr double kLower_s = 0.20;
constexpr double kLift_s = 0.15;
constexpr double kHalt_s = 0.15;      // at a sharp turn and at the end
constexpr double kShortest_s = 0.20;  // even a dot takes this long
constexpr double kLightest = 0.25;    // share of the pressure where a groove has risen to the plateau
constexpr double kTurnWindow_m = 0.0015;
constexpr double kSharpTurn = 50 * std::numbers::pi / 180;

Vec3 between(const Vec3& a, const Vec3& b, double t) { return a + (b - a) * t; }

/// The deviation of the hand: slow waves with incommensurable periods, different for each stroke.
double straying(double time_s, int stroke) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const double phase = 1.7 * stroke;
  return (std::sin(kTurn * 0.9 * time_s + phase) + std::sin(kTurn * 1.7 * time_s + 2.3 * phase + 1) +
          0.8 * std::sin(kTurn * 2.9 * time_s + 3.1 * phase + 2)) /
         std::sqrt((1 + 1 + 0.64) / 2);
}

geometry::TabletPoint from_above(const Vec3& v) { return {v.x, v.y}; }

}  // namespace

HandPlan::HandPlan(std::span<const haptics::StrokePath> strokes, const HandHabits& habits) : habits_(habits) {
  int movements = 0;
  for (const haptics::StrokePath& path : strokes) {
    Stroke stroke;
    stroke.points = path.points.empty() ? std::vector<Vec3>{Vec3(0)} : path.points;
    stroke.arc_m = geometry::arc_lengths<Vec3>(
        stroke.points, [](const Vec3& a, const Vec3& b) { return std::hypot(b.x - a.x, b.y - a.y); });
    stroke.length_m = stroke.arc_m.back();
    for (const Vec3& p : stroke.points) stroke.deepest_m = std::max(stroke.deepest_m, -p.z);
    stroke.begin_s = duration_s_;
    stroke.first_movement = movements;
    std::vector<double> ends = sharp_turns(stroke);
    ends.push_back(stroke.length_m);
    for (const double to_m : ends) {
      // A movement from rest to rest is faster in the middle than on average.
      const double way_m = to_m - stroke.pace.length();
      stroke.pace.move_from_rest_to_rest(to_m, std::max(kShortest_s, 1.5 * way_m / habits.speed_m_s));
      stroke.pace.rest(kHalt_s);
      ++movements;
    }
    duration_s_ += kTravel_s + kLower_s + stroke.pace.duration_s() + kLift_s;
    strokes_.push_back(std::move(stroke));
  }
}

HandPlan::Heading HandPlan::heading(const Stroke& stroke, double arc_m) noexcept {
  const geometry::LinePlace place = geometry::place_at(stroke.arc_m, arc_m);
  const Vec3 point = geometry::point_on<Vec3>(stroke.points, place);
  if (stroke.points.size() < 2) return {point, Vec3(0)};
  const double gap = stroke.arc_m[place.segment + 1] - stroke.arc_m[place.segment];
  if (gap <= 0) return {point, Vec3(0)};
  const Vec3 step = stroke.points[place.segment + 1] - stroke.points[place.segment];
  return {point, Vec3{step.x / gap, step.y / gap, 0}};
}

std::vector<double> HandPlan::sharp_turns(const Stroke& stroke) {
  std::vector<double> turns;
  double sharpest = 0;
  for (const double arc : stroke.arc_m) {
    if (arc < kTurnWindow_m || arc > stroke.length_m - kTurnWindow_m) continue;
    const Vec3 here = heading(stroke, arc).point_m;
    const double turn =
        geometry::angle_between(from_above(here - heading(stroke, arc - kTurnWindow_m).point_m),
                                from_above(heading(stroke, arc + kTurnWindow_m).point_m - here));
    if (turn < kSharpTurn) continue;
    if (turns.empty() || arc - turns.back() > 2 * kTurnWindow_m) {
      turns.push_back(arc);
      sharpest = turn;
    } else if (turn > sharpest) {
      turns.back() = arc;
      sharpest = turn;
    }
  }
  return turns;
}

Vec3 HandPlan::aim(const Stroke& stroke, const Heading& at, double arc_m, int number,
                   double time_s) const noexcept {
  // Accurate at the start of a stroke, deviating after it.
  const double aside = std::min(1.0, arc_m / 0.005) * habits_.wander_m * straying(time_s, number);
  Vec3 target = at.point_m + Vec3{-at.along.y, at.along.x, 0} * aside;
  // The hand rises with the groove in a sweep or a hook.
  const double deep = stroke.deepest_m > 0 ? std::clamp(-target.z / stroke.deepest_m, 0.0, 1.0) : 1.0;
  target.z -= habits_.press_m * (kLightest + (1 - kLightest) * deep);
  return target;
}

HandIntent HandPlan::following(const Stroke& stroke, double since_s, int number,
                               double time_s) const noexcept {
  const auto [arc_m, movement] = stroke.pace.at(since_s);
  const Heading here = heading(stroke, arc_m);
  HandIntent intent;
  intent.target_m = aim(stroke, here, arc_m, number, time_s);
  intent.line_m = here.point_m;
  // At the end of a movement the direction is still that of the movement, not the one after the corner.
  const double begin_m = stroke.pace.begin_of(movement);
  const double end_m = stroke.pace.end_of(movement);
  intent.along = heading(stroke, std::clamp(arc_m, begin_m, std::max(begin_m, end_m - 1e-9))).along;
  intent.movement = stroke.first_movement + static_cast<int>(movement);
  intent.stroke = number;
  intent.next = number;
  return intent;
}

HandIntent HandPlan::at(double time_s) const noexcept {
  HandIntent intent;
  const Vec3 rest{0, 0, habits_.hover_m};
  intent.target_m = rest;
  if (strokes_.empty()) return intent;
  time_s = std::clamp(time_s, 0.0, duration_s_);
  const auto after = std::upper_bound(strokes_.begin(), strokes_.end(), time_s,
                                      [](double t, const Stroke& stroke) { return t < stroke.begin_s; });
  const auto now = after - 1;
  const int number = static_cast<int>(now - strokes_.begin()) + 1;
  const auto over = [this](const Vec3& p) { return Vec3{p.x, p.y, habits_.hover_m}; };
  intent.next = number;

  double t = time_s - now->begin_s;
  const Vec3 start = aim(*now, heading(*now, 0), 0, number, now->begin_s);
  if (t < kTravel_s) {
    const Vec3 from = now == strokes_.begin() ? rest : over((now - 1)->points.back());
    intent.target_m = between(from, over(start), minimum_jerk(t / kTravel_s));
    return intent;
  }
  t -= kTravel_s;
  if (t < kLower_s) {
    intent.target_m = between(over(start), start, minimum_jerk(t / kLower_s));
    return intent;
  }
  t -= kLower_s;
  if (t < now->pace.duration_s()) return following(*now, t, number, time_s);
  t -= now->pace.duration_s();
  const Vec3 end = aim(*now, heading(*now, now->length_m), now->length_m, number, time_s);
  intent.target_m = between(end, over(now->points.back()), minimum_jerk(t / kLift_s));
  return intent;
}

}  // namespace nazori::devices
