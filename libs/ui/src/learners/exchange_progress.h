// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPointer>

#include "nazori/practice/learner_exchange.h"
#include "nazori/widgets/words/feedback.h"

class QProgressDialog;

namespace nazori::ui {

/// Shows the progress of an exchange with a button to stop it, and announces the result in one sentence.
/// Thread: interface.
class ExchangeProgress final : public QObject {
  Q_OBJECT
 public:
  /// @param exchange  outlives this.
  /// @param window  owns this.
  ExchangeProgress(practice::LearnerExchange& exchange, QWidget* window);

 signals:
  void announced(nazori::ui::Feedback kind, QString sentence);

 private:
  void begin(practice::LearnerExchange::Work work, const std::filesystem::path& file);
  void end();
  void announce(const practice::ExchangeEvent& event);

  practice::LearnerExchange& exchange_;
  QWidget* window_;
  QPointer<QProgressDialog> dialog_;
};

}  // namespace nazori::ui
