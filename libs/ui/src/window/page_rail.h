// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QToolBar>

namespace nazori::ui {

/// The pages, one below the other along the edge of the window. Hidden while there is only one.
class PageRail final : public QToolBar {
  Q_OBJECT
 public:
  /// @param entries  the exclusive, checkable actions that go to the pages.
  PageRail(const QList<QAction*>& entries, QWidget* parent);

  /// Shows names or only icons, by the width of the window.
  void fit(int window_width);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  int window_width_ = 0;
};

}  // namespace nazori::ui
