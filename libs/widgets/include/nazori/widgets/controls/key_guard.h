// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

namespace nazori::ui {

/// Keys that widgets use themselves (Space, Enter, arrows) go to the focused widget, even if they are
/// shortcuts of the window: Space presses a button and the arrows move in a list, whatever these keys do on
/// the tablet.
class KeyGuard final : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace nazori::ui
