// SPDX-License-Identifier: Apache-2.0
#include "learners/backups_dialog.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "learners/exchange_progress.h"
#include "nazori/widgets/charts/study_charts.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

enum Column { kKind, kLast, kWritings, kCharacters, kColumns };

QString kind_of(const practice::ListedBackup& backup) {
  switch (backup.kind) {
    case practice::BackupKind::daily:
      return backup.day ? BackupsDialog::tr("Daily (%1)").arg(StudyCharts::date(*backup.day))
                        : BackupsDialog::tr("Daily");
    case practice::BackupKind::own:
      return BackupsDialog::tr("Made by you");
    case practice::BackupKind::before_restore:
      return BackupsDialog::tr("Saved before a restore");
    case practice::BackupKind::before_upgrade:
      return BackupsDialog::tr("Saved before an update");
  }
  return {};
}

}  // namespace

BackupsDialog::BackupsDialog(base::Inbox& inbox, practice::Learner& learner,
                             practice::LearnerExchange& exchange, const ExchangeProgress& progress,
                             QWidget* parent)
    : QDialog(parent),
      learner_(learner),
      exchange_(exchange),
      backups_(inbox, learner),
      table_(named(new QTableWidget(0, kColumns, this), "backups_table", tr("Backups, newest first"))),
      words_(text_label("backups_words", this)) {
  setObjectName(QStringLiteral("backups_dialog"));
  setWindowTitle(tr("Backups of %1").arg(to_text(learner.profile())));
  table_->setHorizontalHeaderLabels(
      {tr("Type"), tr("Last study day"), tr("Times written"), tr("Characters")});
  make_row_table(table_);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  auto* now = named(new QPushButton(tr("&Back up now"), this), "backup_now");
  now->setAutoDefault(false);
  restore_ = named(new QPushButton(tr("&Restore…"), this), "backup_restore");
  restore_->setAutoDefault(false);
  auto* buttons = dialog_buttons(QDialogButtonBox::Close, this);
  connect(now, &QPushButton::clicked, this, [this] { exchange_.back_up(); });
  connect(&progress, &ExchangeProgress::announced, this, [this](Feedback, const QString& sentence) {
    refresh();
    show_words(sentence);
  });
  connect(restore_, &QPushButton::clicked, this, &BackupsDialog::restore);
  connect(table_, &QTableWidget::cellActivated, this, &BackupsDialog::restore);
  connect(table_, &QTableWidget::currentCellChanged, this,
          [this](int row) { restore_->setEnabled(is_sound(row)); });
  subscribe(backups_.read, this, [this](std::size_t row) { show_contents(static_cast<int>(row)); });
  auto* row = new QHBoxLayout;
  row->addWidget(restore_);
  row->addWidget(now);
  row->addStretch(1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(20, 20, 20, 16);
  column->setSpacing(10);
  column->addWidget(table_, 1);
  column->addLayout(row);
  column->addWidget(words_);
  column->addWidget(buttons);
  const int em = fontMetrics().height();
  resize(em * 38, em * 20);
  refresh();
}

void BackupsDialog::show_words(const QString& sentence) {
  words_->setText(sentence);
  words_->setAccessibleName(sentence);
}

bool BackupsDialog::is_sound(int row) const {
  const auto& all = backups_.backups();
  return row >= 0 && row < static_cast<int>(all.size()) && all[static_cast<std::size_t>(row)].is_sound();
}

void BackupsDialog::refresh() {
  backups_.refresh();
  const auto& all = backups_.backups();
  restore_->setEnabled(false);
  table_->setRowCount(static_cast<int>(all.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    table_->setItem(row, kKind, new QTableWidgetItem(kind_of(all[static_cast<std::size_t>(row)])));
    for (int column = kLast; column < kColumns; ++column)
      table_->setItem(row, column, new QTableWidgetItem(QStringLiteral("…")));
  }
  show_words(
      all.empty()
          ? tr("No backups yet. Your data is backed up automatically on every study day.")
          : tr("One is made by itself on each day of study; seven are kept. Of what a backup replaced, the "
               "last three are kept."));
  if (!all.empty()) table_->setCurrentCell(0, 0);
}

void BackupsDialog::show_contents(int row) {
  const QLocale locale;
  if (is_sound(row)) {
    const study::BackupContents& contents = **backups_.backups()[static_cast<std::size_t>(row)].contents;
    table_->item(row, kLast)
        ->setText(contents.last_day ? StudyCharts::date(*contents.last_day) : QStringLiteral("–"));
    table_->item(row, kWritings)->setText(locale.toString(contents.writings));
    table_->item(row, kCharacters)->setText(locale.toString(contents.characters));
  } else {
    table_->item(row, kLast)->setText(tr("cannot be used"));
    table_->item(row, kWritings)->setText(QStringLiteral("–"));
    table_->item(row, kCharacters)->setText(QStringLiteral("–"));
  }
  QStringList cells;
  for (int column = 0; column < kColumns; ++column) cells.append(table_->item(row, column)->text());
  const QString words = tr("%1, last study day %2, times written: %3, characters: %4")
                            .arg(cells[kKind], cells[kLast], cells[kWritings], cells[kCharacters]);
  for (int column = 0; column < kColumns; ++column)
    table_->item(row, column)->setData(Qt::AccessibleTextRole, words);
  if (table_->currentRow() == row) restore_->setEnabled(is_sound(row));
}

void BackupsDialog::restore() {
  const int row = table_->currentRow();
  if (!is_sound(row)) return;
  const study::Backup backup = backups_.backups()[static_cast<std::size_t>(row)].backup;
  QMessageBox question(
      QMessageBox::Question, tr("Restore from a backup"),
      tr("Replace the study data of %1 with this backup? %2")
          .arg(to_text(learner_.profile()), table_->item(row, 0)->data(Qt::AccessibleTextRole).toString()),
      QMessageBox::Cancel, this);
  question.setObjectName(QStringLiteral("backup_question"));
  question.setInformativeText(tr("Your current data is backed up first, so you can undo this."));
  auto* yes = question.addButton(tr("&Restore"), QMessageBox::AcceptRole);
  yes->setObjectName(QStringLiteral("backup_yes"));
  question.setDefaultButton(QMessageBox::Cancel);
  question.exec();
  if (question.clickedButton() != yes) return;
  exchange_.restore(backup.file);
}

}  // namespace nazori::ui
