// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QChartView>

#include "progress/chart.h"

class QCategoryAxis;
class QGraphicsLineItem;

namespace nazori::ui {

/// Draws a chart by Qt Charts, in the colours of the desk. What a series is told apart by is its form, its
/// dashes and its marks; its colour only adds to that. Left, Right, Home, End and the pointer go from row to
/// row.
class DayChart final : public QChartView {
  Q_OBJECT
 public:
  explicit DayChart(QWidget* parent = nullptr);

  void show_chart(const Chart& chart);
  /// Draws it again in the colours and the text size in force.
  void take_appearance() { draw(); }
  [[nodiscard]] int row() const { return row_; }
  void set_row(int row);

 signals:
  void row_changed(int row);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  void draw();
  void add_bars(QChart& chart, const ChartSeries& series);
  void add_line(QChart& chart, const ChartSeries& series, bool second);
  void label_days();
  void mark_row();

  Chart chart_;
  QCategoryAxis* days_ = nullptr;
  QGraphicsLineItem* mark_ = nullptr;
  int row_ = -1;
};

}  // namespace nazori::ui
