// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace nazori::haptics {

/// The state of an opened device.
enum class DeviceState : std::uint8_t {
  stopped,  ///< not started, or stopped
  running,  ///< poses come, forces go
  paused,   ///< no force and no stylus for now; continues automatically, with a force ramp, once the cause is
            ///< gone
  lost,     ///< no force and no stylus any more; it must be opened again
};

/// Why a device cannot be used. The window translates by this value; the sentence is English.
enum class DeviceTrouble : std::uint8_t {
  none,
  // Finding and opening
  library_missing,  ///< the maker's library is not installed or does not load
  symbol_missing,   ///< a library of that name lacks a function that is needed
  service_missing,  ///< the maker's background program does not answer
  device_absent,    ///< nothing is plugged in
  no_permission,    ///< there is a device, but this user has no permission to open it
  in_use,           ///< this or another program has it open
  init_failed,      ///< there, but it refuses
  bad_calibration,  ///< the stored calibration is unusable
  // Paused
  docked,                ///< the stylus rests in its inkwell
  safety_switch,         ///< the switch that allows forces is not held
  not_calibrated,        ///< it requires calibration
  wants_inkwell,         ///< it calibrates itself once the stylus is in its inkwell
  wants_reset_position,  ///< it can be calibrated where its arm is held at the reset position
  not_at_rest,           ///< it was not at rest when it was opened, so its angles are wrong
  not_homed,             ///< it brakes and reports one position until its arms have been moved to their stops
  forces_off,            ///< its forces were switched off; the code says why
  over_force,            ///< its protection against too large a force or impulse has acted
  over_speed,            ///< its protection against too fast a motion has acted
  warm_motors,           ///< its motors must cool
  not_ready,             ///< switched off, braked or in use by another session
  too_slow,              ///< poses arrive too late for safe forces
  // Lost
  communication_lost,  ///< cable or radio
  device_fault,        ///< it reports a fault of its own
  no_timer,            ///< the maker's library got no timer from the system
  stalled,             ///< its servo has stopped ticking
  service_gone,        ///< the maker's background program has ended
  bad_message,         ///< a message does not follow the protocol
};

/// The status of an opened device, which the window shows several times a second.
struct DeviceStatus {
  DeviceState state = DeviceState::running;
  DeviceTrouble trouble = DeviceTrouble::none;
  std::string message;        ///< one English line, what is wrong and what to do; empty when all is well
  std::uint32_t buttons = 0;  ///< bit n = button n is down
  double rate_hz = 0;         ///< measured, smoothed; 0 unknown
  double delay_s = 0;         ///< from pose to force, measured, smoothed; 0 unknown or none
};

}  // namespace nazori::haptics
