// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nazori/study/statistics.h"

namespace nazori::study {

/// Days added up for a chart that would be too fine.
enum class Period : std::uint8_t { day, week, month };

/// The first day of the period that holds `day`: a Monday, the first of a month.
[[nodiscard]] Day begin_of(Period period, Day day);
/// The first day of the next period.
[[nodiscard]] Day next_of(Period period, Day day);

/// What was done in each period from `first` to the last day with study, those without any too. `day` is the
/// period's first. Empty without study since `first`.
[[nodiscard]] std::vector<DayActivity> activity_by(Period period, const Statistics& statistics, Day first);
/// Retention in each period that had reviews to count. @param first  as above.
[[nodiscard]] std::vector<DayRetention> retention_by(Period period, const Statistics& statistics, Day first);
/// The pen in each period with ink: means over its writings.
[[nodiscard]] std::vector<DayMotion> motion_by(Period period, const Statistics& statistics, Day first);

}  // namespace nazori::study
