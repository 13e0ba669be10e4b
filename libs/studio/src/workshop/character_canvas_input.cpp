// SPDX-License-Identifier: Apache-2.0
// Mouse, pen, fingers and keys on the tablet in the making.
#include <QKeyEvent>
#include <QMouseEvent>
#include <QTabletEvent>
#include <QTouchEvent>
#include <QWheelEvent>
#include <cmath>
#include <utility>

#include "nazori/studio/workshop/character_canvas.h"

namespace nazori::ui {
namespace {

constexpr double kKeyStep = 1;  ///< of an arrow key [glyph units]
constexpr double kFineStep = 0.2;
constexpr double kWheelZoom = 1.2;  ///< of one notch

}  // namespace

void CharacterCanvas::send(QPointF at, bool down, std::uint64_t event_ms, std::optional<double> pressure) {
  const bool was_down = std::exchange(down_, down);
  if (!down && !was_down) return;
  geometry::WrittenPoint<geometry::GlyphFrame> pen;
  pen.at = to_glyph(at);
  pen.time_s =
      static_cast<double>(event_ms != 0 ? event_ms : static_cast<std::uint64_t>(clock_.elapsed())) / 1000;
  pen.pressure = pressure;
  emit pen_moved(pen, down);
}

void CharacterCanvas::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::MiddleButton) panned_from_ = event->position();
  if (event->button() == Qt::LeftButton && place_.contains(event->position()))
    send(event->position(), true, event->timestamp());
}

void CharacterCanvas::mouseMoveEvent(QMouseEvent* event) {
  if (panned_from_) {
    const QPointF by = (event->position() - *panned_from_) * (geometry::kGlyphSide / place_.width());
    centre_ -= by;
    panned_from_ = event->position();
    lay_out();
    zoom(1);  // what is shown stays on the tablet
    return;
  }
  send(event->position(), down_, event->timestamp());
}

void CharacterCanvas::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::MiddleButton) panned_from_.reset();
  if (event->button() == Qt::LeftButton) send(event->position(), false, event->timestamp());
}

void CharacterCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) emit double_clicked(to_glyph(event->position()));
}

void CharacterCanvas::tabletEvent(QTabletEvent* event) {
  event->accept();
  finger_.note_pen();
  // Qt's left button is the tip. Buttons on the barrel do nothing here.
  const bool is_tip = event->button() == Qt::LeftButton;
  bool down = down_;
  if (is_tip && event->type() == QEvent::TabletPress) down = place_.contains(event->position());
  if (is_tip && event->type() == QEvent::TabletRelease) down = false;
  std::optional<double> pressure;
  if (event->pointingDevice()->hasCapability(QInputDevice::Capability::Pressure))
    pressure = event->pressure();
  send(event->position(), down, event->timestamp(), pressure);
}

void CharacterCanvas::touch(const QTouchEvent& event) {
  const auto move = finger_.take(
      event, [this](QPointF at) { return place_.contains(at); },
      [this] {
        down_ = false;
        emit pen_lost();
      });
  if (move) send(move->at, move->down, event.timestamp());
}

bool CharacterCanvas::event(QEvent* event) {
  switch (event->type()) {
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
    case QEvent::TouchCancel:
      // Accepted, otherwise Qt would make mouse events of a palm.
      event->accept();
      touch(static_cast<QTouchEvent&>(*event));
      return true;
    default:
      return QWidget::event(event);
  }
}

void CharacterCanvas::wheelEvent(QWheelEvent* event) {
  constexpr double kNotch = 120;
  zoom(std::pow(kWheelZoom, event->angleDelta().y() / kNotch), event->position());
  event->accept();
}

void CharacterCanvas::keyPressEvent(QKeyEvent* event) {
  const auto modifiers = event->modifiers() & ~Qt::KeypadModifier;
  const double step = modifiers == Qt::ShiftModifier ? kFineStep : kKeyStep;
  if (modifiers == Qt::NoModifier || modifiers == Qt::ShiftModifier) {
    switch (event->key()) {
      case Qt::Key_Left:
        return emit moved_by_key({-step, 0});
      case Qt::Key_Right:
        return emit moved_by_key({step, 0});
      case Qt::Key_Up:
        return emit moved_by_key({0, -step});
      case Qt::Key_Down:
        return emit moved_by_key({0, step});
      case Qt::Key_Space:
        return emit pressed_by_key(static_cast<double>(clock_.elapsed()) / 1000);
      default:
        break;
    }
  }
  QWidget::keyPressEvent(event);
}

void CharacterCanvas::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  update();
}

void CharacterCanvas::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  update();
}

}  // namespace nazori::ui
