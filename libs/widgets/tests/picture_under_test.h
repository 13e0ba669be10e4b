// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QWidget>
#include <cstdlib>

namespace nazori::ui::test {

/// What a widget paints; magenta where it paints nothing.
inline QImage picture_of(QWidget& widget) {
  QImage picture(widget.size(), QImage::Format_ARGB32);
  picture.fill(Qt::magenta);
  widget.render(&picture);
  return picture;
}

/// Whether a pixel has about this colour.
inline bool is(const QImage& picture, QPointF at, const QColor& colour) {
  const QRgb pixel = picture.pixel(at.toPoint());
  return std::abs(qRed(pixel) - colour.red()) + std::abs(qGreen(pixel) - colour.green()) +
             std::abs(qBlue(pixel) - colour.blue()) <
         30;
}

/// The box of all pixels of about this colour.
inline QRect box_of(const QImage& picture, const QColor& colour, QRect within = {}) {
  QRect box;
  if (within.isNull()) within = picture.rect();
  for (int y = within.top(); y <= within.bottom(); ++y)
    for (int x = within.left(); x <= within.right(); ++x)
      if (is(picture, {static_cast<double>(x), static_cast<double>(y)}, colour)) box |= QRect(x, y, 1, 1);
  return box;
}

}  // namespace nazori::ui::test
