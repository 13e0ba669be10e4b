// SPDX-License-Identifier: Apache-2.0
#include "snapped.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "nazori/geometry/polyline.h"

namespace nazori::author {
namespace {

using geometry::GlyphPoint;

GlyphPoint unit(GlyphPoint v) {
  const double l = geometry::length(v);
  return l > 0 ? v * (1 / l) : GlyphPoint{};
}

GlyphPoint along_at(const GlyphLine& line, std::size_t i) {
  return unit(line[std::min(i + 1, line.size() - 1)] - line[i - std::min<std::size_t>(i, 1)]);
}

GlyphPoint across(GlyphPoint along) { return {-along.y, along.x}; }

/// For each point of a line how far beside it the middle of its ink is; nothing where there is none.
/// A chain of offsets is chosen whose sum of costs is smallest (dynamic programming).
std::vector<std::optional<double>> offsets_of(const GlyphLine& line, const Ridge& ridge, double gate) {
  constexpr double kStep = 0.25;
  constexpr double kFar = 1.2;        // an offset that far from every middle line costs the most
  constexpr double kNear = 1.0;       // along the line
  constexpr double kParallel = 0.75;  // cosine
  constexpr double kUnsure = 0.35;    // of the gain, beside a junction
  constexpr double kStay = 0.25;      // cost of the largest offset
  constexpr double kBend = 1.6;       // cost of a change by a unit within a unit, squared
  const int half = static_cast<int>(std::lround(gate / kStep));
  const auto states = 2 * static_cast<std::size_t>(half) + 1;
  const auto offset_of = [&](std::size_t s) { return (static_cast<double>(s) - half) * kStep; };
  std::vector<std::vector<double>> cost(line.size(), std::vector<double>(states));
  for (std::size_t i = 0; i < line.size(); ++i) {
    const GlyphPoint along = along_at(line, i);
    const GlyphPoint side = across(along);
    std::vector<double> gain(states);
    for (const RidgePoint& p : ridge.points) {
      const GlyphPoint gap = p.at - line[i];
      const double off = geometry::dot(gap, side);
      if (std::abs(off) > gate + kFar || std::abs(geometry::dot(gap, along)) > kNear) continue;
      const double parallel = std::abs(geometry::dot(p.along, along));
      if (parallel < kParallel) continue;
      for (std::size_t s = 0; s < states; ++s) {
        const double d = std::abs(offset_of(s) - off) / kFar;
        if (d < 1) gain[s] = std::max(gain[s], (p.is_sure ? 1.0 : kUnsure) * parallel * (1 - d * d));
      }
    }
    for (std::size_t s = 0; s < states; ++s)
      cost[i][s] = 1 - gain[s] + kStay * std::pow(offset_of(s) / gate, 2);
  }
  std::vector<std::vector<std::size_t>> from(line.size(), std::vector<std::size_t>(states));
  std::vector<std::vector<double>> sum = cost;
  for (std::size_t i = 1; i < line.size(); ++i) {
    // Around a corner an offset says something else before and after.
    const double turn = geometry::angle_between(along_at(line, i - 1), along_at(line, i));
    const double stiff = turn > 0.35 ? 0.05 : kBend;
    for (std::size_t s = 0; s < states; ++s) {
      double least = std::numeric_limits<double>::infinity();
      const std::size_t first = s - std::min<std::size_t>(s, turn > 0.35 ? states : 8);
      const std::size_t last = std::min(states - 1, s + (turn > 0.35 ? states : 8));
      for (std::size_t k = first; k <= last; ++k) {
        const double change = offset_of(s) - offset_of(k);
        const double c = sum[i - 1][k] + stiff * change * change;
        if (c >= least) continue;
        least = c;
        from[i][s] = k;
      }
      sum[i][s] += least;
    }
  }
  std::vector<std::optional<double>> out(line.size());
  std::size_t s =
      static_cast<std::size_t>(std::min_element(sum.back().begin(), sum.back().end()) - sum.back().begin());
  for (std::size_t i = line.size(); i-- > 0;) {
    // The exact offset: that of the middle line next to the chosen one.
    const GlyphPoint along = along_at(line, i);
    const GlyphPoint side = across(along);
    double least = kFar / 2;
    for (const RidgePoint& p : ridge.points) {
      const GlyphPoint gap = p.at - line[i];
      if (!p.is_sure || std::abs(geometry::dot(gap, along)) > kNear) continue;
      if (std::abs(geometry::dot(p.along, along)) < kParallel) continue;
      // Straight along the middle line to the place beside the point.
      const double slide = geometry::dot(gap, along) / geometry::dot(p.along, along);
      const double off = geometry::dot(gap - p.along * slide, side);
      if (std::abs(off - offset_of(s)) >= least) continue;
      least = std::abs(off - offset_of(s));
      out[i] = off;
    }
    s = from[i][s];
  }
  return out;
}

/// A place to which an end is drawn, as a whole or only along its line.
struct Goal {
  GlyphPoint at;
  bool only_along = false;
};

/// Moves the points of a line so that those with an offset have it and neighbours move alike.
GlyphLine relaxed(const GlyphLine& line, const std::vector<std::optional<double>>& offsets,
                  const std::optional<Goal>& start, const std::optional<Goal>& end) {
  constexpr double kAlike = 6.0;
  constexpr double kStay = 0.002;
  constexpr double kEnd = 8.0;
  const auto count = static_cast<int>(line.size());
  const int unknowns = 2 * count;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns);
  const auto pull = [&](int i, GlyphPoint direction, double goal, double weight) {
    const double n[2] = {direction.x, direction.y};
    for (int a = 0; a < 2; ++a) {
      for (int b = 0; b < 2; ++b) entries.emplace_back(2 * i + a, 2 * i + b, weight * n[a] * n[b]);
      right[2 * i + a] += weight * n[a] * goal;
    }
  };
  for (int i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    pull(i, {1, 0}, 0, kStay);
    pull(i, {0, 1}, 0, kStay);
    if (offsets[k]) pull(i, across(along_at(line, k)), *offsets[k], 1);
    if (i == 0) continue;
    for (int a = 0; a < 2; ++a) {
      const int p = 2 * (i - 1) + a;
      const int q = 2 * i + a;
      entries.emplace_back(p, p, kAlike);
      entries.emplace_back(q, q, kAlike);
      entries.emplace_back(p, q, -kAlike);
      entries.emplace_back(q, p, -kAlike);
    }
  }
  const auto draw = [&](int i, const std::optional<Goal>& goal) {
    if (!goal) return;
    const GlyphPoint way = goal->at - line[static_cast<std::size_t>(i)];
    const GlyphPoint along = along_at(line, static_cast<std::size_t>(i));
    pull(i, along, geometry::dot(way, along), kEnd);
    if (!goal->only_along) pull(i, across(along), geometry::dot(way, across(along)), kEnd);
  };
  draw(0, start);
  draw(count - 1, end);
  Eigen::SparseMatrix<double> left(unknowns, unknowns);
  left.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(left);
  const Eigen::VectorXd moved = solver.solve(right);
  GlyphLine out = line;
  Eigen::Index x = 0;
  for (GlyphPoint& point : out) {
    point = point + GlyphPoint{moved[x], moved[x + 1]};
    x += 2;
  }
  return out;
}

struct LineEnd {
  std::size_t line = 0;
  bool is_start = true;
};

GlyphPoint end_of(const GlyphLine& line, bool is_start) { return is_start ? line.front() : line.back(); }

GlyphPoint outward(const GlyphLine& line, bool is_start) {
  const std::size_t look = std::min<std::size_t>(4, line.size() - 1);
  return is_start ? unit(line.front() - line[look]) : unit(line.back() - line[line.size() - 1 - look]);
}

/// Whether an end of a line lies on another line: then its ink ends in that of the other.
bool is_on_another(const std::vector<GlyphLine>& lines, std::size_t k, bool is_start, double within) {
  for (std::size_t j = 0; j < lines.size(); ++j)
    if (j != k &&
        geometry::nearest_point<geometry::GlyphFrame>(lines[j], end_of(lines[k], is_start)).distance < within)
      return true;
  return false;
}

/// For each start and end of a line the free end of ink that is its own: [0] the start, [1] the end.
using EndGoals = std::vector<std::array<std::optional<Goal>, 2>>;

void take_free_ends(EndGoals& goals, const std::vector<GlyphLine>& lines, const std::vector<bool>& thins_out,
                    const Ridge& ridge, double reach) {
  struct Pair {
    double cost;
    LineEnd line_end;
    std::size_t ink_end;
  };
  constexpr double kTurn = 0.6;  // cosine
  // An end this close to another line is in its ink [glyph units]; the last part of a sweep is narrow.
  constexpr double kHidden = 1.6;
  constexpr double kHiddenSweep = 4.0;
  std::vector<Pair> pairs;
  for (std::size_t k = 0; k < lines.size(); ++k)
    for (const bool is_start : {true, false})
      for (std::size_t e = 0; e < ridge.ends.size(); ++e) {
        const double hidden = !is_start && thins_out[k] ? kHiddenSweep : kHidden;
        if (ridge.ends[e].touches && is_on_another(lines, k, is_start, hidden)) continue;
        const GlyphPoint out = outward(lines[k], is_start);
        const double same = geometry::dot(out, ridge.ends[e].out);
        const GlyphPoint gap = ridge.ends[e].at - end_of(lines[k], is_start);
        // Ends lie apart along a line more easily than beside it.
        const double off = std::abs(geometry::dot(gap, across(out)));
        const double cost = std::hypot(0.6 * geometry::dot(gap, out), 1.4 * off) + 3 * (1 - same);
        if (same > kTurn && cost < reach) pairs.push_back({cost, {k, is_start}, e});
      }
  std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.cost < b.cost; });
  std::vector<bool> taken(ridge.ends.size());
  for (const Pair& p : pairs) {
    auto& goal = goals[p.line_end.line][p.line_end.is_start ? 0 : 1];
    if (goal || taken[p.ink_end]) continue;
    taken[p.ink_end] = true;
    goal = Goal{ridge.ends[p.ink_end].at};
  }
}

