// SPDX-License-Identifier: Apache-2.0
// A tip that is a ball: what is felt, and where it touches.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>

#include "alloc_guard.h"
#include "nazori/haptics/servo.h"
#include "nazori/haptics/surface_contact.h"
#include "nazori/surface/ball_surface.h"
#include "servo_hand.h"

namespace nazori::haptics {
namespace {

using test::Hand;
using test::kAbove;

constexpr geometry::TabletShape kShape{0.1, 0.01};
constexpr double kStiffness_n_m = 0.8 * 500;

/// A map of 0.1 m whose height in metres is z(x, y), -0.01 to 0.
struct Carved {
  explicit Carved(auto z, int size = 513) : map(*surface::HeightMap::create(size)) {
    for (int row = 0; row < size; ++row)
      for (int column = 0; column < size; ++column) {
        const auto p =
            geometry::grid_to_tablet({static_cast<double>(column), static_cast<double>(row)}, size, kShape);
        map.set(column, row, static_cast<float>(1 + std::clamp(z(p.x, p.y), -0.01, 0.0) / 0.01));
      }
  }
  [[nodiscard]] std::shared_ptr<HapticScene> scene(double ball_m) const {
    auto made = std::make_shared<HapticScene>();
    made->surface = *surface::surface_for_ball(map, kShape, ball_m);
    made->shape = kShape;
    made->tip_radius_m = ball_m;
    return made;
  }
  surface::HeightMap map;
};

double v_groove(double x, double) { return -0.009 + std::abs(x); }
double incline(double x, double) { return -0.005 + x; }

TEST(BallTip, AtTheBottomOfAVGrooveBothWallsHoldIt) {
  const Carved groove(v_groove);
  for (const double ball_m : {0.001, 0.002, 0.003}) {
    Hand hand;
    hand.servo.set_scene(groove.scene(ball_m));
    hand.rest(kAbove, 400);
    // 45 degrees: the middle of the ball is sqrt(2) radii above the bottom.
    const double rests = -0.009 + ball_m * (std::numbers::sqrt2 - 1);
    hand.go(kAbove, {0, 0, rests - 0.001}, 400);
    const Vec3 force = hand.rest({0, 0, rests - 0.001}, 50);
    const double rounded = 0.25 * 0.1 / 512;  // a kink is rounded by a quarter of a sample
    EXPECT_NEAR(hand.servo.latest().proxy_m.z, rests, rounded + 5e-6) << ball_m;
    EXPECT_NEAR(force.z, kStiffness_n_m * 0.001, kStiffness_n_m * (rounded + 5e-6));
    EXPECT_NEAR(force.x, 0, 1e-3);
  }
}

TEST(BallTip, OnAnInclineItTouchesBesideItsLowestPointAndIsPushedAlongTheNormal) {
  const Carved plane(incline);
  const double ball_m = 0.003, s = 1 / std::numbers::sqrt2;
  const auto scene = plane.scene(ball_m);
  const TabletSurface felt(*scene->surface, kShape);
  SurfaceContact contact;
  contact.update(felt, {0, 0, 0.005}, {});
  EXPECT_EQ(contact.touched_m(ball_m), Vec3(0, 0, 0.005)) << "the tip itself while nothing is touched";
  const Vec3 device(0.0005, 0, -0.0045);
  contact.update(felt, device, {});
  ASSERT_TRUE(contact.touching());
  const Vec3 touched = contact.touched_m(ball_m), middle = contact.proxy_m() + Vec3(0, 0, ball_m);
  EXPECT_NEAR(touched.z, incline(touched.x, 0), 3e-6) << "on the material";
  EXPECT_NEAR(glm::length(middle - touched), ball_m, 1e-9) << "on the ball";
  EXPECT_NEAR(touched.x - contact.proxy_m().x, ball_m * s, 3e-6) << "up the slope";
  EXPECT_EQ(contact.touched_m(0), contact.proxy_m());
  // The plane of the lowest point is higher by what the ball is wider than a point.
  const double depth = (incline(device.x, 0) + ball_m * (std::numbers::sqrt2 - 1) - device.z) * s;
  const Vec3 push = contact.proxy_m() - device;
  EXPECT_NEAR(glm::length(push), depth, 3e-6);
  EXPECT_NEAR(push.x, -depth * s, 3e-6);
}

TEST(BallTip, OverAnEdgeItMovesOnACircle) {
  const Carved roof([](double x, double) { return -0.001 - std::abs(x); }, 1025);
  const double ball_m = 0.002;
  const auto scene = roof.scene(ball_m);
  const TabletSurface felt(*scene->surface, kShape);
  SurfaceContact contact;
  contact.update(felt, {-0.001, 0, 0.001}, {});
  for (double x = -0.001; x <= 0.001; x += 1e-5) {
    // Towards the middle of the circle, so that the nearest point is known.
    const Vec3 on(x, 0, -0.001 - ball_m + std::sqrt(ball_m * ball_m - x * x));
    const Vec3 centre(0, 0, -0.001 - ball_m);
    contact.update(felt, on + 0.1 * (centre - on), {});
    ASSERT_TRUE(contact.touching());
    ASSERT_NEAR(glm::length(contact.proxy_m() - on), 0, 0.25 * 0.1 / 1024 + 5e-6) << x;
    const Vec3 touched = contact.touched_m(ball_m);
    ASSERT_NEAR(glm::length(touched - Vec3(0, 0, -0.001)), 0, 1.5 * 0.1 / 1024)
        << "it stays on the edge, " << x;
  }
}

TEST(BallTip, ItDoesNotFallIntoAGrooveThatIsNarrower) {
  const double half_m = 0.001, ball_m = 0.002;
  const Carved slot([&](double x, double) { return std::abs(x) < half_m ? -0.01 : 0.0; }, 1025);
  for (const double radius_m : {0.0, ball_m}) {
    Hand hand;
    hand.servo.set_scene(slot.scene(radius_m));
    hand.rest(kAbove, 400);
    hand.go(kAbove, {0, 0, -0.004}, 400);
    hand.rest({0, 0, -0.004}, 10);
    if (radius_m == 0) {
      EXPECT_FALSE(hand.servo.latest().touching);
    } else {
      EXPECT_NEAR(hand.servo.latest().proxy_m.z, -(ball_m - std::sqrt(ball_m * ball_m - half_m * half_m)),
                  1e-4);
    }
  }
}

TEST(BallTip, RadiusZeroGivesTheForcesOfTheMapItselfToTheLastBit) {
  const Carved groove(
      [](double x, double y) { return -0.006 - 0.003 * std::sin(300 * x) * std::cos(250 * y); }, 128);
  auto plain = groove.scene(0);
  plain->surface = *surface::SmoothSurface::create(groove.map);
  auto none = groove.scene(0);
  for (HapticScene* scene : {plain.get(), none.get()}) {
    scene->material.static_friction = 0.3;
    scene->material.dynamic_friction = 0.2;
    scene->material.texture = Texture::wood;
    scene->strokes.push_back({{{-0.04, 0, -0.009}, {0.04, 0, -0.009}}});
    scene->snapping.enabled = true;
  }
  Hand a, b;
  a.servo.set_scene(plain);
  b.servo.set_scene(none);
  for (int i = 0; i < 5000; ++i) {
    const Vec3 at(0.04 * std::sin(0.003 * i), 0.04 * std::sin(0.0041 * i),
                  -0.006 + 0.005 * std::sin(0.01 * i));
    ASSERT_EQ(a.at(at), b.at(at)) << i;
    ASSERT_EQ(a.servo.latest().proxy_m, b.servo.latest().proxy_m) << i;
  }
}

TEST(BallTip, AnotherRadiusUnderAPressedStylusFadesInWithoutAKick) {
  const Carved groove(v_groove);
  Hand hand;
  hand.servo.set_scene(groove.scene(0));
  hand.rest(kAbove, 400);
  const Vec3 deep(0, 0, -0.0095);
  hand.go(kAbove, deep, 400);
  Vec3 before = hand.rest(deep, 50);
  EXPECT_GT(before.z, 0.1);
  for (const double radius_m : {0.003, 0.0005, 0.0}) {
    hand.servo.set_scene(groove.scene(radius_m));
    for (int i = 0; i < 400; ++i) {
      const Vec3 now = hand.at(deep);
      ASSERT_LE(glm::length(now - before), 0.2 + 1e-9) << "the most that a Touch may change in a tick";
      if (i >= 20 && i < 30) {
        ASSERT_LT(now.z, 0.15 * kStiffness_n_m * 0.002) << "it begins at nothing";
      }
      before = now;
    }
    const double depth = hand.servo.latest().proxy_m.z - deep.z;
    EXPECT_NEAR(depth, 0.0005 + radius_m * (std::numbers::sqrt2 - 1), 6e-5);
    EXPECT_NEAR(before.z, kStiffness_n_m * depth, 0.01);
  }
}

TEST(BallTip, FrictionIsOfThePlaceThatTheBallTouches) {
  const Carved plane(incline);
  const double ball_m = 0.003;  // touches 2.1 mm up the slope
  auto zones = std::make_shared<FrictionZones>();
  zones->size = 513;
  zones->zone.resize(513 * 513);
  zones->added = {3};
  for (int row = 0; row < 513; ++row)
    for (int column = 257; column < 513; ++column)
      zones->zone[static_cast<std::size_t>(row * 513 + column)] = 1;
  const auto slides = [&](double x) {
    auto scene = plane.scene(ball_m);
    scene->friction_zones = zones;
    Hand hand;
    hand.servo.set_scene(scene);
    hand.rest(kAbove, 10);
    const double surface_z = incline(x, 0) + ball_m * (std::numbers::sqrt2 - 1);
    hand.go({x, 0, 0.005}, {x, 0, surface_z - 0.0005}, 300);
    const Vec3 from = hand.servo.latest().proxy_m;
    hand.go({x, 0, surface_z - 0.0005}, {x, 0.0005, surface_z - 0.0005}, 50);
    return hand.servo.latest().proxy_m.y - from.y > 0.0003;
  };
  EXPECT_TRUE(slides(-0.003)) << "it touches left of the rough half";
  EXPECT_FALSE(slides(-0.001)) << "its lowest point is left of the rough half, but it touches in it";
}

TEST(BallTip, StrokesLieWhereItsLowestPointCanFollowThem) {
  const Carved groove(v_groove);
  const double ball_m = 0.003, rests = -0.009 + ball_m * (std::numbers::sqrt2 - 1);
  for (const double radius_m : {0.0, ball_m}) {
    auto scene = groove.scene(ball_m);
    scene->tip_radius_m = radius_m;
    scene->strokes.push_back({{{0, -0.04, -0.009}, {0, 0.04, -0.009}}});
    scene->snapping.enabled = true;
    scene->snapping.snap_distance_m = 0.001;
    Hand hand;
    hand.servo.set_scene(scene);
    hand.rest(kAbove, 10);
    hand.go(kAbove, {0, 0, rests + 0.0005}, 300);
    EXPECT_EQ(hand.servo.latest().stroke, radius_m > 0 ? 1 : 0);
  }
}

TEST(BallTip, ItsTickNeverAllocates) {
  const Carved groove(v_groove, 128);
  Hand hand;
  long calls = 0;
  for (const double ball_m : {0.0, 0.0005, 0.002, 0.003, 1.0}) {
    auto scene = groove.scene(std::min(ball_m, 0.003));
    scene->tip_radius_m = ball_m;  // more than the largest counts as the largest
    scene->material.texture = Texture::stone;
    scene->material.static_friction = 0.4;
    scene->strokes.push_back({{{0, -0.04, -0.009}, {0, 0.04, -0.009}}});
    scene->guiding.mode = ball_m > 0.001 ? GuidingMode::lead : GuidingMode::off;
    hand.servo.set_scene(scene);
    const test::AllocGuard guard;
    for (int i = 0; i < 2000; ++i) {
      const Vec3 force = hand.at(
          {0.01 * std::sin(0.01 * i), 0.03 * std::sin(0.02 * i), -0.006 + 0.008 * std::sin(0.05 * i)});
      ASSERT_TRUE(std::isfinite(force.x) && std::isfinite(force.y) && std::isfinite(force.z));
    }
    calls += guard.calls();
  }
  EXPECT_EQ(calls, 0);
}

}  // namespace
}  // namespace nazori::haptics
