// SPDX-License-Identifier: Apache-2.0
#include "tablet_controller.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "nazori/devices/simulated_device.h"
#include "signals.h"

namespace nazori::ui {
namespace {

constexpr int kActivePump_ms = 16;
constexpr int kIdlePump_ms = 250;
constexpr double kUsualDepth = 1.15;  ///< below the deepest groove: a click touches the bottom
constexpr double kDeepest = 1.5;
constexpr double kNotch = 0.05;
constexpr double kSeen_m = 2e-6;  ///< smaller moves of a device change no pixel
constexpr double kBitHalfWidth_m = 0.0012;
constexpr double kBitOpacity = 0.9;

}  // namespace

TabletController::TabletController(QObject* parent) : QObject(parent), mouse_depth_(kUsualDepth) {
  pointer_.in_range = false;
  pump_timer_.setInterval(kIdlePump_ms);
  pump_timer_.setTimerType(Qt::CoarseTimer);
  connect(&pump_timer_, &QTimer::timeout, this, &TabletController::pump);
  subscribe(stylus_.leaving, this, [this] { pump(); });
  subscribe(stylus_.changed, this, [this] {
    if (guides_ && guides_->leading) hand_over_scene();
    send();
  });
}

TabletController::~TabletController() = default;

base::Result<void> TabletController::start() {
  auto started = stylus_.start();
  if (!started) return started;
  send();
  pump_timer_.start();
  return {};
}

void TabletController::set_tablet(std::shared_ptr<const tablet::CarvedTablet> carved) {
  pump();
  tablet_ = std::move(carved);
  current_ = 0;
  led_from_ = 1;
  ++led_times_;
  ink_.set_strokes(tablet_ ? std::span<const haptics::StrokePath>(tablet_->paths())
                           : std::span<const haptics::StrokePath>());
  lay_out_writing();
  hand_over_scene();
  emit tablet_changed();
  emit state_changed();
  emit picture_changed();
}

int TabletController::stroke_count() const { return tablet_ ? static_cast<int>(tablet_->lines().size()) : 0; }

template <class T>
void TabletController::change(T& value, T to, bool felt) {
  if (value == to) return;
  value = to;
  if (felt) hand_over_scene();
  emit state_changed();
  emit picture_changed();
}

void TabletController::set_current_stroke(int stroke) {
  const int open = ink_.next_stroke();
  led_from_ = stroke > 0 ? stroke : open > 0 ? open : stroke_count() + 1;
  change(current_, std::clamp(stroke, 0, stroke_count()), true);
}

void TabletController::next_stroke() { set_current_stroke(current_ >= stroke_count() ? 0 : current_ + 1); }

void TabletController::previous_stroke() {
  set_current_stroke(current_ == 0 ? stroke_count() : current_ - 1);
}

void TabletController::set_strokes_visible(bool on) { change(strokes_visible_, on, true); }
void TabletController::set_numbers_visible(bool on) { change(numbers_visible_, on, false); }
void TabletController::set_arrows_visible(bool on) { change(arrows_visible_, on, false); }
void TabletController::set_snapping(bool on) { change(snapping_, on, true); }
void TabletController::set_style(view::Style style) { change(style_, style, false); }

void TabletController::set_guides(const std::optional<TabletGuides>& guides) {
  guides_ = guides;
  lay_out_writing();
  hand_over_scene();
  emit picture_changed();
}

void TabletController::set_writing(std::vector<view::WrittenStroke> writing) {
  writing_ = std::move(writing);
  lay_out_writing();
  emit picture_changed();
}

void TabletController::lay_out_writing() {
  drawn_writing_ = writing_;
  if (guides_ && !guides_->traced) return;
  for (const int stroke : ink_.left_open()) {
    view::WrittenStroke bit;
    bit.verdict = view::Verdict::shown;
    bit.opacity = kBitOpacity;
    for (const auto& point : ink_.missing_bit(stroke)) bit.points.push_back({point, kBitHalfWidth_m});
    drawn_writing_.push_back(std::move(bit));
  }
}

void TabletController::set_demonstration(std::optional<Demonstration> demonstration) {
  demonstration_ = std::move(demonstration);
  emit picture_changed();
}

void TabletController::clear_ink() {
  ink_.clear();
  lay_out_writing();
  lead_from(1);
  emit picture_changed();
}

void TabletController::undo_ink() {
  const int stroke = ink_.undo();
  if (stroke == 0) return;
  lay_out_writing();
  lead_from(ink_.next_stroke());
  emit picture_changed();
}

void TabletController::lead_from(int stroke) {
  led_from_ = stroke;
  ++led_times_;
  if (guides_ && guides_->leading) hand_over_scene();
}

void TabletController::hand_over_scene() {
  if (!tablet_) {
    stylus_.set_scene(nullptr);
    return;
  }
  haptics::Snapping snap;
  snap.enabled = snapping_in_effect();
  snap.stroke = current_;
  if (guides_) snap.stiffness *= std::clamp(guides_->snapping_strength, 0.0, 1.0);
  haptics::Guiding guiding;
  if (guides_ && guides_->leading && can_lead()) {
    guiding.mode = haptics::GuidingMode::lead;
    guiding.strength = std::clamp(guides_->snapping_strength, 0.0, 1.0);
    guiding.stroke = led_from_;
    guiding.attempt = led_times_;
  }
  stylus_.set_scene(tablet_->scene(material_, snap, guiding));
}

void TabletController::set_slope_help(bool on) { change(slope_help_, on, false); }

void TabletController::set_judged(bool judged) { judged_ = judged; }

void TabletController::set_material(const haptics::Material& material) {
  material_ = material;
  hand_over_scene();
}

void TabletController::move_stylus(geometry::TabletPoint at, bool pressed, std::optional<double> pressure,
                                   std::optional<double> event_s) {
  const geometry::TabletShape shape = tablet_ ? tablet_->shape() : geometry::TabletShape{};
  if (!pressed || pressure || !slope_help_ || judged_)
    slope_gain_.reset();
  else if (tablet_)
    at = slope_gain_.follow(at, haptics::TabletSurface(*tablet_->surface(), shape));
  // A little beyond the edge is still the tablet: strokes may end near it.
  const double edge_m = shape.width_m * 0.56;
  pointer_.x_m = std::clamp(at.x, -edge_m, edge_m);
  pointer_.y_m = std::clamp(at.y, -edge_m, edge_m);
  const bool over = std::abs(at.x) <= edge_m && std::abs(at.y) <= edge_m;
  const bool began = pressed && !pointer_.pressed;
  if (began && !pressure) mouse_depth_ = kUsualDepth;
  if (began && over) emit this->pressed({pointer_.x_m, pointer_.y_m});
  pointer_.pressed = pressed && (over || pointer_.pressed);
  pointer_.in_range = over || pointer_.pressed;
  const double fraction = pressure ? std::clamp(*pressure, 0.0, 1.0) * kDeepest : mouse_depth_;
  pointer_.depth_m = pointer_.pressed ? fraction * shape.depth_m : 0;
  send(event_s);
}

void TabletController::lift_stylus() {
  pointer_.pressed = false;
  pointer_.in_range = false;
  pointer_.depth_m = 0;
  send();
}

void TabletController::lean_stylus(std::optional<QPointF> tilt_deg) {
  const auto slope = [](double degrees) {
    constexpr double kMost = 75;  // drivers that tell more mean a pen that lies
    return std::tan(std::clamp(std::isfinite(degrees) ? degrees : 0, -kMost, kMost) * std::numbers::pi / 180);
  };
  // Many drivers of pens without tilt tell zeros.
  if (tilt_deg && tilt_deg->isNull() && axis_ == haptics::Vec3(0)) return;
  axis_ = tilt_deg ? glm::normalize(haptics::Vec3(slope(tilt_deg->x()), -slope(tilt_deg->y()), 1))
                   : haptics::Vec3(0);
  lean_rad_ = tilt_deg ? std::acos(std::clamp(axis_.z, 0.0, 1.0)) : 0;
}

void TabletController::push_stylus(double notches) {
  if (!pointer_.pressed) return;
  const geometry::TabletShape shape = tablet_ ? tablet_->shape() : geometry::TabletShape{};
  mouse_depth_ = std::clamp(mouse_depth_ + notches * kNotch, kNotch, kDeepest);
  pointer_.depth_m = mouse_depth_ * shape.depth_m;
  send();
}

void TabletController::send(std::optional<double> event_s) {
  stylus_.move(pointer_, event_s);
  // A simulated device has no hand of its own: the mouse leads it.
  if (const auto* opened = stylus_.opened(); opened != nullptr && pointer_.in_range)
    if (auto* simulated = dynamic_cast<devices::SimulatedDevice*>(opened->device.get()))
      simulated->set_target({pointer_.x_m, pointer_.y_m,
                             pointer_.pressed ? -pointer_.depth_m : devices::PointerDevice::kHover_m});
  const bool active = pointer_.pressed || !stylus_.is_pointer();
  if (pump_timer_.isActive()) pump_timer_.setInterval(active ? kActivePump_ms : kIdlePump_ms);
  emit depth_changed(pointer_.depth_m);
  emit picture_changed();
}

void TabletController::pump() {
  std::array<haptics::ServoSample, 256> samples;
  bool inked = false;
  const bool had_bits = !ink_.left_open().empty();
  for (;;) {
    const auto count = stylus_.take_samples(samples);
    const auto taken = std::span<const haptics::ServoSample>(samples).first(count);
    emit sampled(taken);
    const bool traced = !guides_ || guides_->traced;
    for (const auto& sample : taken) {
      if (!traced) break;
      // A tick that came too late drops the touch, which says nothing of the hand.
      if (haptics::has(sample.events, haptics::ServoEvent::fault)) continue;
      const auto step = ink_.follow(sample.proxy_m, sample.touching, current_);
      inked = inked || step.inked || step.event == practice::TraceEvent::left_open;
      if (step.event != practice::TraceEvent::none) emit stroke_event(step.event, step.stroke);
    }
    if (count < samples.size()) break;
  }
  if (inked && (had_bits || !ink_.left_open().empty())) lay_out_writing();
  bool moved = false;
  if (!stylus_.is_pointer()) {
    const haptics::Vec3& at = stylus_.latest().device_m;
    moved = glm::length(at - seen_m_) > kSeen_m;
    if (moved) seen_m_ = at;
  }
  if (inked || moved) emit picture_changed();
}

view::Overlay TabletController::overlay() {
  view::Overlay overlay;
  overlay.strokes_visible = guides_ ? guides_->strokes : strokes_visible_;
  overlay.arrows_visible = guides_ ? guides_->arrows : arrows_visible_;
  overlay.numbers_visible = guides_ ? guides_->numbers : numbers_visible_;
  overlay.lines_opacity = guides_ ? guides_->lines_opacity : 1.0;
  overlay.current_stroke = current_;
  overlay.ink = demonstration_ ? demonstration_->ink : ink_.progress();
  overlay.writing = drawn_writing_;
  if (demonstration_) overlay.cursor = demonstration_->brush;
  shown_s_ = 0;
  if (draws_stylus()) {
    const auto& now = stylus_.latest();
    // A resting stylus shows nothing new, so its sample has no age.
    shown_s_ = stylus_.is_resting() ? 0 : now.begun_s;
    overlay.cursor = view::Cursor{now.proxy_m, now.device_m, now.touching,
                                  stylus_.is_pointer() ? axis_ : haptics::Vec3(0)};
  }
  return overlay;
}

void TabletController::note_drawn() {
  if (shown_s_ <= 0) return;
  const double now_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  drawn_age_s_ = std::max(drawn_age_s_, now_s - shown_s_);
}

double TabletController::take_drawn_age_s() { return std::exchange(drawn_age_s_, 0); }

}  // namespace nazori::ui
