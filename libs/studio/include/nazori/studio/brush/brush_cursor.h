// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QPointF>
#include <QRectF>
#include <string_view>

#include "nazori/calligraphy/brush_writing.h"

class QPainter;

namespace nazori::ui {

/// How the sheet is drawn: where it is in the widget, and how large.
struct SheetPlace {
  QRectF rect;  ///< a square, in pixels of the widget

  [[nodiscard]] double per_m() const { return rect.width() / paint::Sheet::kSide_m; }
  [[nodiscard]] QPointF to_widget(geometry::PaperPoint at) const {
    return rect.center() + QPointF(at.x, -at.y) * per_m();
  }
  [[nodiscard]] geometry::PaperPoint to_paper(QPointF at) const {
    const QPointF from_centre = (at - rect.center()) / per_m();
    return {from_centre.x(), -from_centre.y()};
  }
};

/// The colour of an ink in the brush.
[[nodiscard]] QColor colour_of_ink(std::string_view ink);

/// The brush as it is seen from above at an angle: its hair as it is bent and spread, the shaft, and the
/// shadow of both on the paper.
/// @param ink  colour of its hair. @param pen  where it is now. @param left_hand  the shaft stands to the
/// left.
void paint_brush(QPainter& painter, const calligraphy::BrushShape& brush, const QColor& ink, QPointF pen,
                 double per_m, bool left_hand);
/// What paint_brush() covers at most.
[[nodiscard]] QRectF brush_bounds(const calligraphy::BrushShape& brush, QPointF pen, double per_m);

}  // namespace nazori::ui
