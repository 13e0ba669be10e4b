// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QApplication>
#include <QFont>
#include <QFontInfo>
#include <QWidget>

#include "nazori/practice/session_question.h"
#include "nazori/widgets/words/line_stretch.h"

namespace nazori::ui {

/// How much room there is for the text of a session in the window of a widget.
[[nodiscard]] inline practice::QuestionRoom session_room(const QWidget& widget) {
  const double em = QFontInfo(QApplication::font()).pixelSize();
  return practice::room_for_question(widget.window()->height() / em);
}

/// The text of a session. Beyond a size it keeps behind other text, so that the tablet keeps its half of a
/// small window.
[[nodiscard]] inline QFont session_font(practice::QuestionRoom room) {
  constexpr int kUsual_pt = 20;
  constexpr double kSmaller = 0.85;
  constexpr double kSmallest = 0.72;
  QFont own = QApplication::font();
  if (own.pointSizeF() <= kUsual_pt) return own;
  const bool is_low = room == practice::QuestionRoom::line;
  own.setPointSizeF(own.pointSizeF() * (is_low ? kSmallest / line_stretch(own) : kSmaller));
  return own;
}

}  // namespace nazori::ui
