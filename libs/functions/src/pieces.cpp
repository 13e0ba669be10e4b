// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "nazori/functions/points.h"

namespace nazori::functions {
namespace {

// Lines whose ends are this near belong together, in plate units: far below a groove's width, well above the
// tolerance of drawn lines.
constexpr double kJoined = 4e-4;
constexpr int kCells = 1024;

struct Line {
  PlatePoint p, q;
};

/// The part of a line inside the window.
std::optional<Line> clipped(const Line& line) {
  double first = 0;
  double last = 1;
  constexpr double kHair = 1e-9;
  for (const auto& [from, to] : {std::pair{line.p.u, line.q.u}, std::pair{line.p.v, line.q.v}}) {
    if (from == to) {
      if (from < -kHair || from > 1 + kHair) return std::nullopt;
      continue;
    }
    const double a = (-kHair - from) / (to - from);
    const double b = (1 + kHair - from) / (to - from);
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  if (!(first <= last)) return std::nullopt;
  const auto at = [&](double share) {
    return PlatePoint{line.p.u + (line.q.u - line.p.u) * share, line.p.v + (line.q.v - line.p.v) * share};
  };
  return Line{first == 0 ? line.p : at(first), last == 1 ? line.q : at(last)};
}

double distance(PlatePoint p, const Line& line) {
  const double du = line.q.u - line.p.u;
  const double dv = line.q.v - line.p.v;
  const double square = du * du + dv * dv;
  const double share =
      square > 0 ? std::clamp(((p.u - line.p.u) * du + (p.v - line.p.v) * dv) / square, 0.0, 1.0) : 0;
  return std::hypot(p.u - line.p.u - share * du, p.v - line.p.v - share * dv);
}

double side(PlatePoint p, const Line& line) {
  return (line.q.u - line.p.u) * (p.v - line.p.v) - (line.q.v - line.p.v) * (p.u - line.p.u);
}

bool meet(const Line& a, const Line& b) {
  if (side(a.p, b) * side(a.q, b) < 0 && side(b.p, a) * side(b.q, a) < 0) return true;
  return std::min({distance(a.p, b), distance(a.q, b), distance(b.p, a), distance(b.q, a)}) <= kJoined;
}

class Groups {
 public:
  std::size_t add() {
    parent_.push_back(parent_.size());
    return parent_.size() - 1;
  }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }
  int count() {
    int n = 0;
    for (std::size_t i = 0; i < parent_.size(); ++i) n += root(i) == i ? 1 : 0;
    return n;
  }

 private:
  std::vector<std::size_t> parent_;
};

class PieceCounter {
 public:
  PieceCounter(const Tracing& tracing, int statement) : tracing_(tracing), statement_(statement) {}

  int run() {
    for (const Branch& b : tracing_.branches) {
      if (b.statement == statement_) add(b);
    }
    for (const Bar& b : tracing_.bars) {
      if (b.statement == statement_) add_alone({b.from, b.to});
    }
    for (const Dot& d : tracing_.dots) {
      if (d.statement == statement_) add_alone({d.at, d.at});
    }
    join_lines();
    join_loose_ends();
    join_fills();
    return is_open_region() ? std::max(groups_.count(), separate_areas()) : groups_.count();
  }

 private:
  struct Part {
    Line line;
    std::size_t group;
  };
  /// The pieces of a branch inside the window are one after the other.
  void add(const Branch& branch) {
    std::optional<std::size_t> group;
    PlatePoint last{};
    for (std::size_t i = 0; i + 1 < branch.points.size(); ++i) {
      const CurvePoint& p = branch.points[i];
      const CurvePoint& q = branch.points[i + 1];
      const auto inside = clipped({{p.u, p.v}, {q.u, q.v}});
      if (!inside) {
        group.reset();
        continue;
      }
      if (!group || std::hypot(inside->p.u - last.u, inside->p.v - last.v) > 1e-9) group = groups_.add();
      last = inside->q;
      parts_.push_back({*inside, *group});
      const bool is_alone = branch.points.size() == 2 && std::hypot(q.u - p.u, q.v - p.v) < kJoined;
      if (is_alone && !branch.has_parameter && !branch.boundary) tips_.push_back(parts_.back());
      const bool is_loose = !branch.has_parameter && !branch.boundary && !branch.closed;
      const auto is_at = [](PlatePoint a, const CurvePoint& b) { return a.u == b.u && a.v == b.v; };
      if (is_loose && i == 0 && is_at(inside->p, p)) ends_.emplace_back(inside->p, *group);
      if (is_loose && i + 2 == branch.points.size() && is_at(inside->q, q))
        ends_.emplace_back(inside->q, *group);
    }
  }

