// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/inverse_service.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>

#include "felt_plane.h"
#include "standins/inverse_standin.h"

namespace nazori::devices {
namespace {

using haptics::DeviceState;
using haptics::DeviceTrouble;
using standin::InverseService;
using test::comes_true;
using test::FeltPlane;
using test::Vec3;

class Inverse3 : public testing::Test {
 protected:
  [[nodiscard]] InverseServiceSettings settings() const {
    InverseServiceSettings s;
    s.port = service->port();
    s.delay_s = 0.020;   // so that no force depends on how busy the machine is
    s.give_up_s = 3600;  // only one test waits for it
    return s;
  }
  [[nodiscard]] OpenedDevice opened() const { return opened(settings()); }
  static OpenedDevice opened(const InverseServiceSettings& s) {
    OpenRequest request;
    request.calibration.emplace();
    DeviceResult<OpenedDevice> device;
    // It gives up after half a second; retried in case the machine paused for that long.
    EXPECT_TRUE(comes_true([&] {
      return bool(device = inverse_service_back_end(s)->open("inverse3", request));
    })) << base::to_line(device.error().error);
    return std::move(*device);
  }
  [[nodiscard]] double force() const {
    return std::hypot(service->force_x_n, service->force_y_n, service->force_z_n);
  }
  /// Presses 3 mm into an upright tablet: forward, away from the learner.
  void press() const { service->y_m = 0.003; }

  std::unique_ptr<InverseService> service = std::make_unique<InverseService>();
};

TEST_F(Inverse3, IsFoundByTheNameThatTheServiceGivesIt) {
  BackEndFindings found;
  ASSERT_TRUE(comes_true([&] {
    found = inverse_service_back_end(settings())->find();
    return found.devices.size() == 1;
  }));
  EXPECT_EQ(found.devices.front().id, "inverse3:049D");
  EXPECT_FALSE(found.problem);
  const auto opens = [&](const char* id) { return inverse_service_back_end(settings())->open(id, {}); };
  EXPECT_TRUE(comes_true([&] {
    const auto device = opens("inverse3:049D");
    return device && device->id == "inverse3:049D";
  }));
  EXPECT_TRUE(comes_true([&] {
    const auto device = opens("inverse3:XXXX");
    return !device && device.error().trouble == DeviceTrouble::device_absent;
  }));
}

TEST_F(Inverse3, AKnownPlaneIsFeltInTheServicesFrameWithoutAMalformedMessage) {
  FeltPlane plane;
  OpenedDevice device = opened();
  service->x_m = 0.01;
  service->z_m = 0.02;
  press();
  ASSERT_TRUE(device.device->start(plane));
  // 3 mm at 200 N/m, towards the learner: against +y, which is forward.
  EXPECT_TRUE(comes_true([&] { return std::abs(service->force_y_n + 0.6) < 1e-9; })) << service->force_y_n;
  EXPECT_EQ(service->force_x_n, 0);
  EXPECT_EQ(service->force_z_n, 0);
  EXPECT_NEAR(plane.x_m, 0.01, 1e-12);
  EXPECT_NEAR(plane.y_m, 0.02, 1e-12);  // up is up
  device.device->stop();
  EXPECT_TRUE(comes_true([&] { return force() == 0; }));
  EXPECT_EQ(service->malformed, 0);
}

TEST_F(Inverse3, GripButtonsRateAndDelayAreSeen) {
  FeltPlane plane;
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(plane));
  service->button_b = true;
  EXPECT_TRUE(comes_true([&] { return device.device->status().buttons == 2U; }));
  EXPECT_TRUE(comes_true([&] { return device.device->status().delay_s > 0; }));
  service.reset();
  EXPECT_TRUE(comes_true([&] {
    const haptics::DeviceStatus now = device.device->status();
    return now.trouble == DeviceTrouble::service_gone && now.buttons == 0;
  })) << "a service that is gone holds no button down";
}

TEST_F(Inverse3, TheForceIsHeldToTheCap) {
  for (const double cap : {2.0, 1.0}) {
    InverseServiceSettings s = settings();
    s.force_cap_n = cap;
    test::Push strong({0, 0, 50});
    OpenedDevice device = opened(s);
    EXPECT_EQ(device.device->describe().limits.max_force_n, cap);
    ASSERT_TRUE(device.device->start(strong));
    EXPECT_TRUE(comes_true([&] { return force() > 0.5 * cap; }));
    EXPECT_LE(force(), cap + 1e-12);
    device.device->stop();
    // The service hears of the end a moment later, and the next device meets the same service.
    EXPECT_TRUE(comes_true([&] { return force() == 0; }));
  }
}

TEST_F(Inverse3, TheCapIsHeldBetweenATenthOfANewtonAndTen) {
  InverseServiceSettings s = settings();
  for (const auto& [asked_n, most_n, lasting_n] :
       {std::tuple{0.05, 0.1, 0.1}, {0.2, 0.2, 0.2}, {9.0, 9.0, 2.0}, {20.0, 10.0, 2.0}}) {
    s.force_cap_n = asked_n;
    const haptics::DeviceLimits limits = opened(s).device->describe().limits;
    EXPECT_EQ(limits.max_force_n, most_n);
    EXPECT_EQ(limits.continuous_force_n, lasting_n);
  }
}

TEST_F(Inverse3, AnOldServiceIsSpokenToInTheOldSpelling) {
  service->version = "3.1.0";
  service->takes_vector = service->knows_presets = false;
  FeltPlane plane;
  OpenedDevice device = opened();
  press();
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(comes_true([&] { return force() > 0.3; }));
}

TEST_F(Inverse3, AServiceThatPassesOverOneSpellingIsSpokenToInTheOther) {
  service->takes_vector = false;  // whatever its version says
  FeltPlane plane;
  OpenedDevice device = opened();
  press();
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(comes_true([&] { return force() > 0.3; }));
  EXPECT_GT(plane.absent, 0);  // the servo restarted, with its ramp
}

TEST_F(Inverse3, AServiceThatNeverReportsAForceIsSpokenToInTheOtherSpellingOnlyOnce) {
  service->reports_no_other_than_zero = true;
  test::Push push({0, 0, 1});
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(push));
  ASSERT_TRUE(comes_true([&] { return service->spelling_changes == 1; }));
  // A second doubt would have ended after a fifth of a second: two hundred messages.
  const int then = service->messages;
  ASSERT_TRUE(comes_true([&] { return service->messages > then + 1000; }));
  EXPECT_EQ(service->spelling_changes, 1);
}

