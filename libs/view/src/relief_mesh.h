// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "relief.h"

namespace nazori::view {

/// One corner of the mesh: lattice column and row, and height 0..65535.
struct MeshVertex {
  std::uint16_t column = 0;
  std::uint16_t row = 0;
  std::uint16_t height = 0;
  std::uint16_t padding = 0;
};

/// Triangles whose middle lies in one square of the tablet, so that a small region can be drawn alone.
struct MeshTile {
  std::uint32_t first_index = 0;
  std::uint32_t index_count = 0;
  std::array<std::uint16_t, 4> bounds{};  ///< least column and row, greatest column and row of its triangles
};

/// Triangles that follow a relief: fine where it bends, coarse where it is flat, without cracks.
struct ReliefMesh {
  int grid = 0;  ///< lattice cells a side, a power of two
  std::vector<MeshVertex> vertices;
  std::vector<std::uint32_t> indices;  ///< three a triangle, counter-clockwise seen from above
  std::vector<MeshTile> tiles;
};

/// Right-triangulated irregular network over a lattice of 2^k + 1 samples.
/// @param relief  size 2^k + 1, k >= 5.
/// @param tolerance  largest height difference between a triangle and the sample in the middle of its longest
///   side, there and at all finer levels, as a fraction of the tablet's depth.
/// @source W. Evans, D. Kirkpatrick, G. Townsend, "Right-Triangulated Irregular Networks", Algorithmica 30,
/// 2001.
[[nodiscard]] ReliefMesh make_relief_mesh(const Relief& relief, float tolerance);

}  // namespace nazori::view
