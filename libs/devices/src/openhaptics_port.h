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

/// What to do where libHD is there and lacks a library that it needs.
/// @param words  of the loader.  @param otherwise  where it lacks none that is known.
[[nodiscard]] std::string remedy_for_missing(std::string_view words, std::string otherwise);

/// Takes all errors off the library's stack. @return the oldest, code 0 where there was none. Real-time-safe.
ErrorInfo take_errors(const Functions& hd) noexcept;

/// The library tells errors of connection and timer once for each cause: asked again, it fails without any.
/// This is the last of them since a device was last seen to tick, 0 where there was none. Real-time-safe.
[[nodiscard]] unsigned int latched_error() noexcept;
/// The device ticks. Real-time-safe.
void forget_latched_error() noexcept;

/// The one style to calibrate by: automatic before inkwell before the arm's reset position, as the maker's
/// example prefers them. @param mask  what the device has. @return 0 where it has none.
[[nodiscard]] constexpr int preferred_style(int mask) noexcept {
  for (const int style : {kAutoStyle, kInkwellStyle, kResetStyle})
    if ((mask & style) != 0) return style;
  return 0;
}

/// A device that the library has initialised; disabled when the last owner goes.
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
