// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/look/icons.h"

#include <QIconEngine>
#include <QMetaEnum>
#include <QPainter>
#include <QSvgRenderer>
#include <map>
#include <memory>

#include "nazori/widgets/look/resources.h"

namespace nazori::ui {
namespace {

/// "eye": the enumerator's own name.
QString file_of(Icon which) {
  // Watching is drawn as an eye too.
  if (which == Icon::watch) which = Icon::eye;
  return QStringLiteral("icons/%1.svg")
      .arg(QLatin1String(QMetaEnum::fromType<Icon>().valueToKey(static_cast<int>(which))));
}

/// A drawing in one colour; each is parsed once. Thread: interface.
QSvgRenderer& drawing(Icon which, const QColor& colour) {
  static std::map<std::pair<Icon, QRgb>, std::unique_ptr<QSvgRenderer>> parsed;
  auto& drawn = parsed[{which, colour.rgb()}];
  if (!drawn) {
    QByteArray svg = read_resource(file_of(which));
    svg.replace("currentColor", colour.name().toLatin1());
    drawn = std::make_unique<QSvgRenderer>(svg);
  }
  return *drawn;
}

void draw(QPainter& painter, Icon which, const QColor& colour, const QRectF& area) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setOpacity(painter.opacity() * colour.alphaF());
  drawing(which, colour).render(&painter, area);
  painter.restore();
}

class LineIcon final : public QIconEngine {
 public:
  LineIcon(Icon which, QColor ink, QColor on) : which_(which), ink_(std::move(ink)), on_(std::move(on)) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
    QColor colour = state == QIcon::On ? on_ : ink_;
    if (mode == QIcon::Disabled) colour.setAlphaF(0.38F);
    draw(*painter, which_, colour, rect);
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
  draw(painter, which, colour, QRectF(0, 0, side, side));
  return picture;
}

QIcon program_icon() {
  QSvgRenderer drawing(read_resource(QStringLiteral("nazori.svg")));
  QIcon icon;
  for (const int side : {16, 24, 32, 48, 64, 128, 256}) {
    QPixmap picture(side, side);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    drawing.render(&painter);
    painter.end();
    icon.addPixmap(picture);
  }
  return icon;
}

}  // namespace nazori::ui
