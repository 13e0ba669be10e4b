// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLocale>

#include "nazori/writing/explanation.h"

namespace nazori::ui {

/// The language of explanations of writing: that of the interface.
[[nodiscard]] inline writing::Language writing_language() {
  return QLocale().language() == QLocale::Japanese ? writing::Language::japanese : writing::Language::english;
}

}  // namespace nazori::ui
