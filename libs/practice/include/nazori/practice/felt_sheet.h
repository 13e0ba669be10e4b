// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "nazori/base/executor.h"
#include "nazori/base/latest.h"
#include "nazori/base/signal.h"
#include "nazori/brush/force_table.h"
#include "nazori/brush/pen.h"
#include "nazori/practice/tablet_control.h"

namespace nazori::practice {

/// A sheet of paper under a force-feedback device: the device pushes back as the brush does that bends on the
/// paper, its movement is that of a pen, and it can lead the hand as a teacher does. The sheet lies where the
/// tablet does, at its real size, its surface at the height of the plateau. Without such a device nothing
/// happens. Thread: the owner of the inbox.
class FeltSheet {
 public:
  /// Every so many samples of a device that touches the paper become a sample of a pen.
  static constexpr int kEvery = 4;

  /// @param inbox, tablet  outlive this. @param now_s  the time of the pen [s], on a clock that runs evenly.
  FeltSheet(base::Inbox& inbox, TabletControl& tablet, std::function<double()> now_s);

  /// The device feels the sheet instead of the tablet.
  void enter();
  /// The device feels the tablet again. A stroke that is under way is lost: pen_lost() tells of it.
  void leave();
  /// Whether a force-feedback device feels the sheet.
  [[nodiscard]] bool is_felt() const { return entered_ && tablet_.can_lead(); }
  /// Whether the device has no hand of its own: move_hand() moves it.
  [[nodiscard]] bool has_no_hand() const;
  /// Moves the hand that holds a simulated device. @param pressure  0..1 of a pen; nothing for a mouse.
  void move_hand(geometry::PaperPoint at, bool is_down, std::optional<double> pressure);

  /// Another brush. What it feels like is computed on another thread; until then the old one is felt.
  void set_brush(const brush::TuftForm& form);
  /// How wet the hair is, 0..1. Steps too small to be felt change nothing.
  void set_wetness(double wetness);
  void set_feel(brush::Feel feel);
  /// The tilt of the holder, which no device reports.
  void set_tilt(double lean_rad, double lean_to_rad);
  /// Whether what is felt is still being computed.
  [[nodiscard]] bool is_preparing() const { return preparing_.is_busy(); }

  /// Leads the hand along the strokes of a teacher. It waits where the learner resists, and ends with led()
  /// or stop_leading(). @param hand  as calligraphy::teacher_hand() gives it, with pressures.
  /// @return false where no device is felt, or there is no stroke to lead along.
  bool lead(std::span<const brush::PenSample> hand);
  void stop_leading();
  [[nodiscard]] bool is_leading() const { return !led_.empty(); }

  /// The device moved on the paper, or left it. Times are those of now_s.
  base::Signal<const brush::PenSample&> pen_moved;
  /// A stroke ends without a last position: another device, or none.
  base::Signal<> pen_lost;
  /// Where the device is above the paper.
  base::Signal<geometry::PaperPoint> pointed;
  /// A button of the device was pressed.
  base::Signal<> button_pressed;
  /// The last stroke of the teacher was written.
  base::Signal<> led;

 private:
  using Table = std::shared_ptr<const brush::ForceTable>;

  void follow(std::span<const haptics::ServoSample> samples);
  void move(const haptics::ServoSample& sample);
  void lose_pen();
  void hand_over();

  TabletControl& tablet_;
  std::function<double()> now_s_;
  Table table_;
  double wetness_ = 1;
  brush::Feel feel_ = brush::Feel::strengthened;
  double lean_rad_ = 0, lean_to_rad_ = 0;
  std::vector<haptics::StrokePath> led_;
  std::uint32_t led_times_ = 0;
  bool entered_ = false;
  bool is_down_ = false;
  int since_ = 0;       ///< samples since the last one that was passed on
  double later_s_ = 0;  ///< the clock of the pen, less that of the servo
  base::Connection sampled_, changed_, pressed_;
  base::Latest<brush::TuftForm, Table> preparing_;  // declared last, so that its thread ends first
};

}  // namespace nazori::practice
