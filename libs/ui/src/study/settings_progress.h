// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPointer>

#include "feedback_line.h"
#include "nazori/practice/settings_change.h"

class QProgressDialog;

namespace nazori::ui {

/// Shows how far a change of the study settings is, with a way to stop it, and says in one sentence how it
/// went. Deletes itself then. Thread: interface.
class SettingsProgress final : public QObject {
  Q_OBJECT
 public:
  /// Begins the change at once.
  /// @param window  owns this and the dialog.
  SettingsProgress(practice::SettingsChange& change, const study::Settings& wanted, QWidget* window);

 signals:
  void said(nazori::ui::Feedback kind, QString sentence);

 private:
  void finish(const base::Result<void>& changed);

  QPointer<QProgressDialog> dialog_;
};

}  // namespace nazori::ui
