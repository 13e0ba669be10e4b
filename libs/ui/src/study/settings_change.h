// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPointer>
#include <atomic>

#include "nazori/study/settings.h"
#include "study/learner.h"
#include "worker.h"

class QProgressDialog;

namespace nazori::ui {

/// Settings by which every card is worked out anew, kept on a thread of its own with how far it is and a way
/// to stop: with a history of years that takes seconds. Meanwhile the learner has no store. Deletes itself
/// when it is done. Thread: interface.
class SettingsChange final : public QObject {
  Q_OBJECT
 public:
  /// Whether so much has to be worked out that the window would wait for it.
  [[nodiscard]] static bool takes_long(const study::LearnerStore& store, const study::Settings& wanted);

  /// Begins at once.
  /// @param window  owns this and the dialog.
  SettingsChange(Learner& learner, const study::Settings& wanted, QWidget* window);
  ~SettingsChange() override;

 signals:
  void said(nazori::ui::Feedback kind, QString sentence);

 private:
  Learner& learner_;
  QPointer<QProgressDialog> dialog_;
  std::atomic<bool> wanted_{true};
  Worker worker_{QStringLiteral("settings")};  // last: stops before what it uses goes
};

}  // namespace nazori::ui
