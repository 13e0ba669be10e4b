// SPDX-License-Identifier: Apache-2.0
#include "ink_tracker.h"

#include <algorithm>
#include <cmath>

#include "nazori/geometry/polyline.h"

namespace nazori::ui {
namespace {

constexpr double kDone = 1.0;

using geometry::TabletFrame;
using geometry::TabletPoint;
using Points = std::span<const TabletPoint>;

}  // namespace

void InkTracker::set_strokes(std::span<const haptics::StrokePath> strokes) {
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

void InkTracker::clear() {
  progress_.assign(lines_.size(), 0.0);
  inked_.clear();
  active_ = 0;
  // Who wrote the last stroke still rests at its end: that is no coming down.
}

int InkTracker::undo() {
  if (inked_.empty()) return 0;
  const int stroke = inked_.back();
  inked_.pop_back();
  progress_[static_cast<std::size_t>(stroke - 1)] = 0;
  active_ = 0;
  return stroke;
}

bool InkTracker::is_finished(int stroke) const {
  return stroke >= 1 && static_cast<std::size_t>(stroke) <= progress_.size() &&
         progress_[static_cast<std::size_t>(stroke - 1)] >= kDone;
}

int InkTracker::next_stroke() const {
  const auto open = std::find_if(progress_.begin(), progress_.end(), [](double p) { return p < kDone; });
  return open == progress_.end() ? 0 : static_cast<int>(open - progress_.begin()) + 1;
}

InkTracker::Step InkTracker::follow(const haptics::Vec3& proxy_m, bool touching, int only) {
  if (!touching) {
    active_ = 0;
    was_touching_ = false;
    return {};
  }
  const bool coming_down = !was_touching_;
  was_touching_ = true;
  const TabletPoint at{proxy_m.x, proxy_m.y};
  if (active_ != 0 && only != 0 && active_ != only) active_ = 0;
  return active_ == 0 ? take_up(at, only, coming_down) : advance(at);
}

InkTracker::Step InkTracker::take_up(TabletPoint at, int only, bool coming_down) {
  int best = 0;
  double best_m = kReach_m;
  const int next = next_stroke();
  for (int n = 1; n <= static_cast<int>(lines_.size()); ++n) {
    if ((only != 0 && n != only) || is_finished(n)) continue;
    const auto& line = lines_[static_cast<std::size_t>(n - 1)];
    if (line.points.empty()) continue;
    const double front_m = progress_[static_cast<std::size_t>(n - 1)] * line.length_m;
    const double away_m = geometry::distance(geometry::point_at<TabletFrame>(line.points, front_m), at);
    // Where several begin close together the one whose turn it is wins.
    if (away_m <= kReach_m && n == next) {
      active_ = n;
      return {coming_down ? InkEvent::began : InkEvent::none, n};
    }
    if (away_m < best_m) {
      best_m = away_m;
      best = n;
    }
  }
  if (best != 0) {
    active_ = best;
    const bool early = only == 0 && next != 0 && best > next && coming_down;
    return {early ? InkEvent::too_early : coming_down ? InkEvent::began : InkEvent::none, best};
  }
  if (coming_down) {
    const int candidate = only != 0 ? only : next;
    if (candidate != 0 && static_cast<std::size_t>(candidate) <= lines_.size() && !is_finished(candidate)) {
      const auto& line = lines_[static_cast<std::size_t>(candidate - 1)];
      if (!line.points.empty() && progress_[static_cast<std::size_t>(candidate - 1)] == 0.0 &&
          line.length_m > 2 * kReach_m && geometry::distance(line.points.back(), at) < kReach_m) {
        return {InkEvent::from_the_end, candidate};
      }
    }
  }
  return {};
}

InkTracker::Step InkTracker::advance(TabletPoint at) {
  const auto index = static_cast<std::size_t>(active_ - 1);
  const auto& line = lines_[index];
  double& progress = progress_[index];
  const double front_m = progress * line.length_m;
  // Only the piece just ahead is looked at: a line that comes back near itself must not be jumped.
  double reached_m = front_m;
  double nearest_m = kReach_m;
  constexpr double kStep_m = 0.00025;
  const double last_m = std::min(front_m + kReach_m, line.length_m);
  const int steps = static_cast<int>(std::ceil((last_m - front_m) / kStep_m));
  for (int step = 0; step <= steps; ++step) {
    const double clamped_m = std::min(front_m + step * kStep_m, last_m);
    const double away_m = geometry::distance(geometry::point_at<TabletFrame>(line.points, clamped_m), at);
    if (away_m < nearest_m) {
      nearest_m = away_m;
      reached_m = clamped_m;
    }
  }
  if (nearest_m >= kReach_m &&
      geometry::distance(geometry::point_at<TabletFrame>(line.points, front_m), at) > 2 * kReach_m) {
    active_ = 0;
    return {};
  }
  if (reached_m > front_m && progress == 0) inked_.push_back(active_);
  const double end_m = std::min(0.0015, line.length_m * 0.1);
  if (line.length_m - reached_m <= end_m) {
    const int stroke = active_;
    progress = kDone;
    active_ = 0;
    return {InkEvent::finished, stroke, true};
  }
  if (reached_m <= front_m) return {};
  progress = reached_m / line.length_m;
  return {InkEvent::none, active_, true};
}

}  // namespace nazori::ui
