// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/traced_ink.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "nazori/geometry/polyline.h"

namespace nazori::practice {
namespace {

constexpr double kDone = 1.0;
constexpr double kNearlyDone = 0.999;
constexpr double kAtEnd_m = 0.0015;   ///< within this distance of its end a stroke is finished without a lift
constexpr double kAtEndShare = 0.1;   ///< and within this share of its length
constexpr double kNoTouch_m = 0.002;  ///< a stroke with less ink does not count as left open
constexpr double kPassing_m = 0.008;  ///< nor does one with less ink than this if the stylus only passed by

using geometry::TabletFrame;
using geometry::TabletPoint;
using Points = std::span<const TabletPoint>;

}  // namespace

void TracedInk::set_strokes(std::span<const haptics::StrokePath> strokes) {
  lines_.clear();
  for (const auto& stroke : strokes) {
    Line line;
    line.points.reserve(stroke.points.size());
    for (const auto& p : stroke.points) line.points.push_back({p.x, p.y});
    line.length_m = geometry::arc_length<TabletFrame>(line.points);
    lines_.push_back(std::move(line));
  }
  clear();
}

void TracedInk::clear() {
  progress_.assign(lines_.size(), 0.0);
  inked_.clear();
  left_open_.clear();
  followed_.clear();
  lost_ = {};
  // The stylus may still rest at the end of the last stroke: that does not start a new one.
}

int TracedInk::undo() {
  if (inked_.empty()) return 0;
  const int stroke = inked_.back();
  set_ink(stroke, 0);
  std::erase(left_open_, stroke);
  followed_.clear();
  lost_ = {};
  return stroke;
}

bool TracedInk::is_finished(int stroke) const {
  return stroke >= 1 && static_cast<std::size_t>(stroke) <= progress_.size() &&
         progress_[static_cast<std::size_t>(stroke - 1)] >= kDone;
}

int TracedInk::next_stroke() const {
  const auto open = std::find_if(progress_.begin(), progress_.end(), [](double p) { return p < kDone; });
  return open == progress_.end() ? 0 : static_cast<int>(open - progress_.begin()) + 1;
}

double TracedInk::inked_m(int stroke) const {
  return progress_[static_cast<std::size_t>(stroke - 1)] * line_of(stroke).length_m;
}

void TracedInk::set_ink(int stroke, double front_m) {
  double& progress = progress_[static_cast<std::size_t>(stroke - 1)];
  if (progress == 0 && front_m > 0) inked_.push_back(stroke);
  progress = line_of(stroke).length_m > 0 ? std::min(front_m / line_of(stroke).length_m, kDone) : 0;
  if (progress == 0) std::erase(inked_, stroke);
}

TracedInk::Step TracedInk::follow(const haptics::Vec3& proxy_m, bool touching, int only) {
  if (!touching) return std::exchange(was_touching_, false) ? lift() : Step{};
  const bool coming_down = !was_touching_;
  was_touching_ = true;
  at_ = {proxy_m.x, proxy_m.y};
  std::erase_if(followed_, [only](const Candidate& c) { return only != 0 && c.stroke != only; });
  return followed_.empty() ? take_up(at_, only, coming_down) : advance(at_, only);
}

TracedInk::Step TracedInk::take_up(TabletPoint at, int only, bool coming_down) {
  const int next = next_stroke();
  std::vector<std::pair<double, Candidate>> near;
  for (int n = 1; n <= static_cast<int>(lines_.size()); ++n) {
    if ((only != 0 && n != only) || is_finished(n) || line_of(n).points.empty()) continue;
    const double front_m = inked_m(n);
    const double away_m = geometry::distance(geometry::point_at<TabletFrame>(line_of(n).points, front_m), at);
    // Where several begin close together, the one that is next in order comes first.
    if (away_m <= kReach_m) near.push_back({n == next ? 0.0 : away_m, {n, front_m, front_m, coming_down}});
  }
  std::sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [away_m, candidate] : near) followed_.push_back(candidate);
  if (!followed_.empty()) {
    const int stroke = followed_.front().stroke;
    const bool early = only == 0 && next != 0 && stroke > next;
    return {!coming_down ? TraceEvent::none : early ? TraceEvent::too_early : TraceEvent::began, stroke};
  }
  const int candidate = only != 0 ? only : next;
  if (!coming_down || candidate == 0 || static_cast<std::size_t>(candidate) > lines_.size() ||
      is_finished(candidate))
    return {};
  const auto& line = line_of(candidate);
  if (!line.points.empty() && inked_m(candidate) == 0.0 && line.length_m > 2 * kReach_m &&
      geometry::distance(line.points.back(), at) < kReach_m)
    return {TraceEvent::from_the_end, candidate};
  return {};
}