TEST_F(Inverse3, BeforePresetsTheTabletLiesInTheMiddleOfTheReachAllTheSame) {
  service->knows_presets = service->takes_vector = false;
  for (const char* version : {"3.4.9", static_cast<const char*>(nullptr)}) {
    for (const bool left : {false, true}) {
      service->version = version;
      service->left_handed = left;
      service->x_m = 0.01;
      service->z_m = 0.02;
      press();
      FeltPlane plane;
      OpenedDevice device = opened();
      ASSERT_TRUE(device.device->start(plane));
      EXPECT_TRUE(comes_true([&] { return std::abs(service->force_y_n + 0.6) < 1e-9; }))
          << service->force_y_n;
      EXPECT_NEAR(plane.x_m, 0.01, 1e-12) << left;
      EXPECT_NEAR(plane.y_m, 0.02, 1e-12);
      device.device->stop();
      // The service hears of the end a moment later, and the next device meets the same service.
      EXPECT_TRUE(comes_true([&] { return force() == 0; }));
    }
  }
  EXPECT_EQ(service->malformed, 0);
}

TEST_F(Inverse3, AServiceThatDoesNotTellItsVersionShowsByItsInventoryThatItKnowsPresets) {
  service->version = nullptr;
  press();
  FeltPlane plane;
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(comes_true([&] { return std::abs(service->force_y_n + 0.6) < 1e-9; })) << service->force_y_n;
}

