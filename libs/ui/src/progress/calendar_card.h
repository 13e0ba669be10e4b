// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/study/statistics.h"
#include "nazori/widgets/charts/chart_card.h"

class QLabel;
class QToolButton;

namespace nazori::ui {

class YearView;

/// The calendar of a year: on which days how much was studied.
class CalendarCard final : public ChartCard {
  Q_OBJECT
 public:
  explicit CalendarCard(QWidget* parent = nullptr);

  /// Shows the year of today.
  void show_calendar(const study::Statistics& statistics);
  [[nodiscard]] const YearView& year() const { return *year_; }

 private:
  CalendarCard(QWidget* drawing, QWidget* parent);
  void show_year(int year);

  study::Statistics statistics_;  ///< only the days and today
  QToolButton *earlier_, *later_;
  QLabel* name_;
  YearView* year_;
};

}  // namespace nazori::ui
