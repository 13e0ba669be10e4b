// SPDX-License-Identifier: Apache-2.0
// What is asked of SDL itself. SDL's force feedback is acted out here, because SDL has no virtual haptic
// device.
#include <SDL2/SDL.h>
#include <SDL2/SDL_haptic.h>
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>

#include "sdl_port.h"
#include "standins/virtual_pad.h"

namespace {

/// What SDL's functions do while one of these lives.
struct ActedSdl {
  struct Effect {
    SDL_HapticEffect what{};
    Uint32 times = 0;
    bool running = false;
  };
  ActedSdl() { now = this; }
  ~ActedSdl() { now = nullptr; }
  ActedSdl(const ActedSdl&) = delete;
  ActedSdl& operator=(const ActedSdl&) = delete;

  static inline ActedSdl* now = nullptr;
  int is_haptic = 1;
  unsigned can = SDL_HAPTIC_CONSTANT | SDL_HAPTIC_DAMPER | SDL_HAPTIC_GAIN | SDL_HAPTIC_AUTOCENTER;
  int axes = 2;
  bool sdl_starts = true, haptics_start = true;
  bool joysticks_open = true, haptics_open = true, pads_open = true, takes_effects = true;

  int haptics_running = 0;  // started and not ended
  int handles = 0;          // open handles of force feedback
  int handles_made = 0, updates = 0;
  int gain = -1, centring = -1;
  std::map<int, Effect> effects;