TEST_F(Inverse3, AMinverseReachesLessAndIsNotPlacedByGuessing) {
  const DeviceWorkspace workspace = opened().workspace;
  const double wide_m = workspace.high_m.x;
  EXPECT_NEAR(wide_m, 0.1 / std::sqrt(3.0), 1e-12);
  EXPECT_EQ(workspace.high_m, Vec3(wide_m));
  EXPECT_EQ(workspace.low_m, Vec3(-wide_m));
  service->type = "inverse3x";
  EXPECT_EQ(opened().workspace.high_m.x, wide_m);
  EXPECT_EQ(opened().device->describe().name, "Inverse3x 049D");
  service->type = "minverse";
  EXPECT_NEAR(opened().workspace.high_m.x, 0.04 / std::sqrt(3.0), 1e-12);
  EXPECT_EQ(inverse_service_back_end(settings())->find().devices.at(0).name, "Minverse 049D");
  service->version = "3.4.0";
  service->knows_presets = false;
  EXPECT_TRUE(comes_true([&] {
    const auto device = inverse_service_back_end(settings())->open("inverse3", {});
    return !device && device.error().trouble == DeviceTrouble::bad_calibration &&
           device.error().error.remedy == "update haply-inverse-service to 3.5 or later";
  }));
}

TEST_F(Inverse3, TheNewestPositionIsFeltAlsoWhereTheServiceSendsTwoStatesForACommand) {
  service->states_for_a_message = 2;
  FeltPlane plane;
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(plane));
  const int at_start = service->messages;
  ASSERT_TRUE(comes_true([&] { return service->messages > at_start + 1000 && plane.present > 0; }));
  // Reading only one message per tick would be a thousand messages behind by now.
  service->x_m = 0.03;
  const int moved_at = service->messages;
  ASSERT_TRUE(comes_true([&] { return std::abs(plane.x_m - 0.03) < 1e-9; }));
  EXPECT_LT(service->messages - moved_at, 500);
}

TEST_F(Inverse3, TheLastThatItIsToldIsNoForce) {
  test::Push push({0, 0, 1});
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(push));
  EXPECT_TRUE(comes_true([&] { return service->last_command_n > 0.1; }));
  device.device->stop();
  EXPECT_TRUE(comes_true([&] { return service->last_command_n == 0; }));
}

TEST_F(Inverse3, AServoThatStandsStillDoesNotGoOnPushing) {
  test::StuckPush servo({0, 0, 1});
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(servo));
  EXPECT_TRUE(comes_true([&] { return force() > 0.1; }));
  servo.stick();
  EXPECT_TRUE(comes_true([&] { return force() == 0; }));
  const int before = service->messages;
  EXPECT_TRUE(comes_true([&] { return service->messages > before + 3; })) << "the session stays";
  servo.go_on();
  EXPECT_TRUE(comes_true([&] { return force() > 0.1; }));
}

TEST_F(Inverse3, TheServosThreadNeverWaitsForTheService) {
  // Before the device, which calls them until it is destroyed.
  test::Push push({0, 0, 1});
  FeltPlane ticks;
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(push));
  EXPECT_TRUE(comes_true([&] { return force() > 0.1; }));
  service->delay_ms = 200;
  const haptics::DeviceStatus slow =
      test::comes_to(*device.device, DeviceState::paused, DeviceTrouble::too_slow);
  EXPECT_GT(slow.rate_hz, 0);
  // While waiting for an answer, the servo continues to tick.
  device.device->stop();
  ASSERT_TRUE(device.device->start(ticks));
  const int begun = service->messages;
  EXPECT_TRUE(comes_true([&] { return service->messages > begun + 4; }));
  EXPECT_GT(ticks.ticks, 20 * (service->messages - begun)) << "one tick a message is a servo that waits";
  service->delay_ms = 0;
}

