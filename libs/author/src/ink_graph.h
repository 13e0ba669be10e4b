// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "distance_map.h"
#include "ink_map.h"
#include "nazori/geometry/point.h"

namespace nazori::author {

/// Where a stroke that ends freely touches another one: a round end does not reach it, a sweep does.
struct TouchingTip {
  geometry::GridPoint at;
  bool thins_out = false;  ///< the ink looks like a sweep
};

/// A line of the skeleton between two nodes.
struct Branch {
  std::vector<geometry::GridPoint> points;    ///< neighbouring pixels, those of its nodes not among them
  int from = -1;                              ///< node at the front; -1: it ends freely, or is a ring
  int to = -1;                                ///< node at the back
  bool is_ring = false;                       ///< without ends: the last point is beside the first
  std::optional<TouchingTip> front_tip = {};  ///< of a free end that touches another stroke
  std::optional<TouchingTip> back_tip = {};
};

/// Where three or more branches meet.
struct Node {
  geometry::GridPoint at;
  double radius = 0;  ///< of the ink around it, in samples
};

/// The middle lines of ink.
struct InkGraph {
  std::vector<Node> nodes;
  std::vector<Branch> branches;        ///< at least one point each
  std::vector<std::uint8_t> skeleton;  ///< the pixels, 0 or 1
};

/// Lines one pixel wide as nodes and branches.
[[nodiscard]] InkGraph graph_of(std::vector<std::uint8_t> skeleton, const DistanceMap& distance);

/// The middle lines of the ink, without whiskers: an end is one where the ink reaches farther than the disc
/// at the node. In a groove the lines lie where it is deepest.
[[nodiscard]] InkGraph middle_lines(const InkMap& map);

}  // namespace nazori::author
