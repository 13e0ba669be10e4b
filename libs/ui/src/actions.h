// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAction>
#include <QActionGroup>
#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QString>

class QMenu;
class QMenuBar;

namespace nazori::ui {

/// Everything the window can do, with its words and its keys. Menus, the toolbar and the list of keys are all
/// made from these, so none can be missing in one of them.
class Actions final : public QObject {
  Q_OBJECT
 public:
  explicit Actions(QWidget* window);

  QAction *open, *save, *quit;
  QAction *find, *next_character, *previous_character, *back, *forward;
  QAction *next_stroke, *previous_stroke, *all_strokes;
  QAction *strokes, *numbers, *arrows, *snap, *clear_ink;
  QAction *wood, *slate, *classic;
  QAction *theme_desktop, *theme_light, *theme_dark;
  QAction *language_desktop, *language_english, *language_japanese;
  QAction *text_larger, *text_smaller, *text_usual, *reduced_motion;
  QAction *library, *information, *full_screen;
  QAction *turn_left, *turn_right, *tilt_up, *tilt_down;
  QAction *move_left, *move_right, *move_up, *move_down;
  QAction *zoom_in, *zoom_out, *reset_view;
  QAction *keys, *about;

  /// A named group of actions, as in the menu bar.
  struct Group {
    QString title;
    QList<QAction*> actions;  ///< nullptr: a separator
  };
  [[nodiscard]] const QList<Group>& groups() const { return groups_; }

  /// Fills the menu bar.
  void add_menus(QMenuBar* bar) const;
  /// Draws the icons again in the colours of the window's palette.
  void draw_icons();

 private:
  QAction* make(const char* name, const QString& text, const QString& tip, const QList<QKeySequence>& keys,
                bool checkable = false);

  QWidget* window_;
  QList<Group> groups_;
};

}  // namespace nazori::ui
