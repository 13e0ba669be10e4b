// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>

#include "nazori/practice/chart.h"
#include "nazori/widgets/charts/chart_text.h"

class QLabel;
class QStackedWidget;
class QTableWidget;
class QToolButton;

namespace nazori::ui {

class DayChart;

/// One card of the page: a heading, a sentence, a drawing, and the same numbers as a table. Thread:
/// interface.
class ChartCard : public QFrame {
  Q_OBJECT
 public:
  /// @param id  of the object names: "forecast_card", "forecast_table", ...
  ChartCard(const QString& id, QWidget* parent);

  /// @param text  the words of `chart`.
  void show_chart(const practice::Chart& chart, const ChartText& text);
  /// The words and numbers of the card.
  [[nodiscard]] const ChartText& shown() const { return text_; }
  [[nodiscard]] bool shows_numbers() const;
  void set_shows_numbers(bool numbers);
  [[nodiscard]] QString title() const { return text_.title; }
  /// Gives the focus to the drawing, or to the table.
  void focus_content();
  void refresh_appearance();

 signals:
  void copy_wanted();

 protected:
  /// Without a chart: the derived class makes the drawing.
  ChartCard(const QString& id, QWidget* drawing, QWidget* parent);
  void show_text(const ChartText& text);

 private:
  void build(const QString& id, QWidget* drawing);
  void fill_table();
  void fit_table();
  void read_row(int row);

  ChartText text_;
  QLabel* heading_;
  QLabel* summary_;
  QLabel* reading_;
  QLabel* empty_;
  QToolButton* numbers_;
  QToolButton* copy_;
  QStackedWidget* stack_;
  QTableWidget* table_;
  QWidget* drawing_ = nullptr;
  DayChart* day_chart_ = nullptr;
};

}  // namespace nazori::ui
