// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/year_calendar.h"

#include <algorithm>

namespace nazori::practice {

DayLevel level_of(int times) {
  int level = 0;
  for (const int from : kLevelsFrom)
    if (times >= from) ++level;
  return static_cast<DayLevel>(level);
}

int year_of(study::Day day) { return static_cast<int>(std::chrono::year_month_day(day).year()); }

YearCalendar year_calendar(const study::Statistics& statistics, int year, std::chrono::weekday first) {
  YearCalendar calendar;
  calendar.year = year;
  const study::Day begin(std::chrono::year(year) / std::chrono::January / 1);
  const study::Day end(std::chrono::year(year + 1) / std::chrono::January / 1);
  calendar.before_first = static_cast<int>((std::chrono::weekday(begin) - first).count());
  calendar.days.reserve(static_cast<std::size_t>((end - begin).count()));
  auto studied =
      std::lower_bound(statistics.days.begin(), statistics.days.end(), begin,
                       [](const study::DayActivity& one, study::Day day) { return one.day < day; });
  for (study::Day day = begin; day < end; day += std::chrono::days(1)) {
    CalendarDay made;
    made.activity.day = day;
    made.is_today = day == statistics.today;
    made.is_to_come = day > statistics.today;
    if (studied != statistics.days.end() && studied->day == day) made.activity = *studied++;
    made.level = level_of(made.activity.reviews + made.activity.practices);
    if (made.level != DayLevel::none) ++calendar.study_days;
    calendar.days.push_back(made);
  }
  return calendar;
}

}  // namespace nazori::practice
