// SPDX-License-Identifier: Apache-2.0
// How mouse and keys change the view of the tablet. Nothing is drawn.
#include <gtest/gtest.h>

#include <QDropEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>
#include <QUrl>
#include <QWheelEvent>
#include <cmath>

#include "nazori/widgets/tablet/tablet_window.h"
#include "nazori/widgets/tablet/window_tablet.h"

namespace nazori::ui {
namespace {

class CameraByHand : public testing::Test {
 protected:
  CameraByHand() {
    std::vector<kanji::StrokeLine> lines(1);
    lines[0].points = {{20, 54.5}, {89, 54.5}};
    controller_.set_tablet(*tablet::CarvedTablet::from_lines(tablet::tablet_lines(lines), 64));
    window_.resize(800, 600);
    window_.set_reduced_motion(true);
    controller_.pressed.connect([this](const geometry::TabletPoint& at) { pressed_ = at; });
  }
  void mouse(QEvent::Type type, QPointF at, Qt::MouseButton button, Qt::MouseButtons down,
             Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QMouseEvent event(type, at, at, button, down, modifiers);
    QCoreApplication::sendEvent(&window_, &event);
  }
  void press(QPointF at, Qt::MouseButton button, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    mouse(QEvent::MouseButtonPress, at, button, button, modifiers);
  }
  void move(QPointF at, Qt::MouseButton held) { mouse(QEvent::MouseMove, at, Qt::NoButton, held); }
  void release(QPointF at, Qt::MouseButton button) {
    mouse(QEvent::MouseButtonRelease, at, button, Qt::NoButton);
  }
  /// The point of the tablet at this distance from the middle of the window, as a click finds it.
  geometry::TabletPoint under(double right, double down) {
    pressed_ = {9, 9};
    const QPointF at(400 + right, 300 + down);
    press(at, Qt::LeftButton);
    release(at, Qt::LeftButton);
    return pressed_;
  }
  static void expect_same(const geometry::TabletPoint& a, const geometry::TabletPoint& b) {
    EXPECT_NEAR(a.x, b.x, 1e-9);
    EXPECT_NEAR(a.y, b.y, 1e-9);
  }

