// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QString>
#include <optional>

#include "nazori/practice/session_feedback.h"
#include "nazori/widgets/words/feedback.h"

namespace nazori::ui {

/// Sentences for what a study session announces.
class SessionWords {
  Q_DECLARE_TR_FUNCTIONS(nazori::ui::SessionWords)
 public:
  [[nodiscard]] static Feedback kind(const practice::SessionFeedback& feedback);
  [[nodiscard]] static QString sentence(const practice::SessionFeedback& feedback);
  /// Empty where there is none.
  [[nodiscard]] static QString sentence(const std::optional<practice::SessionFeedback>& feedback);

 private:
  [[nodiscard]] static QString undone(const practice::SessionFeedback& feedback);
};

}  // namespace nazori::ui
