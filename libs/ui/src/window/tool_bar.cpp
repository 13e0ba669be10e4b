// SPDX-License-Identifier: Apache-2.0
#include "window/tool_bar.h"

#include <QEvent>
#include <QFontInfo>
#include <QLayout>
#include <QMenu>
#include <QResizeEvent>
#include <QTimer>
#include <QToolButton>
#include <QWidgetAction>

#include "nazori/widgets/controls/parts.h"
#include "window/actions.h"

namespace nazori::ui {
namespace {

/// An action of the toolbar that brings a widget and lives as long as the toolbar.
QAction* make_widget_action(QWidget* widget, QToolBar* bar) {
  auto* action = new QWidgetAction(bar);
  action->setDefaultWidget(widget);
  return action;
}

}  // namespace

ToolBar::ToolBar(const Actions& actions, QWidget* parent)
    : QToolBar(tr("Toolbar"), parent),
      actions_(actions),
      looks_{actions.wood, actions.slate, actions.classic},
      style_(named(new QToolButton(this), "tool_style")) {
  setObjectName(QStringLiteral("tool_bar"));
  setMovable(false);
  setFloatable(false);
  setContextMenuPolicy(Qt::PreventContextMenu);
  setToolButtonStyle(Qt::ToolButtonIconOnly);

  auto* looks = new QMenu(this);
  for (auto* action : looks_) {
    looks->addAction(action);
    connect(action, &QAction::toggled, this, &ToolBar::refresh);
  }
  style_->setMenu(looks);
  style_->setPopupMode(QToolButton::InstantPopup);
  style_->setToolTip(tr("Tablet style (Ctrl+1, 2, 3)"));
  style_->setToolButtonStyle(Qt::ToolButtonTextOnly);
  style_button_action_ = make_widget_action(style_, this);
  auto* gap = new QWidget(this);
  gap->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  gap_ = make_widget_action(gap, this);
}

void ToolBar::enter(const Page& page) {
  // All buttons are made again, also the one that has the focus.
  QAction* focused = nullptr;
  for (auto* action : actions())
    if (const auto* button = widgetForAction(action); button != nullptr && button->hasFocus())
      focused = action;
  clear();
  words_ = {{}};
  addAction(actions_.left_panel);
  if (page.left().widget != nullptr) addSeparator();
  for (const auto& tool : page.tools()) {
    if (tool.action == nullptr) {
      words_.append(QList<QAction*>());
      addSeparator();
      continue;
    }
    addAction(tool.action);
    if (tool.words) words_.back().append(tool.action);
  }
  if (page.instead_of_tablet() == nullptr) {
    addAction(actions_.reset_view);
    addSeparator();
    addAction(style_button_action_);
  }
  addAction(gap_);
  addAction(actions_.right_panel);
  name_buttons();
  fit();
  refresh();
  // Without this the buttons would be painted at their initial position before the next layout.
  layout()->activate();
  // New buttons become visible with the next layout and cannot have the focus before.
  if (auto* button = focused != nullptr ? widgetForAction(focused) : nullptr)
    QTimer::singleShot(0, button, [button] { button->setFocus(Qt::TabFocusReason); });
}

void ToolBar::name_buttons() {
  for (auto* action : QToolBar::actions())
    if (auto* button = qobject_cast<QToolButton*>(widgetForAction(action));
        button != nullptr && button != style_) {
      button->setObjectName(QStringLiteral("tool_") + action->objectName());
      button->setFocusPolicy(Qt::TabFocus);
      button->setAccessibleName(action->iconText());
      button->setAccessibleDescription(action->statusTip());
    }
}

void ToolBar::refresh() {
  for (const auto* look : looks_)
    if (look->isChecked()) style_->setText(look->iconText() + QStringLiteral("  ▾"));
  style_->setAccessibleName(tr("Tablet style: %1").arg(style_->text().section(QLatin1Char(' '), 0, 0)));
}

void ToolBar::fit() {
  const int em = QFontInfo(font()).pixelSize();
  setIconSize({em * 5 / 4, em * 5 / 4});
  fit_words();
  // Buttons know their new width only after they received the new font.
  QTimer::singleShot(0, this, &ToolBar::fit_words);
}

void ToolBar::fit_words() {
  // If the texts do not fit, only icons and tool tips remain. The last group loses its texts first, because
  // the first group is the same in every stage of a lesson.
  const auto show = [this](const QList<QAction*>& group, Qt::ToolButtonStyle style) {
    for (auto* action : group)
      if (auto* button = qobject_cast<QToolButton*>(widgetForAction(action)))
        button->setToolButtonStyle(style);
    layout()->invalidate();
  };
  for (const auto& group : words_) show(group, Qt::ToolButtonTextBesideIcon);
  for (auto group = words_.crbegin(); group != words_.crend(); ++group)
    if (layout()->sizeHint().width() > width()) show(*group, Qt::ToolButtonIconOnly);
}

void ToolBar::resizeEvent(QResizeEvent* event) {
  QToolBar::resizeEvent(event);
  if (event->oldSize().width() != event->size().width()) fit_words();
}

void ToolBar::changeEvent(QEvent* event) {
  QToolBar::changeEvent(event);
  if (event->type() == QEvent::FontChange) fit();
}

}  // namespace nazori::ui