  geometry::TabletPoint pressed_;
  WindowTablet controller_;
  TabletWindow window_{&controller_};
};

TEST_F(CameraByHand, NearerShowsLessOfTheTabletAndFartherMore) {
  const auto first = under(100, 0);
  window_.zoom_by(1.25);
  const auto nearer = under(100, 0);
  EXPECT_NEAR(nearer.x, first.x / 1.25, 1e-3);
  window_.zoom_by(1 / 1.25);
  expect_same(under(100, 0), first);
  window_.zoom_by(1 / 1.25);
  EXPECT_GT(under(100, 0).x, first.x);
  window_.reset_camera();
  expect_same(under(100, 0), first);
}

TEST_F(CameraByHand, ATurnToTheRightIsTheMirrorImageOfOneToTheLeft) {
  const auto first = under(100, 40);
  window_.orbit_by(40, 0);
  const auto right = under(100, 40);
  EXPECT_GT(std::abs(right.y - first.y) + std::abs(right.x - first.x), 1e-3);
  window_.orbit_by(-80, 0);
  const auto left = under(-100, 40);
  EXPECT_NEAR(left.x, -right.x, 1e-9);
  EXPECT_NEAR(left.y, right.y, 1e-9);
  window_.orbit_by(40, 0);
  expect_same(under(100, 40), first);
}

TEST_F(CameraByHand, ADragUpwardsLaysTheTabletFlatter) {
  // Flatter, the same pixels hold more of the tablet.
  const auto held = [this] { return under(0, -30).y - under(0, 30).y; };
  const auto first = under(0, -60);
  const double upright = held();
  window_.orbit_by(0, -60);
  EXPECT_GT(held(), upright + 1e-4);
  window_.orbit_by(0, 60);
  expect_same(under(0, -60), first);
}

TEST_F(CameraByHand, TheRightButtonTurnsAsTheKeysDo) {
  window_.orbit_by(40, 20);
  const auto by_key = under(100, 40);
  window_.reset_camera();
  press({400, 300}, Qt::RightButton);
  move({430, 300}, Qt::RightButton);
  move({440, 320}, Qt::RightButton);
  // Another button on the way changes nothing.
  press({440, 320}, Qt::LeftButton);
  EXPECT_FALSE(controller_.is_pressed());
  release({440, 320}, Qt::LeftButton);
  move({441, 320}, Qt::RightButton);
  move({440, 320}, Qt::RightButton);
  release({440, 320}, Qt::RightButton);
  expect_same(under(100, 40), by_key);
  move({500, 300}, Qt::NoButton);
  expect_same(under(100, 40), by_key);
}

TEST_F(CameraByHand, TheMiddleButtonAndTheRightOneWithShiftTakeTheTabletAlong) {
  for (const auto& [button, modifiers] : {std::pair(Qt::MiddleButton, Qt::KeyboardModifiers()),
                                          {Qt::RightButton, Qt::KeyboardModifiers(Qt::ShiftModifier)}}) {
    const auto first = under(0, 0);
    press({400, 300}, button, modifiers);
    move({440, 320}, button);
    EXPECT_FALSE(controller_.stylus_in_range() && controller_.is_pressed());
    move({430, 340}, button);
    release({430, 340}, button);
    expect_same(under(30, 40), first);
    window_.reset_camera();
    expect_same(under(0, 0), first);
  }
}

TEST_F(CameraByHand, TheKeysMoveTheMiddleOfTheView) {
  const auto first = under(0, 0);
  window_.pan_by(40, -30);
  expect_same(under(40, -30), first);
  window_.reset_camera();
  window_.pan_by(-25, 10);
  expect_same(under(-25, 10), first);
}

TEST_F(CameraByHand, TheWheelMagnifiesAroundThePointer) {
  const auto wheel = [this](QPointF at, int by) {
    QWheelEvent event(at, at, {}, QPoint(0, by), Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&window_, &event);
  };
  window_.zoom_by(1.15 * 1.15);
  const auto by_key = under(100, 40);
  window_.reset_camera();
  const auto first = under(100, 40), middle = under(0, 0);
  wheel({400, 300}, 240);
  expect_same(under(100, 40), by_key);
  wheel({400, 300}, -240);
  expect_same(under(100, 40), first);
  wheel({500, 340}, 240);
  expect_same(under(100, 40), first);
  const auto now = under(0, 0);
  EXPECT_GT(now.x, middle.x + 1e-4) << "nearer to the pointer";
  EXPECT_LT(now.y, middle.y - 1e-4);
}

TEST_F(CameraByHand, TheLeftButtonWritesFromItsPressToItsRelease) {
  press({400, 300}, Qt::LeftButton);
  EXPECT_TRUE(controller_.is_pressed());
  const double depth_m = controller_.depth_m();
  move({420, 300}, Qt::LeftButton);
  EXPECT_TRUE(controller_.is_pressed());
  release({420, 300}, Qt::RightButton);
  EXPECT_TRUE(controller_.is_pressed()) << "another button";
  // The wheel towards the learner pushes deeper, away from him less deep.
  const auto wheel = [this](int notches) {
    QWheelEvent event(QPointF(400, 300), QPointF(400, 300), {}, QPoint(0, 120 * notches), Qt::LeftButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&window_, &event);
  };
  wheel(1);
  const double shape_depth_m = geometry::TabletShape{}.depth_m;
  EXPECT_NEAR(controller_.depth_m(), depth_m - 0.05 * shape_depth_m, 1e-12);
  wheel(-3);
  EXPECT_NEAR(controller_.depth_m(), depth_m + 0.1 * shape_depth_m, 1e-12);
  QEvent leave(QEvent::Leave);
  QCoreApplication::sendEvent(&window_, &leave);
  EXPECT_TRUE(controller_.is_pressed()) << "in the middle of a stroke";
  release({420, 300}, Qt::LeftButton);
  EXPECT_FALSE(controller_.is_pressed());
  EXPECT_TRUE(controller_.stylus_in_range());
  QCoreApplication::sendEvent(&window_, &leave);
  EXPECT_FALSE(controller_.stylus_in_range());
}

TEST_F(CameraByHand, AMoveWithoutAButtonHovers) {
  move({410, 300}, Qt::NoButton);
  EXPECT_TRUE(controller_.stylus_in_range());
  EXPECT_FALSE(controller_.is_pressed());
  EXPECT_EQ(window_.cursor().shape(), Qt::BlankCursor) << "the drawn stylus is the pointer";
  move({5, 5}, Qt::NoButton);
  EXPECT_EQ(window_.cursor().shape(), Qt::ArrowCursor);
}

TEST_F(CameraByHand, HomeComesBackAndTabGoesOn) {
  const auto key = [this](Qt::Key which) {
    QKeyEvent event(QEvent::KeyPress, which, Qt::NoModifier);
    QCoreApplication::sendEvent(&window_, &event);
  };
  const auto first = under(100, 40);
  window_.orbit_by(30, 10);
  window_.zoom_by(1.5);
  key(Qt::Key_Home);
  expect_same(under(100, 40), first);
  QSignalSpy leaves(&window_, &TabletWindow::focus_leaves);
  key(Qt::Key_Tab);
  key(Qt::Key_Backtab);
  key(Qt::Key_X);
  ASSERT_EQ(leaves.count(), 2);
  EXPECT_TRUE(leaves.at(0).at(0).toBool());
  EXPECT_FALSE(leaves.at(1).at(0).toBool());
}

TEST_F(CameraByHand, AnotherStyleBringsItsOwnViewUnlessTheLearnerChoseOne) {
  const auto wood = under(100, 40);
  controller_.set_style(view::Style::classic);
  const auto classic = under(100, 40);
  EXPECT_GT(std::hypot(wood.x - classic.x, wood.y - classic.y), 1e-4);
  controller_.set_style(view::Style::wood);
  expect_same(under(100, 40), wood);
  window_.orbit_by(30, 0);
  const auto chosen = under(100, 40);
  controller_.set_style(view::Style::slate);
  expect_same(under(100, 40), chosen);
}

TEST_F(CameraByHand, WithMotionTheViewGlidesToTheSamePlace) {
  ASSERT_TRUE(controller_.start());
  window_.zoom_by(1.5);
  const auto at_once = under(100, 0);
  window_.reset_camera();
  const auto before = under(100, 0);
  // The stylus only hovers, because a press would keep the view from moving.
  const auto hovers_at_m = [&] {
    move({500, 300}, Qt::NoButton);
    return controller_.latest().device_m.x;
  };
  ASSERT_TRUE(QTest::qWaitFor([&] { return std::abs(hovers_at_m() - before.x) < 1e-7; }, 10'000));
  window_.set_reduced_motion(false);
  window_.zoom_by(1.5);
  bool on_the_way = false;
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        const double x = hovers_at_m();
        on_the_way = on_the_way || (x > at_once.x + 1e-5 && x < before.x - 1e-5);
        return std::abs(x - at_once.x) < 1e-7;
      },
      10'000));
  EXPECT_TRUE(on_the_way);
}

TEST_F(CameraByHand, LocalFilesCanBeDropped) {
  QSignalSpy dropped(&window_, &TabletWindow::files_dropped);
  QMimeData files;
  files.setUrls({QUrl::fromLocalFile(QStringLiteral("/pictures/a.raw")),
                 QUrl(QStringLiteral("https://a.b/c.raw")),
                 QUrl::fromLocalFile(QStringLiteral("/pictures/b.str"))});
  QMimeData web;
  web.setUrls({QUrl(QStringLiteral("https://a.b/c.raw"))});
  const auto enters = [this](const QMimeData& data) {
    QDragEnterEvent event(QPoint(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    event.ignore();
    QCoreApplication::sendEvent(&window_, &event);
    return event.isAccepted();
  };
  EXPECT_TRUE(enters(files));
  EXPECT_FALSE(enters(web));
  QDropEvent drop(QPointF(10, 10), Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&window_, &drop);
  ASSERT_EQ(dropped.count(), 1);
  EXPECT_EQ(dropped.at(0).at(0).toStringList(),
            (QStringList{QStringLiteral("/pictures/a.raw"), QStringLiteral("/pictures/b.str")}));
}

TEST_F(CameraByHand, AsksForOpenGL3_3WithoutADepthOfItsOwn) {
  const QSurfaceFormat format = TabletWindow::surface_format();
  EXPECT_EQ(format.majorVersion(), 3);
  EXPECT_EQ(format.minorVersion(), 3);
  EXPECT_EQ(format.profile(), QSurfaceFormat::CoreProfile);
  EXPECT_EQ(format.swapInterval(), 1);
}

}  // namespace
}  // namespace nazori::ui
