// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <memory>
#include <vector>

#include "nazori/devices/back_end.h"

namespace nazori::ui {

/// Every way to a haptic device that the program knows, best first; nothing is loaded or looked for yet.
/// Where each looks is said by the environment, as for the command line, or by the group "device" of the
/// settings, with the keys of devices::back_end_settings().
[[nodiscard]] std::vector<std::unique_ptr<devices::BackEnd>> registered_back_ends(
    const QString& settings_file);

}  // namespace nazori::ui
