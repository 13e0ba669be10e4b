// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>

#include "study/session_actions.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace nazori::ui {

/// The thin bar at the top during a session: how far it is, what was saved last and the button that undoes
/// it, and a menu with what else can be done with the character.
class SessionBar final : public QFrame {
  Q_OBJECT
 public:
  SessionBar(const practice::StudySession& session, const SessionActions& actions, QWidget* parent);

  void show_state();
  /// Stands beside the question, with nothing but the number and the buttons. @param is_short  in a low
  /// window.
  void set_short(bool is_short);

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit();

  const practice::StudySession& session_;
  QLabel* progress_;
  QProgressBar* line_;
  QLabel* time_;
  QLabel* note_;
  QPushButton* undo_;
  QToolButton* more_;
  bool is_short_ = false;
};

}  // namespace nazori::ui
