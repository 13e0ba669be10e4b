// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "nazori/geometry/point.h"
#include "nazori/haptics/haptic_scene.h"

namespace nazori::ui {

/// What following the stylus brought to light.
enum class InkEvent : std::uint8_t {
  none,
  began,         ///< the stylus came down on a stroke's start or where its ink ends
  finished,      ///< its end was reached
  too_early,     ///< a stroke was taken up while an earlier one is still to write
  from_the_end,  ///< the stylus came down at the far end of an unwritten stroke
};

/// Ink follows the stylus along the strokes: only forwards, only from a stroke's start or from where its ink
/// ends, and only while the stylus stays near the line. So crossing a groove leaves no stain on it.
class InkTracker {
 public:
  /// How far beside the line still counts as on it, and how far ahead of the ink the stylus may be [m].
  static constexpr double kReach_m = 0.0055;

  struct Step {
    InkEvent event = InkEvent::none;
    int stroke = 0;      ///< the stroke it is about, from 1
    bool inked = false;  ///< ink moved on
  };

  /// Takes new strokes, all without ink.
  void set_strokes(std::span<const haptics::StrokePath> strokes);
  void clear();
  /// Takes the ink off the stroke that took ink up last. @return that stroke, 0 where there is no ink.
  int undo();

  /// One sample of the stylus. @param only  0: any stroke may be written, n: only stroke n.
  Step follow(const haptics::Vec3& proxy_m, bool touching, int only);

  /// Part of each stroke that is inked, 0..1.
  [[nodiscard]] const std::vector<double>& progress() const { return progress_; }
  /// The first stroke that is not finished; 0 when all are.
  [[nodiscard]] int next_stroke() const;
  [[nodiscard]] bool is_finished(int stroke) const;

 private:
  struct Line {
    geometry::Polyline<geometry::TabletFrame> points;
    double length_m = 0;
  };

  Step take_up(geometry::TabletPoint at, int only, bool coming_down);
  Step advance(geometry::TabletPoint at);

  std::vector<Line> lines_;
  std::vector<double> progress_;
  std::vector<int> inked_;     ///< strokes with ink, from 1, in the order they took it up
  int active_ = 0;             ///< stroke under the stylus, from 1
  bool was_touching_ = false;  ///< advice is given only as the stylus comes down
};

}  // namespace nazori::ui
