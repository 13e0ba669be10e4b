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
};

}  // namespace nazori::ui
