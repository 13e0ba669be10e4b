// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/pointer_device.h"

#include <chrono>
#include <optional>
#include <string>

#include "nazori/devices/back_end.h"
#include "pointer_playback.h"

namespace nazori::devices {

struct PointerDevice::Inside {
  PointerPlayback playback;
  std::optional<std::chrono::steady_clock::time_point> begun;  // interface: the first start
  RtThread clock;  // declared last, so that it stops before the other members are destroyed
};

PointerDevice::PointerDevice() : inside_(std::make_unique<Inside>()) {}
PointerDevice::~PointerDevice() { stop(); }

haptics::DeviceDescription PointerDevice::describe() const {
  return {std::string(back_end_names::kPointer), 1 / PointerPlayback::kPeriod_s, false, {}};
}

base::Result<void> PointerDevice::start(haptics::ServoCallback& servo) {
  Inside& in = *inside_;
  in.playback.restart();
  // After a pause the time of the samples continues, so that strokes before and after it keep their distance
  // in time.
  const auto now = std::chrono::steady_clock::now();
  if (!in.begun) in.begun = now;
  const double rested_s = std::chrono::duration<double>(now - *in.begun).count();
  return in.clock.start(PointerPlayback::kPeriod_s, [&in, &servo, rested_s](double now_s) {
    haptics::DeviceSample sample = in.playback.tick();
    sample.time_s = rested_s + now_s;
    (void)servo.tick(sample);
  });
}

void PointerDevice::stop() noexcept { inside_->clock.stop(); }

void PointerDevice::move(const PointerState& state) noexcept { inside_->playback.move(state); }

void PointerDevice::move(const PointerState& state, double event_s) noexcept {
  inside_->playback.move(state, event_s);
}

ClockStatus PointerDevice::clock() const { return inside_->clock.status(); }

}  // namespace nazori::devices
