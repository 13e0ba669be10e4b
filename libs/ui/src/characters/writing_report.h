// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>
#include <QWidget>

#include "nazori/practice/writing_judge.h"
#include "nazori/writing/grade.h"

class QLabel;

namespace nazori::ui {

/// All that was found in a piece of writing, in words: what is wrong, what could be better, what the score is
/// made of, and how the pen moved.
class WritingReport final : public QWidget {
  Q_OBJECT
 public:
  explicit WritingReport(QWidget* parent);

  void show_grade(const writing::Grade& grade, const practice::PenReport& pen);

 private:
  QLabel* add_label(const char* name, const char* role);

  QLabel* points_;
  QLabel* faults_;
  QLabel* parts_;
  QLabel* pen_;
};

}  // namespace nazori::ui
