// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "nazori/haptics/haptic_scene.h"

namespace nazori::cli {

/// How a learner's hand moves who does not look closely.
struct Habits {
  double speed_m_s = 0.05;   ///< along a stroke, once under way
  double wander_m = 0.0008;  ///< how far off the line the hand strays, root mean square
  double press_m = 0.006;    ///< how far below the groove's floor the hand wants to be
  double hover_m = 0.006;    ///< above the plateau between strokes
};

/// Where a hand wants the tip at some moment.
struct Intent {
  haptics::Vec3 target_m{0, 0, 0};
  haptics::Vec3 line_m{0, 0, 0};  ///< the place of the line that it is at, while tracing
  haptics::Vec3 along{0, 0, 0};   ///< unit vector along the line there, seen from above; while tracing
  int piece = 0;                  ///< counts the pieces between the sharp turns of all strokes
  int stroke = 0;                 ///< number of the stroke being traced, 0 on the way from one to the next
  int next = 0;                   ///< number of the stroke being traced or gone to, 0 where there are none
};

/// The intentions of a hand that traces strokes one after the other: down onto the start, along the line with
/// an unsteady aim and a halt at each sharp turn, up, and over to the next. The same strokes give the same
/// plan.
class TracingPlan {
 public:
  TracingPlan(const std::vector<haptics::StrokePath>& strokes, const Habits& habits);

  [[nodiscard]] double duration_s() const { return duration_s_; }
  /// @param time_s  from the start; held within 0..duration_s().
  [[nodiscard]] Intent at(double time_s) const;

  /// Length of a stroke's line seen from above. @param stroke 1..
  [[nodiscard]] double length_m(int stroke) const { return strokes_[index(stroke)].length_m; }
  /// How long its line is traced. @param stroke 1..
  [[nodiscard]] double tracing_s(int stroke) const { return strokes_[index(stroke)].tracing_s; }

 private:
  /// A part of a stroke between sharp turns.
  struct Piece {
    double from_m;  ///< arc length
    double to_m;
    double begin_s;  ///< from the start of the tracing
    double moving_s;
  };
  struct Stroke {
    std::vector<haptics::Vec3> points;
    std::vector<double> arc_m;  ///< at each point, seen from above
    std::vector<Piece> pieces;
    double length_m = 0;
    double deepest_m = 0;  ///< below the plateau
    double begin_s = 0;    ///< the way to the start begins
    double tracing_s = 0;
    int first_piece = 0;
  };
  /// A place on a line and the direction there, seen from above.
  struct Place {
    haptics::Vec3 point_m;
    haptics::Vec3 along;
  };
  static std::size_t index(int stroke) { return static_cast<std::size_t>(stroke) - 1; }
  static Place place(const Stroke& stroke, double arc_m);
  static std::vector<double> sharp_turns(const Stroke& stroke);
  [[nodiscard]] haptics::Vec3 aim(const Stroke& stroke, const Place& place, double arc_m, int number,
                                  double time_s) const;
  [[nodiscard]] Intent tracing(const Stroke& stroke, double since_s, int number, double time_s) const;

  Habits habits_;
  std::vector<Stroke> strokes_;
  double duration_s_ = 0;
};

}  // namespace nazori::cli
