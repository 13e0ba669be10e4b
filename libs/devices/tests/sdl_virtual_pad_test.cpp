// SPDX-License-Identifier: Apache-2.0
// SDL itself, end to end, over a gamepad that SDL acts out.
#include <SDL2/SDL.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>
#include <optional>

#include "default_signals.h"
#include "felt_plane.h"
#include "nazori/devices/device_trial.h"
#include "nazori/devices/game_controllers.h"
#include "sdl_port.h"
#include "standins/virtual_pad.h"

namespace nazori::devices {
namespace {

using haptics::DeviceState;
using haptics::DeviceTrouble;
using standin::VirtualPad;
using test::comes_true;
using test::FeltPlane;
using test::Vec3;

class VirtualGamepad : public testing::Test {
 protected:
  VirtualGamepad() {
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    EXPECT_EQ(SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER), 0) << SDL_GetError();
  }
  ~VirtualGamepad() override { SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER); }
  /// The virtual pad among whatever else may be plugged in.
  std::string id_of_pad() {
    for (const FoundDevice& device : back_end->find().devices) {
      if (device.name == "Nazori's virtual pad") return device.id;
    }
    return {};
  }
  OpenedDevice opened(const OpenRequest& request = {}) {
    auto device = back_end->open(id_of_pad(), request);
    EXPECT_TRUE(device) << base::to_line(device.error().error);
    return std::move(*device);
  }

  std::unique_ptr<BackEnd> back_end = game_controllers_back_end();
};

TEST_F(VirtualGamepad, TheStickOfTheWritingHandIsThePosition) {
  const VirtualPad pad;
  for (const WritingHand hand : {WritingHand::right, WritingHand::left}) {
    const bool right = hand == WritingHand::right;
    OpenRequest request;
    request.posture.hand = hand;
    FeltPlane plane;
    OpenedDevice device = opened(request);
    ASSERT_TRUE(device.device->start(plane));
    EXPECT_TRUE(comes_true([&] { return plane.present > 0 && plane.z_m > 0.004; }));
    pad.axis(right ? SDL_CONTROLLER_AXIS_RIGHTX : SDL_CONTROLLER_AXIS_LEFTX, 32767);
    EXPECT_TRUE(comes_true([&] { return std::abs(plane.x_m - 0.055) < 1e-6; }));
    EXPECT_NEAR(plane.y_m, 0, 1e-3);
    pad.axis(right ? SDL_CONTROLLER_AXIS_RIGHTY : SDL_CONTROLLER_AXIS_LEFTY, -32768);  // SDL's up
    EXPECT_TRUE(comes_true([&] { return std::abs(plane.y_m - 0.055) < 1e-6; }));
    pad.axis(right ? SDL_CONTROLLER_AXIS_TRIGGERRIGHT : SDL_CONTROLLER_AXIS_TRIGGERLEFT, 32767);
    EXPECT_TRUE(comes_true([&] { return plane.z_m < -0.010; }));
    std::uint32_t bit = 1;
    for (const auto button : {SDL_CONTROLLER_BUTTON_A, SDL_CONTROLLER_BUTTON_B, SDL_CONTROLLER_BUTTON_X,
                              SDL_CONTROLLER_BUTTON_Y}) {
      pad.button(button, true);
      EXPECT_TRUE(comes_true([&] { return device.device->status().buttons == bit; })) << button;
      pad.button(button, false);
      EXPECT_TRUE(comes_true([&] { return device.device->status().buttons == 0U; }));
      bit <<= 1U;
    }
    pad.axis(right ? SDL_CONTROLLER_AXIS_TRIGGERRIGHT : SDL_CONTROLLER_AXIS_TRIGGERLEFT, -32768);
    EXPECT_TRUE(comes_true([&] { return plane.z_m > 0.004; }));
    // The shoulder presses all the way down.
    pad.button(right ? SDL_CONTROLLER_BUTTON_RIGHTSHOULDER : SDL_CONTROLLER_BUTTON_LEFTSHOULDER, true);
    EXPECT_TRUE(comes_true([&] { return std::abs(plane.z_m + 0.0115) < 1e-6; }));
    pad.button(right ? SDL_CONTROLLER_BUTTON_RIGHTSHOULDER : SDL_CONTROLLER_BUTTON_LEFTSHOULDER, false);
  }
}

TEST_F(VirtualGamepad, RumblesWhileAWallPushesAndStopsWithTheDevice) {
  const VirtualPad pad;
  test::Push push({0.8, 0, 0});
  OpenedDevice device = opened();
  ASSERT_TRUE(device.device->start(push));
  EXPECT_TRUE(comes_true([&] { return pad.low > 0; }));
  EXPECT_EQ(pad.high, 0);
  device.device->stop();
  EXPECT_EQ(pad.low, 0);
}

TEST_F(VirtualGamepad, ATrialTellsItsRateLatenessNoiseAndRoundTrip) {
  const VirtualPad pad;
  OpenedDevice device = opened();
  DeviceTrial trial(device.device->describe().rate_hz);
  struct Counted final : haptics::ServoCallback {
    explicit Counted(DeviceTrial& of) : trial(of) {}
    Vec3 tick(const haptics::DeviceSample& sample) noexcept override {
      const Vec3 force = trial.tick(sample);
      ++ticks;
      return force;
    }
    DeviceTrial& trial;
    std::atomic<int> ticks{0};
  } counted(trial);
  ASSERT_TRUE(device.device->start(counted));
  EXPECT_TRUE(comes_true([&] { return device.device->status().delay_s > 0; }));
  EXPECT_TRUE(comes_true([&] { return counted.ticks > 4 * DeviceTrial::kRestTicks; }));
  device.device->stop();
  const TrialResult found = trial.result();
  EXPECT_GT(found.ticks, 0U);
  EXPECT_GT(found.rate_hz, 0);
  std::uint64_t periods = 0;
  for (const auto ticks : found.lateness) periods += ticks;
  EXPECT_EQ(periods, found.ticks - 1);
  EXPECT_GE(found.rest_noise_m, 0);
  EXPECT_LT(found.rest_noise_m, 1e-9) << "nobody moves the stick";
}

