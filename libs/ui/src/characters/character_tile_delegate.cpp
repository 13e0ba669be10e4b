// SPDX-License-Identifier: Apache-2.0
#include "characters/character_tile_delegate.h"

#include <QFontInfo>
#include <QPainter>

#include "characters/character_list_model.h"
#include "look/palette.h"
#include "words/kanji_text.h"

namespace nazori::ui {

int CharacterTileDelegate::tile_side(const QFont& font) { return QFontInfo(font).pixelSize() * 3; }

QSize CharacterTileDelegate::sizeHint(const QStyleOptionViewItem& /*option*/,
                                      const QModelIndex& /*index*/) const {
  return {side_, side_};
}

void CharacterTileDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                                  const QModelIndex& index) const {
  const Colours& c = current_colours();
  const bool is_current =
      static_cast<char32_t>(index.data(CharacterListModel::kCodePointRole).toUInt()) == current_;
  const bool has_focus = option.state.testFlag(QStyle::State_HasFocus);
  const bool hovered = option.state.testFlag(QStyle::State_MouseOver);
  const QRectF tile = QRectF(option.rect).adjusted(2.5, 2.5, -2.5, -2.5);

  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(QPen(is_current || has_focus ? c.indigo : c.line, is_current || has_focus ? 2 : 1));
  painter->setBrush(is_current ? blend(c.surface, c.indigo, 0.13)
                    : hovered  ? blend(c.surface, c.line, 0.35)
                               : c.surface);
  painter->drawRoundedRect(tile, 6, 6);
  QFont font = textbook_font(12);
  font.setPixelSize(static_cast<int>(tile.height() * 0.66));
  painter->setFont(font);
  painter->setPen(is_current ? c.indigo : c.ink);
  painter->drawText(tile, Qt::AlignCenter | Qt::TextDontClip, index.data(Qt::DisplayRole).toString());
  painter->restore();
}

}  // namespace nazori::ui
