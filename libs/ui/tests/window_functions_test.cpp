// SPDX-License-Identifier: Apache-2.0
#include <QAbstractItemView>
#include <QAccessible>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QElapsedTimer>
#include <QFile>
#include <QLineEdit>
#include <QMenuBar>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QSlider>
#include <QStyledItemDelegate>
#include <QTableWidget>
#include <cmath>

#include "functions/expression_line.h"
#include "functions_window.h"
#include "nazori/functions/plot.h"
#include "nazori/functions/print_picture.h"
#include "nazori/widgets/controls/spoken_line.h"

namespace nazori::ui {
namespace {

using test::FunctionsWindow;
using test::the_functions;

TEST_F(FunctionsWindow, AnExpressionIsCarvedWhileItIsTyped) {
  type(QStringLiteral("y = x^2"));
  EXPECT_EQ(shown().request.plot.statements.size(), 1U);
  EXPECT_EQ(text("expression_words"), QStringLiteral("y equals x squared"));
  EXPECT_TRUE(text("plot_summary").startsWith(QStringLiteral("y equals x squared: 1 piece")))
      << text("plot_summary").toStdString();
  EXPECT_EQ(window_->windowTitle(), QStringLiteral("y = x^2 – Nazori"));
  // Where the parabola is the plate is cut, beside it not. (Window -6..6 by -4..4, samples from the top.)
  const auto& map = carved().height_map();
  const auto at = [&map](double x, double y) {
    const double n = map.size();
    return map.at(static_cast<int>((x + 6) / 12 * n), static_cast<int>((4 - y) / 8 * n));
  };
  EXPECT_LT(at(1.01, 1.01), 0.2F);
  EXPECT_GT(at(1, 3), 0.85F);
}

TEST_F(FunctionsWindow, AnErrorNamesColumnAndExpectationAndThePlateStays) {
  type(QStringLiteral("y = x"));
  auto* line = find<ExpressionLine>("expression");
  QTest::keyClicks(line, QStringLiteral(" +"));
  EXPECT_EQ(line->marked_column(), 8);
  EXPECT_TRUE(find("expression_error")->isVisible());
  EXPECT_TRUE(text("expression_error").startsWith(QStringLiteral("Column 8: ")))
      << text("expression_error").toStdString();
  EXPECT_TRUE(text("expression_error").contains(QStringLiteral("expected")));
  QTest::qWait(200);
  EXPECT_EQ(functions::canonical(shown().request.plot), "y = x");
  QTest::keyClick(line, Qt::Key_Return);
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("Column 8: ")));
  QTest::keyClicks(line, QStringLiteral(" 1"));
  EXPECT_EQ(line->marked_column(), 0);
  EXPECT_FALSE(find("expression_error")->isVisible());
  ASSERT_TRUE(wait_for_drawing());
  EXPECT_EQ(functions::canonical(shown().request.plot), "y = x + 1");
}

TEST_F(FunctionsWindow, EveryAsymptoteOfTheTangentStandsInTheTable) {
  type(QStringLiteral("y = tan(x)"));
  auto* table = find<QTableWidget>("points_table");
  int asymptotes = 0;
  QStringList places;
  for (int row = 0; row < table->rowCount(); ++row)
    if (table->item(row, 0)->text() == QLatin1String("vertical asymptote")) {
      ++asymptotes;
      places.append(table->item(row, 1)->text());
    }
  EXPECT_EQ(asymptotes, 4);
  EXPECT_TRUE(places.contains(QStringLiteral("π/2 ≈ 1.571"))) << places.join(u'|').toStdString();
}

TEST_F(FunctionsWindow, ARowOfTheTableIsGoneToWithEnterAndTold) {
  type(QStringLiteral("y = x^2 - 1"));
  press(Qt::Key_T, Qt::ControlModifier);
  auto* table = find<QTableWidget>("points_table");
  ASSERT_TRUE(table->hasFocus());
  for (int row = 0; row < table->rowCount(); ++row) {
    if (table->item(row, 0)->text() != QLatin1String("minimum")) continue;
    table->setCurrentCell(row, 0);
    QTest::keyClick(table, Qt::Key_Return);
    ASSERT_TRUE(the_functions->location());
    EXPECT_NEAR(the_functions->location()->x, 0, 1e-12);
    EXPECT_NEAR(the_functions->location()->y, -1, 1e-12);
    EXPECT_EQ(feedback(), QStringLiteral("minimum at x = 0; y = minus 1."));
    return;
  }
  FAIL() << "no minimum in the table";
}

