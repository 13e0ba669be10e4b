// SPDX-License-Identifier: Apache-2.0
// What a scene becomes for one device: every coefficient in closed form.
#include "../src/servo_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <tuple>
#include <utility>

#include "relief.h"

namespace nazori::haptics {
namespace {

using test::plate;
using test::Relief;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A device that can render all that is required of it: 1 kHz, b = 4 N s/m, so 8000 N/m are passive.
DeviceDescription strong() {
  DeviceDescription device;
  device.limits.max_force_n = 8;
  device.limits.max_stiffness_n_m = 1000;
  device.limits.max_damping_n_s_m = 3;
  device.limits.own_damping_n_s_m = 1;
  device.limits.hand_damping_n_s_m = 3;
  return device;
}

StrokePath level_line() { return {{{0, 0, -0.005}, {0.02, 0, -0.005}}}; }

/// A plate of 64 samples with one stroke, and the scene that the servo makes from it.
class Scene {
 public:
  Scene() : from(plate64().scene()) { from->strokes = {level_line()}; }
  [[nodiscard]] ServoScene made(const ServoScene* before = nullptr) const {
    return {from, device, 7, before};
  }
  static const Relief& plate64() {
    static const Relief relief(64, 0.01, plate);
    return relief;
  }

  DeviceDescription device = strong();
  std::shared_ptr<HapticScene> from;
};

TEST(ServoScene, AMaterialIsThatFractionOfWhatTheDeviceRenders) {
  Scene scene;
  scene.from->material.stiffness = 0.6;
  scene.from->material.damping = 0.25;
  scene.from->material.popthrough = 0.5;
  scene.from->material.texture = Texture::wood;
  scene.from->material.roughness = 0.75;
  const ServoScene made = scene.made();
  EXPECT_DOUBLE_EQ(made.stiffness_n_m, 600);
  EXPECT_DOUBLE_EQ(made.damping_n_s_m, 0.75);
  EXPECT_DOUBLE_EQ(made.popthrough_n, 4);
  EXPECT_EQ(made.texture, Texture::wood);
  EXPECT_DOUBLE_EQ(made.roughness, 0.75);
  EXPECT_EQ(made.generation, 7U);
  EXPECT_TRUE(made.surface.exists());
}

TEST(ServoScene, FractionsEndAtNothingAndAtAllAndWhatIsNoNumberIsNothing) {
  for (const auto& [given, part] : {std::pair{-0.1, 0.0}, {1.5, 1.0}, {kNan, 0.0}, {kInfinity, 0.0}}) {
    Scene scene;
    scene.from->material.stiffness = given;
    scene.from->material.popthrough = given;
    scene.from->material.roughness = given;
    scene.from->material.texture = Texture::stone;
    const ServoScene made = scene.made();
    EXPECT_EQ(made.stiffness_n_m, 1000 * part) << given;
    EXPECT_EQ(made.popthrough_n, 8 * part) << given;
    EXPECT_EQ(made.roughness, part) << given;
    EXPECT_EQ(made.texture, part > 0 ? Texture::stone : Texture::none) << given;
  }
}

TEST(ServoScene, DampingIsAtMostHalfOfWhatHandAndJointsDamp) {
  Scene scene;
  scene.device.limits.max_damping_n_s_m = 10;
  scene.from->material.damping = 0.19;
  EXPECT_DOUBLE_EQ(scene.made().damping_n_s_m, 1.9);
  scene.from->material.damping = 0.3;
  EXPECT_DOUBLE_EQ(scene.made().damping_n_s_m, 2) << "(1 + 3) / 2";
}

TEST(ServoScene, FrictionIsHeldBetweenNothingAndTenAndSlidingNeverHoldsMore) {
  Scene scene;
  Material& material = scene.from->material;
  const auto made = [&](double hold, double slide) {
    material.static_friction = hold;
    material.dynamic_friction = slide;
    const ServoScene of = scene.made();
    return std::pair(of.frictions.at(0).hold, of.frictions.at(0).slide);
  };
  EXPECT_EQ(made(0.5, 0.25), std::pair(0.5, 0.25));
  EXPECT_EQ(made(0.5, 0.75), std::pair(0.5, 0.5));
  EXPECT_EQ(made(-1, -1), std::pair(0.0, 0.0));
  EXPECT_EQ(made(9.5, 9), std::pair(9.5, 9.0));
  EXPECT_EQ(made(11, 12), std::pair(10.0, 10.0));
  EXPECT_EQ(made(kNan, 1), std::pair(0.0, 0.0));
}

TEST(ServoScene, ASurfaceNeedsAWidthAndADepth) {
  for (const geometry::TabletShape shape :
       {geometry::TabletShape{0, 0.01}, {0.1, 0}, {-0.1, 0.01}, {0.1, -1}}) {
    Scene scene;
    scene.from->shape = shape;
    EXPECT_FALSE(scene.made().surface.exists());
  }
  Scene nothing;
  nothing.from->surface = nullptr;
  EXPECT_FALSE(nothing.made().surface.exists());
  EXPECT_FALSE((ServoScene{nullptr, strong(), 1, nullptr}.surface.exists()));
}

TEST(ServoScene, SnappingPullsWithItsFractionFromTheDistanceAtWhichFiveNewtonsPull) {
  Scene scene;
  scene.from->snapping.enabled = true;
  scene.from->snapping.stiffness = 0.15;
  scene.from->material.stiffness = 0.5;
  ServoScene made = scene.made();
  EXPECT_FALSE(made.strokes.empty());
  EXPECT_DOUBLE_EQ(made.snap.stiffness_n_m, 150);
  EXPECT_DOUBLE_EQ(made.stiffness_n_m, 500);
  EXPECT_DOUBLE_EQ(made.snap.snap_distance_m, 0.005) << "5 N / 1000 N/m: the rule of 2005";
  EXPECT_DOUBLE_EQ(made.snap.release_distance_m, 1.05 * 0.005);
  scene.from->snapping.snap_distance_m = 0.002;
  made = scene.made();
  EXPECT_DOUBLE_EQ(made.snap.snap_distance_m, 0.002);
  EXPECT_DOUBLE_EQ(made.snap.release_distance_m, 0.0021);
  scene.from->snapping.release_force_n = 0.6;
  EXPECT_DOUBLE_EQ(scene.made().snap.release_distance_m, 0.004) << "0.6 N / 150 N/m";
  scene.from->snapping.release_force_n = 0.3;
  EXPECT_DOUBLE_EQ(scene.made().snap.release_distance_m, 0.0021) << "never nearer than it catches";
  for (const double no_force : {-1.0, kNan, kInfinity}) {
    scene.from->snapping.release_force_n = no_force;
    EXPECT_DOUBLE_EQ(scene.made().snap.release_distance_m, 0.0021) << no_force;
  }
  scene.from->snapping.release_force_n = 0.3;
  scene.from->snapping.stiffness = 0;
  EXPECT_DOUBLE_EQ(scene.made().snap.release_distance_m, 0.0021) << "no spring, no force to wait for";
}

TEST(ServoScene, SnappingHoldsOneStrokeOrAll) {
  Scene scene;
  scene.from->strokes = {level_line(), level_line()};
  scene.from->snapping.enabled = true;
  for (const int stroke : {-1, 0, 1, 2}) {
    scene.from->snapping.stroke = stroke;
    const ServoScene made = scene.made();
    EXPECT_EQ(made.strokes.at_length(1, 0).segment >= 0, stroke < 2) << stroke;
    EXPECT_EQ(made.strokes.at_length(2, 0).segment >= 0, stroke != 1) << stroke;
  }
  scene.from->snapping.enabled = false;
  EXPECT_TRUE(scene.made().strokes.empty());
}

TEST(ServoScene, SurfaceAndPullTogetherStayWithinTheDeviceInTheirRatio) {
  Scene scene;
  scene.from->snapping.enabled = true;
  scene.from->snapping.stiffness = 0.8;
  scene.from->material.stiffness = 0.8;
  EXPECT_DOUBLE_EQ(scene.made().stiffness_n_m, 500);
  EXPECT_DOUBLE_EQ(scene.made().snap.stiffness_n_m, 500);
  scene.from->snapping.stiffness = 0.2;
  EXPECT_DOUBLE_EQ(scene.made().stiffness_n_m, 800) << "exactly all";
  scene.from->snapping.stiffness = 0.4;
  EXPECT_NEAR(scene.made().stiffness_n_m, 1000 * 2 / 3.0, 1e-9);
  EXPECT_NEAR(scene.made().snap.stiffness_n_m, 1000 / 3.0, 1e-9);
}

TEST(ServoScene, SurfaceAndPullTogetherArePassiveAtTheRateAndDelayOfTheDevice) {
  Scene scene;
  scene.device.rate_hz = 500;
  scene.device.limits.delay_s = 0.004;
  scene.from->material.stiffness = 1;
  scene.from->material.damping = 0.5;
  EXPECT_NEAR(scene.made().stiffness_n_m, (4 - 1.5) / (0.001 + 0.004), 1e-9);
}

TEST(ServoScene, ARateThatIsNoneCountsAsOneKilohertz) {
  for (const double rate : {0.0, -1.0, kNan, kInfinity}) {
    Scene scene;
    scene.device.rate_hz = rate;
    scene.device.limits.max_stiffness_n_m = 1e6;
    scene.from->material.stiffness = 1;
    EXPECT_NEAR(scene.made().stiffness_n_m, 4 / 0.0005, 1e-6) << rate;
  }
}

TEST(ServoScene, GuidanceHoldsWithAFifthOfTheDeviceAndNeverAsAWall) {
  for (const GuidingMode mode : {GuidingMode::lesson, GuidingMode::lead}) {
    Scene scene;
    scene.from->guiding.mode = mode;
    scene.from->material.stiffness = 0.5;
    EXPECT_DOUBLE_EQ(scene.made().guide.stiffness_n_m, 200);
    scene.device.limits.max_stiffness_n_m = 2000;
    EXPECT_DOUBLE_EQ(scene.made().guide.stiffness_n_m, 250);
    EXPECT_DOUBLE_EQ(scene.made().stiffness_n_m, 1000);
    scene.from->snapping.enabled = true;
    EXPECT_TRUE(scene.made().strokes.empty()) << "one pull at a time";
  }
}

TEST(ServoScene, ADisturbanceHoldsNothingAndLeavesSnappingOn) {
  Scene scene;
  scene.from->guiding.mode = GuidingMode::disturb;
  scene.from->snapping.enabled = true;
  const ServoScene made = scene.made();
  EXPECT_EQ(made.guide.stiffness_n_m, 0);
  EXPECT_EQ(made.guide.mode, GuidingMode::disturb);
  EXPECT_FALSE(made.strokes.empty());
  EXPECT_EQ(made.plan.strokes(), 1);
}

TEST(ServoScene, WithoutGuidanceThereIsNoPlan) {
  const ServoScene made = Scene().made();
  EXPECT_EQ(made.plan.strokes(), 0);
  EXPECT_EQ(made.guide.mode, GuidingMode::off);
  EXPECT_EQ(made.guide.cap_n, 0);
}

TEST(ServoScene, ForcesOfGuidanceEndAtOneNewtonAndAtWhatTheDeviceCan) {
  Scene scene;
  Guiding& guiding = scene.from->guiding;
  guiding.mode = GuidingMode::lesson;
  guiding.strength = 0.7;
  guiding.cap_n = 0.6;
  guiding.disturbance_n = 0.3;
  EXPECT_EQ(scene.made().guide.strength, 0.7);
  EXPECT_EQ(scene.made().guide.cap_n, 0.6);
  EXPECT_EQ(scene.made().guide.disturbance_n, 0.3);
  guiding.strength = guiding.cap_n = guiding.disturbance_n = 2;
  EXPECT_EQ(scene.made().guide.strength, 1);
  EXPECT_EQ(scene.made().guide.cap_n, 1);
  EXPECT_EQ(scene.made().guide.disturbance_n, 1);
  scene.device.limits.max_force_n = 0.5;
  EXPECT_EQ(scene.made().guide.cap_n, 0.5);
  EXPECT_EQ(scene.made().guide.disturbance_n, 0.5);
}

TEST(ServoScene, CarryingDampsWithWhatTheSurfaceLeavesOfWhatIsPassive) {
  Scene scene;
  scene.from->guiding.mode = GuidingMode::lesson;
  scene.from->material.damping = 0.25;  // 0.75 of the 2 that are passive
  EXPECT_DOUBLE_EQ(scene.made().guide.damping_n_s_m, 1.25);
  scene.from->material.damping = 0.1;
  EXPECT_DOUBLE_EQ(scene.made().guide.damping_n_s_m, 1.5) << "and at most that";
  scene.device.limits.max_damping_n_s_m = 1;
  EXPECT_DOUBLE_EQ(scene.made().guide.damping_n_s_m, 1);
  scene.device.limits.max_damping_n_s_m = 30;
  scene.from->material.damping = 1;
  EXPECT_DOUBLE_EQ(scene.made().guide.damping_n_s_m, 0);
}

TEST(ServoScene, TheTeachersSpeedIsHeldBetweenFiveMillimetresAndTwoHundredASecond) {
  for (const auto& [asked, given] :
       {std::pair{0.004, 0.005}, {0.006, 0.006}, {0.04, 0.04}, {0.19, 0.19}, {0.3, 0.2}, {kNan, 0.005}}) {
    Scene scene;
    scene.from->strokes = {{{{0, 0, 0}, {1, 0, 0}}}};  // long enough for any speed
    scene.from->guiding.mode = GuidingMode::lead;
    scene.from->guiding.speed_m_s = asked;
    EXPECT_NEAR(scene.made().plan.speed_m_s(1, 0.5), given, 1e-6 * given) << asked;
  }
}

TEST(ServoScene, ALessonBeginsAtTheStrokeAskedForAndAtTheFirstAtTheEarliest) {
  Scene scene;
  scene.from->guiding.mode = GuidingMode::lesson;
  for (const auto& [asked, first] : {std::pair{-3, 1}, {0, 1}, {1, 1}, {2, 2}, {5, 5}}) {
    scene.from->guiding.stroke = asked;
    EXPECT_EQ(scene.made().first_stroke, first);
  }
}

TEST(ServoScene, ALessonGoesOnUnlessSomethingOfItIsAnother) {
  Scene first;
  first.from->guiding.mode = GuidingMode::lesson;
  const ServoScene before = first.made();
  EXPECT_EQ(before.lesson, 7U);
  const auto goes_on = [&](auto change) {
    Scene next;
    next.from->guiding = first.from->guiding;
    change(*next.from);
    const ServoScene made{next.from, next.device, 8, &before};
    EXPECT_TRUE(made.lesson == 7 || made.lesson == 8);
    return made.lesson == 7;
  };
  EXPECT_TRUE(goes_on([](HapticScene&) {}));
  EXPECT_TRUE(goes_on([](HapticScene& s) { s.guiding.strength = 0.1; }));
  EXPECT_TRUE(goes_on([](HapticScene& s) { s.guiding.cap_n = 0.1; }));
  EXPECT_TRUE(goes_on([](HapticScene& s) { s.material.stiffness = 0.1; }));
  EXPECT_FALSE(goes_on([](HapticScene& s) { s.guiding.mode = GuidingMode::lead; }));
  EXPECT_FALSE(goes_on([](HapticScene& s) { s.guiding.stroke = 2; }));
  EXPECT_FALSE(goes_on([](HapticScene& s) { s.guiding.attempt = 1; }));
  EXPECT_FALSE(goes_on([](HapticScene& s) { s.guiding.seed = 2; }));
  EXPECT_FALSE(goes_on([](HapticScene& s) { s.strokes.push_back(level_line()); }));
  EXPECT_FALSE(goes_on([](HapticScene& s) { s.strokes.clear(); }));
  EXPECT_FALSE(goes_on([](HapticScene& s) { s.strokes[0].points[1].x = 0.021; }));
  const ServoScene empty{nullptr, strong(), 3, nullptr};
  EXPECT_EQ((ServoScene{first.from, strong(), 4, &empty}.lesson), 4U);
}

TEST(ServoScene, FrictionIsThatOfTheNearestSampleAndBeyondTheEdgeTheMaterials) {
  // Samples 0.1 / 63 m apart; the upper left corner, the lower right one and one in between are zones.
  Scene scene;
  auto zones = std::make_shared<FrictionZones>();
  zones->size = 64;
  // Behind the last row the memory has another friction than the material.
  zones->zone.assign(64 * 65, 3);
  zones->zone.resize(64 * 64);
  std::fill(zones->zone.begin(), zones->zone.end(), 0);
  zones->added = {0.1, 0.2, 0.3};
  zones->zone[0] = 1;
  zones->zone[63 * 64 + 63] = 2;
  zones->zone[20 * 64 + 10] = 3;  // row 20, column 10
  scene.from->friction_zones = zones;
  const ServoScene made = scene.made();
  const auto at = [&](double x, double y) { return made.friction_at({x, y, 0}).hold; };
  constexpr double kStep = 0.1 / 63;
  constexpr double kIn = 0.49 * kStep, kOut = 0.51 * kStep;
  for (const auto& [x, y, hold] :
       {std::tuple{-0.05, 0.05, 0.1}, {0.05, -0.05, 0.2}, {-0.05 + 10 * kStep, 0.05 - 20 * kStep, 0.3}}) {
    EXPECT_EQ(at(x, y), hold);
    for (const Vec3 way : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0)}) {
      EXPECT_EQ(at(x + kIn * way.x, y + kIn * way.y), hold);
      EXPECT_EQ(at(x + kOut * way.x, y + kOut * way.y), 0);
    }
  }
  EXPECT_EQ(at(0, -0.05 - kOut), 0);
  for (const double far : {-1e9, 1e9, kNan}) {
    EXPECT_EQ(at(far, 0), 0);
    EXPECT_EQ(at(0, far), 0);
  }
}

