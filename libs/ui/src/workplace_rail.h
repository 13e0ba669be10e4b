// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QToolBar>

namespace nazori::ui {

/// The workplaces one under the other along the window's edge. Not there while there is only one.
class WorkplaceRail final : public QToolBar {
  Q_OBJECT
 public:
  /// @param entries  the exclusive, checkable actions that go to them.
  WorkplaceRail(const QList<QAction*>& entries, QWidget* parent);

  /// A window this wide has room for the names, or for the drawings alone.
  void fit(int window_width);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  int window_width_ = 0;
};

}  // namespace nazori::ui
