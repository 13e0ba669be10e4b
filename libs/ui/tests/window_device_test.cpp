// SPDX-License-Identifier: Apache-2.0
#include <QApplication>
#include <QComboBox>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>
#include <QSettings>
#include <QSlider>
#include <algorithm>
#include <glm/geometric.hpp>

#include "device_window.h"
#include "hand_under_test.h"
#include "nazori/widgets/events/signals.h"

namespace nazori::ui {
namespace {

using haptics::DeviceState;
using haptics::DeviceTrouble;

using test::Device;

TEST_F(Device, ThatIsFoundHasTheTabletAndTheMouseDoesNot) {
  EXPECT_FALSE(stylus().is_pointer());
  script_->x_m = 0.011;
  controller().move_stylus({-0.03, 0}, true);
  EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(controller().latest().device_m.x - 0.011) < 1e-9; }));
  EXPECT_TRUE(controller().overlay().cursor.has_value()) << "it is drawn without a mouse over the tablet";
}

TEST_F(Device, WhenItIsDockedTheForceIsGoneItIsSaidAndTheMouseWritesUntilItComesBackWithARamp) {
  press_to(-0.004);
  ASSERT_TRUE(QTest::qWaitFor([&] { return script_->force_n > 0.5; })) << "the force begins with a ramp";
  script_->trouble = DeviceTrouble::docked;
  script_->state = DeviceState::paused;
  ASSERT_TRUE(says(QStringLiteral("rests in its inkwell. Take the stylus out to go on. Until then, use")));
  EXPECT_EQ(script_->force_n, 0);
  EXPECT_TRUE(stylus().is_pointer());
  EXPECT_TRUE(text("device").startsWith(QStringLiteral("You are writing with the mouse.")));
  controller().move_stylus({-0.03, 0}, true);
  EXPECT_TRUE(QTest::qWaitFor([&] { return controller().latest().touching; }));
  const auto progress = controller().ink().progress();

  script_->most_step_n = 0;
  script_->state = DeviceState::running;
  ASSERT_TRUE(says(QStringLiteral("Scripted arm is working again. Your writing is still there.")));
  EXPECT_FALSE(stylus().is_pointer());
  EXPECT_TRUE(QTest::qWaitFor([&] { return script_->force_n > 0.5; }));
  EXPECT_LT(script_->most_step_n, 0.05) << "a ramp of 0.3 s, no kick";
  EXPECT_EQ(controller().ink().progress(), progress);
  EXPECT_EQ(script_->opened, 1) << "a pause closes nothing";
}

TEST_F(Device, ThatIsUnpluggedIsSaidAndTakenAgainWhenItIsPluggedIn) {
  script_->plugged_in = false;
  script_->trouble = DeviceTrouble::communication_lost;
  script_->state = DeviceState::lost;
  ASSERT_TRUE(says(QStringLiteral("The connection to Scripted arm was lost. Check the cable. Until then")));
  EXPECT_TRUE(stylus().is_pointer());
  EXPECT_EQ(stylus().opened(), nullptr);
  script_->state = DeviceState::running;
  script_->trouble = DeviceTrouble::none;
  script_->plugged_in = true;
  EXPECT_TRUE(QTest::qWaitFor([&] { return !stylus().is_pointer(); }, 8000));
  EXPECT_TRUE(says(QStringLiteral("Now using Scripted arm.")));
}

TEST_F(Device, GivesNoMoreForceThanTheLearnerAllowsAndNeverMoreThanItsOwnLimit) {
  press_to(-0.05);
  EXPECT_GT(script_->most_force_n, 2.5);
  EXPECT_LE(script_->most_force_n, haptics::DeviceLimits{}.max_force_n + 1e-9);
  press(Qt::Key_2, Qt::AltModifier);
  auto* limit = find<QSlider>("max_force");
  limit->setValue(limit->minimum() + 9);  // 1.0 N
  EXPECT_EQ(text("max_force_value"), QStringLiteral("1.0 N"));
  press(Qt::Key_1, Qt::AltModifier);
  script_->most_force_n = 0;
  press_to(-0.05);
  EXPECT_NEAR(script_->most_force_n, 1.0, 0.01);
}

