// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "nazori/geometry/frames.h"
#include "nazori/geometry/written_stroke.h"
#include "nazori/haptics/servo.h"
#include "nazori/writing/written_character.h"

namespace nazori::practice {

/// A stroke as the hand wrote it on the tablet [m], with times of the servo's clock, pressure and lean.
using HandPoint = geometry::WrittenPoint<geometry::TabletFrame>;
using HandStroke = geometry::WrittenStroke<geometry::TabletFrame>;

/// Makes strokes from the samples of the servo: one from each touch of the tablet to the next lift.
class PenRecorder {
 public:
  /// Points closer than this to the previous one are left out [m].
  static constexpr double kStep_m = 0.0003;
  /// Shorter touches are accidental taps, not strokes [m].
  static constexpr double kSlip_m = 0.0012;

  enum class Event : std::uint8_t {
    none,
    grew,   ///< the present stroke has a new point
    ended,  ///< take() has a new stroke
    slip,   ///< the tablet was only tapped
  };

  /// @param full_press_m  distance of the device below the proxy at full pressure.
  explicit PenRecorder(double full_press_m = 0.015) : full_press_m_(full_press_m) {}

  /// A pointer was pressed here. A stylus that follows a pointer needs a few milliseconds to get there; the
  /// points on its way are not written.
  void press_at(geometry::TabletPoint at) { pressed_at_ = at; }

  /// Sets how the pen is held from now on. @param lean_rad  from upright.
  void lean(double lean_rad) { lean_rad_ = lean_rad; }

  Event follow(const haptics::ServoSample& sample);
  /// The stroke being written; empty while the pen is up.
  [[nodiscard]] const HandStroke& current() const { return current_; }
  /// The stroke that ended last.
  [[nodiscard]] HandStroke take() { return std::exchange(ended_, {}); }
  /// Discards the present stroke; nothing is written until the next touch.
  void drop();

 private:
  static constexpr double kFar_m = std::numeric_limits<double>::infinity();

  double full_press_m_;
  double lean_rad_ = 0;
  HandStroke current_;
  HandPoint last_;  ///< of the present touch, whether it moved or not
  HandStroke ended_;
  [[nodiscard]] bool is_on_its_way(geometry::TabletPoint at);

  std::optional<geometry::TabletPoint> pressed_at_;  ///< set while the stylus is on its way there
  double nearest_m_ = kFar_m;                        ///< that it has come
  bool touching_ = false;
  bool dropped_ = false;
};

/// The strokes for grading, in the glyph frame, with times and pressures and the tablet as its box.
[[nodiscard]] writing::WrittenCharacter to_ink(const std::vector<HandStroke>& strokes,
                                               const geometry::TabletShape& shape);

/// The part of a stroke that was written up to a moment of its clock; its last segment ends where the pen
/// was.
[[nodiscard]] HandStroke until(const HandStroke& stroke, double time_s);

}  // namespace nazori::practice
