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

/// The result of a simulated hand on a tablet.
struct FollowedTablet {
  devices::HandReport hand;
  recording::SampleStatistics samples;  ///< of all ticks, including those between strokes
};

/// The file of the recording, and the name of the character in it.
struct Record {
  std::filesystem::path path;
  std::string character;
};

/// Makes a simulated hand follow every stroke of `tablet` through the servo. With `record`, every tick is
/// recorded.
/// @return Errc::cancelled when `progress` stops it, the errors of the clock thread and of SessionRecorder.
[[nodiscard]] base::Result<FollowedTablet> follow_strokes(const tablet::CarvedTablet& tablet,
                                                          const devices::SimulatedHardware& hardware,
                                                          bool snapping, devices::HandClock clock,
                                                          const std::optional<Record>& record,
                                                          const base::Progress& progress);

}  // namespace nazori::cli
