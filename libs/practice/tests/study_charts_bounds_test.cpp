// SPDX-License-Identifier: Apache-2.0
// Where days become weeks and weeks become months, and what each chart sums up.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nazori/practice/study_charts.h"

namespace nazori::practice {
namespace {

using std::chrono::days;
using std::chrono::milliseconds;
using std::chrono::minutes;
using std::chrono::seconds;
using study::Day;
using study::Period;
using testing::ElementsAre;

const Day kToday = *study::parse_day("2026-03-20");

TEST(StudyChartsBounds, FaultsThatAreAsFrequentStandInTheirOwnOrder) {
  using kanji::MistakeKind;
  const study::HardStroke stroke{
      U'休',
      0,
      3,
      3,
      {{kanji::MistakeKind::reversed, 1}, {kanji::MistakeKind::order, 1}, {kanji::MistakeKind::wrong, 2}}};
  EXPECT_THAT(mistakes_by_count(stroke),
              ElementsAre(std::pair(kanji::MistakeKind::wrong, 2), std::pair(kanji::MistakeKind::order, 1),
                          std::pair(kanji::MistakeKind::reversed, 1)));
}

/// The period of a chart's rows if the first one is this many days back, today included.
Period period(ChartId chart, int day_count, Day first = {}) {
  const Day begin = kToday - days(day_count - 1);
  study::Statistics s;
  s.today = kToday;
  s.days = {{begin, 1, 0, 0, minutes(1)}, {kToday, 1, 0, 0, minutes(1)}};
  s.retention_days = {{begin, {1, 1, 0.9}}, {kToday, {1, 1, 0.9}}};
  s.motion = {{begin, 1, 109, -2}, {kToday, 1, 109, -2}};
  return build_chart(chart, s, first).period;
}

TEST(StudyChartsBounds, ASeasonIsShownByDaysAndTwoYearsByWeeks) {
  for (const auto chart : {ChartId::activity, ChartId::motion}) {
    EXPECT_EQ(period(chart, 92), Period::day);
    EXPECT_EQ(period(chart, 93), Period::week);
    EXPECT_EQ(period(chart, 800), Period::week);
    EXPECT_EQ(period(chart, 801), Period::month);
    EXPECT_EQ(period(chart, 801, kToday - days(91)), Period::day) << "less is shown";
  }
  EXPECT_EQ(period(ChartId::retention, 31), Period::day);
  EXPECT_EQ(period(ChartId::retention, 32), Period::week);
  EXPECT_EQ(period(ChartId::retention, 801), Period::month);
  EXPECT_EQ(period(ChartId::retention, 801, kToday - days(30)), Period::day);
}

TEST(StudyChartsBounds, RowsLieAsFarApartAsTheirWeeksAndMonths) {
  study::Statistics s;
  s.today = kToday;
  s.retention_days = {{*study::parse_day("2025-12-31"), {1, 1, 0.9}},
                      {*study::parse_day("2026-01-05"), {1, 1, 0.9}},
                      {*study::parse_day("2026-01-18"), {1, 1, 0.9}},
                      {kToday, {1, 1, 0.9}}};
  // Mondays: 29 December, 5 and 12 January, 16 March.
  EXPECT_THAT(build_chart(ChartId::retention, s).positions, ElementsAre(0, 1, 2, 11));
  s.retention_days[0].day = *study::parse_day("2023-12-31");
  EXPECT_THAT(build_chart(ChartId::retention, s).positions, ElementsAre(0, 25, 27));
}

TEST(StudyChartsBounds, OfReviewsToComeTheFirstOfTheFullestDaysIsNamed) {
  study::Statistics s;
  s.today = kToday;
  for (const int reviews : {2, 5, 1, 5}) s.forecast.push_back({kToday + days(s.forecast.size()), reviews});
  const Chart chart = build_chart(ChartId::forecast, s);
  const auto& summary = std::get<ForecastSummary>(chart.summary);
  EXPECT_EQ(summary.reviews, 13);
  EXPECT_EQ(summary.today, 2);
  EXPECT_EQ(summary.fullest, kToday + days(1));
  EXPECT_EQ(summary.most, 5);
  EXPECT_THAT(chart.positions, ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(chart.series[0].look.form, SeriesLook::Form::bars);
  EXPECT_EQ(chart.series[0].side, Side::left);
  EXPECT_FALSE(chart.left_range);
  s.forecast.front().reviews = 5;
  EXPECT_EQ(std::get<ForecastSummary>(build_chart(ChartId::forecast, s).summary).fullest, kToday);
}

TEST(StudyChartsBounds, MinutesHaveAnAxisOfTheirOwn) {
  study::Statistics s;
  s.today = kToday;
  s.days = {{kToday - days(1), 3, 2, 1, milliseconds(90'000)}, {kToday, 6, 0, 0, seconds(15)}};
  const Chart chart = build_chart(ChartId::activity, s);
  ASSERT_EQ(chart.series.size(), 2U);
  const Series& reviews = chart.series[0];
  const Series& time = chart.series[1];
  EXPECT_EQ(chart.columns[reviews.column].quantity, Quantity::reviews);
  EXPECT_EQ(reviews.look.form, SeriesLook::Form::bars);
  EXPECT_EQ(reviews.side, Side::left);
  EXPECT_EQ(chart.columns[time.column].quantity, Quantity::minutes);
  EXPECT_EQ(time.look, first_line_look());
  EXPECT_EQ(time.side, Side::right);
  EXPECT_THAT(chart.columns[time.column].values, ElementsAre(1.5, 0.25));
  EXPECT_THAT(chart.columns[1].values, ElementsAre(2, 0));
  EXPECT_THAT(chart.columns[2].values, ElementsAre(1, 0));
  const auto& summary = std::get<ActivitySummary>(chart.summary);
  EXPECT_EQ(summary.reviews, 9);
  EXPECT_EQ(summary.days, 2);
  EXPECT_EQ(summary.time, milliseconds(105'000));
  const auto last = std::get<ActivitySummary>(build_chart(ChartId::activity, s, kToday).summary);
  EXPECT_EQ(last.reviews, 6);
  EXPECT_EQ(last.days, 1);
  EXPECT_EQ(last.reviews_per_day, 6);
  EXPECT_EQ(last.minutes_per_day, 0.25);
}

TEST(StudyChartsBounds, RecalledIsDrawnFromTheTensBelowTheLeast) {
  study::Statistics s;
  s.today = kToday;
  s.retention_days = {{kToday - days(1), {4, 3, 0.62}}, {kToday, {2, 2, 0.92}}};
  const Chart chart = build_chart(ChartId::retention, s);
  ASSERT_TRUE(chart.left_range);
  EXPECT_EQ(*chart.left_range, (std::pair{60.0, 100.0}));
  EXPECT_EQ(value_axis(chart, Side::left)->numbers, (NumberFormat{0, true}));
  for (const Series& series : chart.series) {
    EXPECT_EQ(series.side, Side::left);
    EXPECT_EQ(series.look.form, SeriesLook::Form::line);
  }
  EXPECT_EQ(chart.columns[chart.series[0].column].quantity, Quantity::recalled);
  EXPECT_EQ(chart.columns[chart.series[1].column].quantity, Quantity::predicted);
  // (4 * 0.62 + 2 * 0.92) / 6 = 0.72
  const auto& all = std::get<RetentionSummary>(chart.summary).retention;
  EXPECT_EQ(all.reviews, 6);
  EXPECT_NEAR(all.actual(), 5.0 / 6, 1e-12);
  EXPECT_NEAR(all.predicted, 0.72, 1e-12);
  s.retention_days = {{kToday, {4, 2, 0.9}}};
  EXPECT_EQ(build_chart(ChartId::retention, s).left_range->first, 50);
}

TEST(StudyChartsBounds, OfThePenTheFirstAndTheLastAreSaid) {
  study::Statistics s;
  s.today = kToday;
  s.motion = {{kToday - days(2), 1, 109, -2.5}, {kToday - days(1), 1, 545, -9}, {kToday, 1, 218, -1.75}};
  const Chart chart = build_chart(ChartId::motion, s);
  const auto& summary = std::get<MotionSummary>(chart.summary);
  EXPECT_EQ(summary.first_speed, 1);
  EXPECT_EQ(summary.last_speed, 2);
  EXPECT_EQ(summary.first_smoothness, -2.5);
  EXPECT_EQ(summary.last_smoothness, -1.75);
  EXPECT_EQ(chart.series[0].side, Side::left);
  EXPECT_EQ(chart.series[1].side, Side::right);
}

}  // namespace
}  // namespace nazori::practice
