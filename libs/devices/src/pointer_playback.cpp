// SPDX-License-Identifier: Apache-2.0
#include "pointer_playback.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nazori::devices {
namespace {

// Two low-pass filters in a row: no jump in speed, 98 % of a move after six times this.
constexpr double kHand_s = 0.002;

constexpr double kCatchUp_s = 0.008;  // states that are this late are played at twice the speed
constexpr double kRest_s = 0.010;     // states farther apart: the pointer rested, then moved

using haptics::Vec3;

Vec3 tip(const PointerState& s) {
  return {s.x_m, s.y_m, s.pressed ? -std::fmax(0.0, s.depth_m) : PointerDevice::kHover_m};
}

bool usable(const PointerState& s) {
  return std::isfinite(s.x_m) && std::isfinite(s.y_m) && std::isfinite(s.depth_m);
}

/// Interpolates between two states; values that are not positions are those of the first.
PointerState between(const PointerState& from, const PointerState& to, double share) {
  if (from.pressed != to.pressed || from.in_range != to.in_range) return from;
  PointerState state = from;
  state.x_m += (to.x_m - from.x_m) * share;
  state.y_m += (to.y_m - from.y_m) * share;
  state.depth_m += (to.depth_m - from.depth_m) * share;
  return state;
}

}  // namespace

PointerPlayback::TimedState PointerPlayback::taken() noexcept {
  const TimedState next = events_.front();
  events_.pop();
  if (next.is_restart) restarts_.fetch_sub(1, std::memory_order_relaxed);
  return next;
}

PointerState PointerPlayback::play() noexcept {
  step_s_ = kPeriod_s;
  const bool timed = timed_.load(std::memory_order_acquire);
  if (!timed || is_full_.exchange(false, std::memory_order_acquire)) {
    while (events_.read_available() > 0) (void)taken();
    clock_s_ =
        timed ? last_event_s_.load(std::memory_order_relaxed) : -std::numeric_limits<double>::infinity();
    played_ = {newest_.latest(), clock_s_};
    return played_.state;
  }
  // States before the last restart are not played.
  while (restarts_.load(std::memory_order_acquire) > 0 && events_.read_available() > 0 &&
         !events_.front().is_restart)
    (void)taken();
  if (events_.read_available() == 0) return played_.state;
  const double late_s = last_event_s_.load(std::memory_order_acquire) - clock_s_;
  // Pauses are skipped: the playback continues a little before the next event.
  const double next_s = events_.front().at_s;
  const double begin_s = std::max(played_.at_s, next_s - kRest_s);
  if (clock_s_ < begin_s)
    clock_s_ = begin_s;
  else
    clock_s_ += step_s_ = kPeriod_s * std::clamp(1 + late_s / kCatchUp_s, 1.0, PointerDevice::kFastest);
  while (events_.read_available() > 0 && (events_.front().is_restart || events_.front().at_s <= clock_s_)) {
    const bool was_pressed = played_.state.pressed;
    played_ = taken();
    // Coming down and lifting are never skipped.
    if (played_.is_restart || played_.state.pressed != was_pressed) clock_s_ = played_.at_s;
  }
  if (events_.read_available() == 0) return played_.state;
  const TimedState& next = events_.front();
  const double from_s = std::max(played_.at_s, next.at_s - kRest_s);
  const double share =
      next.at_s > from_s ? std::clamp((clock_s_ - from_s) / (next.at_s - from_s), 0.0, 1.0) : 1;
  return between(played_.state, next.state, share);
}

haptics::DeviceSample PointerPlayback::tick() noexcept {
  const PointerState state = play();
  if (usable(state)) {
    const Vec3 target = tip(state);
    // A pointer that comes back into range appears there at once: it did not cross the tablet.
    if (state.in_range && !present_) halfway_ = at_ = target;
    present_ = state.in_range;
    // Filtered in the time of the events, so that fast playback keeps the shape.
    const double pass = step_s_ / (step_s_ + kHand_s);
    halfway_ += (target - halfway_) * pass;
    at_ += (halfway_ - at_) * pass;
  }
  haptics::DeviceSample sample;
  sample.position_m = at_;
  sample.buttons = state.pressed ? 1U : 0U;
  sample.present = present_;
  return sample;
}

void PointerPlayback::restart() noexcept {
  timed_ = false;
  present_ = false;  // the tip moves to the pointer, too, because it may have stopped in mid-motion
}

void PointerPlayback::move(const PointerState& state) noexcept {
  newest_.back() = state;
  newest_.publish();
  timed_.store(false, std::memory_order_release);
  told_s_ = -std::numeric_limits<double>::infinity();
}

void PointerPlayback::move(const PointerState& state, double event_s) noexcept {
  if (!usable(state) || !std::isfinite(event_s)) return;
  const bool is_restart = event_s < told_s_ || !timed_.load(std::memory_order_relaxed);
  told_s_ = event_s;
  newest_.back() = state;
  newest_.publish();
  last_event_s_.store(event_s, std::memory_order_release);
  // Without room for it the newest state applies at once, and what is queued goes.
  if (!events_.push({state, event_s, is_restart}))
    is_full_.store(true, std::memory_order_release);
  else if (is_restart)
    restarts_.fetch_add(1, std::memory_order_release);
  timed_.store(true, std::memory_order_release);
}

}  // namespace nazori::devices
