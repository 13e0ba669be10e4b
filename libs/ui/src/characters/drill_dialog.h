// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <vector>

#include "nazori/practice/confusables.h"

class QLabel;
class QPushButton;

namespace nazori::ui {

/// Asks which of some confusable characters is meant, until each was told apart.
class DrillDialog final : public QDialog {
  Q_OBJECT
 public:
  DrillDialog(const std::vector<practice::ConfusableFacts>& characters, unsigned seed, QWidget* parent);
  /// The learner wants to write the characters next.
  [[nodiscard]] bool wants_to_write() const { return wants_to_write_; }

 private:
  void ask();
  void answer(char32_t character);

  practice::ConfusableDrill drill_;
  QLabel* progress_;
  QLabel* word_;
  QLabel* meaning_;
  QLabel* verdict_;
  QList<QPushButton*> choices_;
  QPushButton* write_;
  bool wants_to_write_ = false;
};

}  // namespace nazori::ui
