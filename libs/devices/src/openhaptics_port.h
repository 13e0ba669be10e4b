// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "nazori/devices/openhaptics.h"
#include "openhaptics_abi.h"

namespace nazori::devices::hd {

/// @param user_path  tried first; may be empty.
[[nodiscard]] DeviceResult<Functions> load(const std::string& user_path);

/// Takes all errors off the library's stack. @return the oldest, code 0 where there was none. Real-time-safe.
ErrorInfo take_errors(const Functions& hd) noexcept;

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
  int calibration_style = 0;
  bool reads_inkwell = false, reads_safety_switch = false;

 private:
  Port(const Functions& functions, Handle device) : hd(functions), handle(device) { describe(); }
  void describe();
  [[nodiscard]] double number(Enum what, double scale, double otherwise) const;
};

}  // namespace nazori::devices::hd
