// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "nazori/geometry/point.h"
#include "nazori/haptics/haptic_scene.h"

namespace nazori::practice {

/// Events of tracking the stylus.
enum class TraceEvent : std::uint8_t {
  none,
  began,         ///< the stylus came down on a stroke's start or where its ink ends
  finished,      ///< its end was reached
  too_early,     ///< a stroke was begun while an earlier one is not yet written
  from_the_end,  ///< the stylus came down at the far end of an unwritten stroke
  left_open,     ///< the stylus left a stroke before its end
};

/// Ink follows the stylus along the strokes: only forwards, only from a stroke's start or from where its ink
/// ends, and only while the stylus stays near the line. So crossing a groove leaves no ink in it.
///
/// A hand that traces with care lifts a little before the end as often as after it, and a stylus with
/// friction lags behind the hand. So a stroke is finished as soon as the stylus comes very near its end, or
/// is lifted near it.
class TracedInk {
 public:
  /// How far beside the line still counts as on it, and how far ahead of the ink the stylus may be [m].
  static constexpr double kReach_m = 0.0055;
  /// A stroke counts as finished if at most this length is left when the stylus is lifted [m], and at most
  /// this share of its length.
  static constexpr double kLeft_m = 0.005;
  static constexpr double kLeftShare = 0.25;

  struct Step {
    TraceEvent event = TraceEvent::none;
    int stroke = 0;      ///< the stroke it is about, from 1
    bool inked = false;  ///< ink moved on
  };

  /// Sets new strokes, all without ink.
  void set_strokes(std::span<const haptics::StrokePath> strokes);
  void clear();
  /// Removes the ink of the stroke that was inked last. @return that stroke, 0 where there is no ink.
  int undo();

  /// Processes one sample of the stylus. @param only  0: any stroke may be written, n: only stroke n.
  Step follow(const haptics::Vec3& proxy_m, bool touching, int only);

  /// Part of each stroke that is inked, 0..1.
  [[nodiscard]] const std::vector<double>& progress() const { return progress_; }
  /// The first stroke that is not finished; 0 when all are.
  [[nodiscard]] int next_stroke() const;
  [[nodiscard]] bool is_finished(int stroke) const;
  /// Strokes that were left before their end, from 1 in their order.
  [[nodiscard]] const std::vector<int>& left_open() const { return left_open_; }
  /// The part of a stroke without ink, from where its ink ends.
  [[nodiscard]] geometry::Polyline<geometry::TabletFrame> missing_bit(int stroke) const;

 private:
  struct Line {
    geometry::Polyline<geometry::TabletFrame> points;
    double length_m = 0;
  };
  /// A stroke that the stylus may be following in this touch.
  struct Candidate {
    int stroke = 0;         ///< from 1
    double before_m = 0;    ///< its ink when the stylus arrived
    double front_m = 0;     ///< how far its ink would reach now
    bool is_meant = false;  ///< the stylus came down there and did not only pass by
  };

  Step take_up(geometry::TabletPoint at, int only, bool coming_down);
  Step advance(geometry::TabletPoint at, int only);
  Step lift();
  Step finish(int stroke);
  bool follow_on(Candidate& candidate, geometry::TabletPoint at) const;
  void set_ink(int stroke, double front_m);
  [[nodiscard]] const Line& line_of(int stroke) const { return lines_[static_cast<std::size_t>(stroke - 1)]; }
  [[nodiscard]] double inked_m(int stroke) const;
  [[nodiscard]] bool may_end(const Candidate& candidate) const;

  std::vector<Line> lines_;
  std::vector<double> progress_;
  std::vector<int> inked_;      ///< strokes with ink, from 1, in the order in which they were inked
  std::vector<int> left_open_;  ///< of those, ascending
  /// Where strokes begin close together, only the further path of the hand shows which one it follows: the
  /// first one takes the ink.
  std::vector<Candidate> followed_;
  Candidate lost_;             ///< last stroke that was inked in this touch; the stylus has left it since
  geometry::TabletPoint at_;   ///< of the newest touch
  bool was_touching_ = false;  ///< advice is given only as the stylus comes down
};

}  // namespace nazori::practice
