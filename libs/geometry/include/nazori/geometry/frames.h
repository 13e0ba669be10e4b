// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/geometry/point.h"

namespace nazori::geometry {

/// The physical size of the carved tablet. The plateau spans [-width_m/2, width_m/2] in x and y at z = 0; the
/// deepest groove lies at z = -depth_m.
struct TabletShape {
  double width_m = 0.100;  ///< side of the square [m], > 0
  double depth_m = 0.010;  ///< depth of a sample of height 0 below the plateau [m], > 0
};

/// The only place that converts between frames. The samples of a map of side `size` sit on the corners of a
/// lattice that spans the glyph box and the tablet from edge to edge: column 0 is glyph x = 0 and tablet x =
/// -width_m/2, column size-1 is glyph x = 109 and tablet x = +width_m/2; rows likewise, row 0 at the top.

/// Glyph units to columns and rows. @param size side of the map in samples, >= 2.
[[nodiscard]] inline GridPoint glyph_to_grid(GlyphPoint p, int size) {
  const double scale = (size - 1) / kGlyphSide;
  return {p.x * scale, p.y * scale};
}
[[nodiscard]] inline GlyphPoint grid_to_glyph(GridPoint p, int size) {
  const double scale = kGlyphSide / (size - 1);
  return {p.x * scale, p.y * scale};
}
/// Columns and rows to metres; y changes from down to up.
[[nodiscard]] inline TabletPoint grid_to_tablet(GridPoint p, int size, const TabletShape& shape) {
  const double step_m = shape.width_m / (size - 1);
  return {p.x * step_m - shape.width_m / 2, shape.width_m / 2 - p.y * step_m};
}
[[nodiscard]] inline GridPoint tablet_to_grid(TabletPoint p, int size, const TabletShape& shape) {
  const double per_m = (size - 1) / shape.width_m;
  return {(p.x + shape.width_m / 2) * per_m, (shape.width_m / 2 - p.y) * per_m};
}
[[nodiscard]] inline TabletPoint glyph_to_tablet(GlyphPoint p, const TabletShape& shape) {
  const double scale = shape.width_m / kGlyphSide;
  return {p.x * scale - shape.width_m / 2, shape.width_m / 2 - p.y * scale};
}
[[nodiscard]] inline GlyphPoint tablet_to_glyph(TabletPoint p, const TabletShape& shape) {
  const double scale = kGlyphSide / shape.width_m;
  return {(p.x + shape.width_m / 2) * scale, (shape.width_m / 2 - p.y) * scale};
}

}  // namespace nazori::geometry
