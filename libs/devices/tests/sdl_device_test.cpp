// SPDX-License-Identifier: Apache-2.0
#include "sdl_device.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <numbers>
#include <vector>

#include "felt_plane.h"
#include "sdl_back_end.h"
#include "standins/sdl_standin.h"

namespace nazori::devices {
namespace {

using haptics::DeviceState;
using haptics::DeviceTrouble;
using haptics::ServoEvent;
using standin::Stick;
using standin::StickPort;
using test::comes_true;
using test::FeltPlane;
using test::Vec3;

class GameControllers : public testing::Test {
 protected:
  std::shared_ptr<StickPort> port = std::make_shared<StickPort>();
  std::unique_ptr<BackEnd> back_end = sdl::back_end(port);

  OpenedDevice opened(const OpenRequest& request = {}) {
    auto device = back_end->open("sdl", request);
    EXPECT_TRUE(device) << base::to_line(device.error().error);
    return std::move(*device);
  }
  /// A V-shaped groove from top to bottom through the middle, 40 mm wide.
  static std::shared_ptr<const haptics::HapticScene> groove() {
    constexpr int kSize = 101;  // a sample each millimetre
    auto map = surface::HeightMap::create(kSize, 1.0F);
    for (int row = 0; row < kSize; ++row) {
      for (int column = 0; column < kSize; ++column)
        map->set(column, row, std::min(1.0F, static_cast<float>(std::abs(column - 50)) / 20.0F));
    }
    auto scene = std::make_shared<haptics::HapticScene>();
    scene->surface = *surface::SmoothSurface::create(*map);
    return scene;
  }
};

TEST_F(GameControllers, AreListedByModelAndOnlyAPlanarForceIsChosenByItself) {
  EXPECT_EQ(back_end->find().problem->trouble, DeviceTrouble::device_absent);
  EXPECT_NE(base::to_line(back_end->find().problem->error).find("plug it in"), std::string::npos);
  port->plug_in("Pad", standin::kPad);
  port->plug_in("Pad", standin::kPad);
  port->plug_in("Wheel", standin::kWheel);
  port->plug_in("Stick", standin::kForceStick);
  const BackEndFindings found = back_end->find();
  ASSERT_EQ(found.devices.size(), 4U);
  EXPECT_FALSE(found.problem);
  EXPECT_EQ(found.devices[0].id, "sdl:guid-of-Pad");
  EXPECT_EQ(found.devices[1].id, "sdl:guid-of-Pad.2");
  EXPECT_FALSE(found.devices[0].has_force);
  EXPECT_FALSE(found.devices[0].automatic);
  EXPECT_TRUE(found.devices[2].has_force);
  EXPECT_FALSE(found.devices[2].automatic);
  EXPECT_TRUE(found.devices[3].has_force);
  EXPECT_TRUE(found.devices[3].automatic);
  EXPECT_EQ(back_end->open("sdl:guid-of-Pad.2", {})->id, "sdl:guid-of-Pad.2");
  EXPECT_EQ(back_end->open("sdl:guid-of-Pad.3", {}).error().trouble, DeviceTrouble::device_absent);
}

TEST_F(GameControllers, TheStickCoversTheTabletAndTheTriggerPressesDown) {
  const auto stick = port->plug_in("Stick", standin::kForceStick);
  FeltPlane plane;
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(comes_true([&] { return plane.present > 0 && std::abs(plane.z_m - 0.005) < 1e-9; }));
  EXPECT_NEAR(plane.x_m, 0, 1e-9);
  stick->x = 1;
  stick->y = -1;
  stick->press = 1;
  stick->buttons = 5;
  // The whole tablet of 100 mm with a margin of a tenth; below its deepest groove of 10 mm.
  EXPECT_TRUE(comes_true([&] { return std::abs(plane.x_m - 0.055) < 1e-6 && plane.z_m < -0.010; }));
  EXPECT_TRUE(comes_true([&] { return std::abs(plane.y_m + 0.055) < 1e-6; }));
  EXPECT_TRUE(comes_true([&] { return device.device->status().buttons == 5U; }));
  // A full press goes 15 % deeper than the groove, half a press half as deep.
  EXPECT_TRUE(comes_true([&] { return std::abs(plane.z_m + 0.0115) < 1e-6; }));
  stick->press = 0.5;
  EXPECT_TRUE(comes_true([&] { return std::abs(plane.z_m + 0.00575) < 1e-6; }));
}

TEST_F(GameControllers, ThePlaneOfTheStickIsTheTabletsHoweverItShouldStand) {
  const auto stick = port->plug_in("Stick", standin::kForceStick);
  OpenRequest flat;
  flat.posture = {0, 0.5, WritingHand::left};
  flat.calibration.emplace();
  flat.calibration->posture.tilt_rad = 0;
  FeltPlane plane;
  OpenedDevice device = opened(flat);
  EXPECT_EQ(port->hand, WritingHand::left);
  EXPECT_EQ(device.calibration.posture.tilt_rad, std::numbers::pi / 2);
  stick->y = 1;
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(comes_true([&] { return std::abs(plane.y_m - 0.060) < 1e-6; }));
  EXPECT_TRUE(comes_true([&] { return std::abs(plane.z_m - 0.005) < 1e-6; }));
}

TEST_F(GameControllers, APadsRoundRimReachesTheSquareTabletsCorners) {
  const auto pad = port->plug_in("Pad", standin::kPad);
  FeltPlane plane;
  OpenedDevice device = opened();
  EXPECT_FALSE(device.device->describe().has_force);
  pad->x = pad->y = std::sqrt(0.5);
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(comes_true([&] { return std::abs(plane.x_m - 0.055) < 1e-6; }));
  EXPECT_TRUE(comes_true([&] { return std::abs(plane.y_m - 0.055) < 1e-6; }));
  // Half of the way that a worn stick has, which is 95 %, is half of the tablet's.
  pad->x = 0.475;
  pad->y = 0;
  EXPECT_TRUE(comes_true([&] { return std::abs(plane.x_m - 0.0275) < 1e-6; }));
  EXPECT_TRUE(comes_true([&] { return std::abs(plane.y_m) < 1e-6; }));
  pad->x = pad->y = -0.475 * std::sqrt(0.5);
  EXPECT_TRUE(comes_true([&] { return std::abs(plane.x_m + 0.0275) < 1e-6; }));
  EXPECT_TRUE(comes_true([&] { return std::abs(plane.y_m + 0.0275) < 1e-6; }));
}

TEST_F(GameControllers, APadsHumIsAPartOfAFullNewton) {
  const auto pad = port->plug_in("Pad", standin::kPad);
  test::Push push({0.312, -0.416, 0});  // 0.52 N: eight sixteenths
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(push));
  EXPECT_TRUE(comes_true([&] { return pad->anything_runs(); }));
  device.device->stop();
  EXPECT_EQ(pad->most_low, 0x3000);
}

TEST_F(GameControllers, GrooveWallsPushTowardsTheMiddleOfTheGroove) {
  const auto stick = port->plug_in("Stick", standin::kForceStick);
  OpenedDevice device = opened();
  haptics::Servo servo(device.device->describe());
  servo.set_scene(groove());
  test::UnhurriedServo unhurried(servo, 1000);
  stick->press = 1;
  stick->x = 0.18;  // 10 mm to the right of the middle
  ASSERT_TRUE(device.device->start(unhurried));
  EXPECT_TRUE(comes_true([&] { return stick->push_right() < -0.03; })) << stick->push_right();
  EXPECT_NEAR(stick->push_up(), 0, 0.02);
  stick->x = -0.18;
  EXPECT_TRUE(comes_true([&] { return stick->push_right() > 0.03; })) << stick->push_right();
  stick->press = 0;
  EXPECT_TRUE(comes_true([&] { return !stick->anything_runs(); }));
  device.device->stop();
}

TEST_F(GameControllers, TheForceIsAPartOfTheFullOneAndNeverMore) {
  const auto stick = port->plug_in("Stick", standin::kForceStick);
  test::Push push({0.6, -1.2, 0});
  OpenedDevice device = opened();
  EXPECT_EQ(device.device->describe().limits.max_force_n, 3);
  ASSERT_TRUE(device.device->start(push));
  EXPECT_TRUE(comes_true([&] { return std::abs(stick->push_right() - 0.2) < 1e-3; }));
  EXPECT_NEAR(stick->push_up(), -0.4, 1e-3);
  EXPECT_EQ(device.device->status().state, DeviceState::running);
  device.device->stop();
  EXPECT_EQ(device.device->status().state, DeviceState::stopped);
  EXPECT_FALSE(stick->anything_runs());
  EXPECT_TRUE(stick->effects.empty());
  test::Push strong({300, 0, 0});
  ASSERT_TRUE(device.device->start(strong));
  EXPECT_TRUE(comes_true([&] { return stick->push_right() > 0.999; }));
  device.device->stop();
}

TEST_F(GameControllers, AServoThatStandsStillDoesNotGoOnPushing) {
  const auto stick = port->plug_in("Stick", standin::kForceStick);
  test::StuckPush servo({1, 0, 0});
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(servo));
  EXPECT_TRUE(comes_true([&] { return stick->push_right() > 0.3; }));
  servo.stick();
  EXPECT_TRUE(comes_true([&] { return !stick->anything_runs(); }));
  servo.go_on();
  EXPECT_TRUE(comes_true([&] { return stick->push_right() > 0.3; }));
}

