// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QList>
#include <QString>
#include <QStringList>
#include <cstdint>
#include <optional>
#include <utility>

namespace nazori::ui {

/// Numbers in words: the same as a chart shows, for a table, a screen reader and the clipboard.
struct Numbers {
  QStringList head;
  QList<QStringList> rows;

  /// A line each, parted by tabs, the head first: what a spreadsheet takes.
  [[nodiscard]] QString as_text() const;
  /// One row with its heads: "12 Nov 2026: reviews 34, minutes 11".
  [[nodiscard]] QString row_text(int row) const;
};

/// One quantity of a chart, a value to a row.
struct ChartSeries {
  enum class Form : std::uint8_t { bars, line };
  enum class Axis : std::uint8_t { left, right };

  QString name;
  Form form = Form::line;
  Axis axis = Axis::left;
  QList<double> values;
  QString unit = {};  ///< behind the numbers of its axis, as printf takes it: " %%"
};

/// Everything a chart shows, as data. Its rows follow each other in time.
struct Chart {
  QString id;  ///< never translated; also of the widgets' object names
  QString title;
  QString summary;        ///< what there is to see, in a sentence or two
  QString empty;          ///< where there are no rows: what makes some
  QList<double> places;   ///< x of each row, in periods from the first
  QStringList row_names;  ///< short dates, for the axis
  QList<ChartSeries> series;
  std::optional<std::pair<double, double>> left_range;  ///< of the left axis where it is not from 0 up
  Numbers numbers;                                      ///< a row to a row
};

}  // namespace nazori::ui
