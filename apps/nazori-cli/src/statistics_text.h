// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "nazori/recording/sample_statistics.h"

namespace nazori::cli {

/// What a run of samples comes to, for people, in lines that end in a line feed.
[[nodiscard]] std::string statistics_text(const recording::SampleStatistics& samples, double rate_hz);

}  // namespace nazori::cli
