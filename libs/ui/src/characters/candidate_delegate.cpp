// SPDX-License-Identifier: Apache-2.0
#include "characters/candidate_delegate.h"

#include <QApplication>
#include <QFontInfo>
#include <QPainter>
#include <QStyle>

namespace nazori::ui {

void CandidateDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const {
  QStyleOptionViewItem item = option;
  initStyleOption(&item, index);
  const QString character = item.text;
  item.text.clear();
  const QStyle* style = item.widget != nullptr ? item.widget->style() : QApplication::style();
  style->drawControl(QStyle::CE_ItemViewItem, &item, painter, item.widget);

  painter->save();
  painter->setPen(item.palette.color(item.state.testFlag(QStyle::State_Selected) ? QPalette::HighlightedText
                                                                                 : QPalette::Text));
  QFont small = QApplication::font();
  small.setPointSizeF(small.pointSizeF() * 0.75);
  const int line = QFontMetrics(small).height();
  painter->setFont(item.font);
  painter->drawText(item.rect.adjusted(0, 0, 0, -line), Qt::AlignCenter | Qt::TextDontClip, character);
  painter->setFont(small);
  const QRect under = item.rect.adjusted(3, item.rect.height() - line - 2, -3, -2);
  const QString kind = index.data(kKindRole).toString();
  painter->drawText(under, Qt::AlignCenter,
                    QFontMetrics(small).elidedText(kind, Qt::ElideRight, under.width()));
  painter->restore();
}

}  // namespace nazori::ui
