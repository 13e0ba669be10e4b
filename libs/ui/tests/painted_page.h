// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <QStyleOptionViewItem>
#include <QTest>

#include "painting_under_test.h"
#include "window/language.h"

namespace nazori::ui::test {

/// What pages draw in English, in letters of 12 pixels.
class PaintedPage : public testing::Test {
 protected:
  void SetUp() override {
    install_language(QStringLiteral("en"));
    font_.setPixelSize(12);
  }
  static void give_keyboard(QWidget& widget) {
    widget.show();
    widget.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&widget));
    widget.setFocus();
    ASSERT_TRUE(widget.hasFocus());
  }
  [[nodiscard]] QStyleOptionViewItem option(const QRect& rect, QStyle::State state) const {
    QStyleOptionViewItem made;
    made.rect = rect;
    made.state = state;
    made.font = font_;
    made.fontMetrics = QFontMetrics(font_);
    return made;
  }
  QFont font_;
};

}  // namespace nazori::ui::test
