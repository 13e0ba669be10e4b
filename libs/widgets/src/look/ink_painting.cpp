// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/look/ink_painting.h"

#include <QPainter>
#include <algorithm>

#include "nazori/geometry/frames.h"
#include "nazori/view/inked_stroke.h"
#include "nazori/widgets/look/palette.h"

namespace nazori::ui {
namespace {

constexpr double kTabletSide_m = geometry::TabletShape{}.width_m;

}  // namespace

void paint_paper(QPainter& painter, const QRectF& sheet, double corner, double gap, const QPen& frame) {
  const Colours& c = current_colours();
  painter.setPen(frame);
  painter.setBrush(c.surface);
  painter.drawRoundedRect(sheet, corner, corner);
  painter.setPen(QPen(c.line, 1, Qt::DashLine));
  const QPointF middle = sheet.center();
  painter.drawLine(QPointF(middle.x(), sheet.top() + gap), QPointF(middle.x(), sheet.bottom() - gap));
  painter.drawLine(QPointF(sheet.left() + gap, middle.y()), QPointF(sheet.right() - gap, middle.y()));
}

QPointF on_sheet(geometry::TabletPoint point, const QRectF& sheet) {
  return {sheet.center().x() + point.x / kTabletSide_m * sheet.width(),
          sheet.center().y() - point.y / kTabletSide_m * sheet.height()};
}

void paint_ink(QPainter& painter, std::span<const geometry::WrittenPoint<geometry::TabletFrame>> ink,
               const QColor& colour, const QRectF& sheet) {
  const double per_m = sheet.width() / kTabletSide_m;
  for (std::size_t k = 1; k < ink.size(); ++k) {
    painter.setPen(QPen(colour, std::max(2 * per_m * view::ink_half_width_m(ink[k]), 1.5), Qt::SolidLine,
                        Qt::RoundCap, Qt::RoundJoin));
    painter.drawLine(on_sheet(ink[k - 1].at, sheet), on_sheet(ink[k].at, sheet));
  }
}

void paint_handwriting(QPainter& painter, const geometry::WrittenStrokes<geometry::GlyphFrame>& ink,
                       const QRectF& box, const QColor& colour, double pen) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colour, std::max(box.width() * pen, 1.5), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  const double scale = box.width() / geometry::kGlyphSide;
  const QTransform to_box = QTransform::fromTranslate(box.left(), box.top()).scale(scale, scale);
  for (const auto& stroke : ink) painter.drawPath(to_box.map(path_through(geometry::line_of(stroke))));
}

}  // namespace nazori::ui
