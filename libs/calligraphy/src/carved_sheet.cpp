// SPDX-License-Identifier: Apache-2.0
#include "carved_sheet.h"

#include <utility>

#include "nazori/paint/relief.h"

namespace nazori::calligraphy {

base::Result<std::shared_ptr<const tablet::CarvedTablet>> carved_sheet(const paint::Sheet& sheet) {
  // A full stroke leaves about one filling. Walls as wide as a stylus's tip make the groove felt as one.
  constexpr double kDeepest = 0.9;
  constexpr double kWall_m = 0.0012;
  paint::ReliefOptions options;
  options.paper = 0;
  options.per_filling = 1;
  options.tooth = 0;
  options.smooth_m = kWall_m;
  surface::HeightMap map = paint::relief_of(sheet, options);
  for (int row = 0; row < map.size(); ++row)
    for (int column = 0; column < map.size(); ++column)
      map.set(column, row, 1 - static_cast<float>(kDeepest) * map.at(column, row));
  return tablet::CarvedTablet::from_height_map(std::move(map), {});
}

}  // namespace nazori::calligraphy
