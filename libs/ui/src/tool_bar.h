// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QToolBar>

class QLabel;
class QToolButton;

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
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit();
  void fit_words();

  const TabletController& controller_;
  QList<QAction*> looks_;
  QList<QAction*> words_;  ///< whose buttons show words where there is room
  QLabel* stroke_;
  QToolButton* style_;
};

}  // namespace nazori::ui
