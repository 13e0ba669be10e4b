// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "character_json.h"
#include "nazori/recording/sample_statistics.h"

namespace nazori::cli {

/// What a run of samples comes to, for programs: its members are told in docs/command-line.md.
[[nodiscard]] Json statistics_json(const recording::SampleStatistics& samples);

/// The same for people, in lines that end in a line feed.
[[nodiscard]] std::string statistics_text(const recording::SampleStatistics& samples, double rate_hz);

}  // namespace nazori::cli
