// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "nazori/geometry/frames.h"
#include "nazori/haptics/servo.h"
#include "nazori/view/tablet_view.h"
#include "nazori/writing/ink.h"

namespace nazori::practice {

/// A point of a stroke as the hand wrote it.
struct HandPoint {
  geometry::TabletPoint at;  ///< [m]
  double time_s = 0;         ///< of the servo's clock
  double pressure = 0;       ///< 0..1
  double lean_rad = 0;       ///< of the pen from upright; 0 where that is not known
};
using HandStroke = std::vector<HandPoint>;

/// Makes strokes of what the servo saw: one from each touch of the tablet to the next lift.
class PenRecorder {
 public:
  /// Points closer than this to the one before are left out [m].
  static constexpr double kStep_m = 0.0003;
  /// Shorter touches are slips of the hand, not strokes [m].
  static constexpr double kSlip_m = 0.0012;

  enum class Event : std::uint8_t {
    none,
    grew,   ///< the stroke at hand has a new point
    ended,  ///< take() has a new stroke
    slip,   ///< the tablet was only tapped
  };

  /// @param full_press_m  how deep the device lies below the proxy at full pressure.
  explicit PenRecorder(double full_press_m = 0.015) : full_press_m_(full_press_m) {}

  /// The hand pressed here. A stylus that follows a pointer needs a few milliseconds to get there; what it
  /// glides over on its way is not written.
  void press_at(geometry::TabletPoint at) { pressed_at_ = at; }

  /// How the pen is held from now on. @param lean_rad  from upright.
  void lean(double lean_rad) { lean_rad_ = lean_rad; }

  Event follow(const haptics::ServoSample& sample);
  /// The stroke being written; empty while the pen is up.
  [[nodiscard]] const HandStroke& current() const { return current_; }
  /// The stroke that ended last.
  [[nodiscard]] HandStroke take() { return std::exchange(ended_, {}); }
  /// Forgets the stroke at hand; nothing is written until the next touch.
  void drop();

 private:
  static constexpr double kFar_m = std::numeric_limits<double>::infinity();

  double full_press_m_;
  double lean_rad_ = 0;
  HandStroke current_;
  HandPoint last_;  ///< of the touch at hand, whether it moved or not
  HandStroke ended_;
  [[nodiscard]] bool is_on_its_way(geometry::TabletPoint at);

  std::optional<geometry::TabletPoint> pressed_at_;  ///< while the stylus is on its way there
  double nearest_m_ = kFar_m;                        ///< that it has come
  bool touching_ = false;
  bool dropped_ = false;
};

/// Ink for the judge, in the glyph frame, with times and pressures and the tablet as its box.
[[nodiscard]] writing::Ink to_ink(const std::vector<HandStroke>& strokes, const geometry::TabletShape& shape);

/// What of a stroke was written by a moment of its clock; the last piece is cut where the pen was.
[[nodiscard]] HandStroke until(const HandStroke& stroke, double time_s);

/// Ink for the eye: pressure and lean are width.
[[nodiscard]] view::WrittenStroke to_written(const HandStroke& stroke, view::Verdict verdict);

/// Half of the width of a point's ink [m]: more for a firmer press, and for a brush that lies flatter.
[[nodiscard]] double ink_half_width_m(const HandPoint& point);

}  // namespace nazori::practice
