// SPDX-License-Identifier: Apache-2.0
// The default values of the structs of this room, as their headers say them.
#include <gtest/gtest.h>

#include <limits>

#include "../src/guidance.h"
#include "nazori/haptics/device_status.h"
#include "nazori/haptics/haptic_scene.h"
#include "nazori/haptics/servo.h"
#include "nazori/haptics/stroke_constraint.h"
#include "nazori/haptics/surface_contact.h"

namespace nazori::haptics {
namespace {

constexpr Vec3 kAbove{0, 0, 0.02};

TEST(HapticsDefaults, ADeviceThatSaysNothingIsAsCautiousAsASmallOne) {
  const DeviceLimits limits;
  EXPECT_EQ(limits.max_force_n, 3.3);
  EXPECT_EQ(limits.continuous_force_n, 0.88);
  EXPECT_EQ(limits.max_stiffness_n_m, 500);
  EXPECT_EQ(limits.max_damping_n_s_m, 2.5);
  EXPECT_EQ(limits.own_damping_n_s_m, 0.05);
  EXPECT_EQ(limits.max_slew_n_s, 200);
  EXPECT_EQ(limits.delay_s, 0);
  EXPECT_EQ(limits.hand_damping_n_s_m, 2.0);
  EXPECT_EQ(DeviceDescription{}.rate_hz, 1000);
  EXPECT_FALSE(DeviceDescription{}.has_force);
  const DeviceSample sample;
  EXPECT_EQ(sample.time_s, 0);
  EXPECT_EQ(sample.position_m, kAbove);
  EXPECT_EQ(sample.buttons, 0U);
  EXPECT_TRUE(sample.present);
  const DeviceStatus status;
  EXPECT_EQ(status.buttons, 0U);
  EXPECT_EQ(status.rate_hz, 0);
  EXPECT_EQ(status.delay_s, 0);
}

TEST(HapticsDefaults, AServoCallbackWithoutEventsReportsNone) {
  struct Silent final : ServoCallback {
    Vec3 tick(const DeviceSample& /*sample*/) noexcept override { return Vec3(0); }
  };
  EXPECT_EQ(Silent().events(), 0);
}

TEST(HapticsDefaults, ASceneHasAFirmSmoothSurfaceAndNothingThatPulls) {
  const HapticScene scene;
  EXPECT_EQ(scene.material.stiffness, 0.8);
  EXPECT_EQ(scene.material.damping, 0);
  EXPECT_EQ(scene.material.static_friction, 0);
  EXPECT_EQ(scene.material.dynamic_friction, 0);
  EXPECT_EQ(scene.material.popthrough, 0);
  EXPECT_EQ(scene.material.texture, Texture::none);
  EXPECT_EQ(scene.material.roughness, 0.5);
  EXPECT_FALSE(scene.snapping.enabled);
  EXPECT_EQ(scene.snapping.stiffness, 0.2);
  EXPECT_EQ(scene.snapping.snap_distance_m, 0);
  EXPECT_EQ(scene.snapping.stroke, 0);
  EXPECT_EQ(scene.snapping.release_force_n, 0);
  EXPECT_EQ(scene.guiding.mode, GuidingMode::off);
  EXPECT_EQ(scene.guiding.strength, 1);
  EXPECT_EQ(scene.guiding.stroke, 1);
  EXPECT_EQ(scene.guiding.attempt, 0U);
  EXPECT_EQ(scene.guiding.cap_n, 0.8);
  EXPECT_EQ(scene.guiding.speed_m_s, 0.04);
  EXPECT_EQ(scene.guiding.disturbance_n, 0.4);
  EXPECT_EQ(scene.guiding.seed, 1U);
  const SoftTip tip;
  EXPECT_EQ(tip.step_m, 0.001);
  EXPECT_EQ(tip.friction, 0.3);
  EXPECT_EQ(tip.along_hair, 0);
  EXPECT_EQ(tip.sideways_n_m, 10);
  EXPECT_EQ(tip.tow_m, 0.02);
  EXPECT_EQ(FrictionZones{}.size, 0);
  EXPECT_EQ(Friction{}.hold, 0);
  EXPECT_EQ(Friction{}.slide, 0);
}

TEST(HapticsDefaults, BeforeTheFirstTickNothingIsFeltReachedOrCounted) {
  Servo servo{DeviceDescription{}};
  for (const ServoSample& s : {ServoSample{}, servo.latest()}) {
    EXPECT_EQ(s.tick, 0U);
    EXPECT_EQ(s.time_s, 0);
    EXPECT_EQ(s.begun_s, 0);
    EXPECT_EQ(s.device_m, kAbove);
    EXPECT_EQ(s.proxy_m, kAbove);
    EXPECT_EQ(s.guide_m, kAbove);
    EXPECT_EQ(s.force_n, Vec3(0));
    EXPECT_EQ(s.progress_m, 0);
    EXPECT_EQ(s.off_m, 0);
    EXPECT_FALSE(s.touching);
    EXPECT_EQ(s.stroke, 0);
    EXPECT_EQ(s.guided_stroke, 0);
    EXPECT_EQ(s.done_stroke, 0);
    EXPECT_EQ(s.buttons, 0U);
    EXPECT_EQ(s.events, 0);
  }
  for (const ServoTiming& t : {ServoTiming{}, servo.timing()}) {
    EXPECT_EQ(t.ticks, 0U);
    EXPECT_EQ(t.late_ticks, 0U);
    EXPECT_EQ(t.missed_ticks, 0U);
    EXPECT_EQ(t.dropped_samples, 0U);
    EXPECT_EQ(t.mean_tick_s, 0);
    EXPECT_EQ(t.max_tick_s, 0);
    EXPECT_EQ(t.max_lateness_s, 0);
  }
}

TEST(HapticsDefaults, APlaceThatWasNotFoundIsNowhere) {
  const StrokeIndex::Hit hit;
  EXPECT_EQ(hit.point, Vec3(0));
  EXPECT_EQ(hit.squared_m2, std::numeric_limits<double>::infinity());
  EXPECT_EQ(hit.segment, -1);
  EXPECT_EQ(hit.along, 0);
  const StrokeConstraint snap;
  EXPECT_EQ(snap.stroke(), 0);
  EXPECT_EQ(snap.segment(), -1);
  EXPECT_EQ(snap.point_m(), Vec3(0));
  EXPECT_EQ(snap.force_n(), Vec3(0));
  const StrokeConstraint::Settings held;
  EXPECT_EQ(held.stiffness_n_m, 100);
  EXPECT_EQ(held.snap_distance_m, 0.01);
  EXPECT_EQ(held.release_distance_m, 0.0105);
  const TabletSurface::Place flat;
  for (const double value : {flat.x, flat.y, flat.z, flat.zx, flat.zy, flat.zxx, flat.zxy, flat.zyy})
    EXPECT_EQ(value, 0);
  const Guidance::Settings guide;
  EXPECT_EQ(guide.mode, GuidingMode::off);
  for (const double value :
       {guide.strength, guide.cap_n, guide.stiffness_n_m, guide.damping_n_s_m, guide.disturbance_n})
    EXPECT_EQ(value, 0);
}

// Recordings and other programs keep these numbers.
TEST(HapticsDefaults, EveryEventIsABitOfItsOwn) {
  unsigned bit = 1;
  for (const ServoEvent event :
       {ServoEvent::touch, ServoEvent::untouch, ServoEvent::capture, ServoEvent::release, ServoEvent::fault,
        ServoEvent::wrong_start, ServoEvent::wrong_direction, ServoEvent::stroke_done,
        ServoEvent::lesson_done, ServoEvent::resisted, ServoEvent::resumed}) {
    EXPECT_EQ(static_cast<unsigned>(event), bit);
    bit *= 2;
  }
  EXPECT_EQ(static_cast<unsigned>(ServoEvent::none), 0U);
}

}  // namespace
}  // namespace nazori::haptics
