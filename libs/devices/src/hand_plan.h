// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "nazori/devices/simulated_hand.h"
#include "nazori/geometry/stroke_pace.h"
#include "nazori/haptics/haptic_scene.h"

namespace nazori::devices {

/// The target of a hand at one moment.
struct HandIntent {
  haptics::Vec3 target_m{0, 0, 0};
  haptics::Vec3 line_m{0, 0, 0};  ///< the present point of the line, while following a stroke
  haptics::Vec3 along{0, 0, 0};   ///< unit vector along the line there, seen from above; while following
  int movement = 0;               ///< counts the movements, between halts at sharp turns, through all strokes
  int stroke = 0;                 ///< number of the stroke being followed, 0 between two strokes
  int next = 0;                   ///< number of the stroke being followed or gone to, 0 where there are none
};

/// The planned motion of a hand that follows strokes one after the other: down onto the start, along the line
/// with an unsteady aim and a halt at each sharp turn, up, and over to the next. The same strokes give the
/// same plan. Immutable. Thread-safe: yes. Real-time-safe: all but the constructor.
class HandPlan {
 public:
  HandPlan(std::span<const haptics::StrokePath> strokes, const HandHabits& habits);

  [[nodiscard]] double duration_s() const { return duration_s_; }
  /// @param time_s  from the start; limited to 0..duration_s().
  [[nodiscard]] HandIntent at(double time_s) const noexcept;

  /// Length of a stroke's line seen from above. @param stroke 1..
  [[nodiscard]] double length_m(int stroke) const { return strokes_[index(stroke)].length_m; }
  /// Duration of following its line. @param stroke 1..
  [[nodiscard]] double following_s(int stroke) const { return strokes_[index(stroke)].pace.duration_s(); }

 private:
  struct Stroke {
    std::vector<haptics::Vec3> points;
    std::vector<double> arc_m;  ///< at each point, seen from above
    geometry::StrokePace pace;  ///< one movement from each sharp turn to the next
    double length_m = 0;
    double deepest_m = 0;  ///< below the plateau
    double begin_s = 0;    ///< when the motion to the start begins
    int first_movement = 0;
  };
  /// A point of a line and the direction there, seen from above.
  struct Heading {
    haptics::Vec3 point_m;
    haptics::Vec3 along;
  };
  static std::size_t index(int stroke) { return static_cast<std::size_t>(stroke) - 1; }
  static Heading heading(const Stroke& stroke, double arc_m) noexcept;
  static std::vector<double> sharp_turns(const Stroke& stroke);
  [[nodiscard]] haptics::Vec3 aim(const Stroke& stroke, const Heading& at, double arc_m, int number,
                                  double time_s) const noexcept;
  [[nodiscard]] HandIntent following(const Stroke& stroke, double since_s, int number,
                                     double time_s) const noexcept;

  HandHabits habits_;
  std::vector<Stroke> strokes_;
  double duration_s_ = 0;
};

}  // namespace nazori::devices
