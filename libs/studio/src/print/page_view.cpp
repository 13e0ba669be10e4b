// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/print/page_view.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QFontInfo>
#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>
#include <algorithm>
#include <limits>

#include "nazori/widgets/look/palette.h"

namespace nazori::ui {
namespace {

constexpr int kEdge_px = 12;
constexpr int kWheelStep = 120;
constexpr double kDimmed = 0.18;  ///< so that the paper is no bright plate in a dark window

QPainterPath path_of(const print::PageMark& mark) {
  using Kind = print::PathStep::Kind;
  QPainterPath path;
  path.setFillRule(Qt::WindingFill);
  const auto at = [](print::PaperPoint p) { return QPointF(p.x, p.y); };
  for (const auto& step : mark.path) {
    switch (step.kind) {
      case Kind::move:
        path.moveTo(at(step.points[0]));
        break;
      case Kind::line:
        path.lineTo(at(step.points[0]));
        break;
      case Kind::curve:
        path.cubicTo(at(step.points[0]), at(step.points[1]), at(step.points[2]));
        break;
      case Kind::close:
        path.closeSubpath();
        break;
    }
  }
  return path;
}

QAccessibleInterface* make_picture(const QString& class_name, QObject* object) {
  if (class_name != QLatin1String(PageView::staticMetaObject.className())) return nullptr;
  return new QAccessibleWidget(qobject_cast<QWidget*>(object), QAccessible::Graphic);
}

}  // namespace

void paint_page(QPainter& painter, const print::PageDrawing& page, const QColor& paper) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(QRectF(0, 0, page.width_mm, page.height_mm), paper);
  for (const auto& mark : page.marks) {
    const QColor colour = blend(Qt::black, paper, mark.grey);
    if (mark.filled) {
      painter.fillPath(path_of(mark), colour);
      continue;
    }
    QPen pen(colour, mark.width_mm, Qt::SolidLine, mark.round ? Qt::RoundCap : Qt::FlatCap,
             mark.round ? Qt::RoundJoin : Qt::MiterJoin);
    if (mark.dash_mm > 0 && mark.width_mm > 0) {
      const double dash = mark.dash_mm / mark.width_mm;
      pen.setDashPattern({dash, dash});
    }
    painter.strokePath(path_of(mark), pen);
  }
  painter.restore();
}

PageView::PageView(QWidget* parent) : QWidget(parent) {
  QAccessible::installFactory(make_picture);  // once, however often it is asked for
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void PageView::show_page(std::shared_ptr<const print::PageDrawing> page, const QString& words) {
  page_ = std::move(page);
  setAccessibleDescription(words);
  update();
}

void PageView::clear() { show_page({}, {}); }

QRectF PageView::paper() const {
  if (!page_) return {};
  const QSizeF room = QSizeF(size()) - QSizeF(2 * kEdge_px, 2 * kEdge_px);
  const QSizeF fitted = QSizeF(page_->width_mm, page_->height_mm).scaled(room, Qt::KeepAspectRatio);
  return {QPointF((width() - fitted.width()) / 2, (height() - fitted.height()) / 2), fitted};
}

QSize PageView::sizeHint() const {
  const int em = QFontInfo(font()).pixelSize();
  return {em * 22, em * 28};
}

QSize PageView::minimumSizeHint() const { return {120, 120}; }

void PageView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const Colours& colours = current_colours();
  const bool dark = is_dark(palette());
  if (page_) {
    const QRectF place = paper();
    painter.save();
    painter.translate(place.topLeft());
    const double scale = place.width() / page_->width_mm;
    painter.scale(scale, scale);
    paint_page(painter, *page_, dark ? blend(Qt::white, Qt::black, kDimmed) : QColor(Qt::white));
    painter.restore();
    painter.setPen(QPen(colours.edge, 1));
    painter.drawRect(place.adjusted(-0.5, -0.5, 0.5, 0.5));
  }
  if (!hasFocus()) return;
  painter.setPen(QPen(colours.indigo, 2));
  painter.setBrush(Qt::NoBrush);
  painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
}

void PageView::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_PageDown:
      return emit turned(1);
    case Qt::Key_PageUp:
      return emit turned(-1);
    case Qt::Key_Home:
      return emit turned(std::numeric_limits<int>::min());
    case Qt::Key_End:
      return emit turned(std::numeric_limits<int>::max());
    default:
      QWidget::keyPressEvent(event);
  }
}

void PageView::wheelEvent(QWheelEvent* event) {
  wheel_ += event->angleDelta().y();
  const int steps = wheel_ / kWheelStep;
  wheel_ -= steps * kWheelStep;
  if (steps != 0) emit turned(-steps);
  event->accept();
}

}  // namespace nazori::ui
