// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/widgets/controls/action_set.h"
#include "nazori/widgets/page/page.h"

class QActionGroup;
class QMenuBar;

namespace nazori::ui {

/// The actions of the window that exist on every page, and the menu bar with the menus of the current page.
class Actions final : public ActionSet {
  Q_OBJECT
 public:
  explicit Actions(QWidget* window);

  QAction *open, *save, *print, *check_sheets, *record, *quit;
  QAction *groove_sound, *sound_louder, *sound_softer, *slope_help;
  QAction *wood, *slate, *classic;
  QAction *theme_desktop, *theme_light, *theme_dark;
  QAction *language_desktop, *language_english, *language_japanese;
  QAction *text_larger, *text_smaller, *text_usual, *reduced_motion, *left_handed;
  QAction *left_panel, *right_panel, *menus, *full_screen;
  QAction *turn_left, *turn_right, *tilt_up, *tilt_down;
  QAction *move_left, *move_right, *move_up, *move_down;
  QAction *zoom_in, *zoom_out, *reset_view;
  QAction *keys, *about;

  /// Adds a menu entry for a page; the first has the key Alt+1.
  QAction* add_page(const Page& page);
  [[nodiscard]] const QList<QAction*>& pages() const { return pages_; }

  /// Adds a menu that exists on every page, after "File".
  void add_menu(const Group& group) { added_.append(group); }

  /// The menus of the window together with those of one page, in the order of the menu bar and of the list of
  /// keys.
  [[nodiscard]] QList<Group> groups_with(const Page& page) const;
  /// Puts the menus, panels and file actions of a page in force. @param bar  is filled again.
  void enter(const Page& page, QMenuBar* bar);

 private:
  /// A key that a page uses belongs to the page: the entries for the tablet lose it while the page is shown.
  void give_keys(const Page& page);

  Group file_;
  QList<Group> added_;
  Group tablet_;
  Group view_;
  Group go_;
  Group help_;
  QActionGroup* one_page_;
  QHash<QAction*, QList<QKeySequence>> tablet_keys_;  ///< of the entries for the tablet, all of them
  QList<QAction*> pages_;
};

}  // namespace nazori::ui
