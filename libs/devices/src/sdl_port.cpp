// SPDX-License-Identifier: Apache-2.0
#include "sdl_port.h"

#include <SDL2/SDL.h>
#include <SDL2/SDL_thread.h>

#include <algorithm>
#include <array>
#include <map>
#include <mutex>
#include <utility>

#include "nazori/base/sdl_lock.h"

namespace nazori::devices::sdl {
namespace {

constexpr int kMostButtons = 31;

template <class Handle, void (*close)(Handle*)>
struct Closer {
  void operator()(Handle* handle) const { close(handle); }
};
using Joystick = std::unique_ptr<SDL_Joystick, Closer<SDL_Joystick, SDL_JoystickClose>>;
using Pad = std::unique_ptr<SDL_GameController, Closer<SDL_GameController, SDL_GameControllerClose>>;
using Haptic = std::unique_ptr<SDL_Haptic, Closer<SDL_Haptic, SDL_HapticClose>>;

tl::unexpected<base::Error> refused(std::string what) {
  return base::fail(base::Errc::device, std::move(what) + ": " + SDL_GetError(), "joysticks and gamepads",
                    "unplug it and plug it in again");
}

/// Frees SDL's data of a thread that SDL did not start (the text of its last error).
struct Visit {
  Visit() = default;
  ~Visit() { SDL_TLSCleanup(); }
  Visit(const Visit&) = delete;
  Visit& operator=(const Visit&) = delete;
};

/// SDL's joystick and haptic systems, running while this lives. SDL's haptics have no lock of their own,
/// hence this.
struct System {
  ~System() {
    const std::lock_guard one(base::sdl_lock());
    if (haptics) SDL_QuitSubSystem(SDL_INIT_HAPTIC);
    if (begun) SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
  }
  base::Result<void> begin() {
    if (begun) return {};
    const std::lock_guard one(base::sdl_lock());
    // Without this hint SDL would handle Ctrl+C in place of the terminal.
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
    if (SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) != 0) return refused("SDL cannot be started");
    begun = true;
    // A kernel without force feedback still has sticks.
    haptics = SDL_InitSubSystem(SDL_INIT_HAPTIC) == 0;
    // The state is read instead of events, because nothing would remove them from the queue.
    SDL_JoystickEventState(SDL_IGNORE);
    SDL_GameControllerEventState(SDL_IGNORE);
    return {};
  }

  std::mutex lock;
  bool begun = false, haptics = false;
};

// An axis reaches from -32768 to 32767.
double unit(Sint16 axis) { return std::max(axis / 32767.0, -1.0); }

class SystemController final : public Controller {
 public:
  SystemController(std::shared_ptr<System> system, Joystick joystick, Pad pad, Haptic haptic,
                   WritingHand hand)
      : system_(std::move(system)),
        joystick_(std::move(joystick)),
        pad_(std::move(pad)),
        haptic_(std::move(haptic)),
        hand_(hand) {}
  ~SystemController() override {
    const Visit visit;
    const std::lock_guard one(system_->lock);
    haptic_.reset();
    pad_.reset();
    joystick_.reset();
  }

  [[nodiscard]] Reading read() override {
    const std::lock_guard one(system_->lock);
    SDL_JoystickUpdate();
    Reading r;
    r.attached = SDL_JoystickGetAttached(joystick_.get()) == SDL_TRUE;
    if (!r.attached) return r;
    if (pad_)
      read_pad(r);
    else
      read_stick(r);
    return r;
  }
  bool rumble(std::uint16_t low, std::uint16_t high, std::uint32_t length_ms) override {
    const std::lock_guard one(system_->lock);
    return SDL_JoystickRumble(joystick_.get(), low, high, length_ms) == 0;
  }
  [[nodiscard]] int new_effect(SDL_HapticEffect& effect) override {
    const std::lock_guard one(system_->lock);
    return haptic_ ? SDL_HapticNewEffect(haptic_.get(), &effect) : -1;
  }
  bool update_effect(int id, SDL_HapticEffect& effect) override {
    const std::lock_guard one(system_->lock);
    return haptic_ && SDL_HapticUpdateEffect(haptic_.get(), id, &effect) == 0;
  }
  bool run_effect(int id) override {
    const std::lock_guard one(system_->lock);
    return haptic_ && SDL_HapticRunEffect(haptic_.get(), id, 1) == 0;
  }
  bool stop_effect(int id) override {
    const std::lock_guard one(system_->lock);
    return haptic_ && SDL_HapticStopEffect(haptic_.get(), id) == 0;
  }
  void destroy_effect(int id) override {
    const std::lock_guard one(system_->lock);
    if (haptic_) SDL_HapticDestroyEffect(haptic_.get(), id);
  }

