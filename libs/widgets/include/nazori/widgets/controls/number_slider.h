// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QLabel;
class QSlider;

namespace nazori::ui {

/// A slider with its name before it and its value in words after it. The screen reader sees one control.
class NumberSlider final : public QWidget {
  Q_OBJECT
 public:
  /// @param unit  "%1 N"; the number takes the place of %1. @param decimals  of the number.
  NumberSlider(const QString& name, const QString& object, double low, double high, double step,
               const QString& unit, int decimals, QWidget* parent);

  void set_range(double low, double high);
  void set_value(double value);
  [[nodiscard]] double value() const;

 signals:
  /// The learner moved the slider; set_value() does not emit it.
  void moved(double value);

 private:
  void show_value();

  QSlider* slider_;
  QLabel* words_;
  double low_, step_;
  QString unit_;
  int decimals_;
  bool silent_ = false;
};

}  // namespace nazori::ui
