// SPDX-License-Identifier: Apache-2.0
#include "functions/expression_line.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QTest>
#include <algorithm>

#include "nazori/widgets/look/palette.h"
#include "painting_under_test.h"

namespace nazori::ui {
namespace {

TEST(ExpressionLine, UpAndDownGoThroughWhatWasEnteredBefore) {
  ExpressionLine line;
  line.remember(QStringLiteral("y = 1"));
  line.remember(QStringLiteral("y = 2"));
  QTest::keyClicks(&line, QStringLiteral("y = x"));
  QTest::keyClick(&line, Qt::Key_Up);
  EXPECT_EQ(line.text(), QStringLiteral("y = 2"));
  QTest::keyClick(&line, Qt::Key_Up);
  EXPECT_EQ(line.text(), QStringLiteral("y = 1"));
  QTest::keyClick(&line, Qt::Key_Up);
  EXPECT_EQ(line.text(), QStringLiteral("y = 1"));
  QTest::keyClick(&line, Qt::Key_Down);
  QTest::keyClick(&line, Qt::Key_Down);
  EXPECT_EQ(line.text(), QStringLiteral("y = x"));
}

TEST(ExpressionLine, WhatIsEnteredTwiceStandsInTheHistoryOnceAndLast) {
  ExpressionLine line;
  for (const char* text : {"y = 1", "y = 2", "y = 1", "  "}) line.remember(QString::fromLatin1(text));
  EXPECT_EQ(line.history(), (QStringList{QStringLiteral("y = 2"), QStringLiteral("y = 1")}));
}

TEST(ExpressionLine, TheHistoryKeepsTheNewestFifty) {
  ExpressionLine line;
  for (int i = 0; i < 60; ++i) line.remember(QString::number(i));
  EXPECT_EQ(line.history().size(), 50);
  EXPECT_EQ(line.history().front(), QStringLiteral("10"));
}

/// Columns of a picture that hold the colour of the mark.
QList<int> marked_columns(ExpressionLine& line) {
  const QImage picture = line.grab().toImage();
  const QColor mark = current_colours().vermilion;
  QList<int> columns;
  for (int x = 0; x < picture.width(); ++x)
    for (int y = 0; y < picture.height(); ++y) {
      const QColor c = picture.pixelColor(x, y);
      if (std::abs(c.red() - mark.red()) + std::abs(c.green() - mark.green()) +
              std::abs(c.blue() - mark.blue()) <
          60) {
        columns.append(x);
        break;
      }
    }
  return columns;
}

TEST(ExpressionLine, AnErrorIsUnderlinedWhereItIs) {
  ExpressionLine line;
  line.resize(400, 40);
  line.setText(QStringLiteral("y = sin(x) + foo"));
  EXPECT_TRUE(marked_columns(line).isEmpty());
  line.mark_error(14);
  const auto late = marked_columns(line);
  ASSERT_FALSE(late.isEmpty());
  line.mark_error(5);
  const auto early = marked_columns(line);
  ASSERT_FALSE(early.isEmpty());
  EXPECT_LT(early.back(), late.front());
  line.mark_error(0);
  EXPECT_TRUE(marked_columns(line).isEmpty());
}

TEST(ExpressionLine, AnErrorIsUnderlinedWhereItIsInTeethOfAnEighthOfTheText) {
  ExpressionLine line(nullptr);
  line.resize(400, 40);
  line.setText(QStringLiteral("y = 𝑥 + ?"));
  line.setCursorPosition(0);
  const auto zigzag = [&](int column) {
    line.mark_error(column);
    test::Drawn found;
    for (const auto& one : test::drawn_by(line).all)
      if (test::name_of(one.pen.color()) == QStringLiteral("vermilion")) found = one;
    return found;
  };
  EXPECT_TRUE(zigzag(0).points.isEmpty());
  const QFontMetrics metrics = line.fontMetrics();
  const int tooth = std::max(2, metrics.height() / 8);
  const auto first = zigzag(1);
  ASSERT_GE(first.points.size(), 2);
  EXPECT_NEAR(first.points[1].x() - first.points[0].x(), tooth, 0.01);
  EXPECT_NEAR(first.points[0].y() - first.points[1].y(), tooth, 0.01);
  EXPECT_NEAR(first.pen.widthF(), std::max(1.5, metrics.height() / 12.0), 0.01);
  EXPECT_GE(first.box.width(), metrics.averageCharWidth());
  // Column 5 is one letter of two units; column 9 is the sixth place after it.
  const auto letter = zigzag(5);
  EXPECT_NEAR(letter.points[0].x() - first.points[0].x(), metrics.horizontalAdvance(QStringLiteral("y = ")),
              1.01);
  const auto last = zigzag(9);
  EXPECT_NEAR(last.points[0].x() - first.points[0].x(), metrics.horizontalAdvance(QStringLiteral("y = 𝑥 + ")),
              1.01);
  const auto behind = zigzag(10);
  EXPECT_NEAR(behind.points[0].x() - first.points[0].x(), metrics.horizontalAdvance(line.text()), 1.01);
}

}  // namespace
}  // namespace nazori::ui
