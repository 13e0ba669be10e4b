// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace nazori::haptics {

/// How it stands with a device that has been opened.
enum class DeviceState : std::uint8_t {
  stopped,  ///< not started, or stopped
  running,  ///< poses come, forces go
  paused,   ///< no force and no stylus for now; goes on by itself, with a ramp, once the cause is gone
  lost,     ///< no force and no stylus any more; it must be opened again
};

/// What keeps a device from being felt. The window translates by this; the sentence is English.
enum class DeviceTrouble : std::uint8_t {
  none,
  // Finding and opening
  library_missing,  ///< the maker's library is not installed or does not load
  symbol_missing,   ///< a library of that name lacks a function that is needed
  service_missing,  ///< the maker's background program does not answer
  device_absent,    ///< nothing is plugged in
  no_permission,    ///< there is a device, but this user may not open it
  in_use,           ///< this or another program has it open
  init_failed,      ///< there, but it refuses
  bad_calibration,  ///< the stored fit to the tablet is unusable
  // Paused
  docked,                ///< the stylus rests in its inkwell
  safety_switch,         ///< nobody holds the switch that allows forces
  not_calibrated,        ///< it asks to be calibrated
  wants_inkwell,         ///< it calibrates itself once the stylus is in its inkwell
  wants_reset_position,  ///< it can be calibrated where its arm is held at the reset position
  not_at_rest,           ///< it was not at rest when it was opened, so its angles are wrong
  not_homed,             ///< it brakes and tells one place until its arms have been to their ends
  forces_off,            ///< its forces went off; the code says why
  over_force,            ///< its guard against too large a force or impulse acted
  over_speed,            ///< its guard against too fast a motion acted
  warm_motors,           ///< its motors must cool
  not_ready,             ///< switched off, braked or in use by another session
  too_slow,              ///< poses come too late to be felt safely
  // Lost
  communication_lost,  ///< cable or radio
  device_fault,        ///< it reports a fault of its own
  no_timer,            ///< the maker's library gets no timer from the system
  stalled,             ///< its servo does not tick any more
  service_gone,        ///< the maker's background program went away
  bad_message,         ///< what came is not what was agreed
};

/// What the window shows of an opened device, several times a second.
struct DeviceStatus {
  DeviceState state = DeviceState::running;
  DeviceTrouble trouble = DeviceTrouble::none;
  std::string message;        ///< one English line, what is wrong and what to do; empty without trouble
  std::uint32_t buttons = 0;  ///< bit n = button n is down
  double rate_hz = 0;         ///< measured, smoothed; 0 unknown
  double delay_s = 0;         ///< from pose to force, measured, smoothed; 0 unknown or none
};

}  // namespace nazori::haptics
