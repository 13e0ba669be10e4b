// SPDX-License-Identifier: Apache-2.0
// What the page for functions announces, and what it saves.
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QSettings>
#include <QSlider>
#include <QTableWidget>

#include "functions/expression_line.h"
#include "functions/plot_words.h"
#include "functions_window.h"
#include "nazori/functions/tablet_curves.h"

namespace nazori::ui {
namespace {

using test::the_functions;
using test::the_functions_parts;

class PlotWordsInTheWindow : public test::FunctionsWindow {
 protected:
  practice::TabletControl& controller() { return the_functions_parts->tablet(); }
  void set_up_with(const QList<std::pair<const char*, QVariant>>& kept) {
    window_->close();
    QSettings settings(folder_.filePath(QStringLiteral("nazori.ini")), QSettings::IniFormat);
    settings.beginGroup(QStringLiteral("functions"));
    for (const auto& [key, value] : kept) settings.setValue(QString::fromLatin1(key), value);
    settings.endGroup();
    settings.sync();
    open_window(U'休');
    press(Qt::Key_2, Qt::AltModifier);
    ASSERT_TRUE(wait_for_drawing());
  }
  [[nodiscard]] QVariant kept(const char* key) {
    window_->close();
    const QSettings settings(folder_.filePath(QStringLiteral("nazori.ini")), QSettings::IniFormat);
    return settings.value(QStringLiteral("functions/") + QString::fromLatin1(key));
  }
  geometry::TabletPoint on_tablet(double x, double y) {
    const auto& drawing = shown();
    return functions::tablet_place({drawing.request.window.u(x), drawing.request.window.v(y)},
                                   drawing.picture.plate.heights.size(), carved().shape());
  }
};

TEST_F(PlotWordsInTheWindow, TheEndOfACurveAndTheNextPieceAreSaid) {
  type(QStringLiteral("y = 1/x"));
  to_tablet();
  press(Qt::Key_Right);
  press(Qt::Key_Home);
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("x = about minus 6"))) << feedback().toStdString();
  EXPECT_TRUE(feedback().endsWith(u'.'));
  press(Qt::Key_Left);
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("End: x = about minus 6"))) << feedback().toStdString();
  press(Qt::Key_End);
  press(Qt::Key_Right);
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("Next branch: x = about 0.25")))
      << feedback().toStdString();
  EXPECT_GT(the_functions->location()->x, 0);
  press(Qt::Key_Left, Qt::ControlModifier);
  EXPECT_LT(the_functions->location()->x, 0);
}

TEST_F(PlotWordsInTheWindow, ControlWithTheArrowsGoesFromTickToTickBothWays) {
  type(QStringLiteral("y = x/2"));
  to_tablet();
  press(Qt::Key_Right);
  press(Qt::Key_Right, Qt::ControlModifier);
  press(Qt::Key_Right, Qt::ControlModifier);
  const double second = the_functions->location()->x;
  press(Qt::Key_Right, Qt::ControlModifier);
  EXPECT_GT(the_functions->location()->x, second);
  press(Qt::Key_Left, Qt::ControlModifier);
  EXPECT_EQ(the_functions->location()->x, second);
}

TEST_F(PlotWordsInTheWindow, AnotherCurveIsNamedWhereItIsEntered) {
  type(QStringLiteral("y = 1; y = -1; y = 2"));
  to_tablet();
  press(Qt::Key_Right);
  std::vector<int> seen{the_functions->location()->statement};
  for (const auto key : {Qt::Key_Up, Qt::Key_Up, Qt::Key_Down}) {
    press(key);
    seen.push_back(the_functions->location()->statement);
  }
  EXPECT_EQ(seen[1], (seen[0] + 1) % 3);
  EXPECT_EQ(seen[2], (seen[0] + 2) % 3);
  EXPECT_EQ(seen[3], seen[1]);
  press(Qt::Key_Up);
  while (the_functions->location()->statement != 1) press(Qt::Key_Up);
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("y equals minus 1: "))) << feedback().toStdString();
  type(QStringLiteral("y = 1"));
  to_tablet();
  press(Qt::Key_Up);
  EXPECT_EQ(feedback(), QStringLiteral("There is no other curve or branch."));
}

