// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QApplication>
#include <QFont>

namespace nazori::ui {

/// The text of the buttons of a session. Beyond a size it keeps a little behind other text, so that the
/// tablet keeps its half of a small window.
[[nodiscard]] inline QFont session_font() {
  constexpr int kUsual_pt = 20;
  constexpr double kSmaller = 0.85;
  QFont own = QApplication::font();
  if (own.pointSizeF() > kUsual_pt) own.setPointSizeF(own.pointSizeF() * kSmaller);
  return own;
}

}  // namespace nazori::ui
