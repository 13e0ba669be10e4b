// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/exchange/document.h"
#include "nazori/study/statistics.h"

namespace nazori::exchange {

/// How study goes (docs/schemas/study.json, stats).
[[nodiscard]] Value to_json(const study::Statistics& statistics);
/// What a desired retention would cost (docs/schemas/study.json, workload).
[[nodiscard]] Value to_json(double desired_retention, const study::Workload& workload);

}  // namespace nazori::exchange
