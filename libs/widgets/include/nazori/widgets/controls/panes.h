// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QList>
#include <QSplitter>

class QAction;

namespace nazori::ui {

/// A panel, the tablet, a panel side by side. The tablet always has at least half of the width; where that
/// leaves too little for both panels they become drawers, of which one at a time is open.
class Panes final : public QSplitter {
  Q_OBJECT
 public:
  /// In narrower windows the panels are drawers.
  static constexpr int kDrawers_px = 1000;

  Panes(QWidget* tablet, QWidget* parent);

  /// Sets the panels beside the tablet; nullptr: none. The previous panels are hidden.
  void set_panels(QWidget* left, QWidget* right);

  void set_open(bool left, bool right);
  void open_left(bool open);
  void open_right(bool open);
  /// Gives the keyboard to the panel of that side, if it is shown: to what had it there last, else to its
  /// first control.
  void give_keyboard_left();
  void give_keyboard_right();
  [[nodiscard]] bool are_drawers() const { return drawers_; }
  /// The panel that is shown; nullptr: none, or folded away.
  [[nodiscard]] QWidget* shown_left() const;
  [[nodiscard]] QWidget* shown_right() const;
  /// Closes the open drawer.
  void close_drawers();
  /// Whether each panel is open when there is space for both. This is what the settings store.
  [[nodiscard]] bool left_wanted() const { return left_wanted_; }
  [[nodiscard]] bool right_wanted() const { return right_wanted_; }
  /// Shows only the tablet.
  void set_alone(bool alone);
  /// Folds panels away for as long as the page needs their room; afterwards they are as they were. The
  /// learner can still open a folded one for a moment.
  void fold(bool left, bool right);

  /// The panels change sides, for learners who write with the left hand.
  void set_mirrored(bool mirrored);

  /// The widths that the learner chose for the panels. Without them the panels are as wide as possible.
  void wish(int left_width, int right_width);
  [[nodiscard]] int left_wish() const { return left_wish_; }
  [[nodiscard]] int right_wish() const { return right_wish_; }

  /// For a window of this width, in text of this size.
  void fit(int window_width, int text_pt);

 signals:
  void opened(bool left, bool right);
  /// A panel with the keyboard is about to be hidden. Without an answer Qt gives the keyboard to whatever
  /// comes next, which may be in the rail.
  void keyboard_closing();

 private:
  void show_panels(bool left, bool right);
  /// Shows the panels that the learner wants and that have room.
  void show_wanted();

  QWidget* left_;  ///< holds the panels of all pages, one of them shown
  QWidget* right_;
  QWidget* left_panel_ = nullptr;
  QWidget* right_panel_ = nullptr;
  int left_wish_ = QWIDGETSIZE_MAX;
  int right_wish_ = QWIDGETSIZE_MAX;
  bool drawers_ = false;
  bool alone_ = false;
  bool left_folded_ = false;
  bool right_folded_ = false;
  bool mirrored_ = false;
  bool left_wanted_ = true;
  bool right_wanted_ = true;
};

}  // namespace nazori::ui
