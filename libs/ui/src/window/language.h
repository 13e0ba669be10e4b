// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace nazori::ui {

/// Installs the translations of the program and of Qt for the whole application, and removes the previous
/// ones.
/// @param language  "en", "ja"; empty: the desktop's where it is one of these, else English.
/// @return the language in effect.
QString install_language(const QString& language);

}  // namespace nazori::ui
