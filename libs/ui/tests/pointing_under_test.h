// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QMouseEvent>
#include <QPointingDevice>
#include <QTabletEvent>

#include "nazori/widgets/controls/input_watch.h"

namespace nazori::ui::test {

/// A mouse moves over `target`, so that the program notices a mouse, as it does once it has a window.
inline void move_mouse(QObject& target) {
  (void)InputWatch::of_program();
  QMouseEvent move(QEvent::MouseMove, {5, 5}, {5, 5}, Qt::NoButton, Qt::NoButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&target, &move);
}

/// A pen moves over `target`, so that the program notices a pen.
inline void move_pen(QObject& target) {
  (void)InputWatch::of_program();
  const QPointingDevice pen(QStringLiteral("pen"), 77, QInputDevice::DeviceType::Stylus,
                            QPointingDevice::PointerType::Pen, QInputDevice::Capability::All, 1, 2);
  QTabletEvent move(QEvent::TabletMove, &pen, {5, 5}, {5, 5}, 0.5, 0, 0, 0, 0, 0, Qt::NoModifier,
                    Qt::NoButton, Qt::NoButton);
  QCoreApplication::sendEvent(&target, &move);
}

}  // namespace nazori::ui::test
