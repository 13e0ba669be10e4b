// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

#include "nazori/practice/learner.h"
#include "nazori/widgets/words/feedback.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace nazori::ui {

/// The learners of this computer account: one can be chosen, added, renamed or removed. Nothing is ever
/// deleted: the data of a removed learner is moved to the folder ".removed" beside the others.
class LearnersDialog final : public QDialog {
  Q_OBJECT
 public:
  LearnersDialog(practice::Learner& learner, QWidget* parent);

 signals:
  void announced(nazori::ui::Feedback kind, QString sentence);

 private:
  void refresh();
  [[nodiscard]] QString chosen() const;
  /// The typed name, if it is valid and free. Otherwise shows why it is not.
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
