// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/controls/wheel_guard.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QScrollArea>
#include <QSlider>

namespace nazori::ui {
namespace {

bool takes_wheel(const QWidget* widget) {
  return qobject_cast<const QAbstractSpinBox*>(widget) != nullptr ||
         qobject_cast<const QComboBox*>(widget) != nullptr || qobject_cast<const QSlider*>(widget) != nullptr;
}

/// The form in which a control lies; nullptr without one.
QScrollArea* form_of(QWidget* control) {
  for (auto* widget = control; widget != nullptr && !widget->isWindow(); widget = widget->parentWidget())
    if (auto* form = qobject_cast<QScrollArea*>(widget)) return form;
  return nullptr;
}

}  // namespace

bool WheelGuard::eventFilter(QObject* watched, QEvent* event) {
  auto* widget = qobject_cast<QWidget*>(watched);
  if (widget == nullptr || !takes_wheel(widget)) return false;
  // The wheel would give these the keyboard before they are asked.
  if (event->type() == QEvent::Polish && widget->focusPolicy() == Qt::WheelFocus)
    widget->setFocusPolicy(Qt::StrongFocus);
  if (event->type() != QEvent::Wheel || widget->hasFocus()) return false;
  auto* form = form_of(widget);
  if (form == nullptr) return false;
  QCoreApplication::sendEvent(form->viewport(), event);
  return true;
}

}  // namespace nazori::ui
