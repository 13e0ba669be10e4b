// SPDX-License-Identifier: Apache-2.0
// What the page for devices announces, allows and saves.
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSlider>
#include <cmath>
#include <numbers>

#include "device_window.h"

namespace nazori::ui {
namespace {

using haptics::DeviceState;

class DevicesOnTheirPage : public test::Device {
 protected:
  void SetUp() override {
    Device::SetUp();
    press(Qt::Key_2, Qt::AltModifier);
  }
  void click(std::uint32_t button) {
    script_->buttons = button;
    EXPECT_TRUE(ticks_pass(10));
    script_->buttons = 0;
    EXPECT_TRUE(ticks_pass(10));
  }
  bool at_stroke(int stroke) {
    return QTest::qWaitFor([&] { return controller().current_stroke() == stroke; });
  }
  QVariant kept(const char* key) {
    window_->close();
    const QSettings settings(folder_.filePath(QStringLiteral("nazori.ini")), QSettings::IniFormat);
    return settings.value(
        QStringLiteral("device/known/%1/%2")
            .arg(QString::fromLatin1(QByteArray("scripted:arm").toHex()), QString::fromLatin1(key)));
  }
  void lose_it() {
    script_->plugged_in = false;
    script_->state = DeviceState::lost;
    ASSERT_TRUE(QTest::qWaitFor([&] { return stylus().is_pointer() && stylus().opened() == nullptr; }));
  }
};

TEST_F(DevicesOnTheirPage, ATrialGoesByTenthsFromOneToTen) {
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("Touch the wall and the groove gently.")));
  EXPECT_EQ(controller().stroke_count(), 1) << "the trial's groove";
  EXPECT_TRUE(action("stronger")->isEnabled());
  EXPECT_FALSE(action("weaker")->isEnabled());
  for (int tenths = 2; tenths <= 10; ++tenths) {
    EXPECT_TRUE(action("stronger")->isEnabled()) << tenths;
    action("stronger")->trigger();
    EXPECT_NEAR(stylus().strength(), 0.1 * tenths, 1e-9);
    EXPECT_TRUE(text("strength").startsWith(QStringLiteral("Force at %1% of").arg(10 * tenths)));
    EXPECT_TRUE(action("weaker")->isEnabled());
  }
  EXPECT_FALSE(action("stronger")->isEnabled());
  action("weaker")->trigger();
  EXPECT_NEAR(stylus().strength(), 0.9, 1e-9);
  EXPECT_TRUE(action("stronger")->isEnabled());
  press(Qt::Key_1, Qt::AltModifier);
  EXPECT_EQ(stylus().strength(), 1);
  press(Qt::Key_2, Qt::AltModifier);
  EXPECT_NEAR(stylus().strength(), 0.1, 1e-9) << "gently again";
}

TEST_F(DevicesOnTheirPage, WithoutADeviceThereIsNothingToBeFittedOrMadeStronger) {
  lose_it();
  for (const char* name : {"calibrate", "fit", "stronger", "weaker"})
    EXPECT_TRUE(QTest::qWaitFor([&] { return !action(name)->isEnabled(); })) << name;
  press(Qt::Key_1, Qt::AltModifier);
  press(Qt::Key_2, Qt::AltModifier);
  EXPECT_TRUE(
      feedback().startsWith(QStringLiteral("With a mouse or pen you can only see the wall and the groove.")))
      << feedback().toStdString();
}

TEST_F(DevicesOnTheirPage, EachCornerIsAskedForInTurnAndAButtonOfTheStylusWillDo) {
  action("calibrate")->trigger();
  EXPECT_EQ(feedback(), QStringLiteral("Point at three corners for the tablet, in the air or on your desk."));
  EXPECT_EQ(controller().tablet(), nullptr) << "nothing pushes";
  EXPECT_EQ(text("calibration_step"),
            QStringLiteral("1 of 3: hold the tip where you want the bottom left corner."));
  click(1);
  EXPECT_TRUE(QTest::qWaitFor([&] {
    return text("calibration_step") ==
           QStringLiteral("2 of 3: hold the tip where you want the bottom right corner.");
  }));
  EXPECT_EQ(controller().current_stroke(), 0) << "it does nothing else meanwhile";
  click(2);
  EXPECT_TRUE(QTest::qWaitFor([&] {
    return text("calibration_step") ==
           QStringLiteral("3 of 3: hold the tip where you want the top left corner.");
  }));
  press(Qt::Key_1, Qt::AltModifier);
  press(Qt::Key_2, Qt::AltModifier);
  EXPECT_FALSE(find("calibration_step")->isVisible()) << "who goes away shows no more corners";
  ASSERT_TRUE(controller().tablet());
  EXPECT_EQ(script_->opened, 1);
}

