// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/study_charts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace nazori::practice {
namespace {

using std::chrono::days;
using std::chrono::minutes;
using study::Day;
using study::Period;
using testing::ElementsAre;

Day day(const char* text) { return *study::parse_day(text); }

/// Four days of study in three weeks, the last of them today.
study::Statistics some_statistics() {
  study::Statistics s;
  s.today = day("2026-03-20");
  s.days = {{day("2026-03-01"), 0, 6, 2, minutes(9)},
            {day("2026-03-02"), 2, 0, 0, minutes(1)},
            {day("2026-03-10"), 10, 1, 0, minutes(4)},
            {day("2026-03-20"), 7, 0, 1, minutes(3)}};
  s.retention_days = {{day("2026-03-10"), {10, 9, 0.91}}, {day("2026-03-20"), {5, 4, 0.89}}};
  for (int i = 0; i < study::kForecastDays; ++i)
    s.forecast.push_back({s.today + days(i), i % 7 == 2 ? 4 : 1});
  s.motion = {{day("2026-03-10"), 10, 109, -2.5}, {day("2026-03-20"), 7, 218, -1.75}};
  s.hard_strokes = {{U'休', 2, 4, 9, {{kanji::MistakeKind::wrong, 1}, {kanji::MistakeKind::order, 3}}}};
  return s;
}

std::vector<Quantity> quantities(const Chart& chart) {
  std::vector<Quantity> all;
  for (const Column& column : chart.columns) all.push_back(column.quantity);
  return all;
}

/// The numbers of a series.
const std::vector<double>& values(const Chart& chart, std::size_t series) {
  return chart.columns[chart.series[series].column].values;
}

TEST(StudyCharts, ForecastHasARowForEachOfThirtyDays) {
  const auto s = some_statistics();
  const Chart chart = build_chart(ChartId::forecast, s);
  ASSERT_EQ(row_count(chart), 30);
  for (std::size_t i = 0; i < 30; ++i) {
    EXPECT_EQ(values(chart, 0)[i], s.forecast[i].reviews);
    EXPECT_EQ(chart.days[i], s.forecast[i].day);
  }
  const auto& summary = std::get<ForecastSummary>(chart.summary);
  EXPECT_EQ(summary.reviews, 42);
  EXPECT_EQ(summary.today, 1);
  EXPECT_EQ(summary.fullest, day("2026-03-22"));
  EXPECT_EQ(summary.most, 4);
}

TEST(StudyCharts, ActivityCountsDaysWithoutStudyToo) {
  const Chart chart = build_chart(ChartId::activity, some_statistics());
  ASSERT_EQ(row_count(chart), 20);
  EXPECT_THAT(quantities(chart),
              ElementsAre(Quantity::reviews, Quantity::practices, Quantity::introduced, Quantity::minutes));
  EXPECT_EQ(values(chart, 0)[9], 10);
  EXPECT_EQ(values(chart, 1)[9], 4);
  EXPECT_EQ(values(chart, 0)[10], 0);
  EXPECT_EQ(chart.columns[1].values[9], 1);
  EXPECT_EQ(chart.columns[2].values[9], 0);
  EXPECT_EQ(chart.days[9], day("2026-03-10"));
  const auto& summary = std::get<ActivitySummary>(chart.summary);
  EXPECT_EQ(summary.reviews, 19);
  EXPECT_EQ(summary.time, minutes(17));
  EXPECT_EQ(summary.days, 4);
  EXPECT_EQ(summary.reviews_per_day, 4.75);
  EXPECT_EQ(summary.minutes_per_day, 4.25);
  EXPECT_EQ(row_count(build_chart(ChartId::activity, some_statistics(), day("2026-03-05"))), 11);
}

TEST(StudyCharts, ALongTimeIsAddedUpByWeekAndByMonth) {
  auto s = some_statistics();
  s.days.insert(s.days.begin(), {day("2025-11-03"), 3, 0, 0, minutes(1)});
  const Chart weeks = build_chart(ChartId::activity, s);
  EXPECT_EQ(weeks.period, Period::week);
  EXPECT_EQ(row_count(weeks), 20);  // Mondays from 3 November to 16 March
  EXPECT_EQ(weeks.positions.back(), 19);
  s.days.front().day = day("2023-06-15");
  const Chart months = build_chart(ChartId::activity, s);
  EXPECT_EQ(months.period, Period::month);
  EXPECT_EQ(row_count(months), 34);
  EXPECT_EQ(months.positions.back(), 33);
}

TEST(StudyCharts, RetentionShowsTrueBesidePredicted) {
  const Chart chart = build_chart(ChartId::retention, some_statistics());
  ASSERT_EQ(chart.series.size(), 2U);
  EXPECT_THAT(chart.positions, ElementsAre(0, 10));
  EXPECT_NEAR(values(chart, 0)[0], 90, 1e-9);
  EXPECT_NEAR(values(chart, 1)[1], 89, 1e-9);
  EXPECT_EQ(chart.left_range->first, 80);
  EXPECT_THAT(quantities(chart), ElementsAre(Quantity::reviews, Quantity::recalled, Quantity::predicted));
  EXPECT_EQ(chart.columns[0].values[1], 5);
  const auto& all = std::get<RetentionSummary>(chart.summary).retention;
  EXPECT_EQ(all.reviews, 15);
  EXPECT_NEAR(all.actual(), 13.0 / 15, 1e-12);
  EXPECT_NEAR(all.predicted, (10 * 0.91 + 5 * 0.89) / 15, 1e-12);
}

TEST(StudyCharts, ThePenIsMeasuredInCharacterWidths) {
  const Chart chart = build_chart(ChartId::motion, some_statistics());
  EXPECT_THAT(values(chart, 0), ElementsAre(1, 2));
  EXPECT_THAT(values(chart, 1), ElementsAre(-2.5, -1.75));
  EXPECT_THAT(quantities(chart), ElementsAre(Quantity::writings, Quantity::speed, Quantity::smoothness));
  EXPECT_EQ(chart.columns[0].values[0], 10);
}

TEST(StudyCharts, OfAHardStrokeTheMostFrequentFaultComesFirst) {
  EXPECT_THAT(mistakes_by_count(some_statistics().hard_strokes[0]),
              ElementsAre(std::pair(kanji::MistakeKind::order, 3), std::pair(kanji::MistakeKind::wrong, 1)));
}

TEST(StudyCharts, WithoutStudyNoneHasRows) {
  study::Statistics none;
  none.today = day("2026-03-20");
  for (const ChartKind& kind : chart_kinds()) {
    const Chart chart = kind.build(none, Day());
    EXPECT_EQ(row_count(chart), 0) << kind.name;
    EXPECT_FALSE(chart.columns.empty()) << kind.name;
    EXPECT_TRUE(chart.series.empty()) << kind.name;
    EXPECT_TRUE(std::holds_alternative<std::monostate>(chart.summary)) << kind.name;
  }
}

TEST(StudyCharts, OnlyWhatLooksBackBeginsWhereItIsAsked) {
  const Day first = day("2026-03-15");
  for (const ChartKind& kind : chart_kinds()) {
    const auto all = build_chart(kind.id, some_statistics()).days;
    const auto later = build_chart(kind.id, some_statistics(), first).days;
    EXPECT_EQ(later != all, kind.looks_back) << kind.name;
    EXPECT_TRUE(!kind.looks_back || later.front() >= first) << kind.name;
  }
}

TEST(StudyCharts, EachKindBuildsItsOwnChartWithAValueToEachRow) {
  std::set<std::string_view> names;
  std::set<ChartId> ids;
  for (const ChartKind& kind : chart_kinds()) {
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
    EXPECT_TRUE(ids.insert(kind.id).second) << kind.name;
    const Chart chart = build_chart(kind.id, some_statistics());
    EXPECT_EQ(chart.id, kind.id) << kind.name;
    EXPECT_GT(row_count(chart), 0) << kind.name;
    EXPECT_EQ(chart.days.size(), chart.positions.size()) << kind.name;
    for (const Column& column : chart.columns)
      EXPECT_EQ(column.values.size(), chart.positions.size()) << kind.name;
    for (const Series& series : chart.series) EXPECT_LT(series.column, chart.columns.size()) << kind.name;
    EXPECT_TRUE(value_axis(chart, Side::left)) << kind.name;
  }
}

}  // namespace
}  // namespace nazori::practice
