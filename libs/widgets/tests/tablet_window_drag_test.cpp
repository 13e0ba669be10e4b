// SPDX-License-Identifier: Apache-2.0
// Which button of which pointer writes, turns or moves, from its press to its release.
#include <gtest/gtest.h>

#include <QDropEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QMouseEvent>
#include <QPointingDevice>
#include <QSignalSpy>
#include <QTabletEvent>
#include <QTouchEvent>
#include <QUrl>
#include <QWheelEvent>
#include <cmath>

#include "nazori/widgets/tablet/tablet_window.h"
#include "nazori/widgets/tablet/window_tablet.h"

namespace nazori::ui {
namespace {

using Capability = QInputDevice::Capability;
using PointerType = QPointingDevice::PointerType;

class DragsOnTheTablet : public testing::Test {
 protected:
  DragsOnTheTablet() {
    std::vector<kanji::StrokeLine> lines(1);
    lines[0].points = {{20, 54.5}, {89, 54.5}};
    controller_.set_tablet(*tablet::CarvedTablet::from_lines(tablet::tablet_lines(lines), 64));
    window_.resize(800, 600);
    window_.set_reduced_motion(true);
    controller_.pressed.connect([this](const geometry::TabletPoint& at) { pressed_ = at; });
  }
  void mouse(QEvent::Type type, QPointF at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers = {}) {
    QMouseEvent event(type, at, at, button, button, modifiers);
    QCoreApplication::sendEvent(&window_, &event);
  }
  void press(QPointF at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers = {}) {
    mouse(QEvent::MouseButtonPress, at, button, modifiers);
  }
  void move(QPointF at) { mouse(QEvent::MouseMove, at, Qt::NoButton); }
  void release(QPointF at, Qt::MouseButton button) { mouse(QEvent::MouseButtonRelease, at, button); }
  void pen(QEvent::Type type, QPointF at, double pressure, Qt::MouseButton button) {
    QTabletEvent event(type, &pen_, at, at, pressure, 0, 0, 0, 0, 0, Qt::NoModifier, button, button);
    QCoreApplication::sendEvent(&window_, &event);
  }
  void fingers(QEvent::Type type, const QList<std::pair<QEventPoint::State, QPointF>>& touches) {
    QList<QEventPoint> points;
    for (int i = 0; i < touches.size(); ++i)
      points.append(QEventPoint(i, touches[i].first, touches[i].second, touches[i].second));
    QTouchEvent event(type, &screen_, Qt::NoModifier, points);
    QCoreApplication::sendEvent(&window_, &event);
    EXPECT_TRUE(event.isAccepted());
  }
  /// Where a click of the mouse beside the middle reaches the tablet; the stylus is lifted afterwards.
  geometry::TabletPoint under() {
    pressed_ = {9, 9};
    press({500, 340}, Qt::LeftButton);
    release({500, 340}, Qt::LeftButton);
    lift();
    return pressed_;
  }
  void lift() {
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&window_, &leave);
    EXPECT_FALSE(controller_.stylus_in_range());
  }
  static bool same(const geometry::TabletPoint& a, const geometry::TabletPoint& b) {
    return std::hypot(a.x - b.x, a.y - b.y) < 1e-9;
  }

