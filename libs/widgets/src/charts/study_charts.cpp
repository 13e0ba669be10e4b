// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/charts/study_charts.h"

#include <QDate>
#include <QLocale>
#include <algorithm>
#include <array>

#include "nazori/practice/study_charts.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

using practice::ChartId;
using practice::Quantity;
using study::Day;
using study::Period;

QDate date_of(Day day) { return QDate(1970, 1, 1).addDays(day.time_since_epoch().count()); }

bool japanese() { return QLocale().language() == QLocale::Japanese; }

QString axis_date(Day day, Period period) {
  if (period == Period::month)
    return QLocale().toString(date_of(day), japanese() ? QStringLiteral("yyyy/M") : QStringLiteral("MMM yy"));
  return QLocale().toString(date_of(day), japanese() ? QStringLiteral("M/d") : QStringLiteral("d MMM"));
}

QString decimal(double value, int decimals) { return QLocale().toString(value, 'f', decimals); }

QString head_of_days(Period period) {
  switch (period) {
    case Period::day:
      return StudyCharts::tr("Day");
    case Period::week:
      return StudyCharts::tr("Week starting");
    case Period::month:
      return StudyCharts::tr("Month starting");
  }
  return {};
}

QString head_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::reviews:
      return StudyCharts::tr("Reviews");
    case Quantity::practices:
      return StudyCharts::tr("Practice");
    case Quantity::introduced:
      return StudyCharts::tr("New");
    case Quantity::minutes:
      return StudyCharts::tr("Minutes");
    case Quantity::recalled:
      return StudyCharts::tr("Recalled");
    case Quantity::predicted:
      return StudyCharts::tr("Predicted");
    case Quantity::writings:
      return StudyCharts::tr("Times written");
    case Quantity::speed:
      return StudyCharts::tr("Speed");
    case Quantity::smoothness:
      return StudyCharts::tr("Smoothness");
  }
  return {};
}

QString summary_of(const practice::ForecastSummary& s) {
  return StudyCharts::tr("Next 30 days: %1. Today: %2. Busiest day: %3 (%4).")
      .arg(QLocale().toString(s.reviews), QLocale().toString(s.today), StudyCharts::date(s.fullest),
           QLocale().toString(s.most));
}

QString summary_of(const practice::ActivitySummary& s) {
  return StudyCharts::tr("Reviews: %1 in %2. Study days: %3, with about %4 reviews in %5 min each.")
      .arg(QLocale().toString(s.reviews), StudyCharts::duration(s.time), QLocale().toString(s.days),
           decimal(s.reviews_per_day, 0), decimal(s.minutes_per_day, 0));
}

QString summary_of(const practice::RetentionSummary& s) {
  return StudyCharts::tr("Reviews after a day or more: %1. Recalled %2, predicted %3.")
      .arg(QLocale().toString(s.retention.reviews), StudyCharts::percent(s.retention.actual()),
           StudyCharts::percent(s.retention.predicted));
}

QString summary_of(const practice::MotionSummary& s) {
  return StudyCharts::tr(
             "Speed in character widths per second: %1 at first, %2 now. Smoothness: %3 at first, %4 now "
             "(closer to 0 is smoother).")
      .arg(decimal(s.first_speed, 2), decimal(s.last_speed, 2), decimal(s.first_smoothness, 2),
           decimal(s.last_smoothness, 2));
}

QString summary_of(std::monostate /*without rows*/) { return {}; }

/// The words that do not depend on the numbers of a chart; not yet translated.
struct ChartWords {
  ChartId id;
  const char* title;
  const char* empty;  ///< shown if there are no rows: how to get some
  const char* menu_text;
  const char* menu_tip;
};

constexpr std::array kWords{
    ChartWords{ChartId::forecast, QT_TRANSLATE_NOOP("nazori::ui::StudyCharts", "Upcoming reviews"),
               QT_TRANSLATE_NOOP("nazori::ui::StudyCharts",
                                 "Write a character from memory once, and its next review will appear here."),
               QT_TRANSLATE_NOOP("nazori::ui::StudyCharts", "Up&coming reviews"),
               QT_TRANSLATE_NOOP("nazori::ui::StudyCharts", "Go to the upcoming reviews")},
    ChartWords{
        ChartId::retention, QT_TRANSLATE_NOOP("nazori::ui::StudyCharts", "Recall: actual and predicted"),
        QT_TRANSLATE_NOOP("nazori::ui::StudyCharts",
                          "Starts when a character comes back after a day or more. Come back tomorrow."),
        QT_TRANSLATE_NOOP("nazori::ui::StudyCharts", "&Recall: actual and predicted"),
        QT_TRANSLATE_NOOP("nazori::ui::StudyCharts", "Go to actual and predicted recall")},
    ChartWords{ChartId::activity, QT_TRANSLATE_NOOP("nazori::ui::StudyCharts", "Reviews and minutes"),
               QT_TRANSLATE_NOOP("nazori::ui::StudyCharts",
                                 "Nothing written in this period. What you write appears here, day by day."),
               QT_TRANSLATE_NOOP("nazori::ui::StudyCharts", "Reviews and &minutes"),
               QT_TRANSLATE_NOOP("nazori::ui::StudyCharts", "Go to reviews and minutes")},
    ChartWords{ChartId::motion,
               QT_TRANSLATE_NOOP("nazori::ui::StudyCharts", "Speed and smoothness of the pen"),
               QT_TRANSLATE_NOOP("nazori::ui::StudyCharts",
                                 "Shown once you have written on the tablet with a mouse, pen or stylus."),
               QT_TRANSLATE_NOOP("nazori::ui::StudyCharts", "&Speed and smoothness"),
               QT_TRANSLATE_NOOP("nazori::ui::StudyCharts", "Go to speed and smoothness of the pen")},
};

