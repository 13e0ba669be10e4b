// SPDX-License-Identifier: Apache-2.0
#pragma once

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
  int stroke = 0;  ///< number of the stroke being traced, 0 on the way from one to the next
  int next = 0;    ///< number of the stroke being traced or gone to, 0 where there are none
};

/// The intentions of a hand that traces strokes one after the other: down onto the start, along the line with
/// an unsteady aim, up, and over to the next. The same strokes give the same plan.
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
  struct Stroke {
    std::vector<haptics::Vec3> points;
    std::vector<double> arc_m;  ///< at each point, seen from above
    double length_m = 0;
    double deepest_m = 0;  ///< below the plateau
    double begin_s = 0;    ///< the way to the start begins
    double tracing_s = 0;
  };
  static std::size_t index(int stroke) { return static_cast<std::size_t>(stroke) - 1; }
  [[nodiscard]] haptics::Vec3 on_line(const Stroke& stroke, double part, int number, double time_s) const;

  Habits habits_;
  std::vector<Stroke> strokes_;
  double duration_s_ = 0;
};

}  // namespace nazori::cli
