// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QHash>
#include <QString>
#include <array>
#include <cstdint>
#include <optional>

#include "nazori/devices/workspace_mapping.h"
#include "nazori/haptics/haptic_scene.h"

class QSettings;

namespace nazori::ui {

/// What a button of the stylus does.
enum class ButtonDoes : std::uint8_t { nothing, next_stroke, previous_stroke, all_strokes, clear_ink };

/// What is remembered of one device.
struct DeviceSettings {
  static constexpr std::size_t kButtons = 2;

  devices::TabletPosture posture;
  std::optional<devices::WorkspaceCalibration> calibration;  ///< nothing: the largest tablet that fits
  double max_force_n = 0;                                    ///< the learner's own limit; 0: the device's
  double max_stiffness_n_m = 0;                              ///< likewise
  std::array<ButtonDoes, kButtons> buttons{ButtonDoes::next_stroke, ButtonDoes::all_strokes};
};

/// The device that was chosen, what is remembered of each, and the material of the tablet.
struct DeviceMemory {
  QString chosen;  ///< id; empty: the best that is there; "pointer": mouse, pen or finger
  QHash<QString, DeviceSettings> devices;
  haptics::Material material;

  /// Reads the group that `settings` stands in; what makes no sense keeps its default.
  void load(QSettings& settings);
  void save(QSettings& settings) const;
};

/// The limits of a device with those of the learner: never above its own.
[[nodiscard]] haptics::DeviceLimits limited(haptics::DeviceLimits own, const DeviceSettings& settings);

}  // namespace nazori::ui
