// SPDX-License-Identifier: Apache-2.0
// What is found, felt and reported through the library of Force Dimension.
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>

#include "force_dimension_fixture.h"

namespace nazori::devices {
namespace {

using haptics::DeviceState;
using haptics::DeviceTrouble;
using test::comes_true;
using test::FeltPlane;
using test::ForceDimension;
using test::Vec3;

TEST_F(ForceDimension, EveryDeviceIsListedAndClosedAgain) {
  stage->devices = 2;
  const BackEndFindings found = back_end->find();
  ASSERT_EQ(found.devices.size(), 2U);
  EXPECT_EQ(found.devices[1].id, "forcedimension:1");
  EXPECT_EQ(found.devices[1].name, "omega.3");
  EXPECT_FALSE(found.problem);
  EXPECT_EQ(stage->opens, 2);
  EXPECT_EQ(stage->closes, 2);
  EXPECT_EQ(back_end->open("forcedimension:1", {})->id, "forcedimension:1");
  for (const char* wrong : {"forcedimension:2", "forcedimension:x", "forcedimension:", "forcedimension:-1"})
    EXPECT_FALSE(back_end->open(wrong, {})) << wrong;
}

TEST_F(ForceDimension, AKnownPlaneIsFeltInTheMakersFrame) {
  FeltPlane plane;
  OpenedDevice device = opened();
  // 10 mm right, 20 mm up and, with the tablet upright, 3 mm into it.
  stage->x_m = -0.003;
  stage->y_m = 0.010;
  stage->z_m = 0.020;
  stage->buttons = 5;
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(stage->gravity_on);
  // 3 mm at 200 N/m, out of the tablet: towards the operator.
  EXPECT_TRUE(comes_true([&] { return std::abs(stage->force_x_n - 0.6) < 1e-9; }));
  EXPECT_EQ(stage->force_y_n, 0);
  EXPECT_EQ(stage->force_z_n, 0);
  EXPECT_NEAR(plane.x_m, 0.010, 1e-12);
  EXPECT_NEAR(plane.y_m, 0.020, 1e-12);
  EXPECT_TRUE(comes_true([&] { return device.device->status().buttons == 5U; }));
  EXPECT_TRUE(comes_true([&] { return device.device->status().delay_s > 0; }));
  device.device->stop();
  EXPECT_EQ(force(), 0);
  EXPECT_FALSE(stage->force_on);
}

TEST_F(ForceDimension, EachAxisOfForceGoesTheWayOfItsAxisOfMotion) {
  test::Push push({1, 2, 3});  // right, up, towards the operator
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(push));
  EXPECT_TRUE(
      comes_true([&] { return stage->force_x_n == 3 && stage->force_y_n == 1 && stage->force_z_n == 2; }));
}

TEST_F(ForceDimension, ATabletThatLiesFlatPushesUp) {
  OpenRequest request;
  request.posture.tilt_rad = 0;
  test::Push push({0, 0, 1.5});
  auto device = back_end->open("forcedimension", request);
  ASSERT_TRUE(device);
  ASSERT_TRUE(device->device->start(push));
  EXPECT_TRUE(comes_true([&] { return std::abs(stage->force_z_n - 1.5) < 1e-12; }));
  EXPECT_NEAR(stage->force_x_n, 0, 1e-12);
}

TEST_F(ForceDimension, LimitsAreThoseOfTheKindAndNeverAboveTheDevicesOwn) {
  EXPECT_EQ(opened().device->describe().limits.max_force_n, 12);
  stage->max_force_n = 7;
  EXPECT_EQ(opened().device->describe().limits.max_force_n, 7);
  stage->max_force_n = 100;
  stage->name = "sigma.7";
  OpenRequest as_it_is;
  as_it_is.calibration.emplace();
  EXPECT_EQ(back_end->open("forcedimension", as_it_is)->device->describe().limits.max_stiffness_n_m, 4000);
  stage->name = "Novint Falcon";
  EXPECT_EQ(opened().device->describe().limits.max_force_n, 8);
  stage->name = "";
  stage->type = 60;
  test::Push strong({0, 0, 1000});
  OpenedDevice device = opened();
  EXPECT_EQ(device.device->describe().limits.max_force_n, 8);
  ASSERT_TRUE(device.device->start(strong));
  EXPECT_TRUE(comes_true([&] { return std::abs(stage->force_x_n - 8) < 1e-9; }));
  EXPECT_EQ(stage->guard_n, 8);
}

TEST_F(ForceDimension, ReachAndLimitsAreThoseOfTheKind) {
  struct Kind {
    const char* name;
    double radius_m, force_n, continuous_n, stiffness_n_m;
  };
  stage->max_force_n = 100;
  OpenRequest as_it_is;
  as_it_is.calibration.emplace();
  for (const Kind& kind : {Kind{"omega.7", 0.075, 12, 12, 5000}, Kind{"DELTA.6", 0.15, 20, 20, 5000},
                           Kind{"Falcon", 0.04, 8, 4, 3000}, Kind{"sigma.7", 0.06, 12, 12, 4000},
                           Kind{"lambda.7", 0.06, 12, 12, 5000}}) {
    stage->name = kind.name;
    const auto device = back_end->open("forcedimension", as_it_is);
    ASSERT_TRUE(device);
    // The cube within the ball.
    EXPECT_NEAR(glm::length(device->workspace.high_m), kind.radius_m, 1e-12) << kind.name;
    EXPECT_EQ(device->workspace.low_m, -device->workspace.high_m);
    EXPECT_EQ(device->workspace.high_m.x, device->workspace.high_m.z);
    const haptics::DeviceLimits limits = device->device->describe().limits;
    EXPECT_EQ(limits.max_force_n, kind.force_n) << kind.name;
    EXPECT_EQ(limits.continuous_force_n, kind.continuous_n) << kind.name;
    EXPECT_EQ(limits.max_stiffness_n_m, kind.stiffness_n_m) << kind.name;
  }
  stage->max_force_n = 3;
  EXPECT_EQ(back_end->open("forcedimension", as_it_is)->device->describe().limits.continuous_force_n, 3);
}

TEST_F(ForceDimension, SaturatedMotorsAreNoError) {
  stage->saturated = true;
  FeltPlane plane;
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(comes_true([&] { return plane.present > 50; }));
  EXPECT_EQ(plane.absent, 0);
}

TEST_F(ForceDimension, AReadingThatFailsTakesTheForceAwayUntilTheNextGoodOne) {
  FeltPlane plane;
  OpenedDevice device = opened();
  stage->x_m = -0.003;
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(comes_true([&] { return force() > 0.5; }));
  // Twenty in a row would be the end. Each good one resets the count.
  for (const int absent : {19, 38}) {
    stage->bad_reads = 19;
    EXPECT_TRUE(comes_true([&] { return plane.absent == absent; }));
    EXPECT_TRUE(comes_true([&] { return force() > 0.5; }));
  }
  EXPECT_TRUE(comes_true([&] { return device.device->status().state == DeviceState::running; }));
}

TEST_F(ForceDimension, UnpluggedItIsLostAndPluggedInItOpensAgain) {
  FeltPlane plane;
  OpenedDevice device = opened();
  stage->x_m = -0.003;
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(comes_true([&] { return force() > 0.5; }));
  stage->devices = 0;
  EXPECT_EQ(test::comes_to(*device.device, DeviceState::lost, DeviceTrouble::communication_lost).message,
            "omega.3: the connection was lost (check the cable and the power, then select the device again)");
  EXPECT_EQ(force(), 0);
  const std::uint64_t reads = stage->reads;
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(stage->reads, reads);  // the library is not called
  device.device->stop();
  device = {};
  EXPECT_EQ(back_end->find().problem->trouble, DeviceTrouble::device_absent);
  stage->devices = 1;
  device = opened();
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(comes_true([&] { return force() > 0.5; }));
}

TEST_F(ForceDimension, PositionsThatAreNotNumbersGiveNoForce) {
  test::Push push({0, 0, 1});
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(push));
  EXPECT_TRUE(comes_true([&] { return force() > 0.5; }));
  stage->z_m = std::nan("");
  EXPECT_TRUE(comes_true([&] { return device.device->status().trouble == DeviceTrouble::bad_message; }));
  EXPECT_TRUE(comes_true([&] { return force() == 0; }));
}

