// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/openhaptics.h"

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <numbers>

#include "felt_plane.h"
#include "nazori/devices/device_catalogue.h"
#include "openhaptics_port.h"
#include "standins/hd_standin.h"
#include "test_paths.h"

namespace nazori::devices {
namespace {

using haptics::DeviceState;
using haptics::DeviceTrouble;
using test::comes_true;
using test::FeltPlane;
using test::Vec3;

const std::string kLibrary = std::string(test_paths::kStandins) + "/libHD.so";

class OpenHaptics : public testing::Test {
 protected:
  OpenHaptics() {
    void* library = dlopen(kLibrary.c_str(), RTLD_NOW | RTLD_GLOBAL);
    EXPECT_NE(library, nullptr) << dlerror();
    stage = reinterpret_cast<standin::HdStageFunction>(dlsym(library, "nazori_standin_hd"))();
    reinterpret_cast<void (*)()>(dlsym(library, "nazori_standin_hd_reset"))();
  }
  static OpenHapticsSettings settings() {
    OpenHapticsSettings s;
    s.library = kLibrary;
    s.device_folder = "/nowhere";
    return s;
  }
  OpenedDevice opened(const OpenRequest& request = {}) {
    auto device = back_end->open("openhaptics", request);
    EXPECT_TRUE(device) << base::to_line(device.error().error);
    return std::move(*device);
  }
  /// Holds the stylus there, in the tablet frame.
  void hold(const WorkspaceMapping& mapping, const Vec3& tablet_m) const {
    const Vec3 mm = mapping.to_device_m(tablet_m) * 1e3;
    stage->x_mm = mm.x;
    stage->y_mm = mm.y;
    stage->z_mm = mm.z;
  }
  [[nodiscard]] Vec3 force() const {
    return {stage->force_x_n.load(), stage->force_y_n.load(), stage->force_z_n.load()};
  }
  [[nodiscard]] bool pushes(const Vec3& expected) const { return glm::length(force() - expected) < 1e-6; }