  void add_alone(const Line& line) {
    if (const auto inside = clipped(line)) parts_.push_back({*inside, groups_.add()});
  }

  static int cell(double c) { return std::clamp(static_cast<int>(std::floor(c * kCells)), 0, kCells - 1); }

  /// Calls visit(cell) for every cell that the line, or its surroundings of kJoined, can touch.
  template <class Visit>
  static void cells_of(const Line& line, const Visit& visit) {
    const double length = std::max(std::abs(line.q.u - line.p.u), std::abs(line.q.v - line.p.v));
    const int steps = static_cast<int>(length * kCells) + 1;
    int last_r0 = -1, last_r1 = -1, last_c0 = -1, last_c1 = -1;
    for (int k = 0; k < steps; ++k) {
      const auto at = [&](double share) {
        return PlatePoint{line.p.u + (line.q.u - line.p.u) * share, line.p.v + (line.q.v - line.p.v) * share};
      };
      const PlatePoint a = at(static_cast<double>(k) / steps);
      const PlatePoint b = at(static_cast<double>(k + 1) / steps);
      const int c0 = cell(std::min(a.u, b.u) - kJoined);
      const int c1 = cell(std::max(a.u, b.u) + kJoined);
      const int r0 = cell(std::min(a.v, b.v) - kJoined);
      const int r1 = cell(std::max(a.v, b.v) + kJoined);
      for (int r = r0; r <= r1; ++r) {
        for (int c = c0; c <= c1; ++c) {
          if (r >= last_r0 && r <= last_r1 && c >= last_c0 && c <= last_c1) continue;
          visit(static_cast<std::size_t>(r) * kCells + static_cast<std::size_t>(c));
        }
      }
      last_r0 = r0, last_r1 = r1, last_c0 = c0, last_c1 = c1;
    }
  }

  void join_lines() {
    std::vector<std::pair<std::size_t, std::size_t>> at;  // cell, part
    for (std::size_t i = 0; i < parts_.size(); ++i)
      cells_of(parts_[i].line, [&](std::size_t c) { at.emplace_back(c, i); });
    std::sort(at.begin(), at.end());
    for (std::size_t first = 0; first < at.size();) {
      std::size_t end = first;
      while (end < at.size() && at[end].first == at[first].first) ++end;
      for (std::size_t i = first; i < end; ++i) {
        for (std::size_t j = i + 1; j < end; ++j) {
          const Part& a = parts_[at[i].second];
          const Part& b = parts_[at[j].second];
          if (groups_.root(a.group) != groups_.root(b.group) && meet(a.line, b.line))
            groups_.join(a.group, b.group);
        }
      }
      first = end;
    }
  }

  /// The line of an equation ends nowhere inside its domain: where it is too narrow to be drawn, as in a
  /// cusp, the nearest other line goes on.
  void join_loose_ends() {
    constexpr double kReach = 0.008;
    constexpr std::size_t kMostEnds = 200;
    if (ends_.size() > kMostEnds) return;
    for (const auto& [at, group] : ends_) {
      double best = kReach;
      std::optional<std::size_t> nearest;
      for (const Part& part : parts_) {
        if (groups_.root(part.group) == groups_.root(group)) continue;
        const double d = distance(at, part.line);
        if (d < best) {
          best = d;
          nearest = part.group;
        }
      }
      if (nearest) groups_.join(group, *nearest);
    }
    join_tips();
  }

  /// The tip of a narrow cusp is drawn as a short line of its own, where both arms are nearer to each other
  /// than a cell for a long way.
  void join_tips() {
    constexpr double kReach = 0.15;
    for (const Part& tip : tips_) {
      double best = kReach;
      std::optional<std::size_t> nearest;
      for (const Part& part : parts_) {
        if (groups_.root(part.group) == groups_.root(tip.group)) continue;
        const double d = distance(tip.line.p, part.line);
        if (d < best) {
          best = d;
          nearest = part.group;
        }
      }
      if (nearest) groups_.join(tip.group, *nearest);
    }
  }

