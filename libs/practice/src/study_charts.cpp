// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/study_charts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "nazori/geometry/point.h"

namespace nazori::practice {
namespace {

using study::Day;
using study::Period;
using study::Statistics;

constexpr int kDaysAsDays = 92;
constexpr int kDaysAsWeeks = 800;
constexpr int kMonth = 31;

Period period_for(Day first, Day last, int days_as_days) {
  const auto days = (last - first).count() + 1;
  if (days <= days_as_days) return Period::day;
  return days <= kDaysAsWeeks ? Period::week : Period::month;
}

/// The period of a chart whose rows begin at `first`, or later where study began later.
template <class Row>
Period period_of(const std::vector<Row>& days, const Statistics& statistics, Day first, int days_as_days) {
  const Day begin = days.empty() ? statistics.today : std::max(first, days.front().day);
  return period_for(begin, statistics.today, days_as_days);
}

/// Periods from one to another.
double periods_between(Period period, Day from, Day to) {
  switch (period) {
    case Period::day:
      return static_cast<double>((to - from).count());
    case Period::week:
      return static_cast<double>((study::begin_of(period, to) - study::begin_of(period, from)).count()) / 7;
    case Period::month: {
      const std::chrono::year_month_day a(from);
      const std::chrono::year_month_day b(to);
      return static_cast<double>(((b.year() / b.month()) - (a.year() / a.month())).count());
    }
  }
  return 0;
}

double minutes_of(std::chrono::milliseconds time) {
  return std::chrono::duration<double, std::ratio<60>>(time).count();
}

Chart begin_chart(ChartId id, Period period, std::initializer_list<Quantity> columns) {
  Chart chart;
  chart.id = id;
  chart.period = period;
  for (const auto quantity : columns) chart.columns.push_back({quantity, {}});
  return chart;
}

/// @param values  one value per column.
void add_row(Chart& chart, Day day, std::initializer_list<double> values) {
  chart.positions.push_back(chart.days.empty() ? 0 : periods_between(chart.period, chart.days.front(), day));
  chart.days.push_back(day);
  auto column = chart.columns.begin();
  for (const double value : values) (column++)->values.push_back(value);
}

Chart forecast(const Statistics& statistics, Day /*first*/) {
  Chart chart = begin_chart(ChartId::forecast, Period::day, {Quantity::reviews});
  ForecastSummary summary;
  for (const auto& day : statistics.forecast) summary.reviews += day.reviews;
  if (summary.reviews == 0) return chart;
  summary.today = statistics.forecast.front().reviews;
  for (const auto& day : statistics.forecast) {
    add_row(chart, day.day, {static_cast<double>(day.reviews)});
    if (day.reviews <= summary.most) continue;
    summary.fullest = day.day;
    summary.most = day.reviews;
  }
  chart.series = {{0, bars_look(), Side::left}};
  chart.summary = summary;
  return chart;
}

Chart retention(const Statistics& statistics, Day first) {
  const Period period = period_of(statistics.retention_days, statistics, first, kMonth);
  Chart chart =
      begin_chart(ChartId::retention, period, {Quantity::reviews, Quantity::recalled, Quantity::predicted});
  const auto rows = study::retention_by(period, statistics, first);
  if (rows.empty()) return chart;
  study::Retention all;
  double chances = 0;
  double least = 1;
  for (const auto& row : rows) {
    const auto& one = row.retention;
    add_row(chart, row.day, {static_cast<double>(one.reviews), 100 * one.actual(), 100 * one.predicted});
    all.reviews += one.reviews;
    all.recalled += one.recalled;
    chances += one.predicted * one.reviews;
    least = std::min({least, one.actual(), one.predicted});
  }
  all.predicted = chances / all.reviews;
  chart.series = {{1, first_line_look(), Side::left}, {2, second_line_look(), Side::left}};
  chart.left_range = {std::floor(least * 10) * 10, 100};
  chart.summary = RetentionSummary{all};
  return chart;
}

Chart activity(const Statistics& statistics, Day first) {
  const Period period = period_of(statistics.days, statistics, first, kDaysAsDays);
  Chart chart =
      begin_chart(ChartId::activity, period,
                  {Quantity::reviews, Quantity::practices, Quantity::introduced, Quantity::minutes});
  const auto rows = study::activity_by(period, statistics, first);
  if (rows.empty()) return chart;
  ActivitySummary summary;
  for (const auto& row : rows) {
    add_row(chart, row.day,
            {static_cast<double>(row.reviews), static_cast<double>(row.practices),
             static_cast<double>(row.introduced), minutes_of(row.time)});
    summary.reviews += row.reviews;
    summary.time += row.time;
  }
  summary.days =
      static_cast<int>(std::count_if(statistics.days.begin(), statistics.days.end(),
                                     [first](const study::DayActivity& day) { return day.day >= first; }));
  summary.reviews_per_day = static_cast<double>(summary.reviews) / summary.days;
  summary.minutes_per_day = minutes_of(summary.time) / summary.days;
  chart.series = {{0, bars_look(), Side::left}, {3, first_line_look(), Side::right}};
  chart.summary = summary;
  return chart;
}

Chart motion(const Statistics& statistics, Day first) {
  const Period period = period_of(statistics.motion, statistics, first, kDaysAsDays);
  Chart chart =
      begin_chart(ChartId::motion, period, {Quantity::writings, Quantity::speed, Quantity::smoothness});
  const auto rows = study::motion_by(period, statistics, first);
  if (rows.empty()) return chart;
  for (const auto& row : rows)
    add_row(chart, row.day,
            {static_cast<double>(row.writings), row.speed / geometry::kGlyphSide, row.smoothness});
  chart.series = {{1, first_line_look(), Side::left}, {2, second_line_look(), Side::right}};
  const auto& speed = chart.columns[1].values;
  const auto& smoothness = chart.columns[2].values;
  chart.summary = MotionSummary{speed.front(), speed.back(), smoothness.front(), smoothness.back()};
  return chart;
}

constexpr std::array kKinds{
    ChartKind{ChartId::forecast, "forecast", false, forecast},
    ChartKind{ChartId::retention, "retention", true, retention},
    ChartKind{ChartId::activity, "activity", true, activity},
    ChartKind{ChartId::motion, "motion", true, motion},
};

}  // namespace

NumberFormat format_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::reviews:
    case Quantity::practices:
    case Quantity::introduced:
    case Quantity::writings:
      return {0, false};
    case Quantity::minutes:
      return {1, false};
    case Quantity::recalled:
    case Quantity::predicted:
      return {0, true};
    case Quantity::speed:
    case Quantity::smoothness:
      return {2, false};
  }
  return {};
}

std::span<const ChartKind> chart_kinds() { return kKinds; }

Chart build_chart(ChartId id, const Statistics& statistics, Day first) {
  const auto* kind =
      std::find_if(kKinds.begin(), kKinds.end(), [id](const ChartKind& one) { return one.id == id; });
  return kind == kKinds.end() ? Chart{} : kind->build(statistics, first);
}

std::vector<std::pair<kanji::MistakeKind, int>> mistakes_by_count(const study::HardStroke& stroke) {
  std::vector<std::pair<kanji::MistakeKind, int>> kinds(stroke.kinds.begin(), stroke.kinds.end());
  std::stable_sort(kinds.begin(), kinds.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  return kinds;
}

}  // namespace nazori::practice