TEST_F(Device, ButtonsStepThroughTheStrokesAndCanBeGivenOtherMeanings) {
  const auto click = [this](std::uint32_t button) {
    script_->buttons = button;
    EXPECT_TRUE(ticks_pass(10));
    script_->buttons = 0;
    EXPECT_TRUE(ticks_pass(10));
  };
  const auto at_stroke = [this](int stroke) {
    return QTest::qWaitFor([&] { return controller().current_stroke() == stroke; });
  };
  click(1);
  click(1);
  EXPECT_TRUE(at_stroke(2));
  click(2);
  EXPECT_TRUE(at_stroke(0));
  press(Qt::Key_2, Qt::AltModifier);
  find<QComboBox>("stylus_button_1")->setCurrentIndex(static_cast<int>(devices::ButtonDoes::previous_stroke));
  press(Qt::Key_1, Qt::AltModifier);
  click(1);
  EXPECT_TRUE(at_stroke(6)) << controller().current_stroke();
}

TEST_F(Device, ATrialBeginsWithATenthOfItsLimitsAndRisesOnlyOnRequest) {
  press(Qt::Key_2, Qt::AltModifier);
  const double peak_n = haptics::DeviceLimits{}.max_force_n;
  script_->most_force_n = 0;
  press_to(-0.2);
  EXPECT_NEAR(script_->most_force_n, 0.1 * peak_n, 0.01);
  EXPECT_TRUE(text("strength").contains(QStringLiteral("10%"))) << text("strength").toStdString();
  EXPECT_FALSE(action("weaker")->isEnabled());
  find<QPushButton>("button_stronger")->click();
  script_->most_force_n = 0;
  press_to(-0.2);
  EXPECT_NEAR(script_->most_force_n, 0.2 * peak_n, 0.01);
  press(Qt::Key_1, Qt::AltModifier);
  EXPECT_EQ(stylus().strength(), 1);
}

TEST_F(Device, IsFittedByThreeCornersAndKeepsTheFit) {
  press(Qt::Key_2, Qt::AltModifier);
  action("calibrate")->trigger();
  const auto corner = [this](double x, double y) {
    script_->x_m = x;
    script_->y_m = y;
    EXPECT_TRUE(ticks_pass(60));
    find<QPushButton>("corner")->click();
  };
  EXPECT_TRUE(text("calibration_step").startsWith(QStringLiteral("1 of 3")));
  // In the frame of the tablet before the calibration. The arm is at 1:1, so 8 cm are shown for the 10 cm of
  // the tablet.
  corner(-0.04, -0.04);
  corner(0.04, -0.04);
  corner(-0.04, 0.04);
  ASSERT_TRUE(says(QStringLiteral("The tablet is now where you pointed."))) << feedback().toStdString();
  ASSERT_TRUE(script_->asked_calibrated);
  EXPECT_NEAR(stylus().opened()->calibration.scale, 0.100 / 0.080, 1e-6);
  EXPECT_TRUE(text("fit_text").contains(QStringLiteral("1.25 cm"))) << text("fit_text").toStdString();
  press(Qt::Key_1, Qt::AltModifier);
  window_->close();
  script_->asked_calibrated = false;
  open_window();
  ASSERT_TRUE(QTest::qWaitFor([&] { return stylus().opened() != nullptr; }));
  EXPECT_TRUE(script_->asked_calibrated);
  EXPECT_NEAR(stylus().opened()->calibration.scale, 1.25, 1e-6);
}

TEST_F(Device, CornersThatMakeNoTabletChangeNothing) {
  press(Qt::Key_2, Qt::AltModifier);
  action("calibrate")->trigger();
  for (int i = 0; i < 3; ++i) find<QPushButton>("corner")->click();
  EXPECT_TRUE(says(QStringLiteral("These corners do not form a tablet")));
  EXPECT_EQ(script_->opened, 1);
  EXPECT_FALSE(find("corner")->isVisible());
}