TEST_F(GameControllers, ThePenIsHeldBackWhileItIsPressedDown) {
  const auto stick = port->plug_in("Stick", standin::kForceStick);
  test::Push push({1, 0, 0});
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(push));
  EXPECT_TRUE(comes_true([&] { return stick->push_right() > 0.3; }));
  EXPECT_FALSE(stick->effect(SDL_HAPTIC_DAMPER).running);
  stick->press = 0.2;
  EXPECT_TRUE(comes_true([&] { return stick->effect(SDL_HAPTIC_DAMPER).running; }));
}

TEST_F(GameControllers, WhatTheyAreTakenForIsWhatTheDocumentationSays) {
  // docs/devices.md: 3 N, 300 N/m, 18 ms.
  const haptics::DeviceLimits limits = sdl::stick_limits(standin::kForceStick);
  EXPECT_EQ(limits.max_force_n, 3);
  EXPECT_EQ(limits.continuous_force_n, 3);
  EXPECT_EQ(limits.max_stiffness_n_m, 300);
  EXPECT_EQ(limits.max_damping_n_s_m, 1);
  EXPECT_EQ(limits.own_damping_n_s_m, 0.2);
  EXPECT_NEAR(limits.delay_s, 0.018, 1e-12);
  EXPECT_EQ(sdl::stick_limits(standin::kPad).delay_s, 0);
}