/// Ends without a free end of ink that touch another line: they move with the place that they touch.
void stay_attached(EndGoals& goals, const std::vector<GlyphLine>& before,
                   const std::vector<GlyphLine>& after) {
  constexpr double kTouch = 4.5;
  const EndGoals free = goals;
  for (std::size_t k = 0; k < before.size(); ++k)
    for (const bool is_start : {true, false}) {
      if (free[k][is_start ? 0 : 1]) continue;
      const GlyphPoint end = end_of(before[k], is_start);
      double least = kTouch;
      for (std::size_t j = 0; j < before.size(); ++j) {
        if (j == k) continue;
        for (std::size_t i = 0; i < before[j].size(); ++i) {
          const double d = geometry::distance(before[j][i], end);
          if (d >= least) continue;
          least = d;
          goals[k][is_start ? 0 : 1] = Goal{end + (after[j][i] - before[j][i]), true};
        }
      }
    }
}

}  // namespace

std::vector<Snapped> snapped(const std::vector<GlyphLine>& lines, const std::vector<bool>& thins_out,
                             const Ridge& ridge, double gate) {
  constexpr double kEndReach = 1.6;  // in gates
  EndGoals goals(lines.size());
  std::vector<std::vector<std::optional<double>>> offsets;
  std::vector<GlyphLine> after;
  for (const GlyphLine& line : lines) {
    offsets.push_back(offsets_of(line, ridge, gate));
    after.push_back(relaxed(line, offsets.back(), {}, {}));
  }
  take_free_ends(goals, after, thins_out, ridge, kEndReach * gate);
  for (std::size_t k = 0; k < lines.size(); ++k)
    after[k] = relaxed(lines[k], offsets[k], goals[k][0], goals[k][1]);
  stay_attached(goals, lines, after);
  std::vector<Snapped> out;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    Snapped s{relaxed(lines[k], offsets[k], goals[k][0], goals[k][1]), {}};
    for (const auto& o : offsets[k]) s.is_on_ink.push_back(o.has_value());
    out.push_back(std::move(s));
  }
  return out;
}

}  // namespace nazori::author
