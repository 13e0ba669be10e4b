// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "action_set.h"
#include "workplace.h"

class QActionGroup;
class QMenuBar;

namespace nazori::ui {

/// What the window can do whatever workplace stands in it; with the menus of all.
class Actions final : public ActionSet {
  Q_OBJECT
 public:
  explicit Actions(QWidget* window);

  QAction *open, *save, *record, *quit;
  QAction *groove_sound, *sound_louder, *sound_softer, *slope_help;
  QAction *wood, *slate, *classic;
  QAction *theme_desktop, *theme_light, *theme_dark;
  QAction *language_desktop, *language_english, *language_japanese;
  QAction *text_larger, *text_smaller, *text_usual, *reduced_motion;
  QAction *left_panel, *right_panel, *full_screen;
  QAction *turn_left, *turn_right, *tilt_up, *tilt_down;
  QAction *move_left, *move_right, *move_up, *move_down;
  QAction *zoom_in, *zoom_out, *reset_view;
  QAction *keys, *about;

  /// Adds an entry for a workplace; the first is on Alt+1.
  QAction* add_workplace(const Workplace& workplace);
  [[nodiscard]] const QList<QAction*>& workplaces() const { return workplaces_; }

  /// Adds a menu that every workplace has, after "File".
  void add_menu(const Group& group) { added_.append(group); }

  /// The menus with those of one workplace among them, as they stand in the menu bar and in the list of keys.
  [[nodiscard]] QList<Group> groups_with(const Workplace& workplace) const;
  /// Puts a workplace's menus, panels and files in force. @param bar  is filled anew.
  void enter(const Workplace& workplace, QMenuBar* bar);

 private:
  /// A key that a workplace uses itself is its: the entries for the tablet are without it meanwhile.
  void give_keys(const Workplace& workplace);

  Group file_;
  QList<Group> added_;
  Group tablet_;
  Group view_;
  Group go_;
  Group help_;
  QActionGroup* one_workplace_;
  QHash<QAction*, QList<QKeySequence>> tablet_keys_;  ///< as they are where no workplace takes one
  QList<QAction*> workplaces_;
};

}  // namespace nazori::ui
