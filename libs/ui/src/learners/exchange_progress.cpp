// SPDX-License-Identifier: Apache-2.0
#include "learners/exchange_progress.h"

#include <QApplication>
#include <QDir>
#include <QLocale>
#include <QProgressDialog>

#include "nazori/widgets/dialogs/work_dialog.h"
#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/kanji_text.h"
#include "nazori/widgets/words/learner_words.h"

namespace nazori::ui {

using practice::ExchangeEvent;
using practice::LearnerExchange;

ExchangeProgress::ExchangeProgress(LearnerExchange& exchange, QWidget* window)
    : QObject(window), exchange_(exchange), window_(window) {
  subscribe(exchange.started, this,
            [this](LearnerExchange::Work work, const std::filesystem::path& file) { begin(work, file); });
  subscribe(exchange.progressed(), this, [this](int percent) {
    if (dialog_ != nullptr) dialog_->setValue(percent);
  });
  subscribe(exchange.finished, this, [this] { end(); });
  subscribe(exchange.announced, this, [this](const ExchangeEvent& event) { announce(event); });
}

void ExchangeProgress::begin(LearnerExchange::Work work, const std::filesystem::path& file) {
  const QString name = to_text(file.filename().string());
  const auto words = [&] {
    switch (work) {
      case LearnerExchange::Work::write:
        return tr("Exporting %1…").arg(name);
      case LearnerExchange::Work::read:
        return tr("Importing %1…").arg(name);
      case LearnerExchange::Work::back_up:
        return tr("Making a backup…");
      case LearnerExchange::Work::restore:
        return tr("Restoring the backup…");
    }
    return QString();
  };
  // Its parent is the open dialog, if there is one: otherwise that modal dialog would block its input.
  QWidget* above = QApplication::activeModalWidget();
  dialog_ = make_work_dialog(QStringLiteral("exchange_progress"), words(), tr("Stop"),
                             above != nullptr ? above : window_);
  connect(dialog_, &QProgressDialog::canceled, this, [this] { exchange_.stop(); });
}

void ExchangeProgress::end() {
  if (dialog_ != nullptr) dialog_->deleteLater();
  dialog_ = nullptr;
}

void ExchangeProgress::announce(const ExchangeEvent& event) {
  using Kind = ExchangeEvent::Kind;
  const QString name = to_text(event.file.filename().string());
  switch (event.kind) {
    case Kind::busy:
      emit announced(Feedback::advice,
                     tr("An export, import or backup is already running. Wait for it or stop it."));
      return;
    case Kind::nothing_to_back_up:
      emit announced(Feedback::advice, tr("Nothing studied yet, so there is nothing to back up."));
      return;
    case Kind::no_store:
      emit announced(Feedback::wrong, LearnerWords::sentence(event.trouble));
      return;
    case Kind::saved:
      emit announced(Feedback::good,
                     tr("Saved as %1.").arg(QDir::toNativeSeparators(to_text(event.file.string()))));
      return;
    case Kind::imported:
      emit announced(Feedback::good, tr("Imported %2 characters for %1. Now studying as %1.")
                                         .arg(to_text(event.profile), QLocale().toString(event.characters)));
      return;
    case Kind::backed_up:
      emit announced(Feedback::good, tr("Backed up as %1.").arg(name));
      return;
    case Kind::restored:
      emit announced(Feedback::good, tr("Backup restored. Your previous data was backed up."));
      return;
    case Kind::stopped:
      emit announced(Feedback::hint, tr("Stopped. Nothing was changed."));
      return;
    case Kind::exchange_failed:
      emit announced(Feedback::wrong, tr("%1: %2. Nothing was changed.").arg(name, reason(event.error)));
      return;
    case Kind::backup_failed:
      emit announced(Feedback::wrong, tr("Backup failed: %1.").arg(reason(event.error)));
      return;
    case Kind::restore_failed:
      emit announced(
          Feedback::wrong,
          tr("The backup could not be restored: %1. Nothing was changed.").arg(reason(event.error)));
      return;
  }
}

}  // namespace nazori::ui
