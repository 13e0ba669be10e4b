// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/pointer_device.h"

#include <algorithm>
#include <atomic>
#include <boost/lockfree/spsc_queue.hpp>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>

#include "nazori/devices/back_end.h"
#include "nazori/haptics/latest_value.h"

namespace nazori::devices {
namespace {

constexpr double kPeriod_s = 0.001;
// Two low-pass filters in a row: no jump in speed, 98 % of a move after six times this.
constexpr double kHand_s = 0.002;

constexpr double kCatchUp_s = 0.008;  // states that are this late are played at twice the speed
constexpr double kRest_s = 0.010;     // states farther apart: the pointer rested, then moved
constexpr std::size_t kQueue = 4096;

using haptics::Vec3;

Vec3 tip(const PointerState& s) {
  return {s.x_m, s.y_m, s.pressed ? -std::fmax(0.0, s.depth_m) : PointerDevice::kHover_m};
}

bool usable(const PointerState& s) {
  return std::isfinite(s.x_m) && std::isfinite(s.y_m) && std::isfinite(s.depth_m);
}

/// A state at its time.
struct TimedState {
  PointerState state;
  double at_s = 0;
};

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

struct PointerDevice::Inside {
  void tick(double now_s, haptics::ServoCallback& servo) noexcept;
  PointerState play() noexcept;

  haptics::LatestValue<PointerState> newest{PointerState{0, 0, 0, false, false}};
  boost::lockfree::spsc_queue<TimedState, boost::lockfree::capacity<kQueue>> events;
  std::atomic<double> last_event_s{0};                       // of the newest in the queue
  std::atomic<bool> timed{false};                            // whether the newest state has a time
  double told_s = -std::numeric_limits<double>::infinity();  // interface: time of the last event
  // Clock thread.
  TimedState played{PointerState{0, 0, 0, false, false}, 0};
  double clock_s = 0;         // of the events
  double step_s = kPeriod_s;  // time of the events that passed in this tick
  Vec3 halfway{0, 0, kHover_m}, at{0, 0, kHover_m};
  bool present = false;
  std::optional<std::chrono::steady_clock::time_point> begun;  // interface: the first start
  RtThread clock;  // declared last, so that it stops before the other members are destroyed
};

PointerState PointerDevice::Inside::play() noexcept {
  step_s = kPeriod_s;
  if (!timed.load(std::memory_order_acquire)) {
    while (events.pop()) {
    }
    played = {newest.latest(), -std::numeric_limits<double>::infinity()};
    clock_s = played.at_s;
    return played.state;
  }
  if (events.read_available() == 0) return played.state;
  const double late_s = last_event_s.load(std::memory_order_acquire) - clock_s;
  // Pauses are skipped: the playback continues a little before the next event.
  const double next_s = events.front().at_s;
  const double begin_s = std::max(played.at_s, next_s - kRest_s);
  if (clock_s < begin_s)
    clock_s = begin_s;
  else
    clock_s += step_s = kPeriod_s * std::clamp(1 + late_s / kCatchUp_s, 1.0, kFastest);
  while (events.read_available() > 0 && events.front().at_s <= clock_s) {
    const bool was_pressed = played.state.pressed;
    played = events.front();
    events.pop();
    // Coming down and lifting are never skipped.
    if (played.state.pressed != was_pressed) clock_s = played.at_s;
  }
  if (events.read_available() == 0) return played.state;
  const TimedState& next = events.front();
  const double from_s = std::max(played.at_s, next.at_s - kRest_s);
  const double share =
      next.at_s > from_s ? std::clamp((clock_s - from_s) / (next.at_s - from_s), 0.0, 1.0) : 1;
  return between(played.state, next.state, share);
}

void PointerDevice::Inside::tick(double now_s, haptics::ServoCallback& servo) noexcept {
  const PointerState state = play();
  if (usable(state)) {
    const Vec3 target = tip(state);
    // A pointer that comes back into range appears there at once: it did not cross the tablet.
    if (state.in_range && !present) halfway = at = target;
    present = state.in_range;
    // Filtered in the time of the events, so that fast playback keeps the shape.
    const double pass = step_s / (step_s + kHand_s);
    halfway += (target - halfway) * pass;
    at += (halfway - at) * pass;
  }
  haptics::DeviceSample sample;
  sample.time_s = now_s;
  sample.position_m = at;
  sample.buttons = state.pressed ? 1U : 0U;
  sample.present = present;
  (void)servo.tick(sample);
}

PointerDevice::PointerDevice() : inside_(std::make_unique<Inside>()) {}
PointerDevice::~PointerDevice() { stop(); }

haptics::DeviceDescription PointerDevice::describe() const {
  return {std::string(back_end_names::kPointer), 1 / kPeriod_s, false, {}};
}

base::Result<void> PointerDevice::start(haptics::ServoCallback& servo) {
  Inside& in = *inside_;
  // Drop the queued states: only the newest one matters.
  in.timed = false;
  in.present = false;  // the tip moves to the pointer, too, because it may have stopped in mid-motion
  // After a pause the time of the samples continues, so that strokes before and after it keep their distance
  // in time.
  const auto now = std::chrono::steady_clock::now();
  if (!in.begun) in.begun = now;
  const double rested_s = std::chrono::duration<double>(now - *in.begun).count();
  return in.clock.start(kPeriod_s,
                        [&in, &servo, rested_s](double now_s) { in.tick(rested_s + now_s, servo); });
}

void PointerDevice::stop() noexcept { inside_->clock.stop(); }

void PointerDevice::move(const PointerState& state) noexcept {
  inside_->newest.back() = state;
  inside_->newest.publish();
  inside_->timed.store(false, std::memory_order_release);
  inside_->told_s = -std::numeric_limits<double>::infinity();
}

void PointerDevice::move(const PointerState& state, double event_s) noexcept {
  Inside& in = *inside_;
  if (!usable(state) || !std::isfinite(event_s)) return;
  const bool first = event_s < in.told_s || !in.timed.load(std::memory_order_relaxed);
  if (first || !in.events.push({state, event_s})) {
    // Without earlier states or a running playback it applies at once.
    move(state);
    in.events.push({state, event_s});
  }
  in.newest.back() = state;
  in.newest.publish();
  in.told_s = event_s;
  in.last_event_s.store(event_s, std::memory_order_release);
  in.timed.store(true, std::memory_order_release);
}

ClockStatus PointerDevice::clock() const { return inside_->clock.status(); }

}  // namespace nazori::devices
