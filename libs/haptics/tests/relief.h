// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <memory>
#include <utility>

#include "nazori/haptics/haptic_scene.h"
#include "nazori/haptics/tablet_surface.h"

namespace nazori::haptics::test {

/// A tablet of 0.1 m whose height in metres is z(x, y), -depth_m <= z <= 0.
struct Relief {
  Relief(int size, double depth_m, auto z) : shape{0.1, depth_m} {
    surface::HeightMap map = *surface::HeightMap::create(size);
    for (int row = 0; row < size; ++row)
      for (int column = 0; column < size; ++column) {
        const auto p =
            geometry::grid_to_tablet({static_cast<double>(column), static_cast<double>(row)}, size, shape);
        map.set(column, row, static_cast<float>(1 + std::clamp(z(p.x, p.y), -depth_m, 0.0) / depth_m));
      }
    smooth = *surface::SmoothSurface::create(map);
    tablet = TabletSurface(*smooth, shape);
  }
  /// A new scene with this surface; everything else has its defaults.
  [[nodiscard]] std::shared_ptr<HapticScene> scene() const {
    auto made = std::make_shared<HapticScene>();
    made->surface = smooth;
    made->shape = shape;
    return made;
  }

  geometry::TabletShape shape;
  std::shared_ptr<const surface::SmoothSurface> smooth;
  TabletSurface tablet;
};

inline double plate(double, double) { return 0; }

}  // namespace nazori::haptics::test
