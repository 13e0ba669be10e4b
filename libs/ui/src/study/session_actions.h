// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "action_set.h"
#include "nazori/practice/study_session.h"
#include "preferences.h"

namespace nazori::ui {

/// What can be done in a session, and with the character on the desk as something to be learnt.
class SessionActions final : public ActionSet {
  Q_OBJECT
 public:
  explicit SessionActions(QWidget* window);

  QAction *start, *go_on;
  std::array<QAction*, 4> rate;  ///< again, hard, good, easy
  QAction *undo, *postpone, *pause, *reset, *end;
  QAction *tags, *settings;

  /// Which of them mean something now.
  void show_state(const practice::StudySession& session, bool can_write);
  /// Return, and what else `done` has, is `go_on`'s while there is something to go on to and nothing is
  /// written that waits to be judged: two actions with one key would both be dead. Adds keys that one
  /// hand reaches while the other writes, also to `hint`, `undo_stroke` and `done`.
  void set_one_hand(OneHand hand, QAction* hint, QAction* undo_stroke, QAction* done);
  /// Whether something is written that waits to be judged.
  void set_has_unjudged(bool has_unjudged);

 private:
  void give_keys();

  QAction* done_ = nullptr;
  QList<QKeySequence> done_keys_;
  bool has_unjudged_ = false;
  QHash<QAction*, QList<QKeySequence>> own_keys_;  ///< before one hand's were added
};

}  // namespace nazori::ui