  [[nodiscard]] static int done_or_refused() { return now->takes_effects ? 0 : SDL_SetError("refused"); }
};

/// SDL's own function of that name.
template <class Function>
Function sdls_own(Function, const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace

// These replace SDL's functions. Without an ActedSdl they call them.
extern "C" {

int SDL_InitSubSystem(Uint32 flags) {
  if (ActedSdl::now == nullptr) return sdls_own(SDL_InitSubSystem, "SDL_InitSubSystem")(flags);
  if (flags == SDL_INIT_HAPTIC) {
    if (!ActedSdl::now->haptics_start) return SDL_SetError("no force feedback in this kernel");
    ++ActedSdl::now->haptics_running;
    return 0;
  }
  if (!ActedSdl::now->sdl_starts) return SDL_SetError("no joysticks in this kernel");
  return sdls_own(SDL_InitSubSystem, "SDL_InitSubSystem")(flags);
}
void SDL_QuitSubSystem(Uint32 flags) {
  if (ActedSdl::now != nullptr && flags == SDL_INIT_HAPTIC)
    --ActedSdl::now->haptics_running;
  else
    sdls_own(SDL_QuitSubSystem, "SDL_QuitSubSystem")(flags);
}
void SDL_JoystickUpdate() {
  if (ActedSdl::now != nullptr) ++ActedSdl::now->updates;
  sdls_own(SDL_JoystickUpdate, "SDL_JoystickUpdate")();
}
SDL_Joystick* SDL_JoystickOpen(int index) {
  if (ActedSdl::now != nullptr && !ActedSdl::now->joysticks_open) return nullptr;
  return sdls_own(SDL_JoystickOpen, "SDL_JoystickOpen")(index);
}
SDL_GameController* SDL_GameControllerOpen(int index) {
  if (ActedSdl::now != nullptr && !ActedSdl::now->pads_open) return nullptr;
  return sdls_own(SDL_GameControllerOpen, "SDL_GameControllerOpen")(index);
}
int SDL_JoystickIsHaptic(SDL_Joystick* joystick) {
  return ActedSdl::now != nullptr ? ActedSdl::now->is_haptic
                                  : sdls_own(SDL_JoystickIsHaptic, "SDL_JoystickIsHaptic")(joystick);
}
SDL_Haptic* SDL_HapticOpenFromJoystick(SDL_Joystick* joystick) {
  if (ActedSdl::now == nullptr)
    return sdls_own(SDL_HapticOpenFromJoystick, "SDL_HapticOpenFromJoystick")(joystick);
  if (!ActedSdl::now->haptics_open) return nullptr;
  ++ActedSdl::now->handles;
  ++ActedSdl::now->handles_made;
  return reinterpret_cast<SDL_Haptic*>(ActedSdl::now);
}
void SDL_HapticClose(SDL_Haptic* haptic) {
  if (ActedSdl::now == nullptr) return sdls_own(SDL_HapticClose, "SDL_HapticClose")(haptic);
  --ActedSdl::now->handles;
}
unsigned int SDL_HapticQuery(SDL_Haptic* haptic) {
  return ActedSdl::now != nullptr ? ActedSdl::now->can : sdls_own(SDL_HapticQuery, "SDL_HapticQuery")(haptic);
}
int SDL_HapticNumAxes(SDL_Haptic* haptic) {
  return ActedSdl::now != nullptr ? ActedSdl::now->axes
                                  : sdls_own(SDL_HapticNumAxes, "SDL_HapticNumAxes")(haptic);
}
int SDL_HapticSetGain(SDL_Haptic* haptic, int gain) {
  if (ActedSdl::now == nullptr) return sdls_own(SDL_HapticSetGain, "SDL_HapticSetGain")(haptic, gain);
  ActedSdl::now->gain = gain;
  return 0;
}
int SDL_HapticSetAutocenter(SDL_Haptic* haptic, int centring) {
  if (ActedSdl::now == nullptr)
    return sdls_own(SDL_HapticSetAutocenter, "SDL_HapticSetAutocenter")(haptic, centring);
  ActedSdl::now->centring = centring;
  return 0;
}
int SDL_HapticNewEffect(SDL_Haptic* haptic, SDL_HapticEffect* effect) {
  if (ActedSdl::now == nullptr) return sdls_own(SDL_HapticNewEffect, "SDL_HapticNewEffect")(haptic, effect);
  if (!ActedSdl::now->takes_effects) return SDL_SetError("refused");
  const int id = 3 + static_cast<int>(ActedSdl::now->effects.size());
  ActedSdl::now->effects[id].what = *effect;
  return id;
}
int SDL_HapticUpdateEffect(SDL_Haptic* haptic, int id, SDL_HapticEffect* effect) {
  if (ActedSdl::now == nullptr)
    return sdls_own(SDL_HapticUpdateEffect, "SDL_HapticUpdateEffect")(haptic, id, effect);
  ActedSdl::now->effects.at(id).what = *effect;
  return ActedSdl::done_or_refused();
}
int SDL_HapticRunEffect(SDL_Haptic* haptic, int id, Uint32 times) {
  if (ActedSdl::now == nullptr)
    return sdls_own(SDL_HapticRunEffect, "SDL_HapticRunEffect")(haptic, id, times);
  ActedSdl::now->effects.at(id).running = true;
  ActedSdl::now->effects.at(id).times = times;
  return ActedSdl::done_or_refused();
}
int SDL_HapticStopEffect(SDL_Haptic* haptic, int id) {
  if (ActedSdl::now == nullptr) return sdls_own(SDL_HapticStopEffect, "SDL_HapticStopEffect")(haptic, id);
  ActedSdl::now->effects.at(id).running = false;
  return ActedSdl::done_or_refused();
}
void SDL_HapticDestroyEffect(SDL_Haptic* haptic, int id) {
  if (ActedSdl::now == nullptr)
    return sdls_own(SDL_HapticDestroyEffect, "SDL_HapticDestroyEffect")(haptic, id);
  ActedSdl::now->effects.erase(id);
}

}  // extern "C"

namespace nazori::devices::sdl {
namespace {

constexpr const char* kStick = "Nazori's virtual stick";
constexpr const char* kPad = "Nazori's virtual pad";

/// A virtual joystick or wheel, plugged in while it lives.
class VirtualStick {
 public:
  explicit VirtualStick(SDL_JoystickType type = SDL_JOYSTICK_TYPE_FLIGHT_STICK, int buttons = 2,
                        const char* name = kStick) {
    SDL_VirtualJoystickDesc desc{};
    desc.version = SDL_VIRTUAL_JOYSTICK_DESC_VERSION;
    desc.type = static_cast<Uint16>(type);
    desc.naxes = 2;
    desc.nbuttons = static_cast<Uint16>(buttons);
    desc.name = name;
    index_ = SDL_JoystickAttachVirtualEx(&desc);
    EXPECT_GE(index_, 0) << SDL_GetError();
    joystick_ = SDL_JoystickOpen(index_);
  }
  ~VirtualStick() {
    SDL_JoystickDetachVirtual(index_);
    SDL_JoystickClose(joystick_);
  }
  VirtualStick(const VirtualStick&) = delete;
  VirtualStick& operator=(const VirtualStick&) = delete;
  void button(int which, bool down) const { SDL_JoystickSetVirtualButton(joystick_, which, down ? 1 : 0); }

 private:
  int index_ = -1;
  SDL_Joystick* joystick_ = nullptr;
};

class SdlForcePort : public testing::Test {
 protected:
  SdlForcePort() {
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    EXPECT_EQ(SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER), 0) << SDL_GetError();
  }
  ~SdlForcePort() override {
    port.reset();
    SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
  }
  /// A device among whatever else may be plugged in.
  [[nodiscard]] Listed listed(const std::string& name = kStick) const {
    const auto all = port->list();
    EXPECT_TRUE(all);
    for (const Listed& device : *all)
      if (device.name == name) return device;
    ADD_FAILURE() << name << " is not in the list";
    return {};
  }
  [[nodiscard]] std::unique_ptr<Controller> opened() const {
    auto controller = port->open(listed(), WritingHand::right);
    EXPECT_TRUE(controller) << base::to_line(controller.error());
    return std::move(*controller);
  }
  /// What is said where, once the device is listed, something of it does not open.
  [[nodiscard]] std::string refusal(bool ActedSdl::*opens, const std::string& name = kStick) {
    const Listed device = listed(name);
    acted.*opens = false;
    const auto controller = port->open(device, WritingHand::right);
    acted.*opens = true;
    return controller ? "" : base::to_line(controller.error());
  }

  ActedSdl acted;
  std::shared_ptr<Port> port = system_port();
};

TEST_F(SdlForcePort, AForceStickIsListedWithWhatSdlSaysOfIt) {
  const VirtualStick stick;
  const Listed device = listed();
  EXPECT_EQ(device.guid.size(), 32U) << "sixteen bytes in hexadecimal";
  EXPECT_EQ(device.guid.find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_EQ(device.abilities.effects, acted.can);
  EXPECT_EQ(device.abilities.haptic_axes, 2);
  EXPECT_TRUE(device.abilities.force());
  EXPECT_FALSE(device.abilities.pad);
  EXPECT_EQ(acted.handles, 0) << "it was opened only briefly";
}

TEST_F(SdlForcePort, ADeviceIsAskedForItsAbilitiesOnceEachTimeItIsPluggedIn) {
  {
    const VirtualStick stick;
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(listed().abilities.force());
    EXPECT_EQ(acted.handles_made, 1);
  }
  const VirtualStick again;
  EXPECT_TRUE(listed().abilities.force());
  EXPECT_EQ(acted.handles_made, 2);
  EXPECT_EQ(acted.updates, 4) << "each list begins with what was plugged in since";
}

TEST_F(SdlForcePort, AStickWithoutForceFeedbackIsStillAStick) {
  const VirtualStick stick;
  const auto force = [&](auto change) {
    change();
    port = system_port();  // it knows no device yet
    const Abilities can = listed().abilities;
    acted.is_haptic = 1;
    acted.axes = 2;
    acted.haptics_open = acted.haptics_start = true;
    EXPECT_EQ(acted.handles, 0);
    EXPECT_GE(can.haptic_axes, 0);
    return can.force();
  };
  EXPECT_TRUE(force([] {}));
  EXPECT_FALSE(force([this] { acted.is_haptic = 0; }));
  EXPECT_FALSE(force([this] { acted.is_haptic = -1; })) << "SDL could not tell";
  EXPECT_FALSE(force([this] { acted.axes = 0; }));
  EXPECT_FALSE(force([this] { acted.axes = -1; }));
  EXPECT_FALSE(force([this] { acted.haptics_open = false; }));
  EXPECT_FALSE(force([this] { acted.haptics_start = false; })) << "SDL's force feedback does not run";
}

TEST_F(SdlForcePort, AForceStickIsOpenedAtFullStrengthWithoutItsOwnCentring) {
  const VirtualStick stick;
  for (const bool adjustable : {true, false}) {
    acted.can = SDL_HAPTIC_CONSTANT | (adjustable ? SDL_HAPTIC_GAIN | SDL_HAPTIC_AUTOCENTER : 0U);
    acted.gain = acted.centring = -1;
    const auto controller = opened();
    EXPECT_EQ(acted.gain, adjustable ? 100 : -1);
    EXPECT_EQ(acted.centring, adjustable ? 0 : -1);
    EXPECT_EQ(acted.handles, 1);
  }
  EXPECT_EQ(acted.handles, 0) << "it closes with the controller";
}

TEST_F(SdlForcePort, EffectsGoToSdlAndItsAnswersComeBack) {
  const VirtualStick stick;
  const auto controller = opened();
  SDL_HapticEffect push{};
  push.type = SDL_HAPTIC_CONSTANT;
  push.constant.level = 5;
  const int id = controller->new_effect(push);
  EXPECT_EQ(id, 3);
  EXPECT_EQ(acted.effects.at(id).what.constant.level, 5);
  push.constant.level = 7;
  EXPECT_TRUE(controller->update_effect(id, push));
  EXPECT_EQ(acted.effects.at(id).what.constant.level, 7);
  EXPECT_TRUE(controller->run_effect(id));
  EXPECT_TRUE(acted.effects.at(id).running);
  EXPECT_EQ(acted.effects.at(id).times, 1U);
  EXPECT_TRUE(controller->stop_effect(id));
  EXPECT_FALSE(acted.effects.at(id).running);

  acted.takes_effects = false;
  EXPECT_EQ(controller->new_effect(push), -1);
  EXPECT_FALSE(controller->update_effect(id, push));
  EXPECT_FALSE(controller->run_effect(id));
  EXPECT_FALSE(controller->stop_effect(id));
  controller->destroy_effect(id);
  EXPECT_TRUE(acted.effects.empty());
}

TEST_F(SdlForcePort, WithoutForceFeedbackEveryEffectIsRefused) {
  acted.is_haptic = 0;
  const VirtualStick stick;
  const auto controller = opened();
  SDL_HapticEffect push{};
  EXPECT_EQ(controller->new_effect(push), -1);
  EXPECT_FALSE(controller->update_effect(3, push));
  EXPECT_FALSE(controller->run_effect(3));
  EXPECT_FALSE(controller->stop_effect(3));
  controller->destroy_effect(3);
  EXPECT_EQ(acted.handles, 0);
}

TEST_F(SdlForcePort, WhatCannotBeOpenedIsSaidInOneLine) {
  const VirtualStick stick;
  EXPECT_NE(refusal(&ActedSdl::haptics_open).find("its force feedback cannot be opened"), std::string::npos);
  EXPECT_NE(refusal(&ActedSdl::joysticks_open).find("it cannot be opened:"), std::string::npos);
  EXPECT_NE(refusal(&ActedSdl::joysticks_open).find("plug it in again"), std::string::npos);
}

TEST_F(SdlForcePort, APadThatSdlDoesNotOpenAsOneIsRefused) {
  acted.is_haptic = 0;
  const standin::VirtualPad pad;
  EXPECT_TRUE(port->open(listed(kPad), WritingHand::right));
  EXPECT_NE(refusal(&ActedSdl::pads_open, kPad).find("it cannot be opened as a gamepad"), std::string::npos);
}

TEST_F(SdlForcePort, APadWithDirectedForcesIsReadAsAJoystick) {
  const standin::VirtualPad pad;
  EXPECT_EQ(refusal(&ActedSdl::pads_open, kPad), "");
}

TEST_F(SdlForcePort, AJoystickThatCannotBeOpenedIsListedWithoutAbilities) {
  const VirtualStick wheel(SDL_JOYSTICK_TYPE_WHEEL);
  acted.joysticks_open = false;
  const Abilities can = listed().abilities;
  EXPECT_FALSE(can.wheel);
  EXPECT_FALSE(can.force());
}

TEST_F(SdlForcePort, ThirtyButtonsAreReadAfterTheOneThatPresses) {
  const VirtualStick stick(SDL_JOYSTICK_TYPE_FLIGHT_STICK, 40);
  const auto controller = opened();
  for (const auto& [button, bit] : {std::pair{1, 1U}, {30, 1U << 29U}, {31, 0U}, {39, 0U}}) {
    stick.button(button, true);
    EXPECT_EQ(controller->read().buttons, bit) << button;
    stick.button(button, false);
  }
}

TEST_F(SdlForcePort, AStickWithoutANameIsAJoystick) {
  const VirtualStick stick(SDL_JOYSTICK_TYPE_FLIGHT_STICK, 2, "");
  EXPECT_GE(listed("Joystick").instance, 0);
}

TEST_F(SdlForcePort, SdlIsReadWithoutItsEventsAndAlsoInTheBackground) {
  SDL_JoystickEventState(SDL_ENABLE);
  SDL_GameControllerEventState(SDL_ENABLE);
  EXPECT_TRUE(port->list());
  EXPECT_EQ(SDL_JoystickEventState(SDL_QUERY), SDL_IGNORE);
  EXPECT_EQ(SDL_GameControllerEventState(SDL_QUERY), SDL_IGNORE);
  EXPECT_EQ(SDL_GetHintBoolean(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, SDL_FALSE), SDL_TRUE);
}

TEST(SdlSystem, IsStartedOnceAndEndsWithItsPort) {
  ActedSdl acted;
  {
    const auto port = system_port();
    EXPECT_EQ(SDL_WasInit(SDL_INIT_GAMECONTROLLER), 0U) << "nobody has asked for it";
    for (int i = 0; i < 2; ++i) EXPECT_TRUE(port->list());
    EXPECT_EQ(SDL_WasInit(SDL_INIT_GAMECONTROLLER), SDL_INIT_GAMECONTROLLER);
    EXPECT_EQ(acted.haptics_running, 1);
  }
  EXPECT_EQ(SDL_WasInit(SDL_INIT_GAMECONTROLLER), 0U);
  EXPECT_EQ(acted.haptics_running, 0);
}

TEST(SdlSystem, ForceFeedbackThatDidNotStartIsNotEnded) {
  ActedSdl acted;
  acted.haptics_start = false;
  EXPECT_TRUE(system_port()->list()) << "the sticks are still there";
  EXPECT_EQ(acted.haptics_running, 0);
  EXPECT_EQ(SDL_WasInit(SDL_INIT_GAMECONTROLLER), 0U);
}

TEST(SdlSystem, WhereSdlDoesNotStartListAndOpenSayWhy) {
  ActedSdl acted;
  acted.sdl_starts = false;
  const auto port = system_port();
  const auto listed = port->list();
  ASSERT_FALSE(listed);
  EXPECT_NE(base::to_line(listed.error()).find("no joysticks in this kernel"), std::string::npos);
  const auto controller = port->open({}, WritingHand::right);
  ASSERT_FALSE(controller);
  EXPECT_NE(base::to_line(controller.error()).find("SDL cannot be started"), std::string::npos);
  EXPECT_EQ(acted.haptics_running, 0);
  acted.sdl_starts = true;
  EXPECT_TRUE(port->list()) << "it is tried again";
}

}  // namespace
}  // namespace nazori::devices::sdl
