// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

#include "nazori/view/tablet_view.h"
#include "relief_mesh.h"

namespace nazori::view {

/// Vertices x, y, z [m] and their light relative to the plateau; triangles counter-clockwise from outside.
struct BoardMesh {
  std::vector<glm::vec4> vertices;
  std::vector<std::uint32_t> indices;
};

/// Thickness of the board [m].
[[nodiscard]] double board_thickness_m(const geometry::TabletShape& shape);
/// Radius of its corners seen from above [m].
[[nodiscard]] double board_corner_m(const geometry::TabletShape& shape);

/// All of the board except the carved square: rim, rounded edge and sides, and the ends of grooves that run
/// out of the square.
[[nodiscard]] BoardMesh make_board_mesh(const ReliefMesh& relief, const geometry::TabletShape& shape,
                                        Hand hand);

}  // namespace nazori::view
