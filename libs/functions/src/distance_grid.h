// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "nazori/functions/tracing.h"

namespace nazori::functions {

/// Distances of sample centres to the nearest drawn piece, exact within a reach, in plate units.
class DistanceGrid {
 public:
  DistanceGrid(int size, double reach);
  void add_segment(PlatePoint p, PlatePoint q, int statement);
  /// A polyline; pieces within a 32nd of a cell of a longer chord are combined.
  void add_line(const std::vector<CurvePoint>& points, bool closed, int statement);

  /// Infinity beyond the reach.
  [[nodiscard]] float distance(std::size_t sample) const;
  [[nodiscard]] int statement(std::size_t sample) const { return statements_[sample]; }

 private:
  int size_;
  double reach_;
  std::vector<float> squares_;
  std::vector<std::uint8_t> statements_;
};

}  // namespace nazori::functions
