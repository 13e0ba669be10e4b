// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/calendar.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace nazori::study {
namespace {

Day day(const char* text) { return *parse_day(text); }
Time at(const char* text) { return *parse_time(text); }

TEST(Calendar, TheDayBeginsAtFourInTheMorning) {
  const auto tokyo = Calendar::create("Asia/Tokyo");
  ASSERT_TRUE(tokyo);
  EXPECT_EQ(tokyo->day_of(at("2026-01-02T03:59:59+09:00")), day("2026-01-01"));
  EXPECT_EQ(tokyo->day_of(at("2026-01-02T04:00:00+09:00")), day("2026-01-02"));
  EXPECT_EQ(tokyo->begin_of(day("2026-01-02")), at("2026-01-02T04:00:00+09:00"));
}

TEST(Calendar, TheSameMomentIsAnotherDayElsewhere) {
  const Time moment = at("2026-06-01T20:00:00Z");
  EXPECT_EQ(Calendar::create("Asia/Tokyo")->day_of(moment), day("2026-06-02"));
  EXPECT_EQ(Calendar::create("America/New_York")->day_of(moment), day("2026-06-01"));
}

TEST(Calendar, DaysOnWhichTheClocksChangeAreShorterOrLonger) {
  // Central Europe 2026: forward on 29 March at 01:00 UTC, back on 25 October at 01:00 UTC.
  const auto berlin = Calendar::create("Europe/Berlin");
  ASSERT_TRUE(berlin);
  using std::chrono::days;
  using std::chrono::hours;
  const auto length = [&](const char* date) {
    return berlin->begin_of(day(date) + days(1)) - berlin->begin_of(day(date));
  };
  EXPECT_EQ(length("2026-03-28"), hours(23));
  EXPECT_EQ(length("2026-03-29"), hours(24));
  EXPECT_EQ(length("2026-10-24"), hours(25));
  EXPECT_EQ(berlin->day_of(at("2026-03-29T01:59:00Z")), day("2026-03-28"));
  EXPECT_EQ(berlin->day_of(at("2026-03-29T02:00:00Z")), day("2026-03-29"));
}

TEST(Calendar, EveryMomentLiesInTheDayItsDayBegins) {
  // Times when clocks are changed: by an hour at night or at midnight, by half an hour, by a whole day.
  struct Change {
    const char* zone;
    const char* around;
  };
  for (const auto& [zone, around] :
       {Change{"Europe/Berlin", "2026-03-29T00:00Z"}, Change{"Europe/Berlin", "2026-10-25T00:00Z"},
        Change{"America/Sao_Paulo", "2018-02-18T00:00Z"}, Change{"America/Sao_Paulo", "2018-11-04T00:00Z"},
        Change{"Australia/Lord_Howe", "2026-04-05T00:00Z"},
        Change{"Australia/Lord_Howe", "2026-10-04T00:00Z"}, Change{"Asia/Tokyo", "2026-03-29T00:00Z"},
        Change{"Pacific/Apia", "2011-12-30T00:00Z"}}) {
    for (const int hour : {0, 2, 4}) {
      const auto calendar = Calendar::create(zone, hour);
      ASSERT_TRUE(calendar) << zone;
      for (Time t = at(around) - std::chrono::hours(96); t < at(around) + std::chrono::hours(96);
           t += std::chrono::minutes(7)) {
        const Day own = calendar->day_of(t);
        EXPECT_LE(calendar->begin_of(own), t) << zone << " " << to_text(t);
        EXPECT_GT(calendar->begin_of(own + std::chrono::days(1)), t) << zone << " " << to_text(t);
      }
    }
  }
}

TEST(Calendar, TakesTheZoneOfTheEnvironment) {
  ASSERT_EQ(::setenv("TZ", "Asia/Tokyo", 1), 0);
  EXPECT_EQ(Calendar::create("")->zone(), "Asia/Tokyo");
  ASSERT_EQ(::unsetenv("TZ"), 0);
}

TEST(Calendar, TheDayMayBeginFromMidnightToNoon) {
  for (int hour = -1; hour <= 13; ++hour) {
    const auto calendar = Calendar::create("UTC", hour);
    EXPECT_EQ(calendar.has_value(), hour >= 0 && hour <= 12) << hour;
    if (!calendar) continue;
    const Time begin = at("2026-01-02T00:00Z") + std::chrono::hours(hour);
    EXPECT_EQ(calendar->begin_of(day("2026-01-02")), begin);
    EXPECT_EQ(calendar->day_of(begin), day("2026-01-02"));
    EXPECT_EQ(calendar->day_of(begin - std::chrono::milliseconds(1)), day("2026-01-01"));
  }
}

TEST(Calendar, AZoneOfTheEnvironmentThatIsNoneIsPassedOver) {
  for (const auto& [variable, zone] :
       {std::pair(":Asia/Tokyo", "Asia/Tokyo"), std::pair("Europe/Berlin", "Europe/Berlin")}) {
    ASSERT_EQ(::setenv("TZ", variable, 1), 0);
    EXPECT_EQ(Calendar::create("")->zone(), zone);
  }
  ASSERT_EQ(::unsetenv("TZ"), 0);
  const std::string own = Calendar::create("")->zone();
  for (const char* none : {"", "Mars/Olympus", ":"}) {
    ASSERT_EQ(::setenv("TZ", none, 1), 0);
    EXPECT_EQ(Calendar::create("")->zone(), own) << none;
  }
  ASSERT_EQ(::unsetenv("TZ"), 0);
  EXPECT_EQ(Calendar::create("Asia/Tokyo")->zone(), "Asia/Tokyo");
}

TEST(Calendar, RefusesWhatIsNoZoneOrHour) {
  EXPECT_EQ(Calendar::create("Mars/Olympus").error().where, "time zone");
  EXPECT_EQ(Calendar::create("UTC", 13).error().where, "start of the day");
}

}  // namespace
}  // namespace nazori::study
