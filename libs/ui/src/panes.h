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
  /// Narrower windows have drawers.
  static constexpr int kDrawers_px = 1000;

  Panes(QWidget* tablet, QWidget* parent);

  /// The panels that stand beside the tablet from now on, either may be none; those before stay hidden.
  void set_panels(QWidget* left, QWidget* right);

  void set_open(bool left, bool right);
  void open_left(bool open);
  void open_right(bool open);
  [[nodiscard]] bool are_drawers() const { return drawers_; }
  /// The panel that is shown; nullptr: none, or folded away.
  [[nodiscard]] QWidget* shown_left() const;
  [[nodiscard]] QWidget* shown_right() const;
  /// Closes what lies open as a drawer.
  void close_drawers();
  /// Whether each is open where there is room for both: what is worth remembering.
  [[nodiscard]] bool left_wanted() const { return left_wanted_; }
  [[nodiscard]] bool right_wanted() const { return right_wanted_; }
  /// Only the tablet.
  void set_alone(bool alone);

  /// The left panel stands on the right and the right one on the left, for a left hand at the tablet.
  void set_mirrored(bool mirrored);

  /// How wide the learner would have the panels; without a wish they are as wide as may be.
  void wish(int left_width, int right_width);
  [[nodiscard]] int left_wish() const { return left_wish_; }
  [[nodiscard]] int right_wish() const { return right_wish_; }

  /// For a window of this width, in text of this size.
  void fit(int window_width, int text_pt);

 signals:
  void opened(bool left, bool right);

 private:
  void show_panels(bool left, bool right);

  QWidget* left_;  ///< holds the panels of all workplaces, one of them shown
  QWidget* right_;
  QWidget* left_panel_ = nullptr;
  QWidget* right_panel_ = nullptr;
  int left_wish_ = QWIDGETSIZE_MAX;
  int right_wish_ = QWIDGETSIZE_MAX;
  bool drawers_ = false;
  bool alone_ = false;
  bool mirrored_ = false;
  bool left_wanted_ = true;
  bool right_wanted_ = true;
};

}  // namespace nazori::ui
