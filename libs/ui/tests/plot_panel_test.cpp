// SPDX-License-Identifier: Apache-2.0
#include "functions/plot_panel.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QProgressBar>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <numbers>

#include "functions/expression_line.h"

namespace nazori::ui {
namespace {

class PlotPanelByHand : public testing::Test {
 protected:
  PlotPanelByHand() {
    // Windows of other tests leave theirs.
    qApp->setStyleSheet({});
    QApplication::setFont(QFont());
    panel_.resize(420, 900);
    panel_.show_window({-6, 6, -4, 4});
    panel_.show();
    QObject::connect(&panel_, &PlotPanel::plate_changed, &panel_,
                     [this](const functions::PlateSettings& plate) { plates_.push_back(plate); });
    QObject::connect(&panel_, &PlotPanel::window_typed, &panel_,
                     [this](const functions::Window& window) { windows_.push_back(window); });
  }
  template <class T = QLineEdit>
  T* find(const char* name) {
    return panel_.findChild<T*>(QString::fromLatin1(name));
  }
  void type(const char* field, const QString& text, bool enters = true) {
    auto* line = find(field);
    line->selectAll();
    if (text.isEmpty())
      QTest::keyClick(line, Qt::Key_Delete);
    else
      QTest::keyClicks(line, text);
    if (enters) QTest::keyClick(line, Qt::Key_Return);
  }

