// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QList>
#include <QSplitter>

class QAction;

namespace nazori::ui {

/// Library, tablet, information side by side. The tablet always has at least half of the width; where that
/// leaves too little for both panels they become drawers, of which one at a time is open.
class Panes final : public QSplitter {
  Q_OBJECT
 public:
  /// Narrower windows have drawers.
  static constexpr int kDrawers_px = 1000;

  Panes(QWidget* library, QWidget* tablet, QWidget* information, QWidget* parent);

  void set_open(bool library, bool information);
  void open_library(bool open);
  void open_information(bool open);
  [[nodiscard]] bool are_drawers() const { return drawers_; }
  /// Closes what lies open as a drawer.
  void close_drawers();
  /// Whether each is open where there is room for both: what is worth remembering.
  [[nodiscard]] bool library_wanted() const { return library_wanted_; }
  [[nodiscard]] bool information_wanted() const { return information_wanted_; }
  /// Only the tablet.
  void set_alone(bool alone);

  /// How wide the learner would have the panels; without a wish they are as wide as may be.
  void wish(int library_width, int information_width);
  [[nodiscard]] int library_wish() const { return library_wish_; }
  [[nodiscard]] int information_wish() const { return information_wish_; }

  /// For a window of this width, in text of this size.
  void fit(int window_width, int text_pt);

 signals:
  void opened(bool library, bool information);

 private:
  void show_panels(bool library, bool information);

  QWidget* library_;
  QWidget* information_;
  int library_wish_ = QWIDGETSIZE_MAX;
  int information_wish_ = QWIDGETSIZE_MAX;
  bool drawers_ = false;
  bool alone_ = false;
  bool library_wanted_ = true;
  bool information_wanted_ = true;
};

}  // namespace nazori::ui