TEST_F(PlotWordsInTheWindow, BeforeTheFirstStepItIsSaidHowToBegin) {
  type(QStringLiteral("y = x"));
  to_tablet();
  const QString begin = QStringLiteral("First move to a point on a curve with the arrow keys.");
  press(Qt::Key_C);
  EXPECT_EQ(feedback(), begin);
  press(Qt::Key_D);
  EXPECT_EQ(feedback(), QStringLiteral("The curve has no slope here."));
  press(Qt::Key_B);
  EXPECT_EQ(feedback(), begin);
  press(Qt::Key_G);
  EXPECT_EQ(feedback(), QStringLiteral("There are no markers yet. B: add one."));
}

TEST_F(PlotWordsInTheWindow, WhereThereIsNoCurveThatIsSaid) {
  type(QStringLiteral("y = sqrt(-1 - x^2)"));
  to_tablet();
  press(Qt::Key_C);
  EXPECT_EQ(feedback(), QStringLiteral("There is no curve to follow here."));
  press(Qt::Key_Right);
  EXPECT_EQ(feedback(), QStringLiteral("There is no curve to follow here."));
  press(Qt::Key_N);
  EXPECT_EQ(feedback(), QStringLiteral("There are no points of interest in this range."));
}

TEST_F(PlotWordsInTheWindow, PointsAreGoneToInTheTableToo) {
  type(QStringLiteral("y = x^2 - 1"));
  to_tablet();
  press(Qt::Key_N);
  press(Qt::Key_N);
  auto* table = find<QTableWidget>("points_table");
  EXPECT_EQ(table->currentRow(), 1);
  EXPECT_EQ(feedback(), point_words(shown().points[1]) + u'.');
  press(Qt::Key_N, Qt::ShiftModifier);
  EXPECT_EQ(table->currentRow(), 0);
  press(Qt::Key_B);
  EXPECT_EQ(feedback(), QStringLiteral("Marker 1 set: %1.").arg(point_words(shown().points[0])));
  press(Qt::Key_End);
  press(Qt::Key_B);
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("Marker 2 set: x = "))) << feedback().toStdString();
  press(Qt::Key_G);
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("Marker 1: "))) << feedback().toStdString();
}

TEST_F(PlotWordsInTheWindow, OneCurveAmongOneIsNoChoice) {
  type(QStringLiteral("y = 1"));
  to_tablet();
  press(Qt::Key_O);
  EXPECT_EQ(feedback(), QStringLiteral("There is only one curve."));
  EXPECT_FALSE(action("curve_alone")->isChecked());
  press(Qt::Key_O, Qt::ShiftModifier);
  EXPECT_EQ(feedback(), QStringLiteral("There is only one curve."));
}

TEST_F(PlotWordsInTheWindow, EachCurveAloneAndThenAllAgain) {
  type(QStringLiteral("y = 1; y = -1"));
  to_tablet();
  press(Qt::Key_Right);
  while (the_functions->location()->statement != 1) press(Qt::Key_Up);
  press(Qt::Key_O);
  EXPECT_EQ(feedback(), QStringLiteral("Only curve 2: y equals minus 1."));
  EXPECT_TRUE(action("curve_alone")->isChecked());
  press(Qt::Key_O, Qt::ShiftModifier);
  EXPECT_EQ(feedback(), QStringLiteral("All curves are shown."));
  EXPECT_FALSE(action("curve_alone")->isChecked());
  press(Qt::Key_O, Qt::ShiftModifier);
  EXPECT_EQ(feedback(), QStringLiteral("Only curve 1: y equals 1."));
  type(QStringLiteral("y = 3; y = 2"));
  EXPECT_FALSE(action("curve_alone")->isChecked()) << "another plot is shown whole";
  EXPECT_EQ(carved().lines().size(), 2U);
}

