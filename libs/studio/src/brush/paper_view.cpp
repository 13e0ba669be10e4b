// SPDX-License-Identifier: Apache-2.0
// How the sheet is drawn.
#include "nazori/studio/brush/paper_view.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QGuiApplication>
#include <QPaintEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <utility>

#include "nazori/studio/brush/correction_marks.h"
#include "nazori/widgets/look/palette.h"

namespace nazori::ui {
namespace {

constexpr double kMargin_px = 14;
constexpr double kBesideShare = 0.5;  ///< side of the model beside the sheet over that of the sheet, at least
constexpr QColor kModelColour(242, 196, 182), kRuleColour(226, 178, 162), kModelInk(60, 52, 46);
constexpr int kDarkness = 84;  ///< of the sheet in the dark theme, of 255

/// Strokes as they are filled: a disc at each point and a band to the next one.
QPainterPath filled(const calligraphy::ModelStroke& stroke, const SheetPlace& place) {
  QPainterPath path;
  path.setFillRule(Qt::WindingFill);
  for (std::size_t i = 0; i < stroke.points.size(); ++i) {
    const QPointF at = place.to_widget(stroke.points[i]);
    const double r = stroke.half_width_m[i] * place.per_m();
    path.addEllipse(at, r, r);
    if (i == 0) continue;
    const QPointF before = place.to_widget(stroke.points[i - 1]);
    const double r0 = stroke.half_width_m[i - 1] * place.per_m();
    const QPointF way = at - before;
    const double length = std::hypot(way.x(), way.y());
    if (length < 1e-9) continue;
    const QPointF across = QPointF(-way.y(), way.x()) / length;
    QPolygonF band({before + across * r0, at + across * r, at - across * r, before - across * r0});
    // All parts turn the same way, so that none cuts a hole into another.
    QPainterPath part;
    part.addPolygon(band);
    part.closeSubpath();
    path.addPath(part);
  }
  return path;
}

void fill_model(QPainter& painter, const std::vector<calligraphy::ModelStroke>& strokes,
                const SheetPlace& place, const QColor& colour) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
  for (const auto& stroke : strokes) {
    for (std::size_t i = 0; i < stroke.points.size(); ++i) {
      const double r = stroke.half_width_m[i] * place.per_m();
      painter.drawEllipse(place.to_widget(stroke.points[i]), r, r);
    }
    painter.drawPath(filled(stroke, place));
  }
}

QAccessibleInterface* make_canvas(const QString& class_name, QObject* object) {
  if (class_name != QLatin1String(PaperView::staticMetaObject.className())) return nullptr;
  return new QAccessibleWidget(qobject_cast<QWidget*>(object), QAccessible::Canvas);
}

}  // namespace

