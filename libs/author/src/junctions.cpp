// SPDX-License-Identifier: Apache-2.0
#include "junctions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "nazori/geometry/polyline.h"

namespace nazori::author {
namespace {

using geometry::GridPoint;
using Line = geometry::Polyline<geometry::GridFrame>;

GridPoint unit(GridPoint v) {
  const double l = geometry::length(v);
  return l > 0 ? v * (1 / l) : GridPoint{};
}

/// One end of an arm.
struct End {
  std::size_t arm = 0;
  bool at_front = true;
};

/// The end of an arm in a junction.
struct Stub {
  End end;
  GridPoint at;
  GridPoint out;  ///< direction away from the junction
  double length = 0;
};

Stub stub_of(const Arm& arm, End end, const Junction& junction) {
  // Far enough to look over the stairs of the pixels, near enough not to see the next bend.
  const auto look = static_cast<std::size_t>(std::clamp(1.2 * junction.radius, 7.0, 24.0));
  const std::size_t far = std::min(look, arm.points.size() - 1);
  const auto at = [&](std::size_t i) {
    return end.at_front ? arm.points[i] : arm.points[arm.points.size() - 1 - i];
  };
  Stub stub{end, at(0), unit(at(far) - at(0)), static_cast<double>(arm.points.size())};
  // A short arm says little about its direction; the junction says the rest.
  if (far < 5) stub.out = unit(at(far) - junction.at);
  return stub;
}

/// How much a line bends that goes on from one stub in the other [rad].
double bend(const Stub& a, const Stub& b) {
  const double turn = geometry::angle_between(a.out * -1, b.out);
  const GridPoint gap = b.at - a.at;
  if (geometry::length(gap) < 4) return turn;
  // Beside the directions the offset: parallel lines do not go on in each other.
  const double offset =
      std::max(geometry::angle_between(a.out * -1, gap), geometry::angle_between(gap, b.out));
  return 0.5 * turn + 0.5 * offset;
}

/// The short arm of a junction into the round end of a stroke whose hook is another arm.
struct HookedEnd {
  std::size_t rest = 0;  ///< of the stubs
  std::size_t hook = 0;
};

/// Where a hook turns back sharply, its groove and that of its stroke are one ink for a while. Their middle
/// lines then meet before the end of the stroke.
std::optional<HookedEnd> hooked_end(const std::vector<Stub>& stubs, const Arms& all,
                                    const Junction& junction) {
  constexpr double kLongestHook = 14 * kInkPerUnit;
  constexpr double kLongestRest = 2.0;  // radii
  if (stubs.size() != 3) return {};
  const auto arm = [&](std::size_t k) -> const Arm& { return all.arms[stubs[k].end.arm]; };
  const auto is_free = [&](std::size_t k) { return (stubs[k].end.at_front ? arm(k).to : arm(k).from) < 0; };
  for (std::size_t rest = 0; rest < 3; ++rest)
    for (std::size_t hook = 0; hook < 3; ++hook) {
      if (hook == rest || !is_free(rest) || !is_free(hook)) continue;
      if (arm(rest).thins_out || stubs[rest].length > kLongestRest * junction.radius) continue;
      if (!arm(hook).thins_out || stubs[hook].length > kLongestHook) continue;
      return HookedEnd{rest, hook};
    }
  return {};
}

}  // namespace

Arms arms_of(const InkGraph& graph, const InkMap& map, double reach) {
  std::vector<int> junction_of(graph.nodes.size());
  std::iota(junction_of.begin(), junction_of.end(), 0);
  const auto root = [&](int n) {
    while (junction_of[static_cast<std::size_t>(n)] != n) n = junction_of[static_cast<std::size_t>(n)];
    return n;
  };
  const auto radius = [&](int n) {
    return n < 0 ? 0.0 : reach * graph.nodes[static_cast<std::size_t>(n)].radius;
  };
  const auto is_inside = [&](const Branch& b) {
    return b.from >= 0 && b.to >= 0 && static_cast<double>(b.points.size()) < radius(b.from) + radius(b.to);
  };
  for (const Branch& b : graph.branches)
    if (is_inside(b)) junction_of[static_cast<std::size_t>(root(b.from))] = root(b.to);

  Arms out;
  std::vector<int> number(graph.nodes.size(), -1);
  std::vector<int> members;
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
    const auto r = static_cast<std::size_t>(root(static_cast<int>(n)));
    if (number[r] < 0) {
      number[r] = static_cast<int>(out.junctions.size());
      out.junctions.push_back({});
      members.push_back(0);
    }
    const auto j = static_cast<std::size_t>(number[r]);
    out.junctions[j].at = out.junctions[j].at + graph.nodes[n].at;
    out.junctions[j].radius = std::max(out.junctions[j].radius, graph.nodes[n].radius);
    ++members[j];
  }
  for (std::size_t j = 0; j < members.size(); ++j)
    out.junctions[j].at = out.junctions[j].at * (1.0 / static_cast<double>(members[j]));

