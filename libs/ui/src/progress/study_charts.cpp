// SPDX-License-Identifier: Apache-2.0
#include "progress/study_charts.h"

#include <QDate>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "kanji_text.h"
#include "nazori/geometry/point.h"

namespace nazori::ui {
namespace {

using study::Day;
using study::Period;

constexpr int kDaysAsDays = 92;
constexpr int kDaysAsWeeks = 800;
constexpr int kMonth = 31;

QDate date_of(Day day) { return QDate(1970, 1, 1).addDays(day.time_since_epoch().count()); }

bool japanese() { return QLocale().language() == QLocale::Japanese; }

QString axis_date(Day day, Period period) {
  if (period == Period::month)
    return QLocale().toString(date_of(day), japanese() ? QStringLiteral("yyyy/M") : QStringLiteral("MMM yy"));
  return QLocale().toString(date_of(day), japanese() ? QStringLiteral("M/d") : QStringLiteral("d MMM"));
}

Period period_for(Day first, Day last, int days_as_days) {
  const auto days = (last - first).count() + 1;
  if (days <= days_as_days) return Period::day;
  return days <= kDaysAsWeeks ? Period::week : Period::month;
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

QString number(double value, int decimals) { return QLocale().toString(value, 'f', decimals); }

double minutes_of(std::chrono::milliseconds time) {
  return std::chrono::duration<double, std::ratio<60>>(time).count();
}

/// Begins a chart of rows that have days: first row's place is 0.
template <class Row>
void place_rows(Chart& chart, const std::vector<Row>& rows, Period period) {
  for (const Row& row : rows) {
    chart.places.append(periods_between(period, rows.front().day, row.day));
    chart.row_names.append(axis_date(row.day, period));
  }
}

QString head_of_days(Period period) {
  switch (period) {
    case Period::day:
      return StudyCharts::tr("Day");
    case Period::week:
      return StudyCharts::tr("Week from");
    case Period::month:
      return StudyCharts::tr("Month from");
  }
  return {};
}

}  // namespace

QString StudyCharts::date(Day day) {
  return QLocale().toString(date_of(day),
                            japanese() ? QStringLiteral("yyyy年M月d日") : QStringLiteral("d MMM yyyy"));
}

QString StudyCharts::percent(double share) { return tr("%1 %").arg(number(100 * share, 0)); }

QString StudyCharts::duration(std::chrono::milliseconds time) {
  const auto minutes = std::chrono::round<std::chrono::minutes>(time).count();
  if (minutes < 60) return tr("%1 min").arg(QLocale().toString(static_cast<qlonglong>(minutes)));
  return tr("%1 h %2 min")
      .arg(QLocale().toString(static_cast<qlonglong>(minutes / 60)),
           QLocale().toString(static_cast<qlonglong>(minutes % 60)));
}

QString StudyCharts::strength(study::Strength strength) {
  switch (strength) {
    case study::Strength::unseen:
      return tr("not met");
    case study::Strength::learning:
      return tr("learning");
    case study::Strength::young:
      return tr("young");
    case study::Strength::mature:
      return tr("firm");
    case study::Strength::leech:
      return tr("set apart");
    case study::Strength::paused:
      return tr("paused");
  }
  return {};
}

QString StudyCharts::mistake(kanji::MistakeKind kind) {
  switch (kind) {
    case kanji::MistakeKind::order:
      return tr("out of turn");
    case kanji::MistakeKind::reversed:
      return tr("drawn backwards");
    case kanji::MistakeKind::missing:
      return tr("left out");
    case kanji::MistakeKind::extra:
      return tr("one too many");
    case kanji::MistakeKind::joined:
      return tr("joined with another");
    case kanji::MistakeKind::split:
      return tr("drawn in pieces");
    case kanji::MistakeKind::wrong:
      return tr("wrong shape or place");
    case kanji::MistakeKind::other:
      return tr("of another character");
    case kanji::MistakeKind::ending:
      return tr("wrong ending");
  }
  return {};
}

QString StudyCharts::mistakes(const study::HardStroke& stroke) {
  std::vector<std::pair<kanji::MistakeKind, int>> kinds(stroke.kinds.begin(), stroke.kinds.end());
  std::stable_sort(kinds.begin(), kinds.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  QStringList words;
  for (const auto& [kind, count] : kinds)
    words.append(tr("%1 (%2)", "a fault, how often").arg(mistake(kind)).arg(count));
  return words.join(QStringLiteral(", "));
}

Chart StudyCharts::forecast(const study::Statistics& statistics) {
  Chart chart;
  chart.id = QStringLiteral("forecast");
  chart.title = tr("Reviews to come");
  chart.empty = tr("Write a character from memory once, and the day it comes back stands here.");
  chart.numbers.head = {tr("Day"), tr("Reviews")};
  int all = 0;
  for (const auto& day : statistics.forecast) all += day.reviews;
  if (all == 0) return chart;
  place_rows(chart, statistics.forecast, Period::day);
  ChartSeries reviews{tr("Reviews"), ChartSeries::Form::bars, ChartSeries::Axis::left, {}};
  const study::DayForecast* most = &statistics.forecast.front();
  for (const auto& day : statistics.forecast) {
    reviews.values.append(day.reviews);
    chart.numbers.rows.append({date(day.day), QLocale().toString(day.reviews)});
    if (day.reviews > most->reviews) most = &day;
  }
  chart.series = {reviews};
  chart.summary = tr("In 30 days: %1, today: %2. Most on %3: %4.")
                      .arg(QLocale().toString(all), QLocale().toString(statistics.forecast.front().reviews),
                           date(most->day), QLocale().toString(most->reviews));
  return chart;
}

Chart StudyCharts::activity(const study::Statistics& statistics, Day first) {
  Chart chart;
  chart.id = QStringLiteral("activity");
  chart.title = tr("Reviews and minutes");
  chart.empty = tr("Nothing was written in this time. What you write stands here, day by day.");
  const Day begin = statistics.days.empty() ? statistics.today : std::max(first, statistics.days.front().day);
  const Period period = period_for(begin, statistics.today, kDaysAsDays);
  chart.numbers.head = {head_of_days(period), tr("Reviews"), tr("Practice"), tr("New"), tr("Minutes")};
  const auto rows = study::activity_by(period, statistics, first);
  if (rows.empty()) return chart;
  place_rows(chart, rows, period);
  ChartSeries reviews{tr("Reviews"), ChartSeries::Form::bars, ChartSeries::Axis::left, {}};
  ChartSeries minutes{tr("Minutes"), ChartSeries::Form::line, ChartSeries::Axis::right, {}};
  int all = 0;
  std::chrono::milliseconds time{0};
  for (const auto& row : rows) {
    reviews.values.append(row.reviews);
    minutes.values.append(minutes_of(row.time));
    all += row.reviews;
    time += row.time;
    chart.numbers.rows.append({date(row.day), QLocale().toString(row.reviews),
                               QLocale().toString(row.practices), QLocale().toString(row.introduced),
                               number(minutes_of(row.time), 1)});
  }
  chart.series = {reviews, minutes};
  const auto studied = std::count_if(statistics.days.begin(), statistics.days.end(),
                                     [first](const study::DayActivity& day) { return day.day >= first; });
  chart.summary =
      tr("Reviews: %1 in %2. Days of study: %3, each with about %4 reviews in %5 min.")
          .arg(QLocale().toString(all), duration(time), QLocale().toString(static_cast<qlonglong>(studied)),
               number(static_cast<double>(all) / static_cast<double>(studied), 0),
               number(minutes_of(time) / static_cast<double>(studied), 0));
  return chart;
}

Chart StudyCharts::retention(const study::Statistics& statistics, Day first) {
  Chart chart;
  chart.id = QStringLiteral("retention");
  chart.title = tr("Recalled, and predicted");
  chart.empty = tr("Counted once a character comes back after a day or more. Come back tomorrow.");
  const auto& days = statistics.retention_days;
  const Day begin = days.empty() ? statistics.today : std::max(first, days.front().day);
  const Period period = period_for(begin, statistics.today, kMonth);
  chart.numbers.head = {head_of_days(period), tr("Reviews"), tr("Recalled"), tr("Predicted")};
  const auto rows = study::retention_by(period, statistics, first);
  if (rows.empty()) return chart;
  place_rows(chart, rows, period);
  ChartSeries actual{tr("Recalled"), ChartSeries::Form::line, ChartSeries::Axis::left, {}};
  ChartSeries predicted{tr("Predicted"), ChartSeries::Form::line, ChartSeries::Axis::left, {}};
  study::Retention all;
  double chances = 0;
  double least = 1;
  for (const auto& row : rows) {
    const auto& one = row.retention;
    actual.values.append(100 * one.actual());
    predicted.values.append(100 * one.predicted);
    all.reviews += one.reviews;
    all.recalled += one.recalled;
    chances += one.predicted * one.reviews;
    least = std::min({least, one.actual(), one.predicted});
    chart.numbers.rows.append(
        {date(row.day), QLocale().toString(one.reviews), percent(one.actual()), percent(one.predicted)});
  }
  all.predicted = chances / all.reviews;
  actual.unit = predicted.unit = QStringLiteral(" %%");
  chart.series = {actual, predicted};
  chart.left_range = {std::floor(least * 10) * 10, 100};
  chart.summary = tr("Reviews after a day or more: %1. Recalled %2, predicted %3.")
                      .arg(QLocale().toString(all.reviews), percent(all.actual()), percent(all.predicted));
  return chart;
}

Chart StudyCharts::motion(const study::Statistics& statistics, Day first) {
  Chart chart;
  chart.id = QStringLiteral("motion");
  chart.title = tr("Speed and smoothness of the pen");
  chart.empty = tr("Shown once characters were written on the tablet, with pen, mouse or stylus.");
  const Day begin =
      statistics.motion.empty() ? statistics.today : std::max(first, statistics.motion.front().day);
  const Period period = period_for(begin, statistics.today, kDaysAsDays);
  chart.numbers.head = {head_of_days(period), tr("Writings"), tr("Speed"), tr("Smoothness")};
  const auto rows = study::motion_by(period, statistics, first);
  if (rows.empty()) return chart;
  place_rows(chart, rows, period);
  ChartSeries speed{tr("Speed"), ChartSeries::Form::line, ChartSeries::Axis::left, {}};
  ChartSeries smooth{tr("Smoothness"), ChartSeries::Form::line, ChartSeries::Axis::right, {}};
  for (const auto& row : rows) {
    const double widths = row.speed / geometry::kGlyphSide;
    speed.values.append(widths);
    smooth.values.append(row.smoothness);
    chart.numbers.rows.append(
        {date(row.day), QLocale().toString(row.writings), number(widths, 2), number(row.smoothness, 2)});
  }
  chart.series = {speed, smooth};
  chart.summary = tr("Speed %1 at first, %2 now, in character widths a second. Smoothness %3 at first, %4 "
                     "now; nearer to 0 is smoother.")
                      .arg(number(speed.values.front(), 2), number(speed.values.back(), 2),
                           number(smooth.values.front(), 2), number(smooth.values.back(), 2));
  return chart;
}

Numbers StudyCharts::hard_strokes(const study::Statistics& statistics) {
  Numbers numbers;
  numbers.head = {tr("Character"), tr("Stroke"), tr("Wrong in"), tr("Writings"), tr("How")};
  for (const auto& stroke : statistics.hard_strokes)
    numbers.rows.append({to_text(stroke.character), QLocale().toString(stroke.stroke + 1),
                         QLocale().toString(stroke.mistakes), QLocale().toString(stroke.writings),
                         mistakes(stroke)});
  return numbers;
}

}  // namespace nazori::ui
