// SPDX-License-Identifier: Apache-2.0
// A character of the grid as it is painted by its strength.
#include <gtest/gtest.h>

#include <QPainter>

#include "picture_under_test.h"
#include "progress/strength_grid.h"

namespace nazori::ui {
namespace {

using study::Strength;

class StrengthPaint : public testing::Test {
 protected:
  QImage painted(Strength strength, QStyle::State state = QStyle::State_None) {
    StrengthModel model;
    model.set_states({{U'口', strength, 0.9}});
    StrengthDelegate delegate;
    QStyleOptionViewItem option;
    option.rect = QRect(10, 10, 100, 100);
    option.state = state;
    QImage picture(120, 120, QImage::Format_ARGB32);
    picture.fill(Qt::magenta);
    QPainter painter(&picture);
    delegate.paint(&painter, option, model.index(0));
    return picture;
  }
  /// How much of the upper edge is drawn over the fill.
  static int drawn_edge(const QImage& picture, Strength strength) {
    const QRgb fill = look_of(strength, current_colours()).fill.rgb();
    int count = 0;
    for (int x = 20; x < 100; ++x) count += picture.pixel(x, 12) != fill ? 1 : 0;
    return count;
  }
};

TEST_F(StrengthPaint, TheTileHasTheFillOfItsStrengthAndAGapAround) {
  for (const auto strength : {Strength::unseen, Strength::learning, Strength::young, Strength::mature,
                              Strength::leech, Strength::paused}) {
    const auto look = look_of(strength, current_colours());
    const QImage picture = painted(strength);
    EXPECT_TRUE(test::is(picture, {18, 100}, look.fill)) << static_cast<int>(strength);
    for (const QPointF beside : {QPointF(60, 10), QPointF(60, 109), QPointF(10, 60), QPointF(109, 60)})
      EXPECT_TRUE(test::is(picture, beside, Qt::magenta)) << static_cast<int>(strength);
  }
}

TEST_F(StrengthPaint, WhatIsNotMetOrPausedHasABrokenEdge) {
  for (const auto strength : {Strength::learning, Strength::young, Strength::leech})
    EXPECT_EQ(drawn_edge(painted(strength), strength), 80) << static_cast<int>(strength);
  for (const auto strength : {Strength::unseen, Strength::paused}) {
    const int drawn = drawn_edge(painted(strength), strength);
    EXPECT_GT(drawn, 10);
    EXPECT_LT(drawn, 75);
    EXPECT_EQ(drawn_edge(painted(strength, QStyle::State_HasFocus), strength), 80)
        << "where the keyboard is it is whole";
  }
}

TEST_F(StrengthPaint, TheSignStandsInTheUpperRightCorner) {
  const QImage with = painted(Strength::young);
  const QImage without = painted(Strength::unseen);
  const QRect corner(85, 14, 20, 26);
  EXPECT_FALSE(test::box_of(with, current_colours().ink, corner).isNull());
  EXPECT_TRUE(test::box_of(without, current_colours().muted, corner).isNull());
}

}  // namespace
}  // namespace nazori::ui
