// SPDX-License-Identifier: Apache-2.0
#include "functions/expression_line.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "nazori/widgets/look/palette.h"

namespace nazori::ui {

ExpressionLine::ExpressionLine(QWidget* parent) : QLineEdit(parent) {
  connect(this, &QLineEdit::textEdited, this, [this] { at_ = history_.size(); });
}

void ExpressionLine::set_history(const QStringList& history) {
  history_ = history.mid(std::max<qsizetype>(0, history.size() - kMostEntries));
  at_ = history_.size();
}

void ExpressionLine::remember(const QString& expression) {
  if (expression.trimmed().isEmpty()) return;
  history_.removeAll(expression);
  history_.append(expression);
  set_history(history_);
}

void ExpressionLine::mark_error(int column) {
  error_column_ = column;
  update();
}

void ExpressionLine::recall(int step) {
  if (at_ == history_.size()) draft_ = text();
  qsizetype to = at_ + step;
  // An entry that equals the current text is skipped.
  while (to >= 0 && to < history_.size() && history_[to] == text()) to += step;
  if (to < 0 || to > history_.size()) return;
  at_ = to;
  setText(at_ == history_.size() ? draft_ : history_[at_]);
}

void ExpressionLine::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Up:
      recall(-1);
      return;
    case Qt::Key_Down:
      recall(+1);
      return;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      emit entered();
      return;
    default:
      QLineEdit::keyPressEvent(event);
  }
}

void ExpressionLine::paintEvent(QPaintEvent* event) {
  QLineEdit::paintEvent(event);
  if (error_column_ <= 0) return;
  const QString all = text();
  // Columns count code points: a surrogate pair is one column.
  qsizetype from = 0;
  for (int column = 1; column < error_column_ && from < all.size(); ++column)
    from += all[from].isHighSurrogate() && from + 1 < all.size() ? 2 : 1;
  const QString before = all.left(from);
  const QString at =
      from < all.size() ? all.mid(from, all[from].isHighSurrogate() ? 2 : 1) : QStringLiteral("n");
  const QFontMetrics metrics = fontMetrics();
  const QRect cursor = cursorRect();
  const int left = cursor.center().x() - metrics.horizontalAdvance(text().left(cursorPosition())) +
                   metrics.horizontalAdvance(before);
  const int right = left + std::max(metrics.horizontalAdvance(at), metrics.averageCharWidth());
  const int tooth = std::max(2, metrics.height() / 8);
  const int bottom = cursor.bottom();
  QPainterPath zigzag(QPointF(left, bottom));
  bool up = true;
  for (int x = left + tooth; x <= right + tooth; x += tooth, up = !up)
    zigzag.lineTo(x, up ? bottom - tooth : bottom);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setClipRect(rect().adjusted(4, 0, -4, 0));
  painter.setPen(QPen(current_colours().vermilion, std::max(1.5, metrics.height() / 12.0)));
  painter.drawPath(zigzag);
}

}  // namespace nazori::ui
