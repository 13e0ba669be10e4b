// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/tablet_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace nazori::functions {
namespace {

using geometry::TabletPoint;

/// The part of a straight piece inside the window, as shares of its length.
std::optional<std::pair<double, double>> part_inside(PlatePoint p, PlatePoint q) {
  double from = 0;
  double to = 1;
  for (const auto& [start, step] : {std::pair{p.u, q.u - p.u}, std::pair{p.v, q.v - p.v}}) {
    if (step == 0) {
      if (start < 0 || start > 1) return std::nullopt;
      continue;
    }
    const double a = -start / step;
    const double b = (1 - start) / step;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  if (from > to) return std::nullopt;
  return std::pair{from, to};
}

double distance_to_chord(TabletPoint p, TabletPoint a, TabletPoint b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double length2 = dx * dx + dy * dy;
  const double t = length2 > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length2, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

/// Ramer, Douglas and Peucker, with an explicit stack.
std::vector<TabletPoint> simplified(const std::vector<TabletPoint>& all, double tolerance) {
  std::vector<bool> keep(all.size(), false);
  keep.front() = keep.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, all.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double most = tolerance;
    std::size_t worst = 0;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double d = distance_to_chord(all[i], all[first], all[last]);
      if (d > most) {
        most = d;
        worst = i;
      }
    }
    if (worst == 0) continue;
    keep[worst] = true;
    open.emplace_back(first, worst);
    open.emplace_back(worst, last);
  }
  std::vector<TabletPoint> kept;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (keep[i]) kept.push_back(all[i]);
  }
  return kept;
}

/// Straight pieces of a branch; a closed branch has one more, back to its start.
std::size_t piece_count(const Branch& b) { return b.points.size() - (b.closed ? 0 : 1); }

std::pair<PlatePoint, PlatePoint> piece_of(const Branch& b, std::size_t i) {
  const CurvePoint& p = b.points[i];
  const CurvePoint& q = b.points[(i + 1) % b.points.size()];
  return {{p.u, p.v}, {q.u, q.v}};
}

}  // namespace

TabletPoint tablet_place(PlatePoint at, int size, const geometry::TabletShape& shape) {
  return geometry::grid_to_tablet({at.u * size - 0.5, (1 - at.v) * size - 0.5}, size, shape);
}

PlatePoint plate_place(TabletPoint at, int size, const geometry::TabletShape& shape) {
  const double step = shape.width_m / (size - 1);
  const double column = (at.x + shape.width_m / 2) / step;
  const double row = (shape.width_m / 2 - at.y) / step;
  return {(column + 0.5) / size, 1 - (row + 0.5) / size};
}

std::vector<TabletCurve> tablet_curves(const Tracing& tracing, int size, const geometry::TabletShape& shape,
                                       double tolerance_m) {
  std::vector<TabletCurve> curves;
  for (const Branch& b : tracing.branches) {
    TabletCurve piece;
    bool cut = false;
    const auto finish = [&] {
      if (piece.points.size() > 1) {
        piece.statement = b.statement;
        piece.points = simplified(piece.points, tolerance_m);
        curves.push_back(std::move(piece));
      }
      piece = TabletCurve{};
    };
    const std::size_t count = b.points.size();
    for (std::size_t i = 0; i + 1 < count + (b.closed ? 1 : 0); ++i) {
      const PlatePoint p{b.points[i].u, b.points[i].v};
      const CurvePoint& next = b.points[(i + 1) % count];
      const PlatePoint q{next.u, next.v};
      const auto inside = part_inside(p, q);
      if (!inside) {
        cut = true;
        finish();
        continue;
      }
      const auto at = [&](double share) {
        return tablet_place({p.u + (q.u - p.u) * share, p.v + (q.v - p.v) * share}, size, shape);
      };
      if (inside->first > 0) {
        cut = true;
        finish();
      }
      if (piece.points.empty()) piece.points.push_back(at(inside->first));
      piece.points.push_back(at(inside->second));
      if (inside->second < 1) {
        cut = true;
        finish();
      }
    }
    piece.closed = b.closed && !cut;
    finish();
  }
  for (const Dot& d : tracing.dots) {
    if (d.at.u < 0 || d.at.u > 1 || d.at.v < 0 || d.at.v > 1) continue;
    const TabletPoint p = tablet_place(d.at, size, shape);
    curves.push_back({d.statement, false, {p, {p.x + 1e-6, p.y}}});
  }
  return curves;
}

std::optional<CurvePlace> nearest_place(const Tracing& tracing, PlatePoint hand, int statement) {
  std::optional<CurvePlace> best;
  for (std::size_t b = 0; b < tracing.branches.size(); ++b) {
    const Branch& branch = tracing.branches[b];
    if (statement >= 0 && branch.statement != statement) continue;
    const std::size_t pieces = piece_count(branch);
    for (std::size_t i = 0; i < pieces; ++i) {
      const auto [p, q] = piece_of(branch, i);
      const double du = q.u - p.u;
      const double dv = q.v - p.v;
      const double length2 = du * du + dv * dv;
      const double share =
          length2 > 0 ? std::clamp(((hand.u - p.u) * du + (hand.v - p.v) * dv) / length2, 0.0, 1.0) : 0.0;
      const PlatePoint at{p.u + share * du, p.v + share * dv};
      const double distance = std::hypot(at.u - hand.u, at.v - hand.v);
      if (!best || distance < best->distance) best = CurvePlace{b, i, at, distance};
    }
  }
  return best;
}

CurvePlace step_along(const Tracing& tracing, const CurvePlace& from, double distance) {
  const Branch& branch = tracing.branches[from.branch];
  const std::size_t pieces = piece_count(branch);
  CurvePlace place = from;
  double left = std::abs(distance);
  // Twice round is enough for any step of a hand.
  for (std::size_t moves = 0; moves < 2 * pieces + 2; ++moves) {
    const auto [p, q] = piece_of(branch, place.piece);
    const PlatePoint goal = distance < 0 ? p : q;
    const double length = std::hypot(goal.u - place.at.u, goal.v - place.at.v);
    if (length >= left && length > 0) {
      place.at.u += (goal.u - place.at.u) * left / length;
      place.at.v += (goal.v - place.at.v) * left / length;
      break;
    }
    left -= length;
    place.at = goal;
    const bool at_end = distance < 0 ? place.piece == 0 : place.piece + 1 == pieces;
    if (at_end && !branch.closed) break;
    place.piece = distance < 0 ? (place.piece + pieces - 1) % pieces : (place.piece + 1) % pieces;
  }
  place.distance = 0;
  return place;
}

CurveFeel feel_of(int statement) {
  constexpr std::array<CurveFeel, 4> kFeels{{{0.05, 0}, {0.45, 0.012}, {0.25, 0.020}, {0.65, 0.007}}};
  return kFeels[static_cast<std::size_t>(std::max(0, statement)) % kFeels.size()];
}

}  // namespace nazori::functions