TEST_F(FunctionsWindow, ArrowsWalkAlongTheCurveOnlyFromTheTablet) {
  type(QStringLiteral("y = x"));
  press(Qt::Key_Right);
  EXPECT_FALSE(the_functions->location());
  to_tablet();
  press(Qt::Key_Right);
  ASSERT_TRUE(the_functions->location());
  const double x = the_functions->location()->x;
  press(Qt::Key_Right);
  EXPECT_GT(the_functions->location()->x, x);
  press(Qt::Key_Left);
  EXPECT_NEAR(the_functions->location()->x, x, 1e-9);
  EXPECT_TRUE(feedback().contains(QStringLiteral("x = "))) << feedback().toStdString();
  press(Qt::Key_Right, Qt::ControlModifier);
  EXPECT_NEAR(std::remainder(the_functions->location()->x, 1.0), 0, 1e-3);
  press(Qt::Key_End);
  EXPECT_GT(the_functions->location()->x, 3.9);
  press(Qt::Key_Home);
  EXPECT_LT(the_functions->location()->x, -3.9);
}

TEST_F(FunctionsWindow, NGoesFromPointToPointAndTabLeavesTheTablet) {
  type(QStringLiteral("y = x^2 - 1"));
  to_tablet();
  press(Qt::Key_N);
  ASSERT_TRUE(the_functions->location());
  EXPECT_TRUE(find("tablet")->hasFocus());
  const double first = the_functions->location()->x;
  press(Qt::Key_N);
  EXPECT_NE(the_functions->location()->x, first);
  press(Qt::Key_N, Qt::ShiftModifier);
  EXPECT_DOUBLE_EQ(the_functions->location()->x, first);
  press(Qt::Key_Tab);
  EXPECT_FALSE(find("tablet")->hasFocus());
  EXPECT_DOUBLE_EQ(the_functions->location()->x, first);
  to_tablet();
  press(Qt::Key_Backtab, Qt::ShiftModifier);
  EXPECT_FALSE(find("tablet")->hasFocus());
  press(Qt::Key_L, Qt::ControlModifier);
  EXPECT_TRUE(find("expression")->hasFocus());
  press(Qt::Key_Tab);
  EXPECT_FALSE(find("expression")->hasFocus());
  EXPECT_DOUBLE_EQ(the_functions->location()->x, first);
}

TEST_F(FunctionsWindow, CoordinatesSlopeSummaryAndBeaconsAreTold) {
  type(QStringLiteral("y = 2x"));
  to_tablet();
  press(Qt::Key_Right);
  press(Qt::Key_Right, Qt::ControlModifier);
  press(Qt::Key_C);
  EXPECT_TRUE(feedback().contains(QStringLiteral("x = 2; y = 4"))) << feedback().toStdString();
  press(Qt::Key_D);
  EXPECT_EQ(feedback(), QStringLiteral("slope 2"));
  press(Qt::Key_B);
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("Marker 1 set"))) << feedback().toStdString();
  press(Qt::Key_Home);
  press(Qt::Key_G);
  EXPECT_NEAR(the_functions->location()->x, 2, 1e-3);
  press(Qt::Key_S);
  EXPECT_TRUE(feedback().contains(QStringLiteral("x from minus 6 to 6, one tick is ")))
      << feedback().toStdString();
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("y equals 2"))) << feedback().toStdString();
}

