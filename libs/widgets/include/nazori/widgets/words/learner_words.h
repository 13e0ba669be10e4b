// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QString>
#include <optional>

#include "nazori/practice/learner_event.h"
#include "nazori/widgets/words/feedback.h"

namespace nazori::ui {

/// Sentences for what happens to a learner's study data.
class LearnerWords {
  Q_DECLARE_TR_FUNCTIONS(nazori::ui::LearnerWords)
 public:
  [[nodiscard]] static Feedback kind(const practice::LearnerEvent& event);
  [[nodiscard]] static QString sentence(const practice::LearnerEvent& event);
  /// Empty where there is none.
  [[nodiscard]] static QString sentence(const std::optional<practice::LearnerEvent>& event);

 private:
  [[nodiscard]] static QString cause(const practice::LearnerEvent& event);
};

}  // namespace nazori::ui
