// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/model/plate.h"

namespace nazori::model {

/// A closed surface of triangles. Corners are in millimetres, x right, y up, z away from the table, and stand
/// counter-clockwise when seen from outside. Neighbouring triangles share their corners by index.
struct Mesh {
  std::vector<std::array<float, 3>> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

struct MeshSettings {
  /// How far the mesh may be from a height of the plate [mm], measured upwards; > 0.
  double tolerance_mm = 0.01;
  std::size_t most_triangles = 99'000;  ///< of the whole mesh, at least 1,000
};

/// A mesh, and how exact it is.
struct PlateMesh {
  Mesh mesh;
  double error_mm = 0;  ///< greatest distance from a height of the plate; over the tolerance where the
                        ///< triangles did not suffice
};

/// The plate as a solid: its upper face with large triangles where it is flat and small ones where it is not,
/// walls, a flat lower face, and walls of its holes. The faces share the corners of their rims, so the mesh
/// has no open edge and no corner inside an edge. The same plate always gives the same mesh.
/// @return Errc::bad_argument for a setting out of range.
/// @cost a tenth of a second for a grid of 800 x 800. Thread-safe: yes.
/// @source greedy insertion into a Delaunay triangulation: Garland and Heckbert, CMU-CS-95-181.
[[nodiscard]] base::Result<PlateMesh> mesh_of(const Plate& plate, const MeshSettings& settings = {});

/// Edges that do not have exactly two triangles, one in each direction. 0: the mesh is closed.
[[nodiscard]] std::size_t open_edges(const Mesh& mesh);

/// The volume inside a closed mesh [mm^3].
[[nodiscard]] double volume_mm3(const Mesh& mesh);

}  // namespace nazori::model
