// SPDX-License-Identifier: Apache-2.0
// The width and the depth along a stroke as they are drawn, dragged and moved by keys.
#include <gtest/gtest.h>

#include <QApplication>
#include <QSignalSpy>
#include <QTest>

#include "nazori/studio/workshop/groove_curve.h"
#include "painted_lightly.h"
#include "print_qt.h"

namespace nazori::ui {
namespace {

using test::box_words;
using test::Drawing;
using test::Drawn;
using test::drawn_by;
using test::in_words;
using test::words;

class CurveTest : public test::PaintedLightly {};

class PaintedCurve : public CurveTest {
 protected:
  /// A level groove of three points; the second is in the middle.
  static carving::Groove groove() { return {{{10, 50}, 2, 0.5}, {{50, 50}, 4, 1}, {{90, 50}, 6, 0.25}}; }
  void lay_out(GrooveCurve& curve) {
    curve.setFont(font_);
    curve.resize(220, 126);  // 200 x 100 inside: 10 beside, 18 above and 8 below
  }
  /// The little box at a point.
  static QString mark(QPointF at, double half, const char* pen, const char* fill) {
    return box_words({at.x() - half, at.y() - half, 2 * half, 2 * half}, 0, words(pen), words(fill));
  }
};

TEST_F(PaintedCurve, OfDepthsGoesDownFromTheTopAndThatOfWidthsUpFromTheBottom) {
  GrooveCurve depth(GrooveCurve::Quantity::depth, "depth", nullptr);
  GrooveCurve width(GrooveCurve::Quantity::half_width, "width", nullptr);
  EXPECT_EQ(depth.accessibleName(), words("Depth along the stroke"));
  EXPECT_EQ(width.accessibleName(), words("Width along the stroke"));
  for (auto* curve : {&depth, &width}) {
    lay_out(*curve);
    EXPECT_EQ(curve->sizeHint(), QSize(96, 72)) << "eight letters by six";
    EXPECT_EQ(curve->value_words(), words("No stroke is chosen."));
    ASSERT_EQ(drawn_by(*curve).boxes().size(), 1U) << "only the frame";
    curve->show_groove(groove(), 1);
  }
  const QPointF down[] = {{10, 18 + 50}, {110, 18 + 100}, {210, 18 + 25}};
  const QPointF up[] = {{10, 118 - 25}, {110, 118 - 50}, {210, 118 - 75}};  // of 8 units
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(depth.place_of(i).x(), down[i].x(), 0.5);
    EXPECT_NEAR(depth.place_of(i).y(), down[i].y(), 1e-6);
    EXPECT_NEAR(width.place_of(i).x(), up[i].x(), 0.5);
    EXPECT_NEAR(width.place_of(i).y(), up[i].y(), 1e-6);
  }
  EXPECT_EQ(depth.value(), 1);
  EXPECT_EQ(width.value(), 4);
  EXPECT_EQ(depth.value_words(), words("Point 2 of 3: depth 100%"));
  EXPECT_EQ(width.value_words(), words("Point 2 of 3: width 8.0"));
  EXPECT_EQ(depth.largest(), 1);
  EXPECT_EQ(width.largest(), carving::kWidestHalf);
  EXPECT_EQ(depth.step(), 0.05);
  EXPECT_EQ(width.step(), 0.25);

