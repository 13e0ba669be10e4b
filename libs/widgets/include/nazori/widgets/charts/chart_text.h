// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QList>
#include <QString>
#include <QStringList>

namespace nazori::ui {

/// Numbers in words: the same as a chart shows, for a table, a screen reader and the clipboard.
struct Numbers {
  QStringList head;
  QList<QStringList> rows;

  /// One line for each row, with tabs between the cells and the heads first, as spreadsheets read it.
  [[nodiscard]] QString as_text() const;
  /// One row with its heads: "12 Nov 2026: reviews 34, minutes 11".
  [[nodiscard]] QString row_text(int row) const;
};

/// The words of a chart (practice::Chart), in the language in force.
struct ChartText {
  QString id;  ///< never translated; also of the widgets' object names
  QString title;
  QString summary;           ///< what there is to see, in a sentence or two
  QString empty;             ///< shown if there are no rows: how to get some
  QStringList row_names;     ///< short dates, for the axis
  QStringList series_names;  ///< for the legend
  Numbers numbers;           ///< a row to a row
};

}  // namespace nazori::ui
