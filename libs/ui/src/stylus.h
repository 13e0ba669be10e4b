// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>

#include "nazori/base/result.h"
#include "nazori/devices/pointer_device.h"
#include "nazori/haptics/servo.h"

namespace nazori::ui {

/// The mouse or pen as a haptic device with its servo running: pointer states go in, poses and scenes through
/// the same servo that devices with force use. Thread: interface.
class Stylus {
 public:
  Stylus() : servo_(device_.describe()) {}
  ~Stylus() { device_.stop(); }
  Stylus(const Stylus&) = delete;
  Stylus& operator=(const Stylus&) = delete;

  [[nodiscard]] base::Result<void> start() { return device_.start(servo_); }
  void move(const devices::PointerState& state) { device_.move(state); }
  void set_scene(std::shared_ptr<const haptics::HapticScene> scene) { servo_.set_scene(std::move(scene)); }
  [[nodiscard]] const haptics::ServoSample& latest() { return servo_.latest(); }
  std::size_t take_samples(std::span<haptics::ServoSample> out) { return servo_.take_samples(out); }
  [[nodiscard]] haptics::ServoTiming timing() const { return servo_.timing(); }
  [[nodiscard]] haptics::DeviceDescription describe() const { return device_.describe(); }

 private:
  devices::PointerDevice device_;
  haptics::Servo servo_;
};

}  // namespace nazori::ui
