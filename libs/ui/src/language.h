// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace nazori::ui {

/// Puts the program's and Qt's own words into a language for the whole application; what was installed before
/// goes.
/// @param language  "en", "ja"; empty: the desktop's where it is one of these, else English.
/// @return the language in effect.
QString install_language(const QString& language);

}  // namespace nazori::ui
