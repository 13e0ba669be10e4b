// SPDX-License-Identifier: Apache-2.0
// A chart as it is to be drawn: its axes, where its rows lie, which are named, and the row that is read.
#include "nazori/practice/chart.h"

#include <gtest/gtest.h>

namespace nazori::practice {
namespace {

/// A series with its column. @param look  bars_look(), ...
struct Drawn {
  std::vector<double> values;
  SeriesLook look = first_line_look();
  Side side = Side::left;
  Quantity quantity = Quantity::reviews;
};

Chart chart_of(const std::vector<Drawn>& series, std::vector<double> positions = {}) {
  Chart chart;
  for (const Drawn& one : series) {
    chart.series.push_back({chart.columns.size(), one.look, one.side});
    chart.columns.push_back({one.quantity, one.values});
  }
  const auto rows = series.empty() ? 0 : series.front().values.size();
  for (std::size_t row = 0; row < rows; ++row)
    chart.positions.push_back(positions.empty() ? static_cast<double>(row) : positions[row]);
  return chart;
}

struct Scale {
  double low, high;
  int ticks, decimals;
  friend bool operator==(const Scale&, const Scale&) = default;
  friend void PrintTo(const Scale& s, std::ostream* out) {
    *out << s.low << ".." << s.high << ' ' << s.ticks << " ticks, decimals " << s.decimals;
  }
};
/// Range, ticks and tick values of the left axis for some values.
Scale scale(std::vector<double> values, const SeriesLook& look = first_line_look()) {
  const auto axis = value_axis(chart_of({{std::move(values), look}}), Side::left);
  return {axis->low, axis->high, axis->ticks, axis->numbers.decimals};
}

TEST(ChartAxis, EndsAtARoundNumberOverTheGreatest) {
  EXPECT_EQ(scale({0, 0}), (Scale{0, 1, 5, 2}));
  EXPECT_EQ(scale({1, 1}), (Scale{0, 1, 5, 2}));
  EXPECT_EQ(scale({1, 1.5}), (Scale{0, 2, 5, 1}));
  EXPECT_EQ(scale({2, 3}), (Scale{0, 4, 5, 0}));
  EXPECT_EQ(scale({4.5, 0}), (Scale{0, 5, 5, 2}));
  EXPECT_EQ(scale({5.5, 0}), (Scale{0, 10, 5, 1}));
  EXPECT_EQ(scale({10, 0}), (Scale{0, 10, 5, 1}));
  EXPECT_EQ(scale({35, 0}), (Scale{0, 40, 5, 0}));
  EXPECT_EQ(scale({0.3, 0}).ticks, 5);
  EXPECT_DOUBLE_EQ(scale({0.3, 0}).high, 0.4);
  EXPECT_EQ(scale({0.3, 0}).decimals, 1);
}

TEST(ChartAxis, OfWhatIsCountedHasWholeNumbersOnly) {
  EXPECT_EQ(scale({0, 0}, bars_look()), (Scale{0, 1, 2, 0}));
  EXPECT_EQ(scale({0, 1}, bars_look()), (Scale{0, 1, 2, 0}));
  EXPECT_EQ(scale({0, 2}, bars_look()), (Scale{0, 2, 3, 0}));
  EXPECT_EQ(scale({0, 3}, bars_look()), (Scale{0, 4, 5, 0}));
  EXPECT_EQ(scale({0, 13}, bars_look()), (Scale{0, 20, 5, 0}));
}

TEST(ChartAxis, GoesDownBelowNothing) {
  EXPECT_EQ(scale({-2.5, -1.75}), (Scale{-4, 0, 5, 0}));
  EXPECT_EQ(scale({-1.5, 3}), (Scale{-2, 4, 5, 1}));
}

TEST(ChartAxis, HasItsTicksEvenlyFromEndToEnd) {
  const auto axis = value_axis(chart_of({{{-1.5, 3}}}), Side::left);
  EXPECT_DOUBLE_EQ(axis->value(0), -2);
  EXPECT_DOUBLE_EQ(axis->value(1), -0.5);
  EXPECT_DOUBLE_EQ(axis->value(4), 4);
}

TEST(ChartAxis, ARangeThatIsGivenHoldsForTheLeftOneOnly) {
  Chart chart = chart_of({{{90, 80}, first_line_look(), Side::left, Quantity::recalled},
                          {{1, 2}, second_line_look(), Side::right}});
  chart.left_range = {80, 100};
  const auto left = value_axis(chart, Side::left);
  EXPECT_EQ(left->low, 80);
  EXPECT_EQ(left->high, 100);
  EXPECT_EQ(left->numbers, (NumberFormat{0, true}));
  EXPECT_TRUE(left->grid);
  const auto right = value_axis(chart, Side::right);
  ASSERT_TRUE(right);
  EXPECT_EQ(right->low, 0);
  EXPECT_EQ(right->high, 2);
  EXPECT_FALSE(right->numbers.percent);
  EXPECT_FALSE(right->grid) << "two grids would cross";
}

TEST(ChartAxis, IsSharedByTheSeriesOfOneSideAndFitsTheFirst) {
  const Chart chart = chart_of({{{1, 2}}, {{20, 10}, second_line_look()}});
  EXPECT_EQ(value_axis(chart, Side::left)->high, 2);
  EXPECT_FALSE(value_axis(chart, Side::right));
}

TEST(ChartAxis, IsThereOnlyWithRows) {
  EXPECT_FALSE(value_axis(Chart{}, Side::left));
  EXPECT_FALSE(value_axis(chart_of({{{}}}), Side::left));
}

TEST(ChartRows, LieAtTheMiddleOfTheirPeriods) {
  const Chart chart = chart_of({{{5, 6, 7}, bars_look()}}, {0, 1, 4});
  EXPECT_EQ(row_count(chart), 3);
  EXPECT_DOUBLE_EQ(share_of_row(chart, 0), 0.1);
  EXPECT_DOUBLE_EQ(share_of_row(chart, 1), 0.3);
  EXPECT_DOUBLE_EQ(share_of_row(chart, 2), 0.9);
  EXPECT_DOUBLE_EQ(share_of_period(chart), 0.2);
}

TEST(ChartRows, TheNearestIsFound) {
  const Chart chart = chart_of({{{5, 6, 7}, bars_look()}}, {0, 1, 4});
  EXPECT_EQ(row_near(chart, 0.05), 0);
  EXPECT_EQ(row_near(chart, 0.28), 1);
  EXPECT_EQ(row_near(chart, 0.55), 1);
  EXPECT_EQ(row_near(chart, 0.65), 2);
  EXPECT_EQ(row_near(chart, -3), 0);
  EXPECT_EQ(row_near(chart, 3), 2);
  EXPECT_EQ(row_near(Chart{}, 0.5), -1);
}

TEST(ChartRows, AreNamedAsOftenAsThereIsRoomFromTheFirstOn) {
  const Chart chart = chart_of({{std::vector<double>(30, 1.0), bars_look()}});
  std::size_t before = 0;
  for (const int most : {1, 2, 7, 12, 30, 100}) {
    const auto rows = named_rows(chart, most);
    ASSERT_FALSE(rows.empty());
    EXPECT_EQ(rows.front(), 0);
    EXPECT_LE(rows.size(), static_cast<std::size_t>(most));
    EXPECT_GE(rows.size(), before);
    before = rows.size();
    for (std::size_t i = 2; i < rows.size(); ++i)
      EXPECT_EQ(rows[i] - rows[i - 1], rows[1] - rows[0]) << most << ": evenly, as the rows lie evenly";
  }
  EXPECT_EQ(before, 30U) << "all where there is room";
  EXPECT_TRUE(named_rows(Chart{}, 5).empty());
}

TEST(ChartRows, NamesKeepTheirDistanceWhereDaysAreLeftOut) {
  const Chart chart = chart_of({{{1, 1, 1, 1, 1}}}, {0, 1, 2, 18, 19});
  EXPECT_EQ(named_rows(chart, 4), (std::vector<int>{0, 3}));
  EXPECT_EQ(named_rows(chart, 10), (std::vector<int>{0, 2, 3}));
  EXPECT_EQ(named_rows(chart, 20), (std::vector<int>{0, 1, 2, 3, 4}));
}

TEST(ChartRows, StepsStopAtTheEnds) {
  const Chart chart = chart_of({{{1, 2, 3}, bars_look()}});
  EXPECT_EQ(row_after(chart, -1, RowStep::previous), 2) << "from nowhere to the last";
  EXPECT_EQ(row_after(chart, 2, RowStep::previous), 1);
  EXPECT_EQ(row_after(chart, 1, RowStep::next), 2);
  EXPECT_EQ(row_after(chart, 2, RowStep::next), 2);
  EXPECT_EQ(row_after(chart, 2, RowStep::first), 0);
  EXPECT_EQ(row_after(chart, 0, RowStep::previous), 0);
  EXPECT_EQ(row_after(chart, 0, RowStep::last), 2);
  EXPECT_EQ(row_after(chart, -1, RowStep::next), 0) << "from nowhere to the first";
  for (const auto step : {RowStep::previous, RowStep::next, RowStep::first, RowStep::last})
    EXPECT_EQ(row_after(Chart{}, -1, step), -1);
}

TEST(ChartLooks, LinesAreToldApartByDashesAndMarks) {
  const SeriesLook first = first_line_look();
  const SeriesLook second = second_line_look();
  EXPECT_FALSE(first.dashed);
  EXPECT_TRUE(second.dashed);
  EXPECT_NE(first.mark, second.mark);
  EXPECT_NE(first.mark, SeriesLook::Mark::none);
  EXPECT_NE(second.mark, SeriesLook::Mark::none);
  EXPECT_EQ(first.form, SeriesLook::Form::line);
  EXPECT_EQ(second.form, SeriesLook::Form::line);
  EXPECT_EQ(bars_look().form, SeriesLook::Form::bars);
}

TEST(ChartLooks, BarsAreFilledAndLinesHaveTheColourOfTheirMarks) {
  const auto plain = [](ColourRole role) { return Colour{role, role, 0}; };
  EXPECT_EQ(bars_look().edge, plain(ColourRole::accent));
  EXPECT_EQ(bars_look().fill, (Colour{ColourRole::surface, ColourRole::accent, 0.55}));
  EXPECT_FALSE(bars_look().dashed);
  EXPECT_EQ(bars_look().mark, SeriesLook::Mark::none);
  EXPECT_EQ(first_line_look().edge, plain(ColourRole::text));
  EXPECT_EQ(first_line_look().fill, plain(ColourRole::text));
  EXPECT_EQ(first_line_look().mark, SeriesLook::Mark::disc);
  EXPECT_EQ(second_line_look().edge, plain(ColourRole::accent));
  EXPECT_EQ(second_line_look().fill, plain(ColourRole::surface));
  EXPECT_EQ(second_line_look().mark, SeriesLook::Mark::square);
}

TEST(ChartLooks, ALineOfManyRowsHasNoMarks) {
  const auto marked = [](std::size_t rows, const SeriesLook& look) {
    const Chart chart = chart_of({{std::vector<double>(rows, 1.0), look}});
    return has_marks(chart, chart.series[0]);
  };
  EXPECT_TRUE(marked(62, first_line_look()));
  EXPECT_FALSE(marked(63, first_line_look()));
  EXPECT_FALSE(marked(3, bars_look()));
}

TEST(ChartNumbers, CountsAreWholeAndSharesArePercents) {
  for (const auto counted :
       {Quantity::reviews, Quantity::practices, Quantity::introduced, Quantity::writings})
    EXPECT_EQ(format_of(counted), (NumberFormat{0, false}));
  EXPECT_EQ(format_of(Quantity::minutes), (NumberFormat{1, false}));
  EXPECT_EQ(format_of(Quantity::recalled), (NumberFormat{0, true}));
  EXPECT_EQ(format_of(Quantity::predicted), (NumberFormat{0, true}));
  EXPECT_EQ(format_of(Quantity::speed), (NumberFormat{2, false}));
  EXPECT_EQ(format_of(Quantity::smoothness), (NumberFormat{2, false}));
}

}  // namespace
}  // namespace nazori::practice
