// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nazori/study/statistics.h"

namespace nazori::study {

/// Periods into which days are combined when a chart would be too fine.
enum class Period : std::uint8_t { day, week, month };

/// The first day of the period that contains `day`: a Monday, the first of a month.
[[nodiscard]] Day begin_of(Period period, Day day);
/// The first day of the next period.
[[nodiscard]] Day next_of(Period period, Day day);

/// The activity of each period from `first` to the last day with study, including periods without any. `day`
/// is the first day of the period. Empty without study since `first`.
[[nodiscard]] std::vector<DayActivity> activity_by(Period period, const Statistics& statistics, Day first);
/// Retention of each period with reviews that count. @param first  as above.
[[nodiscard]] std::vector<DayRetention> retention_by(Period period, const Statistics& statistics, Day first);
/// Pen motion of each period with ink: means over its writings.
[[nodiscard]] std::vector<DayMotion> motion_by(Period period, const Statistics& statistics, Day first);

}  // namespace nazori::study
