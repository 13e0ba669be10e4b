// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "nazori/study/statistics.h"

namespace nazori::practice {

/// How much was studied on a day, by the number of times that a character was written from memory or
/// practised in another stage.
enum class DayLevel : std::uint8_t {
  none,  ///< nothing
  some,  ///< 1 to 9 times
  good,  ///< 10 to 29 times
  much,  ///< 30 to 59 times
  most,  ///< 60 times and more
};
/// The smallest number of times of each level but `none`, in their order.
inline constexpr std::array kLevelsFrom{1, 10, 30, 60};
/// The level of a number of times. @param times  >= 0.
[[nodiscard]] DayLevel level_of(int times);

/// One day of a calendar.
struct CalendarDay {
  study::DayActivity activity;  ///< `day` is always set
  DayLevel level = DayLevel::none;
  bool is_today = false;
  bool is_to_come = false;  ///< after today

  friend bool operator==(const CalendarDay&, const CalendarDay&) = default;
};

/// The days of a calendar year.
struct YearCalendar {
  int year = 0;
  int before_first = 0;           ///< days of the first week before 1 January, 0..6
  std::vector<CalendarDay> days;  ///< from 1 January: 365, or 366 in a leap year
  int study_days = 0;             ///< days of the year on any level but `none`

  /// The column (week) of a day, by its index in `days`.
  [[nodiscard]] int column(int index) const { return (index + before_first) / 7; }
  /// The row (day of the week) of a day, by its index in `days`; 0 is the first day of the week.
  [[nodiscard]] int row(int index) const { return (index + before_first) % 7; }
  /// The number of columns.
  [[nodiscard]] int columns() const {
    return days.empty() ? 0 : column(static_cast<int>(days.size()) - 1) + 1;
  }
};

/// The calendar of a year. @param first  the day with which a week begins.
[[nodiscard]] YearCalendar year_calendar(const study::Statistics& statistics, int year,
                                         std::chrono::weekday first = std::chrono::Monday);
/// The calendar year of a day.
[[nodiscard]] int year_of(study::Day day);

}  // namespace nazori::practice
