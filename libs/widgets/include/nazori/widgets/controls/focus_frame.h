// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>

namespace nazori::ui {

/// Holds a widget that cannot draw its own focus ring (an OpenGL window). Draws the ring around it while the
/// widget has the focus and the keyboard was used last. With mouse or pen the pointer shows the position.
class FocusFrame final : public QFrame {
  Q_OBJECT
 public:
  FocusFrame(QWidget* inner, QWidget* parent);
  [[nodiscard]] bool shows_ring() const { return inside_ && by_key_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  bool inside_ = false;
  bool by_key_ = true;
};

}  // namespace nazori::ui
