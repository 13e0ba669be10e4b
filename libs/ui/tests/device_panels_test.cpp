// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QFontMetrics>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <numbers>

#include "device/button_lines.h"
#include "device/device_actions.h"
#include "device/device_choice_panel.h"
#include "device/feel_panel.h"
#include "nazori/widgets/controls/number_slider.h"
#include "nazori/widgets/tablet/window_tablet.h"
#include "print_qt.h"

namespace nazori::ui {
namespace {

using haptics::DeviceTrouble;
constexpr double kDegree = std::numbers::pi / 180;

TEST(NumberSlider, ShowsItsNumberAndTellsOnlyWhatAHandDoes) {
  NumberSlider number(QStringLiteral("Force"), QStringLiteral("force"), 0.5, 2.5, 0.1, QStringLiteral("%1 N"),
                      1, nullptr);
  auto* slider = number.findChild<QSlider*>();
  auto* words = number.findChild<QLabel*>(QStringLiteral("force_value"));
  QSignalSpy moved(&number, &NumberSlider::moved);
  EXPECT_EQ(slider->objectName(), QStringLiteral("force"));
  EXPECT_EQ(slider->accessibleName(), QStringLiteral("Force"));
  EXPECT_EQ(words->text(), QStringLiteral("0.5 N"));
  number.set_value(1.34);
  EXPECT_NEAR(number.value(), 1.3, 1e-12) << "the nearest step";
  number.set_value(1.36);
  EXPECT_NEAR(number.value(), 1.4, 1e-12);
  EXPECT_EQ(words->text(), QStringLiteral("1.4 N"));
  EXPECT_EQ(slider->accessibleDescription(), QStringLiteral("1.4 N"));
  number.set_value(9);
  EXPECT_NEAR(number.value(), 2.5, 1e-12);
  EXPECT_EQ(moved.count(), 0);
  slider->setValue(0);
  ASSERT_EQ(moved.count(), 1);
  EXPECT_NEAR(moved.takeFirst().at(0).toDouble(), 0.5, 1e-12);
  EXPECT_EQ(words->text(), QStringLiteral("0.5 N"));
  QTest::keyClick(slider, Qt::Key_PageUp);
  EXPECT_NEAR(number.value(), 0.7, 1e-12) << "a tenth of its 20 steps";
  EXPECT_EQ(moved.count(), 1);
}

TEST(NumberSlider, AnotherRangeIsNoMoveOfAHand) {
  NumberSlider number(QStringLiteral("n"), QStringLiteral("n"), 0, 10, 1, QStringLiteral("%1"), 0, nullptr);
  number.set_value(10);
  QSignalSpy moved(&number, &NumberSlider::moved);
  number.set_range(2, 6);
  EXPECT_EQ(moved.count(), 0);
  EXPECT_EQ(number.value(), 6);
  EXPECT_EQ(number.findChild<QLabel*>(QStringLiteral("n_value"))->text(), QStringLiteral("6"));
  auto* slider = number.findChild<QSlider*>();
  EXPECT_EQ(slider->minimum(), 0);
  EXPECT_EQ(slider->maximum(), 4);
  EXPECT_EQ(slider->pageStep(), 1) << "never none";
}

TEST(TextInLines, BreaksBetweenWordsOnlyWhereItMust) {
  const QFontMetrics metrics{QFont()};
  const QString text = QStringLiteral("one two three");
  const auto wide = [&](const char* words) { return metrics.horizontalAdvance(QString::fromLatin1(words)); };
  EXPECT_EQ(in_lines(text, metrics, wide("one two three")), text);
  EXPECT_EQ(in_lines(text, metrics, wide("one two three") - 1), QStringLiteral("one two\nthree"));
  EXPECT_EQ(in_lines(text, metrics, wide("one two")), QStringLiteral("one two\nthree"));
  EXPECT_EQ(in_lines(text, metrics, std::max(wide("one two") - 1, wide("three"))),
            QStringLiteral("one\ntwo\nthree"));
  EXPECT_EQ(in_lines(QString(), metrics, 100), QString());
}

TEST(TextInLines, AWordThatIsTooWideIsCutInTwoAndNothingIsLost) {
  const QFontMetrics metrics{QFont()};
  const QString text = QStringLiteral("an abcdefghijklmnopqrstuvwxyz end");
  const int width = metrics.horizontalAdvance(QStringLiteral("abcdefghijkl"));
  const QStringList lines = in_lines(text, metrics, width).split(u'\n');
  EXPECT_GE(lines.size(), 4);
  EXPECT_EQ(lines.front(), QStringLiteral("an"));
  EXPECT_EQ(lines.at(1), QStringLiteral("abcdefghijkl")) << "as much as fits";
  QString all = lines.join(QString());
  EXPECT_EQ(all.remove(u' '), QStringLiteral("anabcdefghijklmnopqrstuvwxyzend"));
  for (const auto& line : lines) EXPECT_LE(metrics.horizontalAdvance(line), width);
  // With no space at all there is one letter per line, and the function returns.
  EXPECT_EQ(in_lines(QStringLiteral("abc"), metrics, 1), QStringLiteral("a\nb\nc"));
}

class DeviceChoice : public testing::Test {
 protected:
  DeviceChoice() {
    panel_.resize(360, 1200);
    panel_.show();
  }
  template <class T = QWidget>
  T* find(const char* name) {
    return panel_.findChild<T*>(QString::fromLatin1(name));
  }
  /// The devices to choose from, each with its id; a star marks the one that is chosen.
  QStringList choices() {
    QCoreApplication::processEvents();  // new widgets are shown with the next layout
    QStringList all;
    for (const auto* one : panel_.findChildren<QRadioButton*>())
      if (!one->isHidden())
        all.append(one->property("device").toString() + u'|' + one->accessibleName() +
                   (one->isChecked() ? QStringLiteral("*") : QString()));
    return all;
  }
  QStringList reasons() {
    QCoreApplication::processEvents();
    QStringList all;
    for (const auto* one : panel_.findChildren<QLabel*>(QStringLiteral("reason")))
      if (!one->isHidden()) all.append(one->text());
    return all;
  }
  static devices::BackEndFindings findings(const std::string& name,
                                           std::vector<devices::FoundDevice> found = {},
                                           DeviceTrouble trouble = DeviceTrouble::none) {
    devices::BackEndFindings made{name, std::move(found), std::nullopt};
    if (trouble != DeviceTrouble::none) made.problem = {trouble, {base::Errc::device, "what", "", "do this"}};
    return made;
  }
  void show_findings(const std::vector<devices::BackEndFindings>& findings, const QString& chosen,
                     const QString& in_use, const QString& in_use_name) {
    devices::DeviceMemory memory;
    memory.chosen = chosen.toStdString();
    panel_.show_choices(
        devices::device_choices(findings, memory, in_use.toStdString(), in_use_name.toStdString()));
  }
  static haptics::DeviceDescription arm() { return {"Arm", 1000, true, {}}; }