/// Stores every sample with a stylus. Read them after the device has stopped.
class PathOfStick final : public haptics::ServoCallback {
 public:
  PathOfStick() { samples.reserve(100'000); }
  Vec3 tick(const haptics::DeviceSample& sample) noexcept override {
    if (sample.present && samples.size() < samples.capacity()) samples.push_back(sample.position_m);
    newest_x_m = sample.position_m.x;
    return Vec3(0);
  }
  std::vector<Vec3> samples;
  std::atomic<double> newest_x_m{0};
};

TEST_F(GameControllers, AStickIsFollowedFromWhereItIsThroughTwoLowPassFilters) {
  const auto stick = port->plug_in("Stick", standin::kForceStick);
  stick->x = -0.5;
  PathOfStick path;
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(path));
  EXPECT_TRUE(comes_true([&] { return path.newest_x_m < 0; }));
  stick->x = 0.5;
  EXPECT_TRUE(comes_true([&] { return std::abs(path.newest_x_m - 0.0275) < 1e-6; }));
  device.device->stop();
  const auto& all = path.samples;
  std::size_t begun = 0;
  while (begun < all.size() && std::abs(all[begun].x + 0.0275) < 1e-12) ++begun;
  EXPECT_GT(begun, 0U) << "it does not sweep there from the middle";
  // Each filter of 8 ms leaves 8/9 of the way in a tick of 1 ms.
  ASSERT_GT(all.size(), begun + 50);
  for (int i = 0; i < 50; ++i) {
    const double left = std::pow(8.0 / 9, i + 1) * (1 + (i + 1) / 9.0);
    ASSERT_NEAR(all[begun + static_cast<std::size_t>(i)].x, 0.0275 - 0.055 * left, 1e-12) << i;
  }
}

/// Reports the same event each time.
class Teller final : public haptics::ServoCallback {
 public:
  Vec3 tick(const haptics::DeviceSample&) noexcept override { return Vec3(0); }
  [[nodiscard]] std::uint16_t events() const noexcept override { return reported_events; }
  std::atomic<std::uint16_t> reported_events{0};
};

TEST_F(GameControllers, WhatTheServoTellsIsFeltOnAPad) {
  const auto pad = port->plug_in("Pad", standin::kPad);
  Teller servo;
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(servo));
  servo.reported_events = static_cast<std::uint16_t>(ServoEvent::wrong_start);
  EXPECT_TRUE(comes_true([&] { return pad->anything_runs(); }));
  servo.reported_events = 0;
  EXPECT_TRUE(comes_true([&] { return !pad->anything_runs(); }));
  EXPECT_GT(pad->most_low, 0);
  EXPECT_GT(pad->most_high, 0);
}

