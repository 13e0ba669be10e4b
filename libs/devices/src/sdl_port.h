// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <SDL2/SDL_haptic.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/devices/workspace_mapping.h"

/// What Nazori uses of SDL's joysticks, gamepads and haptics, a thin layer that a test can replace, because
/// SDL has no virtual haptic device.
namespace nazori::devices::sdl {

/// The abilities of a joystick, wheel or pad.
struct Abilities {
  unsigned effects = 0;  ///< SDL_HAPTIC_CONSTANT, SDL_HAPTIC_SPRING ...
  int haptic_axes = 0;   ///< as SDL_HapticNumAxes; on Linux always 2
  bool rumble = false;
  bool pad = false;    ///< SDL knows its layout as a gamepad's
  bool wheel = false;  ///< by SDL_JoystickGetType

  /// Axes that a force can push along. A wheel has one motor, whatever SDL counts.
  [[nodiscard]] int force_axes() const noexcept { return wheel && haptic_axes > 1 ? 1 : haptic_axes; }
  /// Whether it has directed forces, not only rumble.
  [[nodiscard]] bool force() const noexcept {
    return (effects & (SDL_HAPTIC_CONSTANT | SDL_HAPTIC_SPRING)) != 0 && force_axes() > 0;
  }
};

struct Listed {
  std::int32_t instance = -1;  ///< new each time it is plugged in
  std::string guid;            ///< of the model
  std::string name;
  Abilities abilities;
};

struct Reading {
  bool attached = false;
  double x = 0, y = 0;  ///< -1..1, right and up
  double press = 0;     ///< 0..1
  std::uint32_t buttons = 0;
};

/// An open joystick, wheel or pad; closed when destroyed. Thread rules: one at a time.
class Controller {
 public:
  virtual ~Controller() = default;
  /// Processes what has happened since the last call.
  [[nodiscard]] virtual Reading read() = 0;
  /// As SDL_JoystickRumble.
  virtual bool rumble(std::uint16_t low, std::uint16_t high, std::uint32_t length_ms) = 0;
  /// As SDL_HapticNewEffect and its sisters; negative or false: refused.
  [[nodiscard]] virtual int new_effect(SDL_HapticEffect& effect) = 0;
  virtual bool update_effect(int id, SDL_HapticEffect& effect) = 0;
  virtual bool run_effect(int id) = 0;
  virtual bool stop_effect(int id) = 0;
  virtual void destroy_effect(int id) = 0;
};

/// All plugged-in controllers. Thread rules: one thread (the interface), in parallel with those of open
/// controllers.
class Port {
 public:
  virtual ~Port() = default;
  [[nodiscard]] virtual base::Result<std::vector<Listed>> list() = 0;
  /// @param hand  which stick of a pad. @return null, with SDL's message, where it cannot be opened.
  [[nodiscard]] virtual base::Result<std::unique_ptr<Controller>> open(const Listed& device,
                                                                       WritingHand hand) = 0;
};

/// SDL itself, started at the first call of list() or open().
[[nodiscard]] std::shared_ptr<Port> system_port();

}  // namespace nazori::devices::sdl