  QWidget window_;
  DeviceActions actions_{&window_};
  DeviceChoicePanel panel_{actions_, nullptr};
};

TEST_F(DeviceChoice, ListsTheBestThenWhatWasFoundThenWhy) {
  panel_.show_searching();
  EXPECT_TRUE(find("searching")->isVisible());
  show_findings({findings("Arms", {{"a:1", "Arm one", true, true}, {"a:2", "Arm two", true, true}}),
                 findings("Touch", {}, DeviceTrouble::device_absent)},
                {}, QStringLiteral("a:2"), QStringLiteral("Arm two"));
  EXPECT_FALSE(find("searching")->isVisible());
  EXPECT_EQ(choices(), (QStringList{QStringLiteral("|Automatic (best available)*"),
                                    QStringLiteral("a:1|Arm one"), QStringLiteral("a:2|Arm two – in use")}));
  EXPECT_EQ(
      reasons(),
      QStringList{QStringLiteral("Touch: no device is connected. Check the cable and the power. (do this)")});
}

TEST_F(DeviceChoice, MarksTheOneThatWasChosen) {
  show_findings({findings("Arms", {{"a:1", "Arm one", true, true}, {"a:2", "Arm two", true, true}})},
                QStringLiteral("a:1"), QStringLiteral("a:2"), QStringLiteral("Arm two"));
  EXPECT_EQ(choices(), (QStringList{QStringLiteral("|Automatic (best available)"),
                                    QStringLiteral("a:1|Arm one*"), QStringLiteral("a:2|Arm two – in use")}));
}

TEST_F(DeviceChoice, ListsWhatIsInUseOrWasChosenThoughItWasNotFound) {
  show_findings({}, QStringLiteral("gone:1"), QStringLiteral("pointer"), QStringLiteral("Mouse"));
  EXPECT_EQ(choices(), (QStringList{QStringLiteral("|Automatic (best available)"),
                                    QStringLiteral("pointer|Mouse – in use"),
                                    QStringLiteral("gone:1|gone:1 – not connected*")}));
  show_findings({}, QStringLiteral("pointer"), QStringLiteral("pointer"), QStringLiteral("Mouse"));
  EXPECT_EQ(choices(), (QStringList{QStringLiteral("|Automatic (best available)"),
                                    QStringLiteral("pointer|Mouse – in use*")}));
}

TEST_F(DeviceChoice, DoesNotSayThatWhatIsOpenHereIsInUse) {
  const auto both = [](const char* used) {
    return std::vector{findings("Arms", {{"a:1", "Arm", true, true}}, DeviceTrouble::in_use),
                       findings("Others", {{"o:1", "Other", true, true}}, DeviceTrouble::in_use),
                       findings(used, {}, DeviceTrouble::no_permission)};
  };
  show_findings(both("Third"), {}, QStringLiteral("a:1"), QStringLiteral("Arm"));
  ASSERT_EQ(reasons().size(), 2);
  EXPECT_TRUE(reasons()[0].startsWith(QStringLiteral("Others is in use")));
  EXPECT_TRUE(reasons()[1].startsWith(QStringLiteral("Third is connected, but")));
}

TEST_F(DeviceChoice, TellsWhichOneAHandChooses) {
  QSignalSpy chosen(&panel_, &DeviceChoicePanel::chosen);
  show_findings({findings("Arms", {{"a:1", "Arm", true, true}})}, {}, QStringLiteral("pointer"),
                QStringLiteral("Mouse"));
  EXPECT_EQ(chosen.count(), 0);
  find<QRadioButton>("device_a:1")->click();
  EXPECT_EQ(chosen.takeFirst().at(0).toString(), QStringLiteral("a:1"));
  find<QRadioButton>("device_best")->click();
  EXPECT_EQ(chosen.takeFirst().at(0).toString(), QString());
  EXPECT_FALSE(find<QRadioButton>("device_a:1")->isChecked()) << "one of them";
}

TEST_F(DeviceChoice, KeepsTheKeyboardAmongTheDevicesWhenTheyAreListedAnew) {
  panel_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&panel_));
  const auto list = [&] {
    show_findings({findings("Arms", {{"a:1", "Arm", true, true}})}, QStringLiteral("a:1"),
                  QStringLiteral("a:1"), QStringLiteral("Arm"));
    QCoreApplication::processEvents();
  };
  list();
  find<QComboBox>("writing_hand")->setFocus();
  list();
  EXPECT_TRUE(find("writing_hand")->hasFocus());
  for (auto* one : panel_.findChildren<QRadioButton*>())
    if (one->isVisible() && one->isChecked()) one->setFocus();
  list();
  auto* now = qobject_cast<QRadioButton*>(panel_.focusWidget());
  ASSERT_NE(now, nullptr);
  EXPECT_TRUE(now->isVisible());
  EXPECT_TRUE(now->isChecked());
}

