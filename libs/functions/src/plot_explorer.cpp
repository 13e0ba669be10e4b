// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/plot_explorer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nazori::functions {
namespace {

PlotEvent event(PlotEventKind kind) {
  PlotEvent made;
  made.kind = kind;
  return made;
}

}  // namespace

void PlotExplorer::show(SharedDrawing drawing) {
  drawing_ = std::move(drawing);
  touched_ = nullptr;
  if (drawing_ && drawing_->final) follower_.set_drawing(drawing_);
}

void PlotExplorer::settle() {
  if (drawing_ && !drawing_->final) follower_.set_drawing(drawing_);
}

PlotEvent PlotExplorer::at_location(PlotEventKind kind) const {
  if (!follower_.location() || !drawing_) return event(PlotEventKind::no_curve);
  PlotEvent made = event(kind);
  made.location = follower_.location();
  made.statement = made.location->statement;
  if (const auto* point = follower_.point_here()) made.point = *point;
  return made;
}

PlotEvent PlotExplorer::stepped(CurveFollower::Step step) const {
  switch (step) {
    case CurveFollower::Step::done:
      break;
    case CurveFollower::Step::next_branch:
      return at_location(PlotEventKind::next_branch);
    case CurveFollower::Step::end:
      return at_location(PlotEventKind::end_of_branch);
  }
  return at_location(PlotEventKind::here);
}

PlotEvent PlotExplorer::step(Way way) { return stepped(follower_.step(way)); }

PlotEvent PlotExplorer::step_to_tick(Way way) { return stepped(follower_.step_to_tick(way)); }

PlotEvent PlotExplorer::go_to_end(Way way) {
  follower_.go_to_end(way);
  return at_location(PlotEventKind::here);
}

PlotEvent PlotExplorer::change_branch(Way way) {
  if (!follower_.change_branch(way)) return event(PlotEventKind::no_other_branch);
  return at_location(PlotEventKind::other_branch);
}

PlotEvent PlotExplorer::at_point(const PointOfInterest* point) {
  if (point == nullptr) return event(PlotEventKind::no_point);
  follower_.go_to(*point);
  PlotEvent made = at_location(PlotEventKind::point_reached);
  made.point = *point;
  made.number = static_cast<int>(point - drawing_->points.data()) + 1;
  return made;
}

PlotEvent PlotExplorer::next_point(Way way) { return at_point(follower_.next_point(way)); }

PlotEvent PlotExplorer::go_to_point(std::size_t index) {
  return at_point(drawing_ && index < drawing_->points.size() ? &drawing_->points[index] : nullptr);
}

PlotEvent PlotExplorer::drop_beacon() {
  follower_.drop_beacon();
  if (!follower_.location()) return event(PlotEventKind::no_location);
  PlotEvent made = at_location(PlotEventKind::beacon_dropped);
  made.number = static_cast<int>(follower_.beacon_count());
  return made;
}

PlotEvent PlotExplorer::go_to_next_beacon() {
  const int number = follower_.go_to_next_beacon();
  if (number == 0) return event(PlotEventKind::no_beacon);
  PlotEvent made = at_location(PlotEventKind::beacon_reached);
  made.number = number;
  return made;
}

PlotEvent PlotExplorer::where() const {
  if (!follower_.location() && has_curve()) return event(PlotEventKind::no_location);
  return at_location(PlotEventKind::here);
}

PlotEvent PlotExplorer::slope() const {
  const auto slope = follower_.slope();
  PlotEvent made = event(slope ? PlotEventKind::slope : PlotEventKind::no_slope);
  made.slope = slope.value_or(0);
  return made;
}

PlotEvent PlotExplorer::groove(int number, int count) const {
  const bool all = number == 0 || !drawing_;
  PlotEvent made = event(all ? PlotEventKind::all_grooves : PlotEventKind::groove);
  made.count = count;
  if (all) return made;
  made.number = number;
  made.statement = drawing_->grooves[static_cast<std::size_t>(number - 1)].statement;
  return made;
}

Cue PlotExplorer::cue_of(const PlotLocation& location) const {
  return cue_at(location.at, drawing_->request.window, location.on ? 1 : 0);
}

Touch PlotExplorer::touch(PlatePoint hand) {
  const bool surface = drawing_->request.plot.is_surface();
  Touch made = surface ? touch_surface(hand) : touch_curves(hand);
  const auto& window = drawing_->request.window;
  const PointOfInterest* here = nullptr;
  for (const auto& point : drawing_->points) {
    if (std::hypot(window.u(point.x) - hand.u, window.v(point.y) - hand.v) < CurveFollower::kStep)
      here = &point;
  }
  if (here != touched_) made.reached = here;
  touched_ = here;
  return made;
}

Touch PlotExplorer::touch_surface(PlatePoint hand) const {
  const Plate& plate = drawing_->picture.plate;
  const int size = plate.heights.size();
  const int column = std::clamp(static_cast<int>(hand.u * size), 0, size - 1);
  const int row = std::clamp(static_cast<int>((1 - hand.v) * size), 0, size - 1);
  const auto sample =
      static_cast<std::size_t>(row) * static_cast<std::size_t>(size) + static_cast<std::size_t>(column);
  const bool defined = plate.mask[sample] != 0;
  const Window& shown = drawing_->request.window;
  const Window heights{shown.x0, shown.x1, plate.range.low, plate.range.high};
  Touch made;
  made.cue = cue_at({hand.u, plate.heights.at(column, row)}, heights, defined ? 1 : 0);
  return made;
}

Touch PlotExplorer::touch_curves(PlatePoint hand) const {
  const PlotRequest& request = drawing_->request;
  const double half_width = request.plate.half_width;
  const auto& bars = drawing_->picture.tracing.bars;
  Touch made;
  made.trembles = std::any_of(bars.begin(), bars.end(), [&](const Bar& bar) {
    const auto [low, high] = std::minmax(bar.from.v, bar.to.v);
    return std::abs(bar.from.u - hand.u) < half_width && hand.v >= low && hand.v <= high;
  });
  if (made.trembles) {
    made.cue = cue_at(hand, request.window, 1);
    return made;
  }
  const double reach = 3 * half_width;
  const auto near = follower_.nearest(hand);
  const double nearness = near ? std::clamp(1 - near->on->distance / reach, 0.0, 1.0) : 0.0;
  made.cue = cue_at(near ? near->at : hand, request.window, nearness);
  return made;
}

std::optional<Cue> reference_cue(const Window& window) {
  const double v = window.v(0);
  if (v < 0 || v > 1) return std::nullopt;
  return cue_at({0.5, v}, window, 1);
}

}  // namespace nazori::functions
