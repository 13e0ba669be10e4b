// SPDX-License-Identifier: Apache-2.0
#include "tracing_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nazori::cli {
namespace {

using haptics::Vec3;

constexpr double kTravel_s = 0.30;  // over to the next stroke
constexpr double kLower_s = 0.20;
constexpr double kLift_s = 0.15;
constexpr double kHalt_s = 0.15;      // at a sharp turn and at the end
constexpr double kShortest_s = 0.20;  // even a dot takes a moment
constexpr double kLightest = 0.25;    // of the pressing, where a groove has risen to nothing
constexpr double kTurnWindow_m = 0.0015;
constexpr double kSharpTurn = 50 * std::numbers::pi / 180;

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

/// Angle between two directions seen from above, 0..pi; 0 where one has no length.
double angle(const Vec3& a, const Vec3& b) {
  return std::abs(std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y));
}

}  // namespace

TracingPlan::TracingPlan(const std::vector<haptics::StrokePath>& strokes, const Habits& habits)
    : habits_(habits) {
  int pieces = 0;
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
    stroke.first_piece = pieces;
    double from_m = 0;
    std::vector<double> ends = sharp_turns(stroke);
    ends.push_back(stroke.length_m);
    for (const double to_m : ends) {
      // Easing in and out makes the middle faster than the mean.
      const double moving_s = std::max(kShortest_s, 1.5 * (to_m - from_m) / habits.speed_m_s);
      stroke.pieces.push_back({from_m, to_m, stroke.tracing_s, moving_s});
      stroke.tracing_s += moving_s + kHalt_s;
      from_m = to_m;
      ++pieces;
    }
    duration_s_ += kTravel_s + kLower_s + stroke.tracing_s + kLift_s;
    strokes_.push_back(std::move(stroke));
  }
}

TracingPlan::Place TracingPlan::place(const Stroke& stroke, double arc_m) {
  const auto next = std::upper_bound(stroke.arc_m.begin(), stroke.arc_m.end(), arc_m);
  const std::size_t to =
      std::min(static_cast<std::size_t>(next - stroke.arc_m.begin()), stroke.points.size() - 1);
  const std::size_t from = to > 0 ? to - 1 : 0;
  const double gap = stroke.arc_m[to] - stroke.arc_m[from];
  const Vec3& a = stroke.points[from];
  const Vec3& b = stroke.points[to];
  if (gap <= 0) return {b, Vec3(0)};
  return {between(a, b, std::min(1.0, (arc_m - stroke.arc_m[from]) / gap)),
          Vec3{(b.x - a.x) / gap, (b.y - a.y) / gap, 0}};
}

std::vector<double> TracingPlan::sharp_turns(const Stroke& stroke) {
  std::vector<double> turns;
  double sharpest = 0;
  for (const double arc : stroke.arc_m) {
    if (arc < kTurnWindow_m || arc > stroke.length_m - kTurnWindow_m) continue;
    const Vec3 here = place(stroke, arc).point_m;
    const double turn = angle(here - place(stroke, arc - kTurnWindow_m).point_m,
                              place(stroke, arc + kTurnWindow_m).point_m - here);
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

Vec3 TracingPlan::aim(const Stroke& stroke, const Place& place, double arc_m, int number,
                      double time_s) const {
  // Sure at the start of a stroke, straying once under way.
  const double aside = std::min(1.0, arc_m / 0.005) * habits_.wander_m * straying(time_s, number);
  Vec3 at = place.point_m + Vec3{-place.along.y, place.along.x, 0} * aside;
  // The hand lifts with the groove where a taper or a kick rises.
  const double deep = stroke.deepest_m > 0 ? std::clamp(-at.z / stroke.deepest_m, 0.0, 1.0) : 1.0;
  at.z -= habits_.press_m * (kLightest + (1 - kLightest) * deep);
  return at;
}

Intent TracingPlan::tracing(const Stroke& stroke, double since_s, int number, double time_s) const {
  auto piece = stroke.pieces.begin();
  while (piece + 1 != stroke.pieces.end() && (piece + 1)->begin_s <= since_s) ++piece;
  const double arc_m =
      piece->from_m + (piece->to_m - piece->from_m) * ease((since_s - piece->begin_s) / piece->moving_s);
  const Place here = place(stroke, arc_m);
  Intent intent;
  intent.target_m = aim(stroke, here, arc_m, number, time_s);
  intent.line_m = here.point_m;
  // Where a piece ends the hand still looks along it, not round the corner.
  intent.along =
      place(stroke, std::clamp(arc_m, piece->from_m, std::max(piece->from_m, piece->to_m - 1e-9))).along;
  intent.piece = stroke.first_piece + static_cast<int>(piece - stroke.pieces.begin());
  intent.stroke = number;
  intent.next = number;
  return intent;
}

Intent TracingPlan::at(double time_s) const {
  Intent intent;
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
  const Vec3 start = aim(*now, place(*now, 0), 0, number, now->begin_s);
  if (t < kTravel_s) {
    const Vec3 from = now == strokes_.begin() ? rest : over((now - 1)->points.back());
    intent.target_m = between(from, over(start), ease(t / kTravel_s));
    return intent;
  }
  t -= kTravel_s;
  if (t < kLower_s) {
    intent.target_m = between(over(start), start, ease(t / kLower_s));
    return intent;
  }
  t -= kLower_s;
  if (t < now->tracing_s) return tracing(*now, t, number, time_s);
  t -= now->tracing_s;
  const Vec3 end = aim(*now, place(*now, now->length_m), now->length_m, number, time_s);
  intent.target_m = between(end, over(now->points.back()), ease(t / kLift_s));
  return intent;
}

}  // namespace nazori::cli
