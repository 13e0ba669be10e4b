// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/force_dimension.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "felt_plane.h"
#include "standins/dhd_standin.h"
#include "test_paths.h"

namespace nazori::devices {
namespace {

using haptics::DeviceState;
using haptics::DeviceTrouble;
using test::comes_true;
using test::FeltPlane;
using test::Vec3;

const std::string kLibrary = std::string(test_paths::kStandins) + "/libdhd.so";

class ForceDimension : public testing::Test {
 protected:
  ForceDimension() : stage(stage_of(kLibrary)) {}
  static standin::DhdStage* stage_of(const std::string& path) {
    void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL);
    EXPECT_NE(library, nullptr) << dlerror();
    reinterpret_cast<void (*)()>(dlsym(library, "nazori_standin_dhd_reset"))();
    return reinterpret_cast<standin::DhdStageFunction>(dlsym(library, "nazori_standin_dhd"))();
  }
  OpenedDevice opened() {
    OpenRequest request;
    request.calibration.emplace();
    auto device = back_end->open("forcedimension", request);
    EXPECT_TRUE(device) << base::to_line(device.error().error);
    return std::move(*device);
  }
  [[nodiscard]] double force() const {
    return std::hypot(stage->force_x_n, stage->force_y_n, stage->force_z_n);
  }

  standin::DhdStage* stage;
  std::unique_ptr<BackEnd> back_end = force_dimension_back_end({kLibrary, 1000});
};

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
  stage->bad_reads = 5;
  EXPECT_TRUE(comes_true([&] { return plane.absent == 5; }));
  EXPECT_TRUE(comes_true([&] { return force() > 0.5; }));
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
            "omega.3: the connection was lost (check cable and power, then choose the device again)");
  EXPECT_EQ(force(), 0);
  const std::uint64_t reads = stage->reads;
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(stage->reads, reads);  // the library is left alone
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

TEST_F(ForceDimension, ADeviceThatIsNotHomedRefusesToStartAndSaysHow) {
  FeltPlane plane;
  OpenedDevice device = opened();
  stage->not_homed = true;
  const auto refused = device.device->start(plane);
  ASSERT_FALSE(refused);
  EXPECT_NE(base::to_line(refused.error()).find("pull all arms"), std::string::npos);
  stage->not_homed = false;
  EXPECT_TRUE(device.device->start(plane));
  EXPECT_FALSE(device.device->start(plane));
}

TEST_F(ForceDimension, EveryFailureToOpenSaysInOneLineWhatToDo) {
  stage->devices = 0;
  EXPECT_EQ(back_end->find().problem->trouble, DeviceTrouble::device_absent);
  EXPECT_NE(base::to_line(back_end->find().problem->error).find("plug it in"), std::string::npos);
  stage->devices = 1;
  stage->open_error = 3;
  EXPECT_EQ(back_end->find().problem->trouble, DeviceTrouble::in_use);
  stage->open_error = 2;
  EXPECT_NE(base::to_line(back_end->find().problem->error).find("communication error"), std::string::npos);
  EXPECT_EQ(force_dimension_back_end({"/nowhere/libdhd.so", 1000})->find().problem->trouble,
            DeviceTrouble::library_missing);
  // Another library under that name.
  const auto other =
      force_dimension_back_end({std::string(test_paths::kStandins) + "/libHD.so", 1000})->find();
  EXPECT_EQ(other.problem->trouble, DeviceTrouble::symbol_missing);
  EXPECT_NE(base::to_line(other.problem->error).find("dhdGetDeviceCount"), std::string::npos);
}

TEST_F(ForceDimension, AnOlderLibraryWithoutTheButtonMaskStillWorks) {
  standin::DhdStage* const old = stage_of(std::string(test_paths::kStandins) + "/incomplete/libdhd.so");
  FeltPlane plane;
  auto device = force_dimension_back_end({std::string(test_paths::kStandins) + "/incomplete/libdhd.so", 1000})
                    ->open("forcedimension", {});
  ASSERT_TRUE(device);
  old->buttons = 1;
  ASSERT_TRUE(device->device->start(plane));
  EXPECT_TRUE(comes_true([&] { return plane.buttons == 1U; }));
}

TEST_F(ForceDimension, ADeviceThatIsOpenIsListedAsInUse) {
  const OpenedDevice device = opened();
  EXPECT_EQ(back_end->find().problem->trouble, DeviceTrouble::in_use);
  EXPECT_EQ(back_end->open("forcedimension", {}).error().trouble, DeviceTrouble::in_use);
}

}  // namespace
}  // namespace nazori::devices