  for (const Branch& b : graph.branches) {
    if (is_inside(b)) continue;
    const auto count = static_cast<std::ptrdiff_t>(b.points.size());
    const auto cut = [&](int node, bool front) {
      std::ptrdiff_t n = 0;
      if (node < 0) return n;
      const GridPoint at = graph.nodes[static_cast<std::size_t>(node)].at;
      while (n < count && geometry::distance(b.points[static_cast<std::size_t>(front ? n : count - 1 - n)],
                                             at) < radius(node))
        ++n;
      return n;
    };
    std::ptrdiff_t first = cut(b.from, true);
    std::ptrdiff_t last = count - cut(b.to, false);
    if (last - first < 3) {
      // What is left of it is too short: keep the part that is farthest from its junctions.
      first = b.from < 0 ? 0 : b.to < 0 ? std::max<std::ptrdiff_t>(0, count - 3) : count / 2;
      last = b.to < 0 ? count : b.from < 0 ? std::min<std::ptrdiff_t>(count, 3) : count / 2 + 1;
    }
    const auto junction = [&](int node) {
      return node < 0 ? -1 : number[static_cast<std::size_t>(root(node))];
    };
    Arm arm{{b.points.begin() + first, b.points.begin() + last}, junction(b.from), junction(b.to), b.is_ring};
    if (b.front_tip && b.front_tip->thins_out) arm.points.insert(arm.points.begin(), b.front_tip->at);
    if (b.back_tip && b.back_tip->thins_out) arm.points.push_back(b.back_tip->at);
    if ((b.from < 0) != (b.to < 0)) {
      constexpr double kThin = 0.5;
      const GridPoint end = b.from < 0 ? b.points.front() : b.points.back();
      arm.thins_out = static_cast<double>(between(map.distance.distance, end)) <
                      kThin * graph.nodes[static_cast<std::size_t>(std::max(b.from, b.to))].radius;
    }
    out.arms.push_back(std::move(arm));
  }
  return out;
}

