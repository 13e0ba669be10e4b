// SPDX-License-Identifier: Apache-2.0
#include "characters/character_tile_delegate.h"

#include <QFontInfo>
#include <QPainter>

#include "characters/character_list_model.h"
#include "nazori/practice/strengths.h"
#include "nazori/widgets/charts/role_colours.h"
#include "nazori/widgets/look/palette.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

constexpr double kBar = 3;  ///< height of the bar of strength

/// The sign in the upper right corner and the bar at the foot: as long as the character is well known.
void paint_strength(QPainter& painter, const QRectF& tile, study::Strength strength, const QFont& font) {
  const Colours& c = current_colours();
  const auto look = practice::look_of(strength);
  const double share = practice::bar_of(strength);
  if (share > 0) {
    const QRectF bar(tile.left() + 4, tile.bottom() - kBar - 2, tile.width() - 8, kBar);
    painter.setPen(Qt::NoPen);
    painter.setBrush(c.line);
    painter.drawRoundedRect(bar, kBar / 2, kBar / 2);
    painter.setBrush(strength == study::Strength::leech ? c.amber : c.indigo);
    painter.drawRoundedRect(QRectF(bar.topLeft(), QSizeF(bar.width() * share, kBar)), kBar / 2, kBar / 2);
  }
  if (look.sign == 0) return;
  QFont small = font;
  small.setPixelSize(std::max(8, static_cast<int>(tile.height() * 0.22)));
  small.setBold(true);
  painter.setFont(small);
  painter.setPen(strength == study::Strength::leech ? c.amber : c.muted);
  painter.drawText(tile.adjusted(0, 1, -3, 0), Qt::AlignTop | Qt::AlignRight, to_text(look.sign));
}

}  // namespace

int CharacterTileDelegate::tile_side(const QFont& font) { return QFontInfo(font).pixelSize() * 3; }

int CharacterTileDelegate::row_height(const QFont& font) { return QFontInfo(font).pixelSize() * 10 / 3; }

QSize CharacterTileDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  if (!index.data(CharacterListModel::kWhyRole).toString().isEmpty())
    return {option.rect.width(), row_height(option.font)};
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
  const QString why = index.data(CharacterListModel::kWhyRole).toString();

  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(QPen(is_current || has_focus ? c.indigo : c.line, is_current || has_focus ? 2 : 1));
  painter->setBrush(is_current ? blend(c.surface, c.indigo, 0.13)
                    : hovered  ? blend(c.surface, c.line, 0.35)
                               : c.surface);
  painter->drawRoundedRect(tile, 6, 6);
  const QString text = index.data(Qt::DisplayRole).toString();
  QFont font = character_font(text, 12);
  font.setPixelSize(static_cast<int>(tile.height() * (why.isEmpty() ? 0.62 : 0.56)));
  painter->setFont(font);
  painter->setPen(is_current ? c.indigo : c.ink);
  const QVariant strength = index.data(CharacterListModel::kStrengthRole);
  QRectF head = tile;
  if (!why.isEmpty()) {
    // A row: the character or word, and beside it why it was found.
    const double most = tile.width() * 0.45;
    const double wide = std::max(tile.height(), QFontMetricsF(font).horizontalAdvance(text) + 16);
    if (wide > most && text.size() > 1) {
      font.setPixelSize(std::max(10, static_cast<int>(font.pixelSize() * most / wide)));
      painter->setFont(font);
    }
    head.setWidth(std::min(wide, std::max(most, tile.height())));
    painter->drawText(head, Qt::AlignCenter | Qt::TextDontClip, text);
    // What matches above the rest.
    const QRectF beside = tile.adjusted(head.width() + 4, 3, -6, -3);
    const QString between = QStringLiteral(" · ");
    const QString rest = why.section(between, 1);
    painter->setFont(option.font);
    const QFontMetricsF metrics(option.font);
    const auto line = [&](const QRectF& place, const QString& words, const QColor& colour) {
      painter->setPen(colour);
      painter->drawText(place, Qt::AlignVCenter | Qt::AlignLeft,
                        metrics.elidedText(words, Qt::ElideRight, place.width()));
    };
    const QRectF upper(beside.topLeft(), QSizeF(beside.width(), beside.height() / (rest.isEmpty() ? 1 : 2)));
    line(upper, why.section(between, 0, 0), c.ink);
    if (!rest.isEmpty()) line(upper.translated(0, upper.height()), rest, c.muted);
  } else {
    painter->drawText(tile, Qt::AlignCenter | Qt::TextDontClip, text);
  }
  if (strength.isValid())
    paint_strength(*painter, head, static_cast<study::Strength>(strength.toInt()), option.font);
  painter->restore();
}

}  // namespace nazori::ui
