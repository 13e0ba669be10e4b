// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "nazori/calligraphy/ruling.h"

namespace nazori::calligraphy {

/// Distances from the edge of a stroke on a lattice; negative inside. Values further away than a few steps
/// are only known to be positive.
struct StrokeField {
  geometry::PaperPoint corner;  ///< of the first value: lowest x and y
  double step_m = 0;
  int columns = 0, rows = 0;
  std::vector<float> distance_m;  ///< row by row, upwards

  [[nodiscard]] float at(int column, int row) const {
    return distance_m[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                      static_cast<std::size_t>(column)];
  }
  [[nodiscard]] geometry::PaperPoint place(int column, int row) const {
    return {corner.x + column * step_m, corner.y + row * step_m};
  }
};

/// @param stroke  with at least one point. @param step_m  > 0. The corner is a whole number of steps.
[[nodiscard]] StrokeField field_of(const ModelStroke& stroke, double step_m);

}  // namespace nazori::calligraphy
