// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QFontInfo>
#include <string>

#include "described_widget.h"
#include "nazori/widgets/words/kanji_text.h"
#include "window/language.h"

namespace nazori::ui::test {

/// Widgets in English and in the plain look, with the sizes in which they are described.
class MadeWidgets : public testing::Test {
 protected:
  MadeWidgets() {
    install_language(QStringLiteral("en"));
    use_plain_look();
  }
  static int em() { return QFontInfo(QApplication::font()).pixelSize(); }
  static std::string letters(double size) {
    const QFont font = textbook_font(QFontInfo(QApplication::font()).pointSizeF() * size);
    const QString family = QFontInfo(font).family();
    const bool is_usual = family == QFontInfo(QApplication::font()).family();
    return (is_usual ? QString() : QStringLiteral("in %1; ").arg(family)).toStdString() +
           QStringLiteral("letters %1").arg(size).toStdString();
  }
};

}  // namespace nazori::ui::test
