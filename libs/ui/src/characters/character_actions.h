// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/widgets/controls/action_set.h"

namespace nazori::ui {

/// The actions of the page for characters: finding a character, and its strokes.
class CharacterActions final : public ActionSet {
  Q_OBJECT
 public:
  explicit CharacterActions(QWidget* window);

  /// Adds an action of one stage to the menu of practice. @param name, keys  as in ActionSet::make.
  QAction* add_practice(const char* name, const QString& text, const QString& tip, const char* key,
                        Icon drawing);

  QAction *find, *next_character, *previous_character, *back, *forward;
  QAction *next_stroke, *previous_stroke, *all_strokes;
  QAction *strokes, *numbers, *arrows, *snap, *clear_ink;
  QAction *draw_to_find, *find_by_parts, *find_by_radical, *tell_apart, *make_model;
  QList<QAction*> stages;  ///< in the order of stage_rows()
  QAction *play, *step_back, *step_on, *slower, *faster, *loop;
  QAction *by_groove, *by_starts, *lead_hand;
  QAction *undo_stroke, *done, *hint, *give_up, *judge_each;
  QAction *groove_hidden, *groove_shown, *groove_appears;
  QAction *more_lenient, *more_strict, *lenient, *normal, *strict;
  QAction *compare_over, *compare_beside, *show_right;
  QAction* writing_cross;
  QAction *key_pen, *pen_down, *pen_start, *pen_where;
  QAction *speak, *speaks_itself;
  QAction *voice_automatic, *voice_open_jtalk, *voice_dispatcher, *voice_espeak, *voice_file;

 private:
  void make_key_pen();
  void make_sound();

  qsizetype practice_;  ///< the group of the stages
};

}  // namespace nazori::ui