TEST_F(FunctionsWindow, ZoomIsAboutThePointAndDrawsAnew) {
  type(QStringLiteral("y = x^2 - 1"));
  to_tablet();
  press(Qt::Key_N);
  const double x = the_functions->location()->x;
  const auto before = shown().request.window;
  press(Qt::Key_Z);
  ASSERT_TRUE(wait_for_drawing());
  const auto after = shown().request.window;
  EXPECT_NEAR(after.x1 - after.x0, (before.x1 - before.x0) / 2, 1e-12);
  EXPECT_NEAR(after.u(x), before.u(x), 1e-12);
  press(Qt::Key_Z, Qt::ShiftModifier);
  press(Qt::Key_Right, Qt::ShiftModifier);
  ASSERT_TRUE(wait_for_drawing());
  EXPECT_NEAR(shown().request.window.x0, -3, 1e-12);
  press(Qt::Key_W);
  ASSERT_TRUE(wait_for_drawing());
  EXPECT_EQ(shown().request.window, (functions::Window{-6, 6, -4, 4}));
}

TEST_F(FunctionsWindow, BordersAreTypedAsNumbersOrExpressions) {
  auto* border = find<QLineEdit>("window_x1");
  border->setFocus();
  border->selectAll();
  QTest::keyClicks(border, QStringLiteral("2pi"));
  QTest::keyClick(border, Qt::Key_Return);
  ASSERT_TRUE(wait_for_drawing());
  EXPECT_NEAR(shown().request.window.x1, 2 * 3.14159265358979, 1e-12);
  border->setFocus();
  border->selectAll();
  QTest::keyClicks(border, QStringLiteral("-7"));
  QTest::keyClick(border, Qt::Key_Return);
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("This range cannot be shown")))
      << feedback().toStdString();
  border->selectAll();
  QTest::keyClicks(border, QStringLiteral("wide"));
  QTest::keyClick(border, Qt::Key_Return);
  EXPECT_TRUE(feedback().contains(QStringLiteral("is not a number"))) << feedback().toStdString();
  EXPECT_NEAR(shown().request.window.x1, 2 * 3.14159265358979, 1e-12);
}

TEST_F(FunctionsWindow, CurvesHoldTheStylusAsStrokesDo) {
  type(QStringLiteral("y = 1; y = -1"));
  EXPECT_EQ(carved().lines().size(), 2U);
  EXPECT_EQ(carved().paths().size(), 2U);
  // The second curve, y = -1 of -4..4, lies an eighth of the tablet below its middle.
  const auto& path = carved().paths()[1];
  for (const auto& point : path.points) EXPECT_NEAR(point.y, -0.0125, 0.0002);
  to_tablet();
  press(Qt::Key_F);
  EXPECT_TRUE(action("plot_snap")->isChecked());
  press(Qt::Key_Period);
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("Branch 1 of 2: y equals 1"))) << feedback().toStdString();
  press(Qt::Key_Period);
  press(Qt::Key_Period);
  EXPECT_EQ(feedback(), QStringLiteral("2 branches"));
}

TEST_F(FunctionsWindow, NumbersAndArrowsOfCharactersAreAsTheyWereOnComingBack) {
  press(Qt::Key_1, Qt::AltModifier);
  EXPECT_TRUE(action("numbers")->isChecked());
  EXPECT_FALSE(action("snap")->isChecked());
  press(Qt::Key_2, Qt::AltModifier);
  press(Qt::Key_F);
  press(Qt::Key_1, Qt::AltModifier);
  EXPECT_TRUE(action("numbers")->isChecked());
  EXPECT_TRUE(action("arrows")->isChecked());
  EXPECT_FALSE(action("snap")->isChecked());
}

TEST_F(FunctionsWindow, APlotIsSavedAndOpenedAgain) {
  type(QStringLiteral("y = x^3 - 3x"));
  window(-3, 3, -4, 4);
  find<QCheckBox>("layer_grid")->click();
  ASSERT_TRUE(wait_for_drawing());
  const QString path = folder_.filePath(QStringLiteral("cubic.json"));
  the_functions->write(functions::PlotFile::document, path);
  ASSERT_TRUE(QTest::qWaitFor([&path] { return QFile::exists(path); }, 10000));
  type(QStringLiteral("y = 1"));
  press(Qt::Key_1, Qt::AltModifier);
  window_->open_files({path});
  ASSERT_TRUE(QTest::qWaitFor(
      [] { return the_functions->shown()->final && the_functions->shown()->request.window.x1 == 3; }, 30000));
  ASSERT_TRUE(wait_for_drawing());
  EXPECT_EQ(find<QLineEdit>("expression")->text(), QStringLiteral("y = x^3 - 3x"));
  EXPECT_TRUE(find<QCheckBox>("layer_grid")->isChecked());
  EXPECT_TRUE(shown().request.plate.layers.grid);
}

