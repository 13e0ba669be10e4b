// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/tablet_control.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "nazori/devices/simulated_device.h"

namespace nazori::practice {
namespace {

constexpr std::chrono::milliseconds kActivePump{16};
constexpr std::chrono::milliseconds kIdlePump{250};
constexpr double kUsualDepth = 1.15;  ///< below the deepest groove: a click touches the bottom
constexpr double kDeepest = 1.5;
constexpr double kNotch = 0.05;
constexpr double kSeen_m = 2e-6;  ///< smaller moves of a device change no pixel
constexpr double kBitHalfWidth_m = 0.0012;
constexpr double kBitOpacity = 0.9;

}  // namespace

TabletControl::TabletControl(base::Inbox& inbox, const base::Clock& clock,
                             devices::TabletDevice::WakeAt wake_at)
    : mouse_depth_(kUsualDepth),
      clock_(clock),
      device_(inbox, clock, std::move(wake_at)),
      leaving_(device_.leaving.connect([this] { pump(); })),
      changed_(device_.changed.connect([this] {
        if (sheet_ || (guides_ && guides_->leading)) hand_over_scene();
        send();
      })),
      felt_(inbox) {
  felt_.changed.connect([this] { hand_over_scene(); });
  pointer_.in_range = false;
}

TabletControl::~TabletControl() = default;

base::Result<void> TabletControl::start() {
  auto started = device_.start();
  if (started) send();
  return started;
}

std::chrono::milliseconds TabletControl::pump_period() const {
  return pointer_.pressed || !device_.is_pointer() ? kActivePump : kIdlePump;
}

void TabletControl::set_tablet(std::shared_ptr<const tablet::CarvedTablet> carved) {
  pump();
  tablet_ = std::move(carved);
  felt_.set_tablet(tablet_);
  current_ = 0;
  led_from_ = 1;
  ++led_times_;
  ink_.set_strokes(tablet_ ? std::span<const haptics::StrokePath>(tablet_->paths())
                           : std::span<const haptics::StrokePath>());
  lay_out_writing();
  hand_over_scene();
  tablet_changed();
  state_changed();
  picture_changed();
}

int TabletControl::stroke_count() const { return tablet_ ? static_cast<int>(tablet_->lines().size()) : 0; }

template <class T>
void TabletControl::change(T& value, T to, bool felt) {
  if (value == to) return;
  value = to;
  if (felt) hand_over_scene();
  state_changed();
  picture_changed();
}

void TabletControl::set_current_stroke(int stroke) {
  const int open = ink_.next_stroke();
  led_from_ = stroke > 0 ? stroke : open > 0 ? open : stroke_count() + 1;
  change(current_, std::clamp(stroke, 0, stroke_count()), true);
}

void TabletControl::next_stroke() { set_current_stroke(current_ >= stroke_count() ? 0 : current_ + 1); }

void TabletControl::previous_stroke() { set_current_stroke(current_ == 0 ? stroke_count() : current_ - 1); }

void TabletControl::press_button(devices::ButtonDoes what) {
  if (sheet_) return;
  switch (what) {
    case devices::ButtonDoes::nothing:
      return;
    case devices::ButtonDoes::next_stroke:
      next_stroke();
      return;
    case devices::ButtonDoes::previous_stroke:
      previous_stroke();
      return;
    case devices::ButtonDoes::all_strokes:
      set_current_stroke(0);
      return;
    case devices::ButtonDoes::clear_ink:
      clear_ink();
      return;
  }
}

void TabletControl::set_switches(const Switches& to) {
  set_strokes_visible(to.strokes);
  set_numbers_visible(to.numbers);
  set_arrows_visible(to.arrows);
  set_snapping(to.snapping);
}

void TabletControl::set_strokes_visible(bool on) { change(strokes_visible_, on, true); }
void TabletControl::set_numbers_visible(bool on) { change(numbers_visible_, on, false); }
void TabletControl::set_arrows_visible(bool on) { change(arrows_visible_, on, false); }
void TabletControl::set_snapping(bool on) { change(snapping_, on, true); }
void TabletControl::set_style(view::Style style) { change(style_, style, false); }
void TabletControl::set_cross(view::WritingCross cross) { change(cross_, cross, false); }

void TabletControl::set_guides(const std::optional<TabletGuides>& guides) {
  guides_ = guides;
  lay_out_writing();
  hand_over_scene();
  picture_changed();
}

void TabletControl::set_writing(std::vector<view::InkedStroke> writing) {
  writing_ = std::move(writing);
  lay_out_writing();
  picture_changed();
}

void TabletControl::lay_out_writing() {
  drawn_writing_ = writing_;
  if (guides_ && !guides_->traced) return;
  for (const int stroke : ink_.left_open()) {
    view::InkedStroke bit;
    bit.verdict = view::Verdict::shown;
    bit.opacity = kBitOpacity;
    bit.half_width_m = kBitHalfWidth_m;
    for (const auto& point : ink_.missing_bit(stroke)) bit.points.push_back({point});
    drawn_writing_.push_back(std::move(bit));
  }
}

void TabletControl::set_demonstration(std::optional<Demonstration> demonstration) {
  demonstration_ = std::move(demonstration);
  picture_changed();
}

void TabletControl::clear_ink() {
  ink_.clear();
  lay_out_writing();
  lead_from(1);
  picture_changed();
}

void TabletControl::undo_ink() {
  const int stroke = ink_.undo();
  if (stroke == 0) return;
  lay_out_writing();
  lead_from(ink_.next_stroke());
  picture_changed();
}

void TabletControl::lead_from(int stroke) {
  led_from_ = stroke;
  ++led_times_;
  if (guides_ && guides_->leading) hand_over_scene();
}

void TabletControl::set_sheet(std::optional<FlatSheet> sheet) {
  sheet_ = std::move(sheet);
  hand_over_scene();
}

void TabletControl::hand_over_sheet() {
  auto scene = std::make_shared<haptics::HapticScene>();
  scene->soft_tip = sheet_->tip;
  if (!sheet_->led.empty() && can_lead()) {
    scene->strokes = sheet_->led;
    scene->guiding.mode = haptics::GuidingMode::lead;
    scene->guiding.attempt = sheet_->led_times;
  }
  device_.set_scene(std::move(scene));
}

void TabletControl::hand_over_scene() {
  if (sheet_) return hand_over_sheet();
  if (!tablet_) {
    device_.set_scene(nullptr);
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
  device_.set_scene(felt_.felt()->scene(material_, snap, guiding));
}

void TabletControl::set_slope_help(bool on) { change(slope_help_, on, false); }

void TabletControl::set_judged(bool judged) { judged_ = judged; }

void TabletControl::set_material(const haptics::Material& material) {
  material_ = material;
  hand_over_scene();
}

void TabletControl::move_stylus(geometry::TabletPoint at, bool is_down, std::optional<double> pressure,
                                std::optional<double> event_s) {
  const geometry::TabletShape shape = tablet_ ? tablet_->shape() : geometry::TabletShape{};
  if (!is_down || pressure || !slope_help_ || judged_ || sheet_)
    slope_gain_.reset();
  else if (tablet_)
    at = slope_gain_.follow(at, haptics::TabletSurface(*tablet_->surface(), shape));
  // A little beyond the edge still counts as the tablet, because strokes may end near the edge.
  const double edge_m = shape.width_m * 0.56;
  pointer_.x_m = std::clamp(at.x, -edge_m, edge_m);
  pointer_.y_m = std::clamp(at.y, -edge_m, edge_m);
  const bool over = std::abs(at.x) <= edge_m && std::abs(at.y) <= edge_m;
  const bool began = is_down && !pointer_.pressed;
  if (began && !pressure) mouse_depth_ = kUsualDepth;
  if (began && over && !sheet_) pressed({pointer_.x_m, pointer_.y_m});
  pointer_.pressed = is_down && (over || pointer_.pressed);
  pointer_.in_range = over || pointer_.pressed;
  const double fraction = pressure ? std::clamp(*pressure, 0.0, 1.0) * kDeepest : mouse_depth_;
  pointer_.depth_m = pointer_.pressed ? fraction * shape.depth_m : 0;
  send(event_s);
}

void TabletControl::lift_stylus() {
  pointer_.pressed = false;
  pointer_.in_range = false;
  pointer_.depth_m = 0;
  send();
}

void TabletControl::lean_stylus(std::optional<PenTilt> tilt) {
  const auto slope = [](double degrees) {
    constexpr double kMost = 75;  // drivers report more for a pen that lies flat
    return std::tan(std::clamp(std::isfinite(degrees) ? degrees : 0, -kMost, kMost) * std::numbers::pi / 180);
  };
  // Many drivers of pens without tilt report zeros.
  if (tilt && tilt->right_deg == 0 && tilt->towards_learner_deg == 0 && axis_ == haptics::Vec3(0)) return;
  axis_ = tilt ? glm::normalize(haptics::Vec3(slope(tilt->right_deg), -slope(tilt->towards_learner_deg), 1))
               : haptics::Vec3(0);
  lean_rad_ = tilt ? std::acos(std::clamp(axis_.z, 0.0, 1.0)) : 0;
}

void TabletControl::push_stylus(double notches) {
  if (!pointer_.pressed) return;
  const geometry::TabletShape shape = tablet_ ? tablet_->shape() : geometry::TabletShape{};
  mouse_depth_ = std::clamp(mouse_depth_ + notches * kNotch, kNotch, kDeepest);
  pointer_.depth_m = mouse_depth_ * shape.depth_m;
  send();
}

void TabletControl::send(std::optional<double> event_s) {
  device_.move(pointer_, event_s);
  // A simulated device has no hand of its own: the mouse moves it.
  if (const auto* opened = device_.opened(); opened != nullptr && pointer_.in_range)
    if (auto* simulated = dynamic_cast<devices::SimulatedDevice*>(opened->device.get()))
      simulated->set_target({pointer_.x_m, pointer_.y_m,
                             pointer_.pressed ? -pointer_.depth_m : devices::PointerDevice::kHover_m});
  depth_changed(pointer_.depth_m);
  picture_changed();
}

void TabletControl::pump() {
  std::array<haptics::ServoSample, 256> samples;
  for (;;) {
    const auto count = device_.take_samples(samples);
    follow(std::span<const haptics::ServoSample>(samples).first(count));
    if (count < samples.size()) break;
  }
  if (device_.is_pointer()) return;
  const haptics::Vec3& at = device_.latest().device_m;
  if (glm::length(at - seen_m_) <= kSeen_m) return;
  seen_m_ = at;
  picture_changed();
}

void TabletControl::follow(std::span<const haptics::ServoSample> samples) {
  const bool had_bits = !ink_.left_open().empty();
  bool inked = false;
  sampled(samples);
  const bool traced = !sheet_ && (!guides_ || guides_->traced);
  for (const auto& sample : samples) {
    if (!traced) break;
    // A late tick interrupts the contact although the hand did not lift.
    if (haptics::has(sample.events, haptics::ServoEvent::fault)) continue;
    const auto step = ink_.follow(sample.proxy_m, sample.touching, current_);
    inked = inked || step.inked || step.event == TraceEvent::left_open;
    if (step.event != TraceEvent::none) stroke_event(step.event, step.stroke);
  }
  if (!inked) return;
  if (had_bits || !ink_.left_open().empty()) lay_out_writing();
  picture_changed();
}

view::Overlay TabletControl::overlay() {
  view::Overlay overlay;
  overlay.strokes_visible = guides_ ? guides_->strokes : strokes_visible_;
  overlay.arrows_visible = guides_ ? guides_->arrows : arrows_visible_;
  overlay.numbers_visible = guides_ ? guides_->numbers : numbers_visible_;
  overlay.lines_opacity = guides_ ? guides_->lines_opacity : 1.0;
  overlay.current_stroke = current_;
  overlay.groove_ink = demonstration_ ? demonstration_->ink : ink_.progress();
  overlay.writing = drawn_writing_;
  overlay.cross = tablet_ ? cross_ : view::WritingCross::none;
  if (demonstration_) overlay.cursor = demonstration_->brush;
  shown_s_ = 0;
  if (draws_stylus()) {
    const auto& now = device_.latest();
    // A resting stylus shows nothing new, so its sample has no age.
    shown_s_ = device_.is_resting() ? 0 : now.begun_s;
    overlay.cursor = view::Cursor{now.proxy_m, now.device_m, now.touching,
                                  device_.is_pointer() ? axis_ : haptics::Vec3(0)};
  }
  return overlay;
}

void TabletControl::note_drawn() {
  if (shown_s_ <= 0) return;
  const double now_s = std::chrono::duration<double>(clock_.steady().time_since_epoch()).count();
  drawn_age_s_ = std::max(drawn_age_s_, now_s - shown_s_);
}

double TabletControl::take_drawn_age_s() { return std::exchange(drawn_age_s_, 0); }

}  // namespace nazori::practice
