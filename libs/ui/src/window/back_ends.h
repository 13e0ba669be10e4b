// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <memory>
#include <vector>

#include "nazori/devices/back_end.h"

namespace nazori::ui {

/// Every back end for haptic devices, best first. Nothing is loaded or searched yet. The environment says
/// where each searches, as for the command line, or the group "device" of the settings, with the keys of
/// devices::back_end_settings().
[[nodiscard]] std::vector<std::unique_ptr<devices::BackEnd>> registered_back_ends(
    const QString& settings_file);

}  // namespace nazori::ui
