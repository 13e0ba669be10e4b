// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nazori/base/progress.h"
#include "nazori/base/result.h"
#include "nazori/devices/simulated_device.h"
#include "nazori/haptics/servo.h"
#include "nazori/tablet/carved_tablet.h"

namespace nazori::cli {

/// How well the tablet held the hand along one stroke.
struct StrokeTrace {
  int stroke = 0;
  double length_m = 0;
  double duration_s = 0;
  double aim_rms_m = 0;  ///< how far off the line the hand wanted to be
  double aim_max_m = 0;
  double tip_rms_m = 0;  ///< how far off the line the tip was held while it touched, seen from above
  double tip_max_m = 0;
  double mean_force_n = 0;  ///< that the servo sent, and its peak
  double peak_force_n = 0;
  double contact_share = 0;  ///< of the ticks
  double snapped_share = 0;  ///< of the ticks in which this stroke held the stylus
  double mean_depth_m = 0;   ///< of the tip below the plateau while it touched
  int slips = 0;             ///< how often the tip went astray and the hand had to lift and come back
  double traced_share = 0;   ///< of the stroke's length, 0..1
};

/// A whole character traced.
struct TabletTrace {
  std::vector<StrokeTrace> strokes;
  haptics::ServoTiming timing;
  devices::ClockStatus clock;  ///< of the clock thread, at Pace::real_time
};

enum class Pace { fast, real_time };

/// Lets a simulated hand trace every stroke of `tablet` through the servo at 1 kHz. At Pace::fast the ticks
/// follow each other without waiting and the result is the same every time; at Pace::real_time they run on
/// the clock thread.
/// @return Errc::cancelled when `progress` says so, the clock thread's errors.
[[nodiscard]] base::Result<TabletTrace> trace(const tablet::CarvedTablet& tablet,
                                              const devices::SimulatedHardware& hardware, bool snapping,
                                              Pace pace, const base::Progress& progress);

}  // namespace nazori::cli
