// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>

#include "link_exchange.h"
#include "nazori/devices/rt_thread.h"
#include "nazori/haptics/haptic_device.h"
#include "servo_link.h"

namespace nazori::devices {

/// A device whose servo runs on a clock thread of this program, while a link with a thread of its own
/// communicates with the device.
/// @tparam Servo  `start()` before the first tick; `tick()`, real-time-safe.
/// @tparam Link  `start()`, `stop()` (its last command is zero force) and `is_running()`. `kWriteZero`
///   switches the force off without the link's thread; null where the device does that when the connection
///   ends.
template <class Servo, class Link>
class LinkedDevice final : public haptics::HapticDevice {
 public:
  /// @param limits  at the stylus; their delay is the planned one.
  /// @param make_servo  (ServoLink&) -> Servo.  @param make_link  (ServoLink&, Servo&) -> Link.
  template <class MakeServo, class MakeLink>
  LinkedDevice(const std::string& name, const haptics::DeviceLimits& limits, const WorkspaceMapping& mapping,
               const MakeServo& make_servo, const MakeLink& make_link)
      : name_(name),
        limits_(limits),
        feeling_(name, mapping, limits),
        servo_(make_servo(feeling_)),
        link_(make_link(feeling_, servo_)) {}
  LinkedDevice(const LinkedDevice&) = delete;
  LinkedDevice& operator=(const LinkedDevice&) = delete;
  ~LinkedDevice() override { stop(); }

  [[nodiscard]] haptics::DeviceDescription describe() const override {
    return {name_, 1 / kLinkPeriod_s, true, feeling_.mapping().to_tablet(limits_)};
  }

  [[nodiscard]] base::Result<void> start(haptics::ServoCallback& servo) override {
    if (link_.is_running()) return base::fail(base::Errc::device, "the device is already running", name_);
    feeling_.start(servo, Link::kWriteZero, &link_);
    servo_.start();
    auto started = link_.start();
    if (started) started = clock_.start(kLinkPeriod_s, [this](double) { servo_.tick(); });
    if (!started) {
      link_.stop();
      feeling_.stop();
    }
    return started;
  }

  void stop() noexcept override {
    if (!link_.is_running()) return;
    clock_.stop();
    link_.stop();
    feeling_.stop();
  }

  [[nodiscard]] haptics::DeviceStatus status() const override { return feeling_.status(); }

 private:
  const std::string name_;
  const haptics::DeviceLimits limits_;
  ServoLink feeling_;
  Servo servo_;
  Link link_;
  RtThread clock_;  // declared last, so that it stops before the other members are destroyed
};

}  // namespace nazori::devices
