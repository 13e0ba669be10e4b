// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/exchange/document.h"
#include "nazori/recording/sample_statistics.h"

namespace nazori::exchange {

/// What a run of samples comes to: the members that demo, feel and record_info of docs/schemas/tablets.json
/// have in common.
[[nodiscard]] Value to_json(const recording::SampleStatistics& samples);

}  // namespace nazori::exchange