TEST_F(DeviceChoice, ShowsWhatIsRememberedOfADeviceAndTellsNothingOfIt) {
  QSignalSpy posture(&panel_, &DeviceChoicePanel::posture_changed);
  QSignalSpy limits(&panel_, &DeviceChoicePanel::limits_changed);
  QSignalSpy buttons(&panel_, &DeviceChoicePanel::buttons_changed);
  devices::DeviceSettings settings;
  settings.posture = {30 * kDegree, -20 * kDegree, devices::WritingHand::left};
  settings.buttons = {devices::ButtonDoes::clear_ink, devices::ButtonDoes::previous_stroke};
  settings.max_force_n = 1.5;
  settings.max_stiffness_n_m = 200;
  panel_.show_device(settings, arm(), 1.256);
  EXPECT_EQ(find<QLabel>("fit_text")->text(),
            QStringLiteral("Automatic fit: 1 cm of hand movement is 1.26 cm on the tablet."));
  EXPECT_EQ(find<QComboBox>("writing_hand")->currentText(), QStringLiteral("Left hand"));
  EXPECT_EQ(find<QLabel>("tilt_value")->text(), QStringLiteral("30°"));
  EXPECT_EQ(find<QLabel>("yaw_value")->text(), QStringLiteral("-20°"));
  EXPECT_EQ(find<QComboBox>("stylus_button_1")->currentText(), QStringLiteral("clear ink"));
  EXPECT_EQ(find<QComboBox>("stylus_button_2")->currentText(), QStringLiteral("previous stroke"));
  EXPECT_EQ(find<QLabel>("max_force_value")->text(), QStringLiteral("1.5 N"));
  EXPECT_EQ(find<QLabel>("max_stiffness_value")->text(), QStringLiteral("200 N/m"));
  settings = {};
  settings.calibration = devices::WorkspaceCalibration{};
  panel_.show_device(settings, arm(), 0.8);
  EXPECT_EQ(find<QLabel>("fit_text")->text(),
            QStringLiteral("Calibrated with corners: 1 cm of hand movement is 0.80 cm on the tablet."));
  EXPECT_EQ(find<QComboBox>("writing_hand")->currentText(), QStringLiteral("Right hand"));
  EXPECT_EQ(find<QLabel>("tilt_value")->text(), QStringLiteral("90°"));
  EXPECT_EQ(find<QComboBox>("stylus_button_1")->currentText(), QStringLiteral("next stroke"));
  EXPECT_EQ(find<QComboBox>("stylus_button_2")->currentText(), QStringLiteral("all strokes"));
  EXPECT_EQ(find<QLabel>("max_force_value")->text(), QStringLiteral("3.3 N")) << "the device's own";
  EXPECT_EQ(find<QLabel>("max_stiffness_value")->text(), QStringLiteral("500 N/m"));
  EXPECT_EQ(posture.count() + limits.count() + buttons.count(), 0);
}

