// SPDX-License-Identifier: Apache-2.0
#include "progress/year_view.h"

#include <QAccessible>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "nazori/widgets/charts/study_charts.h"
#include "nazori/widgets/look/palette.h"
#include "nazori/widgets/words/study_words.h"

namespace nazori::ui {
namespace {

constexpr int kMostColumns = 54;
constexpr int kRows = 7;
constexpr double kSmallest = 6;
constexpr double kLargest = 30;
constexpr double kGap = 0.12;  ///< of a square
constexpr std::array kShares{0.0, 0.28, 0.52, 0.76, 1.0};

QColor colour_of_level(practice::DayLevel level, const Colours& c) {
  if (level == practice::DayLevel::none) return blend(c.surface, c.line, 0.6);
  return blend(c.surface, c.indigo, kShares[static_cast<std::size_t>(level)]);
}

}  // namespace

YearView::YearView(QWidget* parent) : QFrame(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

void YearView::show_year(practice::YearCalendar calendar) {
  const auto before = day_ >= 0 && calendar.year == calendar_.year ? day_ : -1;
  calendar_ = std::move(calendar);
  const auto& days = calendar_.days;
  const auto today = std::find_if(days.begin(), days.end(), [](const auto& one) { return one.is_today; });
  const auto last = static_cast<int>(days.size()) - 1;
  day_ = -1;
  updateGeometry();
  set_day(before >= 0 && before <= last ? before
          : today != days.end()         ? static_cast<int>(today - days.begin())
                                        : last);
  update();
}

void YearView::set_day(int day) {
  if (calendar_.days.empty()) return;
  day = std::clamp(day, 0, static_cast<int>(calendar_.days.size()) - 1);
  if (day == day_) return;
  day_ = day;
  const QString said = words(calendar_.days[static_cast<std::size_t>(day)]);
  setToolTip(said);
  setAccessibleDescription(said);
  QAccessibleEvent event(this, QAccessible::DescriptionChanged);
  QAccessible::updateAccessibility(&event);
  emit walked(said);
  update();
}

QString YearView::words(const practice::CalendarDay& day) {
  const auto& a = day.activity;
  const QString date = StudyCharts::date(a.day);
  if (day.level == practice::DayLevel::none)
    return day.is_today ? tr("%1, today: no study yet").arg(date) : tr("%1: no study").arg(date);
  QStringList parts;
  if (a.reviews > 0) parts.append(tr("from memory %1").arg(a.reviews));
  if (a.practices > 0) parts.append(tr("practised %1").arg(a.practices));
  if (a.introduced > 0) parts.append(tr("new %1").arg(a.introduced));
  parts.append(StudyCharts::duration(a.time));
  return (day.is_today ? tr("%1, today: %2") : tr("%1: %2")).arg(date, parts.join(tr(", ")));
}

QStringList YearView::level_words() {
  const auto& from = practice::kLevelsFrom;
  QStringList all{tr("none")};
  for (std::size_t i = 0; i + 1 < from.size(); ++i)
    all.append(tr("%1 to %2", "times").arg(from[i]).arg(from[i + 1] - 1));
  all.append(tr("%1 or more", "times").arg(from.back()));
  return all;
}

double YearView::side(int width) const {
  return std::clamp(static_cast<double>(width) / kMostColumns, kSmallest, kLargest);
}

int YearView::months_height() const { return fontMetrics().lineSpacing() + 4; }

int YearView::heightForWidth(int width) const {
  return 2 * months_height() + 6 + static_cast<int>(std::ceil(side(width) * kRows));
}

QSize YearView::sizeHint() const {
  const int least = static_cast<int>(kSmallest * kMostColumns);
  return {least, heightForWidth(std::max(least, width()))};
}

QRectF YearView::square(int day) const {
  const double s = side(width());
  const double gap = s * kGap;
  return {calendar_.column(day) * s, months_height() + calendar_.row(day) * s, s - gap, s - gap};
}

void YearView::paintEvent(QPaintEvent* /*event*/) {
  const Colours& c = current_colours();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  paint_months(painter);
  for (int i = 0; i < static_cast<int>(calendar_.days.size()); ++i) {
    const auto& day = calendar_.days[static_cast<std::size_t>(i)];
    const QRectF box = square(i);
    painter.setPen(day.is_to_come ? QPen(c.line, 1) : QPen(Qt::NoPen));
    painter.setBrush(day.is_to_come ? QBrush(Qt::NoBrush) : QBrush(colour_of_level(day.level, c)));
    painter.drawRoundedRect(day.is_to_come ? box.adjusted(0.5, 0.5, -0.5, -0.5) : box, 2, 2);
    painter.setBrush(Qt::NoBrush);
    if (day.is_today) {
      painter.setPen(QPen(c.ink, 2));
      painter.drawRoundedRect(box.adjusted(1, 1, -1, -1), 2, 2);
    }
  }
  if (hasFocus() && day_ >= 0) {
    painter.setPen(QPen(c.indigo, 2));
    painter.drawRoundedRect(square(day_).adjusted(-1.5, -1.5, 1.5, 1.5), 3, 3);
  }
  paint_legend(painter);
}

void YearView::paint_months(QPainter& painter) const {
  const bool japanese = QLocale().language() == QLocale::Japanese;
  painter.setPen(current_colours().muted);
  double free_from = 0;
  for (unsigned month = 1; month <= 12; ++month) {
    const study::Day first(std::chrono::year(calendar_.year) / std::chrono::month(month) / 1);
    const study::Day begin(std::chrono::year(calendar_.year) / std::chrono::January / 1);
    const int index = static_cast<int>((first - begin).count());
    if (index >= static_cast<int>(calendar_.days.size())) return;
    const QString name = japanese
                             ? QString::number(month) + QStringLiteral("月")
                             : QLocale().standaloneMonthName(static_cast<int>(month), QLocale::ShortFormat);
    const double x = square(index).left();
    const int needed = painter.fontMetrics().horizontalAdvance(name);
    // In a narrow calendar not every month has room for its name.
    if (x < free_from || x + needed > width()) continue;
    painter.drawText(QPointF(x, painter.fontMetrics().ascent()), name);
    free_from = x + needed + painter.fontMetrics().averageCharWidth();
  }
}

void YearView::paint_legend(QPainter& painter) const {
  const Colours& c = current_colours();
  const auto names = level_words();
  const QFontMetrics metrics(font());
  const double box = metrics.ascent() * 0.8;
  const double y = months_height() + side(width()) * kRows + 6;
  double x = 0;
  for (qsizetype i = 0; i < names.size(); ++i) {
    const double needed = box + 5 + metrics.horizontalAdvance(names[i]);
    if (x + needed > width()) return;
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour_of_level(static_cast<practice::DayLevel>(i), c));
    painter.drawRoundedRect(QRectF(x, y + metrics.ascent() * 0.2, box, box), 2, 2);
    painter.setPen(c.muted);
    painter.drawText(QPointF(x + box + 5, y + metrics.ascent()), names[i]);
    x += needed + metrics.averageCharWidth() * 2;
  }
}

void YearView::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Left:
      return set_day(day_ - kRows);
    case Qt::Key_Right:
      return set_day(day_ + kRows);
    case Qt::Key_Up:
      return set_day(day_ - 1);
    case Qt::Key_Down:
      return set_day(day_ + 1);
    case Qt::Key_Home:
      return set_day(0);
    case Qt::Key_End:
      return set_day(static_cast<int>(calendar_.days.size()) - 1);
    case Qt::Key_PageUp:
      emit year_wanted(-1);
      return;
    case Qt::Key_PageDown:
      emit year_wanted(+1);
      return;
    default:
      QFrame::keyPressEvent(event);
  }
}

void YearView::go_to_point(QPointF point) {
  const double s = side(width());
  const int row = static_cast<int>(std::floor((point.y() - months_height()) / s));
  if (row < 0 || row >= kRows || point.x() < 0) return;
  const int day = static_cast<int>(point.x() / s) * kRows + row - calendar_.before_first;
  if (day >= 0 && day < static_cast<int>(calendar_.days.size())) set_day(day);
}

void YearView::mouseMoveEvent(QMouseEvent* event) { go_to_point(event->position()); }
void YearView::mousePressEvent(QMouseEvent* event) { go_to_point(event->position()); }

}  // namespace nazori::ui
