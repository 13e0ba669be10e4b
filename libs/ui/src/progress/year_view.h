// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>

#include "nazori/practice/year_calendar.h"

namespace nazori::ui {

/// Paints the calendar of a year, one square a day, with the months above it and the levels below it. The
/// pointer and the arrow keys go from day to day. Thread: interface.
class YearView final : public QFrame {
  Q_OBJECT
 public:
  explicit YearView(QWidget* parent = nullptr);

  /// The day at hand stays if it is in this year; else it is today, or the last day of the year.
  void show_year(practice::YearCalendar calendar);
  [[nodiscard]] const practice::YearCalendar& calendar() const { return calendar_; }
  /// The index of the day at hand in the calendar; -1 without days.
  [[nodiscard]] int day() const { return day_; }
  void set_day(int day);
  /// The square of a day; in the widget's own pixels.
  [[nodiscard]] QRectF square(int day) const;
  /// "Sunday 22 November: 14 from memory, 9 practised, 5 new, 12 min", "Sunday 22 November: no study".
  [[nodiscard]] static QString words(const practice::CalendarDay& day);
  /// What the levels mean: "none", "1 to 9", ..., "60 or more".
  [[nodiscard]] static QStringList level_words();

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override;

 signals:
  /// Another day is at hand, with its words.
  void walked(QString words);
  /// Page Up (-1) and Page Down (+1).
  void year_wanted(int by);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  [[nodiscard]] double side(int width) const;
  [[nodiscard]] int months_height() const;
  void go_to_point(QPointF point);
  void paint_months(QPainter& painter) const;
  void paint_legend(QPainter& painter) const;

  practice::YearCalendar calendar_;
  int day_ = -1;
};

}  // namespace nazori::ui
