// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>

namespace nazori::ui {

/// Holds a widget that cannot draw its own focus ring (a window of OpenGL) and draws it around it when the
/// keyboard came there.
class FocusFrame final : public QFrame {
  Q_OBJECT
 public:
  FocusFrame(QWidget* inner, QWidget* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  bool ring_ = false;
};

}  // namespace nazori::ui
