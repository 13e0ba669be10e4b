// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/curve_follower.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "curve_location.h"
#include "nazori/functions/curve_kinds.h"

namespace nazori::functions {
namespace {

/// Of the plate: lines are drawn to within a sixteenth of a cell.
constexpr double kSamePlace = 1e-3;

}  // namespace

void CurveFollower::set_drawing(SharedDrawing drawing) {
  const bool same =
      drawing_ && drawing && canonical(drawing_->request.plot) == canonical(drawing->request.plot);
  drawing_ = std::move(drawing);
  point_ = -1;
  if (!location_) return;
  const PlotLocation before = *location_;
  const double x = before.x;
  const double y = before.y;
  location_.reset();
  if (!drawing_) return;
  const auto& window = tracing().window;
  const PlatePoint was{window.u(x), window.v(y)};
  if (was.u < 0 || was.u > 1 || was.v < 0 || was.v > 1) return;
  const auto near = nearest(was);
  if (!near || !(distance(near->at, was) < 0.2)) return;
  location_ = near;
  // The same curve in another window: keep the exact location, or zooming in and out again would end
  // elsewhere.
  if (!same || !(distance(near->at, was) < kSamePlace)) return;
  location_->at = was;
  location_->x = x;
  location_->y = y;
  location_->statement = before.statement;
}

std::optional<PlotLocation> CurveFollower::nearest(PlatePoint hand) const {
  if (!drawing_) return std::nullopt;
  const auto on = nearest_place(tracing(), hand);
  if (!on) return std::nullopt;
  PlotLocation place = described(*on);
  place.on->distance = on->distance;
  return place;
}

PlotLocation CurveFollower::described(const CurvePlace& on) const {
  const Branch& branch = tracing().branches[on.branch];
  const auto& window = tracing().window;
  PlotLocation place;
  place.on = on;
  place.at = on.at;
  place.statement = branch.statement;
  place.x = window.x(on.at.u);
  place.y = window.y(on.at.v);
  if (!branch.has_parameter) return place;
  const auto& statement = drawing_->request.plot.statements[static_cast<std::size_t>(branch.statement)];
  if (const auto exact = position_of(statement, parameter_at(branch, on))) {
    const PlatePoint at{window.u(exact->x.value), window.v(exact->y.value)};
    // Next to a hole or a jump the value of the expression may differ from the line.
    if (distance(at, on.at) < 0.005) {
      place.x = exact->x.value;
      place.y = exact->y.value;
    }
  }
  return place;
}

bool CurveFollower::runs_left(std::size_t branch) const {
  const Branch& b = tracing().branches[branch];
  if (b.closed || b.points.size() < 2) return false;
  const auto& statement = drawing_->request.plot.statements[static_cast<std::size_t>(b.statement)];
  // A curve with its own parameter is followed in the direction of the growing parameter.
  if (curve_kind(statement.kind).has_own_parameter())
    return b.points.front().parameter > b.points.back().parameter;
  return b.points.front().u > b.points.back().u;
}

std::vector<std::size_t> CurveFollower::order() const {
  const auto& branches = tracing().branches;
  std::vector<std::size_t> order;
  std::vector<PlatePoint> corner;
  for (std::size_t i = 0; i < branches.size(); ++i) {
    PlatePoint low{2, 2};
    bool inside = false;
    for (const auto& p : branches[i].points) {
      low.u = std::min(low.u, p.u);
      low.v = std::min(low.v, p.v);
      inside = inside || (p.u >= 0 && p.u <= 1 && p.v >= 0 && p.v <= 1);
    }
    corner.push_back(low);
    if (inside && branches[i].points.size() > 1) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (branches[a].statement != branches[b].statement) return branches[a].statement < branches[b].statement;
    if (std::abs(corner[a].u - corner[b].u) > 1e-9) return corner[a].u < corner[b].u;
    return corner[a].v < corner[b].v;
  });
  return order;
}

CurvePlace CurveFollower::end_of(std::size_t branch, bool last) const {
  const Branch& b = tracing().branches[branch];
  CurvePlace place;
  place.branch = branch;
  if (last && !b.closed) {
    place.piece = b.points.size() - 2;
    place.at = {b.points.back().u, b.points.back().v};
  } else {
    place.at = {b.points.front().u, b.points.front().v};
  }
  if (b.closed || is_in_window(place.at)) return place;
  const double back = last ? -kStep : kStep;
  CurvePlace before = place;
  for (int i = 0; i < 100; ++i) {
    const CurvePlace next = step_along(tracing(), before, back);
    if (is_in_window(next.at)) return last_in_window(tracing(), next, -back);
    before = next;
  }
  return place;
}

bool CurveFollower::begin() {
  if (!drawing_) return false;
  if (location_ && location_->on) return true;
  const auto near = nearest(location_ ? location_->at : PlatePoint{0.5, 0.5});
  if (!near) return false;
  location_ = near;
  return true;
}