PaperView::PaperView(QWidget* parent) : QWidget(parent) {
  QAccessible::installFactory(make_canvas);  // once, however often it is asked for
  setObjectName(QStringLiteral("paper_view"));
  setAccessibleName(tr("Sheet of paper"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAttribute(Qt::WA_AcceptTouchEvents);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  clock_.start();
}

void PaperView::set_picture_side(int side) {
  picture_ = QImage(side, side, QImage::Format_RGB32);
  picture_.fill(QColor(247, 244, 236));
  lay_out();
}

void PaperView::show_frame(const calligraphy::BrushFrame& frame) {
  QRect changed;
  constexpr int kSide = calligraphy::PictureTile::kSide;
  for (const auto& tile : frame.tiles) {
    if (tile.column + kSide > picture_.width() || tile.row + kSide > picture_.height()) continue;
    const std::uint8_t* from = tile.rgb.data();
    for (int y = 0; y < kSide; ++y) {
      auto* to = reinterpret_cast<QRgb*>(picture_.scanLine(tile.row + y)) + tile.column;
      for (int x = 0; x < kSide; ++x, from += 3) to[x] = qRgb(from[0], from[1], from[2]);
    }
    changed = changed.united(QRect(tile.column, tile.row, kSide, kSide));
  }
  if (!changed.isEmpty()) {
    draw_scaled(changed);
    const double per_cell = place_.rect.width() / picture_.width();
    update(QRectF(place_.rect.topLeft() + QPointF(changed.topLeft()) * per_cell,
                  QSizeF(changed.size()) * per_cell)
               .toAlignedRect()
               .adjusted(-2, -2, 2, 2));
  }
  brush_ = frame.brush;
  ink_ = colour_of_ink(frame.state.ink);
  update_brush();
}

void PaperView::show_model(std::vector<calligraphy::ModelStroke> strokes,
                           std::vector<calligraphy::RuledSquare> squares, ModelPlace place) {
  model_ = std::move(strokes);
  squares_ = std::move(squares);
  model_place_ = place;
  lay_out();
}

void PaperView::show_marks(std::vector<calligraphy::CorrectionMark> marks) {
  marks_ = std::move(marks);
  update();
}

void PaperView::set_left_hand(bool left) {
  left_hand_ = left;
  lay_out();
}

void PaperView::set_shows_brush(bool shows) {
  shows_brush_ = shows;
  update();
}

void PaperView::refresh_appearance() { lay_out(); }

void PaperView::lay_out() {
  const QRectF room = QRectF(rect()).adjusted(kMargin_px, kMargin_px, -kMargin_px, -kMargin_px);
  double side = std::min(room.width(), room.height());
  beside_ = {};
  if (model_place_ == ModelPlace::beside) {
    const double width = room.width() - kMargin_px;
    side = std::min(room.height(), width / (1 + kBesideShare));
    const double other = std::min(side, width - side);
    const double both = side + kMargin_px + other;
    const double from = room.left() + (room.width() - both) / 2;
    // The model stands where the writing hand does not cover it.
    const double top = room.top() + (room.height() - side) / 2;
    place_.rect = QRectF(left_hand_ ? from : from + other + kMargin_px, top, side, side);
    beside_ = QRectF(left_hand_ ? from + side + kMargin_px : from, top, other, other);
  } else {
    place_.rect = QRectF(room.center().x() - side / 2, room.center().y() - side / 2, side, side);
  }
  // Whole pixels, so that the parts of the picture meet without seams.
  place_.rect = QRectF(place_.rect.topLeft().toPoint(),
                       QSizeF(std::max(std::floor(side), 1.0), std::max(std::floor(side), 1.0)));
  const int pixels = std::max(static_cast<int>(place_.rect.width() * devicePixelRatioF()), 1);
  scaled_ = QImage(pixels, pixels, QImage::Format_RGB32);
  draw_scaled(picture_.rect());
  draw_guides();
  update();
}

/// Scales a part of the picture, so that a changed tile costs no more than itself.
void PaperView::draw_scaled(const QRect& pixels) {
  if (picture_.isNull() || scaled_.isNull()) return;
  const double scale = static_cast<double>(scaled_.width()) / picture_.width();
  const QRect to = QRectF(QPointF(pixels.topLeft()) * scale, QSizeF(pixels.size()) * scale)
                       .toAlignedRect()
                       .adjusted(-1, -1, 1, 1)
                       .intersected(scaled_.rect());
  // The source is a little larger than what is drawn: no edge is interpolated differently.
  const QRect wide = to.adjusted(-4, -4, 4, 4).intersected(scaled_.rect());
  QPainter painter(&scaled_);
  painter.setClipRect(to);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(QRectF(wide), picture_,
                    QRectF(QPointF(wide.topLeft()) / scale, QSizeF(wide.size()) / scale));
}

void PaperView::draw_guides() {
  guides_ = {};
  const bool beneath = model_place_ == ModelPlace::beneath && !model_.empty();
  if ((!beneath && squares_.empty()) || scaled_.isNull()) return;
  guides_ = QImage(scaled_.size(), QImage::Format_RGB32);
  guides_.fill(Qt::white);
  SheetPlace whole;
  whole.rect = guides_.rect();
  QPainter painter(&guides_);
  if (beneath) fill_model(painter, model_, whole, kModelColour);
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setBrush(Qt::NoBrush);
  const double width = std::max(1.0, devicePixelRatioF());
  for (const auto& square : squares_) {
    const QPointF middle = whole.to_widget(square.middle);
    const double half = square.side_m / 2 * whole.per_m();
    painter.setPen(QPen(kRuleColour, width * 1.5));
    painter.drawRect(QRectF(middle - QPointF(half, half), QSizeF(2 * half, 2 * half)));
    painter.setPen(QPen(kRuleColour, width, Qt::DashLine));
    painter.drawLine(middle - QPointF(half, 0), middle + QPointF(half, 0));
    painter.drawLine(middle - QPointF(0, half), middle + QPointF(0, half));
  }
}

void PaperView::paint_beside(QPainter& painter) const {
  const Colours& c = current_colours();
  painter.fillRect(beside_, c.surface);
  painter.setPen(QPen(c.line, 1));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(beside_);
  SheetPlace place;
  place.rect = beside_;
  fill_model(painter, model_, place, is_dark(QGuiApplication::palette()) ? c.ink : kModelInk);
}

void PaperView::paintEvent(QPaintEvent* event) {
  const Colours& c = current_colours();
  QPainter painter(this);
  painter.fillRect(event->rect(), c.paper);
  const QRectF sheet = place_.rect;
  painter.setPen(Qt::NoPen);
  for (const int spread : {5, 3, 1}) {
    painter.setBrush(QColor(0, 0, 0, 14));
    painter.drawRoundedRect(sheet.adjusted(-spread + 1, -spread + 2, spread + 1, spread + 2), 3, 3);
  }
  painter.drawImage(sheet, scaled_);
  if (!guides_.isNull()) {
    painter.setCompositionMode(QPainter::CompositionMode_Multiply);
    painter.drawImage(sheet, guides_);
    painter.setCompositionMode(QPainter::CompositionMode_SourceOver);
  }
  if (is_dark(QGuiApplication::palette())) painter.fillRect(sheet, QColor(0, 0, 0, kDarkness));
  paint_marks(painter, marks_, place_);
  if (!beside_.isEmpty()) paint_beside(painter);
  if (hasFocus()) {
    painter.setPen(QPen(c.indigo, 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(sheet.adjusted(-3, -3, 3, 3));
  }
  drawn_brush_ = {};
  if (shows_brush_ && cursor_ && (down_ || place_.rect.contains(*cursor_))) {
    drawn_brush_ = brush_bounds(brush_, *cursor_, place_.per_m());
    paint_brush(painter, brush_, ink_, *cursor_, place_.per_m(), left_hand_);
  }
}

void PaperView::update_brush() {
  if (!drawn_brush_.isEmpty()) update(drawn_brush_.toAlignedRect());
  if (shows_brush_ && cursor_) update(brush_bounds(brush_, *cursor_, place_.per_m()).toAlignedRect());
}

void PaperView::move_cursor(std::optional<QPointF> to) {
  cursor_ = to;
  const bool is_over = to && place_.rect.contains(*to);
  setCursor(is_over ? (shows_brush_ ? Qt::BlankCursor : Qt::CrossCursor) : Qt::ArrowCursor);
  update_brush();
}

void PaperView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  lay_out();
}

}  // namespace nazori::ui
