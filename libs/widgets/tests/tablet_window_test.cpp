// SPDX-License-Identifier: Apache-2.0
// Events of pen and fingers on the tablet, as Qt sends them. Nothing is drawn.
#include "nazori/widgets/tablet/tablet_window.h"

#include <gtest/gtest.h>

#include <QMouseEvent>
#include <QPointingDevice>
#include <QSignalSpy>
#include <QTabletEvent>
#include <QTest>
#include <QTouchEvent>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "nazori/practice/pen_recorder.h"
#include "nazori/view/point_under.h"
#include "nazori/widgets/tablet/window_tablet.h"

namespace nazori::ui {
namespace {

using Capability = QInputDevice::Capability;
using PointerType = QPointingDevice::PointerType;

std::shared_ptr<const tablet::CarvedTablet> one_stroke() {
  std::vector<kanji::StrokeLine> lines(1);
  lines[0].points = {{20, 54.5}, {89, 54.5}};
  return *tablet::CarvedTablet::from_lines(tablet::tablet_lines(lines), 64);
}

class PenAndFingers : public testing::Test {
 protected:
  PenAndFingers() {
    controller_.set_tablet(one_stroke());
    window_.resize(800, 600);
    EXPECT_TRUE(controller_.start());
  }
  static QPointingDevice device(QInputDevice::DeviceType type, PointerType pointer, qint64 id,
                                QInputDevice::Capabilities can) {
    return QPointingDevice(QStringLiteral("test"), id, type, pointer, can, 10, 2, QString(),
                           QPointingDeviceUniqueId::fromNumericId(id));
  }
  void pen(QEvent::Type type, QPointF at, double pressure, QPointF tilt = {},
           const QPointingDevice* from = nullptr, Qt::MouseButton button = Qt::LeftButton) {
    if (from == nullptr) from = &pen_;
    const bool moves = type == QEvent::TabletMove;
    const bool down = type != QEvent::TabletRelease && (pressure > 0);
    QTabletEvent event(type, from, at, at, pressure, static_cast<float>(tilt.x()),
                       static_cast<float>(tilt.y()), 0, 0, 0, Qt::NoModifier, moves ? Qt::NoButton : button,
                       down ? Qt::MouseButtons(button) : Qt::NoButton);
    event.setTimestamp(now_ms_ += 20);
    QCoreApplication::sendEvent(&window_, &event);
    EXPECT_TRUE(event.isAccepted()) << "Qt would make a mouse of it";
  }
  void fingers(QEvent::Type type, const QList<std::pair<QEventPoint::State, QPointF>>& touches) {
    QList<QEventPoint> points;
    for (int i = 0; i < touches.size(); ++i)
      points.append(QEventPoint(i, touches[i].first, touches[i].second, touches[i].second));
    QTouchEvent event(type, &screen_, Qt::NoModifier, points);
    event.setTimestamp(now_ms_ += 20);
    QCoreApplication::sendEvent(&window_, &event);
    EXPECT_TRUE(event.isAccepted()) << "Qt would make a mouse of the palm";
  }

