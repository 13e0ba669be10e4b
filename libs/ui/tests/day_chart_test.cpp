// SPDX-License-Identifier: Apache-2.0
// A chart as it is drawn: its axes, its bars and lines, and the row that is read.
#include "progress/day_chart.h"

#include <gtest/gtest.h>

#include <QBarSeries>
#include <QBarSet>
#include <QCategoryAxis>
#include <QGraphicsLineItem>
#include <QLegendMarker>
#include <QLineSeries>
#include <QScatterSeries>
#include <QSignalSpy>
#include <QTest>
#include <QValueAxis>
#include <QWheelEvent>
#include <memory>

namespace nazori::ui {
namespace {

using Form = ChartSeries::Form;
using Side = ChartSeries::Axis;

Chart chart_of(QList<ChartSeries> series, QList<double> places = {}) {
  Chart chart;
  chart.series = std::move(series);
  const auto rows = chart.series.isEmpty() ? 0 : chart.series.front().values.size();
  for (qsizetype row = 0; row < rows; ++row)
    chart.places.append(places.isEmpty() ? static_cast<double>(row) : places[row]);
  for (qsizetype row = 0; row < rows; ++row) chart.row_names.append(QStringLiteral("%1 Mar").arg(row + 1));
  return chart;
}
ChartSeries series(QList<double> values, Form form = Form::line, Side side = Side::left) {
  return {QStringLiteral("Reviews"), form, side, std::move(values)};
}

class DayChartTest : public testing::Test {
 protected:
  DayChartTest() : view_(new DayChart(&parent_)) {
    parent_.resize(900, 400);
    view_->setGeometry(0, 0, 900, 400);
  }
  [[nodiscard]] QList<QAbstractAxis*> axes(Qt::Orientation way) const { return view_->chart()->axes(way); }
  [[nodiscard]] QValueAxis* axis(Qt::Alignment at = Qt::AlignLeft) const {
    for (auto* one : axes(Qt::Vertical))
      if (one->alignment() == at) return qobject_cast<QValueAxis*>(one);
    return nullptr;
  }
  /// "0..4 5 %.0f": range, ticks and numbers of the left axis for values.
  QString scale(QList<double> values, Form form = Form::line) {
    view_->show_chart(chart_of({series(std::move(values), form)}));
    return QStringLiteral("%1..%2 %3 %4")
        .arg(axis()->min())
        .arg(axis()->max())
        .arg(axis()->tickCount())
        .arg(axis()->labelFormat());
  }
  [[nodiscard]] QCategoryAxis* days() const {
    return qobject_cast<QCategoryAxis*>(axes(Qt::Horizontal).at(0));
  }
  [[nodiscard]] const QGraphicsLineItem* mark() const {
    for (auto* item : view_->chart()->childItems())
      if (auto* line = dynamic_cast<QGraphicsLineItem*>(item); line != nullptr && line->zValue() == 20)
        return line;
    return nullptr;
  }

