// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/look/icons.h"

#include <gtest/gtest.h>

#include <QIcon>
#include <QImage>
#include <QPainter>
#include <array>
#include <functional>
#include <set>

namespace nazori::ui {
namespace {

constexpr int kUnit_px = 8;  // of the 24 that a drawing is wide and high
constexpr int kSide_px = 24 * kUnit_px;

QImage drawn_icon(Icon which) { return sign(which, Qt::black, kSide_px, 1).toImage(); }

bool is_ink(const QImage& picture, int x, int y) { return qAlpha(picture.pixel(x, y)) > 127; }

using PixelTurn = std::function<QPoint(QPoint)>;
constexpr int kLast = kSide_px - 1;
const PixelTurn kLeftRight = [](QPoint p) { return QPoint(kLast - p.x(), p.y()); };
const PixelTurn kUpDown = [](QPoint p) { return QPoint(p.x(), kLast - p.y()); };
const PixelTurn kDiagonal = [](QPoint p) { return QPoint(p.y(), p.x()); };
const PixelTurn kOtherDiagonal = [](QPoint p) { return QPoint(kLast - p.y(), kLast - p.x()); };

/// Pixels that hold ink in one drawing and none in the other, after a turn.
int differing(Icon one, Icon other, const PixelTurn& turn) {
  const QImage a = drawn_icon(one);
  const QImage b = drawn_icon(other);
  int count = 0;
  for (int y = 0; y < kSide_px; ++y)
    for (int x = 0; x < kSide_px; ++x) {
      const QPoint there = turn({x, y});
      const int apart = std::abs(qAlpha(a.pixel(x, y)) - qAlpha(b.pixel(there.x(), there.y())));
      count += apart > 128 ? 1 : 0;
    }
  return count;
}

// The edge of a curve falls a hair beside where its mirror image falls.
constexpr int kRounding_px = 12;

constexpr int kCount = static_cast<int>(Icon::redo) + 1;

TEST(Icons, EveryOneIsDrawnWithRoomAroundIt) {
  constexpr int kRoom_px = 3 * kUnit_px / 2;
  for (int i = 0; i < kCount; ++i) {
    const QImage picture = drawn_icon(static_cast<Icon>(i));
    int ink = 0;
    for (int y = 0; y < kSide_px; ++y)
      for (int x = 0; x < kSide_px; ++x) {
        if (!is_ink(picture, x, y)) continue;
        ++ink;
        ASSERT_GE(std::min(x, y), kRoom_px) << "icon " << i;
        ASSERT_LT(std::max(x, y), kSide_px - kRoom_px) << "icon " << i;
      }
    EXPECT_GT(ink, 10 * kUnit_px * kUnit_px) << "icon " << i;
  }
}

TEST(Icons, NoTwoLookTheSameExceptThoseThatMeanTheSame) {
  for (int i = 0; i < kCount; ++i)
    for (int k = i + 1; k < kCount; ++k) {
      const auto one = static_cast<Icon>(i);
      const auto other = static_cast<Icon>(k);
      if (one == Icon::watch && other == Icon::eye) continue;
      EXPECT_GT(differing(one, other, [](QPoint p) { return p; }), kUnit_px * kUnit_px) << i << ' ' << k;
    }
  EXPECT_EQ(drawn_icon(Icon::watch), drawn_icon(Icon::eye));
}

TEST(Icons, WhatIsTheSameOnBothSidesIsDrawnSo) {
  for (const Icon which : {Icon::snap, Icon::hint, Icon::cross, Icon::advice, Icon::eye, Icon::slower,
                           Icon::faster, Icon::hint_lamp, Icon::beside, Icon::home})
    EXPECT_LE(differing(which, which, kLeftRight), kRounding_px) << static_cast<int>(which);
}

TEST(Icons, WhatIsTheSameAboveAndBelowIsDrawnSo) {
  for (const Icon which : {Icon::previous, Icon::next, Icon::back, Icon::sound, Icon::library, Icon::play,
                           Icon::hint, Icon::cross, Icon::eye, Icon::slower, Icon::faster, Icon::beside})
    EXPECT_LE(differing(which, which, kUpDown), kRounding_px) << static_cast<int>(which);
}

TEST(Icons, WhatLiesOnADiagonalIsTheSameOnBothSidesOfIt) {
  for (const Icon which : {Icon::copy, Icon::overlaid, Icon::search, Icon::guided, Icon::faster})
    EXPECT_LE(differing(which, which, kDiagonal), kRounding_px) << static_cast<int>(which);
  for (const Icon which : {Icon::arrows, Icon::pen})
    EXPECT_LE(differing(which, which, kOtherDiagonal), kRounding_px) << static_cast<int>(which);
}

TEST(Icons, WhatPointsTheOtherWayIsTheMirrorImage) {
  EXPECT_LE(differing(Icon::previous, Icon::next, kLeftRight), kRounding_px);
  EXPECT_LE(differing(Icon::library, Icon::information, kLeftRight), kRounding_px);
  EXPECT_GT(differing(Icon::previous, Icon::next, [](QPoint p) { return p; }), kUnit_px * kUnit_px);
}

TEST(Icons, ThreeBarsOfProgressStandOnOneLineAndGrow) {
  const QImage picture = drawn_icon(Icon::progress);
  // The upper end of the drawing in a column, to the right of the axis.
  std::array<int, 3> tops{};
  std::array<int, 3> widths{};
  for (const int bar : {0, 1, 2}) {
    // Bars are 4.8 apart, and the middle of the second is 12.9 from the left.
    const double middle = 12.9 + 4.8 * (bar - 1);
    const auto x = static_cast<int>(middle * kUnit_px);
    int y = 0;
    while (!is_ink(picture, x, y)) ++y;
    tops[static_cast<std::size_t>(bar)] = y;
    const int row = static_cast<int>(17.5 * kUnit_px);
    int left = x;
    int right = x;
    while (left > 0 && !is_ink(picture, left, row)) --left;
    while (right < kLast && !is_ink(picture, right, row)) ++right;
    widths[static_cast<std::size_t>(bar)] = right - left;
    EXPECT_NEAR(x - left, right - x, 2) << bar;
    EXPECT_TRUE(is_ink(picture, x, static_cast<int>(19.6 * kUnit_px))) << bar;
  }
  EXPECT_GT(tops[0], tops[1] + kUnit_px);
  EXPECT_GT(tops[1], tops[2] + kUnit_px);
  EXPECT_NEAR(widths[0], widths[1], 1);
  EXPECT_NEAR(widths[1], widths[2], 1);
}

QColor colour_of(const QIcon& icon, QIcon::Mode mode, QIcon::State state) {
  const QImage picture = icon.pixmap(QSize(48, 48), 1, mode, state).toImage();
  return picture.pixelColor(24, 24);  // the middle of Icon::slower, one line
}

TEST(Icons, OneThatIsOnHasItsOwnColourAndOneThatIsOffForAllIsPale) {
  const QIcon made = icon(Icon::slower, Qt::red, Qt::blue);
  EXPECT_EQ(colour_of(made, QIcon::Normal, QIcon::Off), QColor(Qt::red));
  EXPECT_EQ(colour_of(made, QIcon::Normal, QIcon::On), QColor(Qt::blue));
  const double alpha = colour_of(made, QIcon::Disabled, QIcon::Off).alphaF();
  EXPECT_GT(alpha, 0.2);
  EXPECT_LT(alpha, 0.5);
}

TEST(Icons, ADrawingFillsThePlaceItIsGiven) {
  QImage picture(100, 80, QImage::Format_ARGB32_Premultiplied);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  icon(Icon::cross, Qt::black, Qt::black).paint(&painter, QRect(40, 20, 48, 48));
  painter.end();
  // From 6.5 to 17.5 of 24, at twice the size.
  int least_x = 1000, most_x = 0, least_y = 1000, most_y = 0;
  for (int y = 0; y < 80; ++y)
    for (int x = 0; x < 100; ++x) {
      if (!is_ink(picture, x, y)) continue;
      least_x = std::min(least_x, x);
      most_x = std::max(most_x, x);
      least_y = std::min(least_y, y);
      most_y = std::max(most_y, y);
    }
  EXPECT_NEAR(least_x, 40 + 13 - 1.7, 1.1);
  EXPECT_NEAR(most_x, 40 + 35 + 0.7, 1.1);
  EXPECT_NEAR(least_y, 20 + 13 - 1.7, 1.1);
  EXPECT_NEAR(most_y, 20 + 35 + 0.7, 1.1);
}

TEST(Icons, OneThatIsOffIsDrawnWithThirtyEightPercentOfItsColour) {
  const QIcon made = icon(Icon::slower, Qt::red, Qt::blue);
  EXPECT_NEAR(colour_of(made, QIcon::Disabled, QIcon::Off).alphaF(), 0.38, 0.01);
  EXPECT_NEAR(colour_of(made, QIcon::Disabled, QIcon::On).alphaF(), 0.38, 0.01);
  EXPECT_GT(colour_of(made, QIcon::Disabled, QIcon::On).blueF(), 0.95);
  EXPECT_EQ(colour_of(made, QIcon::Selected, QIcon::Off), QColor(Qt::red));
}

TEST(Icons, ADrawingLeavesThePainterAsItWas) {
  QImage picture(96, 48, QImage::Format_ARGB32_Premultiplied);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  icon(Icon::slower, Qt::red, Qt::blue)
      .paint(&painter, QRect(0, 0, 48, 48), Qt::AlignCenter, QIcon::Disabled);
  EXPECT_EQ(painter.opacity(), 1);
  EXPECT_FALSE(painter.testRenderHint(QPainter::Antialiasing));
  icon(Icon::slower, Qt::red, Qt::blue).paint(&painter, QRect(48, 0, 48, 48));
  painter.end();
  EXPECT_EQ(qAlpha(picture.pixel(48 + 24, 24)), 255);
  EXPECT_LT(qAlpha(picture.pixel(24, 24)), 128);
}

TEST(Icons, APictureOfAnIconIsTheDrawingFromItsCornerOn) {
  const QImage made = icon(Icon::cross, Qt::black, Qt::red).pixmap(QSize(kSide_px, kSide_px), 1).toImage();
  const QImage drawn = drawn_icon(Icon::cross);
  ASSERT_EQ(made.size(), drawn.size());
  EXPECT_EQ(made.convertToFormat(QImage::Format_ARGB32), drawn.convertToFormat(QImage::Format_ARGB32));
  // A cross is the same on both sides of its middle.
  EXPECT_TRUE(is_ink(drawn, kSide_px / 2 - 1, kSide_px / 2 - 1));
  int edges = 0;
  for (int y = 0; y < kSide_px; ++y)
    for (int x = 0; x < kSide_px; ++x) {
      const int alpha = qAlpha(drawn.pixel(x, y));
      edges += alpha > 0 && alpha < 255 ? 1 : 0;
    }
  EXPECT_GT(edges, 50) << "smooth";
}

TEST(Icons, ASignIsAsSharpAsTheScreen) {
  const QPixmap twice = sign(Icon::cross, Qt::black, 20, 2);
  EXPECT_EQ(twice.size(), QSize(40, 40));
  EXPECT_EQ(twice.devicePixelRatio(), 2);
  EXPECT_TRUE(is_ink(twice.toImage(), 20, 20));
  EXPECT_FALSE(is_ink(twice.toImage(), 20, 8));
}

TEST(Icons, TheProgramsOwnIsThereInEverySizeOnARoundedTileOfWood) {
  const QIcon own = program_icon();
  std::set<int> sides;
  for (const QSize size : own.availableSizes()) {
    EXPECT_EQ(size.width(), size.height());
    sides.insert(size.width());
  }
  EXPECT_EQ(sides, (std::set{16, 24, 32, 48, 64, 128, 256}));
  const QImage picture = own.pixmap(QSize(256, 256), 1).toImage();
  for (const QPoint corner : {QPoint(3, 3), QPoint(252, 3), QPoint(3, 252), QPoint(252, 252)})
    EXPECT_EQ(picture.pixelColor(corner).alpha(), 0);
  // Inside the tile but outside its rounded corners.
  for (const QPoint corner : {QPoint(14, 14), QPoint(241, 14), QPoint(14, 241), QPoint(241, 241)})
    EXPECT_EQ(picture.pixelColor(corner).alpha(), 0);
  for (const QPoint edge : {QPoint(128, 20), QPoint(20, 128), QPoint(235, 128), QPoint(128, 235)}) {
    EXPECT_EQ(picture.pixelColor(edge).alpha(), 255);
    EXPECT_GT(picture.pixelColor(edge).red(), picture.pixelColor(edge).blue() + 40) << "wood";
  }
  int written = 0;
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x) written += picture.pixelColor(x, y) == QColor(0x2A2018) ? 1 : 0;
  EXPECT_GT(written, 2000) << "the letter";
}

}  // namespace
}  // namespace nazori::ui
