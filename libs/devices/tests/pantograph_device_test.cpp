// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "felt_plane.h"
#include "nazori/devices/device_catalogue.h"
#include "nazori/devices/pantograph.h"
#include "pantograph_model.h"
#include "pantograph_truth.h"
#include "standins/pantograph_board.h"

namespace nazori::devices {
namespace {

using haptics::DeviceState;
using haptics::DeviceTrouble;
using pantograph::PerJoint;
using pantograph::Vec2;
using standin::PantographBoard;
using test::comes_true;
using test::FeltPlane;
using test::Push;
using test::Vec3;
using Fault = PantographBoard::Fault;

const pantograph::Model& kVersion3 = pantograph::kModels[0];

class Pantograph2diy : public testing::Test {
 protected:
  [[nodiscard]] PantographSettings settings() const {
    PantographSettings s;
    s.port = board.path();
    s.delay_s = 0.020;   // so that no force depends on how busy the machine is
    s.give_up_s = 3600;  // only one test waits for it
    return s;
  }
  [[nodiscard]] OpenedDevice opened() const { return opened(settings()); }
  static OpenedDevice opened(const PantographSettings& s) {
    OpenRequest request;
    request.calibration.emplace();
    DeviceResult<OpenedDevice> device;
    EXPECT_TRUE(comes_true([&] {
      return bool(device = pantograph_back_end(s)->open("pantograph:3", request));
    })) << base::to_line(device.error().error);
    return std::move(*device);
  }
  /// Moves the handle there, device frame.
  void move(double x_m, double y_m) {
    const Vec2 handle(kVersion3.linkage.motors_m / 2 - x_m, pantograph::kMiddle_m - y_m);
    const PerJoint angles = *pantograph::truth::angles_at(kVersion3.linkage, handle);
    board.arm_deg[1] = angles[0];
    board.arm_deg[0] = angles[1];
  }
  [[nodiscard]] bool pushes() const { return board.torque_n_m[0] != 0 || board.torque_n_m[1] != 0; }
  [[nodiscard]] bool is_limp() const { return board.torque_n_m[0] == 0 && board.torque_n_m[1] == 0; }

