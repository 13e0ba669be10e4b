// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

namespace nazori::ui {

/// Keys of the window that widgets work with themselves (Space, Enter, arrows) are the focused widget's: a
/// button is pressed with Space and a list is walked with arrows, whatever these keys mean on the tablet.
class KeyGuard final : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace nazori::ui