TEST_F(FunctionsWindow, AFileThatIsNoPlotLeavesThePlateAsItIs) {
  const auto before = the_functions->shown();
  const QString path = folder_.filePath(QStringLiteral("other.json"));
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("{\"nazori_plot\": 1}");
  file.close();
  window_->open_files({path});
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("Could not open other.json"))) << feedback().toStdString();
  EXPECT_EQ(the_functions->shown(), before);
}

TEST_F(FunctionsWindow, HeightMapsPrintsAndSoundsAreWritten) {
  type(QStringLiteral("y = x"));
  const std::pair<functions::PlotFile, const char*> kinds[] = {{functions::PlotFile::raw, "plot.raw"},
                                                               {functions::PlotFile::png, "plot.png"},
                                                               {functions::PlotFile::print, "print.png"},
                                                               {functions::PlotFile::sound, "plot.wav"}};
  for (const auto& [kind, name] : kinds) {
    const QString path = folder_.filePath(QString::fromLatin1(name));
    the_functions->write(kind, path);
    ASSERT_TRUE(QTest::qWaitFor([&path] { return QFile::exists(path); }, 30000)) << name;
  }
  const auto raw = surface::load_raw(folder_.filePath(QStringLiteral("plot.raw")).toStdString());
  ASSERT_TRUE(raw);
  EXPECT_EQ(raw->size(), 512);
  const auto png = surface::load_png(folder_.filePath(QStringLiteral("plot.png")).toStdString());
  ASSERT_TRUE(png);
  EXPECT_NEAR(png->at(100, 100), shown().picture.plate.heights.at(100, 100), 1.0 / 65535);
  const auto print = surface::load_png(folder_.filePath(QStringLiteral("print.png")).toStdString());
  ASSERT_TRUE(print);
  for (const float sample : print->samples()) ASSERT_TRUE(sample == 0.0F || sample == 1.0F);
}

TEST_F(FunctionsWindow, WhatWasTypedAndSetIsThereAgainAfterARestart) {
  type(QStringLiteral("y = x/2"));
  press(Qt::Key_Return);
  find<QSlider>("volume")->setValue(30);
  find<QCheckBox>("layer_axes")->click();
  to_tablet();
  press(Qt::Key_M);
  press(Qt::Key_Plus);
  window_->close();
  QSettings saved(folder_.filePath(QStringLiteral("nazori.ini")), QSettings::IniFormat);
  saved.beginGroup(QStringLiteral("functions"));
  EXPECT_EQ(saved.value(QStringLiteral("expression")).toString(), QStringLiteral("y = x/2"));
  EXPECT_EQ(saved.value(QStringLiteral("volume")).toInt(), 30);
  EXPECT_TRUE(saved.value(QStringLiteral("muted")).toBool());
  EXPECT_FALSE(saved.value(QStringLiteral("axes")).toBool());
  EXPECT_EQ(saved.value(QStringLiteral("speed")).toInt(), 3);
  open_window(U'休');
  press(Qt::Key_2, Qt::AltModifier);
  ASSERT_TRUE(wait_for_drawing());
  auto* line = find<ExpressionLine>("expression");
  EXPECT_EQ(line->text(), QStringLiteral("y = x/2"));
  EXPECT_EQ(line->history(), QStringList{QStringLiteral("y = x/2")});
  EXPECT_EQ(find<QSlider>("volume")->value(), 30);
  EXPECT_TRUE(action("sound_mute")->isChecked());
  EXPECT_FALSE(find<QCheckBox>("layer_axes")->isChecked());
}

