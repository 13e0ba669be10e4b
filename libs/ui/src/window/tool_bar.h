// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QToolBar>

#include "nazori/widgets/page/page.h"

class QToolButton;

namespace nazori::ui {

class Actions;

/// The toolbar above the tablet: the tools of the page, between those that exist on every page.
class ToolBar final : public QToolBar {
  Q_OBJECT
 public:
  ToolBar(const Actions& actions, QWidget* parent);

  /// Shows the tools of a page.
  void enter(const Page& page);
  /// Shows the current look.
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
  QList<QList<QAction*>> words_;  ///< whose buttons show text if there is space
  QToolButton* style_;
  QAction* style_button_action_;
  QAction* gap_;
};

}  // namespace nazori::ui
