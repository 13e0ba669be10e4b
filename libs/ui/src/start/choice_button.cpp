// SPDX-License-Identifier: Apache-2.0
#include "start/choice_button.h"

#include <QFontInfo>
#include <QFontMetrics>
#include <QPainter>
#include <algorithm>

#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/look/palette.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

constexpr double kGlyph = 2.6;  ///< times the size of the words
constexpr double kMore = 0.9;
constexpr int kBeside = 18;
constexpr int kAround = 10;
constexpr double kTint = 0.1;
constexpr int kCorner = 10;

}  // namespace

ChoiceButton::ChoiceButton(const char* name, const QString& words, QWidget* parent, const QString& glyph,
                           const QString& more)
    : QRadioButton(words, parent), glyph_(glyph), more_(more) {
  named(this, name, words);
  setAccessibleDescription(more);
  setCursor(Qt::PointingHandCursor);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

QFont ChoiceButton::glyph_font() const { return textbook_font(QFontInfo(font()).pointSizeF() * kGlyph); }

QFont ChoiceButton::more_font() const {
  QFont small = font();
  small.setPointSizeF(QFontInfo(font()).pointSizeF() * kMore);
  return small;
}

QSize ChoiceButton::sizeHint() const {
  const QFontMetrics words(font());
  int width = words.horizontalAdvance(text());
  int height = words.lineSpacing();
  if (!glyph_.isEmpty()) {
    const QFontMetrics more(more_font());
    width = std::max({width, more.horizontalAdvance(more_), words.averageCharWidth() * 16});
    height += QFontMetrics(glyph_font()).lineSpacing() + more.lineSpacing();
  }
  return {width + 2 * kBeside, height + 2 * kAround};
}

void ChoiceButton::paintEvent(QPaintEvent* /*event*/) {
  const auto& colours = current_colours();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double pen = isChecked() || hasFocus() ? 2 : 1;
  painter.setPen(QPen(isChecked() || hasFocus() ? colours.indigo : colours.edge, pen));
  const bool is_marked = isChecked() || underMouse();
  painter.setBrush(is_marked ? blend(colours.surface, colours.indigo, isChecked() ? kTint : kTint / 2)
                             : colours.surface);
  const QRectF frame = QRectF(rect()).adjusted(1, 1, -1, -1);
  painter.drawRoundedRect(frame, kCorner, kCorner);
  if (hasFocus()) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colours.indigo, 1));
    painter.drawRoundedRect(frame.adjusted(4, 4, -4, -4), kCorner - 4, kCorner - 4);
  }
  QRect room = rect().adjusted(kBeside, kAround, -kBeside, -kAround);
  painter.setPen(colours.ink);
  if (glyph_.isEmpty()) {
    painter.drawText(room, Qt::AlignCenter, text());
    return;
  }
  const auto line = [&](const QFont& font, const QString& text) {
    painter.setFont(font);
    painter.drawText(room, Qt::AlignLeft | Qt::AlignTop, text);
    room.setTop(room.top() + QFontMetrics(font).lineSpacing());
  };
  line(glyph_font(), glyph_);
  line(font(), text());
  painter.setPen(colours.muted);
  line(more_font(), more_);
}

}  // namespace nazori::ui
