// SPDX-License-Identifier: Apache-2.0
// What is felt and reported through OpenHaptics while nothing goes wrong.
#include <cmath>
#include <filesystem>
#include <iterator>
#include <numbers>
#include <utility>

#include "openhaptics_fixture.h"
#include "openhaptics_port.h"

namespace nazori::devices {
namespace {

using haptics::DeviceState;
using haptics::DeviceTrouble;
using test::comes_true;
using test::FeltPlane;
using test::OpenHaptics;
using test::Vec3;

TEST_F(OpenHaptics, IsFoundWithItsNameAndClosedAgain) {
  const BackEndFindings found = back_end->find();
  ASSERT_EQ(found.devices.size(), 1U);
  EXPECT_EQ(found.devices.front().id, "openhaptics");
  EXPECT_EQ(found.devices.front().name, "Stand-in Touch (serial 0042)");
  EXPECT_TRUE(found.devices.front().has_force);
  EXPECT_FALSE(found.problem);
  EXPECT_EQ(stage->inits, 1);
  EXPECT_EQ(stage->disables, 1);
}

TEST_F(OpenHaptics, LimitsAreReadInTheMakersUnitsAndSeenFromTheTablet) {
  OpenRequest request;
  request.calibration.emplace();
  const haptics::DeviceDescription d = opened(request).device->describe();
  EXPECT_TRUE(d.has_force);
  EXPECT_DOUBLE_EQ(d.limits.max_force_n, 3.3);
  EXPECT_DOUBLE_EQ(d.limits.continuous_force_n, 0.88);
  EXPECT_DOUBLE_EQ(d.limits.max_stiffness_n_m, 500);  // 0.5 N/mm
  EXPECT_DOUBLE_EQ(d.limits.max_damping_n_s_m, 2.5);  // 0.0025 N per mm/s
  request.calibration->scale = 0.5;
  EXPECT_DOUBLE_EQ(opened(request).device->describe().limits.max_stiffness_n_m, 1000);
}

TEST_F(OpenHaptics, ALargerDeviceIsUsedAsFarAsItGoes) {
  stage->large = true;
  stage->max_force_n = 7.9;
  OpenRequest request;
  request.calibration.emplace();
  {
    const OpenedDevice device = opened(request);
    const haptics::DeviceLimits limits = device.device->describe().limits;
    EXPECT_DOUBLE_EQ(limits.max_force_n, 7.9);
    EXPECT_DOUBLE_EQ(limits.continuous_force_n, 1.75);
    EXPECT_DOUBLE_EQ(limits.max_stiffness_n_m, 1000);
    EXPECT_DOUBLE_EQ(limits.max_damping_n_s_m, 5);
    EXPECT_LT(glm::distance(device.workspace.low_m, Vec3(-0.090, -0.070, -0.040)), 1e-12);
    EXPECT_LT(glm::distance(device.workspace.high_m, Vec3(0.070, 0.050, 0.080)), 1e-12);
  }
  stage->max_force_n = 1;
  EXPECT_DOUBLE_EQ(opened(request).device->describe().limits.continuous_force_n, 1);
}

TEST_F(OpenHaptics, GettersThatAnswerZeroGiveWayToTheFiguresOfAnOmni) {
  stage->dumb = true;
  OpenRequest request;
  request.calibration.emplace();
  const OpenedDevice device = opened(request);
  EXPECT_DOUBLE_EQ(device.device->describe().limits.max_force_n, 3.3);
  EXPECT_DOUBLE_EQ(device.device->describe().limits.max_stiffness_n_m, 500);
  EXPECT_DOUBLE_EQ(device.workspace.high_m.x, 0.080);
}

TEST_F(OpenHaptics, WhatTheLibraryRefusesToTellIsNotBelieved) {
  stage->refuses = true;
  stage->out_of_inkwell = false;
  OpenRequest request;
  request.calibration.emplace();
  FeltPlane plane;
  OpenedDevice device = opened(request);
  const haptics::DeviceDescription d = device.device->describe();
  EXPECT_EQ(d.name, "OpenHaptics device");
  EXPECT_DOUBLE_EQ(d.limits.max_force_n, 3.3);
  EXPECT_DOUBLE_EQ(d.limits.continuous_force_n, 0.88);
  EXPECT_DOUBLE_EQ(d.limits.max_stiffness_n_m, 500);
  EXPECT_DOUBLE_EQ(d.limits.max_damping_n_s_m, 2.5);
  const DeviceWorkspace usual;
  EXPECT_EQ(device.workspace.low_m, usual.low_m);
  EXPECT_EQ(device.workspace.high_m, usual.high_m);
  // Its switches are not asked for again, so that no tick has an error.
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(comes_true([&] { return plane.present > 100; }));
  EXPECT_EQ(device.device->status().trouble, DeviceTrouble::none);
}

TEST_F(OpenHaptics, TheCalibrationIsCheckedInEverySixtyFourthTick) {
  FeltPlane plane;
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(comes_true([&] { return plane.ticks > 150; }));
  device.device->stop();
  EXPECT_EQ(stage->checks, (plane.ticks + 63) / 64);
}

TEST_F(OpenHaptics, ItEndsWithFourTicksOfZeroAndOneZeroBehindThem) {
  test::Push push({0, 0, 1});
  OpenedDevice device = opened();
  // It waits for them for a fifth of a second. Tried again in case the machine paused for that long.
  EXPECT_TRUE(comes_true([&] {
    EXPECT_TRUE(device.device->start(push));
    EXPECT_TRUE(comes_true([&] { return pushes({0, 0, 1}); }));
    device.device->stop();
    return stage->zero_ticks == 5U;
  }));
}

TEST_F(OpenHaptics, LookingLeavesNoFileOpen) {
  const auto files = [] {
    const std::filesystem::directory_iterator all("/proc/self/fd");
    return std::distance(begin(all), end(all));
  };
  (void)back_end->find();
  const auto before = files();
  (void)back_end->find();
  EXPECT_EQ(files(), before);
}

TEST_F(OpenHaptics, AKnownPlaneIsFeltInNewtonsAlongTheTabletsNormal) {
  for (const double tilt : {std::numbers::pi / 2, std::numbers::pi / 3, 0.0}) {
    OpenRequest request;
    request.posture.tilt_rad = tilt;
    FeltPlane plane;
    OpenedDevice device = opened(request);
    const WorkspaceMapping mapping = *WorkspaceMapping::create(device.calibration);
    hold(mapping, {0.01, -0.02, 0.005});
    ASSERT_TRUE(device.device->start(plane));
    EXPECT_TRUE(comes_true([&] { return plane.present > 3; }));
    EXPECT_NEAR(plane.x_m, 0.01, 1e-9);
    EXPECT_NEAR(plane.y_m, -0.02, 1e-9);
    EXPECT_TRUE(comes_true([&] { return pushes(Vec3(0)); }));
    hold(mapping, {0.01, -0.02, -0.002});
    // 2 mm deep in the tablet, 200 N/m: 0.4 N, upwards for a flat tablet.
    EXPECT_TRUE(comes_true([&] { return pushes({0, 0.4 * std::cos(tilt), 0.4 * std::sin(tilt)}); }));
    device.device->stop();
    EXPECT_TRUE(comes_true([&] { return pushes(Vec3(0)); }));
    EXPECT_FALSE(stage->running);
  }
}

TEST_F(OpenHaptics, TheRealServoHoldsTheHandUpWithTheStiffnessOfItsMaterial) {
  OpenRequest request;
  request.calibration.emplace();
  OpenedDevice device = opened(request);
  haptics::Servo servo(device.device->describe());
  servo.set_scene(test::flat_tablet(0.8));
  test::UnhurriedServo unhurried(servo, 1000);
  stage->z_mm = -1.5;
  ASSERT_TRUE(device.device->start(unhurried));
  // 0.8 of 0.5 N/mm, 1.5 mm deep; the passivity of a resting hand takes nothing.
  EXPECT_TRUE(comes_true([&] { return std::abs(stage->force_z_n - 0.6) < 1e-6; })) << stage->force_z_n;
  EXPECT_NEAR(stage->force_x_n, 0, 1e-9);
  device.device->stop();
}

TEST_F(OpenHaptics, ButtonsAndRateAreSeenWithoutWaiting) {
  FeltPlane plane;
  OpenedDevice device = opened();
  EXPECT_EQ(device.device->status().state, DeviceState::stopped);
  ASSERT_TRUE(device.device->start(plane));
  stage->buttons = 3;
  EXPECT_TRUE(comes_true([&] { return device.device->status().buttons == 3U; }));
  EXPECT_TRUE(comes_true([&] { return device.device->status().delay_s > 0; }));
  EXPECT_EQ(plane.buttons, 3U);
  const haptics::DeviceStatus runs =
      test::comes_to(*device.device, DeviceState::running, DeviceTrouble::none);
  EXPECT_EQ(runs.state, DeviceState::running);
  EXPECT_GT(runs.rate_hz, 0);
  EXPECT_EQ(runs.message, "");
  device.device->stop();
  EXPECT_EQ(device.device->status().state, DeviceState::stopped);
}

TEST_F(OpenHaptics, NoForceLeavesThatIsOverThePeakOrNotANumber) {
  test::Push strong({0, 30, 40});
  test::Push mad({std::nan(""), 0, 0});
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(strong));
  EXPECT_TRUE(comes_true([&] { return std::abs(glm::length(force()) - 3.3) < 1e-6; }));
  device.device->stop();
  ASSERT_TRUE(device.device->start(mad));
  const std::uint64_t from = stage->ticks;
  EXPECT_TRUE(comes_true([&] { return stage->ticks > from + 5; }));
  EXPECT_TRUE(comes_true([&] { return pushes(Vec3(0)); }));
}

TEST_F(OpenHaptics, RunsAtTheRateAskedForAndAtTheUsualOneWhereTheDeviceRefusesIt) {
  const auto rate_at = [&](int asked_hz) {
    OpenHapticsSettings wanted = settings();
    wanted.rate_hz = asked_hz;
    FeltPlane plane;
    auto device = openhaptics_back_end(wanted)->open("openhaptics", {});
    EXPECT_TRUE(device && device->device->start(plane));
    return device->device->describe().rate_hz;
  };
  EXPECT_EQ(rate_at(1600), 1000);
  EXPECT_EQ(rate_at(500), 500);
  EXPECT_EQ(rate_at(2000), 2000);
}

TEST_F(OpenHaptics, WorksThoughAnotherDeviceOfTheProgramIsTheCurrentOne) {
  // In the stand-in the other one is current whenever a tick begins.
  const auto make_other_current = [this] { function<void (*)(unsigned int)>("hdMakeCurrentDevice")(1); };
  test::Push push({0, 0, 1});
  make_other_current();
  OpenedDevice device = opened();
  EXPECT_EQ(device.device->describe().name, "Stand-in Touch (serial 0042)");
  make_other_current();
  ASSERT_TRUE(device.device->start(push));
  EXPECT_TRUE(comes_true([&] { return pushes({0, 0, 1}); }));
  EXPECT_EQ(device.device->status().state, DeviceState::running);
  stage->frozen = true;
  std::uint64_t ticks = 0;
  EXPECT_TRUE(comes_true([&] { return std::exchange(ticks, stage->ticks) == stage->ticks; }));
  make_other_current();
  device.device->stop();
  EXPECT_TRUE(pushes(Vec3(0)));
  EXPECT_FALSE(stage->output);
}

TEST_F(OpenHaptics, ErrorsOfOthersAreNotTakenForItsOwnAndItLeavesNone) {
  const auto other_error = [this] { function<void (*)(unsigned int)>("hdEnable")(1); };
  const auto error_left = [this] {
    return function<decltype(hd::Functions::get_error)>("hdGetError")().code;
  };
  FeltPlane plane;
  other_error();
  OpenedDevice device = opened();
  EXPECT_EQ(error_left(), 0U);
  other_error();
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(comes_true([&] { return plane.present > 3; }));
  device.device->stop();
  EXPECT_EQ(error_left(), 0U);
  other_error();
  device = {};
  EXPECT_EQ(error_left(), 0U);
}

}  // namespace
}  // namespace nazori::devices
