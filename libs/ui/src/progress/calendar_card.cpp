// SPDX-License-Identifier: Apache-2.0
#include "progress/calendar_card.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QToolButton>
#include <QVBoxLayout>

#include "nazori/widgets/charts/study_charts.h"
#include "nazori/widgets/controls/parts.h"
#include "progress/year_view.h"

namespace nazori::ui {
namespace {

std::chrono::weekday first_weekday() {
  return std::chrono::weekday(static_cast<unsigned>(QLocale().firstDayOfWeek()) % 7);
}

}  // namespace

CalendarCard::CalendarCard(QWidget* parent) : CalendarCard(new QWidget, parent) {}

CalendarCard::CalendarCard(QWidget* drawing, QWidget* parent)
    : ChartCard(QStringLiteral("calendar"), drawing, parent),
      earlier_(named(new QToolButton(drawing), "calendar_earlier", tr("Earlier year"))),
      later_(named(new QToolButton(drawing), "calendar_later", tr("Later year"))),
      name_(text_label("calendar_year", drawing)),
      year_(named(new YearView(drawing), "calendar_days")) {
  earlier_->setText(QStringLiteral("◀"));
  earlier_->setToolTip(tr("Earlier year (Page Up)"));
  later_->setText(QStringLiteral("▶"));
  later_->setToolTip(tr("Later year (Page Down)"));
  name_->setWordWrap(false);
  auto* here = text_label("calendar_here", drawing, "muted");
  auto* years = new QHBoxLayout;
  years->addWidget(earlier_);
  years->addWidget(name_);
  years->addWidget(later_);
  years->addStretch(1);
  auto* column = new QVBoxLayout(drawing);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  column->addLayout(years);
  column->addWidget(year_);
  column->addWidget(here);
  column->addStretch(1);
  drawing->setFocusProxy(year_);
  connect(earlier_, &QToolButton::clicked, this, [this] { show_year(year_->calendar().year - 1); });
  connect(later_, &QToolButton::clicked, this, [this] { show_year(year_->calendar().year + 1); });
  connect(year_, &YearView::year_wanted, this, [this](int by) { show_year(year_->calendar().year + by); });
  connect(year_, &YearView::walked, here, &QLabel::setText);
}

void CalendarCard::show_calendar(const study::Statistics& statistics) {
  statistics_.today = statistics.today;
  statistics_.days = statistics.days;
  show_year(practice::year_of(statistics.today));
}

void CalendarCard::show_year(int year) {
  const int now = practice::year_of(statistics_.today);
  const int first = statistics_.days.empty() ? now : practice::year_of(statistics_.days.front().day);
  if (year < std::min(first, now) || year > now) return;
  const auto calendar = practice::year_calendar(statistics_, year, first_weekday());
  earlier_->setVisible(first < now);
  later_->setVisible(first < now);
  earlier_->setEnabled(year > first);
  later_->setEnabled(year < now);
  name_->setText(QString::number(year));
  ChartText text;
  text.id = QStringLiteral("calendar");
  text.title = tr("Calendar");
  text.summary = tr("Study days in %1: %2. Darker squares: written or practised more often.")
                     .arg(year)
                     .arg(calendar.study_days);
  text.numbers.head = {tr("Day"), tr("From memory"), tr("Practised"), tr("New"), tr("Time")};
  for (const auto& day : calendar.days)
    if (day.level != practice::DayLevel::none || day.is_today)
      text.numbers.rows.append({StudyCharts::date(day.activity.day), QString::number(day.activity.reviews),
                                QString::number(day.activity.practices),
                                QString::number(day.activity.introduced),
                                StudyCharts::duration(day.activity.time)});
  // A year without study is shown as a calendar, too.
  if (text.numbers.rows.isEmpty())
    text.numbers.rows.append({QString::number(year), QStringLiteral("0"), QStringLiteral("0"),
                              QStringLiteral("0"), StudyCharts::duration({})});
  year_->setAccessibleName(tr("Calendar of %1. Arrow keys: day by day and week by week. Levels: %2.")
                               .arg(year)
                               .arg(YearView::level_words().join(tr(", "))));
  show_text(text);
  year_->show_year(calendar);
}

}  // namespace nazori::ui