CurveFollower::Step CurveFollower::pass_end(Way way) {
  const auto all = order();
  const auto here = std::find(all.begin(), all.end(), location_->on->branch);
  if (here == all.end()) return Step::end;
  const auto index = here - all.begin() + static_cast<std::ptrdiff_t>(way);
  if (index < 0 || index >= static_cast<std::ptrdiff_t>(all.size())) return Step::end;
  const std::size_t next = all[static_cast<std::size_t>(index)];
  const auto& statement = drawing_->request.plot.statements[static_cast<std::size_t>(location_->statement)];
  // Only y = f(x) continues from left to right after a break.
  if (tracing().branches[next].statement != location_->statement ||
      !curve_kind(statement.kind).is_graph_of_x())
    return Step::end;
  location_ = described(end_of(next, (way == Way::back) != runs_left(next)));
  return Step::next_branch;
}

CurveFollower::Step CurveFollower::step(Way way) {
  const bool had = location_.has_value();
  if (!begin()) return Step::end;
  if (!had) return Step::done;
  const double sign = (way == Way::on) != runs_left(location_->on->branch) ? 1 : -1;
  auto next = step_along(tracing(), *location_->on, sign * kStep);
  if (!is_in_window(next.at)) next = last_in_window(tracing(), *location_->on, sign * kStep);
  if (distance(next.at, location_->at) < 1e-9) return pass_end(way);
  location_ = described(next);
  return Step::done;
}

CurveFollower::Step CurveFollower::step_to_tick(Way way) {
  if (!begin()) return Step::end;
  const auto& window = tracing().window;
  const double tick = tick_step(window.x0, window.x1);
  const double sign = (way == Way::on) != runs_left(location_->on->branch) ? 1 : -1;
  constexpr double kFine = 0.001;
  constexpr double kNear = 1e-9;
  CurvePlace at = *location_->on;
  const double tick_u = tick / (window.x1 - window.x0);
  const double zero_u = window.u(0);
  bool moved = false;
  // Once round the longest curve is a thousand windows: enough.
  for (int i = 0; i < 100'000; ++i) {
    const CurvePlace next = step_along(tracing(), at, sign * kFine);
    if (distance(next.at, at.at) < kNear) break;
    const double before = (at.at.u - zero_u) / tick_u;
    const double after = (next.at.u - zero_u) / tick_u;
    const double line = after > before ? std::floor(before + 1 + kNear) : std::ceil(before - 1 - kNear);
    if (after > before ? line <= after : (after < before && line >= after)) {
      const double share = (line - before) / (after - before);
      const CurvePlace there = step_along(tracing(), at, sign * kFine * share);
      if (distance(there.at, location_->at) > kFine / 10 && is_in_window(there.at)) {
        location_ = described(there);
        stand_on_tick(line * tick);
        return Step::done;
      }
    }
    const bool leaves = !is_in_window(next.at);
    const CurvePlace reached = leaves ? last_in_window(tracing(), at, sign * kFine) : next;
    moved = moved || distance(reached.at, at.at) > kNear;
    at = reached;
    if (leaves) break;
  }
  if (!moved) return pass_end(way);
  location_ = described(at);
  return Step::end;
}

void CurveFollower::stand_on_tick(double x) {
  const auto& statement = drawing_->request.plot.statements[static_cast<std::size_t>(location_->statement)];
  if (!curve_kind(statement.kind).is_graph_of_x()) return;
  const auto exact = position_of(statement, x);
  if (!exact) return;
  const double y = exact->y.value;
  if (!(std::abs(tracing().window.v(y) - location_->at.v) < 0.5 * kStep)) return;
  location_->x = x;
  location_->y = y;
}

void CurveFollower::go_to_end(Way way) {
  if (!begin()) return;
  const std::size_t branch = location_->on->branch;
  location_ = described(end_of(branch, (way == Way::on) != runs_left(branch)));
}

bool CurveFollower::change_branch(Way way) {
  if (!begin()) return false;
  const auto all = order();
  if (all.size() < 2) return false;
  const auto here = std::find(all.begin(), all.end(), location_->on->branch);
  const auto count = static_cast<std::ptrdiff_t>(all.size());
  const auto from = here == all.end() ? 0 : here - all.begin();
  const auto next = all[static_cast<std::size_t>((from + static_cast<std::ptrdiff_t>(way) + count) % count)];
  const Branch& branch = tracing().branches[next];
  // Directly above or below if it passes there, else its nearest point.
  std::optional<CurvePlace> best;
  double best_off = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < branch.points.size(); ++i) {
    const auto& p = branch.points[i];
    const auto& q = branch.points[i + 1];
    const auto part = part_in_window({p.u, p.v}, {q.u, q.v});
    if (!part) continue;
    const double du = q.u - p.u;
    const double share = std::clamp(du != 0 ? (location_->at.u - p.u) / du : 0.0, part->first, part->second);
    const PlatePoint at{p.u + share * du, p.v + share * (q.v - p.v)};
    const double off = std::abs(at.u - location_->at.u) * 1000 + std::abs(at.v - location_->at.v);
    if (off < best_off) {
      best_off = off;
      best = CurvePlace{next, i, at, 0};
    }
  }
  if (!best) return false;
  best->at = {std::clamp(best->at.u, 0.0, 1.0), std::clamp(best->at.v, 0.0, 1.0)};
  location_ = described(*best);
  return true;
}

