// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "nazori/geometry/stroke_pace.h"
#include "nazori/haptics/haptic_scene.h"
#include "nazori/haptics/stroke_index.h"

namespace nazori::haptics {

/// The strokes of a character prepared for guidance: lines as seen from above, the depth along them, and a
/// teacher's writing speed at every point. Arc lengths are measured as seen from above, so that a line does
/// not become longer by going down into its groove. Immutable. Thread-safe: yes. Real-time-safe: all but the
/// constructor.
class GuidancePlan {
 public:
  /// At a bend of this radius the teacher slows down to 0.79 (cube root of a half) of the speed on a
  /// straight.
  static constexpr double kBend_m = 0.01;
  /// The bend at a point is measured over this length before and after it, so a corner is this wide.
  static constexpr double kWindow_m = 0.0015;
  /// Most acceleration along the line [m/s^2], from the start and towards the end and every slower point.
  static constexpr double kAcceleration = 0.25;
  /// Fraction of the speed at the start and the end, so that the target starts to move and arrives.
  static constexpr double kSlowest = 0.25;

  GuidancePlan() = default;
  /// @param speed_m_s  on a straight line.
  /// @source speed from the bend: v = c (R / (1 + a R))^(1/3), the two-thirds power law with its limit on a
  /// straight: P. Viviani, R. Schneider, A developmental study of the relationship between geometry and
  /// kinematics in drawing movements, J. Experimental Psychology: HPP 17(1), 1991; F. Lacquaniti, C.
  /// Terzuolo, P. Viviani, The law relating the kinematic and figural aspects of drawing movements, Acta
  /// Psychologica 54, 1983. The limit of acceleration: own design.
  GuidancePlan(std::span<const StrokePath> strokes, double speed_m_s);

  /// Number of strokes, including those without points.
  [[nodiscard]] std::int32_t strokes() const noexcept { return static_cast<std::int32_t>(paces_.size()); }
  /// First stroke with points from number `from` on; 0 none.
  [[nodiscard]] std::int32_t stroke_from(std::int32_t from) const noexcept;
  /// Lines at z = 0.
  [[nodiscard]] const StrokeIndex& lines() const noexcept { return lines_; }
  [[nodiscard]] double length_m(std::int32_t stroke) const noexcept {
    return paces_[static_cast<std::size_t>(stroke) - 1].length();
  }
  /// Depth of the groove at a location of lines().
  [[nodiscard]] double depth_m(const StrokeIndex::Hit& hit) const noexcept {
    const Depth& d = depths_m_[static_cast<std::size_t>(hit.segment)];
    return d.from + hit.along * (d.to - d.from);
  }
  /// The teacher's speed at `arc_m` of `stroke`.
  [[nodiscard]] double speed_m_s(std::int32_t stroke, double arc_m) const noexcept {
    return paces_[static_cast<std::size_t>(stroke) - 1].speed_at(arc_m);
  }

 private:
  struct Depth {
    double from, to;
  };
  [[nodiscard]] geometry::StrokePace pace_of(std::int32_t stroke, double length_m, double speed_m_s,
                                             double most_step_m) const;

  StrokeIndex lines_;
  std::vector<Depth> depths_m_;  // by segment of lines_
  // By stroke: speeds at equally spaced arc lengths, both ends among them, linear in between; empty without
  // points.
  std::vector<geometry::StrokePace> paces_;
};

}  // namespace nazori::haptics
