// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "nazori/functions/curve_follower.h"
#include "nazori/functions/points.h"

namespace nazori::functions {

/// The kinds of events while a plot is explored. The window and other programs turn them into sentences.
enum class PlotEventKind : std::uint8_t {
  // The hand is at `location`; `point` is the point of interest there.
  here,            ///< moved along the curve, or the location was requested
  next_branch,     ///< moved from the end of a branch to the next one of the same curve
  end_of_branch,   ///< the branch ends here
  other_branch,    ///< on another curve or branch, of `statement`
  point_reached,   ///< the point of interest with this `number`
  beacon_reached,  ///< the beacon with this `number`
  // The hand stays.
  beacon_dropped,  ///< the beacon with this `number` is at `location`
  slope,           ///< `slope`
  curve_alone,     ///< only `statement` is shown
  all_curves,      ///< every statement is shown
  groove,          ///< the stylus snaps to groove `number` of `count`, of `statement`
  all_grooves,     ///< the stylus snaps to any of `count` grooves
  speed,           ///< of sweeps: `number` of `count`
  window_changed,  ///< to `window`
  // Refused.
  no_curve,         ///< nothing is drawn here that could be followed
  no_other_branch,  ///< there is one only
  no_point,         ///< no point of interest in the window
  no_location,      ///< the hand has no location yet
  no_slope,         ///< where the hand is
  no_beacon,        ///< none was dropped
  only_one_curve,   ///< so it is already alone
  window_limit,     ///< the window cannot be changed further
};

/// An event with its data; members that its kind does not name are not set.
struct PlotEvent {
  PlotEventKind kind = PlotEventKind::here;
  std::optional<PlotLocation> location;
  std::optional<PointOfInterest> point;
  int statement = -1;  ///< index into Plot::statements
  int number = 0;      ///< from 1
  int count = 0;
  double slope = 0;  ///< dy/dx, infinite where the curve is vertical
  Window window;

  /// Whether the stylus and the tone move to `location`.
  [[nodiscard]] bool moves_hand() const { return kind <= PlotEventKind::beacon_reached; }
};

}  // namespace nazori::functions
