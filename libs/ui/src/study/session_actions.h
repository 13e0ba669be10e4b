// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "nazori/practice/study_session.h"
#include "nazori/widgets/controls/action_set.h"
#include "nazori/widgets/settings/preferences.h"

namespace nazori::ui {

/// The actions of a session, and those for studying the character that is shown.
class SessionActions final : public ActionSet {
  Q_OBJECT
 public:
  explicit SessionActions(QWidget* window);

  QAction *start, *go_on;
  std::array<QAction*, 4> rate;  ///< again, hard, good, easy
  QAction *undo, *postpone, *pause, *reset, *end;
  QAction *tags, *study_this, *know_this, *add_to_list, *choices, *settings;

  /// Enables the actions that are possible now.
  void show_state(const practice::StudySession& session, bool can_write);
  /// Gives Return and the other keys of `done` to `go_on` while the session can go on and no writing waits to
  /// be judged. With one key on two actions, neither would work. Also adds keys for one hand, for `hint`,
  /// `undo_stroke` and `done` too.
  void set_one_hand(OneHand hand, QAction* hint, QAction* undo_stroke, QAction* done);
  /// Whether a writing waits to be judged.
  void set_has_unjudged(bool has_unjudged);
  [[nodiscard]] bool has_unjudged() const { return has_unjudged_; }
  /// The action that has a writing judged, as set_one_hand() was given it.
  [[nodiscard]] QAction* done() const { return done_; }

 private:
  void give_keys();

  QAction* done_ = nullptr;
  QList<QKeySequence> done_keys_;
  bool has_unjudged_ = false;
  QHash<QAction*, QList<QKeySequence>> own_keys_;  ///< before the keys for one hand were added
};

}  // namespace nazori::ui
