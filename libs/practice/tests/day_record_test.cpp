// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/day_record.h"

#include <gmock/gmock.h>

#include "learner_under_test.h"
#include "nazori/practice/character_choice.h"
#include "nazori/practice/day_outlook.h"

namespace nazori::practice {
namespace {

using std::chrono::days;
using std::chrono::hours;
using std::chrono::minutes;
using study::Rating;
using study::Stage;
using testing::ElementsAre;
using testing::IsEmpty;

study::Day day(const char* text) { return *study::parse_day(text); }

class DayRecord : public LearnerTest {
 protected:
  study::LearnerStore& store() { return learner_->store(); }
  void write(char32_t character, bool right = true, bool inked = true, Stage stage = Stage::memory) {
    study::Writing writing;
    writing.stage = stage;
    writing.rating = right ? Rating::good : Rating::again;
    writing.result.accepted = right;
    writing.result.duration = std::chrono::seconds(8);
    study::Handwriting ink;
    if (inked) ink = {{{{10, 20}, 0.0, 0.5}, {{80, 20}, 0.5, 0.5}}};
    ASSERT_TRUE(store().add_writing(character, 1, writing, ink));
    clock_.advance(minutes(1));
  }
  [[nodiscard]] WritingRecord today() {
    const auto record = writing_record(store(), store().today(), store().today());
    EXPECT_TRUE(record);
    return *record;
  }
  void use_zone(const char* zone, const char* now) {
    clock_.set_calendar(*study::parse_time(now));
    auto settings = store().settings();
    settings.time_zone = zone;
    ASSERT_TRUE(store().change_settings(settings));
  }
};

TEST_F(DayRecord, HoldsWhatWasWrittenFromMemoryInItsOrder) {
  write(U'木', true, true, Stage::watch);
  write(U'木', true, true, Stage::trace);
  write(U'木', false);
  write(U'休');
  write(U'木');
  write(U'人', false, false);
  const auto record = today();
  EXPECT_EQ(record.study_days, 1);
  EXPECT_EQ(record.time, std::chrono::seconds(6 * 8)) << "watching and tracing take time, too";
  ASSERT_EQ(record.writings.size(), 4U) << "watching and tracing are no writing from memory";
  EXPECT_EQ(record.right(), 2);
  EXPECT_THAT(record.fresh, ElementsAre(U'木', U'休', U'人'));
  EXPECT_THAT(record.hard, ElementsAre(U'木', U'人'));
  const auto best = record.best_of_each();
  ASSERT_EQ(best.size(), 3U);
  EXPECT_EQ(best[0], record.writings[2]) << "the accepted one of 木";
  EXPECT_EQ(best[1], record.writings[1]);
  EXPECT_EQ(best[2], record.writings[3]);
  const auto inks = inks_of(store(), best, 10);
  ASSERT_TRUE(inks);
  ASSERT_EQ(inks->size(), 2U) << "人 was saved without ink";
  EXPECT_EQ((*inks)[1].character, U'休');
  EXPECT_EQ((*inks)[1].ink.size(), 1U);
  EXPECT_EQ(inks_of(store(), best, 1)->size(), 1U);
}

TEST_F(DayRecord, TheMostOftenRefusedIsTheHardestAndTiesStandAsTheyWereWritten) {
  write(U'一', false);
  write(U'二', false);
  write(U'三', false);
  write(U'三', false);
  EXPECT_THAT(today().hard, ElementsAre(U'三', U'一', U'二'));
}

TEST_F(DayRecord, UndoTakesAWritingOutOfTheDay) {
  write(U'木');
  write(U'休', false);
  ASSERT_TRUE(store().undo());
  EXPECT_EQ(today().writings.size(), 1U);
  EXPECT_THAT(today().hard, IsEmpty());
  EXPECT_THAT(today().fresh, ElementsAre(U'木'));
  ASSERT_TRUE(store().undo());
  EXPECT_EQ(today().study_days, 0);
  clock_.advance(days(1));
  EXPECT_EQ(*last_record_before(store(), store().today()), std::nullopt);
}

TEST_F(DayRecord, WhatWasMarkedAsKnownWasNotWritten) {
  ASSERT_TRUE(mark_known(*learner_, U'木'));
  EXPECT_EQ(today(), (WritingRecord{store().today(), store().today(), {}, 0, {}, {}, {}}));
  EXPECT_EQ(streak_now(store()).days, 0);
  EXPECT_THAT(*store().study_days(), IsEmpty());
  write(U'木');
  EXPECT_EQ(today().writings.size(), 1U);
  EXPECT_THAT(today().fresh, IsEmpty()) << "it was known";
  EXPECT_EQ(streak_now(store()).days, 1);
  clock_.advance(days(1));
  ASSERT_TRUE(mark_known(*learner_, U'休'));
  EXPECT_TRUE(today().writings.empty());
  EXPECT_EQ(last_record_before(store(), store().today() + days(1))->value().first, day("2026-03-02"))
      << "the last day on which something was written";
  ASSERT_TRUE(store().rebuild());
  EXPECT_EQ(store().study_days()->size(), 1U) << "also when it is computed again";
}

TEST_F(DayRecord, TheLastDayIsTheLastOneWithAWritingFromMemory) {
  EXPECT_EQ(*last_record_before(store(), store().today()), std::nullopt);
  write(U'木');
  EXPECT_EQ(*last_record_before(store(), store().today()), std::nullopt) << "today does not count";
  clock_.advance(days(3));
  write(U'休', true, true, Stage::trace);
  clock_.advance(days(1));
  const auto last = last_record_before(store(), store().today());
  ASSERT_TRUE(last && *last);
  EXPECT_EQ((*last)->first, day("2026-03-02")) << "tracing alone leaves nothing to show";
  EXPECT_EQ((*last)->writings.size(), 1U);
}

TEST_F(DayRecord, ADayEndsAtTheLearnersHourAlsoWhenTheClocksChange) {
  // Berlin, 29 March 2026: at 2:00 it becomes 3:00. The study day begins at 4:00.
  use_zone("Europe/Berlin", "2026-03-29T01:59:00Z");  // 3:59
  write(U'木');                                       // ends at 4:00
  write(U'休');
  EXPECT_EQ(today().first, day("2026-03-29"));
  ASSERT_EQ(today().writings.size(), 1U);
  EXPECT_EQ(today().writings[0].character, U'休');
  const auto before = last_record_before(store(), store().today());
  ASSERT_TRUE(before && *before);
  EXPECT_EQ((*before)->first, day("2026-03-28"));
  EXPECT_EQ((*before)->writings[0].character, U'木');
}

TEST_F(DayRecord, TwentyNineFebruaryIsADay) {
  use_zone("UTC", "2028-02-29T10:00:00Z");
  write(U'木');
  EXPECT_EQ(today().first, day("2028-02-29"));
  clock_.advance(days(1));
  const auto before = last_record_before(store(), store().today());
  ASSERT_TRUE(before && *before);
  EXPECT_EQ((*before)->first, day("2028-02-29"));
  EXPECT_EQ(month_of(day("2028-02-10")), (DaySpan{day("2028-02-01"), day("2028-02-29")}));
  EXPECT_EQ(month_of(day("2027-02-28")), (DaySpan{day("2027-02-01"), day("2027-02-28")}));
}

TEST_F(DayRecord, AWeekGoesFromMondayToSunday) {
  const DaySpan week{day("2026-03-02"), day("2026-03-08")};
  EXPECT_EQ(week_of(day("2026-03-02")), week);
  EXPECT_EQ(week_of(day("2026-03-05")), week);
  EXPECT_EQ(week_of(day("2026-03-08")), week);
  EXPECT_EQ(week_of(day("2026-03-09")).first, day("2026-03-09"));
}

TEST_F(DayRecord, SeveralDaysAreOneRecord) {
  write(U'木');
  clock_.advance(days(2));
  write(U'木', false);
  write(U'休');
  const auto week = writing_record(store(), day("2026-03-02"), day("2026-03-08"));
  ASSERT_TRUE(week);
  EXPECT_EQ(week->study_days, 2);
  EXPECT_EQ(week->writings.size(), 3U);
  EXPECT_THAT(week->fresh, ElementsAre(U'木', U'休'));
  EXPECT_THAT(week->hard, ElementsAre(U'木'));
  const auto later = writing_record(store(), day("2026-03-03"), day("2026-03-04"));
  EXPECT_THAT(later->fresh, ElementsAre(U'休')) << "木 was begun before";
}

}  // namespace
}  // namespace nazori::practice
