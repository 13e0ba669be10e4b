// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "nazori/practice/chart.h"
#include "nazori/study/statistics.h"

namespace nazori::practice {

/// One of the charts of a learner's statistics.
struct ChartKind {
  ChartId id{};
  std::string_view name;    ///< "forecast": never translated
  bool looks_back = false;  ///< its rows begin at the date that is chosen on the page
  /// Makes the chart from statistics; rows begin at `first` where the chart looks back.
  Chart (*build)(const study::Statistics& statistics, study::Day first);
};

/// Every chart, in the order in which a page shows them.
[[nodiscard]] std::span<const ChartKind> chart_kinds();

/// A chart by its id. @param first  the first day that counts for charts that look back; those that look
/// ahead ignore it. The epoch: everything. @return a chart without rows if nothing was studied.
[[nodiscard]] Chart build_chart(ChartId id, const study::Statistics& statistics, study::Day first = {});

/// The kinds of mistakes of a stroke, the most frequent first; equally frequent ones in the order of
/// kanji::MistakeKind.
[[nodiscard]] std::vector<std::pair<kanji::MistakeKind, int>> mistakes_by_count(
    const study::HardStroke& stroke);

}  // namespace nazori::practice