const PointOfInterest* CurveFollower::next_point(Way way) {
  if (!drawing_ || drawing_->points.empty()) return nullptr;
  const auto count = static_cast<std::ptrdiff_t>(drawing_->points.size());
  if (point_ < 0 && way == Way::back) point_ = 0;
  point_ = (point_ + static_cast<std::ptrdiff_t>(way) + count) % count;
  const auto& point = drawing_->points[static_cast<std::size_t>(point_)];
  go_to(point);
  return &point;
}

void CurveFollower::go_to(const PointOfInterest& point) {
  if (!drawing_) return;
  for (std::size_t i = 0; i < drawing_->points.size(); ++i)
    if (&drawing_->points[i] == &point) point_ = static_cast<std::ptrdiff_t>(i);
  const auto& window = tracing().window;
  // An asymptote has one coordinate; the other is the middle of the window.
  const double x = std::isnan(point.x) ? window.x(0.5) : point.x;
  const double y = std::isnan(point.y) ? window.y(0.5) : point.y;
  PlotLocation place;
  place.at = {window.u(x), window.v(y)};
  place.statement = point.statement;
  if (const auto on = nearest_place(tracing(), place.at, point.statement); on && on->distance < 0.5 * kStep)
    place.on = on;
  place.x = x;
  place.y = y;
  location_ = place;
}

void CurveFollower::go_to(double x, double y) {
  if (!drawing_) return;
  const auto& window = tracing().window;
  if (const auto near = nearest({window.u(x), window.v(y)})) location_ = near;
}

const PointOfInterest* CurveFollower::point_here() const {
  if (!location_ || !drawing_) return nullptr;
  const auto& window = tracing().window;
  const PointOfInterest* best = nullptr;
  double nearest_m = 0.5 * kStep + 1e-12;
  for (const auto& point : drawing_->points) {
    if (point.statement != location_->statement && point.other != location_->statement) continue;
    if (std::isnan(point.x) || std::isnan(point.y)) continue;
    const double off = distance({window.u(point.x), window.v(point.y)}, location_->at);
    if (off < nearest_m) {
      nearest_m = off;
      best = &point;
    }
  }
  return best;
}

std::optional<double> CurveFollower::slope() const {
  if (!location_ || !location_->on) return std::nullopt;
  const Branch& branch = tracing().branches[location_->on->branch];
  const auto& window = tracing().window;
  double dx = 0;
  double dy = 0;
  const auto& statement = drawing_->request.plot.statements[static_cast<std::size_t>(branch.statement)];
  // On a tick or a point of interest the location is known more precisely than from the drawn line.
  const CurveKind& kind = curve_kind(statement.kind);
  const double parameter = kind.is_graph_of_x()   ? location_->x
                           : kind.is_graph_of_y() ? location_->y
                                                  : parameter_at(branch, *location_->on);
  const auto exact =
      branch.has_parameter ? position_of(statement, parameter) : std::optional<CurvePosition>();
  if (exact && std::isfinite(exact->x.slopes[0]) && std::isfinite(exact->y.slopes[0])) {
    dx = exact->x.slopes[0];
    dy = exact->y.slopes[0];
  } else {
    const auto& p = branch.points[location_->on->piece];
    const auto& q = branch.points[(location_->on->piece + 1) % branch.points.size()];
    dx = (q.u - p.u) * (window.x1 - window.x0);
    dy = (q.v - p.v) * (window.y1 - window.y0);
    if (std::abs(dx) < 1e-9 * (window.x1 - window.x0)) dx = 0;
  }
  if (dx == 0 && dy == 0) return std::nullopt;
  return dx == 0 ? std::copysign(std::numeric_limits<double>::infinity(), dy) : dy / dx;
}

void CurveFollower::drop_beacon() {
  if (!location_) return;
  beacons_.push_back({location_->x, location_->y});
  beacon_ = beacons_.size() - 1;
}

int CurveFollower::go_to_next_beacon() {
  if (beacons_.empty() || !drawing_) return 0;
  beacon_ = (beacon_ + 1) % beacons_.size();
  go_to(beacons_[beacon_].x, beacons_[beacon_].y);
  return static_cast<int>(beacon_) + 1;
}

}  // namespace nazori::functions
