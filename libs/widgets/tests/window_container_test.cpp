// SPDX-License-Identifier: Apache-2.0
// The tablet is a window of its own inside a widget.
#include <gtest/gtest.h>

#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QTest>
#include <QWindow>

#include "nazori/widgets/controls/parts.h"

namespace nazori::ui {
namespace {

TEST(WindowContainer, KeepsTheKeyboardHoweverOftenItIsGivenIt) {
  QWidget window;
  auto* const row = new QHBoxLayout(&window);
  auto* const inside = new QWindow;
  auto* const container = QWidget::createWindowContainer(inside, &window);
  container->setFocusPolicy(Qt::StrongFocus);
  auto* const field = new QLineEdit(&window);
  row->addWidget(container);
  row->addWidget(field);
  window.show();
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  field->setFocus();
  ASSERT_TRUE(QTest::qWaitFor([&] { return field->hasFocus(); }, 20'000));
  focus_window_container(*container, inside);
  ASSERT_EQ(QGuiApplication::focusWindow(), inside);
  // The offscreen platform is done at once, and Qt then gives the field the focus of the outer window. The
  // event loop would give the outer window the keyboard, too.
  field->clearFocus();
  focus_window_container(*container, inside);
  EXPECT_EQ(QGuiApplication::focusWindow(), inside);
  EXPECT_FALSE(field->hasFocus());
}

TEST(WindowContainer, WithoutAWindowInsideIsAnOrdinaryWidget) {
  QWidget window;
  QLineEdit field(&window);
  window.show();
  window.activateWindow();
  focus_window_container(field, nullptr);
  EXPECT_TRUE(QTest::qWaitFor([&] { return field.hasFocus(); }, 20'000));
}

}  // namespace
}  // namespace nazori::ui
