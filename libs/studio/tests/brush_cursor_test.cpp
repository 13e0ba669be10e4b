// SPDX-License-Identifier: Apache-2.0
// The brush above the paper, shape by shape.
#include <cmath>

#include "paper_under_test.h"

namespace nazori::ui {
namespace {

using test::Drawn;
using test::upright;

constexpr double kPerM = 4000;

std::vector<Drawn> drawn(const calligraphy::BrushShape& brush, QPointF pen, bool left = false) {
  return test::drawn_by(
             QSize(900, 900),
             [&](QPainter& painter) { paint_brush(painter, brush, QColor(28, 26, 25), pen, kPerM, left); })
      .all;
}

/// The box of a ribbon from a pen to a root, as wide as the root and with a point at the pen.
QRectF ribbon(QPointF pen, QPointF root, double half_px) {
  const QPointF way = pen - root;
  const QPointF across = QPointF(-way.y(), way.x()) / std::hypot(way.x(), way.y()) * half_px;
  return QPolygonF({root + across, pen, root - across}).boundingRect();
}

void expect_same(const QRectF& seen, const QRectF& wanted) {
  EXPECT_NEAR(seen.left(), wanted.left(), 0.01);
  EXPECT_NEAR(seen.top(), wanted.top(), 0.01);
  EXPECT_NEAR(seen.right(), wanted.right(), 0.01);
  EXPECT_NEAR(seen.bottom(), wanted.bottom(), 0.01);
}

TEST(BrushInTheAir, ItsShadowFallsToTheLowerRightSofterFromOutsideIn) {
  const QPointF pen(300, 400);
  const auto all = drawn(upright(), pen);
  ASSERT_EQ(all.size(), 3U + 2 + 8 + 1) << "shadows, hair and root, hairs, shaft";
  const QRectF shadow = ribbon(pen, pen + QPointF(0.16, 0.10) * 0.02 * kPerM, 16);
  const double widths[] = {6, 3, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    expect_same(all[i].box, shadow);
    EXPECT_EQ(all[i].fill.color(), QColor(30, 20, 10, 26));
    if (widths[i] == 0) {
      EXPECT_EQ(all[i].pen.style(), Qt::NoPen);
    } else {
      EXPECT_EQ(all[i].pen.widthF(), widths[i]);
      EXPECT_EQ(all[i].pen.color(), QColor(30, 20, 10, 16));
    }
  }
}

TEST(BrushInTheAir, ItsHairGoesFromItsOwnColourToThatOfTheInk) {
  const QPointF pen(300, 400);
  for (const bool left : {false, true}) {
    const auto all = drawn(upright(), pen, left);
    ASSERT_EQ(all.size(), 14U);
    const QPointF root = pen + QPointF(left ? -0.20 : 0.20, -0.42) * 0.02 * kPerM;
    expect_same(all[3].box, ribbon(pen, root, 16));
    const auto* wet = all[3].fill.gradient();
    ASSERT_NE(wet, nullptr);
    const QColor ink(28, 26, 25);
    EXPECT_EQ(wet->stops(),
              (QGradientStops{{0, QColor(58, 46, 38)}, {0.35, ink.darker(120)}, {1, ink.darker(150)}}));
    EXPECT_EQ(all[3].pen.style(), Qt::NoPen);
    EXPECT_TRUE(all[4].round);
    expect_same(all[4].box, QRectF(root - QPointF(16, 12), QSizeF(32, 24)));
  }
}

TEST(BrushInTheAir, EightHairsDivideItEvenlyAndEndAboveTheTip) {
  const QPointF pen(300, 400);
  const auto all = drawn(upright(), pen);
  ASSERT_EQ(all.size(), 14U);
  const QPointF root = pen + QPointF(0.20, -0.42) * 0.02 * kPerM;
  const QPointF way = pen - root;
  const QPointF across = QPointF(-way.y(), way.x()) / std::hypot(way.x(), way.y());
  for (int line = 1; line <= 8; ++line) {
    const Drawn& hair = all[static_cast<std::size_t>(4 + line)];
    ASSERT_EQ(hair.points.size(), 2) << line;
    // From one side of the ribbon to the other, in ninths.
    const double share = 1 - 2 * line / 9.0;
    const QPointF from = root + across * (16 * share), to = root + way / 2 + across * (8 * share);
    EXPECT_NEAR(hair.points[0].x(), from.x(), 0.01) << line;
    EXPECT_NEAR(hair.points[0].y(), from.y(), 0.01) << line;
    EXPECT_NEAR(hair.points[1].x(), to.x(), 0.01) << line;
    EXPECT_NEAR(hair.points[1].y(), to.y(), 0.01) << line;
    EXPECT_EQ(hair.pen.color(), QColor(150, 130, 112, 90));
    EXPECT_NEAR(hair.pen.widthF(), 0.05 * 16, 0.001) << "a twentieth of the root";
  }
  const auto* bamboo = all.back().fill.gradient();
  ASSERT_NE(bamboo, nullptr);
  EXPECT_EQ(bamboo->stops(), (QGradientStops{{0, QColor(128, 96, 54, 225)},
                                             {0.12, QColor(196, 160, 104, 215)},
                                             {1, QColor(196, 160, 104, 0)}}));
  const auto& along = static_cast<const QLinearGradient&>(*bamboo);
  EXPECT_NEAR(along.start().y(), root.y(), 0.01) << "pale towards its end";
  EXPECT_LT(along.finalStop().y(), root.y());
}

TEST(BrushInTheAir, TheFinestBrushCanStillBeSeen) {
  const auto all = drawn(upright(0.0001), {300, 400});  // 0.4 pixels
  ASSERT_EQ(all.size(), 14U);
  EXPECT_NEAR(all[4].box.width(), 2, 0.01);
  EXPECT_NEAR(all[4].box.height(), 1.5, 0.01);
  EXPECT_NEAR(all[5].pen.widthF(), 0.6, 0.001);
}

TEST(BrushInTheAir, ItsTipIsAbovePenHoweverTheHairIsBent) {
  const QPointF pen(300, 400);
  auto bent = upright();
  bent.pen = {0.001, 0.002};
  for (auto& section : bent.sections) section.at = {0.011, 0.002 + 0.005};
  const auto box = [&](bool touches) {
    bent.touches = touches;
    return drawn(bent, pen)[3].box;
  };
  const QPointF root(0.20 * 0.02 * kPerM, -0.42 * 0.02 * kPerM);
  // On the paper it is where the hair is: 1 cm to the right and half a centimetre up, which is y on paper.
  const QPointF there = pen + QPointF(40, -20);
  expect_same(box(true), ribbon(there, there + root, 16));
  expect_same(box(false), ribbon(pen, pen + root, 16));
}

TEST(BrushInTheAir, ItsBoundsHoldHairShaftAndShadowOfBothHands) {
  calligraphy::BrushShape brush;
  brush.shaft_m = 0.008;
  brush.touches = true;
  brush::TuftSection section;
  section.z_m = 0.01;
  section.half_width_m = 0.002;
  brush.sections = {section};
  const QPointF pen(300, 400);
  // The shaft ends 8.5 cm above the paper: 0.2 of that to each side, 0.42 up, and its shadow 0.1 down.
  const QRectF seen(QPointF(300 - 68, 400 - 142.8), QPointF(300 + 68 + 1, 400 + 34 + 1));
  expect_same(brush_bounds(brush, pen, kPerM), seen.adjusted(-40, -40, 40, 40));
  brush.sections[0].half_width_m = 0.01;
  expect_same(brush_bounds(brush, pen, kPerM), seen.adjusted(-48, -48, 48, 48));
  brush.sections[0].at = {0.01, 0.02};
  expect_same(brush_bounds(brush, pen, kPerM),
              seen.translated(40, -80).united(QRectF(pen, QSizeF(1, 1))).adjusted(-48, -48, 48, 48));
  brush.touches = false;
  expect_same(brush_bounds(brush, pen, kPerM), seen.adjusted(-48, -48, 48, 48));
  brush.sections.clear();
  expect_same(brush_bounds(brush, pen, kPerM), QRectF(300 - 40, 400 - 40, 81, 81));
}

}  // namespace
}  // namespace nazori::ui
