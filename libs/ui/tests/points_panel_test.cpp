// SPDX-License-Identifier: Apache-2.0
#include "functions/points_panel.h"

#include <gtest/gtest.h>

#include <QHeaderView>
#include <QLabel>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTest>

#include "drawing_under_test.h"
#include "functions/plot_words.h"

namespace nazori::ui {
namespace {

class PointsTable : public testing::Test {
 protected:
  PointsTable() {
    panel_.resize(700, 600);
    panel_.show();
  }
  QTableWidget* table() { return panel_.findChild<QTableWidget*>(); }
  QLabel* summary() { return panel_.findChild<QLabel*>(QStringLiteral("plot_summary")); }
  bool says(const QString& text) {
    for (const auto* label : panel_.findChildren<QLabel*>())
      if (label->isVisible() && label->text() == text) return true;
    return false;
  }
  QStringList row(int number) {
    QStringList cells;
    for (int column = 0; column < 3; ++column) cells.append(table()->item(number, column)->text());
    return cells;
  }
  const QString none_ = QStringLiteral("None in this range.");
  PointsPanel panel_;
};

TEST_F(PointsTable, OfADrawingStandInItsOrderWithKindAndPlace) {
  const auto drawing = functions::test::draw("y = x^2 - 1", {-3, 3, -3, 3});
  panel_.show_drawing(drawing);
  ASSERT_EQ(table()->rowCount(), static_cast<int>(drawing->points.size()));
  ASSERT_GE(table()->rowCount(), 3);
  for (int i = 0; i < table()->rowCount(); ++i) {
    const auto& point = drawing->points[static_cast<std::size_t>(i)];
    EXPECT_EQ(row(i), (QStringList{kind_words(point.kind), coordinate_text(point.x, point.x_name),
                                   coordinate_text(point.y, point.y_name)}));
    for (int column = 0; column < 3; ++column) {
      EXPECT_EQ(table()->item(i, column)->data(Qt::AccessibleTextRole).toString(), point_words(point));
      EXPECT_EQ(table()->item(i, column)->toolTip(), point_words(point));
      EXPECT_FALSE(table()->item(i, column)->flags().testFlag(Qt::ItemIsEditable));
    }
  }
  QStringList heads;
  for (int column = 0; column < 3; ++column) heads.append(table()->horizontalHeaderItem(column)->text());
  EXPECT_EQ(heads.join(u' '), QStringLiteral("Type x y"));
  EXPECT_TRUE(table()->isVisible());
  EXPECT_FALSE(says(none_));
  EXPECT_EQ(summary()->text(), QString::fromStdString(drawing->summary));
}

TEST_F(PointsTable, OfSeveralCurvesNameTheirCurvesFrom1) {
  const auto drawing = functions::test::draw("y = x; y = 2 - x", {-3, 3, -3, 3});
  panel_.show_drawing(drawing);
  QStringList kinds;
  for (int i = 0; i < table()->rowCount(); ++i) kinds.append(row(i)[0]);
  EXPECT_EQ(kinds.count(QStringLiteral("crossing, curves 1 and 2")), 1) << kinds.join(u'|').toStdString();
  EXPECT_TRUE(kinds.contains(QStringLiteral("zero, curve 1"))) << kinds.join(u'|').toStdString();
  EXPECT_TRUE(kinds.contains(QStringLiteral("zero, curve 2")));
}

TEST_F(PointsTable, WhereThereAreNoneThatIsSaidInPlaceOfTheTable) {
  panel_.show_drawing(functions::test::draw("y = x", {-3, 3, -3, 3}));
  ASSERT_TRUE(table()->isVisible());
  const auto drawing = functions::test::draw("y = 1", {1, 2, 0, 3});
  ASSERT_TRUE(drawing->points.empty());
  panel_.show_drawing(drawing);
  EXPECT_FALSE(table()->isVisible());
  EXPECT_EQ(table()->rowCount(), 0);
  EXPECT_TRUE(says(none_));
  EXPECT_TRUE(summary()->isVisible());
}

TEST_F(PointsTable, OfAStoppedDrawingWereNotLookedFor) {
  const auto drawing = functions::test::draw("y = 1", {1, 2, 0, 3});
  drawing->final = false;
  panel_.show_drawing(drawing);
  EXPECT_EQ(summary()->text(),
            QStringLiteral("The drawing was stopped before the points of interest were found."));
  EXPECT_FALSE(says(none_)) << "nobody knows";
}

TEST_F(PointsTable, BeforeTheFirstDrawingNothingIsToldOfOne) {
  panel_.show_drawing({});
  EXPECT_EQ(summary()->text(), QString());
  EXPECT_EQ(table()->rowCount(), 0);
  EXPECT_FALSE(table()->isVisible());
}

TEST_F(PointsTable, AreGoneToByClickAndByKey) {
  panel_.show_drawing(functions::test::draw("y = x^2 - 1", {-3, 3, -3, 3}));
  QSignalSpy chosen(&panel_, &PointsPanel::point_chosen);
  const auto middle = [&](int number) { return table()->visualItemRect(table()->item(number, 0)).center(); };
  QTest::mouseClick(table()->viewport(), Qt::LeftButton, {}, middle(1));
  ASSERT_GE(chosen.count(), 1);
  EXPECT_EQ(chosen.last().at(0).toInt(), 1);
  chosen.clear();
  panel_.set_current(2);
  EXPECT_EQ(table()->currentRow(), 2);
  QTest::keyClick(table(), Qt::Key_Return);
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_EQ(chosen.last().at(0).toInt(), 2);
}

TEST_F(PointsTable, TheKeyboardComesToTheRowItLeft) {
  panel_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&panel_));
  panel_.show_drawing({});
  panel_.focus_table();
  EXPECT_TRUE(summary()->hasFocus()) << "there is no row";
  panel_.show_drawing(functions::test::draw("y = x^2 - 1", {-3, 3, -3, 3}));
  panel_.focus_table();
  EXPECT_TRUE(table()->hasFocus());
  EXPECT_EQ(table()->currentRow(), 0);
  panel_.set_current(2);
  summary()->setFocus();
  panel_.focus_table();
  EXPECT_EQ(table()->currentRow(), 2);
}

