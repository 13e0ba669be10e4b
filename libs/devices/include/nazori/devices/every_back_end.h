// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "nazori/base/settings.h"
#include "nazori/devices/back_end.h"

namespace nazori::devices {

/// The settings of back ends: `stored`, overridden by the environment.
///
/// | setting | environment | |
/// |---|---|---|
/// | openhaptics_library | NAZORI_LIBHD | path of the library |
/// | openhaptics_device | NAZORI_OPENHAPTICS_DEVICE | name of the device |
/// | forcedimension_library | NAZORI_LIBDHD | path of the library |
/// | inverse_port | NAZORI_INVERSE_PORT | number of the service's port |
/// | pantograph_port | NAZORI_PANTOGRAPH_PORT | path of the serial port |
/// | pantograph_button | NAZORI_PANTOGRAPH_BUTTON | there is one, unless empty, 0 or false |
[[nodiscard]] base::Settings back_end_settings(base::Settings stored = {});

/// All of them, best first: OpenHaptics, Force Dimension, Inverse Service, pantograph, joysticks and pads,
/// pointer, simulations. Nothing is loaded or searched yet.
/// @param settings  as from back_end_settings(); missing or invalid values have their defaults.
[[nodiscard]] std::vector<std::unique_ptr<BackEnd>> every_back_end(const base::Settings& settings);

}  // namespace nazori::devices