  PantographBoard board;
};

TEST_F(Pantograph2diy, IsListedForEachVersionAndNeverChosenByItself) {
  const BackEndFindings found = pantograph_back_end(settings())->find();
  ASSERT_EQ(found.devices.size(), 2U);
  EXPECT_EQ(found.devices[0].id, "pantograph:3");
  EXPECT_EQ(found.devices[1].id, "pantograph:2");
  for (const FoundDevice& device : found.devices) {
    EXPECT_TRUE(device.has_force);
    EXPECT_FALSE(device.automatic);
    EXPECT_NE(device.name.find(board.path()), std::string::npos);
  }
  EXPECT_FALSE(found.problem);
  EXPECT_EQ(board.setups + board.resets + board.questions, 0) << "looking says nothing to the board";
  std::vector<std::unique_ptr<BackEnd>> all;
  all.push_back(pantograph_back_end(settings()));
  all.push_back(pointer_back_end());
  EXPECT_EQ(DeviceCatalogue(std::move(all)).open_best("", {}).opened->id, "pointer");
  EXPECT_EQ(board.setups + board.questions, 0);
}

TEST(PantographBoards, AreFoundByTheirUsbNumbersAndNoOthers) {
  namespace fs = std::filesystem;
  const fs::path root = fs::path(testing::TempDir()) / ("nazori-pantograph-" + std::to_string(getpid()));
  const auto plug_in = [&](const char* name, const char* product) {
    const fs::path device = root / "sys" / "class" / "tty" / name / "device";
    fs::create_directories(device);
    std::ofstream(device / "uevent") << "DRIVER=cdc_acm\nPRODUCT=" << product << "\n";
    fs::create_directories(root / "dev");
    std::ofstream(root / "dev" / name) << "";
  };
  PantographSettings s;
  s.device_folder = root / "dev";
  s.system_folder = root / "sys";
  plug_in("ttyACM0", "2988/302/100");  // a Touch
  plug_in("ttyACM1", "2341/43/1");     // an Arduino of another kind
  const BackEndFindings none = pantograph_back_end(s)->find();
  EXPECT_TRUE(none.devices.empty());
  EXPECT_EQ(none.problem->trouble, DeviceTrouble::device_absent);
  plug_in("ttyACM2", "2341/804d/100");
  plug_in("ttyACM3", "2341/3e/100");
  const BackEndFindings found = pantograph_back_end(s)->find();
  ASSERT_EQ(found.devices.size(), 4U);
  EXPECT_EQ(found.devices[2].id, "pantograph:3.2");
  EXPECT_NE(found.devices[2].name.find("ttyACM3"), std::string::npos);
  // A file is not a port: there is one message, and nothing is written to it.
  const auto opened = pantograph_back_end(s)->open("pantograph:3.2", {});
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().trouble, DeviceTrouble::init_failed);
  EXPECT_EQ(fs::file_size(root / "dev" / "ttyACM3"), 0U);
  EXPECT_EQ(pantograph_back_end(s)->open("pantograph:9", {}).error().trouble, DeviceTrouble::device_absent);
  if (geteuid() != 0) {  // root may open everything
    chmod((root / "dev" / "ttyACM2").c_str(), 0060);
    const BackEndFindings closed = pantograph_back_end(s)->find();
    EXPECT_EQ(closed.devices.size(), 2U);
    EXPECT_EQ(closed.problem->trouble, DeviceTrouble::no_permission);
    EXPECT_NE(closed.problem->error.remedy.find("usermod -aG"), std::string::npos);
  }
  fs::remove_all(root);
}

TEST_F(Pantograph2diy, ThePlaneIsTheTablets) {
  FeltPlane plane;
  OpenedDevice device = opened();
  move(0.02, -0.01);
  ASSERT_TRUE(device.device->start(plane));
  // A step of the encoder is 0.07 degrees, or 0.2 mm at the handle.
  EXPECT_TRUE(comes_true([&] {
    return std::abs(plane.x_m - 0.02) < 4e-4 && std::abs(plane.y_m + 0.01) < 4e-4;
  })) << plane.x_m
      << " " << plane.y_m;
  // Without a button the tip is down on the tablet, and above it beyond its edges.
  EXPECT_TRUE(comes_true([&] { return plane.z_m < -0.010; }));
  move(0.055, 0.01);
  EXPECT_TRUE(comes_true([&] { return plane.z_m > 0.004; }));
}

TEST_F(Pantograph2diy, AButtonPressesTheTipDown) {
  PantographSettings s = settings();
  s.has_button = true;
  FeltPlane plane;
  OpenedDevice device = opened(s);
  move(0, 0);
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(comes_true([&] { return plane.present > 50 && plane.z_m > 0.004 && plane.buttons == 0U; }));
  board.a2 = 12;
  EXPECT_TRUE(comes_true([&] { return plane.z_m < -0.010 && plane.buttons == 1U; }));
  board.a2 = 1020;
  EXPECT_TRUE(comes_true([&] { return plane.z_m > 0.004 && plane.buttons == 0U; }));
}

TEST_F(Pantograph2diy, APushIsTheTorquesThatDoItsWork) {
  for (const Vec3& force : {Vec3(0.5, 0, 0), Vec3(0, 0.5, 0), Vec3(-0.3, 0.4, 0)}) {
    Push push(force);
    board.arm_deg[0] = 12;  // at rest
    board.arm_deg[1] = 168;
    OpenedDevice device = opened();
    move(0.01, 0.02);
    ASSERT_TRUE(device.device->start(push));
    const Vec2 handle(kVersion3.linkage.motors_m / 2 - 0.01, pantograph::kMiddle_m - 0.02);
    const PerJoint torques =
        pantograph::truth::torques_for(kVersion3.linkage, handle, Vec2(-force.x, -force.y));
    // The position of the handle is known to one encoder step.
    EXPECT_TRUE(comes_true([&] {
      return std::abs(board.torque_n_m[1] - torques[0]) < 5e-4 &&
             std::abs(board.torque_n_m[0] - torques[1]) < 5e-4;
    })) << board.torque_n_m[1]
        << " " << torques[0] << ", " << board.torque_n_m[0] << " " << torques[1];
    device.device->stop();
    EXPECT_TRUE(comes_true([&] { return is_limp(); }));
  }
  EXPECT_EQ(board.unknown, 0);
  EXPECT_EQ(board.incomplete, 0);
}

TEST_F(Pantograph2diy, APushAlongTheDepthCannotBeGiven) {
  Push push({0, 0, 1});
  OpenedDevice device = opened();
  move(0, 0);
  ASSERT_TRUE(device.device->start(push));
  const int before = board.questions;
  EXPECT_TRUE(comes_true([&] { return board.questions > before + 50; }));
  device.device->stop();
  EXPECT_TRUE(is_limp());
  EXPECT_TRUE(comes_true([&] { return board.questions == board.zeros; }));
}

TEST_F(Pantograph2diy, TheForceIsHeldToWhatEveryDirectionHas) {
  Push push({0, 50, 0});
  OpenedDevice device = opened();
  EXPECT_EQ(device.device->describe().limits.max_force_n, pantograph::kMostForce_n);
  move(0, 0);
  ASSERT_TRUE(device.device->start(push));
  const Vec2 handle(kVersion3.linkage.motors_m / 2, pantograph::kMiddle_m);
  const PerJoint most =
      pantograph::truth::torques_for(kVersion3.linkage, handle, {0, -pantograph::kMostForce_n});
  EXPECT_TRUE(comes_true([&] { return std::abs(board.torque_n_m[1] - most[0]) < 1e-3; }))
      << board.torque_n_m[1];
  EXPECT_LT(std::abs(most[0]), PantographBoard::kMostTorque_n_m);
}

TEST_F(Pantograph2diy, AnglesCountFromWhereTheArmsAreWhenItIsOpened) {
  board.arm_deg[0] = 22;  // not at rest: both 10 degrees inwards
  board.arm_deg[1] = 158;
  FeltPlane plane;
  Push push({0.2, 0, 0});
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(plane));
  const double aside = 0.019 - 0.07 * std::cos(168 * pantograph::truth::kDegree);
  const double far =
      0.07 * std::sin(168 * pantograph::truth::kDegree) + std::sqrt(0.09 * 0.09 - aside * aside);
  EXPECT_TRUE(comes_true([&] { return std::abs(plane.y_m - (pantograph::kMiddle_m - far)) < 1e-3; }))
      << plane.y_m;
  device.device->stop();
  // Angles with crossed arms give an impossible position: no force, and a message.
  ASSERT_TRUE(device.device->start(push));
  EXPECT_TRUE(comes_true([&] { return pushes(); }));
  board.arm_deg[0] = 130;
  board.arm_deg[1] = 50;
  const haptics::DeviceStatus wrong =
      test::comes_to(*device.device, DeviceState::paused, DeviceTrouble::not_at_rest);
  EXPECT_NE(wrong.message.find("put its handle to rest"), std::string::npos);
  EXPECT_TRUE(comes_true([&] { return is_limp(); }));
}

