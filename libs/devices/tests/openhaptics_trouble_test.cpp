// SPDX-License-Identifier: Apache-2.0
// Docking, calibration, errors and ends: when OpenHaptics gives force and when it must not.
#include <array>
#include <string>
#include <utility>

#include "openhaptics_fixture.h"

namespace nazori::devices {
namespace {

using haptics::DeviceState;
using haptics::DeviceTrouble;
using test::comes_true;
using test::FeltPlane;
using test::OpenHaptics;
using test::Vec3;

TEST_F(OpenHaptics, DockedItPausesAndOutAgainItGoesOn) {
  FeltPlane plane;
  OpenedDevice device = opened();
  const WorkspaceMapping mapping = *WorkspaceMapping::create(device.calibration);
  hold(mapping, {0, 0, -0.002});
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(comes_true([&] { return glm::length(force()) > 0.3; }));
  stage->out_of_inkwell = false;
  const haptics::DeviceStatus docked =
      test::comes_to(*device.device, DeviceState::paused, DeviceTrouble::docked);
  EXPECT_EQ(docked.trouble, DeviceTrouble::docked);
  EXPECT_NE(docked.message.find("take it out"), std::string::npos);
  EXPECT_TRUE(comes_true([&] { return pushes(Vec3(0)); }));
  stage->out_of_inkwell = true;
  EXPECT_TRUE(comes_true([&] { return glm::length(force()) > 0.3; }));
}

TEST_F(OpenHaptics, ADeviceWithoutAnInkwellIsNotTakenForDocked) {
  stage->calibration_style = 2;
  stage->out_of_inkwell = false;  // reads 0 for ever
  FeltPlane plane;
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(comes_true([&] { return plane.present > 3; }));
}

TEST_F(OpenHaptics, ASafetySwitchThatWasHeldAndIsLetGoPauses) {
  FeltPlane plane;
  OpenedDevice device = opened();
  stage->safety_held = true;
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(comes_true([&] { return plane.present > 3; }));
  stage->safety_held = false;
  EXPECT_TRUE(comes_true([&] { return device.device->status().trouble == DeviceTrouble::safety_switch; }));
  EXPECT_TRUE(comes_true([&] { return stage->zero_ticks > 2; }));
}

TEST_F(OpenHaptics, AsksForTheInkwellAndCalibratesThere) {
  stage->calibration = 0x5001;
  FeltPlane plane;
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_NE(test::comes_to(*device.device, DeviceState::paused, DeviceTrouble::wants_inkwell)
                .message.find("into its inkwell"),
            std::string::npos);
  EXPECT_EQ(stage->calibrations, 0);
  stage->out_of_inkwell = false;
  EXPECT_TRUE(comes_true([&] { return stage->calibrations == 1; }));
  stage->out_of_inkwell = true;
  EXPECT_TRUE(comes_true([&] { return device.device->status().state == DeviceState::running; }));
}

TEST_F(OpenHaptics, CalibratesByOneStyleOfSeveralAutomaticFirst) {
  // The maker's example: automatic before inkwell before reset. The library takes no mask.
  for (const auto& [styles, style] :
       {std::pair{2, 2U}, std::pair{3, 2U}, std::pair{6, 2U}, std::pair{7, 2U}}) {
    stage->calibration_style = styles;
    stage->calibration = 0x5001;
    FeltPlane plane;
    OpenedDevice device = opened();
    ASSERT_TRUE(device.device->start(plane));
    EXPECT_TRUE(comes_true([&] { return stage->calibration == 0x5000U; })) << styles;
    EXPECT_EQ(stage->calibrated_by, style) << styles;
    EXPECT_TRUE(comes_true([&] { return plane.present > 3; })) << styles;
  }
  for (const int styles : {4, 5}) {
    stage->calibration_style = styles;
    stage->calibration = 0x5001;
    stage->out_of_inkwell = false;
    FeltPlane plane;
    OpenedDevice device = opened();
    ASSERT_TRUE(device.device->start(plane));
    EXPECT_TRUE(comes_true([&] { return stage->calibration == 0x5000U; })) << styles;
    EXPECT_EQ(stage->calibrated_by, 4U) << styles;
    stage->out_of_inkwell = true;
  }
}

TEST_F(OpenHaptics, AnArmWithoutInkwellIsCalibratedWhereTheLearnerSaysThatItIsAtItsResetPosition) {
  for (const unsigned int need : {0x5001U, 0x5002U}) {
    stage->calibration_style = 1;
    stage->calibration = need;
    stage->calibrations = 0;
    stage->buttons = 1;  // pressed before the request: not an answer
    FeltPlane plane;
    OpenedDevice device = opened();
    ASSERT_TRUE(device.device->start(plane));
    EXPECT_NE(test::comes_to(*device.device, DeviceState::paused, DeviceTrouble::wants_reset_position)
                  .message.find("press a button"),
              std::string::npos);
    const std::uint64_t from = stage->ticks;
    EXPECT_TRUE(comes_true([&] { return stage->ticks > from + 200; }));  // some checks of the calibration
    EXPECT_EQ(stage->calibrations, 0);
    stage->buttons = 0;
    EXPECT_TRUE(comes_true([&] { return device.device->status().buttons == 0; }));
    stage->buttons = 2;
    EXPECT_TRUE(comes_true([&] { return device.device->status().state == DeviceState::running; }));
    EXPECT_EQ(stage->calibrated_by, 1U);
    EXPECT_EQ(stage->calibrations, 1);
  }
}

TEST_F(OpenHaptics, ForceErrorsTakeTheForceAwayAtOnceAndItComesBackByItself) {
  const std::array<std::pair<unsigned int, DeviceTrouble>, 4> cases{{{0x0200, DeviceTrouble::warm_motors},
                                                                     {0x0201, DeviceTrouble::over_force},
                                                                     {0x0202, DeviceTrouble::over_force},
                                                                     {0x0203, DeviceTrouble::over_speed}}};
  for (const auto& [code, trouble] : cases) {
    FeltPlane plane;
    OpenedDevice device = opened();
    const WorkspaceMapping mapping = *WorkspaceMapping::create(device.calibration);
    hold(mapping, {0, 0, -0.002});
    ASSERT_TRUE(device.device->start(plane));
    EXPECT_TRUE(comes_true([&] { return glm::length(force()) > 0.3; }));
    stage->every_error = code;
    stage->output = false;  // as the library does on hard errors
    const haptics::DeviceStatus paused = test::comes_to(*device.device, DeviceState::paused, trouble);
    EXPECT_EQ(paused.trouble, trouble);
    EXPECT_NE(paused.message.find("resumes by itself"), std::string::npos);
    EXPECT_TRUE(comes_true([&] { return pushes(Vec3(0)); }));
    EXPECT_EQ(stage->force_despite_error_n, 0);  // not even in the tick of the error
    stage->every_error = 0;
    EXPECT_TRUE(comes_true([&] { return glm::length(force()) > 0.3; })) << code;
    EXPECT_TRUE(comes_true([&] { return device.device->status().message.empty(); }));
  }
}

TEST_F(OpenHaptics, AForceErrorIsSeenEvenWhereItLastsOneTick) {
  FeltPlane plane;
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(comes_true([&] { return plane.present > 3; }));
  stage->next_error = 0x0201;
  EXPECT_TRUE(comes_true([&] { return plane.absent > 3; }));
  EXPECT_TRUE(comes_true([&] { return device.device->status().state == DeviceState::running; }));
}

TEST_F(OpenHaptics, UnpluggedItIsLostWithASentenceAndPluggedInItOpensAgain) {
  FeltPlane plane;
  FeltPlane again;
  OpenedDevice device = opened();
  const WorkspaceMapping mapping = *WorkspaceMapping::create(device.calibration);
  hold(mapping, {0, 0, -0.002});
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(comes_true([&] { return glm::length(force()) > 0.3; }));
  stage->plugged = false;
  const haptics::DeviceStatus lost =
      test::comes_to(*device.device, DeviceState::lost, DeviceTrouble::communication_lost);
  EXPECT_TRUE(comes_true([&] { return pushes(Vec3(0)); }));
  EXPECT_EQ(stage->force_despite_error_n, 0);
  EXPECT_EQ(lost.message,
            "Stand-in Touch (serial 0042): the connection was lost (code 0x302) (check the cable and the "
            "power, then select the device again)");
  const int ticks = plane.ticks;
  const std::uint64_t from = stage->ticks;
  EXPECT_TRUE(comes_true([&] { return stage->ticks > from + 5; }));
  EXPECT_EQ(plane.ticks, ticks);  // the callback has ended
  device.device->stop();
  EXPECT_EQ(device.device->status().state, DeviceState::lost);
  device = {};
  EXPECT_EQ(back_end->find().problem->trouble, DeviceTrouble::device_absent);
  stage->plugged = true;
  device = opened();
  ASSERT_TRUE(device.device->start(again));
  EXPECT_TRUE(comes_true([&] { return glm::length(force()) > 0.3; }));
}

TEST_F(OpenHaptics, EverySchedulerErrorEndsIt) {
  for (const unsigned int code : {0x0104U, 0x0300U, 0x0303U, 0x0304U, 0x0500U, 0x0501U}) {
    FeltPlane plane;
    OpenedDevice device = opened();
    ASSERT_TRUE(device.device->start(plane));
    stage->next_error = code;
    EXPECT_TRUE(comes_true([&] { return device.device->status().state == DeviceState::lost; })) << code;
    EXPECT_EQ(device.device->status().trouble,
              code == 0x0304 ? DeviceTrouble::no_timer : DeviceTrouble::device_fault);
    EXPECT_TRUE(comes_true([&] { return pushes(Vec3(0)); }));
  }
}

TEST_F(OpenHaptics, FiftyTicksInARowWithAnErrorOfAnUnknownKindAreTheEnd) {
  FeltPlane plane;
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(plane));
  for (const int bad : {49, 49, 50}) {
    const int before = plane.present;
    stage->bad_ticks = bad;
    EXPECT_TRUE(comes_true([&] { return stage->bad_ticks == 0; }));
    const std::uint64_t from = stage->ticks;
    EXPECT_TRUE(comes_true([&] { return stage->ticks > from + 3; }));
    EXPECT_EQ(device.device->status().state == DeviceState::lost, bad == 50);
    EXPECT_GT(plane.present, before + 40) << "until then they change nothing";
  }
  EXPECT_EQ(device.device->status().trouble, DeviceTrouble::device_fault);
  EXPECT_NE(device.device->status().message.find("0x101"), std::string::npos)
      << device.device->status().message;
}

TEST_F(OpenHaptics, WhateverEndsItTheLastForceWrittenIsZeroAndForcesAreOff) {
  // The library does not remove a force by itself: the last written force stays.
  for (const unsigned int code : {0x0104U, 0x0300U, 0x0302U, 0x0303U, 0x0304U}) {
    test::Push push({0, 0, 1});
    OpenedDevice device = opened();
    ASSERT_TRUE(device.device->start(push));
    EXPECT_TRUE(comes_true([&] { return pushes({0, 0, 1}); })) << code;
    EXPECT_TRUE(stage->output);
    stage->next_error = code;
    // At once, not only when it is stopped.
    EXPECT_TRUE(comes_true([&] { return pushes(Vec3(0)) && !stage->output; })) << code;
    EXPECT_EQ(stage->force_despite_error_n, 0) << code;
    device.device->stop();
    EXPECT_TRUE(pushes(Vec3(0))) << code;
    EXPECT_FALSE(stage->output) << code;
  }
}

TEST_F(OpenHaptics, AStopLeavesNoForceEvenWhereNoTickComesAnyMore) {
  for (const bool frozen : {false, true}) {
    test::Push push({0, 0, 1});
    OpenedDevice device = opened();
    ASSERT_TRUE(device.device->start(push));
    EXPECT_TRUE(comes_true([&] { return pushes({0, 0, 1}); }));
    stage->frozen = frozen;
    device.device->stop();
    EXPECT_TRUE(pushes(Vec3(0))) << frozen;
    EXPECT_FALSE(stage->output) << frozen;
    stage->frozen = false;
  }
}

TEST_F(OpenHaptics, AStartThatIsRefusedLeavesForcesOff) {
  test::Push push({0, 0, 1});
  OpenedDevice device = opened();
  stage->start_error = 0x0304;
  ASSERT_FALSE(device.device->start(push));
  EXPECT_FALSE(stage->output);
  EXPECT_TRUE(pushes(Vec3(0)));
}

TEST_F(OpenHaptics, AServoThatStandsStillIsSaidAndDoesNotHoldUpTheStop) {
  FeltPlane plane;
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(comes_true([&] { return plane.present > 3; }));
  stage->frozen = true;
  EXPECT_TRUE(comes_true([&] { return device.device->status().trouble == DeviceTrouble::stalled; }));
  EXPECT_EQ(device.device->status().state, DeviceState::lost);
  device.device->stop();
  EXPECT_TRUE(comes_true([&] { return pushes(Vec3(0)); }));
}

TEST_F(OpenHaptics, ASchedulerThatIsRefusedTwiceIsAnErrorTwice) {
  FeltPlane plane;
  OpenedDevice device = opened();
  stage->start_error = 0x0304;
  ASSERT_FALSE(device.device->start(plane));
  // The library reports no error this time, and no tick comes.
  const auto second = device.device->start(plane);
  ASSERT_FALSE(second);
  EXPECT_NE(base::to_line(second.error()).find("0x304"), std::string::npos) << base::to_line(second.error());
  EXPECT_EQ(device.device->status().state, DeviceState::stopped);
  stage->start_error = 0;
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(comes_true([&] { return plane.present > 3; }));
}

TEST_F(OpenHaptics, ASchedulerThatDoesNotStartIsAnErrorOfStart) {
  FeltPlane plane;
  OpenedDevice device = opened();
  stage->start_error = 0x0304;
  const auto started = device.device->start(plane);
  ASSERT_FALSE(started);
  EXPECT_NE(base::to_line(started.error()).find("Stand-in Touch"), std::string::npos);
  stage->start_error = 0;
  EXPECT_TRUE(device.device->start(plane));
  EXPECT_FALSE(device.device->start(plane));  // twice
}

}  // namespace
}  // namespace nazori::devices