  PlotPanel panel_;
  std::vector<functions::PlateSettings> plates_;
  std::vector<functions::Window> windows_;
};

TEST_F(PlotPanelByHand, EachExampleComesWithAWindowThatShowsItWell) {
  const std::pair<const char*, functions::Window> all[] = {
      {"y = sin x", {-5, 5, -5, 5}},
      {"y = tan(x); y = sin x", {-6, 6, -4, 4}},
      {"y = x^3 - 3x", {-3, 3, -4, 4}},
      {"y = 1/x", {-5, 5, -5, 5}},
      {"y = |x| - 1", {-3, 3, -2, 2}},
      {"y = floor(x)", {-3.5, 3.5, -4.5, 4.5}},
      {"y = e^x; y = ln x", {-4, 4, -4, 4}},
      {"y = x^2; y = 2 - x^2", {-3, 3, -3, 5}},
      {"x^2 + y^2 = 4", {-3, 3, -3, 3}},
      {"y^2 = x^3 - x", {-2, 3, -3, 3}},
      {"x = cos(3t); y = sin(2t); 0 <= t <= 2π", {-1.5, 1.5, -1.5, 1.5}},
      {"r = 2cos(3θ); 0 <= θ <= π", {-2.5, 2.5, -2.5, 2.5}},
      {"y > x^2", {-3, 3, -1, 5}},
      {"z = sin(x) cos(y)", {-std::numbers::pi, std::numbers::pi, -std::numbers::pi, std::numbers::pi}},
  };
  auto* examples = find<QComboBox>("examples");
  ASSERT_EQ(examples->count(), static_cast<int>(std::size(all)) + 1);
  EXPECT_EQ(examples->itemText(0), QStringLiteral("Examples…"));
  std::vector<std::pair<QString, functions::Window>> chosen;
  QObject::connect(&panel_, &PlotPanel::example_chosen, &panel_,
                   [&](const QString& expression, const functions::Window& window) {
                     chosen.emplace_back(expression, window);
                   });
  emit examples->activated(0);
  EXPECT_TRUE(chosen.empty()) << "the heading is no example";
  for (int row = 1; row < examples->count(); ++row) {
    const auto& [expression, window] = all[row - 1];
    EXPECT_EQ(examples->itemText(row), QString::fromUtf8(expression));
    emit examples->activated(row);
    ASSERT_EQ(chosen.size(), static_cast<std::size_t>(row));
    EXPECT_EQ(chosen.back().first, QString::fromUtf8(expression));
    EXPECT_EQ(chosen.back().second, window) << expression;
  }
}

TEST_F(PlotPanelByHand, NamesStandAboveTheirFieldsBelowElevenLettersOfRoom) {
  QFont font = panel_.font();
  font.setPixelSize(28);
  panel_.setFont(font);
  int narrow = 0, wide = 0;
  for (int width = 300; width <= 420; ++width) {
    panel_.resize(width, 900);
    QCoreApplication::sendPostedEvents();
    const bool above = panel_.viewport()->width() - 2 * 16 < 11 * 28;
    EXPECT_EQ(panel_.widget()->layout()->contentsMargins(),
              above ? QMargins(4, 16, 4, 16) : QMargins(16, 16, 16, 16))
        << width;
    ++(above ? narrow : wide);
  }
  EXPECT_GT(narrow, 0);
  EXPECT_GT(wide, 0);
}

TEST_F(PlotPanelByHand, TheBordersAreThoseOfTheWindow) {
  panel_.show_window({-1.5, 2, -1000000, 0.001});
  EXPECT_EQ(find("window_x0")->text(), QStringLiteral("-1.5"));
  EXPECT_EQ(find("window_x1")->text(), QStringLiteral("2"));
  EXPECT_EQ(find("window_y0")->text(), QStringLiteral("-1000000"));
  EXPECT_EQ(find("window_y1")->text(), QStringLiteral("0.001"));
  EXPECT_TRUE(windows_.empty()) << "shown, not typed";
}

TEST_F(PlotPanelByHand, ATypedBorderChangesThatBorderAlone) {
  type("window_x0", QStringLiteral("-2pi"));
  type("window_x1", QStringLiteral("1/4"));
  type("window_y0", QStringLiteral("-7"));
  type("window_y1", QStringLiteral("9"));
  ASSERT_EQ(windows_.size(), 4U);
  EXPECT_EQ(windows_[0], (functions::Window{-2 * std::numbers::pi, 6, -4, 4}));
  EXPECT_EQ(windows_[1], (functions::Window{-6, 0.25, -4, 4})) << "the first was not taken over";
  EXPECT_EQ(windows_[2], (functions::Window{-6, 6, -7, 4}));
  EXPECT_EQ(windows_[3], (functions::Window{-6, 6, -4, 9}));
}

TEST_F(PlotPanelByHand, ABorderThatIsTypedAsItWasIsNoOtherWindow) {
  type("window_x1", QStringLiteral("6"));
  QTest::keyClick(find("window_y0"), Qt::Key_Return);
  EXPECT_TRUE(windows_.empty());
}

TEST_F(PlotPanelByHand, ABorderThatIsNoNumberIsToldAndTakenBack) {
  QSignalSpy refused(&panel_, &PlotPanel::window_refused);
  for (const char* text : {"x + 1", "1; 2", "y = x", "1/0", "="}) {
    type("window_x1", QString::fromLatin1(text));
    ASSERT_EQ(refused.count(), 1) << text;
    EXPECT_EQ(refused.takeFirst().at(0).toString(), QString::fromLatin1(text));
    EXPECT_EQ(find("window_x1")->text(), QStringLiteral("6"));
  }
  EXPECT_TRUE(windows_.empty());
}

TEST_F(PlotPanelByHand, HeightsAreARangeOnceBothEndsAreThere) {
  panel_.show_surface(true);
  type("window_z0", QStringLiteral("-2"));
  EXPECT_TRUE(plates_.empty()) << "still being typed";
  type("window_z1", QStringLiteral("5"));
  ASSERT_EQ(plates_.size(), 1U);
  ASSERT_TRUE(plates_[0].heights);
  EXPECT_EQ(plates_[0].heights->low, -2);
  EXPECT_EQ(plates_[0].heights->high, 5);
  QTest::keyClick(find("window_z1"), Qt::Key_Return);
  EXPECT_EQ(plates_.size(), 1U) << "nothing was typed";
  type("window_z0", {});
  EXPECT_EQ(plates_.size(), 1U);
  type("window_z1", {});
  ASSERT_EQ(plates_.size(), 2U);
  EXPECT_FALSE(plates_[1].heights) << "as its values are";
}

TEST_F(PlotPanelByHand, HeightsThatAreNoRangeAreTold) {
  panel_.show_surface(true);
  QSignalSpy refused(&panel_, &PlotPanel::heights_refused);
  type("window_z0", QStringLiteral("3"), false);
  for (const char* text : {"3", "2", "wide", "1/0"}) {
    type("window_z1", QString::fromLatin1(text));
    ASSERT_EQ(refused.count(), 1) << text;
    EXPECT_EQ(refused.takeFirst().at(0).toString(), QStringLiteral("3; ") + QString::fromLatin1(text));
  }
  EXPECT_TRUE(plates_.empty());
}

TEST_F(PlotPanelByHand, HeightsStandOnlyBesideASurface) {
  for (const bool surface : {true, false}) {
    panel_.show_surface(surface);
    for (const char* name : {"window_z0", "window_z1"}) EXPECT_EQ(find(name)->isVisible(), surface);
    int names = 0;
    for (const auto* label : panel_.findChildren<QLabel*>())
      names += label->isVisible() && label->text().startsWith(QStringLiteral("z ")) ? 1 : 0;
    EXPECT_EQ(names, surface ? 2 : 0);
  }
}

TEST_F(PlotPanelByHand, ThePlateIsShownAsItIsAndNothingIsToldOfIt) {
  functions::PlateSettings plate;
  plate.layers = {false, true, true, false};
  plate.half_width = 0.02;  // 4 mm of a tablet of 100
  plate.size = 1024;
  plate.heights = functions::HeightRange{-1.5, 2.25};
  panel_.show_plate(plate);
  EXPECT_FALSE(find<QCheckBox>("layer_axes")->isChecked());
  EXPECT_TRUE(find<QCheckBox>("layer_ticks")->isChecked());
  EXPECT_TRUE(find<QCheckBox>("layer_grid")->isChecked());
  EXPECT_FALSE(find<QCheckBox>("layer_rim")->isChecked());
  EXPECT_DOUBLE_EQ(find<QDoubleSpinBox>("groove_width")->value(), 4);
  EXPECT_EQ(find<QComboBox>("plate_size")->currentText(), QStringLiteral("1024"));
  EXPECT_EQ(find("window_z0")->text(), QStringLiteral("-1.5"));
  EXPECT_EQ(find("window_z1")->text(), QStringLiteral("2.25"));
  plate.layers = {true, false, false, true};
  plate.heights.reset();
  plate.size = 300;  // none of those there are
  panel_.show_plate(plate);
  EXPECT_TRUE(find<QCheckBox>("layer_axes")->isChecked());
  EXPECT_FALSE(find<QCheckBox>("layer_ticks")->isChecked());
  EXPECT_FALSE(find<QCheckBox>("layer_grid")->isChecked());
  EXPECT_TRUE(find<QCheckBox>("layer_rim")->isChecked());
  EXPECT_EQ(find("window_z0")->text(), QString());
  EXPECT_EQ(find("window_z1")->text(), QString());
  EXPECT_EQ(find<QComboBox>("plate_size")->currentIndex(), 0);
  EXPECT_TRUE(plates_.empty());
}

TEST_F(PlotPanelByHand, EachSwitchAndSizeOfThePlateIsTold) {
  panel_.show_plate({});
  const auto layers = [&] {
    const auto& l = plates_.back().layers;
    return std::array{l.axes, l.ticks, l.grid, l.rim};
  };
  find<QCheckBox>("layer_axes")->click();
  EXPECT_EQ(layers(), (std::array{false, true, false, true}));
  find<QCheckBox>("layer_ticks")->click();
  EXPECT_EQ(layers(), (std::array{false, false, false, true}));
  find<QCheckBox>("layer_grid")->click();
  EXPECT_EQ(layers(), (std::array{false, false, true, true}));
  find<QCheckBox>("layer_rim")->click();
  EXPECT_EQ(layers(), (std::array{false, false, true, false}));
  EXPECT_EQ(plates_.back().size, 512);
  find<QDoubleSpinBox>("groove_width")->setValue(5);
  EXPECT_NEAR(plates_.back().half_width, 0.025, 1e-12);
  auto* size = find<QComboBox>("plate_size");
  QStringList sizes;
  for (int row = 0; row < size->count(); ++row) sizes.append(size->itemText(row));
  EXPECT_EQ(sizes.join(u' '), QStringLiteral("128 256 512 1024 2048"));
  size->setCurrentIndex(4);
  emit size->activated(4);
  EXPECT_EQ(plates_.back().size, 2048);
  EXPECT_EQ(plates_.size(), 6U);
}

TEST_F(PlotPanelByHand, AGrooveIsFrom0_4To10MillimetresWide) {
  auto* width = find<QDoubleSpinBox>("groove_width");
  width->setValue(0.1);
  EXPECT_DOUBLE_EQ(width->value(), 0.4);
  width->stepUp();
  EXPECT_DOUBLE_EQ(width->value(), 0.5);
  width->setValue(50);
  EXPECT_DOUBLE_EQ(width->value(), 10);
  EXPECT_EQ(width->suffix(), QStringLiteral(" mm"));
  // A number on its way to being typed is no width yet.
  plates_.clear();
  width->selectAll();
  QTest::keyClicks(width, QStringLiteral("2"));
  EXPECT_TRUE(plates_.empty());
  QTest::keyClick(width, Qt::Key_Return);
  ASSERT_EQ(plates_.size(), 1U);
  EXPECT_NEAR(plates_.back().half_width, 0.01, 1e-12);
}

TEST_F(PlotPanelByHand, TheVolumeIsToldWhereAHandSetsItAndNotWhereItIsShown) {
  QSignalSpy volume(&panel_, &PlotPanel::volume_changed);
  QSignalSpy mute(&panel_, &PlotPanel::mute_changed);
  panel_.show_volume(30, true);
  auto* slider = find<QSlider>("volume");
  auto* box = find<QCheckBox>("no_sound");
  EXPECT_EQ(slider->value(), 30);
  EXPECT_TRUE(box->isChecked());
  EXPECT_EQ(volume.count() + mute.count(), 0);
  QTest::keyClick(slider, Qt::Key_PageUp);
  EXPECT_EQ(volume.takeFirst().at(0).toInt(), 40);
  slider->setValue(300);
  EXPECT_EQ(volume.takeFirst().at(0).toInt(), 100);
  slider->setValue(-5);
  EXPECT_EQ(volume.takeFirst().at(0).toInt(), 0);
  box->click();
  EXPECT_FALSE(mute.takeFirst().at(0).toBool());
}

TEST_F(PlotPanelByHand, ProgressIsThereOnlyWhileSomethingIsDrawn) {
  auto* progress = find<QProgressBar>("plot_progress");
  EXPECT_FALSE(progress->isVisible());
  panel_.show_progress(0);
  EXPECT_TRUE(progress->isVisible());
  EXPECT_EQ(progress->value(), 0);
  panel_.show_progress(0.456);
  EXPECT_EQ(progress->value(), 46);
  panel_.show_progress(1);
  EXPECT_EQ(progress->value(), progress->maximum());
  panel_.show_progress(-1);
  EXPECT_FALSE(progress->isVisible());
}

TEST_F(PlotPanelByHand, AMistakeTakesThePlaceOfTheWordsAndTheyComeBack) {
  auto* words = find<QLabel>("expression_words");
  auto* mistake = find<QLabel>("expression_error");
  panel_.show_words(QStringLiteral("y equals x"));
  EXPECT_TRUE(words->isVisible());
  EXPECT_FALSE(mistake->isVisible());
  EXPECT_EQ(words->text(), QStringLiteral("y equals x"));
  EXPECT_EQ(words->accessibleDescription(), QStringLiteral("y equals x"));
  EXPECT_EQ(panel_.line()->accessibleDescription(), QStringLiteral("y equals x"));
  const auto wrong = functions::parse("y = x +");
  ASSERT_FALSE(wrong);
  panel_.show_error(wrong.error());
  EXPECT_FALSE(words->isVisible());
  EXPECT_TRUE(mistake->isVisible());
  EXPECT_TRUE(mistake->text().startsWith(QStringLiteral("Column 8: "))) << mistake->text().toStdString();
  EXPECT_EQ(panel_.line()->accessibleDescription(), mistake->text());
  EXPECT_EQ(panel_.line()->marked_column(), 8);
  panel_.show_words(QStringLiteral("y equals x plus 1"));
  EXPECT_TRUE(words->isVisible());
  EXPECT_FALSE(mistake->isVisible());
  EXPECT_EQ(panel_.line()->marked_column(), 0);
}

TEST_F(PlotPanelByHand, TheTabKeyGoesFromTopToBottom) {
  panel_.show_surface(true);
  panel_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&panel_));
  panel_.line()->setFocus();
  const char* order[] = {"examples",  "window_x0",    "window_x1",  "window_y0",   "window_y1",
                         "window_z0", "window_z1",    "layer_axes", "layer_ticks", "layer_grid",
                         "layer_rim", "groove_width", "plate_size", "volume",      "no_sound"};
  for (const char* name : order) {
    QTest::keyClick(panel_.focusWidget(), Qt::Key_Tab);
    ASSERT_NE(panel_.focusWidget(), nullptr);
    EXPECT_EQ(panel_.focusWidget()->objectName(), QString::fromLatin1(name));
  }
}

