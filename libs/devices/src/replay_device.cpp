// SPDX-License-Identifier: Apache-2.0
#include "nazori/devices/replay_device.h"

#include <atomic>
#include <utility>

namespace nazori::devices {

using haptics::Vec3;

struct ReplayDevice::Inside {
  Vec3 step(haptics::ServoCallback& servo) noexcept {
    const std::size_t i = next.load(std::memory_order_relaxed);
    if (i >= samples.size()) return Vec3(0);
    const Vec3 force = servo.tick(samples[i]);
    next.store(i + 1, std::memory_order_release);
    return force;
  }
  /// In real time the ticks continue after the end, without the stylus.
  void play(haptics::ServoCallback& servo) noexcept {
    if (next.load(std::memory_order_relaxed) < samples.size()) {
      (void)step(servo);
      return;
    }
    haptics::DeviceSample gone = samples.empty() ? haptics::DeviceSample{} : samples.back();
    gone.present = false;
    gone.time_s += static_cast<double>(++after_end) / description.rate_hz;
    (void)servo.tick(gone);
  }

  const std::vector<haptics::DeviceSample> samples;
  const haptics::DeviceDescription description;
  std::atomic<std::size_t> next{0};
  std::uint64_t after_end = 0;
  RtThread clock;  // declared last, so that it stops before the other members are destroyed
};

ReplayDevice::ReplayDevice(std::vector<haptics::DeviceSample> samples, haptics::DeviceDescription description)
    : inside_(new Inside{std::move(samples), std::move(description), {}, 0, {}}) {}
ReplayDevice::~ReplayDevice() { stop(); }

haptics::DeviceDescription ReplayDevice::describe() const { return inside_->description; }

base::Result<void> ReplayDevice::start(haptics::ServoCallback& servo) {
  Inside& in = *inside_;
  return in.clock.start(1 / in.description.rate_hz, [&in, &servo](double) { in.play(servo); });
}

void ReplayDevice::stop() noexcept { inside_->clock.stop(); }
ClockStatus ReplayDevice::clock() const { return inside_->clock.status(); }
Vec3 ReplayDevice::step(haptics::ServoCallback& servo) noexcept { return inside_->step(servo); }

void ReplayDevice::rewind() noexcept {
  inside_->next = 0;
  inside_->after_end = 0;
}

bool ReplayDevice::finished() const noexcept {
  return inside_->next.load(std::memory_order_acquire) >= inside_->samples.size();
}

}  // namespace nazori::devices