TEST_F(ForceDimension, ADeviceThatIsNotHomedPausesSaysHowToHomeItAndGoesOnByItself) {
  stage->not_homed = true;
  FeltPlane plane;
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(plane));  // the library reports success
  EXPECT_EQ(test::comes_to(*device.device, DeviceState::paused, DeviceTrouble::not_homed).message,
            "omega.3: it is not homed, so it brakes and tells no position (home it: press the button of an "
            "omega or delta, pull all arms of a Falcon out and push them in)");
  EXPECT_EQ(plane.present, 0);  // the reported position is not valid
  EXPECT_EQ(force(), 0);
  stage->not_homed = false;
  stage->force_on = false;  // until they are switched on again
  stage->x_m = -0.003;
  EXPECT_TRUE(comes_true([&] { return stage->force_on && force() > 0.5; }));
  EXPECT_TRUE(comes_true([&] { return device.device->status().state == DeviceState::running; }));
  EXPECT_FALSE(device.device->start(plane));
}

TEST_F(ForceDimension, ForcesThatGoOffInMidRunPauseItWithTheCause) {
  struct Case {
    int cause;
    const char* words;
    bool comes_back;  // automatically, because Nazori switches them on again
  };
  for (const Case& c : {Case{1, "press that button again", false}, Case{2, "move more slowly", true},
                        Case{3, "program was late", true}, Case{4, "a program switched", true},
                        Case{5, "USB connection", false}, Case{6, "nobody holds it", false},
                        Case{0, "forces are off", true}, Case{99, "forces are off", true}}) {
    stage->force_on = false;
    stage->force_off_cause = 0;
    stage->x_m = -0.003;
    FeltPlane plane;
    OpenedDevice device = opened();
    ASSERT_TRUE(device.device->start(plane));
    EXPECT_TRUE(comes_true([&] { return force() > 0.5; })) << c.cause;
    stage->force_off_cause = c.cause;
    stage->force_on = false;
    const int enables = stage->enables;
    const auto paused = test::comes_to(*device.device, DeviceState::paused, DeviceTrouble::forces_off);
    EXPECT_NE(paused.message.find(c.words), std::string::npos) << c.cause << ": " << paused.message;
    EXPECT_EQ(paused.message.find("0x"), std::string::npos);
    EXPECT_TRUE(comes_true([&] { return force() == 0; }));
    if (c.comes_back) {
      EXPECT_TRUE(comes_true([&] { return stage->enables > enables; })) << c.cause;
      stage->force_off_cause = 0;
    } else {
      const std::uint64_t from = stage->reads;
      EXPECT_TRUE(comes_true([&] { return stage->reads > from + 800; }));  // longer than the rest
      EXPECT_EQ(stage->enables, enables) << c.cause;
      stage->force_off_cause = 0;
      stage->force_on = true;  // the learner did
    }
    EXPECT_TRUE(comes_true([&] { return force() > 0.5; })) << c.cause;
    EXPECT_TRUE(comes_true([&] { return device.device->status().message.empty(); }));
  }
}

