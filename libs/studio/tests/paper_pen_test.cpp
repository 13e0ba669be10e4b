// SPDX-License-Identifier: Apache-2.0
// The pen on the sheet: of a mouse, of a pen tablet, of a finger and of keys.
#include <QTest>
#include <QTouchEvent>
#include <numbers>

#include "paper_under_test.h"

namespace nazori::ui {
namespace {

using SheetUnderThePen = test::PaperViewTest;

TEST_F(SheetUnderThePen, AMouseWritesFromItsPressOnTheSheetToItsRelease) {
  mouse(QEvent::MouseButtonPress, {5, 5});
  mouse(QEvent::MouseMove, {9, 9});
  EXPECT_TRUE(samples_.empty()) << "beside the sheet, and above it";
  mouse(QEvent::MouseButtonPress, middle_, Qt::RightButton, 59'000);
  EXPECT_TRUE(samples_.empty());
  mouse(QEvent::MouseButtonPress, middle_, Qt::LeftButton, 60'000);
  mouse(QEvent::MouseMove, middle_ + QPointF(40, 20), Qt::NoButton, 60'250);
  mouse(QEvent::MouseButtonRelease, middle_, Qt::RightButton, 60'300);
  mouse(QEvent::MouseButtonRelease, middle_ + QPointF(60, 30), Qt::LeftButton, 60'500);
  ASSERT_EQ(samples_.size(), 3U);
  const auto tilt = calligraphy::assumed_tilt(false);
  const QPointF places[] = {middle_, middle_ + QPointF(40, 20), middle_ + QPointF(60, 30)};
  const double times[] = {60, 60.25, 60.5};
  for (std::size_t i = 0; i < 3; ++i) {
    expect_at(samples_[i], places[i]);
    EXPECT_NEAR(samples_[i].time_s, times[i], 1e-9);
    EXPECT_EQ(samples_[i].down, i < 2);
    EXPECT_FALSE(samples_[i].pressure);
    EXPECT_EQ(samples_[i].lean_rad, tilt.lean_rad);
    EXPECT_EQ(samples_[i].lean_to_rad, tilt.lean_to_rad);
    EXPECT_EQ(samples_[i].twist_rad, 0);
  }
  mouse(QEvent::MouseMove, middle_, Qt::NoButton, 60'600);
  EXPECT_EQ(samples_.size(), 3U) << "above the paper only the brush moves";
  view_.set_left_hand(true);
  mouse(QEvent::MouseButtonPress, middle_, Qt::LeftButton, 60'700);
  EXPECT_EQ(samples_.back().lean_to_rad, calligraphy::assumed_tilt(true).lean_to_rad);
  mouse(QEvent::MouseButtonRelease, middle_, Qt::LeftButton, 60'800);
}

TEST_F(SheetUnderThePen, APenHasItsPressureItsTiltAndItsTurn) {
  using Can = QInputDevice::Capability;
  const auto full = device(QPointingDevice::PointerType::Pen,
                           Can::Position | Can::Pressure | Can::XTilt | Can::YTilt | Can::Rotation);
  pen(full, QEvent::TabletPress, middle_, {0.7, {30, 10}, 90});
  ASSERT_EQ(samples_.size(), 1U);
  EXPECT_TRUE(samples_[0].down);
  EXPECT_EQ(samples_[0].pressure, 0.7);
  const auto tilt = calligraphy::holder_tilt(30, 10, false);
  EXPECT_NEAR(samples_[0].lean_rad, tilt.lean_rad, 1e-6);
  EXPECT_NEAR(samples_[0].lean_to_rad, tilt.lean_to_rad, 1e-6);
  EXPECT_NEAR(samples_[0].twist_rad, -std::numbers::pi / 2, 1e-6) << "clockwise";
  EXPECT_NEAR(samples_[0].time_s, 50.01, 1e-9);
  pen(full, QEvent::TabletRelease, middle_, {0, {}, 0});
  EXPECT_FALSE(samples_.back().down);
  view_.set_left_hand(true);
  pen(full, QEvent::TabletPress, middle_, {0.7, {30, 10}, 90});
  EXPECT_NEAR(samples_.back().twist_rad, std::numbers::pi / 2, 1e-6);
  EXPECT_NEAR(samples_.back().lean_to_rad, calligraphy::holder_tilt(30, 10, true).lean_to_rad, 1e-6);
  pen(full, QEvent::TabletRelease, middle_, {0, {}, 0});
  view_.set_left_hand(false);
  const auto plain = device(QPointingDevice::PointerType::Pen, Can::Position);
  pen(plain, QEvent::TabletPress, middle_, {0.7, {30, 10}, 90});
  EXPECT_FALSE(samples_.back().pressure);
  EXPECT_EQ(samples_.back().lean_rad, calligraphy::assumed_tilt(false).lean_rad);
  EXPECT_EQ(samples_.back().twist_rad, 0);
  pen(plain, QEvent::TabletRelease, middle_, {0, {}, 0});
}

TEST_F(SheetUnderThePen, OnlyTheTipWritesAndOnlyWhereItCameDownOnTheSheet) {
  using Can = QInputDevice::Capability;
  const auto one = device(QPointingDevice::PointerType::Pen, Can::Position | Can::Pressure);
  pen(one, QEvent::TabletPress, middle_, {0.5}, Qt::RightButton);
  pen(one, QEvent::TabletPress, {3, 3}, {0.5});
  pen(one, QEvent::TabletMove, middle_, {0.5}, Qt::NoButton);
  EXPECT_TRUE(samples_.empty());
  pen(one, QEvent::TabletRelease, middle_, {0});
  pen(one, QEvent::TabletPress, middle_, {0.5});
  pen(one, QEvent::TabletRelease, middle_, {0.5}, Qt::RightButton);
  ASSERT_EQ(samples_.size(), 2U);
  EXPECT_TRUE(samples_.back().down) << "the tip is still down";
  pen(one, QEvent::TabletRelease, middle_, {0});
  EXPECT_FALSE(samples_.back().down);
  const auto rubber = device(QPointingDevice::PointerType::Eraser, Can::Position | Can::Pressure);
  const std::size_t before = samples_.size();
  pen(rubber, QEvent::TabletPress, middle_, {0.5}, Qt::RightButton);
  EXPECT_EQ(erased_, 0);
  pen(rubber, QEvent::TabletPress, middle_, {0.5});
  pen(rubber, QEvent::TabletMove, middle_, {0.5}, Qt::NoButton);
  pen(rubber, QEvent::TabletRelease, middle_, {0.5});
  EXPECT_EQ(erased_, 1);
  EXPECT_EQ(samples_.size(), before);
}

TEST_F(SheetUnderThePen, AFingerWritesAndASecondOneEndsIt) {
  view_.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&view_));
  // Qt keeps the devices of a program until its end.
  static auto* const screen = QTest::createTouchDevice();
  const QPoint middle = view_.place().rect.center().toPoint();
  QTest::touchEvent(&view_, screen).press(1, middle);
  QTest::touchEvent(&view_, screen).move(1, middle + QPoint(20, 10));
  QTest::touchEvent(&view_, screen).release(1, middle + QPoint(20, 10));
  ASSERT_EQ(samples_.size(), 3U);
  expect_at(samples_[0], middle);
  expect_at(samples_[1], middle + QPoint(20, 10));
  EXPECT_TRUE(samples_[0].down);
  EXPECT_TRUE(samples_[1].down);
  EXPECT_FALSE(samples_[2].down);
  EXPECT_FALSE(samples_[1].pressure);
  EXPECT_EQ(samples_[1].lean_rad, calligraphy::assumed_tilt(false).lean_rad);
  EXPECT_EQ(lost_, 0);
  QTest::touchEvent(&view_, screen).press(1, {2, 2});
  QTest::touchEvent(&view_, screen).move(1, middle);
  QTest::touchEvent(&view_, screen).release(1, middle);
  EXPECT_EQ(samples_.size(), 3U) << "it began beside the sheet";
  QTest::touchEvent(&view_, screen).press(1, middle);
  QTest::touchEvent(&view_, screen).stationary(1).press(2, middle + QPoint(40, 0));
  EXPECT_EQ(lost_, 1);
  EXPECT_EQ(samples_.size(), 4U);
  QTest::touchEvent(&view_, screen).release(1, middle).release(2, middle + QPoint(40, 0));
  EXPECT_EQ(samples_.size(), 4U);
}

TEST_F(SheetUnderThePen, KeysMoveTheBrushNoFasterThanACalmHand) {
  mouse(QEvent::MouseMove, {3, 3}, Qt::NoButton, 70'000);
  const double begin_s = view_.pen_clock_s();
  EXPECT_GE(begin_s, 70);
  EXPECT_LT(begin_s, 80);
  view_.move_brush({0.04, 0}, true, 0.4);
  view_.move_brush({0.04, 0.03}, true, 0.6);
  view_.move_brush({0.01, 0.03}, false, 0);
  ASSERT_EQ(samples_.size(), 3U);
  EXPECT_GE(samples_[0].time_s, begin_s);
  // 3 cm take half a second.
  EXPECT_NEAR(samples_[1].time_s - samples_[0].time_s, 0.5, 0.05);
  EXPECT_NEAR(samples_[2].time_s - samples_[1].time_s, 0.5, 0.05);
  EXPECT_NEAR(samples_[1].at.x, 0.04, 1e-9);
  EXPECT_NEAR(samples_[1].at.y, 0.03, 1e-9);
  EXPECT_EQ(samples_[0].pressure, 0.4);
  EXPECT_EQ(samples_[1].pressure, 0.6);
  EXPECT_TRUE(samples_[1].down);
  EXPECT_FALSE(samples_[2].down);
}

}  // namespace
}  // namespace nazori::ui
