// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/devices/workspace_mapping.h"
#include "nazori/haptics/haptic_device.h"

namespace nazori::devices {

/// Why a device cannot be felt: what the window translates by, and the English sentence with what to do.
struct DeviceProblem {
  haptics::DeviceTrouble trouble = haptics::DeviceTrouble::none;
  base::Error error;
};

/// A value, or why no device.
template <class T>
using DeviceResult = tl::expected<T, DeviceProblem>;

/// Shorthand for returning a DeviceProblem. @param where  the device or library.
[[nodiscard]] inline tl::unexpected<DeviceProblem> no_device(haptics::DeviceTrouble trouble, std::string what,
                                                             std::string where, std::string remedy) {
  return tl::unexpected<DeviceProblem>(
      {trouble, {base::Errc::device, std::move(what), std::move(where), std::move(remedy)}});
}

/// A device that could be opened now.
struct FoundDevice {
  std::string id;    ///< "openhaptics", "inverse3:049D": what open() takes, the same after unplugging
  std::string name;  ///< for people: "Touch (serial 12345)"
  bool has_force = false;
  bool automatic = true;  ///< may be chosen when nobody asked for it by name
};

/// What one back end found, and why not more.
struct BackEndFindings {
  std::string back_end;  ///< its name: "OpenHaptics"
  std::vector<FoundDevice> devices;
  std::optional<DeviceProblem> problem;  ///< always there where there are no devices
};

/// What the tablet is and how it should stand; the calibration takes the place of the automatic fit.
struct OpenRequest {
  geometry::TabletShape shape;
  TabletPosture posture;
  std::optional<WorkspaceCalibration> calibration;
};

/// An open device, not yet started. One that is destroyed is closed.
struct OpenedDevice {
  std::string id;
  std::unique_ptr<haptics::HapticDevice> device;  ///< its limits are those on the tablet
  WorkspaceCalibration calibration;  ///< where the tablet stands in it; turns poses back into its frame
  DeviceWorkspace workspace;         ///< what the stylus can reach
};

/// One way to reach devices: a maker's library, a service, an interface of the system.
/// Thread rules: one thread at a time calls it and destroys what it opened (the window has one for that);
/// meanwhile another may start, stop and ask the devices that are open. find() and open() may take up to some
/// seconds.
class BackEnd {
 public:
  virtual ~BackEnd() = default;
  /// "openhaptics": what ids of its devices start with, before a colon.
  [[nodiscard]] virtual std::string_view id() const = 0;
  /// Looks for its devices. A device of this back end that is open already is listed with a problem of
  /// DeviceTrouble::in_use.
  [[nodiscard]] virtual BackEndFindings find() = 0;
  /// Opens one. @param device  an id that find() gives, or id(): the first one.
  [[nodiscard]] virtual DeviceResult<OpenedDevice> open(std::string_view device,
                                                        const OpenRequest& request) = 0;
};

}  // namespace nazori::devices
