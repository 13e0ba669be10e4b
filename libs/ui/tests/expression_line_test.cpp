// SPDX-License-Identifier: Apache-2.0
#include "functions/expression_line.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QTest>

#include "nazori/widgets/look/palette.h"

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

}  // namespace
}  // namespace nazori::ui
