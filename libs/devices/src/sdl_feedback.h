// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "sdl_port.h"

namespace nazori::devices::sdl {

/// The feedback that the hand should get now.
struct Wish {
  bool on = false;                ///< false: no feedback, from now on
  double x = 0, y = 0;            ///< position of the stick, -1..1, right and up
  double push_x = 0, push_y = 0;  ///< force as a part of the device's full force, right and up
  bool pressed = false;           ///< the tip is pressed down
  std::uint16_t events = 0;       ///< ServoEvent bits since the last one
};

/// Forces of a joystick or wheel: a constant force, or where it has none a spring whose middle is moved so
/// that it gives that force; and damping while the tip is pressed down. Sends only changes to the device, at
/// most kMost_hz times a second; the end of a force is sent at once. Effects end automatically after
/// kLength_ms and are restarted before that, so that a hanging program does not keep pushing.
class ForceEffects {
 public:
  static constexpr double kMost_hz = 100;
  static constexpr std::uint32_t kLength_ms = 1000;

  /// @return SDL's message where the device accepts no effect.
  [[nodiscard]] static base::Result<ForceEffects> create(Controller& controller, const Abilities& abilities);
  ForceEffects(ForceEffects&& other) noexcept;
  ForceEffects& operator=(ForceEffects&&) = delete;
  ~ForceEffects();

  /// @return false while the device refuses effects.
  bool apply(const Wish& wish, double now_s);

 private:
  struct Effect {
    int id = -1;
    SDL_HapticEffect what{};
    bool running = false;
    double run_s = 0, told_s = -1;
  };
  ForceEffects(Controller& controller, const Abilities& abilities);
  void add(std::optional<Effect>& slot, const SDL_HapticEffect& what);
  bool stop(Effect& effect);
  bool play(Effect& effect, bool changed, double now_s);
  bool push(const Wish& wish, double now_s);
  bool damp(const Wish& wish, double now_s);

  Controller* controller_;
  bool planar_;  // force along two axes
  std::optional<Effect> constant_, spring_, damper_;
  double told_x_ = 0, told_y_ = 0;
  bool refused_ = false;
};

/// Rumble of a pad: a hum while a wall pushes, a tap where a stroke captures or releases the stylus, a long
/// high one when a stroke is done, both motors for a mistake. The timing is that of ForceEffects.
class RumbleCues {
 public:
  explicit RumbleCues(Controller& controller) : controller_(&controller) {}
  /// A pad that refuses to rumble can still be written with.
  void apply(const Wish& wish, double now_s);

 private:
  Controller* controller_;
  int rank_ = 0;
  std::uint16_t cue_low_ = 0, cue_high_ = 0, told_low_ = 0, told_high_ = 0;
  double cue_end_s_ = 0, told_s_ = -1;
};

}  // namespace nazori::devices::sdl
