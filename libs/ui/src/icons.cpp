// SPDX-License-Identifier: Apache-2.0
#include "icons.h"

#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>

#include "kanji_text.h"

namespace nazori::ui {
namespace {

/// Draws in a box of 24 x 24 with a pen of 1.7.
void draw(QPainter& p, Icon which, const QColor& colour) {
  p.setPen(QPen(colour, 1.7, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  p.setBrush(Qt::NoBrush);
  const auto line = [&p](std::initializer_list<QPointF> points) {
    p.drawPolyline(QPolygonF(QList<QPointF>(points)));
  };
  switch (which) {
    case Icon::previous:
      line({{14.5, 6}, {8.5, 12}, {14.5, 18}});
      break;
    case Icon::next:
      line({{9.5, 6}, {15.5, 12}, {9.5, 18}});
      break;
    case Icon::back:
      line({{10, 6}, {4.5, 12}, {10, 18}});
      line({{5, 12}, {19.5, 12}});
      break;
    case Icon::strokes: {
      QPainterPath brush(QPointF(5, 7));
      brush.cubicTo(QPointF(9, 5), QPointF(14, 9), QPointF(19.5, 6));
      brush.moveTo(QPointF(14, 4));
      brush.cubicTo(QPointF(13, 12), QPointF(10, 17), QPointF(5, 20));
      brush.moveTo(QPointF(11.5, 13));
      brush.cubicTo(QPointF(14, 15), QPointF(17, 18), QPointF(19.5, 19.5));
      p.drawPath(brush);
      break;
    }
    case Icon::numbers: {
      p.drawEllipse(QPointF(12, 12), 8.2, 8.2);
      line({{10.2, 9.6}, {12.6, 8}, {12.6, 16}});
      break;
    }
    case Icon::arrows:
      line({{5, 19}, {18.5, 5.5}});
      line({{10.5, 5.2}, {18.8, 5.2}, {18.8, 13.5}});
      break;
    case Icon::snap: {
      // A horseshoe magnet.
      QPainterPath magnet(QPointF(5, 4.5));
      magnet.lineTo(5, 12.5);
      magnet.arcTo(QRectF(5, 5.5, 14, 14), 180, 180);
      magnet.lineTo(19, 4.5);
      magnet.lineTo(14.6, 4.5);
      magnet.lineTo(14.6, 12.5);
      magnet.arcTo(QRectF(9.4, 9.9, 5.2, 5.2), 0, -180);
      magnet.lineTo(9.4, 4.5);
      magnet.closeSubpath();
      p.drawPath(magnet);
      line({{5, 8.6}, {9.4, 8.6}});
      line({{14.6, 8.6}, {19, 8.6}});
      break;
    }
    case Icon::curve: {
      QPainterPath wave(QPointF(4, 16));
      wave.cubicTo(QPointF(8, -1), QPointF(14, 25), QPointF(20, 7));
      p.drawPath(wave);
      line({{4, 4}, {4, 20}, {20, 20}});
      break;
    }
    case Icon::sound: {
      line({{4, 9.5}, {7.5, 9.5}, {12, 5.5}, {12, 18.5}, {7.5, 14.5}, {4, 14.5}, {4, 9.5}});
      QPainterPath waves;
      waves.arcMoveTo(QRectF(9, 8, 8, 8), -50);
      waves.arcTo(QRectF(9, 8, 8, 8), -50, 100);
      waves.arcMoveTo(QRectF(6, 4.5, 15, 15), -50);
      waves.arcTo(QRectF(6, 4.5, 15, 15), -50, 100);
      p.drawPath(waves);
      break;
    }
    case Icon::erase: {
      QPainterPath eraser(QPointF(4.5, 14));
      eraser.lineTo(13, 5.5);
      eraser.lineTo(19, 11.5);
      eraser.lineTo(12, 18.5);
      eraser.lineTo(9, 18.5);
      eraser.closeSubpath();
      p.drawPath(eraser);
      line({{8.8, 9.8}, {14.8, 15.8}});
      line({{9, 18.5}, {19.5, 18.5}});
      break;
    }
    case Icon::library:
    case Icon::information: {
      p.drawRoundedRect(QRectF(3.5, 5, 17, 14), 2.2, 2.2);
      const double x = which == Icon::library ? 9.0 : 15.0;
      line({{x, 5}, {x, 19}});
      break;
    }
    case Icon::copy:
      p.drawRoundedRect(QRectF(8.5, 8.5, 11, 11), 1.8, 1.8);
      line({{5.5, 15.5}, {4.5, 15.5}, {4.5, 4.5}, {15.5, 4.5}, {15.5, 5.5}});
      break;
    case Icon::progress:
      line({{4, 4}, {4, 20}, {20, 20}});
      p.drawRect(QRectF(6.8, 13.5, 2.6, 6));
      p.drawRect(QRectF(11.6, 10, 2.6, 9.5));
      p.drawRect(QRectF(16.4, 5.5, 2.6, 14));
      break;
    case Icon::device:
      // A stylus at the end of a jointed arm.
      line({{4, 19.5}, {12, 19.5}});
      line({{8, 19.5}, {8, 9}, {16, 5}});
      line({{16, 5}, {20, 13.5}});
      p.drawEllipse(QPointF(8, 9), 1.6, 1.6);
      break;
    case Icon::reset_view: {
      QPainterPath turn;
      turn.arcMoveTo(QRectF(5, 5, 14, 14), 60);
      turn.arcTo(QRectF(5, 5, 14, 14), 60, 290);
      p.drawPath(turn);
      line({{15.6, 2.6}, {15.9, 6.3}, {12.2, 6.6}});
      break;
    }
    case Icon::search:
      p.drawEllipse(QPointF(10.5, 10.5), 5.6, 5.6);
      line({{14.8, 14.8}, {19.5, 19.5}});
      break;
    case Icon::tick:
      line({{5, 12.8}, {10, 17.6}, {19.2, 6.8}});
      break;
    case Icon::cross:
      line({{6.5, 6.5}, {17.5, 17.5}});
      line({{17.5, 6.5}, {6.5, 17.5}});
      break;
    case Icon::advice:
      line({{12, 4}, {21, 19.5}, {3, 19.5}, {12, 4}});
      line({{12, 10}, {12, 14}});
      p.drawPoint(QPointF(12, 16.8));
      break;
    case Icon::watch:
    case Icon::eye: {
      QPainterPath eye(QPointF(3, 12));
      eye.quadTo(QPointF(12, 3.5), QPointF(21, 12));
      eye.quadTo(QPointF(12, 20.5), QPointF(3, 12));
      p.drawPath(eye);
      p.drawEllipse(QPointF(12, 12), 2.8, 2.8);
      break;
    }
    case Icon::trace: {
      QPainterPath groove(QPointF(4, 18));
      groove.cubicTo(QPointF(8, 8), QPointF(12, 20), QPointF(15, 10));
      p.drawPath(groove);
      line({{15, 10}, {20, 3.5}});
      break;
    }
    case Icon::guided:
      p.drawEllipse(QPointF(6.5, 6.5), 2.6, 2.6);
      p.setPen(QPen(colour, 1.7, Qt::DotLine, Qt::RoundCap));
      line({{9, 9}, {19, 19}});
      break;
    case Icon::memory:
      p.drawRoundedRect(QRectF(4, 4, 16, 16), 2.2, 2.2);
      line({{12, 16}, {12, 16.2}});
      line({{9.4, 9.6}, {10.4, 8}, {13.4, 8}, {14.4, 9.6}, {12, 12.8}});
      break;
    case Icon::play:
      line({{8, 5.5}, {18.5, 12}, {8, 18.5}, {8, 5.5}});
      break;
    case Icon::slower:
      line({{5, 12}, {19, 12}});
      break;
    case Icon::faster:
      line({{5, 12}, {19, 12}});
      line({{12, 5}, {12, 19}});
      break;
    case Icon::loop: {
      QPainterPath round;
      round.arcMoveTo(QRectF(4.5, 6, 15, 12), 30);
      round.arcTo(QRectF(4.5, 6, 15, 12), 30, 300);
      p.drawPath(round);
      line({{20.6, 5.4}, {18.6, 9}, {15, 7.6}});
      break;
    }
    case Icon::undo: {
      line({{9, 4.5}, {4.5, 9}, {9, 13.5}});
      QPainterPath turn(QPointF(5, 9));
      turn.lineTo(14, 9);
      turn.cubicTo(QPointF(21.5, 9), QPointF(21.5, 19), QPointF(14, 19));
      turn.lineTo(10, 19);
      p.drawPath(turn);
      break;
    }
    case Icon::hint_lamp: {
      QPainterPath lamp;
      lamp.arcMoveTo(QRectF(6.5, 3.5, 11, 11), -55);
      lamp.arcTo(QRectF(6.5, 3.5, 11, 11), -55, 290);
      p.drawPath(lamp);
      line({{9.4, 14}, {9.4, 17}, {14.6, 17}, {14.6, 14}});
      line({{10.4, 20}, {13.6, 20}});
      break;
    }
    case Icon::overlaid:
      p.drawRoundedRect(QRectF(4, 4, 11.5, 11.5), 2, 2);
      p.drawRoundedRect(QRectF(8.5, 8.5, 11.5, 11.5), 2, 2);
      break;
    case Icon::beside:
      p.drawRoundedRect(QRectF(3, 6.5, 8, 11), 1.6, 1.6);
      p.drawRoundedRect(QRectF(13, 6.5, 8, 11), 1.6, 1.6);
      break;
    case Icon::pen:
      line({{4.5, 19.5}, {5.6, 14.8}, {15.8, 4.6}, {19.4, 8.2}, {9.2, 18.4}, {4.5, 19.5}});
      line({{13.4, 7}, {17, 10.6}});
      break;
    case Icon::home:
      line({{3.5, 11.5}, {12, 4}, {20.5, 11.5}});
      line({{6, 10}, {6, 19.5}, {18, 19.5}, {18, 10}});
      line({{10, 19.5}, {10, 14}, {14, 14}, {14, 19.5}});
      break;
    case Icon::hint:
      p.setBrush(colour);
      p.drawEllipse(QPointF(12, 12), 2.4, 2.4);
      break;
  }
}

class LineIcon final : public QIconEngine {
 public:
  LineIcon(Icon which, QColor ink, QColor on) : which_(which), ink_(std::move(ink)), on_(std::move(on)) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
    QColor colour = state == QIcon::On ? on_ : ink_;
    if (mode == QIcon::Disabled) colour.setAlphaF(0.38F);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->translate(rect.topLeft());
    painter->scale(rect.width() / 24.0, rect.height() / 24.0);
    draw(*painter, which_, colour);
    painter->restore();
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap picture(size);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    paint(&painter, QRect(QPoint(0, 0), size), mode, state);
    return picture;
  }

  [[nodiscard]] QIconEngine* clone() const override { return new LineIcon(which_, ink_, on_); }

 private:
  Icon which_;
  QColor ink_;
  QColor on_;
};

}  // namespace

QIcon icon(Icon which, const QColor& ink, const QColor& on) { return QIcon(new LineIcon(which, ink, on)); }

QPixmap sign(Icon which, const QColor& colour, int side, double device_pixel_ratio) {
  QPixmap picture(QSize(side, side) * device_pixel_ratio);
  picture.setDevicePixelRatio(device_pixel_ratio);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(side / 24.0, side / 24.0);
  draw(painter, which, colour);
  return picture;
}

QIcon program_icon() {
  QIcon icon;
  for (const int side : {16, 24, 32, 48, 64, 128, 256}) {
    QPixmap picture(side, side);
    picture.fill(Qt::transparent);
    QPainter p(&picture);
    p.setRenderHint(QPainter::Antialiasing);
    const QRectF tile =
        QRectF(0, 0, side, side).adjusted(side * 0.04, side * 0.04, -side * 0.04, -side * 0.04);
    QLinearGradient wood(tile.topLeft(), tile.bottomRight());
    wood.setColorAt(0, QColor(0xEFD9B0));
    wood.setColorAt(1, QColor(0xD9B97F));
    p.setPen(QPen(QColor(0xB08D55), side * 0.02));
    p.setBrush(wood);
    p.drawRoundedRect(tile, side * 0.17, side * 0.17);
    QFont font = textbook_font(10, QFont::DemiBold);
    font.setPixelSize(static_cast<int>(side * 0.72));
    p.setFont(font);
    p.setPen(QColor(0xFFF4DC));
    p.drawText(tile.translated(side * 0.012, side * 0.016), Qt::AlignCenter, QStringLiteral("な"));
    p.setPen(QColor(0x2A2018));
    p.drawText(tile, Qt::AlignCenter, QStringLiteral("な"));
    p.end();
    icon.addPixmap(picture);
  }
  return icon;
}

}  // namespace nazori::ui
