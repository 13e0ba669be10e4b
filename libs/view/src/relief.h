// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "nazori/surface/height_map.h"

namespace nazori::view {

/// A square lattice of heights in [0, 1], row 0 at the top, for drawing: a height map resampled to the
/// resolution of shading or meshing.
struct Relief {
  int size = 0;
  std::vector<float> heights;

  [[nodiscard]] float at(int column, int row) const {
    return heights[static_cast<std::size_t>(row) * static_cast<std::size_t>(size) +
                   static_cast<std::size_t>(column)];
  }
};

/// The map at another resolution; both lattices span the tablet from edge to edge. Finer: cubic (Catmull-Rom)
/// interpolation limited to [0, 1]. Coarser: tent filter, so nothing fine is skipped. The same size: the map
/// itself.
/// @param size  >= 2.  @param map  loaded.
[[nodiscard]] Relief resampled(const surface::HeightMap& map, int size);

}  // namespace nazori::view
