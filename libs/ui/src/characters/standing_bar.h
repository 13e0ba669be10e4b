// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "nazori/practice/character_choice.h"

class QAction;
class QLabel;
class QPushButton;

namespace nazori::ui {

/// How well the learner knows a character, when it comes again, and what can be decided about it.
class StandingBar final : public QWidget {
  Q_OBJECT
 public:
  /// @param actions  study this, know this, add to a list.
  StandingBar(const QList<QAction*>& actions, QWidget* parent);

  void show_standing(const practice::CharacterStanding& standing);
  /// "well known · comes again in 12 days · 96% likely to be remembered".
  [[nodiscard]] static QString words(const practice::CharacterStanding& standing);

 private:
  QLabel* standing_;
};

}  // namespace nazori::ui