TEST_F(DeviceChoice, TellsEachSettingThatAHandChanges) {
  panel_.show_device({}, arm(), 1);
  std::vector<devices::TabletPosture> postures;
  QObject::connect(&panel_, &DeviceChoicePanel::posture_changed, &panel_,
                   [&](const devices::TabletPosture& posture) { postures.push_back(posture); });
  find<QComboBox>("writing_hand")->setCurrentIndex(1);
  find<QSlider>("tilt")->setValue(9);  // steps of 5 degrees from 0
  find<QSlider>("yaw")->setValue(0);   // from -60
  ASSERT_EQ(postures.size(), 3U);
  EXPECT_EQ(postures[0].hand, devices::WritingHand::left);
  EXPECT_NEAR(postures[0].tilt_rad, 90 * kDegree, 1e-12);
  EXPECT_NEAR(postures[1].tilt_rad, 45 * kDegree, 1e-12);
  EXPECT_NEAR(postures[2].yaw_rad, -60 * kDegree, 1e-12);
  find<QSlider>("yaw")->setValue(find<QSlider>("yaw")->maximum());
  EXPECT_NEAR(postures.back().yaw_rad, 60 * kDegree, 1e-12);
  find<QSlider>("tilt")->setValue(0);
  EXPECT_EQ(postures.back().tilt_rad, 0);
  find<QSlider>("tilt")->setValue(100);
  EXPECT_NEAR(postures.back().tilt_rad, 90 * kDegree, 1e-12);

  std::vector<std::pair<devices::ButtonDoes, devices::ButtonDoes>> buttons;
  QObject::connect(
      &panel_, &DeviceChoicePanel::buttons_changed, &panel_,
      [&](devices::ButtonDoes first, devices::ButtonDoes second) { buttons.emplace_back(first, second); });
  find<QComboBox>("stylus_button_1")->setCurrentIndex(0);
  find<QComboBox>("stylus_button_2")->setCurrentIndex(4);
  using enum devices::ButtonDoes;
  EXPECT_EQ(buttons, (std::vector<std::pair<devices::ButtonDoes, devices::ButtonDoes>>{
                         {nothing, all_strokes}, {nothing, clear_ink}}));

  std::vector<std::pair<double, double>> limits;
  QObject::connect(
      &panel_, &DeviceChoicePanel::limits_changed, &panel_,
      [&](double force_n, double stiffness_n_m) { limits.emplace_back(force_n, stiffness_n_m); });
  find<QSlider>("max_force")->setValue(0);
  find<QSlider>("max_stiffness")->setValue(0);
  ASSERT_EQ(limits.size(), 2U);
  EXPECT_NEAR(limits[0].first, 0.1, 1e-12);
  EXPECT_NEAR(limits[0].second, 500, 1e-9);
  EXPECT_NEAR(limits[1].second, 50, 1e-9);
  find<QSlider>("max_stiffness")->setValue(1);
  EXPECT_NEAR(limits.back().second, 60, 1e-9);
}

