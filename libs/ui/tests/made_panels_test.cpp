// SPDX-License-Identifier: Apache-2.0
// What stands where in the panels for devices and for functions, and how each part is made.
#include <QAction>
#include <QSignalSpy>

#include "described_widget.h"
#include "device/button_lines.h"
#include "device/device_actions.h"
#include "device/device_choice_panel.h"
#include "device/feel_panel.h"
#include "functions/parameter_sliders.h"
#include "functions/plot_panel.h"
#include "functions/points_panel.h"
#include "nazori/widgets/tablet/window_tablet.h"

namespace nazori::ui {
namespace {

using test::expect_laid_out;
using test::expect_made;
using test::made_words;

class MadePanels : public testing::Test {
 protected:
  MadePanels() {
    install_language(QStringLiteral("en"));
    test::use_plain_look();
  }
  QWidget window_;
  DeviceActions actions_{&window_};
};

TEST_F(MadePanels, WhatIsFeltStandsAboveTheMaterialAndTheTip) {
  WindowTablet tablet;
  const FeelPanel panel(tablet.device(), actions_, nullptr);
  expect_laid_out(
      panel,
      {{"information_content",
        "column 16 16 16 16 gap 8: “Now”, (form gap 8 3 wraps: “Tip position” | live_pose, "
        "“Buttons” | live_buttons, “Force” | live_force, “Update rate” | live_rate, "
        "“Longest delay” | live_lateness, “Missed updates” | live_missed, “Latency” | live_delay), QWidget, "
        "“Material”, NumberSlider, NumberSlider, NumberSlider, NumberSlider, NumberSlider, “Texture”, "
        "material_texture, NumberSlider, “Tip of the stylus”, NumberSlider, tip_hint, stretch*1"},
       {"around strength",
        "column 0 0 0 0: “Feel a wall and a groove”, strength, (flow gap 8 8: button_weaker, "
        "button_stronger)"}});
  const std::string unit = "accessibleDescription 0.00; accessibleName ", steps = "; maximum 20; pageStep 2";
  expect_made(
      panel, {{"feel_panel",
               "accessibleName What you feel; horizontalScrollBarPolicy ScrollBarAlwaysOff; widgetResizable"},
              {"live_pose",
               "accessibleName Tip position; textFormat PlainText; textInteractionFlags "
               "TextSelectableByMouse; wordWrap"},
              {"live_missed",
               "accessibleName Missed updates; textFormat PlainText; textInteractionFlags "
               "TextSelectableByMouse; wordWrap"},
              {"material_stiffness", (unit + "Stiffness" + steps).c_str()},
              {"material_damping", (unit + "Damping" + steps).c_str()},
              {"material_static_friction", (unit + "Static friction" + steps).c_str()},
              {"material_dynamic_friction", (unit + "Dynamic friction" + steps).c_str()},
              {"material_popthrough", (unit + "Pop-through" + steps).c_str()},
              {"material_roughness", (unit + "Roughness" + steps).c_str()},
              {"material_texture",
               "accessibleName Texture; minimumContentsLength 4; sizeAdjustPolicy "
               "AdjustToMinimumContentsLengthWithIcon"},
              {"tip_radius",
               "accessibleDescription 0.0 mm; accessibleName Radius of the ball; maximum 30; pageStep 3"},
              {"tip_hint",
               "role muted; text 0 is a point. A ball does not reach the bottom of a groove that is narrower "
               "than it.; "
               "textFormat PlainText; wordWrap"}});
  const auto* texture = panel.findChild<QComboBox*>();
  QStringList textures;
  for (int i = 0; i < texture->count(); ++i) textures.append(texture->itemText(i));
  EXPECT_EQ(textures.join(u' '), QStringLiteral("smooth paper wood stone"));
  for (const auto* label : panel.findChildren<QLabel*>())
    if (label->text() == QStringLiteral("Texture")) {
      EXPECT_EQ(label->buddy(), texture);
    }
}

TEST_F(MadePanels, DevicesStandAboveTheirFitTheirButtonsAndTheirLimits) {
  DeviceChoicePanel panel(actions_, nullptr);
  expect_laid_out(
      panel, {{"information_content",
               "column 16 16 16 16 gap 8: “Device”, (column gap 4: ), searching, button_look_again, "
               "“Calibration”, fit_text, writing_hand, NumberSlider, NumberSlider, button_calibrate, "
               "calibration_step, corner, button_fit, “Stylus buttons”, “First button”, stylus_button_1, "
               "“Second button”, stylus_button_2, “Limits”, NumberSlider, NumberSlider, stretch*1"}});
  const std::string narrow =
      "; minimumContentsLength 4; sizeAdjustPolicy AdjustToMinimumContentsLengthWithIcon";
  expect_made(
      panel,
      {{"device_choice_panel", "accessibleName Devices and their position; widgetResizable"},
       {"searching", "hidden; role muted; text Searching for devices…; wordWrap"},
       {"writing_hand", ("accessibleName Writing hand" + narrow).c_str()},
       {"tilt", "accessibleDescription 0°; accessibleName Tilt of the tablet; maximum 18; pageStep 1"},
       {"yaw",
        "accessibleDescription -60°; accessibleName Angle of your seat to the device; maximum 24; pageStep "
        "2"},
       {"stylus_button_1", ("accessibleName First button" + narrow).c_str()},
       {"stylus_button_2", ("accessibleName Second button" + narrow).c_str()},
       {"max_force", "accessibleDescription 0.1 N; accessibleName Force; maximum 9; pageStep 1"},
       {"max_stiffness", "accessibleDescription 50 N/m; accessibleName Stiffness; maximum 45; pageStep 4"},
       {"calibration_step", "hidden; textFormat PlainText; wordWrap"}});
  const auto* hand = panel.findChild<QComboBox*>(QStringLiteral("writing_hand"));
  EXPECT_EQ(hand->itemText(0) + u' ' + hand->itemText(1), QStringLiteral("Right hand Left hand"));
  for (const auto* label : panel.findChildren<QLabel*>())
    if (label->text().endsWith(QStringLiteral(" button"))) {
      EXPECT_TRUE(label->wordWrap());
      EXPECT_EQ(label->buddy()->accessibleName(), label->text());
    }
  devices::DeviceChoices choices;
  choices.devices = {{"", "", devices::DeviceChoice::State::found, true},
                     {"arm", "Arm", devices::DeviceChoice::State::found, false}};
  panel.show_choices(choices);
  const auto* arm = panel.findChild<QRadioButton*>(QStringLiteral("device_arm"));
  ASSERT_NE(arm, nullptr);
  EXPECT_EQ(arm->accessibleName(), QStringLiteral("Arm"));
  EXPECT_EQ(arm->property("device").toString(), QStringLiteral("arm"));
  EXPECT_FALSE(arm->isChecked());
  EXPECT_TRUE(panel.findChild<QRadioButton*>(QStringLiteral("device_best"))->isChecked());
}

TEST_F(MadePanels, EachParameterHasItsWordsAboveItsSlider) {
  ParameterSliders sliders;
  EXPECT_TRUE(sliders.isHidden());
  functions::Parameter a, b;
  a.name = "a";
  a.value = 2;
  a.from = 0;
  a.to = 10;
  b.name = "b";
  b.value = -1.5;
  b.from = -2;
  b.to = 0.5;
  sliders.show_parameters({a, b});
  EXPECT_EQ(test::layout_words(sliders).toStdString(), "column 0 0 0 0 gap 2: QWidget, QWidget");
  expect_laid_out(sliders, {{"around parameter_a", "column 0 0 0 0 gap 0: parameter_a_value, parameter_a"},
                            {"around parameter_b", "column 0 0 0 0 gap 0: parameter_b_value, parameter_b"}});
  auto* slider = sliders.findChild<QSlider*>(QStringLiteral("parameter_b"));
  EXPECT_EQ(slider->accessibleName(), QStringLiteral("Parameter b"));
  EXPECT_EQ(slider->accessibleDescription(), QStringLiteral("b = -1.5"));
  EXPECT_EQ(slider->toolTip(),
            QStringLiteral("b from -2 to 0.5. Left and Right: one step. Page Up and Page Down: ten steps"));
  EXPECT_EQ(slider->pageStep(), 10);
  EXPECT_EQ(slider->minimum(), 0);
  EXPECT_EQ(sliders.findChild<QLabel*>(QStringLiteral("parameter_b_value"))->text(),
            QStringLiteral("b = -1.5"));
  QSignalSpy moved(&sliders, &ParameterSliders::moved), rebuilt(&sliders, &ParameterSliders::rebuilt);
  slider->setValue(slider->maximum());
  ASSERT_EQ(moved.count(), 1);
  EXPECT_EQ(moved.at(0).at(0).toString(), QStringLiteral("b"));
  EXPECT_DOUBLE_EQ(moved.at(0).at(1).toDouble(), 0.5);
  b.value = 0;
  sliders.show_parameters({a, b});
  EXPECT_EQ(rebuilt.count(), 0);
  EXPECT_EQ(moved.count(), 1) << "shown, not moved";
  EXPECT_EQ(slider->accessibleDescription(), QStringLiteral("b = 0"));
  for (const auto change : {0, 1, 2}) {
    auto other = b;
    if (change == 0) other.name = "c";
    if (change == 1) other.from = -3;
    if (change == 2) other.to = 1;
    sliders.show_parameters({a, b});
    rebuilt.clear();
    sliders.show_parameters({a, other});
    EXPECT_EQ(rebuilt.count(), 1) << change;
  }
  ASSERT_EQ(sliders.sliders().size(), 2U);
  EXPECT_EQ(sliders.sliders()[0]->objectName(), QStringLiteral("parameter_a"));
  sliders.show_parameters({});
  EXPECT_TRUE(sliders.isHidden());
  EXPECT_EQ(test::layout_words(sliders).toStdString(), "column 0 0 0 0 gap 2: ");
}

TEST_F(MadePanels, ThePanelOfAPlotGoesFromTheExpressionToTheSound) {
  PlotPanel panel;
  test::resize_unseen(*panel.viewport(), {900, 900});
  expect_laid_out(
      panel,
      {{"plot_content",
        "column 16 16 16 16 gap 8: “E&xpression”, expression, plot_progress, expression_words, QWidget, "
        "parameters, examples, space 8, “Range”, FieldRow, FieldRow, FieldRow, FieldRow, FieldRow, FieldRow, "
        "space 8, “Show on the plot”, layer_axes, layer_ticks, layer_grid, layer_rim, FieldRow, FieldRow, "
        "space 8, “Vol&ume”, volume, no_sound, stretch*1"},
       {"around expression_error", "row 0 0 0 0: QLabel top, expression_error*1"},
       {"around window_x0", "row 0 0 0 0: “x from”, window_x0*1"},
       {"around window_z1", "row 0 0 0 0: “z to”, window_z1*1"},
       {"around groove_width", "row 0 0 0 0: “Groo&ve width”, groove_width*1"},
       {"around plate_size", "row 0 0 0 0: “Sam&ples”, plate_size*1"}});
  const std::string box = "sizeAdjustPolicy AdjustToMinimumContentsLengthWithIcon";
  const std::string heights = "; toolTip Height range of a surface; leave empty to fit its values";
  expect_made(
      panel,
      {{"plot_panel",
        "accessibleName Expression and range; focusPolicy NoFocus; horizontalScrollBarPolicy "
        "ScrollBarAlwaysOff; widgetResizable"},
       {"expression",
        "accessibleName Expression; minimumWidth 1; placeholderText y = sin x; toolTip Separate several "
        "expressions with semicolons. Up and Down: earlier expressions"},
       {"expression_words",
        "accessibleName The expression in words; role muted; textFormat PlainText; textInteractionFlags "
        "TextSelectableByMouse; wordWrap"},
       {"around expression_error", "hidden"},
       {"plot_progress",
        "accessibleName Drawing; hidden; maximumHeight 6; no textVisible; sizePolicy Expanding Fixed keeps"},
       {"examples", ("accessibleName Examples; minimumContentsLength 6; minimumWidth 1; " + box).c_str()},
       {"layer_axes", "text &Axes"},
       {"layer_ticks", "text Tic&ks"},
       {"layer_grid", "text &Grid"},
       {"layer_rim", "text Fra&me"},
       {"window_z0", ("accessibleName z from" + heights).c_str()},
       {"window_z1", ("accessibleName z to" + heights).c_str()},
       {"groove_width",
        "accessibleName Groove width in millimetres; decimals 1; maximum 10; minimum 0.4; minimumWidth 1; no "
        "keyboardTracking; singleStep 0.1; suffix  mm; value 0.4"},
       {"plate_size",
        ("accessibleName Samples per side; minimumContentsLength 4; minimumWidth 1; " + box).c_str()},
       {"volume", "accessibleName Volume; maximum 100"},
       {"no_sound", "text Soun&d off"}});
  EXPECT_EQ(panel.findChild<QDoubleSpinBox*>()->findChild<QLineEdit*>()->accessibleName(),
            QStringLiteral("Groove width in millimetres"));
  for (const auto* label : panel.findChildren<QLabel*>())
    if (label->buddy() != nullptr && label->property("role").isValid()) {
      EXPECT_EQ(label->buddy()->objectName(), label->text() == QStringLiteral("Vol&ume")
                                                  ? QStringLiteral("volume")
                                                  : QStringLiteral("expression"));
    }
}

TEST_F(MadePanels, TheTableOfPointsStandsBelowItsSentence) {
  const PointsPanel panel(nullptr);
  expect_laid_out(panel,
                  {{"points_panel",
                    "column 16 16 16 16 gap 10: plot_summary, “Points of &interest”, “None in this range.”, "
                    "points_table*1, stretch"}});
  expect_made(
      panel,
      {{"points_panel", "accessibleName About the plot"},
       {"plot_summary",
        "textFormat PlainText; textInteractionFlags TextSelectableByMouse TextSelectableByKeyboard; "
        "wordWrap"},
       {"points_table",
        "accessibleName Points of interest; columnCount 3; editTriggers NoEditTriggers; "
        "horizontalScrollBarPolicy ScrollBarAlwaysOff; horizontalScrollMode ScrollPerPixel; no showGrid; no "
        "tabKeyNavigation; selectionBehavior SelectRows; selectionMode SingleSelection"}});
  QStringList labels;
  for (const auto* label : panel.findChildren<QLabel*>(QString(), Qt::FindDirectChildrenOnly))
    if (label->objectName().isEmpty()) labels.append(made_words(*label));
  EXPECT_EQ(labels.join(u'\n').toStdString(),
            "of points_table; role heading; text Points of &interest; wordWrap\n"
            "role muted; text None in this range.; wordWrap");
}

TEST_F(MadePanels, AButtonHasOneLineWhereItFitsWithItsMarginsAndSixPixelsMore) {
  QScrollArea area;
  area.setFrameShape(QFrame::NoFrame);
  QPushButton button;
  QRadioButton choice;
  ButtonLines lines(&area, 16);
  const QString text = QStringLiteral("Fit automatically now");
  const auto resize = [&](int width) {
    test::resize_unseen(*area.viewport(), {width, 100});
    EXPECT_EQ(area.viewport()->width(), width);
  };
  resize(1000);
  lines.add(&button, text);
  lines.add(&choice, text);
  ASSERT_EQ(button.text(), text);
  ASSERT_EQ(choice.text(), text);
  for (QAbstractButton* one :
       {static_cast<QAbstractButton*>(&button), static_cast<QAbstractButton*>(&choice)}) {
    one->setText(text);
    QStyleOptionButton option;
    option.initFrom(one);
    option.text = text;
    const int words = one->fontMetrics().horizontalAdvance(text);
    const int sides = one->style()
                          ->sizeFromContents(one == &button ? QStyle::CT_PushButton : QStyle::CT_RadioButton,
                                             &option, {1000, one->fontMetrics().height()}, one)
                          .width() -
                      1000;
    const int needed = words + sides + 6 + 2 * 16;
    resize(needed);
    EXPECT_EQ(one->text(), text);
    resize(needed - 1);
    EXPECT_EQ(one->text(), QStringLiteral("Fit automatically\nnow"));
    resize(needed);
    EXPECT_EQ(one->text(), text);
  }
  QFont large = button.font();
  large.setPointSizeF(3 * QFontInfo(large).pointSizeF());
  button.setFont(large);
  EXPECT_GT(button.text().count(u'\n'), 0) << "larger letters need more lines";
}

}  // namespace
}  // namespace nazori::ui
