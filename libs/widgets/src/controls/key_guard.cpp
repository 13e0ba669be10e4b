// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/controls/key_guard.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>

namespace nazori::ui {
namespace {

bool walks(int key) {
  return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
}

bool takes(int key) { return key == Qt::Key_Space || key == Qt::Key_Return || key == Qt::Key_Enter; }

bool slides(int key) {
  return walks(key) || key == Qt::Key_PageUp || key == Qt::Key_PageDown || key == Qt::Key_Home ||
         key == Qt::Key_End;
}

bool works_with(const QObject* widget, int key) {
  if (qobject_cast<const QAbstractItemView*>(widget) != nullptr ||
      qobject_cast<const QComboBox*>(widget) != nullptr)
    return walks(key) || takes(key);
  if (qobject_cast<const QAbstractSlider*>(widget) != nullptr) return slides(key);
  if (qobject_cast<const QLineEdit*>(widget) != nullptr) return key == Qt::Key_Return || key == Qt::Key_Enter;
  return qobject_cast<const QAbstractButton*>(widget) != nullptr && key == Qt::Key_Space;
}

}  // namespace

bool KeyGuard::eventFilter(QObject* watched, QEvent* event) {
  // A popup handles its keys itself, and shortcuts are off while it is open.
  if (event->type() == QEvent::ShortcutOverride && QApplication::activePopupWidget() == nullptr) {
    const auto* key = static_cast<QKeyEvent*>(event);
    const auto modifiers = key->modifiers() & ~Qt::KeypadModifier;
    if (modifiers == Qt::NoModifier && works_with(watched, key->key())) {
      event->accept();
      return true;
    }
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace nazori::ui