 private:
  void read_pad(Reading& r) const {
    const bool right = hand_ == WritingHand::right;
    const auto axis = [&](SDL_GameControllerAxis a) {
      return unit(SDL_GameControllerGetAxis(pad_.get(), a));
    };
    const auto down = [&](SDL_GameControllerButton b) {
      return SDL_GameControllerGetButton(pad_.get(), b) != 0;
    };
    r.x = axis(right ? SDL_CONTROLLER_AXIS_RIGHTX : SDL_CONTROLLER_AXIS_LEFTX);
    r.y = -axis(right ? SDL_CONTROLLER_AXIS_RIGHTY : SDL_CONTROLLER_AXIS_LEFTY);
    r.press = std::max(0.0, axis(right ? SDL_CONTROLLER_AXIS_TRIGGERRIGHT : SDL_CONTROLLER_AXIS_TRIGGERLEFT));
    if (down(right ? SDL_CONTROLLER_BUTTON_RIGHTSHOULDER : SDL_CONTROLLER_BUTTON_LEFTSHOULDER)) r.press = 1;
    constexpr std::array kButtons{SDL_CONTROLLER_BUTTON_A, SDL_CONTROLLER_BUTTON_B, SDL_CONTROLLER_BUTTON_X,
                                  SDL_CONTROLLER_BUTTON_Y};
    for (std::size_t i = 0; i < kButtons.size(); ++i) {
      if (down(kButtons[i])) r.buttons |= 1U << i;
    }
  }
  void read_stick(Reading& r) const {
    r.x = unit(SDL_JoystickGetAxis(joystick_.get(), 0));
    r.y = -unit(SDL_JoystickGetAxis(joystick_.get(), 1));
    // The first button, a joystick's trigger, presses; the others are numbered after it.
    r.press = SDL_JoystickGetButton(joystick_.get(), 0) != 0 ? 1 : 0;
    const int buttons = std::min(SDL_JoystickNumButtons(joystick_.get()), kMostButtons);
    for (int i = 1; i < buttons; ++i) {
      if (SDL_JoystickGetButton(joystick_.get(), i) != 0) r.buttons |= 1U << (i - 1);
    }
  }

  std::shared_ptr<System> system_;
  Joystick joystick_;
  Pad pad_;
  Haptic haptic_;
  WritingHand hand_;
};

/// SDL's list of joysticks does not change while this lives.
struct ListHeld {
  ListHeld() { SDL_LockJoysticks(); }
  ~ListHeld() { SDL_UnlockJoysticks(); }
  ListHeld(const ListHeld&) = delete;
  ListHeld& operator=(const ListHeld&) = delete;
};

class SystemPort final : public Port {
 public:
  [[nodiscard]] base::Result<std::vector<Listed>> list() override {
    const Visit visit;
    const std::lock_guard one(system_->lock);
    if (auto begun = system_->begin(); !begun) return tl::unexpected(begun.error());
    SDL_JoystickUpdate();
    const ListHeld held;
    std::vector<Listed> all;
    std::map<SDL_JoystickID, Abilities> still;
    for (int i = 0; i < SDL_NumJoysticks(); ++i) {
      Listed device;
      device.instance = SDL_JoystickGetDeviceInstanceID(i);
      std::array<char, 33> guid{};
      SDL_JoystickGetGUIDString(SDL_JoystickGetDeviceGUID(i), guid.data(), static_cast<int>(guid.size()));
      device.guid = guid.data();
      const char* name = SDL_JoystickNameForIndex(i);
      device.name = name != nullptr && *name != '\0' ? name : "Joystick";
      const auto known = known_.find(device.instance);
      device.abilities = known != known_.end() ? known->second : abilities_of(i);
      still[device.instance] = device.abilities;
      all.push_back(std::move(device));
    }
    known_ = std::move(still);
    return all;
  }

  [[nodiscard]] base::Result<std::unique_ptr<Controller>> open(const Listed& device,
                                                               WritingHand hand) override {
    const Visit visit;
    const std::lock_guard one(system_->lock);
    if (auto begun = system_->begin(); !begun) return tl::unexpected(begun.error());
    const ListHeld held;
    for (int i = 0; i < SDL_NumJoysticks(); ++i) {
      if (SDL_JoystickGetDeviceInstanceID(i) != device.instance) continue;
      Joystick joystick(SDL_JoystickOpen(i));
      if (!joystick) return refused("it cannot be opened");
      Pad pad;
      Haptic haptic;
      if (device.abilities.force()) {
        haptic.reset(SDL_HapticOpenFromJoystick(joystick.get()));
        if (!haptic) return refused("its force feedback cannot be opened");
        const unsigned can = SDL_HapticQuery(haptic.get());
        if ((can & SDL_HAPTIC_GAIN) != 0) SDL_HapticSetGain(haptic.get(), 100);
        if ((can & SDL_HAPTIC_AUTOCENTER) != 0) SDL_HapticSetAutocenter(haptic.get(), 0);
      } else if (device.abilities.pad) {
        pad.reset(SDL_GameControllerOpen(i));
        if (!pad) return refused("it cannot be opened as a gamepad");
      }
      return std::make_unique<SystemController>(system_, std::move(joystick), std::move(pad),
                                                std::move(haptic), hand);
    }
    return base::fail(base::Errc::device, "it is no longer connected", device.name, "plug it in again");
  }

 private:
  /// Opens the device briefly; done once each time it is plugged in.
  [[nodiscard]] Abilities abilities_of(int index) const {
    Abilities a;
    a.pad = SDL_IsGameController(index) == SDL_TRUE;
    const Joystick joystick(SDL_JoystickOpen(index));
    if (!joystick) return a;
    a.wheel = SDL_JoystickGetType(joystick.get()) == SDL_JOYSTICK_TYPE_WHEEL;
    a.rumble = SDL_JoystickHasRumble(joystick.get()) == SDL_TRUE;
    if (!system_->haptics || SDL_JoystickIsHaptic(joystick.get()) != 1) return a;
    const Haptic haptic(SDL_HapticOpenFromJoystick(joystick.get()));
    if (!haptic) return a;
    a.effects = SDL_HapticQuery(haptic.get());
    a.haptic_axes = std::max(0, SDL_HapticNumAxes(haptic.get()));
    return a;
  }

  std::shared_ptr<System> system_ = std::make_shared<System>();
  std::map<SDL_JoystickID, Abilities> known_;
};

}  // namespace

std::shared_ptr<Port> system_port() { return std::make_shared<SystemPort>(); }

}  // namespace nazori::devices::sdl
