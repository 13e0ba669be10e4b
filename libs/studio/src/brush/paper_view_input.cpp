// SPDX-License-Identifier: Apache-2.0
// Mouse, pen and fingers on the sheet.
#include <QMouseEvent>
#include <QTabletEvent>
#include <QTouchEvent>
#include <algorithm>
#include <numbers>
#include <utility>

#include "nazori/studio/brush/paper_view.h"

namespace nazori::ui {
double PaperView::pen_clock_s() const {
  return static_cast<double>(clock_begins_ms_ + clock_.elapsed()) / 1000;
}

double PaperView::seconds_of(std::uint64_t event_ms) {
  if (event_ms == 0) return pen_clock_s();
  // What has no time of its own is on the same clock.
  clock_begins_ms_ = static_cast<qint64>(event_ms) - clock_.elapsed();
  return static_cast<double>(event_ms) / 1000;
}

void PaperView::write(QPointF at, bool down, double time_s, const calligraphy::HolderTilt& tilt,
                      std::optional<double> pressure, double twist_rad) {
  const bool was_down = std::exchange(down_, down);
  move_cursor(at);
  // Above the paper only the picture of the brush moves.
  if (!down && !was_down) return;
  brush::PenSample sample;
  sample.time_s = time_s;
  sample.at = place_.to_paper(at);
  sample.down = down;
  sample.pressure = pressure;
  sample.lean_rad = tilt.lean_rad;
  sample.lean_to_rad = tilt.lean_to_rad;
  sample.twist_rad = twist_rad;
  emit pen_moved(sample);
}

void PaperView::move_brush(geometry::PaperPoint at, bool down, double pressure) {
  constexpr double kCalm_m_s = 0.06;
  const double way = geometry::distance(std::exchange(moved_to_, at), at);
  moved_s_ = std::max(pen_clock_s(), moved_s_ + way / kCalm_m_s);
  write(place_.to_widget(at), down, moved_s_, calligraphy::assumed_tilt(left_hand_), pressure);
}

void PaperView::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && place_.rect.contains(event->position()))
    write(event->position(), true, seconds_of(event->timestamp()), calligraphy::assumed_tilt(left_hand_));
}

void PaperView::mouseMoveEvent(QMouseEvent* event) {
  write(event->position(), down_, seconds_of(event->timestamp()), calligraphy::assumed_tilt(left_hand_));
}

void PaperView::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton)
    write(event->position(), false, seconds_of(event->timestamp()), calligraphy::assumed_tilt(left_hand_));
}

void PaperView::tabletEvent(QTabletEvent* event) {
  event->accept();
  finger_.note_pen();
  // Qt's left button is the tip. Buttons on the barrel do nothing here.
  const bool is_tip = event->button() == Qt::LeftButton;
  const bool is_eraser = event->pointerType() == QPointingDevice::PointerType::Eraser;
  if (is_eraser) {
    if (is_tip && event->type() == QEvent::TabletPress) emit eraser_used();
    return;
  }
  bool down = down_;
  if (is_tip && event->type() == QEvent::TabletPress) down = place_.rect.contains(event->position());
  if (is_tip && event->type() == QEvent::TabletRelease) down = false;
  const auto has = [event](QInputDevice::Capability what) {
    return event->pointingDevice()->hasCapability(what);
  };
  const auto tilt = has(QInputDevice::Capability::XTilt)
                        ? calligraphy::holder_tilt(event->xTilt(), event->yTilt(), left_hand_)
                        : calligraphy::assumed_tilt(left_hand_);
  // Qt counts the rotation clockwise.
  const double turned =
      has(QInputDevice::Capability::Rotation) ? event->rotation() * std::numbers::pi / 180 : 0;
  std::optional<double> pressure;
  if (has(QInputDevice::Capability::Pressure)) pressure = event->pressure();
  write(event->position(), down, seconds_of(event->timestamp()), tilt, pressure,
        left_hand_ ? turned : -turned);
}

void PaperView::touch(const QTouchEvent& event) {
  const auto move = finger_.take(
      event, [this](QPointF at) { return place_.rect.contains(at); },
      [this] {
        down_ = false;
        emit pen_lost();
      });
  if (move) write(move->at, move->down, seconds_of(event.timestamp()), calligraphy::assumed_tilt(left_hand_));
}

bool PaperView::event(QEvent* event) {
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

void PaperView::leaveEvent(QEvent* event) {
  if (!down_) move_cursor({});
  QWidget::leaveEvent(event);
}

void PaperView::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  update();
}

void PaperView::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  update();
}

}  // namespace nazori::ui
