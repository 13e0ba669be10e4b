// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "plane_tracer.h"

namespace nazori::functions {
namespace {

/// Numbers points so that points nearer than the tolerance share a number.
class PointIndex {
 public:
  PointIndex(double tolerance, std::size_t expected) : tolerance_(tolerance), cell_(kCell * tolerance) {
    numbers_.reserve(expected);
  }

  std::size_t number_of(PlatePoint p) {
    const auto cell = [this](double c) { return static_cast<std::int64_t>(std::floor(c / cell_)); };
    for (std::int64_t cu = cell(p.u - tolerance_); cu <= cell(p.u + tolerance_); ++cu) {
      for (std::int64_t cv = cell(p.v - tolerance_); cv <= cell(p.v + tolerance_); ++cv) {
        const auto [first, last] = numbers_.equal_range(key(cu, cv));
        for (auto found = first; found != last; ++found) {
          const PlatePoint& q = points[found->second];
          if (std::hypot(p.u - q.u, p.v - q.v) <= tolerance_) return found->second;
        }
      }
    }
    points.push_back(p);
    numbers_.emplace(key(cell(p.u), cell(p.v)), points.size() - 1);
    return points.size() - 1;
  }

  std::vector<PlatePoint> points;

 private:
  static std::uint64_t key(std::int64_t a, std::int64_t b) {
    return static_cast<std::uint64_t>(a) * 0x9E3779B97F4A7C15ULL ^
           static_cast<std::uint64_t>(b) * 0xC2B2AE3D27D4EB4FULL;
  }
  // So many times the tolerance that most points have to look into one cell only.
  static constexpr double kCell = 16;
  double tolerance_;
  double cell_;
  std::unordered_multimap<std::uint64_t, std::size_t> numbers_;
};

}  // namespace

std::vector<std::vector<PlatePoint>> stitched(const std::vector<PlaneSolution::Segment>& segments,
                                              double tolerance) {
  PointIndex index(tolerance, 2 * segments.size());
  struct Edge {
    std::size_t a;
    std::size_t b;
    bool used = false;
  };
  std::vector<Edge> edges;
  std::vector<std::vector<PlatePoint>> lines;
  for (const auto& s : segments) {
    const std::size_t a = index.number_of(s.from);
    const std::size_t b = index.number_of(s.to);
    if (a != b) {
      edges.push_back({a, b});
    } else {
      lines.push_back({s.from, s.to});
    }
  }
  std::vector<std::vector<std::size_t>> at(index.points.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    at[edges[e].a].push_back(e);
    at[edges[e].b].push_back(e);
  }
  const auto walk = [&](std::size_t from) {
    while (true) {
      const auto free =
          std::find_if(at[from].begin(), at[from].end(), [&](std::size_t e) { return !edges[e].used; });
      if (free == at[from].end()) return;
      std::vector<PlatePoint> line{index.points[from]};
      std::size_t e = *free;
      std::size_t here = from;
      while (true) {
        edges[e].used = true;
        here = edges[e].a == here ? edges[e].b : edges[e].a;
        line.push_back(index.points[here]);
        if (at[here].size() != 2 || here == from) break;
        const std::size_t next = at[here][0] == e ? at[here][1] : at[here][0];
        if (edges[next].used) break;
        e = next;
      }
      lines.push_back(std::move(line));
    }
  };
  for (std::size_t p = 0; p < at.size(); ++p) {
    if (at[p].size() != 2) walk(p);
  }
  for (std::size_t p = 0; p < at.size(); ++p) walk(p);
  return lines;
}

}  // namespace nazori::functions
