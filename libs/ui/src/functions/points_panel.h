// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "nazori/functions/drawing.h"

class QAbstractItemDelegate;
class QLabel;
class QTableWidget;

namespace nazori::ui {

/// The summary of a plot: one sentence, and a table of its points of interest.
class PointsPanel final : public QWidget {
  Q_OBJECT
 public:
  explicit PointsPanel(QWidget* parent = nullptr);

  void show_drawing(const functions::SharedDrawing& drawing);
  void set_current(int row);
  void focus_table();

 signals:
  /// A row was clicked or entered.
  void point_chosen(int row);

 protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// Puts the coordinates beside the kind if there is space, otherwise under it.
  void fit();

  QLabel* summary_;
  QLabel* caption_;
  QTableWidget* table_;
  QLabel* empty_;
  QAbstractItemDelegate* cells_ = nullptr;
  bool fitting_ = false;
};

}  // namespace nazori::ui