TEST_F(DeviceChoice, WhatAButtonMayDoStandsInOneOrderForBoth) {
  for (const char* name : {"stylus_button_1", "stylus_button_2"}) {
    QStringList does;
    for (int i = 0; i < find<QComboBox>(name)->count(); ++i) does.append(find<QComboBox>(name)->itemText(i));
    EXPECT_EQ(does.join(u'|'),
              QStringLiteral("do nothing|next stroke|previous stroke|all strokes|clear ink"));
  }
  EXPECT_EQ(find("stylus_button_1")->accessibleName(), QStringLiteral("First button"));
  EXPECT_EQ(find("stylus_button_2")->accessibleName(), QStringLiteral("Second button"));
}

TEST_F(DeviceChoice, WithoutForceThereIsNothingToFitOrLimit) {
  const char* only[] = {"fit_text",         "writing_hand",    "tilt",      "yaw",
                        "stylus_button_1",  "stylus_button_2", "max_force", "max_stiffness",
                        "button_calibrate", "button_fit"};
  panel_.show_device({}, {"Mouse", 1000, false, {}}, 1);
  for (const char* name : only) EXPECT_FALSE(find(name)->isVisible()) << name;
  EXPECT_TRUE(find("button_look_again")->isVisible());
  panel_.show_device({}, arm(), 1);
  for (const char* name : only) EXPECT_TRUE(find(name)->isVisible()) << name;
}

TEST_F(DeviceChoice, AStepOfTheCalibrationIsShownWithItsButton) {
  panel_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&panel_));
  EXPECT_FALSE(find("calibration_step")->isVisible());
  EXPECT_FALSE(find("corner")->isVisible());
  QSignalSpy shown(&panel_, &DeviceChoicePanel::corner_shown);
  panel_.show_step(QStringLiteral("1 of 3"));
  EXPECT_EQ(find<QLabel>("calibration_step")->text(), QStringLiteral("1 of 3"));
  EXPECT_TRUE(find("calibration_step")->isVisible());
  EXPECT_TRUE(find("corner")->hasFocus()) << "Space is enough";
  find<QPushButton>("corner")->click();
  EXPECT_EQ(shown.count(), 1);
  panel_.show_step({});
  EXPECT_FALSE(find("calibration_step")->isVisible());
  EXPECT_FALSE(find("corner")->isVisible());
}

TEST_F(DeviceChoice, ButtonsDoWhatTheMenusDo) {
  const std::pair<const char*, QAction*> all[] = {{"button_look_again", actions_.look_again},
                                                  {"button_calibrate", actions_.calibrate},
                                                  {"button_fit", actions_.fit}};
  panel_.show_device({}, arm(), 1);
  for (const auto& [name, action] : all) {
    QSignalSpy triggered(action, &QAction::triggered);
    auto* button = find<QPushButton>(name);
    button->click();
    EXPECT_EQ(triggered.count(), 1) << name;
    EXPECT_EQ(button->accessibleName(), without_mnemonic(action->text()));
    EXPECT_EQ(QString(button->text()).replace(u'\n', u' '), without_mnemonic(action->text()));
    EXPECT_EQ(button->toolTip(), action->toolTip());
  }
}

