// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/year_calendar.h"

#include <gtest/gtest.h>

#include "learner_under_test.h"
#include "nazori/practice/character_choice.h"

namespace nazori::practice {
namespace {

study::Day day(const char* text) { return *study::parse_day(text); }

study::Statistics studied(const char* today, std::vector<study::DayActivity> days) {
  study::Statistics s;
  s.today = day(today);
  s.days = std::move(days);
  return s;
}

TEST(YearCalendar, EachLevelBeginsAtItsBound) {
  EXPECT_EQ(level_of(0), DayLevel::none);
  EXPECT_EQ(level_of(1), DayLevel::some);
  EXPECT_EQ(level_of(9), DayLevel::some);
  EXPECT_EQ(level_of(10), DayLevel::good);
  EXPECT_EQ(level_of(29), DayLevel::good);
  EXPECT_EQ(level_of(30), DayLevel::much);
  EXPECT_EQ(level_of(59), DayLevel::much);
  EXPECT_EQ(level_of(60), DayLevel::most);
  EXPECT_EQ(level_of(1'000), DayLevel::most);
}

TEST(YearCalendar, HasOneSquareADayAndBeginsOnTheRightDayOfTheWeek) {
  // 1 January 2026 was a Thursday.
  const auto monday = year_calendar(studied("2026-11-22", {}), 2026);
  EXPECT_EQ(monday.days.size(), 365U);
  EXPECT_EQ(monday.before_first, 3);
  EXPECT_EQ(monday.row(0), 3);
  EXPECT_EQ(monday.column(3), 0) << "Sunday 4 January";
  EXPECT_EQ(monday.row(4), 0) << "Monday 5 January";
  EXPECT_EQ(monday.column(4), 1);
  EXPECT_EQ(monday.columns(), 53);
  EXPECT_EQ(year_calendar(studied("2026-11-22", {}), 2026, std::chrono::Sunday).before_first, 4);
}

TEST(YearCalendar, ALeapYearHasItsDay) {
  const auto leap = year_calendar(studied("2028-03-01", {{day("2028-02-29"), 3, 0, 0, {}}}), 2028);
  ASSERT_EQ(leap.days.size(), 366U);
  EXPECT_EQ(leap.days[59].activity.day, day("2028-02-29"));
  EXPECT_EQ(leap.days[59].level, DayLevel::some);
  EXPECT_TRUE(leap.days[60].is_today);
  EXPECT_EQ(leap.days.back().activity.day, day("2028-12-31"));
  // The longest year: it begins on the last day of a week.
  const auto longest = year_calendar(studied("2012-01-01", {}), 2012);
  EXPECT_EQ(longest.before_first, 6);
  EXPECT_EQ(longest.columns(), 54);
}

TEST(YearCalendar, CountsReviewsAndPracticeAndKnowsTodayAndWhatIsToCome) {
  const auto calendar = year_calendar(studied("2026-01-03", {{day("2025-12-31"), 99, 0, 0, {}},
                                                             {day("2026-01-01"), 6, 4, 2, {}},
                                                             {day("2026-01-03"), 1, 0, 0, {}},
                                                             {day("2027-01-01"), 99, 0, 0, {}}}),
                                      2026);
  EXPECT_EQ(calendar.year, 2026);
  EXPECT_EQ(calendar.study_days, 2);
  EXPECT_EQ(calendar.days[0].level, DayLevel::good) << "six from memory and four practised";
  EXPECT_EQ(calendar.days[0].activity.introduced, 2);
  EXPECT_EQ(calendar.days[1].level, DayLevel::none);
  EXPECT_FALSE(calendar.days[1].is_to_come);
  EXPECT_TRUE(calendar.days[2].is_today);
  EXPECT_FALSE(calendar.days[2].is_to_come);
  EXPECT_TRUE(calendar.days[3].is_to_come);
  EXPECT_EQ(calendar.days[364].level, DayLevel::none) << "the next year is another calendar";
  EXPECT_EQ(year_of(day("2025-12-31")), 2025);
}

using YearCalendarOfALearner = LearnerTest;

TEST_F(YearCalendarOfALearner, WhatWasMarkedAsKnownIsNotInIt) {
  ASSERT_TRUE(mark_known(*learner_, U'木'));
  const auto known = study::statistics_of(learner_->store());
  ASSERT_TRUE(known);
  EXPECT_EQ(year_calendar(*known, 2026).study_days, 0);
  EXPECT_EQ(known->reviews, 0);
  EXPECT_EQ(known->streak.days, 0);
  write(U'木');
  const auto written = study::statistics_of(learner_->store());
  ASSERT_TRUE(written);
  EXPECT_EQ(year_calendar(*written, 2026).study_days, 1);
  EXPECT_EQ(written->streak.days, 1);
  EXPECT_EQ(written->days[0].introduced, 0) << "it was known before";
}

}  // namespace
}  // namespace nazori::practice
