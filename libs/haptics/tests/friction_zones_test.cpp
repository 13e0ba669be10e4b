// SPDX-License-Identifier: Apache-2.0
#include "nazori/haptics/friction_zones.h"

#include <gtest/gtest.h>

#include <memory>

#include "alloc_guard.h"
#include "nazori/haptics/servo.h"
#include "relief.h"

namespace nazori::haptics {
namespace {

constexpr int kSize = 64;

/// A flat plate whose right half has more friction than the material.
std::shared_ptr<HapticScene> two_halves(const test::Relief& flat, double material, double added) {
  auto zones = std::make_shared<FrictionZones>();
  zones->size = kSize;
  zones->zone.assign(kSize * kSize, 0);
  for (std::size_t i = 0; i < zones->zone.size(); ++i) zones->zone[i] = i % kSize >= kSize / 2 ? 1 : 0;
  zones->added = {added};
  auto scene = flat.scene();
  scene->material.static_friction = scene->material.dynamic_friction = material;
  scene->friction_zones = std::move(zones);
  return scene;
}

/// How far the proxy has moved after the device moved by `pull` sideways from `x`, a millimetre deep.
double slid_m(Servo& servo, double x, double pull) {
  double time_s = servo.latest().time_s;
  const auto at = [&](const Vec3& p) { (void)servo.tick({time_s += 0.001, p, 0, true}); };
  at({x, 0, 0.002});
  for (int i = 0; i < 20; ++i) at({x, 0, 0.002 - 0.003 * i / 19});
  const double from = servo.latest().proxy_m.x;
  for (int i = 1; i <= 50; ++i) at({x + pull * i / 50, 0, -0.001});
  const double slid = servo.latest().proxy_m.x - from;
  at({x + pull, 0, 0.002});
  return slid;
}

// Coulomb: at a depth of 1 mm and a coefficient of 0.5 the proxy stays while it is pulled by up to 0.5 mm.
TEST(FrictionZones, HoldTheTipWhereTheyLieAndNowhereElse) {
  const test::Relief flat(kSize, 0.01, test::plate);
  Servo servo{DeviceDescription{}};
  servo.set_scene(two_halves(flat, 0, 0.5));
  EXPECT_NEAR(slid_m(servo, -0.03, 0.0004), 0.0004, 1e-6);
  EXPECT_NEAR(slid_m(servo, 0.02, 0.0004), 0, 1e-6);
  EXPECT_NEAR(slid_m(servo, 0.02, 0.0010), 0.0005, 2e-5);
  EXPECT_NEAR(slid_m(servo, -0.03, 0.0010), 0.0010, 1e-6);
}

TEST(FrictionZones, AreAddedToTheFrictionOfTheMaterial) {
  const test::Relief flat(kSize, 0.01, test::plate);
  Servo servo{DeviceDescription{}};
  servo.set_scene(two_halves(flat, 0.2, 0.3));
  EXPECT_NEAR(slid_m(servo, -0.03, 0.0010), 0.0008, 2e-5);
  EXPECT_NEAR(slid_m(servo, 0.02, 0.0010), 0.0005, 2e-5);
}

TEST(FrictionZones, OfAnotherSizeOrWithoutACoefficientAreNotFelt) {
  const test::Relief flat(kSize, 0.01, test::plate);
  for (const bool small : {true, false}) {
    auto scene = two_halves(flat, 0, 0.5);
    auto zones = std::make_shared<FrictionZones>(*scene->friction_zones);
    if (small) {
      zones->size = 8;
    } else {
      zones->added.clear();
    }
    scene->friction_zones = zones;
    Servo servo{DeviceDescription{}};
    servo.set_scene(scene);
    EXPECT_NEAR(slid_m(servo, 0.02, 0.0010), 0.0010, 1e-6);
  }
}

TEST(FrictionZones, BeyondTheEdgeTheMaterialIsFelt) {
  const test::Relief flat(kSize, 0.01, test::plate);
  Servo servo{DeviceDescription{}};
  servo.set_scene(two_halves(flat, 0, 0.5));
  EXPECT_NEAR(slid_m(servo, 0.06, 0.0004), 0.0004, 1e-6);
}

TEST(FrictionZones, ATickOverThemAllocatesNothing) {
  const test::Relief flat(kSize, 0.01, test::plate);
  Servo servo{DeviceDescription{}};
  servo.set_scene(two_halves(flat, 0, 0.5));
  (void)servo.tick({0.001, {-0.02, 0, -0.001}, 0, true});
  const test::AllocGuard guard;
  for (int i = 0; i < 200; ++i)
    (void)servo.tick({0.002 + 0.001 * i, {-0.02 + 0.0002 * i, 0, -0.001}, 0, true});
  EXPECT_EQ(guard.calls(), 0);
}

}  // namespace
}  // namespace nazori::haptics