class Feel : public testing::Test {
 protected:
  Feel() {
    panel_.resize(360, 1200);
    panel_.show();
    QObject::connect(&panel_, &FeelPanel::material_changed, &panel_,
                     [this](const haptics::Material& material) { told_.push_back(material); });
  }
  template <class T>
  T* find(const char* name) {
    return panel_.findChild<T*>(QString::fromLatin1(name));
  }
  QString text(const char* name) { return find<QLabel>(name)->text(); }

  QWidget window_;
  DeviceActions actions_{&window_};
  WindowTablet tablet_;
  devices::TabletDevice& stylus_ = tablet_.device();
  FeelPanel panel_{stylus_, actions_, nullptr};
  std::vector<haptics::Material> told_;
};

TEST_F(Feel, AMaterialIsShownInItsNumbersAndNothingIsToldOfIt) {
  panel_.show_material({0.1, 0.2, 0.4, 0.3, 0.5, haptics::Texture::wood, 0.65});
  EXPECT_EQ(text("material_stiffness_value"), QStringLiteral("0.10"));
  EXPECT_EQ(text("material_damping_value"), QStringLiteral("0.20"));
  EXPECT_EQ(text("material_static_friction_value"), QStringLiteral("0.40"));
  EXPECT_EQ(text("material_dynamic_friction_value"), QStringLiteral("0.30"));
  EXPECT_EQ(text("material_popthrough_value"), QStringLiteral("0.50"));
  EXPECT_EQ(text("material_roughness_value"), QStringLiteral("0.65"));
  EXPECT_EQ(find<QComboBox>("material_texture")->currentText(), QStringLiteral("wood"));
  EXPECT_TRUE(told_.empty());
}

TEST_F(Feel, EachNumberOfTheMaterialIsTold) {
  panel_.show_material({});
  const auto set = [&](const char* name, int twentieths) { find<QSlider>(name)->setValue(twentieths); };
  set("material_stiffness", 1);
  EXPECT_NEAR(told_.back().stiffness, 0.05, 1e-12);
  set("material_damping", 2);
  EXPECT_NEAR(told_.back().damping, 0.1, 1e-12);
  set("material_static_friction", 10);
  EXPECT_NEAR(told_.back().static_friction, 0.5, 1e-12);
  set("material_dynamic_friction", 4);
  EXPECT_NEAR(told_.back().dynamic_friction, 0.2, 1e-12);
  set("material_popthrough", 20);
  EXPECT_NEAR(told_.back().popthrough, 1, 1e-12);
  set("material_roughness", 0);
  EXPECT_NEAR(told_.back().roughness, 0, 1e-12);
  find<QComboBox>("material_texture")->setCurrentIndex(3);
  EXPECT_EQ(told_.back().texture, haptics::Texture::stone);
  EXPECT_NEAR(told_.back().stiffness, 0.05, 1e-12) << "all of them, each time";
  EXPECT_NEAR(told_.back().damping, 0.1, 1e-12);
  EXPECT_EQ(told_.size(), 7U);
}

TEST_F(Feel, WhatSlidesIsNeverHeldMoreThanWhatRests) {
  panel_.show_material({0.8, 0, 0.4, 0.4});
  find<QSlider>("material_dynamic_friction")->setValue(15);
  EXPECT_NEAR(told_.back().dynamic_friction, 0.4, 1e-12);
  EXPECT_EQ(text("material_dynamic_friction_value"), QStringLiteral("0.40"));
  find<QSlider>("material_static_friction")->setValue(2);
  EXPECT_NEAR(told_.back().dynamic_friction, 0.1, 1e-12);
  EXPECT_EQ(text("material_dynamic_friction_value"), QStringLiteral("0.10"));
}