TEST_F(PointsTable, StandInColumnsWhereThereIsRoomAndElseUnderEachOther) {
  panel_.show_drawing(functions::test::draw("y = x^2 - 1", {-3, 3, -3, 3}));
  const auto stacked = [&] {
    QCoreApplication::processEvents();
    EXPECT_EQ(table()->isColumnHidden(1), table()->isColumnHidden(2));
    EXPECT_FALSE(table()->isColumnHidden(0));
    EXPECT_EQ(table()->horizontalHeader()->isVisible(), !table()->isColumnHidden(1));
    return table()->isColumnHidden(1);
  };
  EXPECT_FALSE(stacked());
  const int one_line = table()->rowHeight(0);
  panel_.resize(150, 600);
  EXPECT_TRUE(stacked());
  EXPECT_GT(table()->rowHeight(0), 2 * one_line);
  EXPECT_LE(table()->columnWidth(0), table()->viewport()->width());
  panel_.resize(700, 600);
  EXPECT_FALSE(stacked());
  EXPECT_EQ(table()->rowHeight(0), one_line);
}

TEST_F(PointsTable, ALongSentenceGivesWayToTheTable) {
  const auto drawing = functions::test::draw("y = x^2 - 1", {-3, 3, -3, 3});
  drawing->summary = std::string(3000, 'a');
  for (std::size_t i = 8; i < drawing->summary.size(); i += 9) drawing->summary[i] = ' ';
  panel_.resize(300, 400);
  panel_.show_drawing(drawing);
  EXPECT_FALSE(summary()->isVisible());
  drawing->points.clear();
  panel_.show_drawing(drawing);
  EXPECT_TRUE(summary()->isVisible()) << "there is no table";
}

}  // namespace
}  // namespace nazori::ui