TEST(ServoScene, ZonesThatDoNotCoverTheSurfaceAreLeftOut) {
  for (const std::size_t samples : {64U * 64U - 1, 64U * 64U, 64U * 64U + 1}) {
    Scene scene;
    auto zones = std::make_shared<FrictionZones>();
    zones->size = 64;
    zones->zone.assign(samples, 1);
    zones->added = {0.5};
    scene.from->friction_zones = zones;
    EXPECT_EQ(scene.made().zones != nullptr, samples == 64 * 64);
    scene.from->surface = nullptr;
    EXPECT_EQ(scene.made().zones, nullptr) << "nothing to touch";
  }
}

TEST(ServoScene, ASoftTipHasASheetInsteadOfASurface) {
  Scene scene;
  scene.from->soft_tip = std::make_shared<SoftTip>(SoftTip{0.005, {0, 0.1}});
  const ServoScene made = scene.made();
  EXPECT_FALSE(made.surface.exists());
  EXPECT_TRUE(made.soft.exists());
  EXPECT_EQ(made.soft_tip, scene.from->soft_tip.get());
  EXPECT_EQ(made.stiffness_n_m, 0);
  scene.from->soft_tip = std::make_shared<SoftTip>();  // without values there is no tip
  EXPECT_FALSE(scene.made().soft.exists());
  EXPECT_EQ(scene.made().soft_tip, nullptr);
}

TEST(ServoScene, NothingIsFeltWhereNothingWasGiven) {
  const ServoScene none{nullptr, strong(), 3, nullptr};
  EXPECT_EQ(none.lesson, 3U);
  EXPECT_EQ(none.first_stroke, 1);
  EXPECT_EQ(none.frictions.size(), 1U);
  for (const double value : {none.stiffness_n_m, none.damping_n_s_m, none.popthrough_n, none.roughness,
                             none.half_m, none.zones_per_m})
    EXPECT_EQ(value, 0);
  EXPECT_EQ(none.friction_at({0, 0, 0}).hold, 0);
}

}  // namespace
}  // namespace nazori::haptics