TEST_F(Feel, TheRadiusOfTheBallIsSetInTenthsOfAMillimetreFromAPointTo3) {
  QSignalSpy told(&panel_, &FeelPanel::tip_changed);
  auto* slider = find<QSlider>("tip_radius");
  EXPECT_EQ(slider->accessibleName(), QStringLiteral("Radius of the ball"));
  EXPECT_EQ(text("tip_radius_value"), QStringLiteral("0.0 mm"));
  EXPECT_EQ(slider->maximum(), 30);
  panel_.show_tip(0.0017);
  EXPECT_EQ(text("tip_radius_value"), QStringLiteral("1.7 mm"));
  EXPECT_EQ(told.count(), 0) << "it is what is set already";
  slider->setFocus();
  QTest::keyClick(slider, Qt::Key_Right);
  ASSERT_EQ(told.count(), 1);
  EXPECT_NEAR(told.back().at(0).toDouble(), 0.0018, 1e-12);
  QTest::keyClick(slider, Qt::Key_End);
  EXPECT_NEAR(told.back().at(0).toDouble(), 0.003, 1e-12);
  QTest::keyClick(slider, Qt::Key_Home);
  EXPECT_EQ(told.back().at(0).toDouble(), 0);
  EXPECT_TRUE(told_.empty()) << "the material is the same";
}

TEST_F(Feel, TheTrialIsThereWithForceOnlyAndSaysHowStrongItIs) {
  const auto* words = find<QLabel>("strength");
  panel_.show_strength(0.295, true);
  EXPECT_TRUE(words->isVisible());
  EXPECT_EQ(
      words->text(),
      QStringLiteral("Force at 30% of the device's limits. A wall is on the left, a groove on the right."));
  panel_.show_strength(1, false);
  EXPECT_FALSE(words->isVisible());
  for (auto* action : {actions_.weaker, actions_.stronger}) {
    QSignalSpy triggered(action, &QAction::triggered);
    auto* button = panel_.findChild<QPushButton*>(QStringLiteral("button_") + action->objectName());
    button->click();
    EXPECT_EQ(triggered.count(), 1);
    EXPECT_EQ(button->toolTip(), action->toolTip());
  }
}

TEST_F(Feel, WhatIsFeltNowIsToldInNumbers) {
  ASSERT_TRUE(stylus_.start());
  stylus_.move({0.0123, -0.0045, 0.01, true, true});
  const auto shown = [&](const char* name, const QString& wanted) {
    return QTest::qWaitFor(
        [&] {
          std::array<haptics::ServoSample, 256> samples;
          (void)stylus_.take_samples(samples);
          return text(name) == wanted;
        },
        20'000);
  };
  panel_.watch(true);
  EXPECT_TRUE(shown("live_pose", QStringLiteral("12.3, -4.5, -10.0 mm"))) << text("live_pose").toStdString();
  EXPECT_TRUE(shown("live_buttons", QStringLiteral("1"))) << text("live_buttons").toStdString();
  EXPECT_EQ(text("live_force"), QStringLiteral("0.00 N")) << "there is no tablet";
  EXPECT_TRUE(text("live_rate").endsWith(QStringLiteral("times per second")))
      << text("live_rate").toStdString();
  EXPECT_TRUE(text("live_lateness").endsWith(QStringLiteral(" ms")));
  EXPECT_TRUE(text("live_delay").endsWith(QStringLiteral(" ms")));
  EXPECT_FALSE(text("live_missed").isEmpty());
  stylus_.move({0.0123, -0.0045, 0, false, true});
  EXPECT_TRUE(shown("live_buttons", QStringLiteral("none")));
  EXPECT_TRUE(shown("live_rate", QStringLiteral("at rest")));
  panel_.watch(false);
  stylus_.move({0.02, 0, 0, false, true});
  const auto ticks = stylus_.timing().ticks;
  EXPECT_TRUE(QTest::qWaitFor([&] { return stylus_.timing().ticks > ticks + 300; }, 20'000));
  EXPECT_EQ(text("live_rate"), QStringLiteral("at rest")) << "nobody looks";
}

}  // namespace
}  // namespace nazori::ui