  standin::HdStage* stage = nullptr;
  std::unique_ptr<BackEnd> back_end = openhaptics_back_end(settings());
};

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
    // 2 mm deep on the tablet, 200 N/m: 0.4 N, up from the table as far as the tablet lies flat.
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
    stage->buttons = 1;  // pressed before it was asked for: no answer
    FeltPlane plane;
    OpenedDevice device = opened();
    ASSERT_TRUE(device.device->start(plane));
    EXPECT_NE(test::comes_to(*device.device, DeviceState::paused, DeviceTrouble::wants_reset_position)
                  .message.find("press a button"),
              std::string::npos);
    const std::uint64_t from = stage->ticks;
    EXPECT_TRUE(comes_true([&] { return stage->ticks > from + 200; }));  // some looks at the calibration
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
    EXPECT_NE(paused.message.find("goes on by itself"), std::string::npos);
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
            "Stand-in Touch (serial 0042): the connection was lost (code 0x302) (check cable and power, then "
            "choose the device again)");
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

TEST_F(OpenHaptics, WhateverEndsItTheLastForceWrittenIsZeroAndForcesAreOff) {
  // The library takes no force away by itself: what was written last stays.
  for (const unsigned int code : {0x0104U, 0x0300U, 0x0302U, 0x0303U, 0x0304U}) {
    test::Push push({0, 0, 1});
    OpenedDevice device = opened();
    ASSERT_TRUE(device.device->start(push));
    EXPECT_TRUE(comes_true([&] { return pushes({0, 0, 1}); })) << code;
    EXPECT_TRUE(stage->output);
    stage->next_error = code;
    // At once, not only when somebody stops it.
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

TEST_F(OpenHaptics, TriesTheUsersNameThenTheFirstThenTheUsualNames) {
  for (const char* name : {"", "Default Device", "Default PHANToM"}) {
    stage->only_name = name;
    EXPECT_TRUE(back_end->open("openhaptics", {})) << name;
    stage->garbage_handle = true;  // some versions: no error, and a number that is no device
    EXPECT_TRUE(back_end->open("openhaptics", {}).has_value() || *name == '\0') << name;
    stage->garbage_handle = false;
  }
  stage->only_name = "Left";
  EXPECT_FALSE(back_end->open("openhaptics", {}));
  EXPECT_EQ(back_end->open("openhaptics:Left", {})->id, "openhaptics:Left");
  OpenHapticsSettings by_name = settings();
  by_name.device_name = "Left";
  EXPECT_TRUE(openhaptics_back_end(by_name)->open("openhaptics", {}));
}

TEST_F(OpenHaptics, ADeviceThatIsOpenIsListedAsInUse) {
  const OpenedDevice device = opened();
  const BackEndFindings found = back_end->find();
  EXPECT_EQ(found.devices.size(), 1U);
  EXPECT_EQ(found.problem->trouble, DeviceTrouble::in_use);
  EXPECT_EQ(back_end->open("openhaptics", {}).error().trouble, DeviceTrouble::in_use);
  // And by another part of the program, or another program, through the library's own word.
  EXPECT_EQ(openhaptics_back_end(settings())->open("openhaptics", {}).error().trouble, DeviceTrouble::in_use);
}

TEST_F(OpenHaptics, EveryFailureToOpenSaysInOneLineWhatToDo) {
  struct Case {
    unsigned int code;
    DeviceTrouble trouble;
    const char* words;
  };
  for (const Case& c : {Case{0x0304, DeviceTrouble::no_timer, "close other programs"},
                        Case{0x0302, DeviceTrouble::device_absent, "Touch_Setup"},
                        Case{0x0303, DeviceTrouble::device_absent, "'Default PHANToM'"},
                        Case{0x0200, DeviceTrouble::init_failed, "wait some minutes"},
                        Case{0x0600, DeviceTrouble::init_failed, "OH_SDK_LICENSE_PATH"},
                        Case{0x0102, DeviceTrouble::init_failed, "Touch_Diagnostic"}}) {
    stage->init_error = c.code;
    const BackEndFindings found = back_end->find();
    ASSERT_TRUE(found.problem);
    EXPECT_EQ(found.problem->trouble, c.trouble) << c.code;
    const std::string line = base::to_line(found.problem->error);
    EXPECT_NE(line.find(c.words), std::string::npos) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
    EXPECT_EQ(stage->disables, 0);
  }
}

TEST_F(OpenHaptics, TheSecondLookSaysWhatTheFirstSaidThoughTheLibraryDoesNot) {
  // It says 0x0302 to 0x0304 once for each cause.
  for (const auto& [code, words] :
       {std::pair{0x0302U, "0x0302"}, std::pair{0x0303U, "0x0303"}, std::pair{0x0304U, "0x0304"}}) {
    stage->init_error = code;
    const BackEndFindings first = back_end->find();
    const BackEndFindings second = back_end->find();
    ASSERT_TRUE(first.problem && second.problem);
    EXPECT_NE(base::to_line(first.problem->error).find(words), std::string::npos);
    EXPECT_EQ(base::to_line(second.problem->error), base::to_line(first.problem->error));
    EXPECT_EQ(second.problem->trouble, first.problem->trouble);
  }
}

TEST_F(OpenHaptics, ALibraryThatRefusesWithoutAReasonIsNotSentToTheWrongTool) {
  {
    // Whatever an earlier device came to is over once one has run.
    FeltPlane plane;
    OpenedDevice device = opened();
    stage->start_error = 0x0304;
    EXPECT_FALSE(device.device->start(plane));
    stage->start_error = 0;
    ASSERT_TRUE(device.device->start(plane));
  }
  stage->init_error = 0x0302;
  stage->silent = true;
  const BackEndFindings found = back_end->find();
  ASSERT_TRUE(found.problem);
  EXPECT_EQ(found.problem->trouble, DeviceTrouble::device_absent);
  EXPECT_NE(base::to_line(found.problem->error).find("does not say why (tried"), std::string::npos)
      << base::to_line(found.problem->error);
}

TEST_F(OpenHaptics, ASchedulerThatIsRefusedTwiceIsAnErrorTwice) {
  FeltPlane plane;
  OpenedDevice device = opened();
  stage->start_error = 0x0304;
  ASSERT_FALSE(device.device->start(plane));
  // The library says nothing this time, and no tick comes.
  const auto second = device.device->start(plane);
  ASSERT_FALSE(second);
  EXPECT_NE(base::to_line(second.error()).find("0x304"), std::string::npos) << base::to_line(second.error());
  EXPECT_EQ(device.device->status().state, DeviceState::stopped);
  stage->start_error = 0;
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(comes_true([&] { return plane.present > 3; }));
}

TEST_F(OpenHaptics, TheMakersBannerIsNotPrinted) {
  testing::internal::CaptureStderr();
  (void)back_end->find();
  std::fputs("ours\n", stderr);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "ours\n");
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

TEST_F(OpenHaptics, AnUnusableCalibrationIsRefusedAndTheDeviceClosed) {
  OpenRequest request;
  request.calibration.emplace();
  request.calibration->scale = 0;
  const auto refused = back_end->open("openhaptics", request);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().trouble, DeviceTrouble::bad_calibration);
  EXPECT_EQ(stage->disables, 1);
  EXPECT_TRUE(back_end->open("openhaptics", {}));
}

TEST_F(OpenHaptics, AMissingLibraryIsNamedWithAllTheNamesThatWereTried) {
  OpenHapticsSettings missing;
  missing.library = "/nowhere/libHD.so";
  const BackEndFindings found = openhaptics_back_end(missing)->find();
  ASSERT_TRUE(found.problem);
  EXPECT_EQ(found.problem->trouble, DeviceTrouble::library_missing);
  EXPECT_NE(base::to_line(found.problem->error).find("/nowhere/libHD.so"), std::string::npos);
}

TEST_F(OpenHaptics, OnlyNodesOfTheMakerCountAsDevicesThatMayNotBeOpened) {
  namespace fs = std::filesystem;
  const fs::path root = fs::path(testing::TempDir()) / "nazori-touch-nodes";
  fs::remove_all(root);
  const auto node = [&](const std::string& name, const std::string& group, const std::string& about) {
    fs::create_directories(root / "dev");
    fs::create_directories(root / "sys" / "class" / group / name / "device");
    std::ofstream(root / "dev" / name) << "";
    fs::permissions(root / "dev" / name, fs::perms::none);
    std::ofstream(root / "sys" / "class" / group / name / "device" / "uevent") << about;
  };
  // Root may open everything, so it asks as nobody.
  const auto line_as_nobody = [&]() -> std::string {
    int ends[2];
    EXPECT_EQ(pipe(ends), 0);
    const pid_t process = fork();
    if (process == 0) {
      if (geteuid() == 0 && setuid(65534) != 0) std::_Exit(1);
      OpenHapticsSettings s = settings();
      s.device_folder = root / "dev";
      s.system_folder = root / "sys";
      stage->init_error = 0x0303;
      const std::string line = base::to_line(openhaptics_back_end(s)->find().problem->error);
      (void)!write(ends[1], line.data(), line.size());
      std::_Exit(0);
    }
    close(ends[1]);
    std::string line(4096, '\0');
    line.resize(static_cast<std::size_t>(std::max<ssize_t>(0, read(ends[0], line.data(), line.size()))));
    close(ends[0]);
    waitpid(process, nullptr, 0);
    return line;
  };
  node("hidraw0", "hidraw", "DRIVER=hid-generic\nHID_ID=0003:0000046D:0000C31C\n");  // a keyboard
  node("ttyACM0", "tty", "DRIVER=cdc_acm\nPRODUCT=2341/43/1\n");
  EXPECT_NE(line_as_nobody().find("Touch_Setup"), std::string::npos) << line_as_nobody();
  node("hidraw1", "hidraw", "DRIVER=hid-generic\nHID_ID=0003:00002988:00000302\n");
  EXPECT_NE(line_as_nobody().find("/dev/hidraw1: set a udev rule"), std::string::npos) << line_as_nobody();
  fs::remove(root / "dev" / "hidraw1");
  node("ttyACM1", "tty", "DRIVER=cdc_acm\nPRODUCT=2988/302/100\n");
  EXPECT_NE(line_as_nobody().find("/dev/ttyACM1"), std::string::npos) << line_as_nobody();
  fs::remove_all(root);
}

TEST_F(OpenHaptics, ALibraryThatLacksAFunctionIsRefusedByTheNameOfTheFunction) {
  OpenHapticsSettings incomplete;
  incomplete.library = std::string(test_paths::kStandins) + "/incomplete/libHD.so";
  const auto refused = openhaptics_back_end(incomplete)->open("openhaptics", {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().trouble, DeviceTrouble::symbol_missing);
  EXPECT_NE(base::to_line(refused.error().error).find("hdUnschedule"), std::string::npos);
}

TEST_F(OpenHaptics, AFileThatIsNoLibraryIsSaidInTheLoadersWords) {
  OpenHapticsSettings text;
  text.library = std::string(test_paths::kStandins) + "/not-a-library.so";
  const auto refused = openhaptics_back_end(text)->open("openhaptics", {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().trouble, DeviceTrouble::library_missing);
  EXPECT_NE(base::to_line(refused.error().error).find("does not load"), std::string::npos);
}

TEST_F(OpenHaptics, ALibraryThatLacksAnotherNamesWhatBringsIt) {
  // The loader's words, as Debian 12 says them.
  const auto words = [](const std::string& library) {
    return "the library is there but does not load: " + library +
           ": cannot open shared object file: No such file or directory";
  };
  EXPECT_NE(hd::remedy_for_missing(words("libncurses.so.5"), "x").find("libncurses5"), std::string::npos);
  EXPECT_NE(hd::remedy_for_missing(words("libPhantomManagerLite.so"), "x").find("HID driver"),
            std::string::npos);
  for (const char* driver : {"libPHANToMIO.so.4", "libPhantomIOLib42.so"})
    EXPECT_NE(hd::remedy_for_missing(words(driver), "x").find("Touch driver"), std::string::npos);
  EXPECT_EQ(hd::remedy_for_missing(words("libm.so.6"), "x"), "x");
}

TEST_F(OpenHaptics, WithoutItTheProgramGoesOnWithTheNextBest) {
  std::vector<std::unique_ptr<BackEnd>> all;
  all.push_back(openhaptics_back_end(settings()));
  all.push_back(pointer_back_end());
  DeviceCatalogue catalogue(std::move(all));
  EXPECT_EQ(catalogue.open_best("", {}).opened->id, "openhaptics");
  stage->plugged = false;
  const BestDevice best = catalogue.open_best("openhaptics", {});
  EXPECT_EQ(best.opened->id, "pointer");
  ASSERT_FALSE(best.passed_over.empty());
  EXPECT_EQ(best.passed_over.front().trouble, DeviceTrouble::device_absent);
}

}  // namespace
}  // namespace nazori::devices
