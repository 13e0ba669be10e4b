// SPDX-License-Identifier: Apache-2.0
#include "tablet_window.h"

#include <QCoreApplication>
#include <QCursor>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QKeyEvent>
#include <QLineF>
#include <QMimeData>
#include <QMouseEvent>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QScreen>
#include <QTabletEvent>
#include <QTouchEvent>
#include <QUrl>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "nazori/view/point_under.h"
#include "signals.h"

namespace nazori::ui {
namespace {

constexpr int kGlide_ms = 220;
constexpr int kStill_ms = 120;    ///< the camera has come to rest: one more picture, in full quality
constexpr int kSettle_ms = 250;   ///< the simulated tip takes a few milliseconds to follow the pointer
constexpr int kPenGone_ms = 500;  ///< the palm leaves the tablet after the pen
constexpr double kSeen_m = 2e-6;  ///< smaller moves of the tip change no pixel

/// The view to begin with and to come back to: in the classic style the eye of 2005.
view::Camera home(view::Style style) {
  return style == view::Style::classic ? view::Camera{} : view::Camera::resting();
}

/// A drag to the right turns the tablet to the right, one upwards lays it flatter.
view::Camera turned(view::Camera camera, QPointF drag) {
  camera.azimuth += drag.x() * view::Camera::kOrbitStep;
  camera.tilt -= drag.y() * view::Camera::kOrbitStep;
  return view::within_limits(camera);
}

QStringList local_files(const QMimeData* data) {
  QStringList paths;
  for (const auto& url : data->urls())
    if (url.isLocalFile()) paths.append(url.toLocalFile());
  return paths;
}

}  // namespace

TabletWindow::TabletWindow(practice::TabletControl* controller)
    : controller_(controller), style_(controller->style()), camera_(home(style_)) {
  setObjectName(QStringLiteral("tablet_window"));
  setFormat(surface_format());
  frame_timer_.setSingleShot(true);
  frame_timer_.setTimerType(Qt::PreciseTimer);
  connect(&frame_timer_, &QTimer::timeout, this, qOverload<>(&QPaintDeviceWindow::update));
  subscribe(controller_->picture_changed, this, [this] { request_frame(); });
  subscribe(controller_->state_changed, this, [this] { take_style(); });
  subscribe(controller_->tablet_changed, this, [this] { tablet_stale_ = true; });
  still_timer_.setSingleShot(true);
  still_timer_.setInterval(kStill_ms);
  connect(&still_timer_, &QTimer::timeout, this, &TabletWindow::request_frame);
  glide_.setDuration(kGlide_ms);
  glide_.setEasingCurve(QEasingCurve::OutCubic);
  since_frame_.start();
  since_move_.start();
  // Where the pen is near is told to the application alone.
  if (auto* application = QCoreApplication::instance()) application->installEventFilter(this);
}

TabletWindow::~TabletWindow() { release_graphics(); }

QSurfaceFormat TabletWindow::surface_format() {
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  // The view brings its own canvas with depth and several samples a pixel.
  format.setDepthBufferSize(0);
  format.setSwapInterval(1);
  return format;
}

bool TabletWindow::is_possible() {
  QOpenGLContext context;
  context.setFormat(surface_format());
  return context.create() && context.format().version() >= qMakePair(3, 3);
}

void TabletWindow::set_theme(view::Theme theme) {
  theme_ = theme;
  request_frame();
}

void TabletWindow::set_text_size(int text_pt) {
  text_scale_ = text_pt / 12.0;
  request_frame();
}

void TabletWindow::initializeGL() {
  auto made = view::TabletView::create();
  if (!made) {
    emit drawing_failed(made.error());
    return;
  }
  view_ = std::move(*made);
  tablet_stale_ = true;
  // The context goes before this object where the native window is taken away (another screen, closing).
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &TabletWindow::release_graphics,
          Qt::DirectConnection);
}

void TabletWindow::release_graphics() {
  if (!view_) return;
  makeCurrent();
  view_.reset();
  doneCurrent();
}

void TabletWindow::request_frame() {
  if (frame_timer_.isActive()) return;
  // Not every driver waits for the screen: pace ourselves by its rate.
  const double rate_hz = screen() != nullptr ? std::clamp(screen()->refreshRate(), 30.0, 500.0) : 60.0;
  const auto wait_ms =
      static_cast<int>(std::lround(1000.0 / rate_hz)) - static_cast<int>(since_frame_.elapsed());
  frame_timer_.start(std::max(wait_ms, 0));
}

