// SPDX-License-Identifier: Apache-2.0
#include "characters/drawing_pad.h"

#include <QMouseEvent>
#include <QPainter>
#include <QTabletEvent>
#include <algorithm>

#include "nazori/widgets/look/ink_painting.h"
#include "nazori/widgets/look/palette.h"

namespace nazori::ui {
namespace {

constexpr double kMousePressure = 0.6;
constexpr double kStep = 0.004;  ///< of the pad's side: nearer points are left out

}  // namespace

DrawingPad::DrawingPad(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("drawing_pad"));
  setAccessibleName(tr("Draw the character here"));
  setCursor(Qt::CrossCursor);
  setFocusPolicy(Qt::StrongFocus);
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
  ink_.box = writing::WritingBox{{0, 0}, 1};
  clock_.start();
}

void DrawingPad::undo() {
  if (ink_.strokes.empty()) return;
  ink_.strokes.pop_back();
  down_ = false;
  update();
  emit drawn();
}

void DrawingPad::clear() {
  ink_.strokes.clear();
  down_ = false;
  update();
  emit drawn();
}

void DrawingPad::add(QPointF at, double pressure) {
  auto& stroke = ink_.strokes.back();
  const double side = std::max(std::min(width(), height()), 1);
  const writing::WritingPoint point{at.x() / side, at.y() / side};
  if (!stroke.empty() && geometry::distance(stroke.back().at, point) < kStep) return;
  stroke.push_back({point, static_cast<double>(clock_.nsecsElapsed()) / 1e9, pressure});
  update();
  emit drawn();
}

void DrawingPad::begin(QPointF at, double pressure) {
  down_ = true;
  ink_.strokes.emplace_back();
  add(at, pressure);
}

void DrawingPad::go_on(QPointF at, double pressure) {
  if (down_) add(at, pressure);
}

void DrawingPad::finish() {
  if (!down_) return;
  down_ = false;
  // A tap without movement is not a stroke.
  if (ink_.strokes.back().size() < 2) ink_.strokes.pop_back();
  update();
  emit drawn();
}

void DrawingPad::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) begin(event->position(), kMousePressure);
}

void DrawingPad::mouseMoveEvent(QMouseEvent* event) { go_on(event->position(), kMousePressure); }

void DrawingPad::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) finish();
}

void DrawingPad::tabletEvent(QTabletEvent* event) {
  if (event->type() == QEvent::TabletPress) {
    if (event->pointerType() == QPointingDevice::PointerType::Eraser)
      undo();
    else
      begin(event->position(), event->pressure());
  } else if (event->type() == QEvent::TabletRelease) {
    finish();
  } else {
    go_on(event->position(), event->pressure());
  }
  event->accept();
}

void DrawingPad::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Colours& c = current_colours();
  const double side = std::min(width(), height());
  const QRectF box(1, 1, side - 2, side - 2);
  paint_paper(painter, box, 8, 7, QPen(hasFocus() ? c.indigo : c.line, hasFocus() ? 2 : 1));
  if (ink_.strokes.empty()) {
    painter.setPen(c.muted);
    const QRectF room = box.adjusted(16, 16, -16, -16);
    const int how = Qt::AlignCenter | Qt::TextWordWrap;
    const QString words = tr("Draw the character here");
    // With large text in a narrow panel the hint would be cut off. It is left out, because the feedback line
    // says it too.
    if (room.contains(painter.boundingRect(room, how, words))) painter.drawText(room, how, words);
  }
  for (const auto& stroke : ink_.strokes)
    for (std::size_t i = 1; i < stroke.size(); ++i) {
      const double pressure = stroke[i].pressure.value_or(0);
      painter.setPen(QPen(c.ink, side * (0.012 + 0.024 * pressure), Qt::SolidLine, Qt::RoundCap));
      painter.drawLine(QPointF(stroke[i - 1].at.x, stroke[i - 1].at.y) * side,
                       QPointF(stroke[i].at.x, stroke[i].at.y) * side);
    }
}

}  // namespace nazori::ui
