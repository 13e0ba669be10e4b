// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/time.h"

#include <gtest/gtest.h>
#include <stdlib.h>

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

}  // namespace
}  // namespace nazori::study
