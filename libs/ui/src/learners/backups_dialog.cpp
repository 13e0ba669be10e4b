// SPDX-License-Identifier: Apache-2.0
#include "learners/backups_dialog.h"

#include <QDate>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "kanji_text.h"
#include "progress/study_charts.h"

namespace nazori::ui {
namespace {

constexpr std::string_view kDaily = "daily-";

enum Column { kKind, kLast, kWritings, kCharacters, kColumns };

QString kind_of(const study::Backup& backup) {
  const std::string name = backup.file.filename().string();
  if (backup.automatic) {
    const auto day = study::parse_day(backup.file.stem().string().substr(kDaily.size()));
    return day ? BackupsDialog::tr("Of %1").arg(StudyCharts::date(*day)) : BackupsDialog::tr("Daily");
  }
  if (name.starts_with("own-")) return BackupsDialog::tr("Made by you");
  if (name.starts_with("before-restore-")) return BackupsDialog::tr("What a restored one replaced");
  return BackupsDialog::tr("Before a newer version");
}

}  // namespace

BackupsDialog::BackupsDialog(Learner& learner, LearnerExchange& exchange, QWidget* parent)
    : QDialog(parent),
      learner_(learner),
      exchange_(exchange),
      table_(new QTableWidget(0, kColumns, this)),
      words_(new QLabel(this)) {
  setObjectName(QStringLiteral("backups_dialog"));
  setWindowTitle(tr("Backups of %1").arg(learner.profile()));
  table_->setObjectName(QStringLiteral("backups_table"));
  table_->setAccessibleName(tr("Backups, the newest first"));
  table_->setHorizontalHeaderLabels({tr("Kind"), tr("Last day in it"), tr("Writings"), tr("Characters")});
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setTabKeyNavigation(false);
  table_->setShowGrid(false);
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  words_->setObjectName(QStringLiteral("backups_words"));
  words_->setWordWrap(true);
  words_->setTextFormat(Qt::PlainText);
  auto* now = new QPushButton(tr("&Back up now"), this);
  now->setObjectName(QStringLiteral("backup_now"));
  now->setAutoDefault(false);
  restore_ = new QPushButton(tr("&Put it in place…"), this);
  restore_->setObjectName(QStringLiteral("backup_restore"));
  restore_->setAutoDefault(false);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(now, &QPushButton::clicked, &exchange_, &LearnerExchange::back_up);
  connect(&exchange_, &LearnerExchange::said, this, [this](Feedback, const QString& sentence) {
    refresh();
    show_words(sentence);
  });
  connect(restore_, &QPushButton::clicked, this, &BackupsDialog::restore);
  connect(table_, &QTableWidget::cellActivated, this, &BackupsDialog::restore);
  connect(table_, &QTableWidget::currentCellChanged, this, [this](int row) {
    restore_->setEnabled(row >= 0 && row < static_cast<int>(sound_.size()) &&
                         sound_[static_cast<std::size_t>(row)]);
  });
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

void BackupsDialog::refresh() {
  backups_ = study::backups_of(learner_.file());
  sound_.assign(backups_.size(), false);
  restore_->setEnabled(false);
  table_->setRowCount(static_cast<int>(backups_.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    table_->setItem(row, kKind, new QTableWidgetItem(kind_of(backups_[static_cast<std::size_t>(row)])));
    for (int column = kLast; column < kColumns; ++column)
      table_->setItem(row, column, new QTableWidgetItem(QStringLiteral("…")));
  }
  show_words(
      backups_.empty()
          ? tr("There is no backup yet. One is made by itself on each day of study, when Nazori opens.")
          : tr("One is made by itself on each day of study; seven are kept. Of what a backup replaced, the "
               "last three are kept."));
  const std::uint64_t reading = ++reading_;
  for (std::size_t i = 0; i < backups_.size(); ++i) {
    worker_.post([this, file = backups_[i].file, row = static_cast<int>(i), reading] {
      auto contents = study::look_into(file);
      worker_.answer([this, contents = std::move(contents), row, reading] {
        if (reading == reading_) show_contents(row, contents);
      });
    });
  }
  if (!backups_.empty()) table_->setCurrentCell(0, 0);
}

void BackupsDialog::show_contents(int row, const base::Result<study::BackupContents>& contents) {
  const QLocale locale;
  if (contents) {
    sound_[static_cast<std::size_t>(row)] = true;
    table_->item(row, kLast)
        ->setText(contents->last_day ? StudyCharts::date(*contents->last_day) : QStringLiteral("–"));
    table_->item(row, kWritings)->setText(locale.toString(contents->writings));
    table_->item(row, kCharacters)->setText(locale.toString(contents->characters));
  } else {
    table_->item(row, kLast)->setText(tr("cannot be used"));
    table_->item(row, kWritings)->setText(QStringLiteral("–"));
    table_->item(row, kCharacters)->setText(QStringLiteral("–"));
  }
  QStringList cells;
  for (int column = 0; column < kColumns; ++column) cells.append(table_->item(row, column)->text());
  const QString words = tr("%1, last day %2, writings %3, characters %4")
                            .arg(cells[kKind], cells[kLast], cells[kWritings], cells[kCharacters]);
  for (int column = 0; column < kColumns; ++column)
    table_->item(row, column)->setData(Qt::AccessibleTextRole, words);
  if (table_->currentRow() == row) restore_->setEnabled(sound_[static_cast<std::size_t>(row)]);
}

void BackupsDialog::restore() {
  const int row = table_->currentRow();
  if (row < 0 || row >= static_cast<int>(backups_.size()) || !sound_[static_cast<std::size_t>(row)]) return;
  const study::Backup backup = backups_[static_cast<std::size_t>(row)];
  QMessageBox question(
      QMessageBox::Question, tr("Restore from a backup"),
      tr("Put this backup in the place of what %1 has done so far? %2")
          .arg(learner_.profile(), table_->item(row, 0)->data(Qt::AccessibleTextRole).toString()),
      QMessageBox::Cancel, this);
  question.setObjectName(QStringLiteral("backup_question"));
  question.setInformativeText(tr("What stands there now is kept as a backup, so this can be taken back."));
  auto* yes = question.addButton(tr("&Put it in place"), QMessageBox::AcceptRole);
  yes->setObjectName(QStringLiteral("backup_yes"));
  question.setDefaultButton(QMessageBox::Cancel);
  question.exec();
  if (question.clickedButton() != yes) return;
  exchange_.restore(backup.file);
}

}  // namespace nazori::ui
