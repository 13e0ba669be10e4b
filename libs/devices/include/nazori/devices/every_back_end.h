// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "nazori/devices/back_end.h"
#include "nazori/devices/force_dimension.h"
#include "nazori/devices/game_controllers.h"
#include "nazori/devices/inverse_service.h"
#include "nazori/devices/openhaptics.h"
#include "nazori/devices/pantograph.h"

namespace nazori::devices {

/// Where every back end looks. Plain values, for the window's settings.
struct BackEndSettings {
  OpenHapticsSettings openhaptics;
  ForceDimensionSettings force_dimension;
  InverseServiceSettings inverse_service;
  PantographSettings pantograph;

  /// The defaults, changed by NAZORI_LIBHD and NAZORI_LIBDHD (paths of the libraries),
  /// NAZORI_OPENHAPTICS_DEVICE (name), NAZORI_INVERSE_PORT, NAZORI_PANTOGRAPH_PORT (path) and
  /// NAZORI_PANTOGRAPH_BUTTON (anything but 0: it has one) where these are set.
  [[nodiscard]] static BackEndSettings from_environment();
};

/// All of them, best first: OpenHaptics, Force Dimension, Inverse Service, pantograph, joysticks and pads,
/// pointer, simulations.
[[nodiscard]] std::vector<std::unique_ptr<BackEnd>> every_back_end(const BackEndSettings& settings);

}  // namespace nazori::devices
