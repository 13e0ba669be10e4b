// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLocale>

namespace nazori::ui::test {

/// Words and numbers as in English, whatever the desktop speaks.
inline void speak_english() { QLocale::setDefault(QLocale(QLocale::English)); }

}  // namespace nazori::ui::test
