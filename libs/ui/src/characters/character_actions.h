// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "action_set.h"

namespace nazori::ui {

/// What can be done with characters: finding one, and its strokes.
class CharacterActions final : public ActionSet {
  Q_OBJECT
 public:
  explicit CharacterActions(QWidget* window);

  QAction *find, *next_character, *previous_character, *back, *forward;
  QAction *next_stroke, *previous_stroke, *all_strokes;
  QAction *strokes, *numbers, *arrows, *snap, *clear_ink;
  QAction* draw_to_find;
  QAction *watch, *trace, *guided, *memory;
  QAction *play, *step_back, *step_on, *slower, *faster, *loop;
  QAction *by_groove, *by_starts, *lead_hand;
  QAction *undo_stroke, *done, *hint, *give_up, *judge_each;
  QAction *groove_hidden, *groove_shown, *groove_appears;
  QAction *more_lenient, *more_strict, *lenient, *normal, *strict;
  QAction *compare_over, *compare_beside;
};

}  // namespace nazori::ui
