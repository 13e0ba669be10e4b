// SPDX-License-Identifier: Apache-2.0
#include "characters/drawing_pad.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QSignalSpy>
#include <QTabletEvent>
#include <QTest>

#include "nazori/widgets/look/palette.h"
#include "picture_under_test.h"

namespace nazori::ui {
namespace {

class Pad : public testing::Test {
 protected:
  Pad() { pad_.resize(200, 300); }
  void move(QPoint at) {
    QMouseEvent event(QEvent::MouseMove, at, at, Qt::NoButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&pad_, &event);
  }
  void draw(QPoint from, QPoint to, Qt::MouseButton button = Qt::LeftButton) {
    QTest::mousePress(&pad_, button, {}, from);
    move((from + to) / 2);
    move(to);
    QTest::mouseRelease(&pad_, button, {}, to);
  }
  DrawingPad pad_;
};

TEST_F(Pad, StrokesAreMeasuredInSidesOfThePad) {
  draw({20, 40}, {120, 140});
  ASSERT_EQ(pad_.ink().strokes.size(), 1U);
  const auto& stroke = pad_.ink().strokes[0];
  ASSERT_EQ(stroke.size(), 3U);
  EXPECT_DOUBLE_EQ(stroke[0].at.x, 0.1);
  EXPECT_DOUBLE_EQ(stroke[0].at.y, 0.2);
  EXPECT_DOUBLE_EQ(stroke[2].at.x, 0.6);
  EXPECT_DOUBLE_EQ(stroke[2].at.y, 0.7);
  for (const auto& point : stroke) EXPECT_TRUE(point.time_s && point.pressure);
  EXPECT_LE(stroke[0].time_s, stroke[2].time_s);
  EXPECT_EQ(pad_.ink().box->side, 1);
  EXPECT_EQ(pad_.heightForWidth(123), 123);
}

TEST_F(Pad, ATapAnotherButtonAndAMoveWithoutAPressAreNoStrokes) {
  QSignalSpy drawn(&pad_, &DrawingPad::drawn);
  draw({20, 20}, {120, 20}, Qt::RightButton);
  EXPECT_EQ(drawn.count(), 0);
  QTest::mouseClick(&pad_, Qt::LeftButton, {}, {50, 50});
  EXPECT_TRUE(pad_.ink().strokes.empty());
  draw({20, 20}, {120, 20});
  move({150, 20});
  EXPECT_EQ(pad_.ink().strokes[0].size(), 3U);
  const auto before = drawn.count();
  QTest::mouseRelease(&pad_, Qt::LeftButton, {}, {150, 20});
  EXPECT_EQ(drawn.count(), before);
  QTest::mousePress(&pad_, Qt::LeftButton, {}, {50, 60});
  QTest::mouseRelease(&pad_, Qt::RightButton, {}, {50, 60});
  move({90, 60});
  EXPECT_EQ(pad_.ink().strokes.size(), 2U);
  EXPECT_EQ(pad_.ink().strokes[1].size(), 2U) << "the other button ends nothing";
}

TEST_F(Pad, PointsThatLieTooNearAreLeftOut) {
  pad_.resize(1000, 1000);
  QTest::mousePress(&pad_, Qt::LeftButton, {}, {100, 100});
  move({103, 100});
  EXPECT_EQ(pad_.ink().strokes[0].size(), 1U);
  move({105, 100});
  EXPECT_EQ(pad_.ink().strokes[0].size(), 2U);
}

TEST_F(Pad, UndoTakesTheLastStrokeAndClearAll) {
  QSignalSpy drawn(&pad_, &DrawingPad::drawn);
  pad_.undo();
  EXPECT_EQ(drawn.count(), 0) << "there was none";
  draw({20, 20}, {120, 20});
  draw({20, 60}, {120, 60});
  drawn.clear();
  pad_.undo();
  EXPECT_EQ(drawn.count(), 1);
  ASSERT_EQ(pad_.ink().strokes.size(), 1U);
  EXPECT_DOUBLE_EQ(pad_.ink().strokes[0][0].at.y, 0.1);
  pad_.clear();
  EXPECT_EQ(drawn.count(), 2);
  EXPECT_TRUE(pad_.ink().strokes.empty());
  // If the pad is cleared in the middle of a stroke, the rest of that stroke is ignored.
  for (const bool all : {true, false}) {
    QTest::mousePress(&pad_, Qt::LeftButton, {}, {20, 20});
    all ? pad_.clear() : pad_.undo();
    move({120, 20});
    QTest::mouseRelease(&pad_, Qt::LeftButton, {}, {120, 20});
    EXPECT_TRUE(pad_.ink().strokes.empty());
  }
}

TEST_F(Pad, APenHasItsPressureAndItsOtherEndRubsOut) {
  const auto send = [this](QEvent::Type type, QPointF at, double pressure,
                           QPointingDevice::PointerType pointer) {
    // Qt may remember a device that it has seen.
    auto* device = new QPointingDevice(QStringLiteral("pen"), 1, QInputDevice::DeviceType::Stylus, pointer,
                                       QInputDevice::Capability::Pressure, 1, 2, QString(), {}, qApp);
    QTabletEvent event(type, device, at, at, pressure, 0, 0, 0, 0, 0, Qt::NoModifier, Qt::LeftButton,
                       Qt::LeftButton);
    QCoreApplication::sendEvent(&pad_, &event);
    EXPECT_TRUE(event.isAccepted());
  };
  using Pointer = QPointingDevice::PointerType;
  send(QEvent::TabletPress, {20, 20}, 0.25, Pointer::Pen);
  send(QEvent::TabletMove, {120, 20}, 0.75, Pointer::Pen);
  send(QEvent::TabletRelease, {120, 20}, 0, Pointer::Pen);
  ASSERT_EQ(pad_.ink().strokes.size(), 1U);
  ASSERT_EQ(pad_.ink().strokes[0].size(), 2U);
  EXPECT_EQ(pad_.ink().strokes[0][0].pressure, 0.25);
  EXPECT_EQ(pad_.ink().strokes[0][1].pressure, 0.75);
  send(QEvent::TabletPress, {20, 20}, 0.5, Pointer::Eraser);
  EXPECT_TRUE(pad_.ink().strokes.empty());
}

TEST_F(Pad, TheInkIsSeenWhereItWasDrawn) {
  pad_.resize(200, 200);
  const QColor ink = current_colours().ink;
  draw({30, 150}, {170, 150});
  const QRect seen = test::box_of(test::picture_of(pad_), ink);
  EXPECT_NEAR(seen.left(), 30, 4);
  EXPECT_NEAR(seen.right(), 170, 4);
  EXPECT_NEAR(seen.center().y(), 150, 1);
  EXPECT_LT(seen.height(), 20);
}

}  // namespace
}  // namespace nazori::ui