TEST_F(Pantograph2diy, OpeningItPushesNothingAndADelayThatIsSetIsHeldToWhatCanBeFelt) {
  PantographSettings s = settings();
  for (const auto& [set_s, planned_s] : {std::pair{0.003, 0.003}, {-1.0, 0.0}, {1.0, 0.020}}) {
    s.delay_s = set_s;
    EXPECT_EQ(opened(s).device->describe().limits.delay_s, planned_s);
  }
  s.delay_s.reset();
  (void)opened(s);
  EXPECT_GT(board.questions, 0);
  EXPECT_EQ(board.questions, board.zeros);
}

TEST_F(Pantograph2diy, AnswersInPiecesAreOneAnswer) {
  board.piece = 1;
  Push push({0.5, 0, 0});
  OpenedDevice device = opened();
  move(0, 0);
  ASSERT_TRUE(device.device->start(push));
  EXPECT_TRUE(comes_true([&] { return pushes(); }));
}

TEST_F(Pantograph2diy, WhatAnEarlierProgramLeftInTheBoardIsSettledFirst) {
  {  // Half a setup and half a torque command, never completed.
    std::ofstream earlier(board.path(), std::ios::binary);
    earlier.write("\x02\x05\x01\x05\x03", 5).flush();
  }
  EXPECT_TRUE(comes_true([&] { return board.questions > 0; }));
  Push push({0.5, 0, 0});
  OpenedDevice device = opened();
  EXPECT_EQ(board.setups, 2) << "the half one, finished by zeros, and the right one";
  EXPECT_EQ(board.unknown, 0);
  move(0, 0);
  ASSERT_TRUE(device.device->start(push));
  EXPECT_TRUE(comes_true([&] { return pushes(); }));
}

TEST_F(Pantograph2diy, WhatIsWrongForAMomentGivesNoForceAndGoesOn) {
  const std::pair<Fault, DeviceTrouble> faults[] = {{Fault::silent, DeviceTrouble::too_slow},
                                                    {Fault::half, DeviceTrouble::too_slow},
                                                    {Fault::wrong_id, DeviceTrouble::bad_message},
                                                    {Fault::no_number, DeviceTrouble::bad_message},
                                                    {Fault::answers_twice, DeviceTrouble::bad_message}};
  Push push({0.5, 0, 0});
  OpenedDevice device = opened();
  move(0, 0);
  ASSERT_TRUE(device.device->start(push));
  for (const auto& [fault, trouble] : faults) {
    EXPECT_TRUE(comes_true([&] { return pushes(); })) << static_cast<int>(fault);
    board.fault = fault;
    EXPECT_TRUE(comes_true([&, expected = trouble] { return device.device->status().trouble == expected; }))
        << static_cast<int>(fault);
    EXPECT_TRUE(comes_true([&] { return is_limp(); })) << static_cast<int>(fault);
    board.fault = Fault::none;
  }
  EXPECT_TRUE(comes_true([&] { return pushes(); }));
}

