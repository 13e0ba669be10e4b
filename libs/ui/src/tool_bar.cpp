// SPDX-License-Identifier: Apache-2.0
#include "tool_bar.h"

#include <QEvent>
#include <QFontInfo>
#include <QLabel>
#include <QLayout>
#include <QMenu>
#include <QResizeEvent>
#include <QToolButton>
#include <algorithm>

#include "actions.h"
#include "palette.h"
#include "tablet_controller.h"

namespace nazori::ui {

ToolBar::ToolBar(const Actions& actions, const TabletController& controller, QWidget* parent)
    : QToolBar(tr("Strokes and tablet"), parent),
      controller_(controller),
      looks_{actions.wood, actions.slate, actions.classic},
      words_{actions.strokes, actions.numbers, actions.arrows, actions.snap},
      stroke_(new QLabel(this)),
      style_(new QToolButton(this)) {
  setObjectName(QStringLiteral("tool_bar"));
  setMovable(false);
  setFloatable(false);
  setContextMenuPolicy(Qt::PreventContextMenu);
  setToolButtonStyle(Qt::ToolButtonTextBesideIcon);

  stroke_->setObjectName(QStringLiteral("stroke_label"));
  stroke_->setAlignment(Qt::AlignCenter);

  const auto icon_only = [this](QAction* action) {
    if (auto* button = qobject_cast<QToolButton*>(widgetForAction(action)))
      button->setToolButtonStyle(Qt::ToolButtonIconOnly);
  };
  addAction(actions.library);
  icon_only(actions.library);
  addSeparator();
  addAction(actions.previous_stroke);
  icon_only(actions.previous_stroke);
  addWidget(stroke_);
  addAction(actions.next_stroke);
  icon_only(actions.next_stroke);
  addSeparator();
  for (auto* action : {actions.strokes, actions.numbers, actions.arrows, actions.snap}) addAction(action);
  addSeparator();
  addAction(actions.clear_ink);
  icon_only(actions.clear_ink);
  addAction(actions.reset_view);
  icon_only(actions.reset_view);
  addSeparator();
  auto* looks = new QMenu(this);
  for (auto* action : {actions.wood, actions.slate, actions.classic}) {
    looks->addAction(action);
    connect(action, &QAction::toggled, this, &ToolBar::refresh);
  }
  style_->setMenu(looks);
  style_->setPopupMode(QToolButton::InstantPopup);
  style_->setObjectName(QStringLiteral("tool_style"));
  style_->setFocusPolicy(Qt::TabFocus);
  style_->setToolTip(tr("How the tablet looks (Ctrl+1, 2, 3)"));
  style_->setToolButtonStyle(Qt::ToolButtonTextOnly);
  addWidget(style_);
  auto* gap = new QWidget(this);
  gap->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  addWidget(gap);
  addAction(actions.information);
  icon_only(actions.information);
  for (auto* action : QToolBar::actions())
    if (auto* button = qobject_cast<QToolButton*>(widgetForAction(action))) {
      button->setObjectName(QStringLiteral("tool_") + action->objectName());
      button->setFocusPolicy(Qt::TabFocus);
      button->setAccessibleName(action->iconText());
      button->setAccessibleDescription(action->statusTip());
    }
  fit();
  refresh();
}

void ToolBar::refresh() {
  const int count = controller_.stroke_count();
  const int current = controller_.current_stroke();
  if (count == 0)
    stroke_->setText(tr("no strokes"));
  else if (current == 0)
    stroke_->setText(tr("all %n strokes", nullptr, count));
  else
    stroke_->setText(tr("stroke %1 of %2").arg(current).arg(count));
  for (const auto* look : looks_)
    if (look->isChecked()) style_->setText(look->iconText() + QStringLiteral("  ▾"));
  style_->setAccessibleName(tr("Look of the tablet: %1").arg(style_->text().section(QLatin1Char(' '), 0, 0)));
}

void ToolBar::fit() {
  const int em = QFontInfo(font()).pixelSize();
  setIconSize({em * 5 / 4, em * 5 / 4});
  // The label keeps its width while stepping, so the buttons stay under the pointer.
  const QFontMetrics metrics(font());
  stroke_->setMinimumWidth(std::max(metrics.horizontalAdvance(tr("stroke %1 of %2").arg(28).arg(28)),
                                    metrics.horizontalAdvance(tr("all %n strokes", nullptr, 28))) +
                           em);
  fit_words();
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