TEST_F(FunctionsWindow, AnExampleIsAPlotWithItsWindow) {
  auto* examples = find<QComboBox>("examples");
  examples->setFocus();
  examples->setCurrentIndex(1);
  emit examples->activated(1);
  ASSERT_TRUE(wait_for_drawing());
  EXPECT_EQ(find<QLineEdit>("expression")->text(), QStringLiteral("y = sin x"));
  EXPECT_EQ(shown().request.window, (functions::Window{-5, 5, -5, 5}));
}

TEST_F(FunctionsWindow, EveryExampleCanBeReadAndDrawn) {
  auto* examples = find<QComboBox>("examples");
  for (int row = 1; row < examples->count(); ++row) {
    emit examples->activated(row);
    ASSERT_TRUE(wait_for_drawing()) << row;
    EXPECT_EQ(find<ExpressionLine>("expression")->marked_column(), 0)
        << examples->itemText(row).toStdString();
    EXPECT_EQ(window_->windowTitle(), examples->itemText(row) + QStringLiteral(" – Nazori"));
  }
}

TEST_F(FunctionsWindow, ANewerExpressionStopsAnOlderOne) {
  auto* line = find<QLineEdit>("expression");
  // This drawing takes more than a second.
  line->setText(QStringLiteral("e^(sin x + cos y) = sin(e^(x + y))"));
  line->setText(QStringLiteral("y = 1"));
  ASSERT_TRUE(wait_for_drawing());
  EXPECT_EQ(shown().request.plot.statements[0].kind, functions::StatementKind::explicit_y);
}

TEST_F(FunctionsWindow, NoKeyIsGivenTwiceAndEveryFieldHasAName) {
  QStringList keys;
  for (const auto* entry : window_->findChildren<QAction*>())
    if (entry->isVisible())
      for (const auto& key : entry->shortcuts()) keys.append(key.toString());
  QStringList once = keys;
  once.removeDuplicates();
  for (const auto& key : once) EXPECT_EQ(keys.count(key), 1) << key.toStdString();
  for (const char* panel : {"plot_panel", "points_panel"})
    for (auto* widget : find(panel)->findChildren<QWidget*>()) {
      if ((widget->focusPolicy() & Qt::TabFocus) == 0 || !widget->isVisible()) continue;
      auto* accessible = QAccessible::queryAccessibleInterface(widget);
      ASSERT_NE(accessible, nullptr);
      EXPECT_FALSE(accessible->text(QAccessible::Name).isEmpty())
          << widget->metaObject()->className() << ' ' << widget->objectName().toStdString() << ' '
          << widget->property("text").toString().toStdString();
    }
}

TEST_F(FunctionsWindow, APlaceThatIsAskedForAgainIsSpokenAgain) {
  QSignalSpy spoken(find<SpokenLine>("spoken_line"), &SpokenLine::spoken);
  type(QStringLiteral("y = x"));
  to_tablet();
  press(Qt::Key_Right);
  // Sentences wait for one another: what still waits would be spoken together with the first answer.
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return !spoken.isEmpty() && spoken.last().first().toString().endsWith(feedback()); }));
  spoken.clear();
  for (int i = 0; i < 3; ++i) {
    press(Qt::Key_C);
    ASSERT_TRUE(QTest::qWaitFor([&] { return spoken.size() == i + 1; })) << i;
    EXPECT_EQ(spoken.last().first().toString(), feedback()) << i;
  }
}

TEST_F(FunctionsWindow, OneCurveCanBeFeltAndHeardAlone) {
  type(QStringLiteral("y = 1; y = -1"));
  to_tablet();
  press(Qt::Key_O, Qt::ShiftModifier);
  ASSERT_TRUE(wait_for_drawing());
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("Only curve 1: y equals 1"))) << feedback().toStdString();
  EXPECT_EQ(carved().lines().size(), 1U);
  press(Qt::Key_O, Qt::ShiftModifier);
  ASSERT_TRUE(wait_for_drawing());
  ASSERT_EQ(carved().lines().size(), 1U);
  for (const auto& point : carved().paths()[0].points) EXPECT_LT(point.y, 0);
  EXPECT_TRUE(shown().summary.find("y equals minus 1: 1 piece") == 0) << shown().summary;
  press(Qt::Key_O);
  ASSERT_TRUE(wait_for_drawing());
  EXPECT_EQ(carved().lines().size(), 2U);
  EXPECT_EQ(feedback(), QStringLiteral("All curves are shown."));
}