TEST_F(Inverse3, AnUncalibratedOrUnreadyArmGetsNoForceAndGoesOnWhenItIs) {
  test::Push push({0, 0, 1});
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(push));
  EXPECT_TRUE(comes_true([&] { return force() > 0.1; }));
  service->calibrated = false;
  EXPECT_TRUE(comes_true([&] { return device.device->status().trouble == DeviceTrouble::not_calibrated; }));
  EXPECT_TRUE(comes_true([&] { return force() == 0; }));
  service->calibrated = true;
  EXPECT_TRUE(comes_true([&] { return force() > 0.1; }));
  service->ready = false;
  EXPECT_TRUE(comes_true([&] { return device.device->status().trouble == DeviceTrouble::not_ready; }));
  EXPECT_TRUE(comes_true([&] { return force() == 0; }));
}

TEST_F(Inverse3, AnArmThatIsUnpluggedAndPluggedInGoesOnByItself) {
  test::Push push({0, 0, 1});
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(push));
  EXPECT_TRUE(comes_true([&] { return force() > 0.1; }));
  service->plugged = false;
  EXPECT_TRUE(
      comes_true([&] { return device.device->status().trouble == DeviceTrouble::communication_lost; }));
  EXPECT_TRUE(comes_true([&] { return force() == 0; }));
  service->plugged = true;
  EXPECT_TRUE(comes_true([&] { return force() > 0.1; }));
}

TEST_F(Inverse3, AServiceThatGoesAndComesBackIsConnectedToAgain) {
  test::Push push({0, 0, 1});
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(push));
  EXPECT_TRUE(comes_true([&] { return force() > 0.1; }));
  const std::uint16_t port = service->port();
  service.reset();
  const haptics::DeviceStatus gone =
      test::comes_to(*device.device, DeviceState::paused, DeviceTrouble::service_gone);
  EXPECT_NE(gone.message.find("start the service again"), std::string::npos);
  service = std::make_unique<InverseService>(port);
  EXPECT_TRUE(comes_true([&] { return force() > 0.1; }));
  service->hang_up = true;
  EXPECT_TRUE(comes_true([&] { return service->sessions >= 2 && force() > 0.1; }));
  EXPECT_EQ(service->malformed, 0);
}

TEST_F(Inverse3, AServiceThatStaysAwayMakesTheDeviceLost) {
  InverseServiceSettings s = settings();
  s.give_up_s = 0.2;
  test::Push push({0, 0, 1});
  OpenedDevice device = opened(s);
  ASSERT_TRUE(device.device->start(push));
  service.reset();
  EXPECT_TRUE(comes_true([&] { return device.device->status().state == DeviceState::lost; }));
  device.device->stop();
  EXPECT_EQ(inverse_service_back_end(s)->find().problem->trouble, DeviceTrouble::service_missing);
}

TEST_F(Inverse3, GarbageAndHugeMessagesGiveNoForceAndDoNotEndTheProgram) {
  for (const auto answer :
       {InverseService::Answer::garbage, InverseService::Answer::wrong_types, InverseService::Answer::huge}) {
    test::Push push({0, 0, 1});
    OpenedDevice device = opened();
    ASSERT_TRUE(device.device->start(push));
    EXPECT_TRUE(comes_true([&] { return force() > 0.1; }));
    service->answer = answer;
    EXPECT_TRUE(comes_true([&] { return device.device->status().trouble == DeviceTrouble::bad_message; }));
    EXPECT_TRUE(comes_true([&] { return force() == 0; }));
    service->answer = InverseService::Answer::state;
    EXPECT_TRUE(comes_true([&] { return force() > 0.1; }));
  }
}

TEST_F(Inverse3, TwentyMessagesThatCannotBeReadAreAnsweredAndTheNextEndsTheSession) {
  test::Push push({0, 0, 1});
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(push));
  EXPECT_TRUE(comes_true([&] { return force() > 0.1; }));
  service->garbles_inventory = true;
  service->answer = InverseService::Answer::garbage;
  service->hang_up = true;
  // A session may end earlier where the machine pauses; then the next one counts.
  EXPECT_TRUE(comes_true([&] { return service->most_after_garbled == 20; }))
      << service->most_after_garbled << " answers";
}