TEST_F(PlotPanelByHand, NamesStandAboveTheirFieldsWhereThePanelIsNarrow) {
  const auto beside = [&] {
    QCoreApplication::processEvents();
    auto* field = find("window_x0");
    for (const auto* label : panel_.findChildren<QLabel*>())
      if (label->text() == QStringLiteral("x from"))
        return label->mapTo(&panel_, QPoint(0, label->height() / 2)).y() >
               field->mapTo(&panel_, QPoint(0, 0)).y();
    ADD_FAILURE() << "no name";
    return false;
  };
  EXPECT_TRUE(beside());
  panel_.resize(130, 900);
  EXPECT_FALSE(beside());
  panel_.resize(420, 900);
  EXPECT_TRUE(beside());
}

TEST_F(PlotPanelByHand, EachFieldIsSeenBelowTheOneBeforeAtAnyWidth) {
  for (const int width : {420, 230, 130})
    for (const bool surface : {true, false}) {
      panel_.resize(width, 900);
      panel_.show_surface(surface);
      QCoreApplication::processEvents();
      std::vector<const char*> shown{"window_x0", "window_x1", "window_y0", "window_y1"};
      if (surface) shown.insert(shown.end(), {"window_z0", "window_z1"});
      shown.insert(shown.end(), {"layer_axes", "layer_rim", "groove_width", "plate_size"});
      int bottom = 0;
      for (const char* name : shown) {
        const auto* field = find<QWidget>(name);
        ASSERT_TRUE(field->isVisible()) << name << " at " << width;
        const int top = field->mapTo(find<QWidget>("plot_content"), QPoint(0, 0)).y();
        EXPECT_GE(top, bottom) << name << " at " << width;
        EXPECT_GE(field->height(), field->minimumSizeHint().height()) << name << " at " << width;
        bottom = top + field->height();
      }
      EXPECT_EQ(find("window_z0")->isVisible(), surface);
    }
}

TEST_F(PlotPanelByHand, EveryFieldHasANameForTheScreenReader) {
  const std::pair<const char*, const char*> names[] = {
      {"expression", "Expression"},
      {"examples", "Examples"},
      {"window_x0", "x from"},
      {"window_x1", "x to"},
      {"window_y0", "y from"},
      {"window_y1", "y to"},
      {"window_z0", "z from"},
      {"window_z1", "z to"},
      {"plate_size", "Samples per side"},
      {"volume", "Volume"},
      {"groove_width", "Groove width in millimetres"},
      {"plot_progress", "Drawing"},
  };
  for (const auto& [field, name] : names)
    EXPECT_EQ(find<QWidget>(field)->accessibleName(), QString::fromLatin1(name)) << field;
}

}  // namespace
}  // namespace nazori::ui