  /// Areas without their borders that touch in a point only, as x y > 0: as many as there are without the
  /// cells of the borders. What is narrower than some cells is not told apart.
  [[nodiscard]] int separate_areas() const {
    std::vector<bool> is_inside(static_cast<std::size_t>(kCells) * kCells, false);
    const auto index = [](int r, int c) {
      return static_cast<std::size_t>(r) * kCells + static_cast<std::size_t>(c);
    };
    const auto last = [](double high) { return cell(std::nextafter(high, 0.0)); };
    for (const Fill& f : tracing_.fills) {
      if (f.statement != statement_ || f.high.u <= 0 || f.low.u >= 1 || f.high.v <= 0 || f.low.v >= 1)
        continue;
      for (int r = cell(f.low.v); r <= last(f.high.v); ++r) {
        for (int c = cell(f.low.u); c <= last(f.high.u); ++c) is_inside[index(r, c)] = true;
      }
    }
    for (const Part& part : parts_) cells_of(part.line, [&](std::size_t i) { is_inside[i] = false; });
    constexpr int kLeastCells = 24;
    int count = 0;
    std::vector<std::pair<int, int>> open;
    for (int row = 0; row < kCells; ++row) {
      for (int column = 0; column < kCells; ++column) {
        int size = 0;
        const auto visit = [&](int r, int c) {
          if (r < 0 || c < 0 || r >= kCells || c >= kCells || !is_inside[index(r, c)]) return;
          is_inside[index(r, c)] = false;
          ++size;
          open.emplace_back(r, c);
        };
        visit(row, column);
        while (!open.empty()) {
          const auto [r, c] = open.back();
          open.pop_back();
          visit(r + 1, c);
          visit(r - 1, c);
          visit(r, c + 1);
          visit(r, c - 1);
        }
        count += size >= kLeastCells ? 1 : 0;
      }
    }
    return count;
  }

  /// Whether no border belongs to the region.
  [[nodiscard]] bool is_open_region() const {
    const bool has_fill = std::any_of(tracing_.fills.begin(), tracing_.fills.end(),
                                      [this](const Fill& f) { return f.statement == statement_; });
    return has_fill &&
           std::all_of(tracing_.branches.begin(), tracing_.branches.end(), [this](const Branch& b) {
             return b.statement != statement_ || (b.boundary && b.strict);
           });
  }

  /// Areas touch where they cover neighbouring cells, and the lines on their border belong to them.
  void join_fills() {
    constexpr std::size_t kNone = static_cast<std::size_t>(-1);
    std::vector<std::size_t> owner;
    for (const Fill& f : tracing_.fills) {
      if (f.statement != statement_ || f.high.u < 0 || f.low.u > 1 || f.high.v < 0 || f.low.v > 1) continue;
      if (owner.empty()) owner.assign(static_cast<std::size_t>(kCells) * kCells, kNone);
      const std::size_t group = groups_.add();
      for (int r = cell(f.low.v); r <= cell(f.high.v); ++r) {
        for (int c = cell(f.low.u); c <= cell(f.high.u); ++c) {
          auto& o = owner[static_cast<std::size_t>(r) * kCells + static_cast<std::size_t>(c)];
          if (o != kNone) groups_.join(o, group);
          o = group;
        }
      }
    }
    if (owner.empty()) return;
    const auto at = [&](int r, int c) -> std::size_t {
      return r < 0 || c < 0 || r >= kCells || c >= kCells
                 ? kNone
                 : owner[static_cast<std::size_t>(r) * kCells + static_cast<std::size_t>(c)];
    };
    for (int r = 0; r < kCells; ++r) {
      for (int c = 0; c < kCells; ++c) {
        if (at(r, c) == kNone) continue;
        for (const auto& [dr, dc] : {std::pair{0, 1}, std::pair{1, 0}}) {
          if (at(r + dr, c + dc) != kNone) groups_.join(at(r, c), at(r + dr, c + dc));
        }
      }
    }
    for (const Part& part : parts_) {
      cells_of(part.line, [&](std::size_t i) {
        const int r = static_cast<int>(i / kCells);
        const int c = static_cast<int>(i % kCells);
        // Boxes that the border crosses are undecided: it is up to some cells away from those that are
        // filled.
        for (int dr = -4; dr <= 4; ++dr) {
          for (int dc = -4; dc <= 4; ++dc) {
            if (at(r + dr, c + dc) != kNone) groups_.join(at(r + dr, c + dc), part.group);
          }
        }
      });
    }
  }

  const Tracing& tracing_;
  int statement_;
  Groups groups_;
  std::vector<Part> parts_;
  std::vector<Part> tips_;                                // single short lines of equations
  std::vector<std::pair<PlatePoint, std::size_t>> ends_;  // of lines of equations, inside the window
};

}  // namespace

int pieces_of(const Tracing& tracing, int statement) { return PieceCounter(tracing, statement).run(); }

int pieces(const Plot& plot, const Tracing& tracing) {
  // A curve that is shown alone keeps its index in the whole plot.
  int last = static_cast<int>(plot.statements.size()) - 1;
  for (const Branch& b : tracing.branches) last = std::max(last, b.statement);
  int n = 0;
  for (int i = 0; i <= last; ++i) n += pieces_of(tracing, i);
  return n;
}

}  // namespace nazori::functions
