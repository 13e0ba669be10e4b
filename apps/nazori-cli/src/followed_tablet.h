// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "nazori/base/progress.h"
#include "nazori/base/result.h"
#include "nazori/devices/simulated_hand.h"
#include "nazori/recording/sample_statistics.h"
#include "nazori/tablet/carved_tablet.h"

namespace nazori::cli {

/// What a simulated hand met on a tablet.
struct FollowedTablet {
  devices::HandReport hand;
  recording::SampleStatistics samples;  ///< of all ticks, on the way from stroke to stroke too
};

/// Where what the servo does is recorded to, and the name of the character in the recording.
struct Record {
  std::filesystem::path path;
  std::string character;
};

/// Lets a simulated hand follow every stroke of `tablet` through the servo. With `record`, every tick goes to
/// a recording.
/// @return Errc::cancelled when `progress` says so, the errors of the clock thread and of SessionRecorder.
[[nodiscard]] base::Result<FollowedTablet> follow_strokes(const tablet::CarvedTablet& tablet,
                                                          const devices::SimulatedHardware& hardware,
                                                          bool snapping, devices::HandClock clock,
                                                          const std::optional<Record>& record,
                                                          const base::Progress& progress);

}  // namespace nazori::cli