TEST_F(Device, TheStatusLineTellsRateAndMissedTicksOnThePageOfDevicesOnly) {
  EXPECT_EQ(text("device"), QStringLiteral("Scripted arm"));
  EXPECT_TRUE(find("device")->isVisible());
  for (const char* figure : {"rate", "missed", "timing", "depth"})
    EXPECT_FALSE(find(figure)->isVisible()) << figure;
  press(Qt::Key_2, Qt::AltModifier);
  EXPECT_TRUE(find("rate")->isVisible());
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return text("rate").contains(QStringLiteral("times per second")); }, 30'000))
      << text("rate").toStdString();
  EXPECT_TRUE(text("missed").contains(QStringLiteral(" missed"))) << text("missed").toStdString();
  press(Qt::Key_1, Qt::AltModifier);
  EXPECT_FALSE(find("rate")->isVisible());
}

TEST_F(Device, ALimitThatIsRememberedAboveTheDevicesOwnRaisesNothing) {
  haptics::DeviceLimits own;
  devices::DeviceSettings bold;
  bold.max_force_n = 50;
  bold.max_stiffness_n_m = 90'000;
  EXPECT_EQ(devices::limited(own, bold).max_force_n, own.max_force_n);
  EXPECT_EQ(devices::limited(own, bold).max_stiffness_n_m, own.max_stiffness_n_m);
  EXPECT_LE(devices::limited(own, bold).continuous_force_n, own.continuous_force_n);
}

TEST_F(Device, ChoiceAndMaterialAreRemembered) {
  press(Qt::Key_2, Qt::AltModifier);
  ASSERT_TRUE(QTest::qWaitFor([&] { return find<QRadioButton>("device_pointer") != nullptr; }));
  find<QRadioButton>("device_pointer")->click();
  EXPECT_TRUE(stylus().is_pointer());
  find<QSlider>("material_stiffness")->setValue(8);
  find<QComboBox>("material_texture")->setCurrentIndex(2);
  find<QSlider>("tip_radius")->setValue(15);
  press(Qt::Key_1, Qt::AltModifier);
  window_->close();
  open_window();
  press(Qt::Key_2, Qt::AltModifier);
  ASSERT_TRUE(QTest::qWaitFor([&] { return find("device_scripted:arm") != nullptr; }));
  EXPECT_TRUE(stylus().is_pointer()) << "the mouse was chosen, though the arm is there";
  EXPECT_TRUE(find<QRadioButton>("device_pointer")->isChecked());
  EXPECT_EQ(find<QSlider>("material_stiffness")->value(), 8);
  EXPECT_EQ(find<QComboBox>("material_texture")->currentIndex(), 2);
  EXPECT_EQ(find<QSlider>("tip_radius")->value(), 15);
  EXPECT_NEAR(controller().tip_radius_m(), 0.0015, 1e-12) << "also while it is not shown";
}

TEST_F(Device, KeysMakeTheBallAtTheTipLargerAndSmallerAndSayItsRadius) {
  press(Qt::Key_2, Qt::AltModifier);
  find<QSlider>("tip_radius")->setValue(0);
  press(Qt::Key_BracketRight);
  EXPECT_EQ(feedback(), QStringLiteral("Radius of the ball at the tip: 0.5 mm."));
  EXPECT_NEAR(controller().tip_radius_m(), 0.0005, 1e-12);
  EXPECT_EQ(find<QSlider>("tip_radius")->value(), 5);
  for (int i = 0; i < 7; ++i) press(Qt::Key_BracketRight);
  EXPECT_NEAR(controller().tip_radius_m(), 0.003, 1e-12) << "no larger than the largest";
  press(Qt::Key_BracketLeft);
  EXPECT_EQ(feedback(), QStringLiteral("Radius of the ball at the tip: 2.5 mm."));
  for (int i = 0; i < 5; ++i) press(Qt::Key_BracketLeft);
  EXPECT_EQ(feedback(), QStringLiteral("The tip is a point."));
  EXPECT_EQ(controller().tip_radius_m(), 0);
  press(Qt::Key_BracketLeft);
  EXPECT_EQ(controller().tip_radius_m(), 0);
  EXPECT_EQ(find<QSlider>("tip_radius")->value(), 0);
}

