// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/devices/back_end.h"

namespace nazori::devices {

/// What open_best() came to.
struct BestDevice {
  std::vector<DeviceProblem> passed_over;  ///< why better ones were not opened, in the order of the attempts
  DeviceResult<OpenedDevice> opened;       ///< fails only where nothing at all could be opened
};

/// All back ends in one list, best first. It lists the devices that are present and why others are missing,
/// opens one by name, and falls back to the next best. It keeps no state between calls. Thread rules: those
/// of BackEnd.
class DeviceCatalogue {
 public:
  /// @param back_ends  best first.
  explicit DeviceCatalogue(std::vector<std::unique_ptr<BackEnd>> back_ends);

  /// One entry for each back end, best first.
  [[nodiscard]] std::vector<BackEndFindings> find();

  /// Opens the device that `name` describes: an id, a back end ("openhaptics": its first device), or a part
  /// of a device's name in small or capital letters.
  /// @return DeviceTrouble::device_absent where no device has that name; lists the names that exist.
  [[nodiscard]] DeviceResult<OpenedDevice> open(std::string_view name, const OpenRequest& request);

  /// Opens `preferred` if it is not empty. If it is empty or cannot be opened, opens the first device of the
  /// list that can be opened, devices with force first.
  /// @param avoid  the id of a device that was just lost; tried last.
  [[nodiscard]] BestDevice open_best(std::string_view preferred, const OpenRequest& request,
                                     std::string_view avoid = {});

 private:
  std::vector<std::unique_ptr<BackEnd>> back_ends_;
};

/// The mouse, pen or finger; always available. Its device is a PointerDevice, which the window moves.
[[nodiscard]] std::unique_ptr<BackEnd> pointer_back_end();
/// The simulated devices; opened only by name: "simulated:touch".
[[nodiscard]] std::unique_ptr<BackEnd> simulated_back_end();

}  // namespace nazori::devices
