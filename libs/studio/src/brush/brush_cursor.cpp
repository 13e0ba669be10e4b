// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/brush/brush_cursor.h"

#include <QLinearGradient>
#include <QPainter>
#include <QPainterPath>
#include <array>
#include <cmath>
#include <vector>

namespace nazori::ui {
namespace {

// How far one metre of height moves a point on the screen: the brush is seen from the writer's side.
constexpr QPointF kRise(0.20, -0.42);
// The light comes from the upper left, as on the tablet.
constexpr QPointF kShade(0.16, 0.10);
constexpr double kShaft_m = 0.075;  ///< length that is drawn; it fades out
constexpr double kHairLines = 9;
constexpr QColor kHairColour(58, 46, 38);
constexpr QColor kBamboo(196, 160, 104), kBambooEdge(128, 96, 54);

/// The hair as a ribbon on the screen.
struct Ribbon {
  std::vector<QPointF> left, middle, right;

  [[nodiscard]] QPainterPath outline() const {
    QPainterPath path(left.front());
    for (const auto& p : left) path.lineTo(p);
    for (auto p = right.rbegin(); p != right.rend(); ++p) path.lineTo(*p);
    path.closeSubpath();
    return path;
  }
};

/// From the pen to a section on the paper, as on the screen [m].
QPointF flat_offset(const calligraphy::BrushShape& brush, const brush::TuftSection& section) {
  return {section.at.x - brush.pen.x, -(section.at.y - brush.pen.y)};
}

/// @param lift  what one metre of height moves a point.
Ribbon ribbon_of(const calligraphy::BrushShape& brush, QPointF pen, double per_m, QPointF lift) {
  Ribbon ribbon;
  const auto& sections = brush.sections;
  // In the air the tip is above the pen, however the hair is bent from the last stroke.
  if (!brush.touches) pen -= flat_offset(brush, sections.back()) * per_m;
  for (const auto& section : sections) {
    ribbon.middle.push_back(pen + (flat_offset(brush, section) + lift * section.z_m) * per_m);
  }
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const QPointF along =
        ribbon.middle[std::min(i + 1, sections.size() - 1)] - ribbon.middle[i > 0 ? i - 1 : 0];
    const double length = std::max(std::hypot(along.x(), along.y()), 1e-6);
    const QPointF across = QPointF(-along.y(), along.x()) / length * (sections[i].half_width_m * per_m);
    ribbon.left.push_back(ribbon.middle[i] + across);
    ribbon.right.push_back(ribbon.middle[i] - across);
  }
  return ribbon;
}

QPointF rise(bool left_hand) { return left_hand ? QPointF(-kRise.x(), kRise.y()) : kRise; }

}  // namespace

QColor colour_of_ink(std::string_view ink) {
  if (ink == "vermilion") return {196, 62, 38};
  if (ink == "sumi-blue") return {24, 30, 46};
  if (ink == "sumi-brown") return {48, 34, 24};
  if (ink == "water") return {120, 108, 98};
  return {28, 26, 25};
}

void paint_brush(QPainter& painter, const calligraphy::BrushShape& brush, const QColor& ink, QPointF pen,
                 double per_m, bool left_hand) {
  if (brush.sections.size() < 2) return;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  const Ribbon hair = ribbon_of(brush, pen, per_m, rise(left_hand));
  const Ribbon shadow = ribbon_of(brush, pen, per_m, kShade);
  const double root_px = std::max(brush.sections.front().half_width_m * per_m, 1.0);

  // The shadow is softer and paler the higher the part is above the paper.
  for (const int width : {6, 3, 0}) {
    painter.setPen(width > 0 ? QPen(QColor(30, 20, 10, 16), width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin)
                             : QPen(Qt::NoPen));
    painter.setBrush(QColor(30, 20, 10, 26));
    painter.drawPath(shadow.outline());
  }

  const QPointF root = hair.middle.front();
  const QPointF up = rise(left_hand) * per_m;
  const double up_length = std::max(std::hypot(up.x(), up.y()), 1e-6);
  const QPointF side = QPointF(-up.y(), up.x()) / up_length * (brush.shaft_m / 2 * per_m);
  const QPointF end = root + up * kShaft_m;
  QLinearGradient bamboo(root, end);
  const auto faded = [](QColor colour, int alpha) {
    colour.setAlpha(alpha);
    return colour;
  };
  bamboo.setColorAt(0, faded(kBambooEdge, 225));
  bamboo.setColorAt(0.12, faded(kBamboo, 215));
  bamboo.setColorAt(1, faded(kBamboo, 0));
  painter.setPen(Qt::NoPen);

  QLinearGradient wet(root, hair.middle.back());
  wet.setColorAt(0, kHairColour);
  wet.setColorAt(0.35, ink.darker(120));
  wet.setColorAt(1, ink.darker(150));
  painter.setBrush(wet);
  painter.drawPath(hair.outline());
  // Round where the hair comes out of the shaft.
  painter.drawEllipse(root, root_px, root_px * 0.75);

  painter.setPen(QPen(QColor(150, 130, 112, 90), std::max(root_px * 0.05, 0.6)));
  painter.setBrush(Qt::NoBrush);
  for (int line = 1; line < static_cast<int>(kHairLines); ++line) {
    const double t = line / kHairLines;
    QPainterPath bristle;
    for (std::size_t i = 0; i + 1 < hair.middle.size(); ++i) {
      const QPointF at = hair.left[i] + (hair.right[i] - hair.left[i]) * t;
      if (i == 0)
        bristle.moveTo(at);
      else
        bristle.lineTo(at);
    }
    painter.drawPath(bristle);
  }

  painter.setPen(Qt::NoPen);
  painter.setBrush(bamboo);
  painter.drawPolygon(QPolygonF({root + side, root - side, end - side * 0.8, end + side * 0.8}));
  painter.restore();
}

QRectF brush_bounds(const calligraphy::BrushShape& brush, QPointF pen, double per_m) {
  QRectF bounds(pen, QSizeF(1, 1));
  double width = brush.shaft_m;
  if (!brush.touches && !brush.sections.empty()) pen -= flat_offset(brush, brush.sections.back()) * per_m;
  for (const auto& section : brush.sections) {
    const QPointF flat = flat_offset(brush, section);
    width = std::max(width, section.half_width_m);
    const QPointF rises[] = {kRise, {-kRise.x(), kRise.y()}, kShade};
    for (const QPointF& lift : rises)
      for (const double z : {section.z_m, section.z_m + kShaft_m})
        bounds = bounds.united(QRectF(pen + (flat + lift * z) * per_m, QSizeF(1, 1)));
  }
  const double room = width * per_m + 8;
  return bounds.adjusted(-room, -room, room, room);
}

}  // namespace nazori::ui