  const Drawing all = drawn_by(depth);
  const auto boxes = all.boxes();
  ASSERT_EQ(boxes.size(), 6U) << "frame, area, line and three points";
  EXPECT_EQ(in_words(boxes[0]), box_words({1, 1, 218, 124}, 4, words("edge 1"), words("surface")));
  EXPECT_EQ(boxes[1].pen_words(), words("none"));
  EXPECT_EQ(boxes[1].fill.color(), blend(c_.surface, c_.indigo, 0.18));
  EXPECT_NEAR(boxes[1].box.top(), 18, 0.01) << "down to a depth of nothing";
  EXPECT_EQ(boxes[2].pen_words(), words("indigo 1.5"));
  EXPECT_EQ(boxes[2].fill_words(), words("none"));
  EXPECT_EQ(in_words(boxes[3]), mark(depth.place_of(0), 3, "indigo 1.5", "surface"));
  EXPECT_EQ(in_words(boxes[4]), mark(depth.place_of(1), 5, "vermilion 1.5", "vermilion"));
  EXPECT_EQ(in_words(boxes[5]), mark(depth.place_of(2), 3, "indigo 1.5", "surface"));
  const Drawn name = all.words(words("Depth"));
  EXPECT_NEAR(name.box.left(), 8, 1.01);
  EXPECT_NEAR(name.baseline, 3 + QFontMetrics(font_).ascent(), 1.01);
  EXPECT_EQ(test::name_of(name.pen.color()), words("muted"));
  const Drawn value = all.words(words("100"));
  EXPECT_NEAR(value.box.right(), 212, 1.01);
  EXPECT_EQ(test::name_of(value.pen.color()), words("ink"));
  EXPECT_TRUE(drawn_by(width).words(words("8.0")).box.right() > 205);
  EXPECT_EQ(drawn_by(width).words()[0].text, words("Width"));
}

TEST_F(PaintedCurve, ShowsTheKeyboardAndAWiderGrooveHasAnotherScale) {
  GrooveCurve width(GrooveCurve::Quantity::half_width, "width", nullptr);
  lay_out(width);
  auto wide = groove();
  wide[2].half_width = 16;  // the scale ends a quarter above
  width.show_groove(wide, {});
  EXPECT_NEAR(width.place_of(2).y(), 118 - 80, 1e-6);
  EXPECT_EQ(width.value(), std::nullopt);
  EXPECT_EQ(width.value_words(), words("3 points. Left and Right choose one."));
  EXPECT_EQ(drawn_by(width).words().size(), 1U) << "no value without a point";
  width.show_groove(groove(), 7);
  EXPECT_EQ(width.value(), std::nullopt) << "there is no such point";
  give_keyboard(width);
  EXPECT_EQ(in_words(drawn_by(width).boxes()[0]),
            box_words({1, 1, 218, 124}, 4, words("indigo 2"), words("surface")));
}

TEST_F(PaintedCurve, IsGraspedNearAPointAndTheNearestOneIsTaken) {
  GrooveCurve width(GrooveCurve::Quantity::half_width, "width", nullptr);
  lay_out(width);
  width.show_groove(groove(), 1);
  QSignalSpy chosen(&width, &GrooveCurve::point_chosen);
  QSignalSpy moved(&width, &GrooveCurve::value_moved);
  QObject::connect(&width, &GrooveCurve::point_chosen, &width,
                   [&](std::size_t point) { width.show_groove(groove(), point); });
  const auto press = [&](double x, double y, Qt::MouseButton button = Qt::LeftButton) {
    QTest::mousePress(&width, button, {}, QPoint(static_cast<int>(x), static_cast<int>(y)));
  };
  const auto move = [&](double x, double y) {
    QMouseEvent event(QEvent::MouseMove, {x, y}, {x, y}, Qt::NoButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&width, &event);
  };
  press(110 + 16, 60);
  EXPECT_EQ(chosen.count(), 0) << "too far beside it";
  move(126, 20);
  EXPECT_EQ(moved.count(), 0);
  QTest::mouseRelease(&width, Qt::LeftButton);
  press(200, 40);
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_EQ(chosen.at(0).at(0).value<std::size_t>(), 2U);
  const double y = width.place_of(2).y();
  move(200, 41);
  EXPECT_EQ(moved.count(), 0) << "a hand trembles";
  move(200, 30);
  move(200, 20);
  ASSERT_EQ(moved.count(), 2);
  // The point is as far from the pointer as it was: 10 pixels of 100 are 0.8 of 8 units.
  EXPECT_NEAR(moved.at(0).at(1).toDouble(), (118 - (y - 10)) / 100 * 8, 1e-6);
  EXPECT_FALSE(moved.at(0).at(2).toBool());
  EXPECT_TRUE(moved.at(1).at(2).toBool()) << "the same drag";
  move(200, 400);
  EXPECT_EQ(moved.last().at(1).toDouble(), 0) << "no narrower than nothing";
  QSignalSpy said(&width, &GrooveCurve::said);
  QTest::mouseRelease(&width, Qt::LeftButton);
  ASSERT_EQ(said.count(), 1);
  EXPECT_EQ(said.at(0).at(0).toString(), words("Point 3 of 3: width 12.0"));
  press(10, 90, Qt::RightButton);
  EXPECT_EQ(chosen.count(), 1);
}

TEST_F(PaintedCurve, KeysChooseAPointAndMoveItByWholeAndFineSteps) {
  GrooveCurve depth(GrooveCurve::Quantity::depth, "depth", nullptr);
  lay_out(depth);
  depth.show_groove(groove(), {});
  std::vector<std::size_t> chosen;
  std::vector<double> moved;
  QObject::connect(&depth, &GrooveCurve::point_chosen, &depth, [&](std::size_t point) {
    chosen.push_back(point);
    depth.show_groove(groove(), point);
  });
  QObject::connect(&depth, &GrooveCurve::value_moved, &depth,
                   [&](std::size_t, double value, bool) { moved.push_back(value); });
  for (const Qt::Key key : {Qt::Key_Up, Qt::Key_Right, Qt::Key_Right, Qt::Key_Right, Qt::Key_Left,
                            Qt::Key_Left, Qt::Key_Left, Qt::Key_End, Qt::Key_Home})
    QTest::keyClick(&depth, key);
  EXPECT_EQ(chosen, (std::vector<std::size_t>{0, 1, 2, 1, 0, 2, 0})) << "and no further than the ends";
  EXPECT_TRUE(moved.empty());
  QTest::keyClick(&depth, Qt::Key_Up);
  QTest::keyClick(&depth, Qt::Key_Down);
  QTest::keyClick(&depth, Qt::Key_Down, Qt::ShiftModifier);
  QTest::keyClick(&depth, Qt::Key_Up, Qt::KeypadModifier);
  QTest::keyClick(&depth, Qt::Key_Up, Qt::ControlModifier);
  ASSERT_EQ(moved.size(), 4U) << "Ctrl is the window's";
  const double wanted[] = {0.45, 0.55, 0.51, 0.45};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(moved[i], wanted[i], 1e-9) << i;
  depth.set_value(7);
  EXPECT_EQ(moved.back(), 1);
}

}  // namespace
}  // namespace nazori::ui
