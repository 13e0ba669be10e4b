// SPDX-License-Identifier: Apache-2.0
#include "gaps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace nazori::author {
namespace {

using geometry::GridPoint;

std::size_t pixel(const InkMap& map, GridPoint p) {
  return map.index(static_cast<int>(std::lround(p.x)), static_cast<int>(std::lround(p.y)));
}

/// Where a branch is divided: the last point of its first part and the first of its second one.
struct Gap {
  std::ptrdiff_t before = 0;
  std::ptrdiff_t after = 0;
  std::ptrdiff_t at = 0;          ///< between them
  bool before_thins_out = false;  ///< the first part goes on to `at`
  bool after_thins_out = false;
};

/// The deepest gap of values along a branch that is narrow.
/// @param values  depth or width. @param radius  half of the width [points].
std::optional<Gap> gap_of(const std::vector<double>& values, const std::vector<double>& radius, double most,
                          bool is_groove) {
  constexpr double kReach = 2.5;   // radii on both sides within which it is deep again
  constexpr double kWhole = 0.96;  // of the greatest value: there a stroke ends
  const auto count = static_cast<std::ptrdiff_t>(values.size());
  const auto value = [&](std::ptrdiff_t i) { return values[static_cast<std::size_t>(i)]; };
  std::optional<Gap> best;
  double least = most;
  for (std::ptrdiff_t i = 1; i + 1 < count; ++i) {
    if (value(i) > value(i - 1) || value(i) > value(i + 1)) continue;
    double around = 0;
    for (std::ptrdiff_t k = std::max<std::ptrdiff_t>(0, i - 12); k < std::min(count, i + 13); ++k)
      around = std::max(around, radius[static_cast<std::size_t>(k)]);
    const auto reach = static_cast<std::ptrdiff_t>(kReach * around);
    std::ptrdiff_t left = i;
    for (std::ptrdiff_t k = i; k >= std::max<std::ptrdiff_t>(0, i - reach); --k)
      if (value(k) > value(left)) left = k;
    std::ptrdiff_t right = i;
    for (std::ptrdiff_t k = i; k < std::min(count, i + reach + 1); ++k)
      if (value(k) > value(right)) right = k;
    const double lower = std::min(value(left), value(right));
    if (lower <= 0 || value(i) / lower >= least) continue;
    least = value(i) / lower;
    // A round end is as deep as its stroke within a radius. A sweep falls off more slowly than such an end
    // and reaches into the gap.
    const auto near = static_cast<std::ptrdiff_t>(1.1 * around);
    Gap gap{i, i, i};
    const auto end_from = [&](std::ptrdiff_t step, double whole, std::ptrdiff_t& end, bool& thins_out) {
      for (std::ptrdiff_t k = i; k >= 0 && k < count && std::abs(k - i) <= near; k += step) {
        if (value(k) < kWhole * whole) continue;
        const double r = radius[static_cast<std::size_t>(k)];
        const double share = std::min(1.0, static_cast<double>(std::abs(k - i)) / 2 / std::max(r, 1.0));
        const double round = is_groove ? std::pow(1 - share * share, 2) : std::sqrt(1 - share * share);
        constexpr double kSlower = 0.12;
        end = k;
        thins_out = value((k + i) / 2) > (round + kSlower) * value(k);
        return;
      }
    };
    end_from(-1, value(left), gap.before, gap.before_thins_out);
    end_from(1, value(right), gap.after, gap.after_thins_out);
    best = gap;
  }
  return best;
}

}  // namespace

InkGraph divided_at_gaps(const InkGraph& graph, const InkMap& map) {
  // The least value in a gap, in parts of what is around it.
  const double most = map.is_groove ? 0.93 : 0.72;
  constexpr double kRest = 1.25;  // radii: what is shorter beside a node is the rim of its stroke
  InkGraph out = graph;
  out.branches.clear();
  std::vector<Branch> open = graph.branches;
  while (!open.empty()) {
    Branch branch = std::move(open.back());
    open.pop_back();
    std::vector<double> values;
    std::vector<double> radius;
    const auto add = [&](GridPoint p) {
      radius.push_back(std::max(0.5, static_cast<double>(map.distance.distance[pixel(map, p)]) - 0.5));
      values.push_back(map.is_groove ? static_cast<double>(map.depth[pixel(map, p)]) : radius.back());
    };
    const auto node = [&](int n) -> const Node& { return graph.nodes[static_cast<std::size_t>(n)]; };
    const std::ptrdiff_t first = branch.from >= 0 ? 1 : 0;
    if (branch.from >= 0) add(node(branch.from).at);
    for (const GridPoint p : branch.points) add(p);
    if (branch.to >= 0) add(node(branch.to).at);
    const auto gap = branch.is_ring ? std::nullopt : gap_of(values, radius, most, map.is_groove);
    if (!gap) {
      out.branches.push_back(std::move(branch));
      continue;
    }
    const auto count = static_cast<std::ptrdiff_t>(branch.points.size());
    const std::ptrdiff_t before = std::clamp<std::ptrdiff_t>(gap->before - first + 1, 0, count);
    const std::ptrdiff_t after = std::clamp<std::ptrdiff_t>(gap->after - first, 0, count);
    const auto begin = branch.points.begin();
    const std::ptrdiff_t between = std::clamp<std::ptrdiff_t>(gap->at - first, 0, count - 1);
    const GridPoint tip = branch.points[static_cast<std::size_t>(between)];
    Branch front{{begin, begin + before},
                 branch.from,
                 -1,
                 false,
                 branch.front_tip,
                 TouchingTip{tip, gap->before_thins_out}};
    Branch back{{begin + after, branch.points.end()},
                -1,
                branch.to,
                false,
                TouchingTip{tip, gap->after_thins_out},
                branch.back_tip};
    const auto keep = [&](Branch part, int n) {
      if (part.points.empty()) return;
      if (n >= 0 && static_cast<double>(part.points.size()) < kRest * node(n).radius) return;
      // A part as long as the whole would be divided again and again.
      if (part.points.size() >= branch.points.size()) {
        out.branches.push_back(std::move(part));
        return;
      }
      open.push_back(std::move(part));
    };
    keep(std::move(front), branch.from);
    keep(std::move(back), branch.to);
  }
  return out;
}

}  // namespace nazori::author
