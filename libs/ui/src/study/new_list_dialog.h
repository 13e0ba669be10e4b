// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

#include "nazori/practice/learner.h"

class QLabel;
class QLineEdit;
class QPlainTextEdit;

namespace nazori::ui {

/// Asks for a list of the learner's own, typed or read from a file.
class NewListDialog final : public QDialog {
  Q_OBJECT
 public:
  NewListDialog(practice::Learner& learner, QWidget* parent);
  [[nodiscard]] const study::CustomList& list() const { return list_; }

 private:
  void read_file();
  void read_and_accept();

  practice::Learner& learner_;
  study::CustomList list_;
  QLineEdit* name_;
  QPlainTextEdit* text_;
  QLabel* trouble_;
};

}  // namespace nazori::ui
