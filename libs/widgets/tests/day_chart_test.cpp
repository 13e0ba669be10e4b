// SPDX-License-Identifier: Apache-2.0
// A chart as it is painted: the positions of bars, lines and names, and the row that is read.
#include "nazori/widgets/charts/day_chart.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>
#include <QWheelEvent>

#include "nazori/widgets/charts/role_colours.h"
#include "nazori/widgets/look/palette.h"

namespace nazori::ui {
namespace {

using practice::Series;
using practice::Side;

struct Drawn {
  std::vector<double> values;
  practice::SeriesLook look = practice::first_line_look();
  Side side = Side::left;
};

practice::Chart chart_of(const std::vector<Drawn>& series, std::vector<double> positions = {}) {
  practice::Chart chart;
  for (const Drawn& one : series) {
    chart.series.push_back({chart.columns.size(), one.look, one.side});
    chart.columns.push_back({practice::Quantity::reviews, one.values});
  }
  const auto rows = series.empty() ? 0 : series.front().values.size();
  for (std::size_t row = 0; row < rows; ++row)
    chart.positions.push_back(positions.empty() ? static_cast<double>(row) : positions[row]);
  return chart;
}

ChartText text_of(const practice::Chart& chart) {
  ChartText text;
  for (int row = 0; row < practice::row_count(chart); ++row)
    text.row_names.append(QStringLiteral("%1 Mar").arg(row + 1));
  for (std::size_t i = 0; i < chart.series.size(); ++i)
    text.series_names.append(QStringLiteral("Series %1").arg(i));
  return text;
}

class DayChartTest : public testing::Test {
 protected:
  DayChartTest() : view_(new DayChart(&parent_)) {
    parent_.resize(900, 400);
    view_->setGeometry(0, 0, 900, 400);
  }
  void show(const practice::Chart& chart) { view_->show_chart(chart, text_of(chart)); }

  [[nodiscard]] QImage painted() const {
    QImage picture(view_->size(), QImage::Format_ARGB32);
    picture.fill(Qt::white);
    view_->render(&picture, {}, {}, QWidget::DrawChildren);
    return picture;
  }
  static bool is(QRgb pixel, const QColor& colour) {
    return std::abs(qRed(pixel) - colour.red()) + std::abs(qGreen(pixel) - colour.green()) +
               std::abs(qBlue(pixel) - colour.blue()) <
           12;
  }
  /// Pixels that have more of the colour than of the white around it, because thin lines are anti-aliased.
  static int count_about(const QImage& picture, const QColor& colour, const QRect& part) {
    const auto apart = [](QRgb a, QRgb b) {
      return std::abs(qRed(a) - qRed(b)) + std::abs(qGreen(a) - qGreen(b)) + std::abs(qBlue(a) - qBlue(b));
    };
    int found = 0;
    for (int y = part.top(); y <= part.bottom(); ++y)
      for (int x = part.left(); x <= part.right(); ++x)
        found += picture.rect().contains(x, y) && 2 * apart(picture.pixel(x, y), colour.rgb()) <
                                                      apart(qRgb(255, 255, 255), colour.rgb())
                     ? 1
                     : 0;
    return found;
  }
  /// A point in the plot as a pixel: as shares of its width from the left and of its height from below.
  [[nodiscard]] QPoint at(double along, double up) const {
    const QRectF plot = view_->plot_area();
    return QPointF(plot.left() + plot.width() * along, plot.bottom() - plot.height() * up).toPoint();
  }
  /// Pixels of a colour in the part of the picture.
  static int count(const QImage& picture, const QColor& colour, const QRect& part) {
    int found = 0;
    for (int y = part.top(); y <= part.bottom(); ++y)
      for (int x = part.left(); x <= part.right(); ++x)
        found += picture.rect().contains(x, y) && is(picture.pixel(x, y), colour) ? 1 : 0;
    return found;
  }

