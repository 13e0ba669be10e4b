// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QToolBar>

#include "workplace.h"

class QToolButton;

namespace nazori::ui {

class Actions;

/// The row above the tablet: the tools of the workplace between what every workplace has.
class ToolBar final : public QToolBar {
  Q_OBJECT
 public:
  ToolBar(const Actions& actions, QWidget* parent);

  /// Shows the tools of a workplace.
  void enter(const Workplace& workplace);
  /// Shows which look is chosen now.
  void refresh();

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit();
  void fit_words();
  void name_buttons();

  const Actions& actions_;
  QList<QAction*> looks_;
  QList<QList<QAction*>> words_;  ///< whose buttons show words where there is room
  QToolButton* style_;
  QAction* style_place_;
  QAction* gap_;
};

}  // namespace nazori::ui
