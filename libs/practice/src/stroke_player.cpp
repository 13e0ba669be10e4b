// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/stroke_player.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "nazori/geometry/follow_line.h"

namespace nazori::practice {
namespace {

using haptics::Vec3;

constexpr double kPiece_m = 0.0005;
constexpr double kRamp_m = 0.007;     ///< length over which the brush gains or loses speed
constexpr double kCorner_m = 0.004;   ///< around a corner
constexpr double kSlowest = 0.22;     ///< share of the speed at a start, a corner, a stop
constexpr double kSwept = 1.15;       ///< at the end of a sweep, and in a hook
constexpr double kPress_s = 0.14;     ///< pause of the brush before it moves
constexpr double kRest_s = 0.16;      ///< pause before it is lifted, where the stroke stops
constexpr double kTravel_m_s = 0.12;  ///< in the air
constexpr double kLeastTravel_s = 0.28;

/// Points at equal distances along a path.
std::vector<Vec3> resampled(std::span<const Vec3> path) {
  std::vector<Vec3> out;
  if (path.empty()) return out;
  out.push_back(path.front());
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double length_m = glm::distance(path[i - 1], path[i]);
    const int pieces = std::max(1, static_cast<int>(std::ceil(length_m / kPiece_m)));
    for (int k = 1; k <= pieces; ++k)
      out.push_back(glm::mix(path[i - 1], path[i], static_cast<double>(k) / pieces));
  }
  return out;
}

/// How much the path turns around a point, 0 straight on .. 1 back.
double turn_at(const std::vector<Vec3>& points, std::size_t i) {
  const auto reach = static_cast<std::size_t>(kCorner_m / kPiece_m / 2);
  const std::size_t before = i > reach ? i - reach : 0;
  const std::size_t after = std::min(i + reach, points.size() - 1);
  glm::dvec2 in(points[i] - points[before]);
  glm::dvec2 on(points[after] - points[i]);
  if (glm::length(in) < 1e-9 || glm::length(on) < 1e-9) return 0;
  return (1 - glm::dot(glm::normalize(in), glm::normalize(on))) / 2;
}

}  // namespace

void StrokePlayer::set_strokes(std::span<const haptics::StrokePath> paths,
                               std::span<const tablet::TabletLine> lines) {
  strokes_.clear();
  double clock_s = kLeastTravel_s;
  for (std::size_t n = 0; n < paths.size() && n < lines.size(); ++n) {
    Timed stroke;
    stroke.points = resampled(paths[n].points);
    if (stroke.points.empty()) stroke.points.push_back(Vec3(0));
    const auto& points = stroke.points;
    stroke.along_m = geometry::arc_lengths<Vec3>(
        points, [](const Vec3& a, const Vec3& b) { return glm::length(glm::dvec2(b - a)); });
    const double length_m = stroke.along_m.back();
    const auto ending = lines[n].ending.value_or(kanji::StrokeEnding::stop);
    const bool stops = ending == kanji::StrokeEnding::stop || ending == kanji::StrokeEnding::either;
    if (n > 0) {
      const double way_m = glm::distance(strokes_.back().points.back(), points.front());
      clock_s += std::max(way_m / kTravel_m_s, kLeastTravel_s);
    }
    stroke.start_s = clock_s;
    stroke.pace.rest(kPress_s);
    for (std::size_t i = 1; i < points.size(); ++i) {
      const double at_m = (stroke.along_m[i - 1] + stroke.along_m[i]) / 2;
      double pace = std::min(kSlowest + (1 - kSlowest) * at_m / kRamp_m, 1.0);
      const double left_m = length_m - at_m;
      if (stops)
        pace = std::min(pace, kSlowest + (1 - kSlowest) * left_m / kRamp_m);
      else if (left_m < kRamp_m)
        pace = std::min(pace * 2, kSwept);
      // A turn of 90 degrees or more is made at the slowest pace.
      const double turn = std::min(turn_at(points, i) * 2, 1.0);
      pace *= 1 - (1 - kSlowest) * turn;
      stroke.pace.move(stroke.along_m[i], kSpeed_m_s * pace);
    }
    clock_s += stroke.pace.duration_s() + (stops ? kRest_s : 0.0);
    strokes_.push_back(std::move(stroke));
  }
}

double StrokePlayer::duration_s() const {
  return strokes_.empty() ? 0.0 : end_s(stroke_count()) + kLeastTravel_s;
}

double StrokePlayer::start_s(int stroke) const {
  return strokes_[static_cast<std::size_t>(stroke - 1)].start_s;
}

double StrokePlayer::end_s(int stroke) const {
  const auto& timed = strokes_[static_cast<std::size_t>(stroke - 1)];
  return timed.start_s + timed.pace.duration_s();
}

double StrokePlayer::share_at(int stroke, double time_s) const {
  const auto& timed = strokes_[static_cast<std::size_t>(stroke - 1)];
  const double since_s = time_s - timed.start_s;
  const double length_m = timed.along_m.back();
  if (since_s >= timed.pace.duration_s()) return 1.0;
  return length_m > 0 ? timed.pace.at(since_s).along / length_m : 0.0;
}

geometry::Polyline<geometry::TabletFrame> StrokePlayer::written(int stroke, double time_s) const {
  const auto& timed = strokes_[static_cast<std::size_t>(stroke - 1)];
  geometry::Polyline<geometry::TabletFrame> line;
  const double share = share_at(stroke, time_s);
  if (share <= 0) return line;
  const auto end = geometry::place_at(timed.along_m, share * timed.along_m.back());
  for (std::size_t i = 0; i <= end.segment; ++i) line.push_back({timed.points[i].x, timed.points[i].y});
  const Vec3 tip_m = geometry::point_on<Vec3>(timed.points, end);
  line.push_back({tip_m.x, tip_m.y});
  return line;
}

StrokePlayer::Pose StrokePlayer::at(double time_s) const {
  Pose pose;
  if (strokes_.empty()) return pose;
  time_s = std::clamp(time_s, 0.0, duration_s());
  for (int n = 1; n <= stroke_count(); ++n) {
    const auto& timed = strokes_[static_cast<std::size_t>(n - 1)];
    pose.stroke = n;
    if (time_s < timed.start_s) {
      // In the air, in an arc from the end of the previous stroke.
      const Vec3 to = timed.points.front();
      const Vec3 from =
          n > 1 ? strokes_[static_cast<std::size_t>(n - 2)].points.back() : to + Vec3(0, 0, kLift_m);
      const double left_s = n > 1 ? end_s(n - 1) : 0.0;
      const double part = glm::smoothstep(left_s, timed.start_s, time_s);
      pose.tip_m = glm::mix(from, to, part) + Vec3(0, 0, kLift_m * 4 * part * (1 - part));
      pose.share = 0;
      return pose;
    }
    pose.share = share_at(n, time_s);
    if (time_s <= end_s(n)) {
      const double at_m = pose.share * timed.along_m.back();
      pose.tip_m = geometry::point_on<Vec3>(timed.points, geometry::place_at(timed.along_m, at_m));
      pose.writing = true;
      return pose;
    }
  }
  const double since_s = time_s - end_s(stroke_count());
  pose.tip_m = strokes_.back().points.back() + Vec3(0, 0, kLift_m * std::min(since_s / kLeastTravel_s, 1.0));
  pose.share = 1;
  return pose;
}

}  // namespace nazori::practice
