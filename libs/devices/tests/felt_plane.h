// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <memory>
#include <thread>

#include "nazori/devices/back_end.h"
#include "nazori/haptics/servo.h"

namespace nazori::devices::test {

using haptics::DeviceSample;
using haptics::DeviceState;
using haptics::DeviceTrouble;
using haptics::Vec3;

/// A known plane: a spring of kStiffness_n_m on the tablet's plateau, nothing above it.
class FeltPlane final : public haptics::ServoCallback {
 public:
  static constexpr double kStiffness_n_m = 200;

  Vec3 tick(const DeviceSample& sample) noexcept override {
    ++ticks;
    if (!sample.present) {
      ++absent;
      return Vec3(0, 0, 1);  // a servo that keeps pushing: the device must stop it
    }
    ++present;
    x_m = sample.position_m.x;
    y_m = sample.position_m.y;
    z_m = sample.position_m.z;
    buttons = sample.buttons;
    return Vec3(0, 0, sample.position_m.z < 0 ? -kStiffness_n_m * sample.position_m.z : 0);
  }

  std::atomic<int> ticks{0}, present{0}, absent{0};
  std::atomic<double> x_m{0}, y_m{0}, z_m{0};
  std::atomic<std::uint32_t> buttons{0};
};

/// The real servo on a clock that never runs late, so that no test depends on how busy the machine is.
class UnhurriedServo final : public haptics::ServoCallback {
 public:
  UnhurriedServo(haptics::Servo& servo, double rate_hz) : servo_(servo), period_s_(1 / rate_hz) {}
  Vec3 tick(const DeviceSample& sample) noexcept override {
    DeviceSample timely = sample;
    timely.time_s = period_s_ * static_cast<double>(ticks_++);
    return servo_.tick(timely);
  }
  [[nodiscard]] std::uint16_t events() const noexcept override { return servo_.events(); }

 private:
  haptics::Servo& servo_;
  double period_s_;
  long ticks_ = 0;
};

/// Always gives the same force, wherever the stylus is.
class Push final : public haptics::ServoCallback {
 public:
  explicit Push(const Vec3& force_n) : force_n_(force_n) {}
  Vec3 tick(const DeviceSample&) noexcept override { return force_n_; }

 private:
  Vec3 force_n_;
};

/// Pushes, and blocks in a tick for as long as the test chooses.
class StuckPush final : public haptics::ServoCallback {
 public:
  explicit StuckPush(const Vec3& force_n) : force_n_(force_n) {}
  Vec3 tick(const DeviceSample&) noexcept override {
    stuck_.wait(true);
    return force_n_;
  }
  void stick() { stuck_ = true; }
  void go_on() {
    stuck_ = false;
    stuck_.notify_all();
  }

 private:
  Vec3 force_n_;
  std::atomic<bool> stuck_{false};
};

/// How long to wait for something that must come: a minute, or NAZORI_TEST_PATIENCE_S.
inline std::chrono::seconds patience() {
  const char* const given = std::getenv("NAZORI_TEST_PATIENCE_S");
  return std::chrono::seconds(given != nullptr ? std::max(1, std::atoi(given)) : 60);
}

/// Waits until `wish` is true; false if it does not become true.
inline bool comes_true(const std::function<bool()>& wish) {
  const auto end = std::chrono::steady_clock::now() + patience();
  while (!wish()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

/// Waits for a status with both and returns it. Check it as a whole: a machine that pauses for half a second
/// briefly shows another status.
inline haptics::DeviceStatus comes_to(const haptics::HapticDevice& device, DeviceState state,
                                      DeviceTrouble trouble) {
  haptics::DeviceStatus seen;
  (void)comes_true([&] {
    seen = device.status();
    return seen.state == state && seen.trouble == trouble;
  });
  return seen;
}

/// The status right after `tick`. If the machine paused for half a second in between, ticks again.
template <class Ticking>
haptics::DeviceStatus status_after(const Ticking& ticking, const std::function<void()>& tick) {
  haptics::DeviceStatus seen;
  (void)comes_true([&] {
    tick();
    seen = ticking.status();
    return seen.trouble != DeviceTrouble::stalled;
  });
  return seen;
}

/// A flat tablet for the real servo.
inline std::shared_ptr<const haptics::HapticScene> flat_tablet(double stiffness) {
  auto scene = std::make_shared<haptics::HapticScene>();
  scene->surface = *surface::SmoothSurface::create(*surface::HeightMap::create(32, 1.0F));
  scene->material.stiffness = stiffness;
  return scene;
}

}  // namespace nazori::devices::test
