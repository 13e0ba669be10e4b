// SPDX-License-Identifier: Apache-2.0
#include "ink_graph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "skeleton.h"

namespace nazori::author {
namespace {

using geometry::GridPoint;

constexpr std::array<Pixel, 8> kAround{
    {{0, -1}, {1, 0}, {0, 1}, {-1, 0}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}}};

GridPoint place(Pixel p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

double radius_at(const DistanceMap& map, GridPoint p) {
  const double r = static_cast<double>(
      map.distance[map.index(static_cast<int>(std::lround(p.x)), static_cast<int>(std::lround(p.y)))]);
  return std::max(0.0, r - 0.5);
}

class Reader {
 public:
  Reader(InkGraph& graph, const DistanceMap& distance)
      : graph_(graph),
        distance_(distance),
        side_(distance.side),
        node_of_(graph.skeleton.size(), -1),
        done_(graph.skeleton.size()) {}

  void read() {
    for (int y = 0; y < side_; ++y)
      for (int x = 0; x < side_; ++x)
        if (is_set({x, y}) && neighbours({x, y}) > 2 && node_of_[index({x, y})] < 0) add_node({x, y});
    // Lines with an end or a node first; what is left are rings.
    for (const bool rings : {false, true})
      for (int y = 0; y < side_; ++y)
        for (int x = 0; x < side_; ++x) {
          const Pixel p{x, y};
          if (!is_set(p) || node_of_[index(p)] >= 0 || done_[index(p)] != 0) continue;
          if (rings || plain_neighbours(p) < 2) add_branch(p, rings);
        }
  }

 private:
  [[nodiscard]] std::size_t index(Pixel p) const { return distance_.index(p.x, p.y); }
  [[nodiscard]] bool is_set(Pixel p) const {
    return p.x >= 0 && p.y >= 0 && p.x < side_ && p.y < side_ && graph_.skeleton[index(p)] != 0;
  }
  template <class Use>
  void each_neighbour(Pixel p, Use use) const {
    for (const Pixel e : kAround)
      if (is_set({p.x + e.x, p.y + e.y})) use(Pixel{p.x + e.x, p.y + e.y});
  }
  [[nodiscard]] int neighbours(Pixel p) const {
    int count = 0;
    each_neighbour(p, [&](Pixel) { ++count; });
    return count;
  }
  [[nodiscard]] int plain_neighbours(Pixel p) const {
    int count = 0;
    each_neighbour(p, [&](Pixel q) { count += node_of_[index(q)] < 0 ? 1 : 0; });
    return count;
  }

  void add_node(Pixel start) {
    const int number = static_cast<int>(graph_.nodes.size());
    std::vector<Pixel> pixels{start};
    node_of_[index(start)] = number;
    GridPoint sum;
    double radius = 0;
    for (std::size_t n = 0; n < pixels.size(); ++n) {
      const Pixel p = pixels[n];
      sum = sum + place(p);
      radius = std::max(radius, radius_at(distance_, place(p)));
      each_neighbour(p, [&](Pixel q) {
        if (node_of_[index(q)] >= 0 || neighbours(q) <= 2) return;
        node_of_[index(q)] = number;
        pixels.push_back(q);
      });
    }
    graph_.nodes.push_back({sum * (1.0 / static_cast<double>(pixels.size())), radius});
  }

  void add_branch(Pixel start, bool is_ring) {
    Branch branch;
    branch.is_ring = is_ring;
    Pixel p = start;
    const auto node_beside = [&](Pixel q, int other_than) {
      int found = -1;
      each_neighbour(q, [&](Pixel n) {
        const int node = node_of_[index(n)];
        if (node >= 0 && node != other_than && found < 0) found = node;
      });
      return found;
    };
    branch.from = node_beside(p, -1);
    while (true) {
      done_[index(p)] = 1;
      branch.points.push_back(place(p));
      bool goes_on = false;
      Pixel next;
      each_neighbour(p, [&](Pixel q) {
        if (goes_on || node_of_[index(q)] >= 0 || done_[index(q)] != 0) return;
        next = q;
        goes_on = true;
      });
      if (!goes_on) break;
      p = next;
    }
    if (branch.points.size() == 1) {
      branch.to = node_beside(p, branch.from);
      // One pixel that leaves a node and returns to it is a branch without length, one with a free end is
      // not.
      int beside = 0;
      each_neighbour(p, [&](Pixel) { ++beside; });
      if (branch.to < 0 && branch.from >= 0 && beside > 1) branch.to = branch.from;
    } else {
      branch.to = node_beside(p, -1);
    }
    graph_.branches.push_back(std::move(branch));
  }

  InkGraph& graph_;
  const DistanceMap& distance_;
  int side_;
  std::vector<int> node_of_;
  std::vector<std::uint8_t> done_;
};

/// The free end of a branch without the part that runs into the rim of a round end or into one corner of a
/// square end: the last point whose disc covers nearly all that comes after it.
GridPoint end_without_rim(const Branch& branch, bool at_front, const InkMap& map) {
  constexpr double kInRadii = 0.1;
  // A corner reaches 0.41 radii beyond a disc, and lies aside by 45 degrees. The tip of a sweep lies ahead.
  constexpr double kOfCorner = 0.5;
  constexpr double kAside = 0.866;  // cosine
  constexpr double kLeast = 0.8;
  const std::size_t count = branch.points.size();
  const auto at = [&](std::size_t i) { return at_front ? branch.points[i] : branch.points[count - 1 - i]; };
  const double rim = radius_at(map.distance, at(0));
  const auto covers = [&](std::size_t i, double in_radii) {
    const double radius = radius_at(map.distance, at(i));
    return geometry::distance(at(0), at(i)) + rim - radius <= in_radii * radius + kLeast;
  };
  const auto end_lies_aside = [&](std::size_t i, double radius) {
    const GridPoint inside = at(std::min(count - 1, i + static_cast<std::size_t>(radius)));
    const GridPoint along = at(i) - inside, out = at(0) - at(i);
    return along.x * out.x + along.y * out.y <
           kAside * std::hypot(along.x, along.y) * std::hypot(out.x, out.y);
  };
  std::size_t best = 0;
  std::size_t corner = 0;
  for (std::size_t i = 1; i < count; ++i) {
    const double radius = radius_at(map.distance, at(i));
    if (covers(i, kInRadii)) best = i;
    if (covers(i, kOfCorner) && end_lies_aside(i, radius)) corner = i;
    if (static_cast<double>(i) > 2 * radius + 4) break;
  }
  const bool is_in_corner =
      !map.is_groove && radius_at(map.distance, at(best)) < radius_at(map.distance, at(corner)) / 2;
  return at(is_in_corner ? corner : best);
}

/// By how much the ink around the free end of a branch reaches beyond the disc at its node [samples].
double reach_beyond(const Branch& branch, const Node& node, const DistanceMap& distance) {
  const GridPoint end = branch.from < 0 ? branch.points.front() : branch.points.back();
  return geometry::distance(end, node.at) + radius_at(distance, end) - node.radius;
}

/// The distance from the rim that four fifths of the ink do not exceed.
float usual_distance(const InkMap& map) {
  std::vector<float> all;
  for (const float d : map.distance.distance)
    if (d > 0) all.push_back(d);
  const auto at = all.begin() + static_cast<std::ptrdiff_t>(all.size() * 4 / 5);
  std::nth_element(all.begin(), at, all.end());
  return *at;
}

std::vector<std::uint8_t> without_width(std::vector<std::uint8_t> lines, const DistanceMap& distance) {
  const std::vector<std::uint8_t> none(lines.size());
  return thinned(std::move(lines), distance.side, distance.distance, none, true);
}

/// The two corners of a square end of a line [samples]: of each node, how far its two whiskers together reach
/// beyond its disc; infinite where it has not just two.
std::vector<double> reaches_of_ends(const InkGraph& graph, const DistanceMap& distance) {
  std::vector<int> whiskers(graph.nodes.size());
  std::vector<double> reaches(graph.nodes.size());
  for (const Branch& branch : graph.branches) {
    if ((branch.from < 0) == (branch.to < 0)) continue;
    const auto node = static_cast<std::size_t>(std::max(branch.from, branch.to));
    ++whiskers[node];
    reaches[node] += reach_beyond(branch, graph.nodes[node], distance);
  }
  for (std::size_t n = 0; n < reaches.size(); ++n)
    if (whiskers[n] != 2) reaches[n] = std::numeric_limits<double>::infinity();
  return reaches;
}

/// Takes the whiskers away, pass by pass, until none is left.
/// @return the graph without them.
InkGraph without_whiskers(InkGraph graph, const InkMap& map) {
  // A square end of a line has corners that reach 0.41 radii beyond its last disc, both together 0.83; one
  // that is cut at a slant of 20 degrees 0.74 and 0.22. The round ends of a groove have none.
  const double in_radii = map.is_groove ? 0.22 : 0.5;
  const double both_in_radii = map.is_groove ? 0 : 1.05;
  constexpr double kLeast = 1.5;
  for (int pass = 0; pass < 6; ++pass) {
    bool any = false;
    const std::vector<double> both = reaches_of_ends(graph, map.distance);
    for (const Branch& branch : graph.branches) {
      if ((branch.from < 0) == (branch.to < 0)) continue;
      const auto at = static_cast<std::size_t>(std::max(branch.from, branch.to));
      const Node& node = graph.nodes[at];
      if (reach_beyond(branch, node, map.distance) >= std::max(kLeast, in_radii * node.radius) &&
          both[at] >= both_in_radii * node.radius)
        continue;
      any = true;
      for (const GridPoint p : branch.points)
        graph.skeleton[map.index(static_cast<int>(p.x), static_cast<int>(p.y))] = 0;
    }
    if (!any) break;
    // Nodes that have become corners of one line lose the pixels that they have too many.
    graph = graph_of(without_width(std::move(graph.skeleton), map.distance), map.distance);
  }
  return graph;
}

}  // namespace

InkGraph graph_of(std::vector<std::uint8_t> skeleton, const DistanceMap& distance) {
  InkGraph graph;
  graph.skeleton = std::move(skeleton);
  Reader(graph, distance).read();
  return graph;
}

InkGraph middle_lines(const InkMap& map) {
  const int side = map.distance.side;
  // Lines of a pixel or two have no middle that differs from their rim.
  constexpr float kThin = 2.5F;
  const bool is_thin = usual_distance(map) < kThin;
  std::vector<std::uint8_t> lines =
      thinned(map.ink, side, map.distance.distance,
              is_thin ? std::vector<std::uint8_t>(map.ink.size()) : middle_of(map.distance), is_thin);
  const InkGraph first =
      without_whiskers(graph_of(without_width(std::move(lines), map.distance), map.distance), map);
  // Once more between the ends alone, along the deepest of a groove, which is the centre line even beside a
  // junction.
  std::vector<std::uint8_t> ends(map.ink.size());
  std::vector<int> arms(first.nodes.size());
  const auto keep = [&](GridPoint p) {
    ends[map.index(static_cast<int>(std::lround(p.x)), static_cast<int>(std::lround(p.y)))] = 1;
  };
  for (const Branch& branch : first.branches) {
    if (branch.is_ring) continue;
    if (branch.from < 0) keep(end_without_rim(branch, true, map));
    if (branch.to < 0) keep(end_without_rim(branch, false, map));
    for (const int node : {branch.from, branch.to})
      if (node >= 0) ++arms[static_cast<std::size_t>(node)];
  }
  for (std::size_t n = 0; n < arms.size(); ++n)
    if (arms[n] == 1) keep(first.nodes[n].at);
  std::vector<float> height = map.distance.distance;
  if (map.is_groove) {
    // On level ground the distance still decides.
    constexpr float kTie = 0.002F;
    for (std::size_t i = 0; i < height.size(); ++i) height[i] = map.depth[i] + kTie * height[i];
  }
  return graph_of(thinned(map.ink, side, height, ends), map.distance);
}

}  // namespace nazori::author
