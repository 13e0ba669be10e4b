// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>
#include <vector>

#include "nazori/practice/chart.h"
#include "nazori/widgets/charts/chart_text.h"

namespace nazori::ui {

/// Paints a chart in the colours of the palette. Left, Right, Home, End and the pointer go from row to row.
/// Thread: interface.
class DayChart final : public QFrame {
  Q_OBJECT
 public:
  explicit DayChart(QWidget* parent = nullptr);

  /// @param text  the names of its rows and series.
  void show_chart(const practice::Chart& chart, const ChartText& text);
  /// Draws again in the current colours and text size.
  void refresh_appearance() { update(); }
  [[nodiscard]] int row() const { return row_; }
  void set_row(int row);

  /// The area of bars and lines, between the axes; in the widget's own pixels.
  [[nodiscard]] QRectF plot_area() const;
  /// The rows that are named below the plot, as many as fit.
  [[nodiscard]] std::vector<int> named_rows() const;
  /// Whether the series are named below: one alone is named by the title.
  [[nodiscard]] bool has_legend() const { return chart_.series.size() > 1; }
  /// Where the mark of the row that is read is drawn; in the widget's own pixels.
  [[nodiscard]] double mark_x() const;

 signals:
  void row_changed(int row);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  [[nodiscard]] QString label(const practice::ValueAxis& axis, int tick) const;
  [[nodiscard]] double label_room(practice::Side side) const;
  [[nodiscard]] QPointF point(const practice::Series& series, const practice::ValueAxis& axis, int row) const;
  void paint_axis(QPainter& painter, practice::Side side) const;
  void paint_row_names(QPainter& painter) const;
  void paint_bars(QPainter& painter, const practice::Series& series) const;
  void paint_line(QPainter& painter, const practice::Series& series) const;
  void paint_legend(QPainter& painter) const;

  practice::Chart chart_;
  QStringList row_names_;
  QStringList series_names_;
  int row_ = -1;
};

}  // namespace nazori::ui