TEST_F(ForceDimension, ForcesThatGoOffAreNotSwitchedOnAgainBeforeARest) {
  FeltPlane plane;
  OpenedDevice device = opened();
  stage->x_m = -0.003;
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(comes_true([&] { return force() > 0.5; }));
  const int enables = stage->enables;
  const auto off = std::chrono::steady_clock::now();
  stage->force_off_cause = 2;  // and they stay off
  stage->force_on = false;
  EXPECT_TRUE(comes_true([&] { return stage->enables >= enables + 2; }));
  const int again = stage->enables - enables;
  const double elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - off).count();
  EXPECT_LE(again, elapsed_s / 0.5);
}

TEST_F(ForceDimension, ARateThatNoClockKeepsLeavesNoForceOn) {
  ForceDimensionSettings too_fast = settings();
  too_fast.rate_hz = 1e6;
  auto device = force_dimension_back_end(too_fast)->open("forcedimension", {});
  ASSERT_TRUE(device);
  FeltPlane plane;
  EXPECT_FALSE(device->device->start(plane));
  EXPECT_FALSE(stage->force_on);
  EXPECT_EQ(device->device->status().state, DeviceState::stopped);
}

TEST_F(ForceDimension, ALostDeviceAndAStoppedOneHaveForcesOff) {
  FeltPlane plane;
  OpenedDevice device = opened();
  stage->x_m = -0.003;
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(comes_true([&] { return force() > 0.5; }));
  stage->bad_reads = 1'000'000;
  (void)test::comes_to(*device.device, DeviceState::lost, DeviceTrouble::communication_lost);
  EXPECT_EQ(force(), 0);
  EXPECT_FALSE(stage->force_on);
  device.device->stop();
  EXPECT_EQ(force(), 0);
  EXPECT_FALSE(stage->force_on);
}

TEST_F(ForceDimension, AGripperIsAButton) {
  stage->name = "omega.7";
  FeltPlane plane;
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(stage->button_emulated);
}

