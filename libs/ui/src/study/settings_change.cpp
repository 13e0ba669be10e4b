// SPDX-License-Identifier: Apache-2.0
#include "study/settings_change.h"

#include <QProgressDialog>
#include <algorithm>
#include <utility>

#include "error_text.h"
#include "nazori/study/card.h"

namespace nazori::ui {
namespace {

constexpr int kPatience_ms = 500;
constexpr std::int64_t kSoonDone = 1'000;  ///< entries

}  // namespace

bool SettingsChange::takes_long(const study::LearnerStore& store, const study::Settings& wanted) {
  return study::changes_memory(store.settings(), wanted) && store.last_entry() > kSoonDone;
}

SettingsChange::SettingsChange(Learner& learner, const study::Settings& wanted, QWidget* window)
    : QObject(window), learner_(learner) {
  dialog_ = new QProgressDialog(tr("Working out every character anew…"), tr("Stop"), 0, 100, window);
  dialog_->setObjectName(QStringLiteral("settings_progress"));
  dialog_->setWindowModality(Qt::WindowModal);
  dialog_->setMinimumDuration(kPatience_ms);
  dialog_->setAutoClose(false);
  dialog_->setAutoReset(false);
  dialog_->setValue(0);
  connect(dialog_, &QProgressDialog::canceled, this, [this] { wanted_ = false; });
  const study::Time now = learner_.store().now();
  learner_.let_go(tr("Every character of %1 is being worked out anew. Nothing is kept until that is done.")
                      .arg(learner_.profile()));
  worker_.post([this, wanted, now, file = learner_.file()] {
    // The dialog paints itself whenever it is told, so it is told of whole percents.
    const auto progress = [this, told = 0](double done, std::string_view) mutable {
      const int percent = std::clamp(static_cast<int>(100 * done), 0, 99);
      if (percent > std::exchange(told, percent)) {
        worker_.answer([this, percent] {
          if (dialog_ != nullptr && wanted_) dialog_->setValue(percent);
        });
      }
      return wanted_.load();
    };
    auto changed = [&]() -> base::Result<void> {
      auto store = study::LearnerStore::open(
          file, study::Access::write, [now] { return now; }, study::Upkeep::later);
      if (!store) return tl::unexpected(store.error());
      return store->change_settings(wanted, progress);
    }();
    worker_.answer([this, changed = std::move(changed)] {
      (void)learner_.open_again();
      if (dialog_ != nullptr) dialog_->deleteLater();
      if (changed)
        emit said(Feedback::good, tr("The study settings hold from now on."));
      else if (changed.error().code == base::Errc::cancelled)
        emit said(Feedback::hint, tr("Stopped. The study settings are as they were."));
      else
        emit said(
            Feedback::wrong,
            tr("The study settings were not kept: %1. They are as they were.").arg(reason(changed.error())));
      deleteLater();
    });
  });
}

SettingsChange::~SettingsChange() { wanted_ = false; }

}  // namespace nazori::ui