TEST_F(FunctionsWindow, EachCurveHasAFrictionOfItsOwn) {
  type(QStringLiteral("y = 1; y = -1"));
  const auto& zones = carved().friction();
  ASSERT_NE(zones, nullptr);
  const int n = zones->size;
  const auto at = [&](double y) {
    const auto row = static_cast<std::size_t>((4 - y) / 8 * n);
    return static_cast<int>(zones->zone[row * static_cast<std::size_t>(n) + static_cast<std::size_t>(n / 3)]);
  };
  EXPECT_EQ(at(1), 1);
  EXPECT_EQ(at(-1), 2);
  EXPECT_EQ(at(2.5), 0);
  ASSERT_EQ(zones->added.size(), 2U);
  EXPECT_GT(std::abs(zones->added[0] - zones->added[1]), 0.1);
  const auto scene = carved().scene({}, {});
  EXPECT_EQ(scene->friction_zones, zones);
}

TEST_F(FunctionsWindow, TheToneOfZeroIsPlayedWhereItIsInTheWindow) {
  type(QStringLiteral("y = x"));
  to_tablet();
  press(Qt::Key_Y);
  EXPECT_EQ(feedback(), QStringLiteral("This is the tone of y = 0."));
  window(-1, 1, 2, 4);
  to_tablet();
  press(Qt::Key_Y);
  EXPECT_EQ(feedback(), QStringLiteral("y = 0 is outside the range."));
}

TEST_F(FunctionsWindow, ASurfaceHasARangeOfHeights) {
  EXPECT_FALSE(find("window_z0")->isVisible());
  type(QStringLiteral("z = x"));
  EXPECT_TRUE(find("window_z0")->isVisible());
  for (const auto& [name, value] : {std::pair{"window_z0", "-12"}, std::pair{"window_z1", "12"}}) {
    auto* border = find<QLineEdit>(name);
    border->setFocus();
    border->selectAll();
    QTest::keyClicks(border, QString::fromLatin1(value));
    QTest::keyClick(border, Qt::Key_Return);
  }
  ASSERT_TRUE(wait_for_drawing());
  // x = 6 at the right border is three quarters of the way from -12 to 12.
  const auto& heights = carved().height_map();
  EXPECT_NEAR(heights.at(heights.size() - 1, heights.size() / 2), 0.75, 2e-3);
}

TEST_F(FunctionsWindow, MistakesAreToldInTheLanguageOfTheWindow) {
  install_language(QStringLiteral("ja"));
  type(QStringLiteral("y = x"));
  QTest::keyClicks(find<ExpressionLine>("expression"), QStringLiteral(" +"));
  const QString said = text("expression_error");
  install_language(QStringLiteral("en"));
  EXPECT_TRUE(said.contains(QStringLiteral("「+」の後に数や文字がありません"))) << said.toStdString();
  EXPECT_FALSE(said.contains(QStringLiteral("expected"))) << said.toStdString();
}

TEST_F(FunctionsWindow, CoordinatesAreReadWithoutWideningAnything) {
  type(QStringLiteral("y = tan(x); y = sin x"));
  auto* table = find<QTableWidget>("points_table");
  for (const int text_pt : {Preferences::kMinText_pt, Preferences::kMaxText_pt}) {
    set_text_size(text_pt);
    EXPECT_EQ(table->horizontalScrollBar()->maximum(), 0);
    // What is drawn of a row: kind and coordinates, in columns or under each other, never cut off.
    const QModelIndex first = table->model()->index(0, 0);
    const bool stacked = table->isColumnHidden(1);
    for (int column = 0; column < (stacked ? 1 : 3); ++column) {
      const QModelIndex index = first.siblingAtColumn(column);
      QStyleOptionViewItem option;
      option.font = table->font();
      option.fontMetrics = QFontMetrics(table->font());
      option.features = QStyleOptionViewItem::WrapText;
      option.rect = table->visualRect(index);
      const QSize wanted = table->itemDelegate()->sizeHint(option, index);
      EXPECT_LE(wanted.width(), table->columnWidth(column)) << column << " at " << text_pt;
      EXPECT_LE(wanted.height(), table->rowHeight(0)) << column << " at " << text_pt;
      if (stacked) {
        EXPECT_GE(wanted.height(), 2 * option.fontMetrics.height());
      }
    }
  }
}

