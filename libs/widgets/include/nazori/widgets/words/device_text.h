// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <string_view>

#include "nazori/haptics/device_status.h"

namespace nazori::ui {

/// What is wrong with a device and what to do, in one sentence in the language of the window. @param name  of
/// the device or of the maker's library, as shown to the learner. @param detail  English, of the back end. It
/// is added in brackets if the sentence alone would not say what to do (a file, a package, an error number).
[[nodiscard]] QString trouble_text(haptics::DeviceTrouble trouble, const QString& name,
                                   const QString& detail = {});

/// The name of a device as shown to the learner. Names that Nazori chose are translated.
[[nodiscard]] QString device_name(std::string_view name);

}  // namespace nazori::ui
