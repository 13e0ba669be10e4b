// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>

#include "nazori/base/result.h"
#include "nazori/haptics/device_status.h"

namespace nazori::haptics {

/// Metres, newtons or metres per second in the tablet frame: x right, y up, z towards the learner, plateau at
/// z = 0.
using Vec3 = glm::dvec3;

/// The report of a device in one tick.
struct DeviceSample {
  double time_s = 0;            ///< monotonic, from the start of the device
  Vec3 position_m{0, 0, 0.02};  ///< tip of the stylus, tablet frame
  std::uint32_t buttons = 0;    ///< bit n = button n is down
  bool present = true;          ///< false: pen lifted out of range, device lost; the force must be zero
};

/// The capabilities of a device. All forces that the servo sends stay within these limits.
struct DeviceLimits {
  double max_force_n = 3.3;          ///< peak
  double continuous_force_n = 0.88;  ///< bearable for long (thermal)
  double max_stiffness_n_m = 500;    ///< it renders stably
  double max_damping_n_s_m = 2.5;
  double own_damping_n_s_m = 0.05;  ///< physical damping of its joints, b in b > KT/2 + |B|
  double max_slew_n_s = 200;        ///< fastest change of force
  double delay_s = 0;               ///< from pose to force, beyond one tick
  /// Damping that a loosely holding hand adds to own_damping_n_s_m.
  double hand_damping_n_s_m = 2.0;
};

/// The properties of a device that the window and the command line show.
struct DeviceDescription {
  std::string name;        ///< "Mouse", "Simulated hand"
  double rate_hz = 1000;   ///< of its servo
  bool has_force = false;  ///< false: pen or mouse; forces are computed and shown, but not felt
  DeviceLimits limits;
};

/// Called once per tick, on the servo thread, by what drives the device: a timer thread of this program or
/// the scheduler of the vendor's library. Real-time-safe: implementations must not allocate, lock, log, throw
/// or wait.
class ServoCallback {
 public:
  virtual ~ServoCallback() = default;
  /// @return force to command [N], tablet frame, finite and within the device's limits.
  virtual Vec3 tick(const DeviceSample& sample) noexcept = 0;
  /// The events of the last tick, as bits of ServoEvent, for devices that signal them in another way, such as
  /// rumble. Thread: servo.
  [[nodiscard]] virtual std::uint16_t events() const noexcept { return 0; }
};

/// A stylus: with force, or a mouse, pen, recording or simulation in its place.
/// Thread rules: describe, start and stop are called by one thread (the interface); tick runs on the device's
/// servo thread between start and stop.
class HapticDevice {
 public:
  virtual ~HapticDevice() = default;
  [[nodiscard]] virtual DeviceDescription describe() const = 0;
  /// Starts calling `servo` at the device's rate. `servo` must live until stop() returns.
  [[nodiscard]] virtual base::Result<void> start(ServoCallback& servo) = 0;
  /// Sets the force to zero; no tick runs after it returns. Has no effect when not started.
  virtual void stop() noexcept = 0;
  /// The present status. Never waits for the servo. Thread: interface. The default is a running device.
  [[nodiscard]] virtual DeviceStatus status() const { return {}; }
};

}  // namespace nazori::haptics
