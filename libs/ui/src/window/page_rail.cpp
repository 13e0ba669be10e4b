// SPDX-License-Identifier: Apache-2.0
#include "window/page_rail.h"

#include <QEvent>
#include <QFontInfo>
#include <QToolButton>

namespace nazori::ui {
namespace {

constexpr int kWordsWindow_em = 72;  ///< narrower windows show only the icons

}  // namespace

PageRail::PageRail(const QList<QAction*>& entries, QWidget* parent) : QToolBar(tr("Pages"), parent) {
  setObjectName(QStringLiteral("page_rail"));
  setAccessibleName(windowTitle());
  setOrientation(Qt::Vertical);
  setMovable(false);
  setFloatable(false);
  setContextMenuPolicy(Qt::PreventContextMenu);
  for (auto* entry : entries) {
    addAction(entry);
    auto* button = qobject_cast<QToolButton*>(widgetForAction(entry));
    button->setObjectName(QStringLiteral("rail_") + entry->objectName());
    button->setFocusPolicy(Qt::TabFocus);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    button->setAccessibleName(entry->iconText());
    button->setAccessibleDescription(entry->statusTip());
  }
}

void PageRail::fit(int window_width) {
  window_width_ = window_width;
  const int em = QFontInfo(font()).pixelSize();
  setIconSize({em * 3 / 2, em * 3 / 2});
  setToolButtonStyle(window_width >= em * kWordsWindow_em ? Qt::ToolButtonTextUnderIcon
                                                          : Qt::ToolButtonIconOnly);
}

void PageRail::changeEvent(QEvent* event) {
  QToolBar::changeEvent(event);
  if (event->type() == QEvent::FontChange && window_width_ > 0) fit(window_width_);
}

}  // namespace nazori::ui
