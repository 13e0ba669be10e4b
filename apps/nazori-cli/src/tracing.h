// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "nazori/base/progress.h"
#include "nazori/base/result.h"
#include "nazori/devices/simulated_device.h"
#include "nazori/haptics/servo.h"
#include "nazori/recording/sample_statistics.h"
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
  recording::SampleStatistics samples;  ///< of all ticks, on the way from stroke to stroke too
  double work_on_hand_j = 0;  ///< that the device's motors did at the tip; negative: the tablet took energy
  haptics::ServoTiming timing;
  double p999_tick_s = 0;      ///< 99.9 % of the ticks took no longer, to within 3 %
  double p999_lateness_s = 0;  ///< 99.9 % began no later after their due time, at Pace::real_time
  devices::ClockStatus clock;  ///< of the clock thread, at Pace::real_time
};

enum class Pace { fast, real_time };

/// Where a session is recorded to, and how what is traced is called in it.
struct Record {
  std::filesystem::path path;
  std::string character;
};

/// Lets a simulated hand trace every stroke of `tablet` through the servo at 1 kHz. At Pace::fast the ticks
/// follow each other without waiting and the result is the same every time; at Pace::real_time they run on
/// the clock thread. With `record`, every tick goes to a recording.
/// @return Errc::cancelled when `progress` says so, the errors of the clock thread and of SessionRecorder.
[[nodiscard]] base::Result<TabletTrace> trace(const tablet::CarvedTablet& tablet,
                                              const devices::SimulatedHardware& hardware, bool snapping,
                                              Pace pace, const std::optional<Record>& record,
                                              const base::Progress& progress);

}  // namespace nazori::cli
