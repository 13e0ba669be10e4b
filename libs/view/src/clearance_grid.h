// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "nazori/geometry/frames.h"
#include "nazori/geometry/point.h"

namespace nazori::view {

/// Answers many queries for the distance from a point to all lines. The lines may have millions of pieces:
/// those near a point are found in a grid over the glyph box and its surroundings.
class ClearanceGrid {
 public:
  explicit ClearanceGrid(std::span<const geometry::Polyline<geometry::GlyphFrame>> lines);

  /// Distance from `place` to the nearest line, at most `most`. If one glyph unit contains so many pieces
  /// that no point in it is clear, the distance to that unit.
  /// @param most  at most kReach.
  [[nodiscard]] double at(geometry::GlyphPoint place, double most) const;

  /// Glyph units around the box within which pieces are known.
  static constexpr double kReach = 20;

 private:
  struct Piece {
    geometry::GlyphPoint from;
    geometry::GlyphPoint to;
  };
  /// No point in a glyph unit with this many pieces is clear of them.
  static constexpr std::size_t kCrowd = 32;
  struct Cell {
    std::array<std::uint32_t, kCrowd> pieces;
    std::size_t count = 0;
  };

  void add(const Piece& piece);
  [[nodiscard]] double in_cell(int column, int row, geometry::GlyphPoint place, double least) const;
  [[nodiscard]] const Cell& cell(int column, int row) const;

  std::vector<Piece> pieces_;
  std::vector<Cell> cells_;
};

}  // namespace nazori::view
