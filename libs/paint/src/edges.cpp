// SPDX-License-Identifier: Apache-2.0
// What a tile shows its neighbours.
#include "inside.h"

namespace nazori::paint {
namespace {

struct Line {
  std::size_t first, stride;
};
constexpr std::array<Line, 4> kLines{Line{0, kTile}, Line{kTile - 1, kTile}, Line{0, 1},
                                     Line{std::size_t{kTile} * (kTile - 1), 1}};

Amount copy(const Field& field, Line line, std::array<Amount, kTile>& to) {
  Amount any = 0;
  for (std::size_t i = 0; i < kTile; ++i) any |= to[i] = field[line.first + i * line.stride];
  return any;
}

void copy_side(const Tile& tile, Line line, Edge& edge) {
  copy(tile.fibre, line, edge.fibre);
  edge.has_standing = tile.standing != 0 && copy(tile.surface, line, edge.surface) != 0;
  edge.slots = 0;
  for (std::size_t k = 0; k < kSlots; ++k)
    if ((tile.slots >> k & 1U) != 0 && copy(tile.moving[k], line, edge.moving[k]) != 0) edge.slots |= 1U << k;
}

bool differ(const Edge& a, const Edge& b) {
  if (a.fibre != b.fibre || a.slots != b.slots || a.has_standing != b.has_standing) return true;
  if (a.has_standing && a.surface != b.surface) return true;
  for (std::size_t k = 0; k < kSlots; ++k)
    if ((a.slots >> k & 1U) != 0 && a.moving[k] != b.moving[k]) return true;
  return false;
}

}  // namespace

void prepare_edges(Tile& tile) {
  const auto& shown = tile.edges[tile.shown];
  auto& next = tile.edges[1 - tile.shown];
  tile.next_changed = 0;
  for (const Side side : {left, right, top, bottom}) {
    copy_side(tile, kLines[side], next[side]);
    if (differ(next[side], shown[side])) tile.next_changed |= static_cast<std::uint8_t>(1U << side);
  }
  tile.has_next_edges = true;
}

void publish_edges(Tile& tile) {
  if (!tile.has_next_edges) prepare_edges(tile);
  tile.shown ^= 1U;
  tile.edges_changed = tile.next_changed;
  tile.has_next_edges = false;
}

}  // namespace nazori::paint