/// Pushes on the right half of the tablet only.
class RightHalf final : public haptics::ServoCallback {
 public:
  Vec3 tick(const haptics::DeviceSample& sample) noexcept override {
    return sample.present && sample.position_m.x > 0 ? Vec3(0.5, 0, 0) : Vec3(0);
  }
};

TEST_F(Pantograph2diy, AnAnswerTooManyDoesNotMakeAllLaterOnesLate) {
  RightHalf servo;
  OpenedDevice device = opened();
  move(-0.02, 0);
  board.other_deg[0] = board.arm_deg[0].load();
  board.other_deg[1] = board.arm_deg[1].load();
  move(0.02, 0);
  ASSERT_TRUE(device.device->start(servo));
  EXPECT_TRUE(comes_true([&] { return pushes(); }));
  board.swings = true;
  EXPECT_TRUE(comes_true([&] { return board.in_time > 20; }));
  board.fault = Fault::answers_later;
  EXPECT_TRUE(comes_true([&] { return board.fault == Fault::none; }));
  const int in_time = board.in_time, late = board.late;
  EXPECT_TRUE(comes_true([&] { return board.in_time + board.late > in_time + late + 100; }));
  EXPECT_GT(board.in_time - in_time, board.late - late) << "each question finds the answer to the one before";
}

TEST_F(Pantograph2diy, ABoardThatWasNotSetUpAnswersWithItsIdAloneAndGetsNoForce) {
  Push push({0.5, 0, 0});
  OpenedDevice device = opened();
  move(0, 0);
  ASSERT_TRUE(device.device->start(push));
  EXPECT_TRUE(comes_true([&] { return pushes(); }));
  board.fault = Fault::forgets;
  EXPECT_TRUE(comes_true([&] { return device.device->status().trouble == DeviceTrouble::too_slow; }));
  EXPECT_EQ(board.setups, 1) << "its arms are anywhere now: it must not be set up again unasked";
}

TEST_F(Pantograph2diy, ABoardThatStaysSilentOrIsUnpluggedIsLost) {
  PantographSettings s = settings();
  s.give_up_s = 0.2;
  Push push({0.5, 0, 0});
  {
    OpenedDevice device = opened(s);
    move(0, 0);
    ASSERT_TRUE(device.device->start(push));
    EXPECT_TRUE(comes_true([&] { return pushes(); }));
    board.fault = Fault::silent;
    (void)test::comes_to(*device.device, DeviceState::lost, DeviceTrouble::communication_lost);
    EXPECT_EQ(device.device->status().state, DeviceState::lost);
    EXPECT_TRUE(comes_true([&] { return is_limp(); })) << "it was told zero, though it did not answer";
  }
  board.fault = Fault::none;
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(push));
  EXPECT_TRUE(comes_true([&] { return pushes(); }));
  board.unplug();
  (void)test::comes_to(*device.device, DeviceState::lost, DeviceTrouble::communication_lost);
  EXPECT_EQ(device.device->status().state, DeviceState::lost);
}

TEST_F(Pantograph2diy, AServoThatStandsStillDoesNotGoOnPushing) {
  test::StuckPush servo({0.5, 0, 0});
  OpenedDevice device = opened();
  move(0, 0);
  ASSERT_TRUE(device.device->start(servo));
  EXPECT_TRUE(comes_true([&] { return pushes(); }));
  servo.stick();
  EXPECT_TRUE(comes_true([&] { return is_limp(); }));
  servo.go_on();
  EXPECT_TRUE(comes_true([&] { return pushes(); }));
}

