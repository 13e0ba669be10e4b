// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

#include "nazori/practice/backup_list.h"
#include "nazori/practice/learner.h"
#include "nazori/practice/learner_exchange.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace nazori::ui {

class ExchangeProgress;

/// The backups of the current learner, each with its day and its content. One can be restored, and a new one
/// made.
class BackupsDialog final : public QDialog {
  Q_OBJECT
 public:
  /// @param progress  of the exchange; its sentences are shown here, too.
  BackupsDialog(base::Inbox& inbox, practice::Learner& learner, practice::LearnerExchange& exchange,
                const ExchangeProgress& progress, QWidget* parent);

 private:
  void refresh();
  void show_contents(int row);
  [[nodiscard]] bool is_sound(int row) const;
  void restore();
  void show_words(const QString& sentence);

  practice::Learner& learner_;
  practice::LearnerExchange& exchange_;
  practice::BackupList backups_;
  QTableWidget* table_;
  QLabel* words_;
  QPushButton* restore_;
};

}  // namespace nazori::ui
