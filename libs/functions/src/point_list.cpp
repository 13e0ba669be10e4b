// SPDX-License-Identifier: Apache-2.0
#include "point_list.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nazori::functions {
namespace {

// Two points of interest of one kind nearer than this share of the plate count as one.
constexpr double kSame = 1e-6;

/// Gives a coordinate its exact name, and the value of that name.
void name(double& value, std::string& text, double range) {
  const auto exact = exact_name(value);
  if (!exact) return;
  // In a window this narrow the name could belong to a neighbour.
  if (range < 1e-9 * std::max(1.0, std::abs(value))) return;
  text = *exact;
  if (text == "0") value = 0;
}

}  // namespace

bool PointList::in_window(double x, double y) const {
  constexpr double kHair = 1e-9;
  const double u = window_.u(x);
  const double v = window_.v(y);
  return (std::isnan(x) || (u >= -kHair && u <= 1 + kHair)) &&
         (std::isnan(y) || (v >= -kHair && v <= 1 + kHair)) && !(std::isnan(x) && std::isnan(y));
}

bool PointList::has_near(int statement, PointKind kind, double x, double y, double share) const {
  return std::any_of(found_.begin(), found_.end(), [&](const PointOfInterest& p) {
    if (p.kind != kind || p.statement != statement) return false;
    const double du = std::isnan(x) ? 0 : window_.u(p.x) - window_.u(x);
    const double dv = std::isnan(y) ? 0 : window_.v(p.y) - window_.v(y);
    return std::hypot(du, dv) < share;
  });
}

bool PointList::has_event(int statement, EventKind kind, double parameter, double reach) const {
  return std::any_of(events_.begin(), events_.end(), [&](const Event& e) {
    return e.statement == statement && e.kind == kind && std::abs(e.parameter - parameter) <= reach;
  });
}

bool PointList::has_break(int statement, double parameter, double reach) const {
  return has_event(statement, EventKind::pole, parameter, reach) ||
         has_event(statement, EventKind::jump, parameter, reach) ||
         has_event(statement, EventKind::hole, parameter, reach);
}

PointOfInterest* PointList::add(int statement, PointKind kind, double x, double y, double parameter,
                                int other) {
  if (!in_window(x, y)) return nullptr;
  const auto owner = static_cast<std::size_t>(statement);
  if (counts_[owner] >= most_) return nullptr;
  for (const PointOfInterest& p : found_) {
    if (p.kind != kind || p.statement != statement || p.other != other) continue;
    const double du = std::isnan(x) ? 0 : window_.u(p.x) - window_.u(x);
    const double dv = std::isnan(y) ? 0 : window_.v(p.y) - window_.v(y);
    if (std::hypot(du, dv) < kSame) return nullptr;
  }
  ++counts_[owner];
  PointOfInterest p;
  p.kind = kind;
  p.statement = statement;
  p.other = other;
  p.x = x + 0.0;
  p.y = y + 0.0;
  p.parameter = parameter + 0.0;
  found_.push_back(std::move(p));
  return &found_.back();
}

PointOfInterest& PointList::add_slanted(int statement, double slope, double intercept, int side) {
  PointOfInterest p;
  p.kind = PointKind::slanted_asymptote;
  p.statement = statement;
  p.x = p.y = kNaN;
  p.slope = slope;
  p.intercept = intercept;
  p.side = side;
  found_.push_back(std::move(p));
  return found_.back();
}

std::vector<PointOfInterest> PointList::take() {
  for (PointOfInterest& p : found_) {
    name(p.x, p.x_name, window_.x1 - window_.x0);
    name(p.y, p.y_name, window_.y1 - window_.y0);
  }
  std::stable_sort(found_.begin(), found_.end(), [](const PointOfInterest& a, const PointOfInterest& b) {
    if (a.statement != b.statement) return a.statement < b.statement;
    const double ax = std::isnan(a.x) ? -1e300 : a.x;
    const double bx = std::isnan(b.x) ? -1e300 : b.x;
    return ax < bx;
  });
  return std::move(found_);
}

}  // namespace nazori::functions