TEST_F(Pantograph2diy, ASlowBoardIsAnsweredWithLessForceAndTheServoTicksOn) {
  PantographSettings s = settings();
  s.delay_s.reset();
  const double measured_s = opened(s).device->describe().limits.delay_s;
  EXPECT_GT(measured_s, 0.001);
  EXPECT_LE(measured_s, 0.020);
  s.delay_s = 0;
  Push push({0.5, 0, 0});
  FeltPlane ticks;
  OpenedDevice device = opened(s);
  board.delay_ms = 8;
  move(0, 0);
  ASSERT_TRUE(device.device->start(push));
  const Vec2 handle(kVersion3.linkage.motors_m / 2, pantograph::kMiddle_m);
  const PerJoint full = pantograph::truth::torques_for(kVersion3.linkage, handle, {-0.5, 0});
  // K may be (T/2 + 0) / (T/2 + 8 ms or more) of what a board without delay allows: a seventeenth.
  EXPECT_TRUE(comes_true([&] {
    const double share = board.torque_n_m[1] / full[0];
    return share > 0 && share <= 1.0 / 17 + 1e-2;
  }));
  board.delay_ms = 200;
  device.device->stop();
  ASSERT_TRUE(device.device->start(ticks));
  const int begun = board.questions;
  EXPECT_TRUE(comes_true([&] { return board.questions > begun + 2; }));
  EXPECT_GT(ticks.ticks, 20 * (board.questions - begun)) << "one tick an answer is a servo that waits";
  board.delay_ms = 0;
}

TEST_F(Pantograph2diy, TheLastThatItIsToldIsZeroAndItConfirmsThat) {
  Push push({0.5, 0, 0});
  OpenedDevice device = opened();
  move(0, 0);
  for (int again = 0; again < 3; ++again) {
    ASSERT_TRUE(device.device->start(push));
    EXPECT_TRUE(comes_true([&] { return pushes(); }));
    const int zeros = board.zeros;
    device.device->stop();
    EXPECT_TRUE(comes_true([&] { return is_limp() && board.zeros > zeros; }));
  }
}

TEST_F(Pantograph2diy, APortIsOpenedOnceOnly) {
  const auto back_end = pantograph_back_end(settings());
  const auto first = back_end->open("pantograph", {});
  ASSERT_TRUE(first);
  EXPECT_EQ(first->id, "pantograph:3");
  EXPECT_EQ(back_end->open("pantograph:2", {}).error().trouble, DeviceTrouble::in_use);
  EXPECT_EQ(back_end->find().problem->trouble, DeviceTrouble::in_use);
  EXPECT_EQ(pantograph_back_end(settings())->open("pantograph:3", {}).error().trouble, DeviceTrouble::in_use)
      << "another program";
}

TEST_F(Pantograph2diy, WhatDoesNotAnswerAsABoardIsRefusedInOneSentence) {
  for (const Fault fault : {Fault::silent, Fault::wrong_id, Fault::half}) {
    board.fault = fault;
    const auto opened = pantograph_back_end(settings())->open("pantograph", {});
    ASSERT_FALSE(opened) << static_cast<int>(fault);
    EXPECT_EQ(opened.error().trouble, DeviceTrouble::init_failed);
    EXPECT_NE(opened.error().error.remedy.find("firmware"), std::string::npos);
  }
  PantographSettings nowhere;
  nowhere.port = "/nowhere/ttyACM7";
  EXPECT_EQ(pantograph_back_end(nowhere)->find().problem->trouble, DeviceTrouble::device_absent);
}

TEST_F(Pantograph2diy, AHandMayKnockTheArmsByTwentyDegreesWhileItIsOpened) {
  for (const double knocked : {19.5, 20.5, -19.5, -20.5}) {
    board.knocked_deg = knocked;
    const auto device = pantograph_back_end(settings())->open("pantograph", {});
    EXPECT_EQ(bool(device), std::abs(knocked) < 20) << knocked;
    if (!device) {
      EXPECT_EQ(device.error().error.what, "its board answers with angles that it was not given");
    }
  }
}

TEST_F(Pantograph2diy, AnUnusableCalibrationIsRefusedBeforeTheBoardIsTouched) {
  OpenRequest request;
  request.calibration.emplace();
  request.calibration->scale = -1;
  EXPECT_EQ(pantograph_back_end(settings())->open("pantograph", request).error().trouble,
            DeviceTrouble::bad_calibration);
  EXPECT_EQ(board.resets, 0);
}

TEST_F(Pantograph2diy, WithoutACalibrationTheTabletFitsIntoTheReachUpright) {
  OpenRequest request;
  request.posture.tilt_rad = 0;
  const auto opened = pantograph_back_end(settings())->open("pantograph", request);
  ASSERT_TRUE(opened);
  EXPECT_EQ(opened->calibration.posture.tilt_rad, TabletPosture{}.tilt_rad);
  EXPECT_LE(request.shape.width_m / opened->calibration.scale, 2 * pantograph::kReach_m);
}

}  // namespace
}  // namespace nazori::devices