TEST_F(PlotWordsInTheWindow, VolumeGoesInTensFrom0To100) {
  to_tablet();
  press(Qt::Key_V);
  EXPECT_EQ(feedback(), QStringLiteral("Volume 60"));
  EXPECT_EQ(find<QSlider>("volume")->value(), 60);
  for (int i = 0; i < 6; ++i) press(Qt::Key_V);
  EXPECT_EQ(feedback(), QStringLiteral("Volume 100"));
  press(Qt::Key_V, Qt::ShiftModifier);
  EXPECT_EQ(feedback(), QStringLiteral("Volume 90"));
  find<QSlider>("volume")->setValue(5);
  to_tablet();
  press(Qt::Key_V, Qt::ShiftModifier);
  EXPECT_EQ(feedback(), QStringLiteral("Volume 0"));
  EXPECT_EQ(kept("volume").toInt(), 0);
}

TEST_F(PlotWordsInTheWindow, SpeedGoesFrom1To10) {
  to_tablet();
  press(Qt::Key_Plus);
  EXPECT_EQ(feedback(), QStringLiteral("Speed 3 of 10"));
  for (int i = 0; i < 9; ++i) press(Qt::Key_Plus);
  EXPECT_EQ(feedback(), QStringLiteral("Speed 10 of 10"));
  for (int i = 0; i < 12; ++i) press(Qt::Key_Minus);
  EXPECT_EQ(feedback(), QStringLiteral("Speed 1 of 10"));
  EXPECT_EQ(kept("speed").toInt(), 1);
}

TEST_F(PlotWordsInTheWindow, WithoutSoundItIsSaidHowToTurnItOn) {
  type(QStringLiteral("y = x"));
  to_tablet();
  press(Qt::Key_M);
  EXPECT_EQ(feedback(), QStringLiteral("Sound off."));
  EXPECT_TRUE(find<QCheckBox>("no_sound")->isChecked());
  EXPECT_TRUE(action("sound_mute")->isChecked());
  for (const auto key : {Qt::Key_H, Qt::Key_Y}) {
    press(key);
    EXPECT_EQ(feedback(), QStringLiteral("Sound is off. M: turn it on."));
    press(Qt::Key_C);
  }
  find<QCheckBox>("no_sound")->click();
  EXPECT_EQ(feedback(), QStringLiteral("Sound on."));
  EXPECT_FALSE(action("sound_mute")->isChecked());
  to_tablet();
  press(Qt::Key_H);
  EXPECT_EQ(feedback(), QStringLiteral("y equals x"));
}

TEST_F(PlotWordsInTheWindow, ASurfaceHasNothingToPlayOrToPrint) {
  type(QStringLiteral("z = x"));
  to_tablet();
  press(Qt::Key_H);
  EXPECT_EQ(feedback(), QStringLiteral("A surface has no curve to play."));
  action("plot_export_print")->trigger();
  EXPECT_EQ(feedback(), QStringLiteral("A surface has no lines to print."));
  press(Qt::Key_C);
  action("plot_export_sound")->trigger();
  EXPECT_EQ(feedback(), QStringLiteral("A surface has no curve to play."));
}

TEST_F(PlotWordsInTheWindow, HoldingTheStylusIsSaidAndKept) {
  to_tablet();
  press(Qt::Key_F);
  EXPECT_EQ(feedback(), QStringLiteral("Snapping on: curves attract the stylus."));
  EXPECT_TRUE(controller().snapping_in_effect());
  press(Qt::Key_F);
  EXPECT_EQ(feedback(), QStringLiteral("Snapping off: the stylus moves freely."));
  EXPECT_FALSE(controller().snapping());
  press(Qt::Key_F);
  EXPECT_TRUE(kept("snapping").toBool());
}

