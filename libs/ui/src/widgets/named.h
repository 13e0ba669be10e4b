// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace nazori::ui {

/// Gives a widget its object name and, where it has one, the name that a screen reader says.
/// @param name  never translated: tests and the style sheet find the widget by it. @return the widget.
template <class Widget>
Widget* named(Widget* widget, const char* name, const QString& spoken = {}) {
  widget->setObjectName(QString::fromLatin1(name));
  if (!spoken.isEmpty()) widget->setAccessibleName(spoken);
  return widget;
}

}  // namespace nazori::ui
