// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>
#include <array>

#include "study/session_actions.h"

class QBoxLayout;
class QGridLayout;
class QLabel;
class QProgressBar;
class QPushButton;

namespace nazori::ui {

/// Under the tablet while a session runs: how far it is, what is asked, and after the writing the four
/// ratings, each with the day it leads to.
class SessionBar final : public QFrame {
  Q_OBJECT
 public:
  SessionBar(const StudySession& session, const SessionActions& actions, const Learner& learner,
             QWidget* parent);

  /// Shows where the session is. @param sheet  of the session's character; null while it is on its way.
  void show_state(const std::shared_ptr<const practice::CharacterSheet>& sheet);
  /// The same again in the colours and the text size of now.
  void refresh();

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void show_ratings();
  void show_next();
  [[nodiscard]] QString question(const practice::CharacterSheet& sheet) const;
  void fit();

  const StudySession& session_;
  const SessionActions& actions_;
  const Learner& learner_;
  std::shared_ptr<const practice::CharacterSheet> sheet_;  ///< shown last
  QLabel* progress_;
  QProgressBar* line_;
  QWidget* task_;  ///< question and next step
  QLabel* question_;
  QPushButton* next_;
  QWidget* ratings_;
  QGridLayout* grid_;
  std::array<QPushButton*, 4> rating_;
  bool narrow_ = false;
};

}  // namespace nazori::ui
