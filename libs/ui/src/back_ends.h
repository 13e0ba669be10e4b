// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "stylus.h"

namespace nazori::ui {

/// Every way to a haptic device that the program knows, best first; nothing is loaded or looked for yet.
/// Where each looks is said by the environment, as for the command line, or by the settings:
/// device/openhaptics_library, device/openhaptics_device, device/forcedimension_library, device/inverse_port,
/// device/pantograph_port, device/pantograph_button.
[[nodiscard]] Stylus::BackEnds registered_back_ends(const QString& settings_file);

}  // namespace nazori::ui