std::vector<Line> joined(const Arms& all) {
  constexpr double kMostBend = 42 * 3.14159265358979323846 / 180;
  std::vector<std::vector<Stub>> stubs(all.junctions.size());
  for (std::size_t i = 0; i < all.arms.size(); ++i)
    for (const bool at_front : {true, false}) {
      const int j = at_front ? all.arms[i].from : all.arms[i].to;
      if (j >= 0)
        stubs[static_cast<std::size_t>(j)].push_back(
            stub_of(all.arms[i], {i, at_front}, all.junctions[static_cast<std::size_t>(j)]));
    }
  std::vector<std::array<std::optional<End>, 2>> next(all.arms.size());
  std::vector<std::array<std::optional<GridPoint>, 2>> end_at(all.arms.size());
  const auto slot = [](auto& list, End end) -> auto& { return list[end.arm][end.at_front ? 0 : 1]; };
  for (std::size_t j = 0; j < stubs.size(); ++j) {
    struct Pair {
      double cost;
      std::size_t a, b;
    };
    std::vector<Pair> pairs;
    const auto& own = stubs[j];
    const auto hooked = hooked_end(own, all, all.junctions[j]);
    if (hooked) {
      const std::size_t body = 3 - hooked->rest - hooked->hook;
      slot(next, own[body].end) = own[hooked->rest].end;
      slot(next, own[hooked->rest].end) = own[body].end;
      const End turn{own[hooked->rest].end.arm, !own[hooked->rest].end.at_front};
      slot(next, turn) = own[hooked->hook].end;
      slot(next, own[hooked->hook].end) = turn;
      continue;
    }
    for (std::size_t a = 0; a < own.size(); ++a)
      for (std::size_t b = a + 1; b < own.size(); ++b) {
        const double cost = bend(own[a], own[b]);
        if (own.size() == 2 || cost < kMostBend) pairs.push_back({cost, a, b});
      }
    std::sort(pairs.begin(), pairs.end(), [](const Pair& p, const Pair& q) { return p.cost < q.cost; });
    std::vector<std::pair<GridPoint, GridPoint>> through;
    for (const Pair& pair : pairs) {
      auto& a = slot(next, own[pair.a].end);
      auto& b = slot(next, own[pair.b].end);
      if (a || b) continue;
      a = own[pair.b].end;
      b = own[pair.a].end;
      through.emplace_back(own[pair.a].at, own[pair.b].at);
    }
    for (const Stub& stub : own) {
      if (slot(next, stub.end)) continue;
      // It ends where it meets the line that goes through, else beside the middle of the junction.
      GridPoint goal = all.junctions[j].at;
      double least = std::numeric_limits<double>::infinity();
      for (const auto& [from, to] : through) {
        const GridPoint along = to - from;
        const double cross = stub.out.x * along.y - stub.out.y * along.x;
        if (std::abs(cross) < 0.2 * geometry::length(along)) continue;
        const GridPoint gap = from - stub.at;
        const double t = (gap.x * along.y - gap.y * along.x) / cross;  // along `out`
        if (t > 2 || -t > 3 * all.junctions[j].radius || std::abs(t) >= least) continue;
        least = std::abs(t);
        goal = stub.at + stub.out * t;
      }
      if (through.empty()) {
        const double back = std::min(0.0, geometry::dot(goal - stub.at, stub.out));
        const GridPoint beside = stub.at + stub.out * back;
        goal = (goal + beside) * 0.5;
      }
      slot(end_at, stub.end) = goal;
    }
  }

  std::vector<Line> lines;
  std::vector<bool> used(all.arms.size());
  const auto walk = [&](End end) {
    Line line;
    if (const auto& start = slot(end_at, end)) line.push_back(*start);
    while (!used[end.arm]) {
      used[end.arm] = true;
      const Arm& arm = all.arms[end.arm];
      if (end.at_front) {
        line.insert(line.end(), arm.points.begin(), arm.points.end());
      } else {
        line.insert(line.end(), arm.points.rbegin(), arm.points.rend());
      }
      const End other{end.arm, !end.at_front};
      if (const auto& goal = slot(end_at, other)) line.push_back(*goal);
      const auto& follow = slot(next, other);
      if (!follow) break;
      end = *follow;
    }
    lines.push_back(std::move(line));
  };
  for (std::size_t i = 0; i < all.arms.size(); ++i)
    for (const bool at_front : {true, false})
      if (!used[i] && !next[i][at_front ? 0 : 1]) walk({i, at_front});
  for (std::size_t i = 0; i < all.arms.size(); ++i)
    if (!used[i]) {
      walk({i, true});
      lines.back().push_back(lines.back().front());
    }
  return lines;
}

}  // namespace nazori::author
