// SPDX-License-Identifier: Apache-2.0
#include "nazori/haptics/surface_contact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace nazori::haptics {
namespace {

/// A tablet of 0.1 m whose height in metres is `z(x, y)` <= 0.
struct Relief {
  Relief(int size, double depth_m, auto z) : shape{0.1, depth_m} {
    surface::HeightMap map = *surface::HeightMap::create(size);
    for (int row = 0; row < size; ++row)
      for (int column = 0; column < size; ++column) {
        const auto p = geometry::grid_to_tablet({double(column), double(row)}, size, shape);
        map.set(column, row, static_cast<float>(1 + z(p.x, p.y) / depth_m));
      }
    smooth = *surface::SmoothSurface::create(map);
    tablet = TabletSurface(*smooth, shape);
  }
  geometry::TabletShape shape;
  std::shared_ptr<const surface::SmoothSurface> smooth;
  TabletSurface tablet;
};

TEST(SurfaceContact, OnAPlateTheProxyIsStraightAboveTheDeviceWithoutLag) {
  const Relief plate(128, 0.01, [](double, double) { return 0.0; });
  SurfaceContact contact;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 device{0.04 * std::sin(0.02 * i), 0.03 * std::cos(0.03 * i), -0.002};
    contact.update(plate.tablet, device, {});
    ASSERT_TRUE(contact.touching());
    EXPECT_NEAR(contact.proxy_m().x, device.x, 1e-12);
    EXPECT_NEAR(contact.proxy_m().y, device.y, 1e-12);
    EXPECT_NEAR(contact.proxy_m().z, 0, 1e-12);
  }
}

}  // namespace
}  // namespace nazori::haptics