TEST_F(FunctionsWindow, NothingIsWiderThanItsPanelInTheLargestText) {
  set_text_size(Preferences::kMaxText_pt);
  auto* panel = find<QScrollArea>("plot_panel");
  EXPECT_EQ(panel->horizontalScrollBar()->maximum(), 0)
      << widest_parts(panel->widget(), panel->viewport()->width());
  for (auto* widget : panel->findChildren<QWidget*>()) {
    if (!widget->isVisible()) continue;
    // Not the parts of its scroll bar.
    if (!panel->widget()->isAncestorOf(widget)) continue;
    const int right = widget->mapTo(panel, QPoint(widget->width(), 0)).x();
    EXPECT_LE(right, panel->viewport()->width())
        << widget->metaObject()->className() << ' ' << widget->objectName().toStdString() << ' '
        << widget->property("text").toString().toStdString();
    if (const auto* box = qobject_cast<QCheckBox*>(widget)) {
      EXPECT_GE(box->width(), box->sizeHint().width()) << box->text().toStdString();
    }
  }
}

TEST_F(FunctionsWindow, ReturnInTheListOfExamplesChoosesOne) {
  auto* examples = find<QComboBox>("examples");
  examples->setFocus();
  examples->showPopup();
  ASSERT_TRUE(QTest::qWaitFor([&] { return QApplication::activePopupWidget() != nullptr; }));
  QTest::keyClick(examples->view(), Qt::Key_Home);
  for (int i = 0; i < 4; ++i) QTest::keyClick(examples->view(), Qt::Key_Down);
  QTest::keyClick(examples->view(), Qt::Key_Return);
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return find<QLineEdit>("expression")->text() == QLatin1String("y = 1/x"); }));
  EXPECT_EQ(QApplication::activePopupWidget(), nullptr);
}

TEST_F(FunctionsWindow, TheListOfExamplesNamesOnlyWhatStandsInTheLine) {
  auto* examples = find<QComboBox>("examples");
  auto* line = find<QLineEdit>("expression");
  line->setText(QStringLiteral("y = floor(x)"));
  EXPECT_EQ(examples->currentText(), QStringLiteral("y = floor(x)"));
  line->setText(QStringLiteral("y = floor(x) + 1"));
  EXPECT_EQ(examples->currentIndex(), 0);
}

TEST_F(FunctionsWindow, APointWithoutAnExactNameIsSaidToBeAboutThere) {
  type(QStringLiteral("y = x^3 - 2x + 1"));
  set_text_size(Preferences::kMaxText_pt);
  auto* table = find<QTableWidget>("points_table");
  ASSERT_TRUE(table->isColumnHidden(1));
  QStringList shown;
  for (int row = 0; row < table->rowCount(); ++row) {
    QStyleOptionViewItem option;
    struct Open : QStyledItemDelegate {
      using QStyledItemDelegate::initStyleOption;
    };
    (static_cast<const QStyledItemDelegate*>(table->itemDelegate())->*(&Open::initStyleOption))(
        &option, table->model()->index(row, 0));
    shown.append(option.text);
  }
  const QString all = shown.join(QLatin1Char('|'));
  EXPECT_TRUE(all.contains(QStringLiteral("y ≈ 2.089"))) << all.toStdString();
  EXPECT_FALSE(all.contains(QStringLiteral("= ≈"))) << all.toStdString();
}

}  // namespace
}  // namespace nazori::ui
