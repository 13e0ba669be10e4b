// SPDX-License-Identifier: Apache-2.0
#include "sdl_feedback.h"

#include <SDL2/SDL_error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "nazori/haptics/servo.h"

namespace nazori::devices::sdl {

using haptics::ServoEvent;

namespace {

constexpr double kLeastTime_s = 1 / ForceEffects::kMost_hz;
constexpr double kLeastChange = 0.01;  // of the full force or travel
constexpr double kAnew_s = 0.4;        // well before an effect ends
constexpr Sint16 kFullLevel = 32767;
constexpr Uint16 kFullSaturation = 0xFFFF;
constexpr Sint16 kInkDrag = 0x1800;

Sint16 level(double part) {
  return static_cast<Sint16>(std::lround(std::clamp(part, -1.0, 1.0) * kFullLevel));
}

SDL_HapticEffect condition(Uint16 type, Sint16 coefficient) {
  SDL_HapticEffect e{};
  e.type = type;
  e.condition.length = ForceEffects::kLength_ms;
  for (int axis = 0; axis < 3; ++axis) {
    e.condition.right_sat[axis] = e.condition.left_sat[axis] = kFullSaturation;
    e.condition.right_coeff[axis] = e.condition.left_coeff[axis] = coefficient;
  }
  return e;
}

}  // namespace

base::Result<ForceEffects> ForceEffects::create(Controller& controller, const Abilities& abilities) {
  ForceEffects all(controller, abilities);
  if (!all.constant_ && !all.spring_)
    return base::fail(base::Errc::device, std::string("it does not accept force effects: ") + SDL_GetError(),
                      "force feedback", "close other programs that use it");
  return all;
}

ForceEffects::ForceEffects(Controller& controller, const Abilities& abilities)
    : controller_(&controller), planar_(abilities.force_axes() >= 2) {
  if ((abilities.effects & SDL_HAPTIC_CONSTANT) != 0) {
    SDL_HapticEffect e{};
    e.type = SDL_HAPTIC_CONSTANT;
    e.constant.length = kLength_ms;
    // SDL's directions say where the force comes from: from the left, so that a positive level pushes right.
    e.constant.direction.type = SDL_HAPTIC_CARTESIAN;
    e.constant.direction.dir[0] = -1;
    add(constant_, e);
  }
  if (!constant_ && (abilities.effects & SDL_HAPTIC_SPRING) != 0)
    add(spring_, condition(SDL_HAPTIC_SPRING, kFullLevel));
  if ((abilities.effects & SDL_HAPTIC_DAMPER) != 0) add(damper_, condition(SDL_HAPTIC_DAMPER, kInkDrag));
}

ForceEffects::ForceEffects(ForceEffects&& other) noexcept
    : controller_(std::exchange(other.controller_, nullptr)),
      planar_(other.planar_),
      constant_(other.constant_),
      spring_(other.spring_),
      damper_(other.damper_),
      told_x_(other.told_x_),
      told_y_(other.told_y_),
      refused_(other.refused_) {}

ForceEffects::~ForceEffects() {
  if (controller_ == nullptr) return;
  for (auto* effect : {&constant_, &spring_, &damper_}) {
    if (!*effect) continue;
    (void)stop(**effect);
    controller_->destroy_effect((*effect)->id);
  }
}

void ForceEffects::add(std::optional<Effect>& slot, const SDL_HapticEffect& what) {
  Effect effect;
  effect.what = what;
  effect.id = controller_->new_effect(effect.what);
  if (effect.id >= 0) slot = effect;
}

bool ForceEffects::stop(Effect& effect) {
  if (!effect.running) return true;
  // Stays marked on failure, so that the next call tries again.
  if (!controller_->stop_effect(effect.id)) return false;
  effect.running = false;
  return true;
}

bool ForceEffects::play(Effect& effect, bool changed, double now_s) {
  if (changed && !controller_->update_effect(effect.id, effect.what)) return false;
  if (effect.running && now_s - effect.run_s < kAnew_s) return true;
  if (!controller_->run_effect(effect.id)) return false;
  effect.running = true;
  effect.run_s = now_s;
  return true;
}

bool ForceEffects::apply(const Wish& wish, double now_s) {
  const bool pushed = push(wish, now_s);
  return damp(wish, now_s) && pushed;
}

bool ForceEffects::push(const Wish& wish, double now_s) {
  Effect& effect = constant_ ? *constant_ : *spring_;
  double x = wish.push_x, y = planar_ ? wish.push_y : 0;
  double size = std::hypot(x, y);
  if (!wish.on || !(size >= kLeastChange) || !std::isfinite(size)) return stop(effect);
  if (effect.told_s >= 0 && now_s - effect.told_s < kLeastTime_s) return !refused_;
  if (size > 1) {
    x /= size;
    y /= size;
    size = 1;
  }
  if (spring_) {
    x = std::clamp(wish.x + x, -1.0, 1.0);
    y = std::clamp(wish.y + y, -1.0, 1.0);
  }
  const bool changed =
      effect.told_s < 0 || std::hypot(x - told_x_, y - told_y_) >= kLeastChange || !effect.running;
  if (!changed) return play(effect, false, now_s);
  if (spring_) {
    effect.what.condition.center[0] = level(x);
    effect.what.condition.center[1] = level(-y);  // SDL's y is down
  } else if (planar_) {
    // The direction is the one the force comes from: from the left to push right; from the south, which is
    // SDL's +y, to push up.
    effect.what.constant.direction.dir[0] = -level(x);
    effect.what.constant.direction.dir[1] = level(y);
    effect.what.constant.level = level(size);
  } else {
    effect.what.constant.level = level(x);
  }
  effect.told_s = now_s;
  refused_ = !play(effect, true, now_s);
  if (refused_) return false;
  told_x_ = x;
  told_y_ = y;
  return true;
}

bool ForceEffects::damp(const Wish& wish, double now_s) {
  if (!damper_) return true;
  return wish.on && wish.pressed ? play(*damper_, false, now_s) : stop(*damper_);
}

void RumbleCues::apply(const Wish& wish, double now_s) {
  struct Cue {
    ServoEvent event;
    int rank;
    std::uint16_t low, high;
    double length_s;
  };
  // Motors of pads take some 30 ms to be felt.
  static constexpr std::array kCues{Cue{ServoEvent::capture, 1, 0, 0x6000, 0.06},
                                    Cue{ServoEvent::release, 1, 0, 0x4000, 0.06},
                                    Cue{ServoEvent::stroke_done, 2, 0, 0xA000, 0.18},
                                    Cue{ServoEvent::lesson_done, 3, 0x4000, 0xC000, 0.40},
                                    Cue{ServoEvent::wrong_start, 4, 0xC000, 0xC000, 0.25},
                                    Cue{ServoEvent::wrong_direction, 4, 0xC000, 0xC000, 0.25}};
  if (now_s >= cue_end_s_ || !wish.on) rank_ = 0;
  for (const Cue& cue : kCues) {
    if (!wish.on || !haptics::has(wish.events, cue.event) || cue.rank < rank_) continue;
    rank_ = cue.rank;
    cue_low_ = cue.low;
    cue_high_ = cue.high;
    cue_end_s_ = now_s + cue.length_s;
  }
  std::uint16_t low = 0, high = 0;
  if (wish.on) {
    const double push = std::hypot(wish.push_x, wish.push_y);
    // In sixteen steps: a pad does not resolve more, and each step is a message to it.
    constexpr double kSteps = 16, kHum = 0x6000;
    if (std::isfinite(push))
      low = static_cast<std::uint16_t>(std::floor(std::min(1.0, push) * kSteps) / kSteps * kHum);
    if (rank_ > 0) {
      low = std::max(low, cue_low_);
      high = cue_high_;
    }
  }
  const bool silent = low == 0 && high == 0;
  const bool changed = low != told_low_ || high != told_high_;
  if (!changed && (silent || now_s - told_s_ < kAnew_s)) return;
  if (!silent && told_s_ >= 0 && now_s - told_s_ < kLeastTime_s) return;
  if (!controller_->rumble(low, high, silent ? 0 : ForceEffects::kLength_ms)) return;
  told_low_ = low;
  told_high_ = high;
  told_s_ = now_s;
}

}  // namespace nazori::devices::sdl
