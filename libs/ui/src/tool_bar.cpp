// SPDX-License-Identifier: Apache-2.0
#include "tool_bar.h"

#include <QEvent>
#include <QFontInfo>
#include <QLayout>
#include <QMenu>
#include <QResizeEvent>
#include <QTimer>
#include <QToolButton>
#include <QWidgetAction>

#include "actions.h"

namespace nazori::ui {
namespace {

/// An action of the toolbar that brings a widget and lives as long as the toolbar.
QAction* make_place(QWidget* widget, QToolBar* bar) {
  auto* place = new QWidgetAction(bar);
  place->setDefaultWidget(widget);
  return place;
}

}  // namespace

ToolBar::ToolBar(const Actions& actions, QWidget* parent)
    : QToolBar(tr("Tools"), parent),
      actions_(actions),
      looks_{actions.wood, actions.slate, actions.classic},
      style_(new QToolButton(this)) {
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
  style_->setObjectName(QStringLiteral("tool_style"));
  style_->setFocusPolicy(Qt::TabFocus);
  style_->setToolTip(tr("How the tablet looks (Ctrl+1, 2, 3)"));
  style_->setToolButtonStyle(Qt::ToolButtonTextOnly);
  style_place_ = make_place(style_, this);
  auto* gap = new QWidget(this);
  gap->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  gap_ = make_place(gap, this);
}

void ToolBar::enter(const Workplace& workplace) {
  // The button with the keyboard is made anew with the others.
  QAction* focused = nullptr;
  for (auto* action : actions())
    if (const auto* button = widgetForAction(action); button != nullptr && button->hasFocus())
      focused = action;
  clear();
  words_.clear();
  addAction(actions_.left_panel);
  if (workplace.left().widget != nullptr) addSeparator();
  for (const auto& tool : workplace.tools()) {
    if (tool.action == nullptr) {
      addSeparator();
      continue;
    }
    addAction(tool.action);
    if (tool.words) words_.append(tool.action);
  }
  if (workplace.page() == nullptr) {
    addAction(actions_.reset_view);
    addSeparator();
    addAction(style_place_);
  }
  addAction(gap_);
  addAction(actions_.right_panel);
  name_buttons();
  fit();
  refresh();
  // Else the next picture, which may come long before the next layout, shows them where they are made.
  layout()->activate();
  // New buttons are shown with the next layout; before, they cannot have the keyboard.
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
  style_->setAccessibleName(tr("Look of the tablet: %1").arg(style_->text().section(QLatin1Char(' '), 0, 0)));
}

void ToolBar::fit() {
  const int em = QFontInfo(font()).pixelSize();
  setIconSize({em * 5 / 4, em * 5 / 4});
  fit_words();
  // Buttons know their width in a new font only after they took it up.
  QTimer::singleShot(0, this, &ToolBar::fit_words);
}

void ToolBar::fit_words() {
  // Where the words do not fit the drawings alone stay, and their tool tips.
  const auto show = [this](Qt::ToolButtonStyle style) {
    for (auto* action : words_)
      if (auto* button = qobject_cast<QToolButton*>(widgetForAction(action)))
        button->setToolButtonStyle(style);
  };
  show(Qt::ToolButtonTextBesideIcon);
  layout()->invalidate();
  if (layout()->sizeHint().width() > width()) show(Qt::ToolButtonIconOnly);
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
