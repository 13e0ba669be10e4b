// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>

namespace nazori::ui {

/// Holds a widget that cannot draw its own focus ring (a window of OpenGL) and draws it around it while the
/// keyboard is there and was the last thing used: who works with mouse or pen has the pointer to look at.
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