TEST_F(GameControllers, TheRealServoTellsThatAGrooveTookHold) {
  const auto pad = port->plug_in("Pad", standin::kPad);
  OpenedDevice device = opened();
  haptics::Servo servo(device.device->describe());
  auto scene = std::make_shared<haptics::HapticScene>(*groove());
  scene->strokes.push_back({{Vec3(0, 0.04, -0.01), Vec3(0, -0.04, -0.01)}});
  scene->snapping.enabled = true;
  servo.set_scene(scene);
  test::UnhurriedServo unhurried(servo, 1000);
  ASSERT_TRUE(device.device->start(unhurried));
  pad->press = 1;
  EXPECT_TRUE(comes_true([&] {
    const std::lock_guard one(pad->lock);
    return pad->most_high > 0;
  }));
  device.device->stop();
}

TEST_F(GameControllers, UnpluggedInMidRunItIsLostAndPluggedInItIsFoundAgain) {
  auto stick = port->plug_in("Stick", standin::kForceStick);
  test::Push push({1, 0, 0});
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(push));
  EXPECT_TRUE(comes_true([&] { return stick->push_right() > 0.3; }));
  EXPECT_EQ(back_end->find().problem->trouble, DeviceTrouble::in_use);
  EXPECT_EQ(back_end->open("sdl", {}).error().trouble, DeviceTrouble::in_use);
  stick->attached = false;
  port->plugged.clear();
  EXPECT_EQ(test::comes_to(*device.device, DeviceState::lost, DeviceTrouble::communication_lost).message,
            "Stick: the connection was lost (check the cable and the power, then select the device again)");
  EXPECT_TRUE(comes_true([&] { return !stick->anything_runs(); }));
  EXPECT_EQ(back_end->find().problem->trouble, DeviceTrouble::device_absent);
  const auto again = port->plug_in("Stick", standin::kForceStick);
  EXPECT_EQ(back_end->find().devices.front().id, device.id);  // while the lost one is still open
  device.device->stop();
  EXPECT_EQ(device.device->status().state, DeviceState::lost);
  EXPECT_FALSE(device.device->start(push));
  device = opened();
  ASSERT_TRUE(device.device->start(push));
  EXPECT_TRUE(comes_true([&] { return again->push_right() > 0.3; }));
}

TEST_F(GameControllers, ADeviceThatTakesNoEffectsAnyMoreIsLost) {
  const auto stick = port->plug_in("Stick", standin::kForceStick);
  test::Push push({1, 0, 0});
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(push));
  EXPECT_FALSE(device.device->start(push));  // once is enough
  EXPECT_TRUE(comes_true([&] { return stick->push_right() > 0.3; }));
  stick->refuses_effects = true;
  EXPECT_TRUE(comes_true([&] { return device.device->status().trouble == DeviceTrouble::device_fault; }));
  EXPECT_TRUE(comes_true([&] { return !stick->anything_runs(); }));
  device.device->stop();
  EXPECT_FALSE(device.device->start(push));  // it refuses from the beginning
  stick->refuses_effects = false;
  EXPECT_TRUE(device.device->start(push));
  EXPECT_TRUE(comes_true([&] { return stick->push_right() > 0.3; }));
}

TEST_F(GameControllers, WhatDoesNotOpenIsSaidInOneLine) {
  port->starts = false;
  EXPECT_EQ(back_end->find().problem->trouble, DeviceTrouble::init_failed);
  EXPECT_EQ(back_end->open("sdl", {}).error().trouble, DeviceTrouble::init_failed);
  port->starts = true;
  port->plug_in("Pad", standin::kPad);
  port->opens = false;
  EXPECT_EQ(back_end->open("sdl", {}).error().trouble, DeviceTrouble::init_failed);
  port->opens = true;
  OpenRequest request;
  request.calibration.emplace();
  request.calibration->scale = -1;
  EXPECT_EQ(back_end->open("sdl", request).error().trouble, DeviceTrouble::bad_calibration);
}

TEST_F(GameControllers, PositionsThatAreNotNumbersGiveNoForce) {
  const auto stick = port->plug_in("Stick", standin::kForceStick);
  test::Push push({1, 0, 0});
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(push));
  EXPECT_TRUE(comes_true([&] { return stick->push_right() > 0.3; }));
  stick->x = std::nan("");
  EXPECT_TRUE(comes_true([&] { return device.device->status().trouble == DeviceTrouble::bad_message; }));
  EXPECT_TRUE(comes_true([&] { return !stick->anything_runs(); }));
}

}  // namespace
}  // namespace nazori::devices
