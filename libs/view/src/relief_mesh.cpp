// SPDX-License-Identifier: Apache-2.0
#include "relief_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace nazori::view {
namespace {

constexpr int kTilesPerSide = 16;

/// For the middle of each hypotenuse, the error of the coarser triangle there or anywhere below it in the
/// hierarchy.
class ErrorPyramid {
 public:
  explicit ErrorPyramid(const Relief& relief)
      : relief_(relief), side_(relief.size), errors_(relief.heights.size(), 0.0F) {
    for (int cell = 2; cell < side_; cell *= 2) {
      measure_sides(cell);
      measure_middles(cell);
    }
  }
  [[nodiscard]] float at(int column, int row) const { return errors_[index(column, row)]; }

 private:
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(side_) + static_cast<std::size_t>(column);
  }
  [[nodiscard]] float below(int column, int row) const {
    const bool inside = column >= 0 && row >= 0 && column < side_ && row < side_;
    return inside ? errors_[index(column, row)] : 0.0F;
  }
  void measure(int column, int row, int dx, int dy, float finer) {
    const float chord = (relief_.at(column - dx, row - dy) + relief_.at(column + dx, row + dy)) / 2;
    errors_[index(column, row)] = std::max(finer, std::abs(chord - relief_.at(column, row)));
  }
  /// Hypotenuses along the lattice, `cell` long; the triangles under them meet at the middles of cells half
  /// as large.
  void measure_sides(int cell) {
    const int half = cell / 2;
    const int quarter = cell / 4;
    for (int row = 0; row < side_; row += half) {
      const bool on_line = row % cell == 0;
      for (int column = on_line ? half : 0; column < side_; column += cell) {
        float finer = 0;
        if (quarter > 0) {
          finer = std::max({below(column - quarter, row - quarter), below(column + quarter, row - quarter),
                            below(column - quarter, row + quarter), below(column + quarter, row + quarter)});
        }
        measure(column, row, on_line ? half : 0, on_line ? 0 : half, finer);
      }
    }
  }
  /// Hypotenuses across a cell; they run from the middle of the cell twice as large to its corner.
  void measure_middles(int cell) {
    const int half = cell / 2;
    for (int row = half; row < side_; row += cell) {
      for (int column = half; column < side_; column += cell) {
        const float finer = std::max({below(column - half, row), below(column + half, row),
                                      below(column, row - half), below(column, row + half)});
        const bool same_parity = ((column / cell) ^ (row / cell)) % 2 == 0;
        measure(column, row, half, same_parity ? half : -half, finer);
      }
    }
  }

  const Relief& relief_;
  int side_;
  std::vector<float> errors_;
};

struct Corner {
  int column;
  int row;
};

class Triangulation {
 public:
  Triangulation(const Relief& relief, float tolerance)
      : relief_(relief),
        errors_(relief),
        tolerance_(tolerance),
        grid_(relief.size - 1),
        numbers_(relief.heights.size(), kNone),
        tiles_(static_cast<std::size_t>(kTilesPerSide * kTilesPerSide)) {
    split({0, 0}, {grid_, grid_}, {0, grid_});
    split({grid_, grid_}, {0, 0}, {grid_, 0});
  }

  ReliefMesh collect() {
    mesh_.grid = grid_;
    for (const auto& tile : tiles_) {
      if (tile.empty()) continue;
      MeshTile entry;
      entry.first_index = static_cast<std::uint32_t>(mesh_.indices.size());
      entry.index_count = static_cast<std::uint32_t>(tile.size());
      entry.bounds = {std::numeric_limits<std::uint16_t>::max(), std::numeric_limits<std::uint16_t>::max(), 0,
                      0};
      for (const std::uint32_t number : tile) {
        const MeshVertex& vertex = mesh_.vertices[number];
        entry.bounds = {std::min(entry.bounds[0], vertex.column), std::min(entry.bounds[1], vertex.row),
                        std::max(entry.bounds[2], vertex.column), std::max(entry.bounds[3], vertex.row)};
        mesh_.indices.push_back(number);
      }
      mesh_.tiles.push_back(entry);
    }
    return std::move(mesh_);
  }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  /// The triangle a, b, c with its right angle at c.
  void split(Corner a, Corner b, Corner c) {  // NOLINT(misc-no-recursion): depth is 2 log2(grid)
    const Corner middle{(a.column + b.column) / 2, (a.row + b.row) / 2};
    const int leg = std::abs(a.column - c.column) + std::abs(a.row - c.row);
    const bool large = leg > grid_ / kTilesPerSide;
    if (leg > 1 && (large || errors_.at(middle.column, middle.row) > tolerance_)) {
      split(c, a, middle);
      split(b, c, middle);
      return;
    }
    const int tile_cells = grid_ / kTilesPerSide;
    const int tile_column = std::min((a.column + b.column + c.column) / (3 * tile_cells), kTilesPerSide - 1);
    const int tile_row = std::min((a.row + b.row + c.row) / (3 * tile_cells), kTilesPerSide - 1);
    auto& tile =
        tiles_[static_cast<std::size_t>(tile_row) * kTilesPerSide + static_cast<std::size_t>(tile_column)];
    tile.insert(tile.end(), {number_of(b), number_of(a), number_of(c)});
  }

  std::uint32_t number_of(Corner corner) {
    const std::size_t place = static_cast<std::size_t>(corner.row) * static_cast<std::size_t>(relief_.size) +
                              static_cast<std::size_t>(corner.column);
    if (numbers_[place] == kNone) {
      numbers_[place] = static_cast<std::uint32_t>(mesh_.vertices.size());
      mesh_.vertices.push_back(
          {static_cast<std::uint16_t>(corner.column), static_cast<std::uint16_t>(corner.row),
           static_cast<std::uint16_t>(std::lround(relief_.heights[place] * 65535.0F)), 0});
    }
    return numbers_[place];
  }

  const Relief& relief_;
  ErrorPyramid errors_;
  float tolerance_;
  int grid_;
  std::vector<std::uint32_t> numbers_;
  std::vector<std::vector<std::uint32_t>> tiles_;
  ReliefMesh mesh_;
};

}  // namespace

ReliefMesh make_relief_mesh(const Relief& relief, float tolerance) {
  return Triangulation(relief, tolerance).collect();
}

}  // namespace nazori::view
