// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "nazori/base/settings.h"
#include "nazori/devices/workspace_mapping.h"
#include "nazori/haptics/haptic_scene.h"

namespace nazori::devices {

/// The action of a button of the stylus.
enum class ButtonDoes : std::uint8_t { nothing, next_stroke, previous_stroke, all_strokes, clear_ink };

/// The saved settings of one device.
struct DeviceSettings {
  static constexpr std::size_t kButtons = 2;

  TabletPosture posture;
  std::optional<WorkspaceCalibration> calibration;  ///< nothing: the largest tablet that fits
  double max_force_n = 0;                           ///< the learner's own limit; 0: the device's
  double max_stiffness_n_m = 0;                     ///< likewise
  std::array<ButtonDoes, kButtons> buttons{ButtonDoes::next_stroke, ButtonDoes::all_strokes};
  std::string name;  ///< for people, as when it was last open; empty: it never was
};

/// The saved settings of each device, by its id.
using RememberedDevices = std::map<std::string, DeviceSettings, std::less<>>;

/// The settings of a device; where none are saved, the defaults for a new device.
[[nodiscard]] DeviceSettings settings_of(const RememberedDevices& devices, std::string_view id);

/// The chosen device, the saved settings of each device, the material of the tablet, and the tip it is felt
/// with.
struct DeviceMemory {
  std::string chosen;  ///< id; empty: the best one available; "pointer": mouse, pen or finger
  RememberedDevices devices;
  haptics::Material material;
  double tip_radius_m = 0;  ///< of the ball at the tip, 0..surface::kLargestBall_m; 0: a point

  /// Reads stored settings; invalid values keep their defaults. Keys: "chosen", "tip_radius_mm",
  /// "material_stiffness" (and the other numbers of haptics::Material, and "material_texture"),
  /// "known/ID/KEY" with ID as the hexadecimal digits of a device's id, because ids contain characters that a
  /// key may not contain.
  void load(const base::Settings& settings);
  /// Stores all that load() reads; other keys are unchanged.
  void save(base::Settings& settings) const;
};

/// The limits of a device, reduced by the learner's own limits.
[[nodiscard]] haptics::DeviceLimits limited(haptics::DeviceLimits own, const DeviceSettings& settings);

}  // namespace nazori::devices
