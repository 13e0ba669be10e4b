// SPDX-License-Identifier: Apache-2.0
// What the library of Force Dimension refuses, lacks or says only for a moment.
#include "force_dimension_fixture.h"

namespace nazori::devices {
namespace {

using haptics::DeviceState;
using haptics::DeviceTrouble;
using test::comes_true;
using test::FeltPlane;
using test::ForceDimension;

TEST_F(ForceDimension, SixteenDevicesAreLookedFor) {
  stage->devices = 20;
  EXPECT_EQ(back_end->find().devices.size(), 16U);
  EXPECT_EQ(back_end->open("forcedimension:15", {})->id, "forcedimension:15");
  EXPECT_EQ(back_end->open("forcedimension:16", {}).error().trouble, DeviceTrouble::device_absent);
}

TEST_F(ForceDimension, OneOfTwoMayBeOpen) {
  stage->devices = 2;
  const auto second = back_end->open("forcedimension:1", {});
  ASSERT_TRUE(second);
  const BackEndFindings found = back_end->find();
  ASSERT_EQ(found.devices.size(), 2U);
  EXPECT_EQ(found.devices[0].id, "forcedimension:0");
  EXPECT_EQ(found.devices[1].id, "forcedimension:1");
  EXPECT_EQ(found.devices[1].name, "omega.3");
  EXPECT_EQ(found.problem->trouble, DeviceTrouble::in_use);
  EXPECT_TRUE(back_end->open("forcedimension:0", {}));
  EXPECT_EQ(back_end->open("forcedimension:1", {}).error().trouble, DeviceTrouble::in_use);
}

TEST_F(ForceDimension, ALargestForceOfNothingIsNoAnswer) {
  for (const double answer : {0.0, -1.0, std::nan("")}) {
    stage->max_force_n = answer;
    EXPECT_EQ(opened().device->describe().limits.max_force_n, 12) << answer;
  }
}

TEST_F(ForceDimension, ADeviceWithoutANameIsCalledByItsMaker) {
  for (const char* name : {"", static_cast<const char*>(nullptr)}) {
    stage->name = name;
    EXPECT_EQ(opened().device->describe().name, "Force Dimension device");
  }
}

TEST_F(ForceDimension, ForcesAreSwitchedOnWithNoneLeftFromBefore) {
  stage->force_x_n = 5;  // of another program
  FeltPlane plane;
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_EQ(stage->enables, 1);
  EXPECT_EQ(stage->switched_on_with_n, 0);
}

TEST_F(ForceDimension, ADeviceThatDoesNotSwitchItsForcesOnDoesNotStart) {
  FeltPlane plane;
  OpenedDevice device = opened();
  for (const bool wordless : {false, true}) {
    stage->wordless = wordless;
    stage->devices = 0;
    const auto started = device.device->start(plane);
    ASSERT_FALSE(started);
    const std::string line = base::to_line(started.error());
    EXPECT_NE(line.find("it does not output force: "), std::string::npos) << line;
    EXPECT_NE(line.find(wordless ? "error 2" : "communication error"), std::string::npos) << line;
    EXPECT_EQ(device.device->status().state, DeviceState::stopped);
  }
  stage->devices = 1;
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(comes_true([&] { return plane.present > 3; }));
}

TEST_F(ForceDimension, TheStatusIsAskedForInEverySixteenthTick) {
  FeltPlane plane;
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(comes_true([&] { return stage->reads > 100; }));
  device.device->stop();
  EXPECT_EQ(stage->looks, (stage->reads + 15) / 16);
}

TEST_F(ForceDimension, AStatusThatIsRefusedSaysNothing) {
  stage->bad_status = true;
  FeltPlane plane;
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(comes_true([&] { return stage->looks > 5; }));
  EXPECT_EQ(plane.absent, 0);
}

TEST_F(ForceDimension, ForcesAreOffWhereTwoLooksSaySo) {
  FeltPlane plane;
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(plane));
  const auto absent_after = [&](int looks) {
    const int before = plane.absent;
    stage->looks_off = looks;
    const std::uint64_t from = stage->looks;
    EXPECT_TRUE(comes_true([&] { return stage->looks_off == 0 && stage->looks > from + 6; }));
    return plane.absent - before;
  };
  EXPECT_EQ(absent_after(1), 0) << "switching them on takes a moment";
  EXPECT_EQ(absent_after(1), 0) << "each time anew";
  EXPECT_EQ(absent_after(2), 16);
  EXPECT_EQ(absent_after(3), 32);
}

TEST_F(ForceDimension, OnceItIsHomedForcesAreSwitchedOnAtTheNextLookWithoutARest) {
  FeltPlane plane;
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(comes_true([&] { return plane.present > 3; }));
  stage->force_off_cause = 2;
  EXPECT_TRUE(comes_true([&] { return device.device->status().trouble == DeviceTrouble::forces_off; }));
  stage->not_homed = true;
  const auto paused = test::comes_to(*device.device, DeviceState::paused, DeviceTrouble::not_homed);
  EXPECT_EQ(paused.message.find("(code"), std::string::npos) << "of the cause before: " << paused.message;
  stage->force_off_cause = 0;
  stage->force_on = false;
  const int enables = stage->enables;
  stage->not_homed = false;
  const std::uint64_t from = stage->looks;
  EXPECT_TRUE(comes_true([&] { return stage->enables > enables; }));
  EXPECT_LE(stage->switched_on_at_look, from + 2) << "a rest would be thirty looks";
}

TEST_F(ForceDimension, AForceThatIsRefusedPausesItAndTwentyInARowAreTheEnd) {
  FeltPlane plane;
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(comes_true([&] { return plane.present > 3; }));
  stage->bad_writes = 1'000'000;
  (void)test::comes_to(*device.device, DeviceState::lost, DeviceTrouble::communication_lost);
  device.device->stop();
  EXPECT_EQ(plane.absent, 20);
}

TEST_F(ForceDimension, ALibraryThatHasOnlyWhatEveryVersionHasWorks) {
  standin::DhdStage* const old = stage_of(kOlderLibrary);
  old->name = "Falcon";  // which it has no function to tell
  FeltPlane plane;
  ForceDimensionSettings older;
  older.library = kOlderLibrary;
  OpenRequest as_it_is;
  as_it_is.calibration.emplace();
  auto device = force_dimension_back_end(older)->open("forcedimension", as_it_is);
  ASSERT_TRUE(device);
  EXPECT_EQ(device->device->describe().name, "Force Dimension device");
  EXPECT_EQ(device->device->describe().limits.max_force_n, 12);
  old->buttons = 0;
  ASSERT_TRUE(device->device->start(plane));
  EXPECT_TRUE(comes_true([&] { return plane.ticks > 3; }));
  EXPECT_EQ(plane.buttons, 0U);
  old->buttons = 1;
  EXPECT_TRUE(comes_true([&] { return plane.buttons == 1U; }));
}

}  // namespace
}  // namespace nazori::devices
