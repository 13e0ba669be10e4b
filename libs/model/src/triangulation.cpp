// SPDX-License-Identifier: Apache-2.0
#include "triangulation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace nazori::model {
namespace {

std::int64_t twice_area(GridSample a, GridSample b, GridSample c) {
  return static_cast<std::int64_t>(b.column - a.column) * (c.row - a.row) -
         static_cast<std::int64_t>(b.row - a.row) * (c.column - a.column);
}

/// Whether d lies inside the circle through the corners of a counter-clockwise triangle.
bool is_in_circle(GridSample a, GridSample b, GridSample c, GridSample d) {
  const std::int64_t ax = a.column - d.column;
  const std::int64_t ay = a.row - d.row;
  const std::int64_t bx = b.column - d.column;
  const std::int64_t by = b.row - d.row;
  const std::int64_t cx = c.column - d.column;
  const std::int64_t cy = c.row - d.row;
  const std::int64_t aa = ax * ax + ay * ay;
  const std::int64_t bb = bx * bx + by * by;
  const std::int64_t cc = cx * cx + cy * cy;
  return ax * (by * cc - bb * cy) - ay * (bx * cc - bb * cx) + aa * (bx * cy - by * cx) > 0;
}

std::int64_t floor_div(std::int64_t a, std::int64_t b) {
  return a >= 0 ? a / b : -((-a + b - 1) / b);  // b > 0
}

}  // namespace

Triangulation::Triangulation(int columns, int rows, std::span<const float> heights)
    : columns_(columns), heights_(heights) {
  assert(columns >= 2 && rows >= 2);
  samples_ = {{0, 0}, {columns - 1, 0}, {columns - 1, rows - 1}, {0, rows - 1}};
  triangles_ = {{{0, 1, 2}, {-1, 1, -1}}, {{0, 2, 3}, {-1, -1, 0}}};
  farthest_.resize(2);
  version_.resize(2);
  is_changed_.assign(2, true);
  changed_ = {0, 1};
}

void Triangulation::set(std::int32_t triangle, const Triangle& value) {
  const auto i = static_cast<std::size_t>(triangle);
  if (i == triangles_.size()) {
    triangles_.push_back(value);
    farthest_.emplace_back();
    version_.push_back(0);
    is_changed_.push_back(false);
  } else {
    triangles_[i] = value;
  }
  if (!is_changed_[i]) {
    is_changed_[i] = true;
    changed_.push_back(triangle);
  }
}

void Triangulation::relink(std::int32_t triangle, std::int32_t from, std::int32_t to) {
  if (triangle < 0) return;
  for (std::int32_t& neighbour : tri(triangle).across) {
    if (neighbour == from) {
      neighbour = to;
      return;
    }
  }
  assert(false);
}

void Triangulation::split(std::int32_t triangle, std::int32_t p) {
  const Triangle old = tri(triangle);
  const auto [a, b, c] = old.corner;
  const std::int32_t t0 = triangle;
  const auto t1 = static_cast<std::int32_t>(triangles_.size());
  const std::int32_t t2 = t1 + 1;
  set(t0, {{p, a, b}, {old.across[2], t1, t2}});
  set(t1, {{p, b, c}, {old.across[0], t2, t0}});
  set(t2, {{p, c, a}, {old.across[1], t0, t1}});
  relink(old.across[0], t0, t1);
  relink(old.across[1], t0, t2);
  unsettled_ = {t0, t1, t2};
}

void Triangulation::split_edge(std::int32_t triangle, int opposite, std::int32_t p) {
  const Triangle old = tri(triangle);
  const auto corner = [](const Triangle& t, int i) { return t.corner[static_cast<std::size_t>(i % 3)]; };
  const auto beyond = [](const Triangle& t, int i) { return t.across[static_cast<std::size_t>(i % 3)]; };
  const std::int32_t a = corner(old, opposite);
  const std::int32_t b = corner(old, opposite + 1);
  const std::int32_t c = corner(old, opposite + 2);
  const std::int32_t other = beyond(old, opposite);
  const std::int32_t t0 = triangle;
  const auto t1 = static_cast<std::int32_t>(triangles_.size());
  const std::int32_t t2 = other;
  const std::int32_t t3 = other < 0 ? -1 : t1 + 1;
  set(t0, {{p, a, b}, {beyond(old, opposite + 2), t2, t1}});
  set(t1, {{p, c, a}, {beyond(old, opposite + 1), t0, t3}});
  relink(beyond(old, opposite + 1), t0, t1);
  unsettled_ = {t0, t1};
  if (other < 0) return;
  const Triangle far = tri(other);
  const int q = far.across[0] == triangle ? 0 : far.across[1] == triangle ? 1 : 2;
  // The corners of `far` from q on are q, c, b.
  set(t2, {{p, b, corner(far, q)}, {beyond(far, q + 1), t3, t0}});
  set(t3, {{p, corner(far, q), c}, {beyond(far, q + 2), t1, t2}});
  relink(beyond(far, q + 2), t2, t3);
  unsettled_.push_back(t2);
  unsettled_.push_back(t3);
}

