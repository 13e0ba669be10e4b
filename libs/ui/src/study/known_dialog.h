// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

#include "nazori/practice/learning_choices.h"

class QLabel;
class QPlainTextEdit;
class QPushButton;

namespace nazori::ui {

/// Asks for a text whose kanji and kana the learner knows, typed, pasted or read from a file, and shows how
/// many would be marked. Saves nothing.
class KnownDialog final : public QDialog {
  Q_OBJECT
 public:
  KnownDialog(practice::Learner& learner, QWidget* parent);
  /// To take with practice::take_plan().
  [[nodiscard]] const practice::LearningPlan& plan() const { return plan_; }

 private:
  void read_file();
  void show_found();

  practice::Learner& learner_;
  practice::LearningPlan plan_;
  QPlainTextEdit* text_;
  QLabel* found_;
  QPushButton* mark_;
};

}  // namespace nazori::ui