  QWidget parent_;
  DayChart* view_;
};

TEST_F(DayChartTest, AnAxisEndsAtARoundNumberOverTheGreatest) {
  EXPECT_EQ(scale({0, 0}), QStringLiteral("0..1 5 %.2f"));
  EXPECT_EQ(scale({1, 1}), QStringLiteral("0..1 5 %.2f"));
  EXPECT_EQ(scale({1, 1.5}), QStringLiteral("0..2 5 %.1f"));
  EXPECT_EQ(scale({2, 3}), QStringLiteral("0..4 5 %.0f"));
  EXPECT_EQ(scale({4.5, 0}), QStringLiteral("0..5 5 %.2f"));
  EXPECT_EQ(scale({5.5, 0}), QStringLiteral("0..10 5 %.1f"));
  EXPECT_EQ(scale({10, 0}), QStringLiteral("0..10 5 %.1f"));
  EXPECT_EQ(scale({35, 0}), QStringLiteral("0..40 5 %.0f"));
  EXPECT_EQ(scale({0.3, 0}), QStringLiteral("0..0.4 5 %.1f"));
}

TEST_F(DayChartTest, WhatIsCountedHasWholeNumbersOnly) {
  EXPECT_EQ(scale({0, 0}, Form::bars), QStringLiteral("0..1 2 %.0f"));
  EXPECT_EQ(scale({0, 1}, Form::bars), QStringLiteral("0..1 2 %.0f"));
  EXPECT_EQ(scale({0, 2}, Form::bars), QStringLiteral("0..2 3 %.0f"));
  EXPECT_EQ(scale({0, 3}, Form::bars), QStringLiteral("0..4 5 %.0f"));
  EXPECT_EQ(scale({0, 13}, Form::bars), QStringLiteral("0..20 5 %.0f"));
}

TEST_F(DayChartTest, BelowNothingTheAxisGoesDown) {
  EXPECT_EQ(scale({-2.5, -1.75}), QStringLiteral("-4..0 5 %.0f"));
  EXPECT_EQ(scale({-1.5, 3}), QStringLiteral("-2..4 5 %.1f"));
}

TEST_F(DayChartTest, ARangeThatIsGivenHoldsForTheLeftAxisOnly) {
  Chart chart = chart_of({series({90, 80}), series({1, 2}, Form::line, Side::right)});
  chart.series[0].unit = QStringLiteral(" %%");
  chart.left_range = {80, 100};
  view_->show_chart(chart);
  EXPECT_EQ(axis()->min(), 80);
  EXPECT_EQ(axis()->max(), 100);
  EXPECT_EQ(axis()->labelFormat(), QStringLiteral("%.0f %%"));
  EXPECT_TRUE(axis()->isGridLineVisible());
  ASSERT_NE(axis(Qt::AlignRight), nullptr);
  EXPECT_EQ(axis(Qt::AlignRight)->min(), 0);
  EXPECT_EQ(axis(Qt::AlignRight)->max(), 2);
  EXPECT_FALSE(axis(Qt::AlignRight)->isGridLineVisible()) << "two grids would cross";
}

TEST_F(DayChartTest, SeriesOfOneSideShareItsAxis) {
  view_->show_chart(chart_of({series({1, 2}), series({2, 1})}));
  EXPECT_EQ(axes(Qt::Vertical).size(), 1);
  EXPECT_EQ(axes(Qt::Horizontal).size(), 1);
  for (auto* one : view_->chart()->series()) EXPECT_EQ(one->attachedAxes().size(), 2);
}

TEST_F(DayChartTest, BarsStandAtTheirDaysWithNothingBetween) {
  view_->show_chart(chart_of({series({5, 6, 7}, Form::bars)}, {0, 1, 3}));
  ASSERT_EQ(view_->chart()->series().size(), 1);
  const auto* bars = qobject_cast<QBarSeries*>(view_->chart()->series().at(0));
  ASSERT_NE(bars, nullptr);
  const auto* set = bars->barSets().at(0);
  QList<double> heights;
  for (int i = 0; i < set->count(); ++i) heights.append(set->at(i));
  EXPECT_EQ(heights, (QList<double>{5, 6, 0, 7}));
  EXPECT_EQ(set->label(), QStringLiteral("Reviews"));
  EXPECT_EQ(days()->min(), -0.5);
  EXPECT_EQ(days()->max(), 3.5);
  EXPECT_FALSE(view_->chart()->legend()->isVisible());
}

TEST_F(DayChartTest, LinesAreToldApartByDashesAndMarks) {
  view_->show_chart(chart_of({series({5, 6}), series({7, 8})}, {0, 4}));
  const auto all = view_->chart()->series();
  ASSERT_EQ(all.size(), 4);
  const auto* first = qobject_cast<QLineSeries*>(all[0]);
  const auto* marks = qobject_cast<QScatterSeries*>(all[1]);
  const auto* second = qobject_cast<QLineSeries*>(all[2]);
  const auto* other_marks = qobject_cast<QScatterSeries*>(all[3]);
  ASSERT_TRUE(first != nullptr && marks != nullptr && second != nullptr && other_marks != nullptr);
  EXPECT_EQ(first->points(), (QList<QPointF>{{0, 5}, {4, 6}}));
  EXPECT_EQ(marks->points(), first->points());
  EXPECT_EQ(other_marks->points(), second->points());
  EXPECT_EQ(first->pen().style(), Qt::SolidLine);
  EXPECT_EQ(second->pen().style(), Qt::DashLine);
  EXPECT_NE(marks->markerShape(), other_marks->markerShape());
  EXPECT_EQ(first->name(), QStringLiteral("Reviews"));
  EXPECT_TRUE(view_->chart()->legend()->isVisible());
  int told = 0;
  for (const auto* marker : view_->chart()->legend()->markers()) told += marker->isVisible() ? 1 : 0;
  EXPECT_EQ(told, 2) << "each line once";
}

TEST_F(DayChartTest, ALineOfManyRowsHasNoMarks) {
  view_->show_chart(chart_of({series(QList<double>(62, 1.0))}));
  EXPECT_EQ(view_->chart()->series().size(), 2);
  view_->show_chart(chart_of({series(QList<double>(63, 1.0))}));
  EXPECT_EQ(view_->chart()->series().size(), 1);
}

TEST_F(DayChartTest, DaysAreNamedAsOftenAsThereIsRoomFromTheFirstOn) {
  parent_.show();
  view_->show_chart(chart_of({series(QList<double>(30, 1.0), Form::bars)}));
  const auto named = [this] { return days()->categoriesLabels(); };
  const double widest = view_->fontMetrics().horizontalAdvance(QStringLiteral("30 Mar"));
  int before = 0;
  for (const int width : {60, 500, 900, 3000}) {
    view_->resize(width, 400);
    QCoreApplication::processEvents();
    ASSERT_FALSE(named().isEmpty()) << width;
    EXPECT_EQ(named().front(), QStringLiteral("1 Mar"));
    EXPECT_GE(named().size(), before) << width;
    before = static_cast<int>(named().size());
    if (named().size() > 2 && width >= 500) {
      const double apart = days()->endValue(named()[1]) - days()->endValue(named()[0]);
      EXPECT_GT(apart * view_->chart()->plotArea().width() / 30, widest) << width;
    }
  }
  EXPECT_EQ(before, 30) << "all where there is room";
}

TEST_F(DayChartTest, DaysOfOneNameAreAllThere) {
  Chart chart = chart_of({series({1, 2, 3}, Form::bars)});
  chart.row_names = {QStringLiteral("2 Mar"), QStringLiteral("2 Mar"), QStringLiteral("2 Mar")};
  view_->resize(2000, 300);
  view_->show_chart(chart);
  EXPECT_EQ(days()->categoriesLabels().size(), 3);
}

TEST_F(DayChartTest, KeysGoFromRowToRowAndStopAtTheEnds) {
  view_->show_chart(chart_of({series({1, 2, 3}, Form::bars)}));
  EXPECT_EQ(view_->row(), -1);
  EXPECT_FALSE(mark()->isVisible());
  const QSignalSpy changed(view_, &DayChart::row_changed);
  const auto press = [this](Qt::Key key) {
    QTest::keyClick(view_, key);
    return view_->row();
  };
  EXPECT_EQ(press(Qt::Key_Left), 2) << "from nowhere to the last";
  EXPECT_EQ(press(Qt::Key_Left), 1);
  EXPECT_EQ(press(Qt::Key_Right), 2);
  EXPECT_EQ(press(Qt::Key_Right), 2);
  EXPECT_EQ(press(Qt::Key_Home), 0);
  EXPECT_EQ(press(Qt::Key_Left), 0);
  EXPECT_EQ(press(Qt::Key_End), 2);
  EXPECT_EQ(changed.count(), 5) << "told only where it went on";
  EXPECT_EQ(changed.last().at(0).toInt(), 2);
  EXPECT_TRUE(mark()->isVisible());
  view_->show_chart(chart_of({series({1, 2, 3}, Form::bars)}));
  EXPECT_EQ(view_->row(), -1);
  EXPECT_EQ(press(Qt::Key_Right), 0) << "from nowhere to the first";
  view_->show_chart(Chart{});
  EXPECT_EQ(press(Qt::Key_End), -1);
}

TEST_F(DayChartTest, TheMarkStandsAtTheMiddleOfItsDay) {
  parent_.show();
  view_->show_chart(chart_of({series({1, 2, 3}, Form::bars)}, {0, 1, 4}));
  QCoreApplication::processEvents();
  view_->set_row(2);
  const QRectF plot = view_->chart()->plotArea();
  EXPECT_NEAR(mark()->line().x1(), plot.left() + plot.width() * 0.9, 1e-6);
  EXPECT_EQ(mark()->line().x1(), mark()->line().x2());
  EXPECT_EQ(mark()->line().y1(), plot.top());
  EXPECT_EQ(mark()->line().y2(), plot.bottom());
  // The nearest day is taken by the pointer.
  const auto click = [&](double share) {
    QTest::mouseClick(view_->viewport(), Qt::LeftButton, {},
                      QPoint(static_cast<int>(plot.left() + plot.width() * share), 100));
    return view_->row();
  };
  EXPECT_EQ(click(0.05), 0);
  EXPECT_EQ(click(0.28), 1);
  EXPECT_EQ(click(0.55), 1);
  EXPECT_EQ(click(0.65), 2);
  view_->resize(500, 300);
  QCoreApplication::processEvents();
  const QRectF smaller = view_->chart()->plotArea();
  EXPECT_NEAR(mark()->line().x1(), smaller.left() + smaller.width() * 0.9, 1e-6) << "also in another size";
}

TEST_F(DayChartTest, TheWheelIsThePages) {
  view_->show_chart(chart_of({series({1, 2, 3}, Form::bars)}));
  QWheelEvent wheel({10, 10}, {10, 10}, {}, {0, 120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
  wheel.accept();
  QCoreApplication::sendEvent(view_->viewport(), &wheel);
  EXPECT_FALSE(wheel.isAccepted());
}

}  // namespace
}  // namespace nazori::ui
