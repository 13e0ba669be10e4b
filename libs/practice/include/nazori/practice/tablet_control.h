// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "nazori/base/clock.h"
#include "nazori/base/executor.h"
#include "nazori/base/signal.h"
#include "nazori/devices/slope_gain.h"
#include "nazori/devices/tablet_device.h"
#include "nazori/practice/felt_tablet.h"
#include "nazori/practice/traced_ink.h"
#include "nazori/tablet/carved_tablet.h"
#include "nazori/view/tablet_view.h"

namespace nazori::practice {

/// Which strokes are drawn and how they attract the stylus, where a stage decides it instead of the learner's
/// switches.
struct TabletGuides {
  bool strokes = false;  ///< lines, arrowheads and numbers
  bool arrows = false;
  bool numbers = false;
  double lines_opacity = 1;
  bool snapping = false;
  double snapping_strength = 1;  ///< of the usual pull, and of leading, 0..1
  bool leading = false;          ///< a force-feedback device leads the hand, in place of snapping
  bool traced = false;           ///< ink follows the stylus along the strokes
};

/// The tilt of a pen, in degrees from upright.
struct PenTilt {
  double right_deg = 0;
  double towards_learner_deg = 0;
};

/// A brush that writes by itself.
struct Demonstration {
  std::vector<double> ink;  ///< the written share of each stroke
  view::Cursor brush;
  bool moving = false;  ///< the brush is drawn even where a stylus is near
};

/// A flat sheet of paper in place of the tablet.
struct FlatSheet {
  std::shared_ptr<const haptics::SoftTip> tip;  ///< that bends on it; null: nothing to touch yet
  std::vector<haptics::StrokePath> led;         ///< strokes along which the device leads the hand
  std::uint32_t led_times = 0;                  ///< another number begins with the first stroke again
};

/// The state of the tablet: the carved tablet itself, which strokes are shown, whether they attract the
/// stylus, the ink, and the stylus. It uses no OpenGL and no widgets: a view and a toolbar only show its
/// state. Thread: the owner of the inbox.
class TabletControl {
 public:
  /// @param inbox, clock  outlive this. @param wake_at  as for devices::TabletDevice.
  TabletControl(base::Inbox& inbox, const base::Clock& clock, devices::TabletDevice::WakeAt wake_at);
  ~TabletControl();
  TabletControl(const TabletControl&) = delete;
  TabletControl& operator=(const TabletControl&) = delete;

  /// Starts the stylus; everything but touching works without it.
  [[nodiscard]] base::Result<void> start();

  /// Shows another tablet, with all strokes and without ink; null: none.
  void set_tablet(std::shared_ptr<const tablet::CarvedTablet> carved);
  [[nodiscard]] const std::shared_ptr<const tablet::CarvedTablet>& tablet() const { return tablet_; }

  [[nodiscard]] int stroke_count() const;
  /// 0: all strokes, n: stroke n alone.
  [[nodiscard]] int current_stroke() const { return current_; }
  void set_current_stroke(int stroke);
  /// As in the 2005 program: forwards and backwards, both wrapping through 0.
  void next_stroke();
  void previous_stroke();
  /// Does what a button of the stylus is set to do.
  void press_button(devices::ButtonDoes what);

  /// What is shown of the strokes, and whether they attract the stylus.
  struct Switches {
    bool strokes = true;
    bool numbers = true;
    bool arrows = true;
    bool snapping = false;
  };
  [[nodiscard]] Switches switches() const {
    return {strokes_visible_, numbers_visible_, arrows_visible_, snapping_};
  }
  void set_switches(const Switches& to);
  [[nodiscard]] bool strokes_visible() const { return strokes_visible_; }
  [[nodiscard]] bool numbers_visible() const { return numbers_visible_; }
  [[nodiscard]] bool arrows_visible() const { return arrows_visible_; }
  [[nodiscard]] bool snapping() const { return snapping_; }
  /// As in the 2005 program: strokes attract the stylus only while they are shown.
  [[nodiscard]] bool snapping_in_effect() const {
    return guides_ ? guides_->snapping : snapping_ && strokes_visible_;
  }
  [[nodiscard]] view::Style style() const { return style_; }
  void set_strokes_visible(bool on);
  void set_numbers_visible(bool on);
  void set_arrows_visible(bool on);
  void set_snapping(bool on);
  void set_style(view::Style style);
  [[nodiscard]] view::WritingCross cross() const { return cross_; }
  /// Shows thin lines on the tablet, whatever stage is practised.
  void set_cross(view::WritingCross cross);

  /// Lets the stylus feel a sheet instead of the tablet: nothing is traced, and the buttons of the stylus do
  /// nothing here. Nothing: the tablet again.
  void set_sheet(std::optional<FlatSheet> sheet);
  void set_guides(const std::optional<TabletGuides>& guides);
  [[nodiscard]] const std::optional<TabletGuides>& guides() const { return guides_; }
  /// Whether the active device can lead the hand.
  [[nodiscard]] bool can_lead() const { return device_.describe().has_force; }
  /// Flat ink on the tablet, drawn as given.
  void set_writing(std::vector<view::InkedStroke> writing);
  /// Sets the brush. It is shown in place of the learner's ink, and in place of the stylus while the brush
  /// moves or the stylus is away.
  void set_demonstration(std::optional<Demonstration> demonstration);

  void clear_ink();
  /// Removes the ink of the stroke that was inked last.
  void undo_ink();
  [[nodiscard]] const TracedInk& ink() const { return ink_; }

