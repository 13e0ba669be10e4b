// SPDX-License-Identifier: Apache-2.0
// Mouse, pen, fingers, keys and dropped files on the tablet.
#include <QDropEvent>
#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QTabletEvent>
#include <QTouchEvent>
#include <QWheelEvent>
#include <cmath>

#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/tablet/tablet_window.h"

namespace nazori::ui {
namespace {

constexpr int kPenGone_ms = 500;  ///< the palm leaves the tablet this long after the pen

}  // namespace

void TabletWindow::begin_drag(Drag drag, QPointF position) {
  glide_.stop();
  drag_ = drag;
  drag_from_ = position;
}

void TabletWindow::drag_camera(QPointF to) {
  set_camera(drag_ == Drag::orbit ? turned(to - drag_from_) : panned(drag_from_, to));
  drag_from_ = to;
}

void TabletWindow::point_stylus(QPointF position, bool pressed, std::optional<double> pressure,
                                quint64 event_ms) {
  since_move_.restart();
  std::optional<double> event_s;
  if (event_ms != 0) event_s = static_cast<double>(event_ms) / 1000;
  if (const auto at = point_under(position)) controller_->move_stylus(*at, pressed, pressure, event_s);
  // Over the tablet the drawn stylus replaces the mouse pointer. The two would never be at the same point.
  const bool hide = controller_->device().is_pointer() && controller_->draws_stylus();
  if (hide != (cursor().shape() == Qt::BlankCursor)) setCursor(hide ? Qt::BlankCursor : Qt::ArrowCursor);
}

void TabletWindow::mousePressEvent(QMouseEvent* event) {
  controller_->lean_stylus({});
  if (drag_ != Drag::none) return;
  const QPointF at = event->position();
  if (event->button() == Qt::LeftButton) {
    begin_drag(Drag::stylus, at);
    point_stylus(at, true, {}, event->timestamp());
  } else if (event->button() == Qt::MiddleButton ||
             (event->button() == Qt::RightButton && event->modifiers().testFlag(Qt::ShiftModifier))) {
    begin_drag(Drag::pan, at);
  } else if (event->button() == Qt::RightButton) {
    begin_drag(Drag::orbit, at);
  }
}

void TabletWindow::mouseMoveEvent(QMouseEvent* event) {
  if (drag_ == Drag::orbit || drag_ == Drag::pan)
    drag_camera(event->position());
  else
    point_stylus(event->position(), drag_ == Drag::stylus, {}, event->timestamp());
}

void TabletWindow::mouseReleaseEvent(QMouseEvent* event) {
  const bool ends = (drag_ == Drag::stylus && event->button() == Qt::LeftButton) ||
                    (drag_ == Drag::orbit && event->button() == Qt::RightButton) ||
                    (drag_ == Drag::pan && event->button() != Qt::LeftButton);
  if (!ends) return;
  drag_ = Drag::none;
  point_stylus(event->position(), false, {}, event->timestamp());
}

void TabletWindow::tabletEvent(QTabletEvent* event) {
  since_pen_.start();
  const QPointF at = event->position();
  if (event->pointingDevice()->hasCapability(QInputDevice::Capability::XTilt))
    controller_->lean_stylus(practice::PenTilt{event->xTilt(), event->yTilt()});
  // Qt's left button is the tip. While the tip is up, the buttons on the barrel act as those of a mouse. A
  // button that is pressed during a stroke is ignored: it is an accident.
  const bool is_tip = event->button() == Qt::LeftButton;
  if (event->type() == QEvent::TabletPress) {
    if (!is_tip && !pen_down_ && drag_ == Drag::none) {
      if (event->button() == Qt::RightButton) begin_drag(Drag::orbit, at);
      if (event->button() == Qt::MiddleButton) begin_drag(Drag::pan, at);
    } else if (is_tip && event->pointerType() == QPointingDevice::PointerType::Eraser) {
      controller_->eraser_used();
    } else if (is_tip && drag_ == Drag::none) {
      pen_down_ = true;
    }
  } else if (event->type() == QEvent::TabletRelease) {
    if (is_tip) pen_down_ = false;
    if ((drag_ == Drag::orbit && event->button() == Qt::RightButton) ||
        (drag_ == Drag::pan && event->button() == Qt::MiddleButton))
      drag_ = Drag::none;
  }
  if (drag_ == Drag::orbit || drag_ == Drag::pan)
    drag_camera(at);
  else
    point_stylus(at, pen_down_, event->pressure(), event->timestamp());
  event->accept();
}

bool TabletWindow::pen_is_near() const {
  return pen_in_proximity_ || (since_pen_.isValid() && since_pen_.elapsed() < kPenGone_ms);
}

void TabletWindow::touchEvent(QTouchEvent* event) {
  // Always accepted, otherwise Qt would turn the palm into mouse events.
  event->accept();
  const auto& points = event->points();
  if (pen_is_near() || event->type() == QEvent::TouchCancel || points.isEmpty()) {
    if (fingers_ == 1 && !pen_down_) controller_->lift_stylus();
    fingers_ = 0;
    return;
  }
  int down = 0;
  for (const auto& point : points) down += point.state() != QEventPoint::Released ? 1 : 0;
  const QPointF first = points.front().scenePosition();
  if (down >= 2 && points.size() >= 2) {
    const QPointF second = points[1].scenePosition();
    const QPointF middle = (first + second) / 2;
    const double apart = QLineF(first, second).length();
    if (fingers_ == 1) controller_->lift_stylus();
    if (fingers_ == 2 && apart > 1 && pinch_apart_ > 1) {
      set_camera(panned(pinch_middle_, middle));
      set_camera(zoomed(apart / pinch_apart_, middle));
    }
    fingers_ = 2;
    pinch_middle_ = middle;
    pinch_apart_ = apart;
    return;
  }
  controller_->lean_stylus({});
  // After a gesture with two fingers the last finger does not write: it is being lifted.
  if (fingers_ == 2) {
    if (down == 0) fingers_ = 0;
    return;
  }
  fingers_ = down;
  point_stylus(first, down == 1, {}, event->timestamp());
  if (down == 0) controller_->lift_stylus();
}

bool TabletWindow::eventFilter(QObject* /*watched*/, QEvent* event) {
  if (event->type() == QEvent::TabletEnterProximity) pen_in_proximity_ = true;
  if (event->type() == QEvent::TabletLeaveProximity) {
    pen_in_proximity_ = false;
    since_pen_.start();
  }
  return false;
}

void TabletWindow::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / 120.0;
  if (drag_ == Drag::stylus) {
    controller_->push_stylus(-notches);
    since_move_.restart();
    return;
  }
  glide_.stop();
  // The point under the pointer stays in place.
  set_camera(zoomed(std::pow(view::Camera::kZoomStep, notches), event->position()));
}

void TabletWindow::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Home:
      reset_camera();
      break;
    case Qt::Key_Tab:
      emit focus_leaves(true);
      break;
    case Qt::Key_Backtab:
      emit focus_leaves(false);
      break;
    default:
      QOpenGLWindow::keyPressEvent(event);
  }
}

bool TabletWindow::event(QEvent* event) {
  switch (event->type()) {
    case QEvent::Leave:
      if (drag_ == Drag::none) {
        controller_->lift_stylus();
        since_move_.restart();
      }
      break;
    case QEvent::DragEnter:
    case QEvent::DragMove: {
      auto* drag = static_cast<QDragMoveEvent*>(event);
      if (!local_files(drag->mimeData()).isEmpty()) drag->acceptProposedAction();
      return true;
    }
    case QEvent::Drop: {
      auto* drop = static_cast<QDropEvent*>(event);
      drop->acceptProposedAction();
      emit files_dropped(local_files(drop->mimeData()));
      return true;
    }
    default:
      break;
  }
  return QOpenGLWindow::event(event);
}

}  // namespace nazori::ui
