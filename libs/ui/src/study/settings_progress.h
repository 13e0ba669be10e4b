// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPointer>

#include "nazori/practice/settings_change.h"
#include "nazori/widgets/words/feedback.h"

class QProgressDialog;

namespace nazori::ui {

/// Shows the progress of a change of the study settings with a button to stop it, announces the result in one
/// sentence, and deletes itself. Thread: interface.
class SettingsProgress final : public QObject {
  Q_OBJECT
 public:
  /// Begins the change at once.
  /// @param window  owns this and the dialog.
  SettingsProgress(practice::SettingsChange& change, const study::Settings& wanted, QWidget* window);

 signals:
  void announced(nazori::ui::Feedback kind, QString sentence);

 private:
  void finish(const base::Result<void>& changed);

  QPointer<QProgressDialog> dialog_;
};

}  // namespace nazori::ui
