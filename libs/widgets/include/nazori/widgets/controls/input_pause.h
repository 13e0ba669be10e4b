// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QWidget>
#include <chrono>

namespace nazori::ui {

/// Ignores presses of keys, mouse, pen and fingers on a widget for a moment, so that one press too many on
/// what was there before does not trigger what has appeared in its place. Thread: interface.
class InputPause final : public QObject {
  Q_OBJECT
 public:
  /// @param widget  with everything in it; also its parent.
  explicit InputPause(QWidget* widget);

  void begin(std::chrono::milliseconds time);
  [[nodiscard]] bool is_on() const { return on_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void timerEvent(QTimerEvent* event) override;

 private:
  void end();

  QWidget* widget_;
  int timer_ = 0;
  bool on_ = false;
};

}  // namespace nazori::ui