  QPointingDevice pen_{QStringLiteral("pen"),
                       41,
                       QInputDevice::DeviceType::Stylus,
                       PointerType::Pen,
                       Capability::Position | Capability::Pressure,
                       1,
                       3};
  QPointingDevice screen_{QStringLiteral("screen"),
                          42,
                          QInputDevice::DeviceType::TouchScreen,
                          PointerType::Finger,
                          Capability::Position,
                          10,
                          0};
  geometry::TabletPoint pressed_;
  WindowTablet controller_;
  TabletWindow window_{&controller_};
};

TEST_F(DragsOnTheTablet, AMoveOfTheTabletEndsWithItsButtonAndMovesNoStylus) {
  for (const auto& [button, modifiers, other] :
       {std::tuple(Qt::MiddleButton, Qt::KeyboardModifiers(), Qt::LeftButton),
        {Qt::RightButton, Qt::KeyboardModifiers(Qt::ShiftModifier), Qt::LeftButton},
        {Qt::RightButton, Qt::KeyboardModifiers(), Qt::MiddleButton}}) {
    press({400, 300}, button, modifiers);
    EXPECT_FALSE(controller_.stylus_in_range());
    move({405, 300});
    EXPECT_FALSE(controller_.stylus_in_range());
    release({405, 300}, other);
    move({400, 300});
    EXPECT_FALSE(controller_.stylus_in_range()) << "another button ends nothing";
    release({400, 300}, button);
    EXPECT_TRUE(controller_.stylus_in_range()) << "it hovers again";
    EXPECT_FALSE(controller_.is_pressed());
    lift();
  }
}

TEST_F(DragsOnTheTablet, WhileTheStylusWritesOtherButtonsDoNothing) {
  const auto before = under();
  press({400, 300}, Qt::LeftButton);
  for (const auto button : {Qt::RightButton, Qt::MiddleButton}) {
    press({410, 300}, button);
    move({450, 330});
    EXPECT_TRUE(controller_.is_pressed());
    release({450, 330}, button);
    EXPECT_TRUE(controller_.is_pressed());
  }
  release({450, 330}, Qt::LeftButton);
  EXPECT_FALSE(controller_.is_pressed());
  lift();
  EXPECT_TRUE(same(under(), before)) << "the view did not turn";
}

TEST_F(DragsOnTheTablet, ABackButtonOfTheMouseIsNoButtonOfTheTablet) {
  const auto before = under();
  press({400, 300}, Qt::BackButton);
  EXPECT_FALSE(controller_.is_pressed());
  move({450, 330});
  EXPECT_FALSE(controller_.is_pressed());
  EXPECT_TRUE(controller_.stylus_in_range()) << "it hovers";
  release({450, 330}, Qt::BackButton);
  lift();
  EXPECT_TRUE(same(under(), before));
}

TEST_F(DragsOnTheTablet, TheLowerButtonOfThePenTurnsAsTheMouseDoes) {
  window_.orbit_by(40, 20);
  const auto by_keys = under();
  window_.reset_camera();
  const auto at_home = under();
  pen(QEvent::TabletMove, {400, 300}, 0, Qt::NoButton);
  lift();
  pen(QEvent::TabletPress, {400, 300}, 0, Qt::RightButton);
  EXPECT_FALSE(controller_.stylus_in_range());
  pen(QEvent::TabletMove, {430, 305}, 0, Qt::NoButton);
  EXPECT_FALSE(controller_.stylus_in_range()) << "it turns";
  pen(QEvent::TabletRelease, {430, 305}, 0, Qt::MiddleButton);
  pen(QEvent::TabletMove, {440, 320}, 0, Qt::NoButton);
  EXPECT_FALSE(controller_.stylus_in_range()) << "another button ends nothing";
  pen(QEvent::TabletRelease, {440, 320}, 0, Qt::RightButton);
  EXPECT_TRUE(controller_.stylus_in_range());
  lift();
  EXPECT_TRUE(same(under(), by_keys));
  EXPECT_FALSE(same(by_keys, at_home));
  // The other one moves the tablet.
  pen(QEvent::TabletPress, {400, 300}, 0, Qt::MiddleButton);
  pen(QEvent::TabletMove, {430, 305}, 0, Qt::NoButton);
  EXPECT_FALSE(controller_.stylus_in_range());
  pen(QEvent::TabletRelease, {430, 305}, 0, Qt::RightButton);
  pen(QEvent::TabletMove, {400, 300}, 0, Qt::NoButton);
  EXPECT_FALSE(controller_.stylus_in_range());
  pen(QEvent::TabletRelease, {400, 300}, 0, Qt::MiddleButton);
  EXPECT_TRUE(controller_.stylus_in_range());
}

TEST_F(DragsOnTheTablet, AfterTwoFingersOneWritesOnceBothWereLifted) {
  const QPointF one(400, 300), two(480, 300);
  using State = QEventPoint::State;
  fingers(QEvent::TouchBegin, {{State::Pressed, one}, {State::Pressed, two}});
  EXPECT_FALSE(controller_.stylus_in_range()) << "both at once write nothing";
  fingers(QEvent::TouchUpdate, {{State::Updated, one + QPointF(5, 0)}, {State::Stationary, two}});
  EXPECT_FALSE(controller_.stylus_in_range());
  fingers(QEvent::TouchUpdate, {{State::Stationary, one}, {State::Released, two}});
  fingers(QEvent::TouchUpdate, {{State::Updated, one + QPointF(9, 0)}});
  EXPECT_FALSE(controller_.stylus_in_range()) << "the last one is being lifted";
  fingers(QEvent::TouchEnd, {{State::Released, one}});
  EXPECT_FALSE(controller_.stylus_in_range());
  fingers(QEvent::TouchBegin, {{State::Pressed, one}});
  EXPECT_TRUE(controller_.is_pressed());
  fingers(QEvent::TouchUpdate, {{State::Updated, one + QPointF(9, 0)}});
  EXPECT_TRUE(controller_.is_pressed());
  fingers(QEvent::TouchEnd, {{State::Released, one + QPointF(9, 0)}});
  EXPECT_FALSE(controller_.is_pressed());
  EXPECT_FALSE(controller_.stylus_in_range());
}

TEST_F(DragsOnTheTablet, ACancelledGestureOfTwoLeavesAMouseAlone) {
  using State = QEventPoint::State;
  fingers(QEvent::TouchBegin, {{State::Pressed, {400, 300}}, {State::Pressed, {480, 300}}});
  move({410, 300});
  EXPECT_TRUE(controller_.stylus_in_range());
  fingers(QEvent::TouchCancel, {});
  EXPECT_TRUE(controller_.stylus_in_range()) << "no finger had the stylus";
  fingers(QEvent::TouchBegin, {{State::Pressed, {400, 300}}});
  EXPECT_TRUE(controller_.is_pressed()) << "a gesture that was cancelled is over";
  fingers(QEvent::TouchUpdate, {});
  EXPECT_FALSE(controller_.stylus_in_range()) << "without a point nothing touches";
}

TEST_F(DragsOnTheTablet, KeysOfTheWindowGoOnAndWhatIsDroppedIsTaken) {
  const auto taken = [this](Qt::Key which) {
    QKeyEvent event(QEvent::KeyPress, which, Qt::NoModifier);
    QCoreApplication::sendEvent(&window_, &event);
    return event.isAccepted();
  };
  EXPECT_TRUE(taken(Qt::Key_Home));
  EXPECT_TRUE(taken(Qt::Key_Tab));
  EXPECT_FALSE(taken(Qt::Key_X));
  QMimeData files;
  files.setUrls({QUrl::fromLocalFile(QStringLiteral("/a.raw"))});
  QDropEvent drop(QPointF(10, 10), Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
  drop.ignore();
  QCoreApplication::sendEvent(&window_, &drop);
  EXPECT_TRUE(drop.isAccepted());
}

TEST_F(DragsOnTheTablet, WhileABrushWritesByItselfThePointerIsSeen) {
  move({400, 300});
  EXPECT_EQ(window_.cursor().shape(), Qt::BlankCursor);
  practice::Demonstration brush;
  brush.ink = {0.5};
  brush.moving = true;
  controller_.set_demonstration(brush);
  move({401, 300});
  EXPECT_EQ(window_.cursor().shape(), Qt::ArrowCursor);
  controller_.set_demonstration({});
  move({400, 300});
  EXPECT_EQ(window_.cursor().shape(), Qt::BlankCursor);
}

TEST_F(DragsOnTheTablet, AViewThatWasTiltedOrZoomedStaysWithAnotherStyle) {
  for (const bool zooms : {false, true}) {
    controller_.set_style(view::Style::wood);
    window_.reset_camera();
    const auto home = under();
    if (zooms)
      window_.zoom_by(1.3);
    else
      window_.orbit_by(0, 30);
    const auto chosen = under();
    EXPECT_FALSE(same(chosen, home));
    controller_.set_style(view::Style::classic);
    controller_.set_style(view::Style::wood);
    EXPECT_TRUE(same(under(), chosen)) << zooms;
    window_.reset_camera();
    controller_.set_style(view::Style::classic);
    const auto classic = under();
    window_.reset_camera();
    EXPECT_TRUE(same(under(), classic)) << "from one home to the other";
  }
}

TEST_F(DragsOnTheTablet, TwoFingersMoveAndMagnifyTheTabletAsTheMouseDoes) {
  press({450, 300}, Qt::MiddleButton);
  move({460, 330});
  release({460, 330}, Qt::MiddleButton);
  QWheelEvent wheel(QPointF(460, 330), QPointF(460, 330), {}, QPoint(0, 120), Qt::NoButton, Qt::NoModifier,
                    Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&window_, &wheel);
  const auto by_mouse = under();
  window_.reset_camera();
  const auto home = under();
  EXPECT_FALSE(same(home, by_mouse));
  const auto pinch = [this](QEvent::Type type, QEventPoint::State state, QPointF middle, double apart) {
    fingers(type, {{state, middle - QPointF(apart / 2, 0)}, {state, middle + QPointF(apart / 2, 0)}});
  };
  using State = QEventPoint::State;
  pinch(QEvent::TouchBegin, State::Pressed, {450, 300}, 100);
  pinch(QEvent::TouchUpdate, State::Updated, {460, 330}, 100 * view::Camera::kZoomStep);
  pinch(QEvent::TouchEnd, State::Released, {460, 330}, 100 * view::Camera::kZoomStep);
  EXPECT_TRUE(same(under(), by_mouse));
  // From or to one and the same place there is no share by which they came apart.
  window_.reset_camera();
  pinch(QEvent::TouchBegin, State::Pressed, {450, 300}, 0);
  pinch(QEvent::TouchUpdate, State::Updated, {450, 300}, 100);
  pinch(QEvent::TouchUpdate, State::Updated, {450, 300}, 1);
  pinch(QEvent::TouchUpdate, State::Updated, {450, 300}, 50);
  pinch(QEvent::TouchEnd, State::Released, {450, 300}, 50);
  EXPECT_TRUE(same(under(), home));
}

TEST_F(DragsOnTheTablet, AWheelWithoutAPressChangesNoDepth) {
  press({400, 300}, Qt::LeftButton);
  const double depth_m = controller_.depth_m();
  release({400, 300}, Qt::LeftButton);
  QWheelEvent wheel(QPointF(400, 300), QPointF(400, 300), {}, QPoint(0, 240), Qt::NoButton, Qt::NoModifier,
                    Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&window_, &wheel);
  press({400, 300}, Qt::LeftButton);
  EXPECT_EQ(controller_.depth_m(), depth_m);
  release({400, 300}, Qt::LeftButton);
}

}  // namespace
}  // namespace nazori::ui
