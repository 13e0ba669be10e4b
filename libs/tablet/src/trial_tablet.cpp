// SPDX-License-Identifier: Apache-2.0
#include "nazori/tablet/trial_tablet.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nazori::tablet {

std::shared_ptr<const CarvedTablet> wall_and_groove(const geometry::TabletShape& shape) {
  constexpr int kSize = 512;
  auto map = surface::HeightMap::create(kSize);
  if (!map) return nullptr;
  for (int column = 0; column < kSize; ++column) {
    const double x = static_cast<double>(column) / (kSize - 1);
    // A floor, then a steep wall; a round groove in the plateau.
    const double wall = 0.1 + 0.9 * std::clamp((x - 0.30) / 0.06, 0.0, 1.0);
    const double off = (x - 0.68) / 0.035;
    const double height = std::min(wall, 1 - 0.8 * std::exp(-off * off));
    for (int row = 0; row < kSize; ++row) map->set(column, row, static_cast<float>(height));
  }
  TabletLine line;
  line.points = {{0.68 * geometry::kGlyphSide, 15}, {0.68 * geometry::kGlyphSide, 94}};
  auto made = CarvedTablet::from_height_map(std::move(*map), {line}, shape);
  return made ? *made : nullptr;
}

}  // namespace nazori::tablet
