// SPDX-License-Identifier: Apache-2.0
#include "device/button_lines.h"

#include <QEvent>
#include <QFontMetrics>
#include <QPushButton>
#include <QScrollArea>
#include <QStyle>
#include <QStyleOptionButton>
#include <QTextBoundaryFinder>
#include <algorithm>

namespace nazori::ui {

QString in_lines(const QString& text, const QFontMetrics& metrics, int width_px) {
  QString lines;
  QString line;
  QTextBoundaryFinder finder(QTextBoundaryFinder::Line, text);
  qsizetype from = 0;
  for (qsizetype to = finder.toNextBoundary(); to >= 0; to = finder.toNextBoundary()) {
    QString piece = text.mid(from, to - from);
    from = to;
    // A word that is wider than a line is broken, so that it is not cut off.
    while (piece.size() > 1 && metrics.horizontalAdvance(piece.trimmed()) > width_px) {
      if (!line.isEmpty()) lines += line.trimmed() + QLatin1Char('\n');
      qsizetype fits = piece.size() - 1;
      while (fits > 1 && metrics.horizontalAdvance(piece.left(fits)) > width_px) --fits;
      lines += piece.left(fits) + QLatin1Char('\n');
      line.clear();
      piece = piece.mid(fits);
    }
    const QString longer = line + piece;
    // A space at the end of a line takes no width.
    if (!line.isEmpty() && metrics.horizontalAdvance(longer.trimmed()) > width_px) {
      lines += line.trimmed() + QLatin1Char('\n');
      line = piece;
    } else {
      line = longer;
    }
  }
  return lines + line.trimmed();
}

ButtonLines::ButtonLines(QScrollArea* area, int margin_px)
    : QObject(area), viewport_(area->viewport()), margin_px_(margin_px) {
  viewport_->installEventFilter(this);
}

void ButtonLines::add(QAbstractButton* button, const QString& text) {
  texts_.insert(button, text);
  button->installEventFilter(this);
  connect(button, &QObject::destroyed, this, [this, button] { texts_.remove(button); });
  break_lines(button);
}

bool ButtonLines::eventFilter(QObject* watched, QEvent* event) {
  if (watched == viewport_) {
    if (event->type() == QEvent::Resize)
      for (auto* button : texts_.keys()) break_lines(button);
  } else if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange ||
             event->type() == QEvent::Show) {
    if (auto* button = qobject_cast<QAbstractButton*>(watched)) break_lines(button);
  }
  return false;
}

void ButtonLines::break_lines(QAbstractButton* button) const {
  if (!viewport_) return;
  constexpr int kAnyWidth = 1000;
  constexpr int kSlack_px = 6;  // some styles measure text a little wider
  QStyleOptionButton option;
  option.initFrom(button);
  option.text = texts_.value(button);  // the style reserves space beside the icon only if there is a text
  const auto kind =
      qobject_cast<QPushButton*>(button) != nullptr ? QStyle::CT_PushButton : QStyle::CT_RadioButton;
  const QFontMetrics metrics = button->fontMetrics();
  const QSize whole = button->style()->sizeFromContents(kind, &option, {kAnyWidth, metrics.height()}, button);
  const int room = viewport_->width() - 2 * margin_px_ - (whole.width() - kAnyWidth) - kSlack_px;
  const QString text = in_lines(texts_.value(button), metrics, std::max(room, 1));
  if (button->text() != text) button->setText(text);
}

}  // namespace nazori::ui
