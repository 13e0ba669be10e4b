// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

namespace nazori::ui {

/// The mouse wheel scrolls a form, also where the pointer is on a number, a choice or a slider: these take
/// the wheel only while they have the keyboard, so that nobody changes a value by scrolling past it. An
/// event filter of the program.
class WheelGuard final : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace nazori::ui