TEST_F(Inverse3, AServiceThatFallsSilentOrSlowGivesNoForceAndSaysSo) {
  test::Push push({0, 0, 1});
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(push));
  EXPECT_TRUE(comes_true([&] { return force() > 0.1; }));
  service->delay_ms = 60;
  EXPECT_TRUE(comes_true([&] { return device.device->status().trouble == DeviceTrouble::too_slow; }));
  EXPECT_TRUE(comes_true([&] { return force() == 0; }));
  service->delay_ms = 0;
  EXPECT_TRUE(comes_true([&] { return force() > 0.1; }));
  service->answer = InverseService::Answer::nothing;
  EXPECT_TRUE(comes_true([&] { return device.device->status().trouble == DeviceTrouble::too_slow; }));
  service->answer = InverseService::Answer::state;
  EXPECT_TRUE(comes_true([&] { return force() > 0.1; }));  // over a new connection
}

TEST_F(Inverse3, AServiceThatStaysSilentIsConnectedToAgain) {
  test::Push push({0, 0, 1});
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(push));
  EXPECT_TRUE(comes_true([&] { return force() > 0.1; }));
  // Neither side closes it: the connection exists but is dead.
  service->answer = InverseService::Answer::nothing;
  const int sessions = service->sessions;
  EXPECT_TRUE(comes_true([&] { return service->sessions > sessions; }));
  service->answer = InverseService::Answer::state;
  EXPECT_TRUE(comes_true([&] { return force() > 0.1; }));
}

TEST_F(Inverse3, TheDelayIsMeasuredAndASlowerServiceIsAnsweredWithLessForce) {
  InverseServiceSettings s = settings();
  s.delay_s.reset();
  const double measured_s = opened(s).device->describe().limits.delay_s;
  EXPECT_GE(measured_s, 0.001);
  EXPECT_LE(measured_s, 0.020);
  s.delay_s = 0;
  test::Push push({0, 0, 1});
  OpenedDevice device = opened(s);
  service->delay_ms = 8;
  ASSERT_TRUE(device.device->start(push));
  // K may be (T/2 + 0) / (T/2 + 8 ms or more) of what a service without delay allows: a seventeenth.
  EXPECT_TRUE(comes_true([&] { return force() > 0 && force() <= 1.0 / 17; }));
}

TEST_F(Inverse3, ADelayThatIsSetIsHeldToWhatCanBeFelt) {
  InverseServiceSettings s = settings();
  for (const auto& [set_s, planned_s] : {std::pair{0.003, 0.003}, {-1.0, 0.0}, {1.0, 0.020}}) {
    s.delay_s = set_s;
    EXPECT_EQ(opened(s).device->describe().limits.delay_s, planned_s);
  }
}

TEST_F(Inverse3, WhatIsNoServiceOrHasNoArmIsSaidInOneLine) {
  service->plugged = false;
  EXPECT_TRUE(comes_true([&] {
    const auto problem = inverse_service_back_end(settings())->find().problem;
    return problem && problem->trouble == DeviceTrouble::device_absent;
  }));
  const InverseServiceSettings s = settings();
  service.reset();
  const BackEndFindings gone = inverse_service_back_end(s)->find();
  EXPECT_EQ(gone.problem->trouble, DeviceTrouble::service_missing);
  EXPECT_NE(base::to_line(gone.problem->error).find("haply-inverse-service"), std::string::npos);
  InverseServiceSettings nowhere;
  nowhere.host = "not an address";
  EXPECT_EQ(inverse_service_back_end(nowhere)->find().problem->trouble, DeviceTrouble::service_missing);
}

TEST_F(Inverse3, AnUnusableCalibrationIsRefused) {
  OpenRequest request;
  request.calibration.emplace();
  request.calibration->scale = -1;
  EXPECT_TRUE(comes_true([&] {
    const auto device = inverse_service_back_end(settings())->open("inverse3", request);
    return !device && device.error().trouble == DeviceTrouble::bad_calibration;
  }));
}

}  // namespace
}  // namespace nazori::devices
