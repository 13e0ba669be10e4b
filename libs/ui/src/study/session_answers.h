// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>
#include <array>

#include "study/session_actions.h"

class QFontMetrics;
class QGridLayout;
class QPushButton;

namespace nazori::ui {

/// The row under the tablet during a session: while the learner writes, what helps and the next step; after
/// it, the four ratings, each with the time of the next review. The next step is the only indigo button.
class SessionAnswers final : public QFrame {
  Q_OBJECT
 public:
  /// @param help  actions that help while a character is written from memory.
  SessionAnswers(const practice::StudySession& session, const SessionActions& actions,
                 const practice::Learner& learner, const QList<QAction*>& help, QWidget* parent);

  void show_state();
  /// The next step is on the side of the hand that writes.
  void set_left_handed(bool left);

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void show_ratings(const QFontMetrics& metrics);
  void show_next(const QFontMetrics& metrics);

  const practice::StudySession& session_;
  const SessionActions& actions_;
  const practice::Learner& learner_;
  QWidget* task_;  ///< help and the next step
  QList<QAction*> help_actions_;
  QList<QPushButton*> help_;  ///< in the same order
  QPushButton* next_;
  QWidget* ratings_;
  QGridLayout* grid_;
  std::array<QPushButton*, 4> rating_;
};

}  // namespace nazori::ui
