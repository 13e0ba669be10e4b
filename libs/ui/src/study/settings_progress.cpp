// SPDX-License-Identifier: Apache-2.0
#include "study/settings_progress.h"

#include <QProgressDialog>

#include "nazori/widgets/dialogs/work_dialog.h"
#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/words/error_text.h"

namespace nazori::ui {

SettingsProgress::SettingsProgress(practice::SettingsChange& change, const study::Settings& wanted,
                                   QWidget* window)
    : QObject(window) {
  dialog_ = make_work_dialog(QStringLiteral("settings_progress"), tr("Working out every character anew…"),
                             tr("Stop"), window);
  connect(dialog_, &QProgressDialog::canceled, this, [&change] { change.stop(); });
  subscribe(change.progressed(), this, [this](int percent) {
    if (dialog_ != nullptr) dialog_->setValue(percent);
  });
  subscribe(change.finished, this, [this](const base::Result<void>& changed) { finish(changed); });
  change.start(wanted);
}

void SettingsProgress::finish(const base::Result<void>& changed) {
  if (dialog_ != nullptr) dialog_->deleteLater();
  if (changed)
    emit announced(Feedback::good, tr("Settings saved."));
  else if (changed.error().code == base::Errc::cancelled)
    emit announced(Feedback::hint, tr("Stopped. The study settings are as they were."));
  else
    emit announced(
        Feedback::wrong,
        tr("The study settings were not kept: %1. They are as they were.").arg(reason(changed.error())));
  deleteLater();
}

}  // namespace nazori::ui
