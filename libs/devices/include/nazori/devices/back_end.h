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

/// Why a device cannot be used: a code for the window's translation, and an English sentence that says what
/// to do.
struct DeviceProblem {
  haptics::DeviceTrouble trouble = haptics::DeviceTrouble::none;
  base::Error error;
};

/// A value, or the reason why there is no device.
template <class T>
using DeviceResult = tl::expected<T, DeviceProblem>;

/// Shorthand for returning a DeviceProblem. @param where  the device or library.
[[nodiscard]] inline tl::unexpected<DeviceProblem> no_device(haptics::DeviceTrouble trouble, std::string what,
                                                             std::string where, std::string remedy) {
  return tl::unexpected<DeviceProblem>(
      {trouble, {base::Errc::device, std::move(what), std::move(where), std::move(remedy)}});
}

/// Names that are words, which a window says in its own language. Other names are those of products.
namespace back_end_names {
inline constexpr std::string_view kPointer = "Mouse, pen or finger";
inline constexpr std::string_view kGamepads = "Joysticks, wheels and gamepads";
inline constexpr std::string_view kSimulated = "Simulated devices";
}  // namespace back_end_names

/// What the name of a simulated device ends with: "Falcon (simulated)".
inline constexpr std::string_view kSimulatedMark = " (simulated)";

/// A device that could be opened now.
struct FoundDevice {
  std::string id;    ///< "openhaptics", "inverse3:049D": what open() takes, the same after unplugging
  std::string name;  ///< for people: "Touch (serial 12345)"
  bool has_force = false;
  bool automatic = true;  ///< may be chosen when none was requested by name
};

/// The devices that one back end found, and why others are missing.
struct BackEndFindings {
  std::string back_end;  ///< its name: "OpenHaptics"
  std::vector<FoundDevice> devices;
  std::optional<DeviceProblem> problem;  ///< always set if there are no devices
};

/// The size of the tablet and its pose. A calibration replaces the automatic fit.
struct OpenRequest {
  geometry::TabletShape shape;
  TabletPosture posture;
  std::optional<WorkspaceCalibration> calibration;
};

/// An open device, not yet started. One that is destroyed is closed.
struct OpenedDevice {
  std::string id;
  std::unique_ptr<haptics::HapticDevice> device;  ///< its limits apply in the tablet frame
  WorkspaceCalibration
      calibration;  ///< where the tablet lies in the workspace; converts poses back to the device frame
  DeviceWorkspace workspace;  ///< the space that the stylus can reach
};

/// One way to reach devices: a maker's library, a service, an interface of the system. Thread rules: one
/// thread at a time calls it and destroys what it opened (the window has a thread for that). Meanwhile
/// another thread may start, stop and query the open devices. find() and open() may take up to some seconds.
class BackEnd {
 public:
  virtual ~BackEnd() = default;
  /// "openhaptics": the part before the colon in the ids of its devices.
  [[nodiscard]] virtual std::string_view id() const = 0;
  /// Looks for its devices. A device of this back end that is open already is listed with a problem of
  /// DeviceTrouble::in_use.
  [[nodiscard]] virtual BackEndFindings find() = 0;
  /// Opens one. @param device  an id that find() gives, or id(): the first one.
  [[nodiscard]] virtual DeviceResult<OpenedDevice> open(std::string_view device,
                                                        const OpenRequest& request) = 0;
};

}  // namespace nazori::devices
