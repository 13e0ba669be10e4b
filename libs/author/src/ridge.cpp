// SPDX-License-Identifier: Apache-2.0
#include "ridge.h"

#include <algorithm>

#include "groove_line.h"
#include "nazori/geometry/frames.h"
#include "nazori/geometry/polyline.h"

namespace nazori::author {
namespace {

using geometry::GlyphPoint;
using geometry::GridPoint;

GlyphPoint unit(GlyphPoint v) {
  const double l = geometry::length(v);
  return l > 0 ? v * (1 / l) : GlyphPoint{};
}

}  // namespace

Ridge ridge_of(const InkGraph& graph, const InkMap& map, double reach) {
  constexpr double kSpacing = 3.0;
  Ridge ridge;
  for (const Branch& branch : graph.branches) {
    GridLine line = branch.points;
    const auto node = [&](int n) -> const Node* {
      return n < 0 ? nullptr : &graph.nodes[static_cast<std::size_t>(n)];
    };
    const Node* from = node(branch.from);
    const Node* to = node(branch.to);
    if (from != nullptr) line.insert(line.begin(), from->at);
    if (to != nullptr) line.push_back(to->at);
    line = smoothed(line, kSpacing);
    if (!branch.is_ring)
      centre_ends(line, map, from == nullptr && !branch.front_tip, to == nullptr && !branch.back_tip);
    const auto glyph = [&](std::size_t i) { return geometry::grid_to_glyph(line[i], kInkSide); };
    for (std::size_t i = 0; i < line.size(); ++i) {
      const GlyphPoint along =
          unit(glyph(std::min(i + 1, line.size() - 1)) - glyph(i - std::min<std::size_t>(i, 1)));
      const auto is_near = [&](const Node* n) {
        return n != nullptr && geometry::distance(n->at, line[i]) < reach * n->radius;
      };
      ridge.points.push_back({glyph(i), along, !is_near(from) && !is_near(to)});
    }
    if (branch.is_ring) continue;
    const std::size_t last = line.size() - 1;
    const std::size_t look = std::min<std::size_t>(4, last);
    const auto add = [&](bool touches, std::size_t i, std::size_t inside) {
      ridge.ends.push_back({glyph(i), unit(glyph(i) - glyph(inside)), touches});
    };
    if (from == nullptr) add(branch.front_tip.has_value(), 0, look);
    if (to == nullptr) add(branch.back_tip.has_value(), last, last - look);
  }
  return ridge;
}

}  // namespace nazori::author