void Triangulation::legalise() {
  while (!unsettled_.empty()) {
    const std::int32_t t = unsettled_.back();
    unsettled_.pop_back();
    const Triangle here = tri(t);
    const std::int32_t n = here.across[0];
    if (n < 0) continue;
    const Triangle there = tri(n);
    const std::size_t j = there.across[0] == t ? 0 : there.across[1] == t ? 1 : 2;
    const std::int32_t q = there.corner[j];
    const auto [p, b, c] = here.corner;
    if (!is_in_circle(at(p), at(b), at(c), at(q))) continue;
    // The corners of `there` from q on are q, c, b.
    const std::int32_t beyond_bq = there.across[(j + 1) % 3];
    const std::int32_t beyond_qc = there.across[(j + 2) % 3];
    set(t, {{p, b, q}, {beyond_bq, n, here.across[2]}});
    set(n, {{p, q, c}, {beyond_qc, here.across[1], t}});
    relink(beyond_bq, n, t);
    relink(here.across[1], t, n);
    unsettled_.push_back(t);
    unsettled_.push_back(n);
  }
}

void Triangulation::insert_into(std::int32_t triangle, GridSample sample) {
  const auto p = static_cast<std::int32_t>(samples_.size());
  const auto corner = tri(triangle).corner;
  samples_.push_back(sample);
  int on_edge = -1;
  for (int i = 0; i < 3; ++i) {
    if (twice_area(at(corner[static_cast<std::size_t>((i + 1) % 3)]),
                   at(corner[static_cast<std::size_t>((i + 2) % 3)]), sample) == 0)
      on_edge = i;
  }
  if (on_edge >= 0) {
    split_edge(triangle, on_edge, p);
  } else {
    split(triangle, p);
  }
  legalise();
}

std::int32_t Triangulation::locate(GridSample sample) const {
  std::int32_t t = last_found_;
  for (;;) {
    const Triangle& triangle = tri(t);
    std::int32_t next = t;
    for (std::size_t i = 0; i < 3; ++i) {
      if (twice_area(at(triangle.corner[(i + 1) % 3]), at(triangle.corner[(i + 2) % 3]), sample) < 0)
        next = triangle.across[i];
    }
    if (next == t) break;
    t = next;
  }
  last_found_ = t;
  return t;
}

void Triangulation::insert(GridSample sample) {
  const std::int32_t t = locate(sample);
  for (const std::int32_t corner : tri(t).corner) {
    if (at(corner) == sample) return;
  }
  insert_into(t, sample);
}

Triangulation::Farthest Triangulation::farthest_in(const Triangle& triangle) const {
  const GridSample a = at(triangle.corner[0]);
  const GridSample b = at(triangle.corner[1]);
  const GridSample c = at(triangle.corner[2]);
  const double area = static_cast<double>(twice_area(a, b, c));
  const double za = height(a);
  const double zb = height(b) - za;
  const double zc = height(c) - za;
  const double by_column = (zb * (c.row - a.row) - zc * (b.row - a.row)) / area;
  const double by_row = (zc * (b.column - a.column) - zb * (c.column - a.column)) / area;

  Farthest best;
  const int last_row = std::max({a.row, b.row, c.row});
  for (int row = std::min({a.row, b.row, c.row}); row <= last_row; ++row) {
    std::int64_t low = std::min({a.column, b.column, c.column});
    std::int64_t high = std::max({a.column, b.column, c.column});
    for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
      // The sample lies left of the edge where dx (row - from.row) - dy (column - from.column) >= 0.
      const std::int64_t dy = to.row - from.row;
      const std::int64_t reach = static_cast<std::int64_t>(to.column - from.column) * (row - from.row);
      if (dy > 0) high = std::min(high, from.column + floor_div(reach, dy));
      if (dy < 0) low = std::max(low, from.column - floor_div(reach, -dy));
    }
    const float* const heights = heights_.data() + static_cast<std::ptrdiff_t>(row) * columns_;
    const double start = za + by_row * (row - a.row) - by_column * a.column;
    for (std::int64_t column = low; column <= high; ++column) {
      const auto error =
          static_cast<float>(std::abs(start + by_column * static_cast<double>(column) - heights[column]));
      if (error > best.error) best = {error, {static_cast<int>(column), row}};
    }
  }
  return best;
}

void Triangulation::examine_changed() {
  for (const std::int32_t t : changed_) {
    const auto i = static_cast<std::size_t>(t);
    is_changed_[i] = false;
    farthest_[i] = farthest_in(triangles_[i]);
    queue_.push({farthest_[i].error, t, ++version_[i]});
  }
  changed_.clear();
}

double Triangulation::refine(double tolerance, std::size_t most_triangles) {
  for (;;) {
    examine_changed();
    while (!queue_.empty() &&
           version_[static_cast<std::size_t>(queue_.top().triangle)] != queue_.top().version)
      queue_.pop();
    if (queue_.empty()) return 0;
    const Waiting worst = queue_.top();
    if (worst.error <= tolerance || triangles_.size() + 2 > most_triangles) return worst.error;
    queue_.pop();
    const GridSample sample = farthest_[static_cast<std::size_t>(worst.triangle)].sample;
    // Rounding can make a corner seem to be off the surface by nothing.
    bool is_corner = false;
    for (const std::int32_t corner : tri(worst.triangle).corner)
      is_corner = is_corner || at(corner) == sample;
    if (!is_corner) insert_into(worst.triangle, sample);
  }
}

}  // namespace nazori::model
