// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QTest>

#include "in_english.h"
#include "painting_under_test.h"

namespace nazori::ui::test {

/// What pages draw in English, in letters of 12 pixels and in light colours, without a style sheet.
class PaintedLightly : public testing::Test {
 protected:
  void SetUp() override {
    speak_english();
    font_.setPixelSize(12);
    qApp->setStyleSheet({});
    QApplication::setPalette(make_palette(light_colours()));
  }
  static void give_keyboard(QWidget& widget) {
    widget.show();
    widget.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&widget));
    widget.setFocus();
    ASSERT_TRUE(widget.hasFocus());
  }
  QFont font_;
  const Colours& c_ = light_colours();
};

}  // namespace nazori::ui::test
