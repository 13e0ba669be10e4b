// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <string>

#include "force_guard.h"
#include "nazori/devices/workspace_mapping.h"
#include "nazori/haptics/haptic_device.h"
#include "nazori/haptics/latest_value.h"

namespace nazori::devices {

/// A measured delay [s], smoothed over some twenty measurements.
/// @param before_s  the value so far; 0: this is the first.
[[nodiscard]] constexpr double smoothed_delay_s(double before_s, double measured_s) noexcept {
  constexpr double kFilter = 0.05;
  return before_s > 0 ? before_s + (measured_s - before_s) * kFilter : measured_s;
}

/// The share of the stiffness for a shorter delay that remains at the loop's actual delay: b > K (T / 2 +
/// delay).
/// @param planned_delay_s  for which the limits of the device were computed.
[[nodiscard]] constexpr double softened(double period_s, double planned_delay_s, double delay_s) noexcept {
  const double share = (period_s / 2 + planned_delay_s) / (period_s / 2 + delay_s);
  return share < 1 ? share : 1;
}

/// What every back end does around the servo's tick: converts the pose to the tablet frame and the force
/// back, blocks forces that are not finite or over the device's peak, gives no force while the device is
/// paused or lost or all forces are cut (ForceGuard), and reports the status to the interface. The functions
/// of the servo thread do not allocate, lock, log, throw or wait.
class ServoLink {
 public:
  /// @param name  of the device, for messages.  @param limits  at the stylus.
  ServoLink(std::string name, const WorkspaceMapping& mapping, const haptics::DeviceLimits& limits)
      : name_(std::move(name)), mapping_(mapping), limits_(limits) {}

  /// Before the first tick. Thread: interface, while nothing ticks.
  /// @param off  switches the device's force off, on the servo thread; may be null. @param device  its
  /// argument.
  void start(haptics::ServoCallback& servo, ForceGuard::Off off = nullptr, void* device = nullptr) noexcept;
  /// After the last tick and the last zero force. Thread: interface, while nothing ticks.
  void stop() noexcept;

  /// A tick with the stylus in a hand. Thread: servo.
  /// @param device_m  device frame. Not finite: as if absent.
  /// @return force in the device frame [N].
  haptics::Vec3 feel(const haptics::Vec3& device_m, std::uint32_t buttons) noexcept;

  /// A tick without a stylus: the servo releases it, the force is zero. Thread: servo.
  /// @param code  the maker's code, for the message; 0 none.
  void pause(haptics::DeviceState state, haptics::DeviceTrouble trouble, std::int32_t code,
             std::uint32_t buttons) noexcept;

  /// The device was set to zero force while forces are suspended. Thread: servo.
  void confirm_zero() noexcept { guard_.confirm_zero(); }
  /// The device was set to zero force, its output is off, and no force follows. Thread: servo.
  void confirm_off() noexcept { guard_.confirm_off(); }
  /// For a device without a switch for its output: it was set to zero force while forces were not allowed.
  /// Thread: the one that communicates with the device.
  void confirm_no_force() noexcept {
    if (ForceGuard::forces() == Forces::cut)
      guard_.confirm_off();
    else
      guard_.confirm_zero();
  }

  /// While this lives, a crash of this thread calls `off` of start() on it, as a crash of the servo thread
  /// does: for a thread that communicates with the device in place of the servo. Thread: that one, between
  /// start and stop.
  [[nodiscard]] ForceGuard::OwnCode own_code() const noexcept { return ForceGuard::OwnCode(guard_); }

  /// From pose to force, as measured. Thread: servo.
  void set_delay_s(double delay_s) noexcept { delay_s_ = delay_s; }
  /// The same for one tick; smoothed. Thread: servo.
  void note_delay_s(double delay_s) noexcept { delay_s_ = smoothed_delay_s(delay_s_, delay_s); }

  /// Thread: interface. Reports DeviceTrouble::stalled where no tick has come for half a second.
  [[nodiscard]] haptics::DeviceStatus status() const;

  [[nodiscard]] const WorkspaceMapping& mapping() const noexcept { return mapping_; }

 private:
  using Clock = std::chrono::steady_clock;
  struct Stand {
    haptics::DeviceState state = haptics::DeviceState::stopped;
    haptics::DeviceTrouble trouble = haptics::DeviceTrouble::none;
    std::int32_t code = 0;
    std::uint32_t buttons = 0;
    double rate_hz = 0;
    double delay_s = 0;
    Clock::time_point at;
  };
  haptics::DeviceSample sample(std::uint32_t buttons) noexcept;
  void publish(Stand stand) noexcept;
  haptics::Vec3 ask(const haptics::DeviceSample& sample) noexcept;

  std::string name_;
  WorkspaceMapping mapping_;
  haptics::DeviceLimits limits_;
  mutable haptics::LatestValue<Stand> stand_{Stand{}};
  // Servo thread, and the interface's while nothing ticks.
  haptics::ServoCallback* servo_ = nullptr;
  Clock::time_point begin_, now_, last_;
  haptics::Vec3 last_tablet_m_{0, 0, 0.02};
  double period_s_ = 0, delay_s_ = 0;
  ForceGuard guard_;
};

/// Why a device switched off its forces: the code of DeviceTrouble::forces_off.
/// @source DHD 3.17 dhdc.h, DHD_FORCEOFF_...
enum class ForcesOff : std::int32_t { unknown, button, speed, watchdog, software, usb, grip_switch };

/// The message for a device with a fault: what happened and what to do. @param code  of the maker, 0 none.
[[nodiscard]] base::Error trouble_error(haptics::DeviceTrouble trouble, const std::string& device,
                                        std::int32_t code);

}  // namespace nazori::devices
