// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <vector>

#include "learners/learner_exchange.h"
#include "nazori/study/backups.h"
#include "study/learner.h"
#include "worker.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace nazori::ui {

/// The backups of the present learner, each with its day and what it holds; one can be put in place of the
/// store, and one made. They are read on a thread of their own.
class BackupsDialog final : public QDialog {
  Q_OBJECT
 public:
  BackupsDialog(Learner& learner, LearnerExchange& exchange, QWidget* parent);

 private:
  void refresh();
  void show_contents(int row, const base::Result<study::BackupContents>& contents);
  void restore();
  void show_words(const QString& sentence);

  Learner& learner_;
  LearnerExchange& exchange_;
  QTableWidget* table_;
  QLabel* words_;
  QPushButton* restore_;
  std::vector<study::Backup> backups_;
  std::vector<bool> sound_;
  std::uint64_t reading_ = 0;
  Worker worker_{QStringLiteral("backups")};  // last: stops before what it uses goes
};

}  // namespace nazori::ui
