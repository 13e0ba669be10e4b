// SPDX-License-Identifier: Apache-2.0
// What the error codes of OpenHaptics mean for a device.
#pragma once

#include <cstdint>

#include "nazori/haptics/haptic_device.h"
#include "openhaptics_port.h"

namespace nazori::devices {

/// How the device goes on after an error: not at all changed, without force for a while, closed, or as the
/// next ticks show.
enum class ErrorKind : std::uint8_t { none, force, end, other };

/// Called on the servo's thread.
[[nodiscard]] inline ErrorKind kind_of(unsigned int code) noexcept {
  switch (code) {
    case 0:
      return ErrorKind::none;
    case hd::warm_motors:
    case hd::max_force:
    case hd::force_impulse:
    case hd::max_velocity:
    case hd::mixed_forces:
      return ErrorKind::force;
    case hd::bad_handle:
    case hd::device_fault:
    case hd::communication:
    case hd::configuration:
    case hd::timer:
    case hd::priority:
    case hd::scheduler_full:
      return ErrorKind::end;
    default:
      return ErrorKind::other;
  }
}

/// What a learner is told about an error.
[[nodiscard]] inline haptics::DeviceTrouble trouble_of(unsigned int code) noexcept {
  switch (code) {
    case hd::warm_motors:
      return haptics::DeviceTrouble::warm_motors;
    case hd::max_velocity:
      return haptics::DeviceTrouble::over_speed;
    case hd::max_force:
    case hd::force_impulse:
    case hd::mixed_forces:
      return haptics::DeviceTrouble::over_force;
    case hd::communication:
      return haptics::DeviceTrouble::communication_lost;
    case hd::timer:
      return haptics::DeviceTrouble::no_timer;
    default:
      return haptics::DeviceTrouble::device_fault;
  }
}

}  // namespace nazori::devices
