// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "study/session_actions.h"

class QLabel;
class QPushButton;

namespace nazori::ui {

class InkGallery;

/// Beside the tablet while a session runs: why the character comes, what went wrong with it before, earlier
/// writing beside today's, and what can be done with it. The words may scroll; the buttons are always there.
class SessionPanel final : public QWidget {
  Q_OBJECT
 public:
  SessionPanel(const StudySession& session, const SessionActions& actions, Learner& learner, QWidget* parent);

  void show_state(const std::shared_ptr<const practice::CharacterSheet>& sheet);
  /// The same again in the colours and the text size of now.
  void refresh();

 private:
  [[nodiscard]] QString why() const;
  [[nodiscard]] QString history() const;
  [[nodiscard]] QString hard_strokes() const;
  /// Why a writing that was accepted is worth less than it looks.
  [[nodiscard]] QString help_used() const;
  void show_ink();

  const StudySession& session_;
  Learner& learner_;
  std::shared_ptr<const practice::CharacterSheet> sheet_;  ///< shown last
  QLabel* kind_;
  QLabel* steps_;
  QLabel* history_;
  QLabel* faults_;
  QLabel* parts_;
  QLabel* help_;
  QLabel* note_;
  QLabel* ink_heading_;
  InkGallery* gallery_;
};

}  // namespace nazori::ui
