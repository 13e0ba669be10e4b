// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QString>
#include <optional>

#include "nazori/practice/learning_choices.h"
#include "nazori/practice/placement_run.h"

namespace nazori::ui {

/// Sentences of the first start and of the test of what is known.
class StartWords {
  Q_DECLARE_TR_FUNCTIONS(nazori::ui::StartWords)
 public:
  /// "You can write about 310 of the 2,136 school kanji, up to grade 3."
  [[nodiscard]] static QString found(const practice::PlacementResult& result,
                                     std::optional<practice::LearningGoal> goal);
  /// What a question of the test asks for, in plain text.
  [[nodiscard]] static QString asked(const practice::SessionQuestion& question);
};

}  // namespace nazori::ui
