// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <vector>

#include "nazori/functions/plot.h"

class QLabel;
class QSlider;

namespace nazori::ui {

/// A slider for each parameter of the expression ("a = 2; 0 <= a <= 3"). Hidden while there is none.
class ParameterSliders final : public QWidget {
  Q_OBJECT
 public:
  explicit ParameterSliders(QWidget* parent = nullptr);

  /// Shows these parameters. A slider whose letter and range stay is kept, so that it can be dragged on.
  void show_parameters(const std::vector<functions::Parameter>& parameters);

  /// From top to bottom, for the order of Tab.
  [[nodiscard]] std::vector<QWidget*> sliders() const;

 signals:
  /// The learner has moved a slider; show_parameters() does not emit it.
  void moved(QString letter, double value);
  /// There are other sliders than before.
  void rebuilt();

 private:
  struct Row {
    functions::Parameter parameter;
    QWidget* line;
    QLabel* words;
    QSlider* slider;
  };

  void rebuild(const std::vector<functions::Parameter>& parameters);
  static void show_value(const Row& row, double value);

  std::vector<Row> rows_;
};

}  // namespace nazori::ui
