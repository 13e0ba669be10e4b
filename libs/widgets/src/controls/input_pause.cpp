// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/controls/input_pause.h"

#include <QCoreApplication>
#include <QEvent>
#include <QTimerEvent>

namespace nazori::ui {
namespace {

bool is_press(QEvent::Type type) {
  switch (type) {
    case QEvent::KeyPress:
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::TabletPress:
    case QEvent::TouchBegin:
      return true;
    default:
      return false;
  }
}

}  // namespace

InputPause::InputPause(QWidget* widget) : QObject(widget), widget_(widget) {}

void InputPause::begin(std::chrono::milliseconds time) {
  end();
  on_ = true;
  QCoreApplication::instance()->installEventFilter(this);
  timer_ = startTimer(time);
}

void InputPause::end() {
  if (!on_) return;
  on_ = false;
  killTimer(timer_);
  QCoreApplication::instance()->removeEventFilter(this);
}

void InputPause::timerEvent(QTimerEvent* event) {
  if (event->timerId() == timer_) end();
}

bool InputPause::eventFilter(QObject* watched, QEvent* event) {
  // The key of an action reaches the action, not the widget. No action has a key for a moment.
  if (event->type() == QEvent::Shortcut) return widget_->isVisible();
  if (!is_press(event->type())) return false;
  const auto* at = qobject_cast<QWidget*>(watched);
  return at != nullptr && (at == widget_ || widget_->isAncestorOf(at));
}

}  // namespace nazori::ui
