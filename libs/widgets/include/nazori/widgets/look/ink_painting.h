// SPDX-License-Identifier: Apache-2.0
// How writing and practice paper are painted in widgets.
#pragma once

#include <QPainterPath>
#include <QPen>
#include <span>

#include "nazori/geometry/written_stroke.h"

class QPainter;

namespace nazori::ui {

/// A sheet of practice paper: rounded corners and a dashed cross. @param gap  between the frame and the
/// cross.
void paint_paper(QPainter& painter, const QRectF& sheet, double corner, double gap, const QPen& frame);
/// Where a point of the tablet is on such a sheet, which shows the whole tablet.
[[nodiscard]] QPointF on_sheet(geometry::TabletPoint point, const QRectF& sheet);
/// Ink as wide as the pen pressed.
void paint_ink(QPainter& painter, std::span<const geometry::WrittenPoint<geometry::TabletFrame>> ink,
               const QColor& colour, const QRectF& sheet);

/// Handwriting as it was saved, in a square box that stands for the whole tablet.
/// @param pen  width of the ink, as a share of the side of the box.
void paint_handwriting(QPainter& painter, const geometry::WrittenStrokes<geometry::GlyphFrame>& ink,
                       const QRectF& box, const QColor& colour, double pen);

/// The path through points that have an x and a y.
template <class Points>
[[nodiscard]] QPainterPath path_through(const Points& points) {
  QPainterPath path;
  for (const auto& point : points)
    if (path.elementCount() == 0)
      path.moveTo(point.x, point.y);
    else
      path.lineTo(point.x, point.y);
  return path;
}

}  // namespace nazori::ui