  /// Sets the position of the stylus over the tablet. @param pressure  0..1 of a pen; nothing for a mouse,
  /// whose depth the wheel sets.
  /// @param event_s  when, on the clock of the window system; nothing: now.
  void move_stylus(geometry::TabletPoint at, bool is_down, std::optional<double> pressure = {},
                   std::optional<double> event_s = {});
  void lift_stylus();
  /// Sets the tilt of the pen from now on; nothing for a pen without tilt.
  void lean_stylus(std::optional<PenTilt> tilt);
  /// Tilt of the pen from upright [rad], 0 where it is not known.
  [[nodiscard]] double lean_rad() const { return lean_rad_; }
  /// Makes a mouse move slower up a slope and faster down.
  void set_slope_help(bool on);
  [[nodiscard]] bool slope_help() const { return slope_help_; }
  /// While handwriting is graded, only the hand may move the stylus.
  void set_judged(bool judged);
  /// The material of the tablet.
  void set_material(const haptics::Material& material);
  /// Feels every tablet with a ball of this radius at the tip of the stylus; 0: with a point. The force fades
  /// in when the surface of the ball is ready, a few milliseconds later at 128 samples a side.
  /// @param radius_m  as for FeltTablet::set_radius().
  void set_tip(double radius_m) { felt_.set_radius(radius_m); }
  [[nodiscard]] double tip_radius_m() const { return felt_.radius_m(); }
  /// Pushes the pressed stylus deeper (positive) or less deep, in notches of the wheel.
  void push_stylus(double notches);
  [[nodiscard]] bool is_pressed() const { return pointer_.pressed; }
  [[nodiscard]] double depth_m() const { return pointer_.depth_m; }

  /// Reads the samples of the servo since the last call: updates the ink and emits signals. Shows the missing
  /// part of a stroke that was left before its end. To be called every pump_period().
  void pump();
  /// How often pump() is to be called: more often while something moves.
  [[nodiscard]] std::chrono::milliseconds pump_period() const;
  /// Processes samples as if they came from the servo: for a simulated hand, and for tests.
  void follow(std::span<const haptics::ServoSample> samples);
  [[nodiscard]] const haptics::ServoSample& latest() { return device_.latest(); }
  [[nodiscard]] devices::TabletDevice& device() { return device_; }
  [[nodiscard]] const devices::TabletDevice& device() const { return device_; }

  /// What to draw at this moment.
  [[nodiscard]] view::Overlay overlay();
  /// The picture of the last overlay() is finished: measures the age of the stylus in it.
  void note_drawn();
  /// Greatest age of a drawn stylus since the last call [s], 0 where none was drawn.
  [[nodiscard]] double take_drawn_age_s();
  /// The stylus is over the tablet.
  [[nodiscard]] bool stylus_in_range() const { return !device_.is_pointer() || pointer_.in_range; }
  /// Whether the picture shows the learner's own stylus.
  [[nodiscard]] bool draws_stylus() const {
    return stylus_in_range() && !(demonstration_ && demonstration_->moving);
  }

  base::Signal<> tablet_changed;
  /// The stroke that is shown, a switch, or the style.
  base::Signal<> state_changed;
  base::Signal<> picture_changed;
  base::Signal<TraceEvent, int> stroke_event;
  /// Depth of the pointer's press [m].
  base::Signal<double> depth_changed;
  /// The samples of the servo since the last time, in order.
  base::Signal<std::span<const haptics::ServoSample>> sampled;
  /// A pointer was pressed on the tablet.
  base::Signal<geometry::TabletPoint> pressed;
  /// The other end of the pen touched the tablet.
  base::Signal<> eraser_used;

 private:
  void hand_over_scene();
  void hand_over_sheet();
  void lead_from(int stroke);
  void send(std::optional<double> event_s = {});
  void lay_out_writing();
  template <class T>
  void change(T& value, T to, bool felt);

  std::shared_ptr<const tablet::CarvedTablet> tablet_;
  TracedInk ink_;
  int current_ = 0;
  int led_from_ = 1;  ///< first stroke of leading
  std::uint32_t led_times_ = 0;
  bool strokes_visible_ = true;
  bool numbers_visible_ = true;
  bool arrows_visible_ = true;
  bool snapping_ = false;
  view::Style style_ = view::Style::wood;
  view::WritingCross cross_ = view::WritingCross::none;
  std::optional<FlatSheet> sheet_;
  std::optional<TabletGuides> guides_;
  std::optional<Demonstration> demonstration_;
  std::vector<view::InkedStroke> writing_;
  std::vector<view::InkedStroke> drawn_writing_;  ///< that, and the missing parts of strokes left open
  haptics::Material material_;
  devices::SlopeGain slope_gain_;
  bool slope_help_ = false;
  bool judged_ = false;
  haptics::Vec3 axis_{0};  ///< of the pen, from its tip to the hand; zero: not known
  double lean_rad_ = 0;
  haptics::Vec3 seen_m_{0};  ///< device position when its motion was last reported
  devices::PointerState pointer_;
  double shown_s_ = 0;      ///< begun_s of the sample in the last overlay, 0 none
  double drawn_age_s_ = 0;  ///< greatest since it was taken
  double mouse_depth_;      ///< depth to which the mouse presses, as a fraction of the tablet's depth
  const base::Clock& clock_;
  devices::TabletDevice device_;
  base::Connection leaving_, changed_;
  FeltTablet felt_;  // declared last, so that its thread ends first
};

}  // namespace nazori::practice