  QPointingDevice pen_ =
      device(QInputDevice::DeviceType::Stylus, PointerType::Pen, 7,
             Capability::Position | Capability::Pressure | Capability::XTilt | Capability::YTilt);
  QPointingDevice eraser_ = device(QInputDevice::DeviceType::Stylus, PointerType::Eraser, 8,
                                   Capability::Position | Capability::Pressure);
  QPointingDevice screen_ =
      device(QInputDevice::DeviceType::TouchScreen, PointerType::Finger, 9, Capability::Position);
  const QPointF middle_{400, 300};
  quint64 now_ms_ = 1000;
  WindowTablet controller_;
  TabletWindow window_{&controller_};
};

TEST_F(PenAndFingers, PressureOfThePenIsDepthOnTheTablet) {
  const double deepest_m = 1.5 * geometry::TabletShape{}.depth_m;
  pen(QEvent::TabletPress, middle_, 0.25);
  EXPECT_TRUE(controller_.is_pressed());
  EXPECT_NEAR(controller_.depth_m(), 0.25 * deepest_m, 1e-12);
  pen(QEvent::TabletMove, middle_, 0.75);
  EXPECT_NEAR(controller_.depth_m(), 0.75 * deepest_m, 1e-12);
  pen(QEvent::TabletRelease, middle_, 0);
  EXPECT_FALSE(controller_.is_pressed());
  EXPECT_TRUE(controller_.stylus_in_range()) << "it hovers";
}

TEST_F(PenAndFingers, TiltLeansTheDrawnBrushAsThePenLeans) {
  ASSERT_TRUE(controller_.overlay().cursor == std::nullopt);
  pen(QEvent::TabletPress, middle_, 0.5, {30, 0});
  const auto right = controller_.overlay().cursor->axis;
  EXPECT_NEAR(right.x, std::sin(std::numbers::pi / 6), 1e-6);
  EXPECT_NEAR(right.y, 0, 1e-6);
  EXPECT_NEAR(right.z, std::cos(std::numbers::pi / 6), 1e-6);
  EXPECT_NEAR(controller_.lean_rad(), std::numbers::pi / 6, 1e-6);
  pen(QEvent::TabletMove, middle_, 0.5, {0, 45});  // towards the learner: down on the tablet
  EXPECT_LT(controller_.overlay().cursor->axis.y, -0.7);
  QMouseEvent mouse(QEvent::MouseButtonPress, middle_, middle_, Qt::LeftButton, Qt::LeftButton,
                    Qt::NoModifier);
  QCoreApplication::sendEvent(&window_, &mouse);
  EXPECT_EQ(controller_.lean_rad(), 0) << "a mouse has no tilt";
}

TEST_F(PenAndFingers, APenWithoutTiltIsHeldAsAHandHoldsIt) {
  pen(QEvent::TabletPress, middle_, 0.5, {0, 0});
  EXPECT_EQ(controller_.overlay().cursor->axis, haptics::Vec3(0));
}

TEST_F(PenAndFingers, InkOfAFirmerOrFlatterBrushIsBroader) {
  const auto width = [](double pressure, double lean_rad) {
    return view::ink_half_width_m(practice::HandPoint{{}, 0, pressure, lean_rad});
  };
  EXPECT_GT(width(0.8, 0), width(0.2, 0));
  EXPECT_GT(width(0.5, 1.0), width(0.5, 0.5));
  EXPECT_GT(width(0.5, 0.5), width(0.5, 0));
  practice::PenRecorder recorder;
  recorder.lean(0.7);
  haptics::ServoSample sample;
  sample.touching = true;
  recorder.follow(sample);
  EXPECT_EQ(recorder.current().at(0).lean_rad, 0.7);
}

TEST_F(PenAndFingers, TheOtherEndOfThePenTakesBackAndWritesNothing) {
  int erased = 0;
  controller_.eraser_used.connect([&] { ++erased; });
  pen(QEvent::TabletPress, middle_, 0.5, {}, &eraser_);
  pen(QEvent::TabletMove, middle_ + QPointF(20, 0), 0.5, {}, &eraser_);
  EXPECT_FALSE(controller_.is_pressed());
  pen(QEvent::TabletRelease, middle_, 0, {}, &eraser_);
  EXPECT_EQ(erased, 1) << "once for each touch";
}

TEST_F(PenAndFingers, AButtonOnTheBarrelDoesNotEndTheStroke) {
  for (const auto button : {Qt::RightButton, Qt::MiddleButton}) {
    pen(QEvent::TabletPress, middle_, 0.5);
    pen(QEvent::TabletPress, middle_ + QPointF(10, 0), 0.5, {}, nullptr, button);
    EXPECT_TRUE(controller_.is_pressed()) << button;
    pen(QEvent::TabletMove, middle_ + QPointF(20, 0), 0.5);
    EXPECT_TRUE(controller_.is_pressed()) << button;
    pen(QEvent::TabletRelease, middle_ + QPointF(30, 0), 0.5, {}, nullptr, button);
    EXPECT_TRUE(controller_.is_pressed()) << "the tip is still down";
    pen(QEvent::TabletMove, middle_ + QPointF(40, 0), 0.5);
    EXPECT_TRUE(controller_.is_pressed()) << button;
    pen(QEvent::TabletRelease, middle_ + QPointF(50, 0), 0);
    EXPECT_FALSE(controller_.is_pressed()) << button;
  }
}

TEST_F(PenAndFingers, AButtonInHoverWritesNothing) {
  for (const auto button : {Qt::RightButton, Qt::MiddleButton}) {
    pen(QEvent::TabletMove, middle_, 0);
    pen(QEvent::TabletPress, middle_, 0, {}, nullptr, button);
    pen(QEvent::TabletMove, middle_ + QPointF(5, 0), 0);
    EXPECT_FALSE(controller_.is_pressed()) << button;
    // The tip comes down while the button turns or moves the tablet: that is no writing.
    pen(QEvent::TabletPress, middle_, 0.5);
    EXPECT_FALSE(controller_.is_pressed()) << button;
    pen(QEvent::TabletRelease, middle_, 0.5, {}, nullptr, button);
    pen(QEvent::TabletMove, middle_, 0.5);
    EXPECT_FALSE(controller_.is_pressed()) << "a stroke does not begin in the air";
    pen(QEvent::TabletRelease, middle_, 0);
    pen(QEvent::TabletPress, middle_, 0.5);
    EXPECT_TRUE(controller_.is_pressed()) << button;
    pen(QEvent::TabletRelease, middle_, 0);
  }
}

TEST_F(PenAndFingers, EveryMoveOfAFastPenReachesTheServoInItsOwnTime) {
  // Ten moves at once, as after the window was busy: 20 ms apart, 40 px each.
  const QPointF from = middle_ - QPointF(100, 0);
  pen(QEvent::TabletPress, from, 0.5);
  std::vector<double> seen_x_m;
  controller_.sampled.connect([&](std::span<const haptics::ServoSample> samples) {
    for (const auto& sample : samples) seen_x_m.push_back(sample.device_m.x);
  });
  // There and back: if only the last event were used, there would be no stroke.
  for (const double x : {40., 80., 120., 160., 200., 160., 120., 80., 40., 0.})
    pen(QEvent::TabletMove, from + QPointF(x, 0), 0.5);
  const double begin_m =
      view::point_under(view::Camera::resting(), controller_.style(), {}, {from.x(), from.y()}, 800, 600)->x;
  const double end_m = view::point_under(view::Camera::resting(), controller_.style(), {},
                                         {from.x() + 200, from.y()}, 800, 600)
                           ->x;
  EXPECT_TRUE(QTest::qWaitFor([&] {
    return !seen_x_m.empty() &&
           *std::max_element(seen_x_m.begin(), seen_x_m.end()) > begin_m + 0.5 * (end_m - begin_m);
  }));
}

TEST_F(PenAndFingers, AFingerWritesWhileNoPenIsNear) {
  fingers(QEvent::TouchBegin, {{QEventPoint::Pressed, middle_}});
  EXPECT_TRUE(controller_.is_pressed());
  fingers(QEvent::TouchEnd, {{QEventPoint::Released, middle_}});
  EXPECT_FALSE(controller_.is_pressed());
  EXPECT_FALSE(controller_.stylus_in_range());
}

TEST_F(PenAndFingers, ThePalmDoesNothingWhileThePenWritesOrIsNear) {
  pen(QEvent::TabletPress, middle_, 0.5);
  fingers(QEvent::TouchBegin, {{QEventPoint::Pressed, middle_ + QPointF(150, 150)}});
  EXPECT_TRUE(controller_.is_pressed()) << "the pen goes on";
  fingers(QEvent::TouchEnd, {{QEventPoint::Released, middle_ + QPointF(150, 150)}});
  EXPECT_TRUE(controller_.is_pressed());
  pen(QEvent::TabletRelease, middle_, 0);

  QTabletEvent near(QEvent::TabletEnterProximity, &pen_, {}, {}, 0, 0, 0, 0, 0, 0, Qt::NoModifier,
                    Qt::NoButton, Qt::NoButton);
  QCoreApplication::sendEvent(QCoreApplication::instance(), &near);
  QTest::qWait(700);  // longer than the time after which a palm counts as a finger
  fingers(QEvent::TouchBegin, {{QEventPoint::Pressed, middle_}});
  EXPECT_FALSE(controller_.is_pressed()) << "the pen hovers";
  fingers(QEvent::TouchEnd, {{QEventPoint::Released, middle_}});
  QTabletEvent away(QEvent::TabletLeaveProximity, &pen_, {}, {}, 0, 0, 0, 0, 0, 0, Qt::NoModifier,
                    Qt::NoButton, Qt::NoButton);
  QCoreApplication::sendEvent(QCoreApplication::instance(), &away);
  EXPECT_TRUE(QTest::qWaitFor([&] {
    QTest::qWait(50);
    fingers(QEvent::TouchBegin, {{QEventPoint::Pressed, middle_}});
    return controller_.is_pressed();
  })) << "the pen is put away";
}

TEST_F(PenAndFingers, ATouchThatIsCancelledOrBecomesTwoWritesNoFurther) {
  fingers(QEvent::TouchBegin, {{QEventPoint::Pressed, middle_}});
  ASSERT_TRUE(controller_.is_pressed());
  fingers(QEvent::TouchCancel, {});
  EXPECT_FALSE(controller_.is_pressed()) << "Qt found that it was a palm";

  fingers(QEvent::TouchBegin, {{QEventPoint::Pressed, middle_}});
  fingers(QEvent::TouchUpdate,
          {{QEventPoint::Stationary, middle_}, {QEventPoint::Pressed, middle_ + QPointF(80, 0)}});
  EXPECT_FALSE(controller_.is_pressed()) << "two fingers move the tablet";
  fingers(QEvent::TouchUpdate,
          {{QEventPoint::Updated, middle_}, {QEventPoint::Released, middle_ + QPointF(80, 0)}});
  EXPECT_FALSE(controller_.is_pressed()) << "the one that is left is on its way up";
}

}  // namespace
}  // namespace nazori::ui
