// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/pointer_device.h"

#include <cmath>

#include "nazori/haptics/latest_value.h"

namespace nazori::devices {
namespace {

constexpr double kPeriod_s = 0.001;
// Two low-pass filters in a row: no jump in speed, 98 % of a move after six times this.
constexpr double kHand_s = 0.002;

using haptics::Vec3;

Vec3 tip(const PointerState& s) {
  return {s.x_m, s.y_m, s.pressed ? -std::fmax(0.0, s.depth_m) : PointerDevice::kHover_m};
}

bool usable(const PointerState& s) {
  return std::isfinite(s.x_m) && std::isfinite(s.y_m) && std::isfinite(s.depth_m);
}

}  // namespace

struct PointerDevice::Inside {
  void tick(double now_s, haptics::ServoCallback& servo) noexcept;

  haptics::LatestValue<PointerState> newest{PointerState{0, 0, 0, false, false}};
  // Clock thread.
  Vec3 halfway{0, 0, kHover_m}, at{0, 0, kHover_m};
  bool present = false;
  RtThread clock;  // last: it stops before the rest goes
};

void PointerDevice::Inside::tick(double now_s, haptics::ServoCallback& servo) noexcept {
  const PointerState& state = newest.latest();
  if (usable(state)) {
    const Vec3 target = tip(state);
    // A pointer that comes back into range is there at once: it did not cross the tablet.
    if (state.in_range && !present) halfway = at = target;
    present = state.in_range;
    constexpr double kPass = kPeriod_s / (kPeriod_s + kHand_s);
    halfway += (target - halfway) * kPass;
    at += (halfway - at) * kPass;
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
  return {"Mouse or pen", 1 / kPeriod_s, false, {}};
}

base::Result<void> PointerDevice::start(haptics::ServoCallback& servo) {
  Inside& in = *inside_;
  return in.clock.start(kPeriod_s, [&in, &servo](double now_s) { in.tick(now_s, servo); });
}

void PointerDevice::stop() noexcept { inside_->clock.stop(); }

void PointerDevice::move(const PointerState& state) noexcept {
  inside_->newest.back() = state;
  inside_->newest.publish();
}

ClockStatus PointerDevice::clock() const { return inside_->clock.status(); }

}  // namespace nazori::devices
