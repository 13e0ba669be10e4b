// SPDX-License-Identifier: Apache-2.0
#include "clearance_grid.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "nazori/geometry/polyline.h"

namespace nazori::view {
namespace {

using geometry::GlyphPoint;
using GlyphLine = geometry::Polyline<geometry::GlyphFrame>;

// Cells of one glyph unit; cell (0, 0) begins at (-kReach, -kReach).
constexpr int kSide = static_cast<int>(geometry::kGlyphSide + 2 * ClearanceGrid::kReach);

int cell_of(double coordinate) {
  const double cell = std::floor(coordinate + ClearanceGrid::kReach);
  return static_cast<int>(std::clamp(cell, -1.0, static_cast<double>(kSide)));
}

/// From a coordinate to the nearest one within [low, low + 1].
double outside(double coordinate, double low) {
  return std::max({low - coordinate, coordinate - low - 1, 0.0});
}

}  // namespace

ClearanceGrid::ClearanceGrid(std::span<const GlyphLine> lines)
    : cells_(static_cast<std::size_t>(kSide) * static_cast<std::size_t>(kSide)) {
  for (const GlyphLine& line : lines) {
    if (line.size() == 1) add({line[0], line[0]});
    for (std::size_t i = 0; i + 1 < line.size(); ++i) add({line[i], line[i + 1]});
  }
}

void ClearanceGrid::add(const Piece& piece) {
  const bool down = piece.from.y <= piece.to.y;
  const GlyphPoint top = down ? piece.from : piece.to;
  const GlyphPoint bottom = down ? piece.to : piece.from;
  const double height = bottom.y - top.y;
  bool used = false;
  const auto index = static_cast<std::uint32_t>(pieces_.size());
  for (int row = std::max(cell_of(top.y), 0); row <= std::min(cell_of(bottom.y), kSide - 1); ++row) {
    // The part of the piece within the row.
    const double row_top = row - kReach;
    const double first = height > 0 ? std::clamp((row_top - top.y) / height, 0.0, 1.0) : 0.0;
    const double last = height > 0 ? std::clamp((row_top + 1 - top.y) / height, 0.0, 1.0) : 1.0;
    const double x0 = std::lerp(top.x, bottom.x, first);
    const double x1 = std::lerp(top.x, bottom.x, last);
    const int end = std::min(cell_of(std::max(x0, x1)), kSide - 1);
    for (int column = std::max(cell_of(std::min(x0, x1)), 0); column <= end; ++column) {
      Cell& entered = cells_[static_cast<std::size_t>(row) * kSide + static_cast<std::size_t>(column)];
      if (entered.count == kCrowd) continue;
      entered.pieces[entered.count++] = index;
      used = true;
    }
  }
  if (used) pieces_.push_back(piece);
}

const ClearanceGrid::Cell& ClearanceGrid::cell(int column, int row) const {
  return cells_[static_cast<std::size_t>(row) * kSide + static_cast<std::size_t>(column)];
}

/// The least of `least` and the distances to what is in a cell.
double ClearanceGrid::in_cell(int column, int row, GlyphPoint place, double least) const {
  const double to_cell = std::hypot(outside(place.x, column - kReach), outside(place.y, row - kReach));
  if (to_cell >= least) return least;
  const Cell& one = cell(column, row);
  if (one.count == kCrowd) return to_cell;
  for (std::size_t i = 0; i < one.count; ++i) {
    const Piece& piece = pieces_[one.pieces[i]];
    least = std::min(least, geometry::distance_to_segment(place, piece.from, piece.to));
  }
  return least;
}

double ClearanceGrid::at(GlyphPoint place, double most) const {
  assert(most <= kReach);
  const int column = cell_of(place.x);
  const int row = cell_of(place.y);
  double least = most;
  // Rings of cells around that of the point: pieces n rings away are more than n - 1 units off.
  for (int ring = 0; ring - 1 < least; ++ring) {
    for (int r = std::max(row - ring, 0); r <= std::min(row + ring, kSide - 1); ++r) {
      const bool whole_row = std::abs(r - row) == ring;
      for (int c = column - ring; c <= column + ring; c += whole_row || ring == 0 ? 1 : 2 * ring) {
        if (c >= 0 && c < kSide) least = in_cell(c, r, place, least);
      }
    }
  }
  return least;
}

}  // namespace nazori::view
