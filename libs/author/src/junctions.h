// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "ink_graph.h"

namespace nazori::author {

/// How far beside a node the middle lines of ink and of grooves are bent, in radii of the ink there.
inline constexpr double kInkReach = 1.1;
inline constexpr double kGrooveReach = 0.9;

/// A part of a skeleton without the surroundings of its junctions, where the middle of the ink is the middle
/// of no line.
struct Arm {
  std::vector<geometry::GridPoint> points;  ///< at least one
  int from = -1;                            ///< junction at the front; -1: it ends freely
  int to = -1;                              ///< junction at the back
  bool is_ring = false;
  bool thins_out = false;  ///< towards its free end
};

/// Where lines meet: a node, or some so close together that they are one crossing.
struct Junction {
  geometry::GridPoint at;
  double radius = 0;  ///< of the ink [samples]
};

struct Arms {
  std::vector<Arm> arms;
  std::vector<Junction> junctions;
};

/// Cuts the branches off beside their nodes.
/// @param map  from which the graph was made. @param reach  kInkReach or kGrooveReach.
[[nodiscard]] Arms arms_of(const InkGraph& graph, const InkMap& map, double reach);

/// The lines of which the arms are parts: in a junction those go on in each other that bend least, and what
/// remains ends there. In no order, from any end.
[[nodiscard]] std::vector<geometry::Polyline<geometry::GridFrame>> joined(const Arms& arms);

}  // namespace nazori::author
