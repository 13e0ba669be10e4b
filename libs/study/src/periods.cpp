// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/periods.h"

namespace nazori::study {
namespace {

using std::chrono::days;
using std::chrono::weekday;
using std::chrono::year_month_day;

}  // namespace

Day begin_of(Period period, Day day) {
  switch (period) {
    case Period::day:
      return day;
    case Period::week:
      return day - (weekday(day) - std::chrono::Monday);
    case Period::month: {
      const year_month_day date(day);
      return date.year() / date.month() / 1;
    }
  }
  return day;
}

Day next_of(Period period, Day day) {
  switch (period) {
    case Period::day:
      return day + days(1);
    case Period::week:
      return begin_of(period, day) + days(7);
    case Period::month:
      return begin_of(period, begin_of(period, day) + days(31));
  }
  return day;
}

std::vector<DayActivity> activity_by(Period period, const Statistics& statistics, Day first) {
  std::vector<DayActivity> periods;
  for (const DayActivity& one : statistics.days) {
    if (one.day < first) continue;
    if (periods.empty()) periods.push_back({begin_of(period, std::max(first, one.day)), 0, 0, 0, {}});
    while (next_of(period, periods.back().day) <= one.day)
      periods.push_back({next_of(period, periods.back().day), 0, 0, 0, {}});
    DayActivity& sum = periods.back();
    sum.reviews += one.reviews;
    sum.practices += one.practices;
    sum.introduced += one.introduced;
    sum.time += one.time;
  }
  return periods;
}

std::vector<DayRetention> retention_by(Period period, const Statistics& statistics, Day first) {
  std::vector<DayRetention> periods;
  for (const DayRetention& one : statistics.retention_days) {
    if (one.day < first) continue;
    const Day begin = begin_of(period, one.day);
    if (periods.empty() || periods.back().day != begin) periods.push_back({begin, {}});
    Retention& sum = periods.back().retention;
    const int reviews = sum.reviews + one.retention.reviews;
    sum.predicted = (sum.predicted * sum.reviews + one.retention.predicted * one.retention.reviews) / reviews;
    sum.recalled += one.retention.recalled;
    sum.reviews = reviews;
  }
  return periods;
}

std::vector<DayMotion> motion_by(Period period, const Statistics& statistics, Day first) {
  std::vector<DayMotion> periods;
  for (const DayMotion& one : statistics.motion) {
    if (one.day < first) continue;
    const Day begin = begin_of(period, one.day);
    if (periods.empty() || periods.back().day != begin) periods.push_back({begin, 0, 0, 0});
    DayMotion& sum = periods.back();
    const int writings = sum.writings + one.writings;
    sum.speed = (sum.speed * sum.writings + one.speed * one.writings) / writings;
    sum.smoothness = (sum.smoothness * sum.writings + one.smoothness * one.writings) / writings;
    sum.writings = writings;
  }
  return periods;
}

}  // namespace nazori::study
