// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <string_view>

#include "nazori/haptics/device_status.h"

namespace nazori::ui {

/// What is wrong with a device and what to do, one sentence in the language of the window. @param name  of
/// the device or of the maker's library, for people. @param detail  English, of the back end; it stands in
/// brackets where the sentence alone would not tell what to do (a file, a package, an error number).
[[nodiscard]] QString trouble_text(haptics::DeviceTrouble trouble, const QString& name,
                                   const QString& detail = {});

/// A device's name for people: the window translates what it made up itself.
[[nodiscard]] QString device_name(std::string_view name);

}  // namespace nazori::ui
