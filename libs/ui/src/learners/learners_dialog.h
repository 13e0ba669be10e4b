// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

#include "feedback_line.h"
#include "nazori/practice/learner.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace nazori::ui {

/// The learners of this computer account: one is chosen, added, given another name, or removed. Nothing is
/// ever deleted: what is removed lies in the folder ".removed" beside the others.
class LearnersDialog final : public QDialog {
  Q_OBJECT
 public:
  LearnersDialog(practice::Learner& learner, QWidget* parent);

 signals:
  void said(nazori::ui::Feedback kind, QString sentence);

 private:
  void refresh();
  [[nodiscard]] QString chosen() const;
  /// The name that is typed, if it can be one and is free; says why not.
  [[nodiscard]] QString typed_name();
  void choose();
  void add();
  void rename();
  void remove();
  void show_words(const QString& sentence);

  practice::Learner& learner_;
  QListWidget* list_;
  QLineEdit* name_;
  QLabel* words_;
  QPushButton* choose_;
  QPushButton* rename_;
  QPushButton* remove_;
};

}  // namespace nazori::ui