TEST_F(DevicesOnTheirPage, ADeviceThatGoesAwayEndsItsCalibration) {
  action("calibrate")->trigger();
  lose_it();
  find<QPushButton>("corner")->click();
  EXPECT_EQ(feedback(), QStringLiteral("The device was disconnected. The tablet was not changed."));
  EXPECT_FALSE(find("corner")->isVisible());
  EXPECT_TRUE(controller().tablet());
}

TEST_F(DevicesOnTheirPage, ATabletThatFitsByItselfForgetsTheCorners) {
  action("calibrate")->trigger();
  for (const auto& [x, y] : {std::pair{-0.04, -0.04}, {0.04, -0.04}, {-0.04, 0.04}}) {
    script_->x_m = x;
    script_->y_m = y;
    ASSERT_TRUE(ticks_pass(60));
    find<QPushButton>("corner")->click();
  }
  ASSERT_TRUE(says(QStringLiteral("The tablet is now where you pointed.")));
  EXPECT_TRUE(text("fit_text").startsWith(QStringLiteral("Calibrated with corners")));
  action("fit")->trigger();
  ASSERT_TRUE(says(QStringLiteral("The tablet is now as large as the stylus can reach.")));
  EXPECT_TRUE(text("fit_text").startsWith(QStringLiteral("Automatic fit")));
  EXPECT_FALSE(script_->asked_calibrated);
  EXPECT_FALSE(kept("scale").isValid());
}

TEST_F(DevicesOnTheirPage, APostureIsTakenUpOnceItsSliderRests) {
  auto* tilt = find<QSlider>("tilt");
  for (const int step : {17, 12, 6}) tilt->setValue(step);
  EXPECT_EQ(script_->opened, 1);
  ASSERT_TRUE(says(QStringLiteral("The position of the tablet was updated.")));
  EXPECT_EQ(script_->opened, 2) << "once, not at each step";
  EXPECT_NEAR(script_->asked_tilt_rad, 30 * std::numbers::pi / 180, 1e-9);
  EXPECT_EQ(text("tilt_value"), QStringLiteral("30°"));
  EXPECT_NEAR(kept("tilt").toDouble(), 30 * std::numbers::pi / 180, 1e-9);
}

TEST_F(DevicesOnTheirPage, EachButtonDoesWhatItWasGiven) {
  const auto give = [&](devices::ButtonDoes first, devices::ButtonDoes second) {
    press(Qt::Key_2, Qt::AltModifier);
    find<QComboBox>("stylus_button_1")->setCurrentIndex(static_cast<int>(first));
    find<QComboBox>("stylus_button_2")->setCurrentIndex(static_cast<int>(second));
    press(Qt::Key_1, Qt::AltModifier);
    EXPECT_TRUE(ticks_pass(20));
  };
  using enum devices::ButtonDoes;
  give(previous_stroke, all_strokes);
  click(1);
  EXPECT_TRUE(at_stroke(6));
  click(1);
  EXPECT_TRUE(at_stroke(5));
  click(2);
  EXPECT_TRUE(at_stroke(0));
  give(nothing, next_stroke);
  click(1);
  click(2);
  EXPECT_TRUE(at_stroke(1)) << "by the second alone";
  give(clear_ink, nothing);
  int pictures = 0;
  const base::Connection counting = controller().picture_changed.connect([&] { ++pictures; });
  click(1);
  click(4);
  EXPECT_TRUE(QTest::qWaitFor([&] { return pictures > 0; }));
  EXPECT_EQ(controller().current_stroke(), 0) << "and a third one does nothing";
  EXPECT_EQ(kept("button_1").toString(), QStringLiteral("clear_ink"));
}

TEST_F(DevicesOnTheirPage, LimitsAreKept) {
  auto* force = find<QSlider>("max_force");
  EXPECT_EQ(text("max_force_value"), QStringLiteral("3.3 N")) << "its own, not the trial's tenth";
  force->setValue(force->minimum() + 4);
  find<QSlider>("max_stiffness")->setValue(10);
  EXPECT_EQ(text("max_force_value"), QStringLiteral("0.5 N"));
  EXPECT_EQ(text("max_stiffness_value"), QStringLiteral("150 N/m"));
  EXPECT_NEAR(kept("max_force_n").toDouble(), 0.5, 1e-9);
  EXPECT_NEAR(kept("max_stiffness_n_m").toDouble(), 150, 1e-9);
}

}  // namespace
}  // namespace nazori::ui