TEST_F(VirtualGamepad, UnpluggedItIsLostAndPluggedInItIsFoundAgain) {
  auto pad = std::make_unique<VirtualPad>();
  test::Push push({0.8, 0, 0});
  OpenedDevice device = opened();
  const std::string id = device.id;
  ASSERT_TRUE(device.device->start(push));
  EXPECT_TRUE(comes_true([&] { return pad->low > 0; }));
  EXPECT_EQ(back_end->find().problem->trouble, DeviceTrouble::in_use);
  pad.reset();
  EXPECT_EQ(test::comes_to(*device.device, DeviceState::lost, DeviceTrouble::communication_lost).state,
            DeviceState::lost);
  EXPECT_EQ(id_of_pad(), "");
  pad = std::make_unique<VirtualPad>();
  EXPECT_EQ(id_of_pad(), id);
  device = opened();
  ASSERT_TRUE(device.device->start(push));
  EXPECT_TRUE(comes_true([&] { return pad->low > 0; }));
}

TEST_F(VirtualGamepad, SdlTakesNoSignals) {
  // SDL handles signals when it starts, but only those that are neither handled nor ignored.
  const test::DefaultSignals signals;
  SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
  ASSERT_EQ(SDL_WasInit(SDL_INIT_EVERYTHING), 0U);
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "0");
  (void)back_end->find();
  for (const int number : {SIGINT, SIGTERM}) {
    struct sigaction action {};
    ASSERT_EQ(sigaction(number, nullptr, &action), 0);
    EXPECT_EQ(action.sa_handler, SIG_DFL) << number;
  }
  back_end.reset();
  EXPECT_EQ(SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER), 0) << SDL_GetError();
}

TEST_F(VirtualGamepad, AWheelIsToldByItsType) {
  const auto listed = [](SDL_JoystickType type) {
    const int index = SDL_JoystickAttachVirtual(type, 2, 1, 0);
    EXPECT_GE(index, 0) << SDL_GetError();
    const SDL_JoystickID instance = SDL_JoystickGetDeviceInstanceID(index);
    std::optional<bool> is_wheel;
    const auto all = sdl::system_port()->list();
    EXPECT_TRUE(all);
    for (const sdl::Listed& device : *all) {
      if (device.instance == instance) is_wheel = device.abilities.wheel;
    }
    for (int i = 0; i < SDL_NumJoysticks(); ++i) {
      if (SDL_JoystickGetDeviceInstanceID(i) == instance) SDL_JoystickDetachVirtual(i);
    }
    return is_wheel;
  };
  EXPECT_EQ(listed(SDL_JOYSTICK_TYPE_WHEEL), true);
  EXPECT_EQ(listed(SDL_JOYSTICK_TYPE_FLIGHT_STICK), false);
}

TEST_F(VirtualGamepad, AJoysticksFirstButtonPressesAndItsOthersCountFromThere) {
  const int index = SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_FLIGHT_STICK, 2, 4, 0);
  ASSERT_GE(index, 0) << SDL_GetError();
  SDL_Joystick* const joystick = SDL_JoystickOpen(index);
  const SDL_JoystickID instance = SDL_JoystickInstanceID(joystick);
  {
    const auto port = sdl::system_port();
    const auto all = port->list();
    ASSERT_TRUE(all);
    const auto listed = std::find_if(all->begin(), all->end(),
                                     [&](const sdl::Listed& device) { return device.instance == instance; });
    ASSERT_NE(listed, all->end());
    EXPECT_FALSE(listed->abilities.pad);
    EXPECT_FALSE(listed->abilities.force());
    const auto controller = port->open(*listed, WritingHand::right);
    ASSERT_TRUE(controller);
    SDL_JoystickSetVirtualAxis(joystick, 0, 16384);
    SDL_JoystickSetVirtualAxis(joystick, 1, -32768);
    sdl::Reading reading = (*controller)->read();
    EXPECT_TRUE(reading.attached);
    EXPECT_NEAR(reading.x, 0.5, 1e-4);
    EXPECT_EQ(reading.y, 1) << "SDL's y is down";
    EXPECT_EQ(reading.press, 0);
    EXPECT_EQ(reading.buttons, 0U);
    const std::uint32_t bits[] = {0, 1, 2, 4};
    for (int button = 0; button < 4; ++button) {
      SDL_JoystickSetVirtualButton(joystick, button, 1);
      reading = (*controller)->read();
      EXPECT_EQ(reading.press, button == 0 ? 1 : 0);
      EXPECT_EQ(reading.buttons, bits[button]);
      SDL_JoystickSetVirtualButton(joystick, button, 0);
    }
    sdl::Listed gone = *listed;
    gone.instance = -7;
    EXPECT_FALSE(port->open(gone, WritingHand::right));
  }
  SDL_JoystickDetachVirtual(index);
  SDL_JoystickClose(joystick);
}

TEST_F(VirtualGamepad, ADeviceOutlivesItsBackEnd) {
  const VirtualPad pad;
  FeltPlane plane;
  OpenedDevice device = opened();
  back_end.reset();
  ASSERT_TRUE(device.device->start(plane));
  EXPECT_TRUE(comes_true([&] { return plane.present > 10; }));
}

}  // namespace
}  // namespace nazori::devices
