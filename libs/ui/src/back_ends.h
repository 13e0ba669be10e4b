// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include "stylus.h"

namespace nazori::ui {

/// Every way to a haptic device that the program knows, best first. Where a maker's library lies can be said
/// in the settings: device/openhaptics_library, device/forcedimension_library.
[[nodiscard]] Stylus::BackEnds registered_back_ends(const QString& settings_file);

}  // namespace nazori::ui
