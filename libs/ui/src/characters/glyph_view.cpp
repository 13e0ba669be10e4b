// SPDX-License-Identifier: Apache-2.0
#include "characters/glyph_view.h"

#include <QFontInfo>
#include <QPainter>

#include "nazori/widgets/look/ink_painting.h"
#include "nazori/widgets/look/palette.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {

GlyphView::GlyphView(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("glyph"));
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void GlyphView::show_character(std::shared_ptr<const practice::CharacterSheet> sheet) {
  sheet_ = std::move(sheet);
  setAccessibleName(sheet_ ? to_text(sheet_->character.code_point) : QString());
  update();
}

QSize GlyphView::sizeHint() const {
  const int side = std::min(QFontInfo(font()).pixelSize() * 8, 210);
  return {side, side};
}

void GlyphView::paintEvent(QPaintEvent* /*event*/) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const Colours& c = current_colours();
  const double side = std::min(width(), height());
  const QRectF box(0.5, 0.5, side - 1, side - 1);
  paint_paper(p, box, 10, 6, QPen(c.line, 1));
  if (!sheet_) return;
  const auto& character = sheet_->character;
  if (!character.own_form && textbook_font_has(character.code_point)) {
    QFont font = textbook_font(12);
    font.setPixelSize(static_cast<int>(side * 0.82));
    p.setFont(font);
    p.setPen(c.ink);
    // Centred by the ideographic box, not by the line's ascent and descent.
    const QFontMetricsF metrics(font);
    const QString text = to_text(character.code_point);
    const QRectF ink = metrics.tightBoundingRect(text);
    const double x = (side - metrics.horizontalAdvance(text)) / 2;
    const double y = (side - ink.height()) / 2 - ink.top();
    p.drawText(QPointF(x, y), text);
    return;
  }
  const double scale = side * 0.84 / geometry::kGlyphSide;
  p.translate(side * 0.08, side * 0.08);
  p.scale(scale, scale);
  p.setPen(QPen(c.ink, 4.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  p.setBrush(Qt::NoBrush);
  for (const auto& stroke : character.strokes) p.drawPath(path_through(stroke.line.points));
}

}  // namespace nazori::ui
