// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "nazori/devices/openhaptics.h"
#include "openhaptics_abi.h"

namespace nazori::devices::hd {

/// @param user_path  tried first; may be empty.
[[nodiscard]] DeviceResult<Functions> load(const std::string& user_path);

/// Instructions for a libHD that lacks a library it needs.
/// @param words  the loader's message.  @param otherwise  returned where no known library is missing.
[[nodiscard]] std::string remedy_for_missing(std::string_view words, std::string otherwise);

/// Takes all errors off the library's stack. @return the oldest, code 0 where there was none. Real-time-safe.
ErrorInfo pop_errors(const Functions& hd) noexcept;

/// The library reports errors of connection and timer only once per cause and later fails without one. This
/// is the last such error since a device last ticked, 0 where there was none. Real-time-safe.
[[nodiscard]] unsigned int latched_error() noexcept;
/// The device ticks. Real-time-safe.
void forget_latched_error() noexcept;

/// The one style to calibrate by: automatic before inkwell before the arm's reset position, as in the maker's
/// example. @param mask  the styles of the device. @return 0 where it has none.
[[nodiscard]] constexpr int preferred_style(int mask) noexcept {
  for (const int style : {kAutoStyle, kInkwellStyle, kResetStyle})
    if ((mask & style) != 0) return style;
  return 0;
}

/// A device that the library has initialised; disabled when the last owner is destroyed.
class Port {
 public:
  /// Tries the names in order, draining the library's errors in between.
  [[nodiscard]] static DeviceResult<std::shared_ptr<Port>> open(const Functions& hd,
                                                                const OpenHapticsSettings& settings,
                                                                const std::string& wanted_name);
  ~Port();
  Port(const Port&) = delete;
  Port& operator=(const Port&) = delete;

  const Functions hd;
  const Handle handle;
  std::string name;  // "Touch (serial 123)"
  haptics::DeviceLimits limits;
  DeviceWorkspace workspace;
  int calibration_styles = 0;  // bits
  bool reads_inkwell = false, reads_safety_switch = false;

 private:
  Port(const Functions& functions, Handle device) : hd(functions), handle(device) { describe(); }
  void describe();
  [[nodiscard]] double number(Enum what, double scale, double otherwise) const;
};

}  // namespace nazori::devices::hd