TEST_F(PlotWordsInTheWindow, PiecesAreHeldOneByOneAndAllAgain) {
  type(QStringLiteral("y = 1; y = -1"));
  to_tablet();
  press(Qt::Key_Comma);
  EXPECT_EQ(feedback(), QStringLiteral("Branch 2 of 2: y equals minus 1"));
  press(Qt::Key_Comma);
  EXPECT_EQ(feedback(), QStringLiteral("Branch 1 of 2: y equals 1"));
  EXPECT_EQ(controller().current_stroke(), 1);
  press(Qt::Key_0);
  EXPECT_EQ(feedback(), QStringLiteral("2 branches"));
  EXPECT_EQ(controller().current_stroke(), 0);
}

TEST_F(PlotWordsInTheWindow, TheWindowIsMovedByAQuarterAndSaid) {
  type(QStringLiteral("y = 1"));
  to_tablet();
  const std::pair<Qt::Key, functions::Window> moves[] = {{Qt::Key_Left, {-9, 3, -4, 4}},
                                                         {Qt::Key_Up, {-9, 3, -2, 6}},
                                                         {Qt::Key_Right, {-6, 6, -2, 6}},
                                                         {Qt::Key_Down, {-6, 6, -4, 4}}};
  for (const auto& [key, window] : moves) {
    press(key, Qt::ShiftModifier);
    EXPECT_EQ(feedback(), window_words(window) + u'.');
    ASSERT_TRUE(wait_for_drawing());
    EXPECT_EQ(shown().request.window, window);
  }
  press(Qt::Key_Z, Qt::ShiftModifier);
  ASSERT_TRUE(wait_for_drawing());
  EXPECT_EQ(shown().request.window, (functions::Window{-12, 12, -8, 8})) << "about the middle";
  EXPECT_EQ(find<QLineEdit>("window_x0")->text(), QStringLiteral("-12"));
  window(-2, 2, -1, 3);
  to_tablet();
  press(Qt::Key_Z);
  press(Qt::Key_W);
  ASSERT_TRUE(wait_for_drawing());
  EXPECT_EQ(shown().request.window, (functions::Window{-2, 2, -1, 3})) << "as it was typed";
  EXPECT_EQ(kept("y1").toDouble(), 3);
}

TEST_F(PlotWordsInTheWindow, AWindowThatCannotBeSmallerStaysAsItIs) {
  type(QStringLiteral("y = 1"));
  window(1, 2, 0, 3);
  to_tablet();
  const QString no_further = QStringLiteral("The range cannot be changed any further.");
  for (int i = 0; i < 100 && feedback() != no_further; ++i) press(Qt::Key_Z);
  EXPECT_EQ(feedback(), no_further);
}

TEST_F(PlotWordsInTheWindow, AStoppedDrawingIsSaidToBeOneUntilTheNext) {
  find<QLineEdit>("expression")->setText(QStringLiteral("e^(sin x + cos y) = sin(e^(x + y))"));
  ASSERT_TRUE(the_functions->is_drawing());
  to_tablet();
  const QString stopped = QStringLiteral("The drawing was stopped and may be incomplete.");
  ASSERT_TRUE(
      QTest::qWaitFor([] { return the_functions->shown() && !the_functions->shown()->final; }, 30'000));
  press(Qt::Key_S);
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("The curve is still being drawn. x from ")))
      << feedback().toStdString();
  press(Qt::Key_Escape);
  EXPECT_EQ(feedback(), stopped);
  EXPECT_FALSE(the_functions->is_drawing());
  press(Qt::Key_S);
  EXPECT_TRUE(feedback().startsWith(stopped + QStringLiteral(" x from "))) << feedback().toStdString();
  EXPECT_TRUE(text("plot_summary").startsWith(QStringLiteral("The drawing was stopped before")));
  action("plot_export_raw")->trigger();
  EXPECT_EQ(feedback(), QStringLiteral("There is no plot to save yet."));
  type(QStringLiteral("y = 1"));
  to_tablet();
  press(Qt::Key_S);
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("y equals 1"))) << feedback().toStdString();
}

