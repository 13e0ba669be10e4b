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

/// The bar under the tablet during a session: the progress, the question, and after the writing the four
/// ratings, each with the day of the next review.
class SessionBar final : public QFrame {
  Q_OBJECT
 public:
  SessionBar(const practice::StudySession& session, const SessionActions& actions,
             const practice::Learner& learner, QWidget* parent);

  /// Shows the state of the session. @param sheet  of the session's character; null while it is loading.
  void show_state(const std::shared_ptr<const practice::CharacterSheet>& sheet);
  /// Shows the same in the current colours and text size.
  void refresh();

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void show_ratings();
  void show_next();
  [[nodiscard]] QString question(const practice::CharacterSheet& sheet) const;
  void fit();

  const practice::StudySession& session_;
  const SessionActions& actions_;
  const practice::Learner& learner_;
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