TEST_F(Device, ABallAtTheTipIsFeltAtOnceAndTheForceFadesIn) {
  press(Qt::Key_2, Qt::AltModifier);
  // On the floor of the groove of the trial tablet.
  const auto tablet = controller().tablet();
  ASSERT_TRUE(tablet);
  const auto& floor = tablet->paths().front().points;
  const auto at = floor[floor.size() / 2];
  find<QSlider>("tip_radius")->setValue(0);
  stylus().set_strength(1);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !stylus().is_pointer(); }));
  script_->x_m = at.x;
  script_->y_m = at.y;
  script_->z_m = 0.002;
  ASSERT_TRUE(ticks_pass(400));
  script_->z_m = at.z - 0.0005;
  const double point_n = settled_force_n();
  ASSERT_GT(point_n, 0.1);
  script_->most_step_n = 0;
  find<QSlider>("tip_radius")->setValue(30);
  EXPECT_TRUE(QTest::qWaitFor([&] { return script_->force_n > point_n + 0.1; }))
      << "the ball stays higher: " << script_->force_n << " N, a point " << point_n << " N";
  ASSERT_TRUE(ticks_pass(400));
  EXPECT_LE(script_->most_step_n, 0.2 + 1e-9) << "the most that a device may change in a tick";
}

TEST_F(Device, OneKeyGoesToTheListOfDevices) {
  press(Qt::Key_2, Qt::AltModifier);
  ASSERT_TRUE(QTest::qWaitFor([&] { return find("device_scripted:arm") != nullptr; }));
  ASSERT_EQ(action("choose_device")->shortcut(), QKeySequence(QStringLiteral("D")));
  action("choose_device")->trigger();
  EXPECT_TRUE(find("device_choice_panel")->isVisible());
  EXPECT_TRUE(QTest::qWaitFor([&] {
    const auto* at = qobject_cast<QRadioButton*>(window_->focusWidget());
    return at != nullptr && at->isChecked() && at->isVisible();
  })) << window_->focusWidget()->objectName().toStdString();
}

TEST_F(Device, ThePageSaysWhyADeviceIsNotThere) {
  script_->plugged_in = false;
  script_->state = DeviceState::lost;
  ASSERT_TRUE(QTest::qWaitFor([&] { return stylus().is_pointer(); }));
  press(Qt::Key_2, Qt::AltModifier);
  EXPECT_TRUE(QTest::qWaitFor([&] {
    return texts("reason").contains(
        QStringLiteral("Scripts: no device is connected. Check the cable and the power."));
  })) << texts("reason").join(QStringLiteral("; ")).toStdString()
      << " visible " << find("device_choice_panel")->isVisible();
}

TEST_F(Device, ASimulationIsLedByTheMouse) {
  open_window_with_simulations();
  press(Qt::Key_2, Qt::AltModifier);
  EXPECT_TRUE(stylus().is_pointer()) << "nobody asked for a simulation";
  ASSERT_TRUE(QTest::qWaitFor([&] { return find<QRadioButton>("device_simulated:touch") != nullptr; }));
  find<QRadioButton>("device_simulated:touch")->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !stylus().is_pointer(); }));
  press(Qt::Key_1, Qt::AltModifier);
  controller().move_stylus({0.045, 0.045}, true);
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return controller().latest().touching && controller().latest().force_n.z > 0.1; }));
}

