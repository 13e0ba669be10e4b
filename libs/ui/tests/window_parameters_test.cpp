// SPDX-License-Identifier: Apache-2.0
#include <QLabel>
#include <QSlider>

#include "functions/plot_panel.h"
#include "functions_window.h"

namespace nazori::ui {
namespace {

using test::FunctionsWindow;
using test::the_functions;

class ParametersWindow : public FunctionsWindow {
 protected:
  [[nodiscard]] QString expression() { return find<QLineEdit>("expression")->text(); }
  [[nodiscard]] static double drawn_value() {
    return the_functions->shown()->request.plot.parameters.at(0).value;
  }
};

TEST_F(ParametersWindow, ASliderWritesTheValueIntoTheExpressionAndThePlotFollows) {
  type(QStringLiteral("y = a x; a = 1; 0 <= a <= 3"));
  auto* slider = find<QSlider>("parameter_a");
  EXPECT_TRUE(slider->isVisible());
  EXPECT_EQ(slider->value(), 50);  // steps of 0.02
  EXPECT_EQ(text("parameter_a_value"), QStringLiteral("a = 1"));
  QTest::keyClick(slider, Qt::Key_Right);
  EXPECT_EQ(expression(), QStringLiteral("y = a x; a = 1.02; 0 <= a <= 3"));
  EXPECT_EQ(text("parameter_a_value"), QStringLiteral("a = 1.02"));
  EXPECT_EQ(slider->accessibleDescription(), QStringLiteral("a = 1.02"));
  EXPECT_EQ(feedback(), QStringLiteral("a = 1.02"));
  ASSERT_TRUE(wait_for_drawing());
  EXPECT_EQ(drawn_value(), 1.02);
  QTest::keyClick(slider, Qt::Key_End);
  EXPECT_EQ(expression(), QStringLiteral("y = a x; a = 3; 0 <= a <= 3"));
}

TEST_F(ParametersWindow, AfterAStepTheValueIsHeardAndNotTheSummaryOfThePicture) {
  type(QStringLiteral("y = a x; a = 1; 0 <= a <= 3"));
  auto* slider = find<QSlider>("parameter_a");
  slider->setFocus();
  QTest::keyClick(slider, Qt::Key_PageUp);
  ASSERT_TRUE(wait_for_drawing());
  EXPECT_EQ(feedback(), QStringLiteral("a = 1.2"));
}

TEST_F(ParametersWindow, ASliderStaysWhileItsRangeStaysAndGoesWhereTheTypedValueIs) {
  type(QStringLiteral("y = a x; a = 1; 0 <= a <= 3"));
  const auto* slider = find<QSlider>("parameter_a");
  // At once: letter by letter, the parameter is gone in between.
  find<QLineEdit>("expression")->setText(QStringLiteral("y = a x^2; a = 2; 0 <= a <= 3"));
  ASSERT_TRUE(wait_for_drawing());
  EXPECT_EQ(find<QSlider>("parameter_a"), slider);
  EXPECT_EQ(slider->value(), 100);
  EXPECT_EQ(expression(), QStringLiteral("y = a x^2; a = 2; 0 <= a <= 3"));
}

TEST_F(ParametersWindow, AValueThatStandsInTheLineIsNotWrittenIntoItAgain) {
  type(QStringLiteral("y = a x; a = 1; 0 <= a <= 3"));
  auto* line = find<QLineEdit>("expression");
  line->setCursorPosition(3);
  const QString before = feedback();
  auto* panel = window_->findChild<PlotPanel*>();
  ASSERT_NE(panel, nullptr);
  emit panel->parameter_moved(QStringLiteral("a"), 1);
  EXPECT_EQ(line->cursorPosition(), 3);
  EXPECT_EQ(feedback(), before);
  emit panel->parameter_moved(QStringLiteral("b"), 1);
  EXPECT_EQ(expression(), QStringLiteral("y = a x; a = 1; 0 <= a <= 3")) << "there is no such letter";
}

TEST_F(ParametersWindow, WhatASliderWroteIsUndoneInTheLine) {
  type(QStringLiteral("y = a x; a = 1; 0 <= a <= 3"));
  QTest::keyClick(find<QSlider>("parameter_a"), Qt::Key_Home);
  EXPECT_EQ(expression(), QStringLiteral("y = a x; a = 0; 0 <= a <= 3"));
  find<QLineEdit>("expression")->undo();
  EXPECT_EQ(expression(), QStringLiteral("y = a x; a = 1; 0 <= a <= 3"));
  EXPECT_EQ(find<QSlider>("parameter_a")->value(), 50);
}

TEST_F(ParametersWindow, EachParameterHasASliderAndWithoutParametersThereIsNone) {
  type(QStringLiteral("y = a x + b; a = 2; b = 1"));
  EXPECT_EQ(find<QSlider>("parameter_a")->value(), 120);  // from -10 to 10 in steps of 0.1
  EXPECT_EQ(find<QSlider>("parameter_b")->value(), 110);
  QTest::keyClick(find<QSlider>("parameter_b"), Qt::Key_Left);
  EXPECT_EQ(expression(), QStringLiteral("y = a x + b; a = 2; b = 0.9"));
  type(QStringLiteral("y = x"));
  EXPECT_FALSE(find("parameters")->isVisible());
}

TEST_F(ParametersWindow, TabGoesFromTheExpressionOverTheSlidersToTheExamples) {
  type(QStringLiteral("y = a x + b; a = 2; b = 1"));
  auto* line = find("expression");
  EXPECT_EQ(line->nextInFocusChain(), find("parameter_a"));
  EXPECT_EQ(find("parameter_a")->nextInFocusChain(), find("parameter_b"));
  EXPECT_EQ(find("parameter_b")->nextInFocusChain(), find("examples"));
  type(QStringLiteral("y = x"));
  EXPECT_EQ(line->nextInFocusChain(), find("examples"));
}

}  // namespace
}  // namespace nazori::ui
