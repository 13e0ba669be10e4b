// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/brush/correction_marks.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace nazori::ui {
namespace {

using Kind = calligraphy::CorrectionMark::Kind;

// On paper, so it is the same in light and dark windows.
constexpr QColor kVermilion(214, 58, 34), kWash(214, 58, 34, 40);
constexpr double kLine_m = 0.0006;
constexpr double kHead_m = 0.0026;

void paint_outline(QPainter& painter, const calligraphy::CorrectionMark& mark, const SheetPlace& place) {
  QPainterPath path;
  for (const auto& loop : mark.outline) {
    QPolygonF polygon;
    for (const auto at : loop) polygon.append(place.to_widget(at));
    path.addPolygon(polygon);
    path.closeSubpath();
  }
  painter.setBrush(kWash);
  painter.drawPath(path);
}

void paint_arrow(QPainter& painter, const calligraphy::CorrectionMark& mark, const SheetPlace& place) {
  const QPointF from = place.to_widget(mark.from), to = place.to_widget(mark.to);
  const QPointF way = to - from;
  const double length = std::hypot(way.x(), way.y());
  if (length < 1) return;
  const QPointF along = way / length, across(-along.y(), along.x());
  const double head = std::min(kHead_m * place.per_m(), length * 0.6);
  painter.setBrush(Qt::NoBrush);
  painter.drawLine(from, to);
  painter.drawPolyline(
      QPolygonF({to - along * head + across * head * 0.55, to, to - along * head - across * head * 0.55}));
}

}  // namespace

void paint_marks(QPainter& painter, std::span<const calligraphy::CorrectionMark> marks,
                 const SheetPlace& place) {
  if (marks.empty()) return;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setClipRect(place.rect);
  const double width = std::max(kLine_m * place.per_m(), 1.5);
  painter.setPen(QPen(kVermilion, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  for (const auto& mark : marks) {
    switch (mark.kind) {
      case Kind::outline:
        paint_outline(painter, mark, place);
        break;
      case Kind::arrow:
        paint_arrow(painter, mark, place);
        break;
      case Kind::circle: {
        const double r = mark.radius_m * place.per_m();
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(place.to_widget(mark.to), r, r);
        break;
      }
    }
  }
  painter.restore();
}

}  // namespace nazori::ui
