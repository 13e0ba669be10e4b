// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPointer>

#include "feedback_line.h"
#include "nazori/practice/learner_exchange.h"

class QProgressDialog;

namespace nazori::ui {

/// Shows how far an exchange is, with a way to stop it, and says in one sentence how it went.
/// Thread: interface.
class ExchangeProgress final : public QObject {
  Q_OBJECT
 public:
  /// @param exchange  outlives this.
  /// @param window  owns this.
  ExchangeProgress(practice::LearnerExchange& exchange, QWidget* window);

 signals:
  void said(nazori::ui::Feedback kind, QString sentence);

 private:
  void begin(practice::LearnerExchange::Work work, const std::filesystem::path& file);
  void end();
  void say(const practice::ExchangeEvent& event);

  practice::LearnerExchange& exchange_;
  QWidget* window_;
  QPointer<QProgressDialog> dialog_;
};

}  // namespace nazori::ui