const ChartWords& words_of(ChartId id) {
  return *std::find_if(kWords.begin(), kWords.end(), [id](const ChartWords& one) { return one.id == id; });
}

}  // namespace

QString StudyCharts::date(Day day) {
  return QLocale().toString(date_of(day),
                            japanese() ? QStringLiteral("yyyy年M月d日") : QStringLiteral("d MMM yyyy"));
}

QString StudyCharts::number(double value, practice::NumberFormat format) {
  const QString written = decimal(value, format.decimals);
  return format.percent ? tr("%1%").arg(written) : written;
}

QString StudyCharts::percent(double share) { return number(100 * share, {0, true}); }

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
      return tr("not studied");
    case study::Strength::learning:
      return tr("learning");
    case study::Strength::young:
      return tr("recently learned");
    case study::Strength::mature:
      return tr("well known");
    case study::Strength::leech:
      return tr("difficult");
    case study::Strength::paused:
      return tr("suspended");
  }
  return {};
}

QString StudyCharts::mistake(kanji::MistakeKind kind) {
  switch (kind) {
    case kanji::MistakeKind::order:
      return tr("wrong order");
    case kanji::MistakeKind::reversed:
      return tr("drawn backwards");
    case kanji::MistakeKind::missing:
      return tr("missing");
    case kanji::MistakeKind::extra:
      return tr("extra stroke");
    case kanji::MistakeKind::joined:
      return tr("joined to another stroke");
    case kanji::MistakeKind::split:
      return tr("split into pieces");
    case kanji::MistakeKind::wrong:
      return tr("wrong shape or position");
    case kanji::MistakeKind::other:
      return tr("stroke of another character");
    case kanji::MistakeKind::ending:
      return tr("wrong ending");
  }
  return {};
}

QString StudyCharts::mistakes(const study::HardStroke& stroke) {
  QStringList words;
  for (const auto& [kind, count] : practice::mistakes_by_count(stroke))
    words.append(tr("%1 (%2)", "a fault, how often").arg(mistake(kind)).arg(count));
  return words.join(QStringLiteral(", "));
}

ChartText StudyCharts::text(const practice::Chart& chart) {
  const ChartWords& words = words_of(chart.id);
  ChartText text;
  text.id = id(chart.id);
  text.title = tr(words.title);
  text.empty = tr(words.empty);
  text.summary = std::visit([](const auto& summary) { return summary_of(summary); }, chart.summary);
  text.numbers.head = {head_of_days(chart.period)};
  for (const auto& column : chart.columns) text.numbers.head.append(head_of(column.quantity));
  for (const auto& series : chart.series)
    text.series_names.append(head_of(chart.columns[series.column].quantity));
  for (std::size_t row = 0; row < chart.days.size(); ++row) {
    text.row_names.append(axis_date(chart.days[row], chart.period));
    QStringList cells{date(chart.days[row])};
    for (const auto& column : chart.columns)
      cells.append(number(column.values[row], practice::format_of(column.quantity)));
    text.numbers.rows.append(cells);
  }
  return text;
}

QString StudyCharts::id(ChartId chart) {
  const auto kinds = practice::chart_kinds();
  const auto kind =
      std::find_if(kinds.begin(), kinds.end(), [chart](const auto& one) { return one.id == chart; });
  return QString::fromUtf8(kind->name.data(), static_cast<qsizetype>(kind->name.size()));
}

QString StudyCharts::menu_text(ChartId chart) { return tr(words_of(chart).menu_text); }
QString StudyCharts::menu_tip(ChartId chart) { return tr(words_of(chart).menu_tip); }

Numbers StudyCharts::hard_strokes(const study::Statistics& statistics) {
  Numbers numbers;
  numbers.head = {tr("Character"), tr("Stroke"), tr("Times wrong"), tr("Times written"), tr("Mistakes")};
  for (const auto& stroke : statistics.hard_strokes)
    numbers.rows.append({to_text(stroke.character), QLocale().toString(stroke.stroke + 1),
                         QLocale().toString(stroke.mistakes), QLocale().toString(stroke.writings),
                         mistakes(stroke)});
  return numbers;
}

}  // namespace nazori::ui
