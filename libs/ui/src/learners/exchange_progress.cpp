// SPDX-License-Identifier: Apache-2.0
#include "learners/exchange_progress.h"

#include <QApplication>
#include <QDir>
#include <QLocale>
#include <QProgressDialog>

#include "error_text.h"
#include "kanji_text.h"
#include "signals.h"
#include "study/learner_words.h"
#include "work_dialog.h"

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
  subscribe(exchange.announced, this, [this](const ExchangeEvent& event) { say(event); });
}

void ExchangeProgress::begin(LearnerExchange::Work work, const std::filesystem::path& file) {
  const QString name = to_text(file.filename().string());
  const auto words = [&] {
    switch (work) {
      case LearnerExchange::Work::write:
        return tr("Writing %1…").arg(name);
      case LearnerExchange::Work::read:
        return tr("Reading %1…").arg(name);
      case LearnerExchange::Work::back_up:
        return tr("Making a backup…");
      case LearnerExchange::Work::restore:
        return tr("Putting the backup in place…");
    }
    return QString();
  };
  // Above a dialog that is open, which would hold its input up otherwise.
  QWidget* above = QApplication::activeModalWidget();
  dialog_ = make_work_dialog(QStringLiteral("exchange_progress"), words(), tr("Stop"),
                             above != nullptr ? above : window_);
  connect(dialog_, &QProgressDialog::canceled, this, [this] { exchange_.stop(); });
}

void ExchangeProgress::end() {
  if (dialog_ != nullptr) dialog_->deleteLater();
  dialog_ = nullptr;
}

void ExchangeProgress::say(const ExchangeEvent& event) {
  using Kind = ExchangeEvent::Kind;
  const QString name = to_text(event.file.filename().string());
  switch (event.kind) {
    case Kind::busy:
      emit said(Feedback::advice, tr("Something is being written or read already. Wait for it, or stop it."));
      return;
    case Kind::nothing_to_back_up:
      emit said(Feedback::advice, tr("Nothing is studied yet: there is nothing to back up."));
      return;
    case Kind::no_store:
      emit said(Feedback::wrong, LearnerWords::sentence(event.trouble));
      return;
    case Kind::saved:
      emit said(Feedback::good,
                tr("Saved as %1.").arg(QDir::toNativeSeparators(to_text(event.file.string()))));
      return;
    case Kind::imported:
      emit said(Feedback::good, tr("Imported for %1: characters %2. %1 studies now.")
                                    .arg(to_text(event.profile), QLocale().toString(event.characters)));
      return;
    case Kind::backed_up:
      emit said(Feedback::good, tr("Backed up as %1.").arg(name));
      return;
    case Kind::restored:
      emit said(Feedback::good, tr("The backup is in place. What stood there is kept."));
      return;
    case Kind::stopped:
      emit said(Feedback::hint, tr("Stopped. Everything is as it was."));
      return;
    case Kind::exchange_failed:
      emit said(Feedback::wrong, tr("%1: %2. Everything is as it was.").arg(name, reason(event.error)));
      return;
    case Kind::backup_failed:
      emit said(Feedback::wrong, tr("No backup was made: %1.").arg(reason(event.error)));
      return;
    case Kind::restore_failed:
      emit said(Feedback::wrong,
                tr("The backup was not put in place: %1. Everything is as it was.").arg(reason(event.error)));
      return;
  }
}

}  // namespace nazori::ui
