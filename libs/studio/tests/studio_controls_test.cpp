// SPDX-License-Identifier: Apache-2.0
// Controls of the pages and dialogs for making something, each alone: their ranges, steps and signs.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFontInfo>
#include <QFormLayout>
#include <QLabel>
#include <QListWidget>
#include <QSignalSpy>
#include <cmath>

#include "in_english.h"
#include "nazori/studio/brush/brush_cursor.h"
#include "nazori/studio/brush/tools_panel.h"
#include "nazori/studio/print/machine_options.h"
#include "nazori/studio/workshop/workshop_actions.h"
#include "nazori/studio/workshop/workshop_panel.h"
#include "nazori/studio/workshop/workshop_words.h"
#include "painting_under_test.h"
#include "picture_under_test.h"
#include "print_qt.h"

namespace nazori::ui {
namespace {

class OptionsOfMachines : public testing::Test {
 protected:
  OptionsOfMachines() {
    test::speak_english();
    options_.load({});
  }
  template <class T = QDoubleSpinBox>
  T* find(const char* name) {
    return window_.findChild<T*>(QString::fromLatin1(name));
  }
  QWidget window_;
  QFormLayout form_{&window_};
  MachineOptions options_{form_, nullptr};
};

TEST_F(OptionsOfMachines, EachNumberHasTheRangeOfTheMachineAndAStepThatFitsIt) {
  struct Row {
    const char *name, *suffix;
    double low, high, step, usual;
    int decimals;
  };
  const Row rows[] = {{"solid_depth", " mm", 0.1, 5, 0.5, model::TabletPlateSettings().depth_mm, 1},
                      {"solid_cutter", " mm", 0.2, 20, 0.5, 3, 2},
                      {"solid_pass", " mm", 0.05, 50, 0.5, 1.5, 2},
                      {"solid_step_over", " mm", 0.02, 5, 0.05, 0.2, 2},
                      {"solid_feed", " mm/min", 10, 20'000, 50, 800, 0},
                      {"solid_plunge", " mm/min", 10, 20'000, 50, 250, 0},
                      {"solid_safe", " mm", 1, 100, 1, 5, 1},
                      {"solid_spindle", " rpm", 0, 60'000, 500, 12'000, 0}};
  for (const Row& row : rows) {
    const auto* spin = find(row.name);
    ASSERT_NE(spin, nullptr) << row.name;
    EXPECT_EQ(spin->minimum(), row.low) << row.name;
    EXPECT_EQ(spin->maximum(), row.high) << row.name;
    EXPECT_EQ(spin->singleStep(), row.step) << row.name;
    EXPECT_EQ(spin->value(), row.usual) << row.name;
    EXPECT_EQ(spin->decimals(), row.decimals) << row.name;
    EXPECT_EQ(spin->suffix(), QString::fromLatin1(row.suffix)) << row.name;
    EXPECT_FALSE(spin->accessibleName().isEmpty());
    EXPECT_FALSE(spin->accessibleName().contains(QLatin1Char('&'))) << row.name;
    const auto* label = qobject_cast<QLabel*>(form_.labelForField(find(row.name)));
    ASSERT_NE(label, nullptr);
    EXPECT_EQ(label->text().remove(QLatin1Char('&')), spin->accessibleName());
  }
  for (const char* name : {"solid_columns", "solid_lines"}) {
    EXPECT_EQ(find<QSpinBox>(name)->minimum(), 12) << name;
    EXPECT_EQ(find<QSpinBox>(name)->maximum(), 100) << name;
  }
  EXPECT_EQ(find<QSpinBox>("solid_layers")->minimum(), 1);
  EXPECT_EQ(find<QSpinBox>("solid_layers")->maximum(), 64);
  EXPECT_EQ(find<QComboBox>("solid_paper")->count(), 3);
  EXPECT_EQ(find<QComboBox>("solid_paper")->minimumContentsLength(), 12);
  EXPECT_EQ(find<QComboBox>("solid_english")->count(), 2);
}

TEST_F(OptionsOfMachines, AreWhatTheMachinesGetAndAreKept) {
  const std::pair<const char*, double> numbers[] = {
      {"solid_depth", 2.5}, {"solid_cutter", 4},   {"solid_pass", 2}, {"solid_step_over", 0.5},
      {"solid_feed", 900},  {"solid_plunge", 300}, {"solid_safe", 7}, {"solid_spindle", 9000}};
  const QSignalSpy deeper(&options_, &MachineOptions::depth_changed);
  for (const auto& [name, value] : numbers) find(name)->setValue(value);
  EXPECT_EQ(deeper.count(), 1) << "of the depth alone";
  find<QSpinBox>("solid_layers")->setValue(9);
  find<QSpinBox>("solid_columns")->setValue(33);
  find<QSpinBox>("solid_lines")->setValue(22);
  find<QComboBox>("solid_paper")->setCurrentIndex(2);
  find<QComboBox>("solid_english")->setCurrentIndex(1);
  base::Settings kept;
  options_.store(kept);
  const auto expect_all = [](const MachineOptions& options) {
    const auto machines = options.machines();
    EXPECT_EQ(options.depth_mm(), 2.5);
    EXPECT_EQ(machines.mill.cutter_mm, 4);
    EXPECT_EQ(machines.mill.pass_depth_mm, 2);
    EXPECT_EQ(machines.mill.step_over_mm, 0.5);
    EXPECT_EQ(machines.mill.feed_mm_min, 900);
    EXPECT_EQ(machines.mill.plunge_mm_min, 300);
    EXPECT_EQ(machines.mill.safe_mm, 7);
    EXPECT_EQ(machines.mill.spindle_rpm, 9000);
    EXPECT_EQ(machines.layers, 9);
    EXPECT_EQ(machines.embosser.columns, 33);
    EXPECT_EQ(machines.embosser.lines, 22);
    EXPECT_EQ(machines.paper, print::Paper::letter);
    EXPECT_EQ(static_cast<int>(machines.english), 1);
  };
  expect_all(options_);
  QWidget other;
  QFormLayout form(&other);
  MachineOptions read(form, nullptr);
  read.load(kept);
  expect_all(read);
}

TEST_F(OptionsOfMachines, OnlyThoseOfWhatIsMadeAreShown) {
  using Made = MachineOptions::Made;
  const auto shown = [this] {
    QStringList names;
    for (int row = 0; row < form_.rowCount(); ++row)
      if (form_.isRowVisible(row))
        names.append(form_.itemAt(row, QFormLayout::FieldRole)->widget()->objectName());
    return names.join(QLatin1Char(' ')).toStdString();
  };
  options_.show_for(Made::grooved_tablet);
  EXPECT_EQ(shown(),
            "solid_depth solid_cutter solid_pass solid_step_over solid_feed solid_plunge solid_safe "
            "solid_spindle solid_layers");
  options_.show_for(Made::raised_tablet);
  EXPECT_EQ(shown(), "solid_paper solid_english solid_columns solid_lines");
  options_.show_for(Made::plot);
  EXPECT_EQ(shown(), "solid_paper solid_columns solid_lines");
  options_.show_for(Made::surface);
  EXPECT_EQ(shown(), "");
}

TEST(ToolOfTheWorkshop, IsSetInStepsThatAHandNotices) {
  test::speak_english();
  QWidget window;
  const WorkshopActions actions(&window);
  const WorkshopPanel panel(actions, &window);
  const auto* width = panel.findChild<QDoubleSpinBox*>(QStringLiteral("workshop_width"));
  const auto* depth = panel.findChild<QSpinBox*>(QStringLiteral("workshop_depth"));
  EXPECT_EQ(width->minimum(), 0.5);
  EXPECT_EQ(width->maximum(), 40);
  EXPECT_EQ(width->singleStep(), 0.5);
  EXPECT_EQ(width->decimals(), 1);
  EXPECT_EQ(depth->minimum(), 5);
  EXPECT_EQ(depth->maximum(), 100);
  EXPECT_EQ(depth->singleStep(), 5);
  EXPECT_EQ(depth->suffix(), QStringLiteral(" %"));
  EXPECT_EQ(panel.sizeHint().height(), 400);
  EXPECT_EQ(panel.findChild<QListWidget*>(QStringLiteral("workshop_strokes_list"))->minimumHeight(),
            9 * QFontInfo(panel.font()).pixelSize());
}

TEST(InkInTheBrush, IsABarAsLongAsTheBrushIsFullInTheColourOfItsInk) {
  InkGauge gauge(nullptr);
  QFont font;
  font.setPixelSize(16);
  gauge.setFont(font);
  EXPECT_EQ(gauge.sizeHint(), QSize(120, 18));
  gauge.resize(102, 24);
  calligraphy::SheetState state;
  state.fullness = 0;
  gauge.show_state(state);
  const QString rim =
      test::box_words({1, 2, 100, 20}, 10, QStringLiteral("edge 1"), test::name_of(QColor(250, 247, 240)));
  EXPECT_EQ(test::in_words(test::drawn_by(gauge).all), QStringList{rim});
  state.fullness = 0.5;
  state.strength = 0.25;
  state.ink = "vermilion";
  gauge.show_state(state);
  const auto drawn = test::drawn_by(gauge).all;
  ASSERT_EQ(drawn.size(), 2U);
  EXPECT_EQ(test::in_words(drawn[1]),
            test::box_words({3, 4, 96, 16}, 8, QStringLiteral("none"),
                            test::name_of(blend(QColor(198, 216, 232), QColor(196, 62, 38), 0.25))));
  const QImage seen = test::picture_of(gauge);
  EXPECT_TRUE(test::is(seen, {40, 12}, drawn[1].fill.color()));
  EXPECT_TRUE(test::is(seen, {60, 12}, QColor(250, 247, 240))) << "the empty half";
}

TEST(ColourOfInk, IsThatOfTheStoneOrOfTheStick) {
  const std::pair<const char*, QColor> all[] = {{"vermilion", QColor(196, 62, 38)},
                                                {"sumi-blue", QColor(24, 30, 46)},
                                                {"sumi-brown", QColor(48, 34, 24)},
                                                {"water", QColor(120, 108, 98)},
                                                {"sumi", QColor(28, 26, 25)}};
  for (const auto& [ink, colour] : all) EXPECT_EQ(colour_of_ink(ink), colour) << ink;
}

TEST(BrushAboveThePaper, IsDrawnWithinItsBoundsAndStandsOnTheSideOfTheHand) {
  calligraphy::BrushShape brush;
  brush.shaft_m = 0.008;
  brush.touches = true;
  brush.pen = {0, 0};
  for (int i = 0; i < 5; ++i) {
    brush::TuftSection section;
    section.at = {0, 0};
    section.z_m = 0.02 * (4 - i) / 4;
    section.half_width_m = 0.004 * (4 - i) / 4;
    brush.sections.push_back(section);
  }
  const QPointF pen(200, 300);
  constexpr double kPerM = 4000;
  for (const bool left : {false, true}) {
    const auto drawn = test::drawn_by(QSize(800, 800), [&](QPainter& painter) {
      paint_brush(painter, brush, Qt::black, pen, kPerM, left);
    });
    const QRectF bounds = brush_bounds(brush, pen, kPerM);
    QRectF all;
    for (const auto& one : drawn.all) all = all.united(one.box);
    EXPECT_TRUE(bounds.contains(all)) << left;
    // The shaft goes up from the root of the hair, a metre of height 0.42 up and 0.2 to the side.
    const auto shaft = drawn.all.back();
    const double side = left ? -1 : 1;
    const QPointF root = pen + QPointF(side * 0.2, -0.42) * 0.02 * kPerM;
    const QPointF end = root + QPointF(side * 0.2, -0.42) * 0.075 * kPerM;
    ASSERT_EQ(shaft.points.size(), 4);
    const QPointF low = (shaft.points[0] + shaft.points[1]) / 2,
                  high = (shaft.points[2] + shaft.points[3]) / 2;
    EXPECT_NEAR(low.x(), root.x(), 0.01);
    EXPECT_NEAR(low.y(), root.y(), 0.01);
    EXPECT_NEAR(high.x(), end.x(), 0.01);
    EXPECT_NEAR(high.y(), end.y(), 0.01);
    const auto width = [](QPointF a, QPointF b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); };
    EXPECT_NEAR(width(shaft.points[0], shaft.points[1]), 0.008 * kPerM, 0.01);
    EXPECT_NEAR(width(shaft.points[2], shaft.points[3]), 0.8 * 0.008 * kPerM, 0.01);
  }
  brush.sections.resize(1);
  EXPECT_TRUE(test::drawn_by(QSize(9, 9), [&](QPainter& painter) {
                paint_brush(painter, brush, Qt::black, pen, kPerM, false);
              }).all.empty());
}

TEST(FindingsOfACheck, HaveASignForHowMuchTheyMatter) {
  test::speak_english();
  QWidget window;
  const WorkshopActions actions(&window);
  WorkshopPanel panel(actions, &window);
  const auto* list = panel.findChild<QListWidget*>(QStringLiteral("workshop_findings"));
  const std::vector<author::Finding> findings{
      {.kind = author::FindingKind::no_strokes, .severity = author::Severity::error},
      {.kind = author::FindingKind::too_shallow, .severity = author::Severity::warning, .stroke = 2},
      {.kind = author::FindingKind::no_name, .severity = author::Severity::note}};
  panel.show_findings(findings, true);
  ASSERT_EQ(list->count(), 3);
  EXPECT_EQ(list->item(0)->text(), QStringLiteral("✗ There are no strokes."));
  EXPECT_EQ(list->item(1)->text(), QStringLiteral("⚠ Stroke 3 is too shallow to feel."));
  EXPECT_EQ(list->item(2)->text(), QStringLiteral("· The character has no name."));
  EXPECT_FALSE(list->isHidden());
  const auto says = [&panel](const QString& words) {
    const auto labels = panel.findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [&](const QLabel* one) { return one->text() == words; });
  };
  EXPECT_TRUE(says(QStringLiteral("3 remarks")));
  panel.show_findings({}, true);
  EXPECT_TRUE(list->isHidden());
  EXPECT_TRUE(says(QStringLiteral("✓ Nothing was found.")));
  panel.show_findings({}, false);
  EXPECT_TRUE(says(QStringLiteral("Not checked yet.")));
}

}  // namespace
}  // namespace nazori::ui
