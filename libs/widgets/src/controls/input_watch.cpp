// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/controls/input_watch.h"

#include <QCoreApplication>
#include <QInputDevice>
#include <QPointer>
#include <QPointerEvent>
#include <QRegularExpression>
#include <algorithm>

namespace nazori::ui {
namespace {

bool has_pen() {
  const auto all = QInputDevice::devices();
  return std::any_of(all.begin(), all.end(), [](const QInputDevice* device) {
    return device->type() == QInputDevice::DeviceType::Stylus;
  });
}

}  // namespace

InputWatch::InputWatch(QObject* program) : QObject(program) { program->installEventFilter(this); }

InputWatch& InputWatch::of_program() {
  static QPointer<InputWatch> watch;
  if (watch == nullptr) watch = new InputWatch(QCoreApplication::instance());
  return *watch;
}

QString InputWatch::sentence(const QString& device) const {
  if (!device.isEmpty()) return tr("You are writing with %1.").arg(device);
  switch (kind_) {
    case Kind::pen:
      return tr("You are writing with the pen.");
    case Kind::finger:
      return tr("You are writing with your finger. A pen works better.");
    case Kind::mouse:
      return has_pen() ? tr("You are writing with the mouse. Your pen tablet works better.")
                       : tr("You are writing with the mouse. A pen tablet works better.");
  }
  return {};
}

QStringList InputWatch::shorter_and_shorter() const {
  const QString word = kind_ == Kind::pen ? tr("Pen") : kind_ == Kind::finger ? tr("Finger") : tr("Mouse");
  const QString all = sentence({});
  const auto end = all.indexOf(QRegularExpression(QStringLiteral("[.。]")));
  return {all, all.left(end + 1), word};
}

bool InputWatch::eventFilter(QObject* /*watched*/, QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseMove:
    case QEvent::MouseButtonPress:
    case QEvent::TabletMove:
    case QEvent::TabletPress:
    case QEvent::TouchBegin: {
      // A mouse event that Qt makes of a pen or a finger says so, too.
      const auto pointer = static_cast<const QPointerEvent*>(event)->pointerType();
      const Kind kind =
          pointer == QPointingDevice::PointerType::Pen || pointer == QPointingDevice::PointerType::Eraser
              ? Kind::pen
          : pointer == QPointingDevice::PointerType::Finger ? Kind::finger
                                                            : Kind::mouse;
      has_pointed_ = true;
      if (std::exchange(kind_, kind) != kind) emit changed();
      break;
    }
    default:
      break;
  }
  return false;
}

}  // namespace nazori::ui