void TabletWindow::paintGL() {
  since_frame_.restart();
  if (!view_) return;
  controller_->pump();
  if (tablet_stale_) {
    tablet_stale_ = false;
    const auto& carved = controller_->tablet();
    if (carved) {
      view_->set_height_map(carved->height_map(), carved->shape());
      view_->set_strokes(tablet::stroke_lines(carved->lines()));
    } else {
      view_->set_height_map({});
      view_->set_strokes({});
    }
  }
  view_->set_theme(theme_);
  view_->set_style(style_);
  view_->set_camera(camera_);
  const double scale = devicePixelRatio();
  view::Overlay overlay = controller_->overlay();
  overlay.text_scale = text_scale_;
  view_->draw(static_cast<int>(std::lround(width() * scale)), static_cast<int>(std::lround(height() * scale)),
              scale, overlay);
  controller_->note_drawn();
  if (view_->wants_redraw()) still_timer_.start();
  if (!overlay.cursor) return;
  const bool moved = glm::length(overlay.cursor->proxy_m - drawn_proxy_m_) > kSeen_m ||
                     glm::length(overlay.cursor->device_m - drawn_device_m_) > kSeen_m;
  drawn_proxy_m_ = overlay.cursor->proxy_m;
  drawn_device_m_ = overlay.cursor->device_m;
  if (moved || since_move_.elapsed() < kSettle_ms) request_frame();
}

// A window that shrinks is not exposed anew.
void TabletWindow::resizeGL(int /*width*/, int /*height*/) { request_frame(); }

std::optional<geometry::TabletPoint> TabletWindow::point_under(QPointF position) const {
  const auto& carved = controller_->tablet();
  return view::point_under(camera_, style_, carved ? carved->shape() : geometry::TabletShape{},
                           {position.x(), position.y()}, width(), height());
}

void TabletWindow::set_camera(const view::Camera& camera) {
  camera_ = camera;
  if (view_) view_->set_camera(camera_);
  request_frame();
}

void TabletWindow::glide_to(const view::Camera& camera) {
  glide_.stop();
  if (reduced_motion_) {
    set_camera(camera);
    return;
  }
  disconnect(&glide_, nullptr, this, nullptr);
  connect(&glide_, &QVariantAnimation::valueChanged, this,
          [this, from = camera_, camera](const QVariant& share) {
            set_camera(view::between(from, camera, share.toDouble()));
          });
  glide_.setStartValue(0.0);
  glide_.setEndValue(1.0);
  glide_.start();
}

void TabletWindow::orbit_by(double right, double down) { glide_to(turned(camera_, {right, down})); }

void TabletWindow::pan_by(double right, double down) {
  if (!view_) return;
  const glm::dvec2 middle(width() / 2.0, height() / 2.0);
  glide_to(view_->panned(middle, middle + glm::dvec2(right, down), width(), height()));
}

void TabletWindow::zoom_by(double factor) {
  view::Camera nearer = camera_;
  nearer.zoom *= factor;
  glide_to(view::within_limits(nearer));
}

void TabletWindow::reset_camera() { glide_to(home(style_)); }

void TabletWindow::take_style() {
  if (style_ == controller_->style()) return;
  const view::Camera before = home(style_);
  const bool at_home = camera_.tilt == before.tilt && camera_.azimuth == before.azimuth &&
                       camera_.zoom == before.zoom && camera_.pan == before.pan;
  style_ = controller_->style();
  if (at_home) glide_to(home(style_));
}

void TabletWindow::begin_drag(Drag drag, QPointF position) {
  glide_.stop();
  drag_ = drag;
  drag_from_ = position;
}

void TabletWindow::drag_camera(QPointF to) {
  if (drag_ == Drag::orbit)
    set_camera(turned(camera_, to - drag_from_));
  else if (view_)
    set_camera(view_->panned({drag_from_.x(), drag_from_.y()}, {to.x(), to.y()}, width(), height()));
  drag_from_ = to;
}

void TabletWindow::point_stylus(QPointF position, bool pressed, std::optional<double> pressure,
                                quint64 event_ms) {
  since_move_.restart();
  std::optional<double> event_s;
  if (event_ms != 0) event_s = static_cast<double>(event_ms) / 1000;
  if (const auto at = point_under(position)) controller_->move_stylus(*at, pressed, pressure, event_s);
  // Over the tablet the drawn stylus is the pointer; a second one beside it would only lag or lead.
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
  // Qt's left button is the tip. The buttons on the barrel do what those of a mouse do, while the tip is up:
  // one that is pressed in the middle of a stroke is an accident of the hand.
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
  // Taken even where nothing is done with it: Qt would make a mouse of the palm.
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
    if (fingers_ == 2 && view_ && apart > 1 && pinch_apart_ > 1) {
      set_camera(
          view_->panned({pinch_middle_.x(), pinch_middle_.y()}, {middle.x(), middle.y()}, width(), height()));
      set_camera(view_->zoomed(apart / pinch_apart_, {middle.x(), middle.y()}, width(), height()));
    }
    fingers_ = 2;
    pinch_middle_ = middle;
    pinch_apart_ = apart;
    return;
  }
  controller_->lean_stylus({});
  // After two fingers the last one does not write: it is on its way up.
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
  if (!view_) return;
  glide_.stop();
  // What lies under the pointer stays there.
  const QPointF at = event->position();
  set_camera(view_->zoomed(std::pow(view::Camera::kZoomStep, notches), {at.x(), at.y()}, width(), height()));
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
