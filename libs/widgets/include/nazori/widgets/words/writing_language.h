// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLocale>

#include "nazori/writing/explanation.h"

namespace nazori::ui {

/// The language of explanations of writing: that of the interface.
[[nodiscard]] inline writing::Language writing_language() {
  return QLocale().language() == QLocale::Japanese ? writing::Language::japanese : writing::Language::english;
}

/// What stands between two sentences of it.
[[nodiscard]] inline QString between_sentences() {
  return writing_language() == writing::Language::japanese ? QString() : QStringLiteral(" ");
}

}  // namespace nazori::ui
