// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>
#include <QWidget>

#include "nazori/practice/writing_judge.h"
#include "nazori/writing/grade.h"

class QLabel;

namespace nazori::ui {

/// The report on a writing: mistakes, what could be better, the parts of the score, and how the pen moved.
class WritingReport final : public QWidget {
  Q_OBJECT
 public:
  explicit WritingReport(QWidget* parent);

  void show_grade(const writing::Grade& grade, const practice::PenReport& pen);
  /// "Correct. Form: ★★★★☆"; a refused writing has no stars.
  [[nodiscard]] static QString verdict(const writing::Grade& grade);
  /// "★★★★☆"; of a refused writing the verdict.
  [[nodiscard]] static QString stars(const writing::Grade& grade);
  /// The same for a screen reader, which does not count stars.
  [[nodiscard]] static QString spoken_verdict(const writing::Grade& grade);

 private:
  QLabel* add_label(const char* name, const char* role);

  QLabel* verdict_;
  QLabel* mistakes_;
  QLabel* parts_;
  QLabel* pen_;
};

}  // namespace nazori::ui
