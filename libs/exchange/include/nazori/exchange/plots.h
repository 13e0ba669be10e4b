// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nazori/exchange/document.h"
#include "nazori/functions/plate.h"
#include "nazori/functions/points.h"
#include "nazori/functions/value_table.h"

namespace nazori::exchange {

/// How long parts of the work took.
struct PlotTimings {
  double draw_ms = 0;
  double points_ms = 0;
};

/// What is known of a drawn plot (docs/schemas/plots.json, plot). Statements are counted from 1.
[[nodiscard]] Value to_json(const functions::Plot& plot, const functions::Picture& picture,
                            const std::vector<functions::PointOfInterest>& points, const PlotTimings& timings,
                            functions::Language language,
                            functions::SpeechStyle style = functions::SpeechStyle::verbose);
/// A table of values: rows of x and y, null where undefined.
[[nodiscard]] Value to_json(const std::vector<functions::ValueRow>& table);

}  // namespace nazori::exchange
