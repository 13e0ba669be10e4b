// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QToolBar>

class QLabel;

namespace nazori::ui {

class Actions;
class TabletController;

/// The row above the tablet: which stroke is shown, and what is switched on.
class ToolBar final : public QToolBar {
  Q_OBJECT
 public:
  ToolBar(const Actions& actions, const TabletController& controller, QWidget* parent);

  /// Shows what the controller says now.
  void refresh();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void fit();

  const TabletController& controller_;
  QLabel* stroke_;
};

}  // namespace nazori::ui
