// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/controls/wheel_guard.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QSpinBox>
#include <QTest>
#include <QVBoxLayout>
#include <QWheelEvent>

namespace nazori::ui {
namespace {

/// A form that is higher than its window.
struct Form {
  WheelGuard guard;
  QWidget window;
  QScrollArea* area = new QScrollArea;
  QSpinBox* number = new QSpinBox;
  QComboBox* choice = new QComboBox;
  QSlider* slider = new QSlider(Qt::Horizontal);
  QSpinBox* beside = new QSpinBox;

  Form() {
    qApp->installEventFilter(&guard);
    auto* content = new QWidget;
    auto* column = new QVBoxLayout(content);
    choice->addItems({"a", "b", "c"});
    choice->setCurrentIndex(1);
    number->setValue(50);
    slider->setValue(50);
    beside->setValue(50);
    for (QWidget* widget : std::initializer_list<QWidget*>{number, choice, slider}) column->addWidget(widget);
    column->addSpacing(2'000);
    area->setWidget(content);
    area->setWidgetResizable(true);
    auto* row = new QVBoxLayout(&window);
    row->addWidget(area);
    row->addWidget(beside);
    window.resize(300, 300);
    window.show();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
    area->setFocus();
  }
  void turn_wheel_over(QWidget* widget) const {
    const QPointF middle(widget->rect().center());
    QWheelEvent event(middle, widget->mapToGlobal(middle), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(widget, &event);
  }
};

TEST(WheelGuard, OverANumberAChoiceAndASliderTheWheelScrollsTheForm) {
  const Form form;
  for (QWidget* widget : std::initializer_list<QWidget*>{form.slider, form.number, form.choice}) {
    form.area->verticalScrollBar()->setValue(0);
    form.turn_wheel_over(widget);
    EXPECT_GT(form.area->verticalScrollBar()->value(), 0) << widget->metaObject()->className();
    EXPECT_FALSE(widget->hasFocus());
  }
  EXPECT_EQ(form.number->value(), 50);
  EXPECT_EQ(form.choice->currentIndex(), 1);
  EXPECT_EQ(form.slider->value(), 50);
}

TEST(WheelGuard, WhatHasTheKeyboardTakesTheWheel) {
  const Form form;
  form.number->setFocus();
  form.turn_wheel_over(form.number);
  EXPECT_EQ(form.number->value(), 49);
  form.choice->setFocus();
  form.turn_wheel_over(form.choice);
  EXPECT_EQ(form.choice->currentIndex(), 2);
  EXPECT_EQ(form.area->verticalScrollBar()->value(), 0);
}

TEST(WheelGuard, OutsideOfAFormTheWheelChangesANumber) {
  const Form form;
  form.turn_wheel_over(form.beside);
  EXPECT_EQ(form.beside->value(), 49);
}

}  // namespace
}  // namespace nazori::ui
