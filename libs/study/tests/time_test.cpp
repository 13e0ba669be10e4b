// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/time.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <array>
#include <string>

namespace nazori::study {
namespace {

using std::chrono::milliseconds;

TEST(Time, IsReadAndWrittenAlike) {
  for (const char* text :
       {"1970-01-01T00:00:00.000Z", "2026-01-01T09:00:00.000Z", "2176-12-13T23:59:59.999Z"}) {
    const auto time = parse_time(text);
    ASSERT_TRUE(time) << text;
    EXPECT_EQ(to_text(*time), text);
  }
  // date -u -d 2026-11-21T13:42:06Z +%s
  EXPECT_EQ(parse_time("2026-11-21T13:42:06Z")->time_since_epoch(), milliseconds(1'795'268'526'000));
}

TEST(Time, WithAnOffsetIsTheSameMoment) {
  EXPECT_EQ(parse_time("2026-01-01T18:00:00+09:00"), parse_time("2026-01-01T09:00:00Z"));
  EXPECT_EQ(parse_time("2026-01-01T01:30-0730"), parse_time("2026-01-01T09:00Z"));
}

TEST(Time, OfAClockThatWasSetGoesOnFromThere) {
  const Time start = *parse_time("2026-01-01T09:00Z");
  const Clock clock = clock_from(start);
  const Time first = clock();
  EXPECT_GE(first, start);
  EXPECT_LT(first, start + std::chrono::minutes(10));
  EXPECT_GE(clock(), first);
}

TEST(Time, ThePresentCanBeSetInTheEnvironment) {
  ::setenv("NAZORI_NOW", "2026-03-01T06:30+09:00", 1);
  const auto set = environment_clock();
  ASSERT_TRUE(set);
  EXPECT_EQ(to_text((*set)()).substr(0, 13), "2026-02-28T21");
  ::setenv("NAZORI_NOW", "tomorrow", 1);
  const auto refused = environment_clock();
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().where, "tomorrow");
  ::unsetenv("NAZORI_NOW");
  EXPECT_GT((*environment_clock())(), *parse_time("2026-01-01T00:00Z"));
}

TEST(Time, ThatIsNoneIsRefused) {
  for (const char* text :
       {"", "now", "2026-01-01", "2026-13-01T00:00Z", "2026-02-29T00:00Z", "2026-01-01T24:00Z",
        "2026-01-01T09:00:00", "2026-01-01T09:00:00Z ", "2026-01-01T09:00:00.Z", "1969-12-31T23:00Z",
        "2026-01-01T09:60Z", "2026-01-01T09:00+15:00", "-026-01-01T09:00Z"}) {
    EXPECT_FALSE(parse_time(text)) << text;
  }
  EXPECT_FALSE(parse_day("2026-02-30"));
  EXPECT_EQ(to_text(*parse_day("2028-02-29")), "2028-02-29");
}

TEST(Time, EachPartHasItsRange) {
  for (const char* fine :
       {"1970-01-01T00:00Z", "9999-12-31T23:59:59.999Z", "2026-01-01T00:00:00Z", "2026-12-31T23:59:59Z",
        "2026-01-01T09:00+14:59", "2026-01-01T09:00-14:00", "2026-01-01T09:00:00.1Z",
        "2026-01-01T09:00:00.123456789Z", "1970-01-01T01:00+01:00"})
    EXPECT_TRUE(parse_time(fine)) << fine;
  for (const char* wrong :
       {"1969-12-31T23:59:59.999Z", "1970-01-01T00:59+01:00", "2026-00-01T00:00Z",
        "2026-01-00T00:00Z",        "2026-01-32T00:00Z",      "2026-01-01T00:00:60Z",
        "2026-01-01T09:00+14:60",   "2026-01-01T09:00+1:00",  "2026-01-01T09:00:00.1234567890Z",
        "2026-01-01T09:00:",        "2026-01-01T09:0",        "2026-01-01T09:00Zx",
        "2026-01-01T09:00*01:00",   "2026-01-01 09:00Z",      "2026/01/01T09:00Z",
        "2026-01/01T09:00Z",        "2026-01-01T09.00Z",      "2026-01-01T0x:00Z",
        "2026-01-01T:9:00Z",        "2026-01-01T09:0/Z",      "20x6-01-01T09:00Z"})
    EXPECT_FALSE(parse_time(wrong)) << wrong;
}

TEST(Time, PartsOfASecondAreMilliseconds) {
  const Time second = *parse_time("2026-01-01T09:00:07Z");
  const std::array<std::pair<const char*, int>, 7> kParts{
      {{"5", 500}, {"05", 50}, {"005", 5}, {"250", 250}, {"1239", 123}, {"000999999", 0}, {"999", 999}}};
  for (const auto& [part, ms] : kParts)
    EXPECT_EQ(*parse_time(std::string("2026-01-01T09:00:07.") + part + "Z") - second, milliseconds(ms))
        << part;
}

TEST(Time, IsWrittenWithEachPartInItsPlace) {
  using std::chrono::hours;
  using std::chrono::minutes;
  using std::chrono::seconds;
  const Time start = *parse_time("2026-03-04T00:00Z");
  EXPECT_EQ(to_text(start + hours(5) + minutes(6) + seconds(7) + milliseconds(8)),
            "2026-03-04T05:06:07.008Z");
  EXPECT_EQ(to_text(start + hours(23) + minutes(59) + seconds(59) + milliseconds(999)),
            "2026-03-04T23:59:59.999Z");
  EXPECT_EQ(to_text(start - milliseconds(1)), "2026-03-03T23:59:59.999Z");
  EXPECT_EQ(to_text(utc_day(start - milliseconds(1))), "2026-03-03");
  EXPECT_EQ(to_text(utc_day(start)), "2026-03-04");
}

TEST(Time, OffsetsGoBothWays) {
  EXPECT_EQ(parse_time("2026-01-01T09:00:00+05:45"), parse_time("2026-01-01T03:15:00Z"));
  EXPECT_EQ(parse_time("2026-01-01T09:00:00-05:45"), parse_time("2026-01-01T14:45:00Z"));
  EXPECT_EQ(parse_time("2026-01-01T09:00:00+0000"), parse_time("2026-01-01T09:00:00Z"));
}

TEST(Time, ADayIsOneOfTheCalendarFrom1970On) {
  for (const char* fine : {"1970-01-01", "9999-12-31", "2000-02-29", "2026-04-30"})
    EXPECT_EQ(to_text(*parse_day(fine)), fine);
  for (const char* wrong : {"1969-12-31", "2026-04-31", "2100-02-29", "2026-1-01", "2026-01-1", "2026-01-011",
                            "", "2026-01-01T", "02026-01-01"}) {
    ASSERT_FALSE(parse_day(wrong)) << wrong;
    EXPECT_EQ(parse_day(wrong).error().where, wrong);
  }
  EXPECT_EQ(*parse_day("1970-01-02") - *parse_day("1970-01-01"), std::chrono::days(1));
}

TEST(Time, AnEmptyVariableIsNoTimeThatWasSet) {
  ::setenv("NAZORI_NOW", "", 1);
  const auto clock = environment_clock();
  ::unsetenv("NAZORI_NOW");
  ASSERT_TRUE(clock);
  EXPECT_LE(system_now() - (*clock)(), std::chrono::minutes(1));
  EXPECT_GE(system_now(), (*clock)() - milliseconds(1));
}

}  // namespace
}  // namespace nazori::study
