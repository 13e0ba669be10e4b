// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/tablet/tablet_window.h"

#include <QCoreApplication>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QScreen>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "nazori/view/point_under.h"
#include "nazori/widgets/events/signals.h"

namespace nazori::ui {
namespace {

constexpr int kGlide_ms = 220;
constexpr int kStill_ms = 120;    ///< the camera is at rest: one more picture in full quality
constexpr int kIdle_ms = 1500;    ///< the same where that costs the processor as much as a new character
constexpr int kSettle_ms = 250;   ///< the simulated tip takes a few milliseconds to follow the pointer
constexpr double kSeen_m = 2e-6;  ///< smaller moves of the tip change no pixel

/// The view to begin with and to come back to: in the classic style the eye of 2005.
view::Camera home(view::Style style) {
  return style == view::Style::classic ? view::Camera{} : view::Camera::resting();
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
  subscribe(controller_->state_changed, this, [this] { update_style(); });
  subscribe(controller_->tablet_changed, this, [this] { tablet_stale_ = true; });
  still_timer_.setSingleShot(true);
  connect(&still_timer_, &QTimer::timeout, this, [this] {
    if (view_) view_->refine();
    request_frame();
  });
  glide_.setDuration(kGlide_ms);
  glide_.setEasingCurve(QEasingCurve::OutCubic);
  since_frame_.start();
  since_move_.start();
  // Qt sends the proximity of the pen to the application only.
  if (auto* application = QCoreApplication::instance()) application->installEventFilter(this);
}

TabletWindow::~TabletWindow() { release_graphics(); }

QSurfaceFormat TabletWindow::surface_format() {
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  // The view has its own framebuffer with depth and several samples per pixel.
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

void TabletWindow::set_hand(view::Hand hand) {
  hand_ = hand;
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
  const auto* renderer = context()->functions()->glGetString(GL_RENDERER);
  const view::Refinement refinement =
      view::refinement_for(renderer != nullptr ? reinterpret_cast<const char*>(renderer) : "");
  view_->set_refinement(refinement);
  still_timer_.setInterval(refinement == view::Refinement::when_idle ? kIdle_ms : kStill_ms);
  tablet_stale_ = true;
  // The context is destroyed before this object when the native window is closed or moves to another screen.
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
  // Not every driver waits for the screen, so the frames follow its refresh rate.
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
      view_->set_strokes(tablet::centre_lines(carved->lines()));
      view_->set_labels(carved->labels());
    } else {
      view_->set_height_map({});
      view_->set_strokes({});
      view_->set_labels({});
    }
  }
  view_->set_theme(theme_);
  view_->set_style(style_);
  view_->set_hand(hand_);
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

// A window that becomes smaller gets no expose event.
void TabletWindow::resizeGL(int /*width*/, int /*height*/) { request_frame(); }

geometry::TabletShape TabletWindow::shape() const {
  const auto& carved = controller_->tablet();
  return carved ? carved->shape() : geometry::TabletShape{};
}

std::optional<geometry::TabletPoint> TabletWindow::point_under(QPointF position) const {
  return view::point_under(camera_, style_, shape(), {position.x(), position.y()}, width(), height());
}

void TabletWindow::set_camera(const view::Camera& camera) {
  camera_ = camera;
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

view::Camera TabletWindow::turned(QPointF drag) const {
  view::Camera camera = camera_;
  camera.azimuth += drag.x() * view::Camera::kOrbitStep;
  camera.tilt -= drag.y() * view::Camera::kOrbitStep;
  return view::within_limits(camera);
}

view::Camera TabletWindow::panned(QPointF from, QPointF to) const {
  return view::panned(camera_, style_, shape(), {from.x(), from.y()}, {to.x(), to.y()}, width(), height());
}

view::Camera TabletWindow::zoomed(double factor, QPointF at) const {
  return view::zoomed(camera_, style_, shape(), factor, {at.x(), at.y()}, width(), height());
}

void TabletWindow::orbit_by(double right, double down) { glide_to(turned({right, down})); }

void TabletWindow::pan_by(double right, double down) {
  const QPointF middle(width() / 2.0, height() / 2.0);
  glide_to(panned(middle, middle + QPointF(right, down)));
}

void TabletWindow::zoom_by(double factor) {
  view::Camera nearer = camera_;
  nearer.zoom *= factor;
  glide_to(view::within_limits(nearer));
}

void TabletWindow::reset_camera() { glide_to(home(style_)); }

void TabletWindow::update_style() {
  if (style_ == controller_->style()) return;
  const view::Camera before = home(style_);
  const bool at_home = camera_.tilt == before.tilt && camera_.azimuth == before.azimuth &&
                       camera_.zoom == before.zoom && camera_.pan == before.pan;
  style_ = controller_->style();
  if (at_home) glide_to(home(style_));
}

}  // namespace nazori::ui
