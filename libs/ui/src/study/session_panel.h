// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QList>
#include <QWidget>

#include "study/session_actions.h"

class QLabel;
class QPushButton;
class QPushButton;

namespace nazori::ui {

class InkGallery;

/// The panel beside the tablet during a session: why the character is asked, what went wrong with it before,
/// earlier writings beside today's, and what can be done with it. The words may scroll; the buttons are
/// always visible.
class SessionPanel final : public QWidget {
  Q_OBJECT
 public:
  SessionPanel(const practice::StudySession& session, const SessionActions& actions,
               practice::Learner& learner, QWidget* parent);

  void show_state(const std::shared_ptr<const practice::CharacterSheet>& sheet);
  /// Shows the same in the current colours and text size.
  void refresh();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  /// Gives the buttons under the panel a size of text that fits it.
  void fit_buttons();
  [[nodiscard]] QString why() const;
  [[nodiscard]] QString history() const;
  [[nodiscard]] QString hard_strokes() const;
  /// Why the suggested rating of an accepted writing is lower than the learner may expect.
  [[nodiscard]] QString help_used() const;
  void show_ink();

  const practice::StudySession& session_;
  practice::Learner& learner_;
  std::shared_ptr<const practice::CharacterSheet> sheet_;  ///< shown last
  QLabel* kind_;
  QLabel* steps_;
  QLabel* history_;
  QLabel* mistakes_;
  QLabel* parts_;
  QLabel* help_;
  QLabel* note_;
  QLabel* ink_heading_;
  InkGallery* gallery_;
  QList<QPushButton*> buttons_;
};

}  // namespace nazori::ui