/// @return whether the stylus is still near the stroke.
bool TracedInk::follow_on(Candidate& candidate, TabletPoint at) const {
  const auto& line = line_of(candidate.stroke);
  // Search only just ahead: ink must not jump to another part of a line that comes back near itself.
  const double front_m = candidate.front_m;
  const auto ahead =
      geometry::nearest_point_between<TabletFrame>(line.points, at, front_m, front_m + kReach_m);
  if (ahead.distance < kReach_m) {
    candidate.front_m = std::clamp(ahead.arc_length, front_m, line.length_m);
    return true;
  }
  return geometry::distance(geometry::point_at<TabletFrame>(line.points, front_m), at) <= 2 * kReach_m;
}

TracedInk::Step TracedInk::advance(TabletPoint at, int only) {
  const Candidate shown = followed_.front();
  std::erase_if(followed_, [&](Candidate& c) { return !follow_on(c, at); });
  Step step;
  if (followed_.empty()) {
    lost_ = shown;
    return step;
  }
  if (followed_.front().stroke != shown.stroke) {
    // The hand has not followed the stroke that took the ink, so that stroke was not meant.
    set_ink(shown.stroke, shown.before_m);
    std::stable_sort(followed_.begin(), followed_.end(), [](const Candidate& a, const Candidate& b) {
      return a.front_m - a.before_m > b.front_m - b.before_m;
    });
    const int next = next_stroke();
    const int stroke = followed_.front().stroke;
    if (only == 0 && next != 0 && stroke > next) step = {TraceEvent::too_early, stroke};
    step.inked = true;
  }
  const auto& now = followed_.front();
  const auto& line = line_of(now.stroke);
  // While another stroke may be meant, the lift decides.
  if (followed_.size() == 1 && line.length_m - now.front_m <= std::min(kAtEnd_m, line.length_m * kAtEndShare))
    return finish(now.stroke);
  if (now.front_m > inked_m(now.stroke)) {
    set_ink(now.stroke, std::min(now.front_m, line.length_m * kNearlyDone));
    step.stroke = now.stroke;
    step.inked = true;
  }
  return step;
}

TracedInk::Step TracedInk::finish(int stroke) {
  set_ink(stroke, line_of(stroke).length_m);
  progress_[static_cast<std::size_t>(stroke - 1)] = kDone;
  std::erase(left_open_, stroke);
  followed_.clear();
  lost_ = {};
  return {TraceEvent::finished, stroke, true};
}

bool TracedInk::may_end(const Candidate& candidate) const {
  const auto& line = line_of(candidate.stroke);
  return line.length_m - candidate.front_m <= std::min(kLeft_m, line.length_m * kLeftShare);
}

TracedInk::Step TracedInk::lift() {
  const Candidate shown = followed_.empty() ? lost_ : followed_.front();
  const auto others = std::exchange(followed_, {});
  lost_ = {};
  if (shown.stroke == 0 || is_finished(shown.stroke)) return {};
  if (others.size() <= 1 && may_end(shown)) return finish(shown.stroke);
  // Among the strokes that begin there, choose the one that ends where the stylus was lifted.
  const auto from_end_m = [this](const Candidate& c) {
    return geometry::distance(line_of(c.stroke).points.back(), at_);
  };
  const Candidate* ended = nullptr;
  for (const auto& one : others)
    if (may_end(one) && from_end_m(one) <= kReach_m &&
        (ended == nullptr || from_end_m(one) < from_end_m(*ended)))
      ended = &one;
  if (ended != nullptr) {
    if (ended->stroke != shown.stroke) set_ink(shown.stroke, shown.before_m);
    return finish(ended->stroke);
  }
  if (!shown.is_meant && shown.front_m - shown.before_m < kPassing_m) {
    set_ink(shown.stroke, shown.before_m);
    return {TraceEvent::none, shown.stroke, true};
  }
  if (inked_m(shown.stroke) < kNoTouch_m) return {};
  const auto place = std::lower_bound(left_open_.begin(), left_open_.end(), shown.stroke);
  if (place == left_open_.end() || *place != shown.stroke) left_open_.insert(place, shown.stroke);
  return {TraceEvent::left_open, shown.stroke};
}

geometry::Polyline<TabletFrame> TracedInk::missing_bit(int stroke) const {
  geometry::Polyline<TabletFrame> bit;
  if (stroke < 1 || static_cast<std::size_t>(stroke) > lines_.size() || is_finished(stroke)) return bit;
  constexpr double kStep_m = 0.001;
  const auto& line = line_of(stroke);
  const double left_m = line.length_m - inked_m(stroke);
  const int steps = std::max(1, static_cast<int>(std::ceil(left_m / kStep_m)));
  for (int step = 0; step <= steps; ++step)
    bit.push_back(
        geometry::point_at<TabletFrame>(line.points, line.length_m - left_m * (steps - step) / steps));
  return bit;
}

}  // namespace nazori::practice
