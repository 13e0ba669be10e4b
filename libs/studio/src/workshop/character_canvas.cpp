// SPDX-License-Identifier: Apache-2.0
// How the tablet is drawn.
#include "nazori/studio/workshop/character_canvas.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QPaintEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "nazori/author/stroke_edits.h"
#include "nazori/carving/groove.h"
#include "nazori/widgets/look/palette.h"

namespace nazori::ui {
namespace {

constexpr double kMargin_px = 14;
constexpr QColor kWood(214, 188, 150);
constexpr double kDigit = 8;   ///< height of the font of numbers [glyph units], as in KanjiVG's files
constexpr int kDarkness = 70;  ///< of the tablet in the dark theme, of 255

QAccessibleInterface* make_canvas(const QString& class_name, QObject* object) {
  if (class_name != QLatin1String(CharacterCanvas::staticMetaObject.className())) return nullptr;
  return new QAccessibleWidget(qobject_cast<QWidget*>(object), QAccessible::Canvas);
}

/// Colour of a sample: darker in the depth, with light from the upper left.
QRgb colour_at(const surface::HeightMap& map, int column, int row) {
  const int last = map.size() - 1;
  const float here = map.at(column, row);
  const float right = map.at(std::min(column + 1, last), row);
  const float below = map.at(column, std::min(row + 1, last));
  // A tablet is a tenth as deep as it is wide, and has map.size() samples a side.
  const float steepness = 0.1F * static_cast<float>(map.size());
  const float light = std::clamp((here - right + here - below) * steepness * -0.16F, -0.45F, 0.35F);
  const float shade = (0.62F + 0.38F * here) * (1.0F + light);
  const auto part = [shade](int of) {
    return static_cast<int>(std::clamp(static_cast<float>(of) * shade, 0.0F, 255.0F));
  };
  return qRgb(part(kWood.red()), part(kWood.green()), part(kWood.blue()));
}

}  // namespace

CharacterCanvas::CharacterCanvas(const author::Workbench& bench, QWidget* parent)
    : QWidget(parent), bench_(bench) {
  QAccessible::installFactory(make_canvas);  // once, however often it is asked for
  setObjectName(QStringLiteral("character_canvas"));
  setAccessibleName(tr("Tablet in the making"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAttribute(Qt::WA_AcceptTouchEvents);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setCursor(Qt::CrossCursor);
  clock_.start();
  refresh_relief(carving::whole_map(bench_.editor().map().size()));
  refresh();
}

void CharacterCanvas::refresh_relief(const carving::GridBox& box) {
  const auto& map = bench_.editor().map();
  carving::GridBox changed = box;
  if (relief_.width() != map.size()) {
    relief_ = QImage(map.size(), map.size(), QImage::Format_RGB32);
    changed = carving::whole_map(map.size());
  }
  // The light of a sample depends on its neighbours to the right and below.
  const int left = std::max(changed.left - 1, 0);
  const int top = std::max(changed.top - 1, 0);
  for (int row = top; row < changed.bottom; ++row) {
    auto* pixels = reinterpret_cast<QRgb*>(relief_.scanLine(row));
    for (int column = left; column < changed.right; ++column) pixels[column] = colour_at(map, column, row);
  }
  const double per_sample = place_.width() / map.size();
  update(QRectF(place_.topLeft() + QPointF(left, top) * per_sample,
                QSizeF(changed.right - left, changed.bottom - top) * per_sample)
             .toAlignedRect()
             .adjusted(-2, -2, 2, 2));
}

void CharacterCanvas::refresh() {
  lines_.clear();
  const auto& strokes = bench_.character().strokes;
  lines_.reserve(strokes.size());
  for (const auto& stroke : strokes) {
    QPolygonF line;
    for (const auto& point : carving::smooth_line(stroke.points)) line.append({point.at.x, point.at.y});
    lines_.push_back(std::move(line));
  }
  numbers_ = author::number_places(strokes);
  update();
}

void CharacterCanvas::refresh_appearance() { update(); }

void CharacterCanvas::set_shows_strokes(bool shows) {
  shows_strokes_ = shows;
  update();
}

void CharacterCanvas::lay_out() {
  const QRectF room = QRectF(rect()).adjusted(kMargin_px, kMargin_px, -kMargin_px, -kMargin_px);
  const double side = std::max(std::min(room.width(), room.height()), 1.0) * zoom_;
  const QPointF middle = room.center();
  place_ = QRectF(middle - centre_ / geometry::kGlyphSide * side, QSizeF(side, side));
  update();
}

void CharacterCanvas::zoom(double factor, std::optional<QPointF> around) {
  const QPointF fixed = around.value_or(QRectF(rect()).center());
  const auto before = to_glyph(fixed);
  zoom_ = std::clamp(zoom_ * factor, 1.0, kLargestZoom);
  lay_out();
  const auto after = to_glyph(fixed);
  centre_ += QPointF(before.x - after.x, before.y - after.y);
  // What is shown stays on the tablet.
  const double half = geometry::kGlyphSide / 2 / zoom_;
  centre_.setX(std::clamp(centre_.x(), half, geometry::kGlyphSide - half));
  centre_.setY(std::clamp(centre_.y(), half, geometry::kGlyphSide - half));
  lay_out();
}

void CharacterCanvas::show_whole() {
  zoom_ = 1;
  centre_ = {geometry::kGlyphSide / 2, geometry::kGlyphSide / 2};
  lay_out();
}

QPointF CharacterCanvas::to_widget(geometry::GlyphPoint at) const {
  return place_.topLeft() + QPointF(at.x, at.y) * (place_.width() / geometry::kGlyphSide);
}

geometry::GlyphPoint CharacterCanvas::to_glyph(QPointF at) const {
  const QPointF p = (at - place_.topLeft()) * (geometry::kGlyphSide / place_.width());
  return {p.x(), p.y()};
}

void CharacterCanvas::paintEvent(QPaintEvent* event) {
  const Colours& c = current_colours();
  QPainter painter(this);
  painter.fillRect(event->rect(), c.paper);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  // Only the part that changed is scaled.
  const QRectF shown = QRectF(event->rect().adjusted(-2, -2, 2, 2)).intersected(place_);
  if (!shown.isEmpty()) {
    const double samples = relief_.width() / place_.width();
    painter.drawImage(shown, relief_,
                      QRectF((shown.topLeft() - place_.topLeft()) * samples, shown.size() * samples));
    if (is_dark(palette())) painter.fillRect(shown, QColor(0, 0, 0, kDarkness));
  }
  painter.setRenderHint(QPainter::Antialiasing);
  if (shows_strokes_) paint_strokes(painter);
  paint_under_way(painter);
  if (!hasFocus()) return;
  painter.setPen(QPen(c.indigo, 2));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(place_.intersected(QRectF(rect())).adjusted(-3, -3, 3, 3));
}

void CharacterCanvas::paint_strokes(QPainter& painter) const {
  for (std::size_t i = 0; i < lines_.size(); ++i)
    if (i != bench_.selection().stroke) paint_stroke(painter, i);
  if (bench_.selection().stroke) paint_stroke(painter, *bench_.selection().stroke);
}

void CharacterCanvas::paint_stroke(QPainter& painter, std::size_t number) const {
  const Colours& c = current_colours();
  const bool chosen = number == bench_.selection().stroke;
  const QColor colour = chosen ? light_colours().vermilion : light_colours().indigo;
  QPolygonF line;
  for (const QPointF& p : lines_[number]) line.append(to_widget({p.x(), p.y()}));
  // A pale rim keeps the line apart from the dark of a groove.
  painter.setBrush(Qt::NoBrush);
  painter.setPen(
      QPen(QColor(255, 255, 255, 170), chosen ? 5 : 3.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolyline(line);
  painter.setPen(QPen(colour, chosen ? 2.5 : 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolyline(line);
  painter.setBrush(colour);
  painter.drawEllipse(line.front(), 4, 4);
  // The arrow at the end shows the direction.
  const QPointF way = line.back() - line[std::max<qsizetype>(line.size() - 4, 0)];
  if (const double length = std::hypot(way.x(), way.y()); length > 1) {
    const QPointF along = way / length * 9;
    const QPointF across(-along.y() / 2, along.x() / 2);
    painter.drawPolyline(
        QPolygonF({line.back() - along + across, line.back(), line.back() - along - across}));
  }
  const auto& stroke = bench_.character().strokes[number];
  if (chosen) {
    for (std::size_t i = 0; i < stroke.points.size(); ++i) {
      const QPointF at = to_widget(stroke.points[i].at);
      const double half = i == bench_.selection().point ? 6 : 3.5;
      painter.setBrush(i == bench_.selection().point ? colour : QColor(Qt::white));
      painter.drawRect(QRectF(at - QPointF(half, half), QSizeF(2 * half, 2 * half)));
    }
  }
  if (number >= numbers_.size()) return;
  if (chosen && bench_.selection().number) {
    const auto box = author::number_box(number + 1, numbers_[number]);
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(
        QRectF(to_widget({box.left, box.top}), to_widget({box.right, box.bottom})).adjusted(-2, -2, 2, 2));
  }
  QFont font = painter.font();
  font.setPixelSize(std::max(static_cast<int>(kDigit * place_.width() / geometry::kGlyphSide), 9));
  font.setBold(chosen);
  painter.setFont(font);
  painter.setPen(is_dark(palette()) ? c.ink : colour);
  painter.drawText(to_widget(numbers_[number]), QString::number(number + 1));
}

void CharacterCanvas::paint_under_way(QPainter& painter) const {
  const QColor colour = light_colours().vermilion;
  const double per_unit = place_.width() / geometry::kGlyphSide;
  const auto& settings = bench_.settings();
  if (const auto& movement = bench_.movement(); !movement.empty()) {
    QPolygonF line;
    for (const auto& point : movement) line.append(to_widget(point.at));
    if (settings.straight && line.size() > 2) line = QPolygonF({line.front(), line.back()});
    QColor pale = colour;
    pale.setAlphaF(0.45F);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(pale, settings.width * per_unit, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    line.size() == 1 ? painter.drawPoint(line.front()) : painter.drawPolyline(line);
  }
  if (const auto& placed = bench_.placed(); !placed.empty()) {
    QPolygonF line;
    for (const auto& at : placed) line.append(to_widget(at));
    painter.setPen(QPen(colour, 2, Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(line);
    painter.setPen(QPen(colour, 2));
    painter.setBrush(Qt::white);
    for (const QPointF& at : line) painter.drawEllipse(at, 4, 4);
  }
  if (!hasFocus()) return;
  const QPointF at = to_widget(bench_.cursor());
  painter.setPen(QPen(bench_.is_down() ? colour : light_colours().ink, 1.5));
  painter.drawLine(at - QPointF(7, 0), at + QPointF(7, 0));
  painter.drawLine(at - QPointF(0, 7), at + QPointF(0, 7));
}

void CharacterCanvas::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  lay_out();
}

}  // namespace nazori::ui
