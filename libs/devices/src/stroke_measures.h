// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "nazori/devices/simulated_hand.h"
#include "nazori/geometry/point.h"
#include "nazori/haptics/servo.h"

namespace nazori::devices {

/// Sums over the ticks in which one stroke was followed. Real-time-safe: add().
class StrokeMeasures {
 public:
  /// @param line  of the stroke, seen from above; at least one point.
  explicit StrokeMeasures(geometry::Polyline<geometry::TabletFrame> line) : line_(std::move(line)) {}

  /// How far a point is from the line. @param from_above  as seen from there.
  [[nodiscard]] double off_m(geometry::TabletPoint from_above) const noexcept;
  /// One tick. @param stroke  number of this one.  @param aimed  the target of the hand.  @param slips since
  /// the last tick.
  void add(int stroke, geometry::TabletPoint aimed, int slips, const haptics::ServoSample& sample,
           const haptics::Vec3& force_n) noexcept;
  /// Computes the results from the sums. @param followed  its length_m is known.
  void report_to(FollowedStroke& followed) const;

 private:
  geometry::Polyline<geometry::TabletFrame> line_;
  std::uint64_t ticks_ = 0;
  std::uint64_t touching_ = 0;
  std::uint64_t snapped_ = 0;
  double aim_squared_ = 0, aim_max_ = 0;
  double tip_squared_ = 0, tip_max_ = 0;
  double force_ = 0, force_max_ = 0;
  double depth_ = 0;
  double followed_m_ = 0;
  int slips_ = 0;
};

}  // namespace nazori::devices