  const Colours& colours_ = current_colours();
  const QColor bars_ = colour_of(practice::bars_look().fill, colours_);
  QWidget parent_;
  DayChart* view_;
};

TEST_F(DayChartTest, BarsStandAtTheirDaysWithNothingBetween) {
  show(chart_of({{{5, 10, 7.5}, practice::bars_look()}}, {0, 1, 3}));
  const QImage picture = painted();
  const auto height = [&](double along) {
    int last = -1;
    for (int percent = 1; percent < 100; ++percent)
      if (is(picture.pixel(at(along, percent / 100.0)), bars_)) last = percent;
    return last;
  };
  EXPECT_NEAR(height(0.125), 50, 2);
  EXPECT_NEAR(height(0.375), 100, 2);
  EXPECT_EQ(height(0.625), -1) << "a day without study";
  EXPECT_NEAR(height(0.875), 75, 2);
  for (const double between : {0.005, 0.25, 0.5, 0.75})
    EXPECT_EQ(height(between), -1) << "bars do not touch: " << between;
  EXPECT_FALSE(view_->has_legend()) << "the title names it";
}

TEST_F(DayChartTest, ALineGoesFromRowToRowOnItsOwnAxis) {
  show(chart_of({{{0, 10}}, {{2, 1}, practice::second_line_look(), Side::right}}, {0, 4}));
  const QImage picture = painted();
  EXPECT_TRUE(is(picture.pixel(at(0.1, 0)), colours_.ink)) << "0 of 10, at the left";
  EXPECT_TRUE(is(picture.pixel(at(0.9, 1)), colours_.ink));
  EXPECT_TRUE(is(picture.pixel(at(0.5, 0.5)), colours_.ink)) << "straight between them";
  const auto around = [&](double along, double up) {
    return QRect(at(along, up) - QPoint(6, 6), QSize(13, 13));
  };
  EXPECT_GT(count_about(picture, colours_.indigo, around(0.1, 1)), 4) << "2 of 2, at the right axis";
  EXPECT_GT(count_about(picture, colours_.indigo, around(0.9, 0.5)), 4);
}

TEST_F(DayChartTest, LinesAreToldApartByDashesAndMarks) {
  const auto ink_along = [&](const practice::SeriesLook& look) {
    show(chart_of({{{10, 10}, look}}, {0, 19}));
    const QImage picture = painted();
    const QColor colour = colour_of(look.edge, colours_);
    const int y = at(0, 1).y();
    int drawn = 0, all = 0;
    for (int x = at(0.1, 1).x(); x < at(0.9, 1).x(); ++x, ++all)
      drawn += count(picture, colour, QRect(x, y - 1, 1, 3)) > 0 ? 1 : 0;
    return static_cast<double>(drawn) / all;
  };
  EXPECT_EQ(ink_along(practice::first_line_look()), 1) << "solid";
  const double dashed = ink_along(practice::second_line_look());
  EXPECT_GT(dashed, 0.5);
  EXPECT_LT(dashed, 0.9);

  show(chart_of({{{10, 10}}, {{5, 5}, practice::second_line_look()}}, {0, 4}));
  const QImage marks = painted();
  const QPoint disc = at(0.1, 1);
  const QPoint square = at(0.1, 0.5);
  EXPECT_TRUE(is(marks.pixel(disc), colours_.ink));
  EXPECT_TRUE(is(marks.pixel(square), colours_.surface)) << "hollow";
  EXPECT_FALSE(is(marks.pixel(disc + QPoint(-4, -4)), colours_.ink)) << "a disc has no corners";
  EXPECT_TRUE(view_->has_legend());
}

TEST_F(DayChartTest, EachSeriesIsNamedBelowWithItsSign) {
  show(chart_of({{{5, 6}, practice::bars_look()}, {{7, 8}, practice::first_line_look(), Side::right}}));
  const QImage picture = painted();
  const QRect below(0, static_cast<int>(view_->plot_area().bottom()) + 2 * view_->fontMetrics().height(), 900,
                    400);
  EXPECT_GT(count_about(picture, bars_, below & picture.rect()), 20) << "the sign of bars";
  EXPECT_GT(count(picture, colours_.ink, below & picture.rect()), 20) << "the line, and the names";
  show(chart_of({{{5, 6}, practice::bars_look()}}));
  EXPECT_EQ(count(painted(), bars_, QRect(0, static_cast<int>(view_->plot_area().bottom()) + 2, 900, 400)),
            0);
}

TEST_F(DayChartTest, ALineOfManyRowsHasNoMarks) {
  const auto thickness = [&](std::size_t rows) {
    show(chart_of({{std::vector<double>(rows, 5.0)}}));
    const QImage picture = painted();
    const QPoint middle = at(practice::share_of_row(chart_of({{std::vector<double>(rows, 5.0)}}), 5), 1);
    return count_about(picture, colours_.ink, QRect(middle - QPoint(0, 6), QSize(1, 13)));
  };
  EXPECT_GE(thickness(62), 7);
  EXPECT_LE(thickness(63), 3);
}

TEST_F(DayChartTest, OnlyTheLeftAxisHasAGrid) {
  show(chart_of({{{10, 10}, practice::first_line_look(), Side::right}}));
  EXPECT_EQ(count(painted(), colours_.line, QRect(at(0.5, 0.5) - QPoint(0, 5), QSize(1, 11))), 0);
  show(chart_of({{{10, 10}}}));
  EXPECT_GT(count(painted(), colours_.line, QRect(at(0.5, 0.5) - QPoint(0, 5), QSize(1, 11))), 0);
}

TEST_F(DayChartTest, AxesWithTheirNumbersHaveRoomBesideThePlot) {
  show(chart_of({{{10, 10}}}));
  const QRectF alone = view_->plot_area();
  const double widest = view_->fontMetrics().horizontalAdvance(QStringLiteral("10.0"));
  EXPECT_GT(alone.left(), widest);
  EXPECT_LT(900 - alone.right(), widest);
  show(chart_of({{{10, 10}}, {{10, 10}, practice::second_line_look(), Side::right}}));
  EXPECT_GT(900 - view_->plot_area().right(), widest);
  EXPECT_GT(400 - view_->plot_area().bottom(), 2 * view_->fontMetrics().height()) << "days and legend";
  EXPECT_GT(view_->plot_area().top(), view_->fontMetrics().height() / 2.0);
}

TEST_F(DayChartTest, DaysAreNamedAsOftenAsThereIsRoomFromTheFirstOn) {
  parent_.show();
  show(chart_of({{std::vector<double>(30, 1.0), practice::bars_look()}}));
  const double widest = view_->fontMetrics().horizontalAdvance(QStringLiteral("30 Mar"));
  std::size_t before = 0;
  for (const int width : {60, 500, 900, 3000}) {
    view_->resize(width, 400);
    QCoreApplication::processEvents();
    const auto named = view_->named_rows();
    ASSERT_FALSE(named.empty()) << width;
    EXPECT_EQ(named.front(), 0);
    EXPECT_GE(named.size(), before) << width;
    before = named.size();
    if (named.size() > 2 && width >= 500) {
      const int apart = named[1] - named[0];
      EXPECT_GT(apart * view_->plot_area().width() / 30, widest) << width;
    }
  }
  EXPECT_EQ(before, 30U) << "all where there is room";
}

TEST_F(DayChartTest, DaysOfOneNameAreAllThere) {
  const auto chart = chart_of({{{1, 2, 3}, practice::bars_look()}});
  ChartText text = text_of(chart);
  text.row_names = {QStringLiteral("2 Mar"), QStringLiteral("2 Mar"), QStringLiteral("2 Mar")};
  view_->resize(2000, 300);
  view_->show_chart(chart, text);
  EXPECT_EQ(view_->named_rows().size(), 3U);
}

TEST_F(DayChartTest, KeysGoFromRowToRowAndStopAtTheEnds) {
  show(chart_of({{{1, 2, 3}, practice::bars_look()}}));
  EXPECT_EQ(view_->row(), -1);
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
  show(chart_of({{{1, 2, 3}, practice::bars_look()}}));
  EXPECT_EQ(view_->row(), -1);
  EXPECT_EQ(press(Qt::Key_Right), 0) << "from nowhere to the first";
  show({});
  EXPECT_EQ(press(Qt::Key_End), -1);
}

TEST_F(DayChartTest, TheMarkStandsAtTheMiddleOfItsDay) {
  parent_.show();
  // The bar of the last day is far from the mark's colour, so that only the mark is counted.
  show(chart_of({{{1, 2, 0}, practice::bars_look()}}, {0, 1, 4}));
  QCoreApplication::processEvents();
  const auto marked = [&] {
    const QPoint middle = at(0.9, 0.5);
    return count(painted(), colours_.indigo,
                 QRect(middle.x() - 2, static_cast<int>(view_->plot_area().top()), 5,
                       static_cast<int>(view_->plot_area().height())));
  };
  EXPECT_EQ(marked(), 0) << "no row is read";
  view_->set_row(2);
  EXPECT_GT(marked(), 50);
  const QRectF plot = view_->plot_area();
  EXPECT_NEAR(view_->mark_x(), plot.left() + plot.width() * 0.9, 1e-6);
  // The pointer reads the nearest day.
  const auto click = [&](double share) {
    QTest::mouseClick(view_, Qt::LeftButton, {},
                      QPoint(static_cast<int>(plot.left() + plot.width() * share), 100));
    return view_->row();
  };
  EXPECT_EQ(click(0.05), 0);
  EXPECT_EQ(click(0.28), 1);
  EXPECT_EQ(click(0.55), 1);
  EXPECT_EQ(click(0.65), 2);
  view_->resize(500, 300);
  QCoreApplication::processEvents();
  const QRectF smaller = view_->plot_area();
  EXPECT_NEAR(view_->mark_x(), smaller.left() + smaller.width() * 0.9, 1e-6) << "also in another size";
}

TEST_F(DayChartTest, TheWheelIsThePages) {
  show(chart_of({{{1, 2, 3}, practice::bars_look()}}));
  QWheelEvent wheel({10, 10}, {10, 10}, {}, {0, 120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
  wheel.accept();
  QCoreApplication::sendEvent(view_, &wheel);
  EXPECT_FALSE(wheel.isAccepted());
}

TEST_F(DayChartTest, TooLittleRoomPaintsNothing) {
  show(chart_of({{{1, 2, 3}, practice::bars_look()}}));
  view_->resize(12, 9);
  EXPECT_EQ(count(painted(), bars_, QRect(0, 0, 12, 9)), 0);
}

}  // namespace
}  // namespace nazori::ui