TEST_F(ForceDimension, OnlyADeviceOfTheMakerCountsAsOneThatMayNotBeOpened) {
  namespace fs = std::filesystem;
  const fs::path root = fs::path(testing::TempDir()) / "nazori-usb-nodes";
  fs::remove_all(root);
  const auto plug_in = [&](const std::string& port, const char* vendor, const char* product,
                           const std::string& number) {
    const fs::path about = root / "sys" / "bus" / "usb" / "devices" / port;
    fs::create_directories(about);
    std::ofstream(about / "idVendor") << vendor << "\n";
    std::ofstream(about / "idProduct") << product << "\n";
    std::ofstream(about / "busnum") << "3\n";
    std::ofstream(about / "devnum") << number << "\n";
    fs::create_directories(root / "dev" / "bus" / "usb" / "003");
    const fs::path node =
        root / "dev" / "bus" / "usb" / "003" / std::string(3 - number.size(), '0').append(number);
    std::ofstream(node) << "";
    fs::permissions(node, fs::perms::none);
  };
  // Root may open everything, so the check runs as the user nobody.
  const auto ask_as_nobody = [&](const std::string& part) {
    if (geteuid() == 0 && setuid(65534) != 0) std::_Exit(99);
    stage->devices = 0;
    ForceDimensionSettings s;
    s.library = kLibrary;
    s.device_folder = root / "dev";
    s.system_folder = root / "sys";
    const std::string line = base::to_line(force_dimension_back_end(s)->find().problem->error);
    std::fputs(line.c_str(), stderr);
    std::_Exit(line.find(part) != std::string::npos ? 0 : 1);
  };
  const auto trouble_as_nobody = [&](const char* part) {
    EXPECT_EXIT(ask_as_nobody(part), testing::ExitedWithCode(0), part);
  };
  plug_in("3-1", "046d", "c31c", "2");  // a keyboard
  plug_in("3-2", "0403", "6001", "5");  // a serial adapter of the Falcon's chip
  fs::create_directories(root / "dev");
  std::ofstream(root / "dev" / "hidraw0") << "";
  fs::permissions(root / "dev" / "hidraw0", fs::perms::none);
  trouble_as_nobody("plug it in");
  plug_in("3-3", "1451", "0402", "17");
  trouble_as_nobody("bus/usb/003/017: install a udev rule");
  fs::remove_all(root / "sys" / "bus" / "usb" / "devices" / "3-3");
  plug_in("3-4", "0403", "cb48", "104");
  trouble_as_nobody("bus/usb/003/104: install a udev rule");
  fs::remove_all(root);
}

TEST_F(ForceDimension, EveryFailureToOpenSaysInOneLineWhatToDo) {
  stage->devices = 0;
  EXPECT_EQ(back_end->find().problem->trouble, DeviceTrouble::device_absent);
  EXPECT_NE(base::to_line(back_end->find().problem->error).find("plug it in"), std::string::npos);
  stage->devices = 1;
  stage->open_error = 3;
  EXPECT_EQ(back_end->find().problem->trouble, DeviceTrouble::in_use);
  stage->open_error = 20;
  EXPECT_EQ(back_end->find().problem->trouble, DeviceTrouble::in_use);
  EXPECT_NE(base::to_line(back_end->find().problem->error).find("close the program that uses it"),
            std::string::npos);
  stage->open_error = 2;
  EXPECT_NE(base::to_line(back_end->find().problem->error).find("communication error"), std::string::npos);
  ForceDimensionSettings missing;
  missing.library = "/nowhere/libdhd.so";
  EXPECT_EQ(force_dimension_back_end(missing)->find().problem->trouble, DeviceTrouble::library_missing);
  // A different library with that name.
  ForceDimensionSettings another;
  another.library = std::string(test_paths::kStandins) + "/libHD.so";
  const auto other = force_dimension_back_end(another)->find();
  EXPECT_EQ(other.problem->trouble, DeviceTrouble::symbol_missing);
  EXPECT_NE(base::to_line(other.problem->error).find("dhdGetDeviceCount"), std::string::npos);
}

TEST_F(ForceDimension, ADeviceThatIsOpenIsListedAsInUse) {
  const OpenedDevice device = opened();
  EXPECT_EQ(back_end->find().problem->trouble, DeviceTrouble::in_use);
  EXPECT_EQ(back_end->open("forcedimension", {}).error().trouble, DeviceTrouble::in_use);
}

}  // namespace
}  // namespace nazori::devices