TEST_F(Device, GuidedLeadsTheHandOfADeviceWithForceLessAfterEachSuccess) {
  open_window_with_simulations();
  show(U'一');
  const auto line = test::model(U'一').front();
  auto& tablet = controller();
  double strongest_n = 0;
  std::uint64_t samples = 0;
  subscribe(tablet.sampled, window_.get(), [&](std::span<const haptics::ServoSample> taken) {
    samples += taken.size();
    for (const auto& one : taken) strongest_n = std::max(strongest_n, glm::length(one.force_n));
  });
  /// The largest force of the simulation within this many ticks, while the hand rests in the air, away from
  /// the stroke. The force needs time to rise. If a busy machine misses ticks, this tries again until
  /// `least_n` is reached.
  const auto felt = [&](std::uint64_t ticks, double least_n) {
    tablet.device().choose("simulated:touch");
    EXPECT_TRUE(QTest::qWaitFor([&] { return !tablet.device().is_pointer(); }, 20'000));
    tablet.move_stylus({0.03, -0.03}, false);
    tablet.pump();
    strongest_n = 0;
    samples = 0;
    tablet.clear_ink();  // writing starts again
    EXPECT_TRUE(QTest::qWaitFor(
        [&] {
          if (samples <= ticks) return false;
          if (strongest_n >= least_n) return true;
          samples = 0;
          tablet.clear_ink();
          return false;
        },
        60'000))
        << strongest_n << " N";
    tablet.device().choose("pointer");
    EXPECT_TRUE(QTest::qWaitFor([&] { return tablet.device().is_pointer(); }, 20'000));
    return strongest_n;
  };
  press(Qt::Key_F7);
  EXPECT_LT(felt(300, 0), 0.01) << "the stroke holds, nothing leads";
  action("lead_hand")->trigger();
  EXPECT_TRUE(feedback().contains(QStringLiteral("Only a force-feedback device can lead your hand")))
      << feedback().toStdString();
  EXPECT_TRUE(tablet.snapping_in_effect()) << "where nothing can lead";
  // At most the cap of 0.8 N times the help that is left.
  double before_n = 1;
  for (const double help : {1.0, 0.6, 0.3}) {
    const double now_n = felt(1'000, 0.4 * help);
    EXPECT_GT(now_n, 0.05 * help);
    EXPECT_LE(now_n, 0.8 * help + 1e-6);
    EXPECT_LT(now_n, before_n);
    before_n = now_n;
    test::write(tablet, line);
    ASSERT_TRUE(feedback().startsWith(QStringLiteral("No mistakes"))) << feedback().toStdString();
  }
  EXPECT_EQ(felt(300, 0), 0) << "and at last unaided";
}

TEST_F(Device, WhatIsOnItsPageHasNamesForTheScreenReader) {
  press(Qt::Key_2, Qt::AltModifier);
  for (const char* panel : {"device_choice_panel", "feel_panel"}) {
    EXPECT_FALSE(find(panel)->accessibleName().isEmpty());
    for (const auto* slider : find(panel)->findChildren<QSlider*>())
      EXPECT_FALSE(slider->accessibleName().isEmpty()) << slider->objectName().toStdString();
    for (const auto* box : find(panel)->findChildren<QComboBox*>())
      EXPECT_FALSE(box->accessibleName().isEmpty()) << box->objectName().toStdString();
  }
}

TEST_F(Device, ItsPageHoldsInANarrowWindowWithTheLargestTextInBothLanguages) {
  for (const char* language : {"en", "ja"}) {
    install_language(QString::fromLatin1(language));
    script_->trouble = DeviceTrouble::none;
    open_window();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !stylus().is_pointer(); }));
    press(Qt::Key_2, Qt::AltModifier);
    ASSERT_TRUE(QTest::qWaitFor([&] { return find("device_scripted:arm") != nullptr; }));
    action("calibrate")->trigger();  // so that every widget of the panel is visible
    for (const int text_pt : {Preferences::kMinText_pt, Preferences::kMaxText_pt}) {
      for (const int width : {1000, 1600}) {
        set_text_size(text_pt, width, 800);
        for (const char* name : {"device_choice_panel", "feel_panel"}) {
          const auto* area = find<QScrollArea>(name);
          const QWidget* content = area->widget();
          EXPECT_TRUE(QTest::qWaitFor([&] { return content->width() <= area->viewport()->width(); }))
              << content->width() << " in " << area->viewport()->width() << ' ' << name << ' ' << width << ' '
              << QApplication::font().pointSize() << ' ' << language
              << widest_parts(content, area->viewport()->width());
          for (const auto* child : content->findChildren<QWidget*>()) {
            if (!child->isVisible()) continue;
            const int right = child->mapTo(content, QPoint(child->width(), 0)).x();
            EXPECT_LE(right, content->width()) << child->objectName().toStdString();
            if (qobject_cast<const QAbstractButton*>(child) != nullptr) {
              EXPECT_GE(child->width(), child->sizeHint().width()) << child->objectName().toStdString();
            }
          }
        }
      }
    }
  }
  install_language(QStringLiteral("en"));
}

}  // namespace
}  // namespace nazori::ui