TEST_F(PlotWordsInTheWindow, WhatWasKeptIsHeldWithinWhatItCanBe) {
  set_up_with({{"half_width", 1.0}, {"size", 5}, {"speed", 99}, {"x0", 5}, {"x1", -5}});
  EXPECT_DOUBLE_EQ(find<QDoubleSpinBox>("groove_width")->value(), 10);
  EXPECT_EQ(find<QComboBox>("plate_size")->currentText(), QStringLiteral("128"));
  EXPECT_EQ(shown().request.window, (functions::Window{-6, 6, -4, 4})) << "this one cannot be";
  to_tablet();
  press(Qt::Key_Plus);
  EXPECT_EQ(feedback(), QStringLiteral("Speed 10 of 10"));
  set_up_with({{"half_width", 1e-5}, {"size", 256}, {"speed", -4}, {"x0", 0}, {"x1", QStringLiteral("nan")}});
  EXPECT_DOUBLE_EQ(find<QDoubleSpinBox>("groove_width")->value(), 0.4);
  EXPECT_EQ(shown().request.plate.size, 256);
  EXPECT_EQ(shown().request.window, (functions::Window{0, 6, -4, 4})) << "the other border is as at first";
  to_tablet();
  press(Qt::Key_Minus);
  EXPECT_EQ(feedback(), QStringLiteral("Speed 1 of 10"));
}

TEST_F(PlotWordsInTheWindow, EveryLayerAndSizeIsKept) {
  for (const char* layer : {"layer_ticks", "layer_grid", "layer_rim"}) find<QCheckBox>(layer)->click();
  find<QDoubleSpinBox>("groove_width")->setValue(5);
  auto* size = find<QComboBox>("plate_size");
  size->setCurrentIndex(0);
  emit size->activated(0);
  window(-1, 2, -3, 4);
  EXPECT_FALSE(kept("ticks").toBool());
  EXPECT_TRUE(kept("grid").toBool());
  EXPECT_FALSE(kept("rim").toBool());
  EXPECT_TRUE(kept("axes").toBool());
  EXPECT_NEAR(kept("half_width").toDouble(), 0.025, 1e-12);
  EXPECT_EQ(kept("size").toInt(), 128);
  EXPECT_EQ(kept("x0").toDouble(), -1);
  EXPECT_EQ(kept("x1").toDouble(), 2);
  EXPECT_EQ(kept("y0").toDouble(), -3);
  EXPECT_EQ(kept("y1").toDouble(), 4);
}

TEST_F(PlotWordsInTheWindow, KeysPutTheStylusIntoTheGrooveAndAHandTakesItOver) {
  type(QStringLiteral("y = x^2 - 1"));
  to_tablet();
  const auto lies_at = [&](double x, double y) {
    const auto wanted = on_tablet(x, y);
    return QTest::qWaitFor(
        [&] {
          const auto& now = controller().latest();
          return now.touching && std::hypot(now.device_m.x - wanted.x, now.device_m.y - wanted.y) < 1e-4;
        },
        20'000);
  };
  press(Qt::Key_N);
  EXPECT_TRUE(lies_at(the_functions->location()->x, the_functions->location()->y));
  press(Qt::Key_End);
  EXPECT_TRUE(lies_at(the_functions->location()->x, the_functions->location()->y));
  for (int i = 0; i < 3; ++i) press(Qt::Key_Left);
  EXPECT_TRUE(lies_at(the_functions->location()->x, the_functions->location()->y));
  const QString before = feedback();
  const auto zero = on_tablet(-1, 0);
  controller().move_stylus(zero, false);
  controller().move_stylus(zero, true);
  EXPECT_TRUE(QTest::qWaitFor([&] { return feedback() != before; }, 20'000));
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("zero at x = minus 1"))) << feedback().toStdString();
}

}  // namespace
}  // namespace nazori::ui
