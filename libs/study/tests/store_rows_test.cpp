// SPDX-License-Identifier: Apache-2.0
// What may be written into a learner's file, and which rows of one are damage.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <set>

#include "learner_fixture.h"
#include "nazori/study/backups.h"

namespace nazori::study {
namespace {

using std::chrono::days;
using std::chrono::hours;
using std::chrono::milliseconds;
using test::MovedClock;
using test::must;
using test::review;
using test::some_ink;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr char32_t kRest = U'休';

/// The place of the error if the writing is refused; empty if it is accepted.
std::string refused(const std::function<void(Writing&)>& change, int strokes = 6,
                    char32_t character = kRest) {
  LearnerStore store = must(LearnerStore::in_memory(MovedClock("2026-01-01T09:00:00Z").clock()));
  Writing writing = review(Rating::good);
  change(writing);
  const auto card = store.add_writing(character, strokes, writing);
  EXPECT_EQ(store.last_entry(), card ? 1 : 0);
  if (card) return "";
  EXPECT_EQ(card.error().code, base::Errc::bad_argument);
  return card.error().where;
}

TEST(WritingLimits, EachNumberHasItsRange) {
  const auto nothing = [](Writing&) {};
  EXPECT_EQ(refused(nothing, 1), "");
  EXPECT_EQ(refused(nothing, 1'000), "");
  EXPECT_EQ(refused(nothing, 0), "strokes");
  EXPECT_EQ(refused(nothing, 1'001), "strokes");
  for (const char32_t c : {char32_t{1}, char32_t{0xD7FF}, char32_t{0xE000}, char32_t{0x10FFFF}})
    EXPECT_EQ(refused(nothing, 1, c), "") << std::hex << static_cast<unsigned>(c);
  for (const char32_t c : {char32_t{0}, char32_t{0xD800}, char32_t{0xDFFF}, char32_t{0x110000}})
    EXPECT_EQ(refused(nothing, 1, c), "character") << std::hex << static_cast<unsigned>(c);
  const auto score = [](int value) { return refused([=](Writing& w) { w.result.score = value; }); };
  EXPECT_EQ(score(-1), "score");
  EXPECT_EQ(score(0), "");
  EXPECT_EQ(score(100), "");
  EXPECT_EQ(score(101), "score");
  const auto help = [](double value) { return refused([=](Writing& w) { w.result.help = value; }); };
  EXPECT_EQ(help(-0.001), "help");
  EXPECT_EQ(help(0), "");
  EXPECT_EQ(help(1), "");
  EXPECT_EQ(help(1.001), "help");
  EXPECT_EQ(help(NAN), "help");
  const auto took = [](milliseconds value) {
    return refused([=](Writing& w) { w.result.duration = value; });
  };
  EXPECT_EQ(took(milliseconds(-1)), "duration");
  EXPECT_EQ(took(milliseconds(0)), "");
  EXPECT_EQ(took(hours(24)), "");
  EXPECT_EQ(took(hours(24) + milliseconds(1)), "duration");
}

TEST(WritingLimits, NothingIsCountedBelowNone) {
  for (int WritingResult::*const member :
       {&WritingResult::hints, &WritingResult::misses, &WritingResult::shown_strokes}) {
    EXPECT_EQ(refused([=](Writing& w) { w.result.*member = -1; }), "hints, misses or shown strokes");
    EXPECT_EQ(refused([=](Writing& w) { w.result.*member = 0; }), "");
  }
}

TEST(WritingLimits, AThousandMistakesOfAThousandStrokesAreTaken) {
  const auto mistakes = [](std::size_t count, int stroke) {
    return refused([=](Writing& w) { w.result.mistakes.assign(count, {kanji::MistakeKind::wrong, stroke}); });
  };
  EXPECT_EQ(mistakes(1'000, 0), "");
  EXPECT_EQ(mistakes(1'001, 0), "faults");
  EXPECT_EQ(mistakes(1, 1'000), "");
  EXPECT_EQ(mistakes(1, 1'001), "fault");
  EXPECT_EQ(mistakes(1, -1), "fault");
  EXPECT_EQ(refused([](Writing& w) {
              w.result.mistakes = {{kanji::MistakeKind::wrong, 1}, {kanji::MistakeKind::wrong, -1}};
            }),
            "fault");
}

/// A learner's file whose rows are changed without the store.
class ChangedFile {
 public:
  ChangedFile() {
    LearnerStore store = opened();
    Writing writing = review(Rating::good);
    writing.result.mistakes = {{kanji::MistakeKind::wrong, 2}, {kanji::MistakeKind::ending, 0}};
    (void)must(store.add_writing(kRest, 6, writing, some_ink()));
    (void)must(store.add_writing(kRest, 6, writing, some_ink()));
    EXPECT_TRUE(must(store.undo()));
    EXPECT_TRUE(store.postpone(std::span(&kRest, 1), store.today() + std::chrono::days(2)));
  }
  [[nodiscard]] LearnerStore opened(Access access = Access::write) {
    return must(LearnerStore::open(file(), access, clock_.clock(), Upkeep::later));
  }
  [[nodiscard]] std::filesystem::path file() const { return folder_ / "learner.db"; }
  void execute(const std::string& sql) {
    SQLite::Database db(file().string(), SQLite::OPEN_READWRITE, 1'000);
    // Data here need not survive a crash of the computer.
    db.exec("PRAGMA synchronous = OFF; DROP TRIGGER IF EXISTS log_is_not_changed; " + sql);
  }

 private:
  TemporaryFolder folder_;
  MovedClock clock_{"2026-01-01T09:00:00Z"};
};

TEST(StoreRows, EveryColumnOfTheLogHasItsRange) {
  ChangedFile changed;
  const LearnerStore store = changed.opened();
  changed.execute("CREATE TABLE kept AS SELECT * FROM log");
  const auto fits = [&](const std::string& assignment, int id) {
    const std::string where = " WHERE id = " + std::to_string(id);
    changed.execute("UPDATE log SET " + assignment + where);
    const auto read = store.for_each_entry(false, [](const auto&) { return true; });
    if (!read) {
      EXPECT_EQ(read.error().code, base::Errc::parse) << assignment;
    }
    if (!read) {
      EXPECT_THAT(read.error().what, testing::HasSubstr("entry " + std::to_string(id)));
    }
    changed.execute(
        "DROP TRIGGER IF EXISTS log_is_not_shortened; DELETE FROM log; "
        "INSERT INTO log SELECT * FROM kept");
    return read.has_value();
  };
  // Of the first writing.
  for (const char* fine : {"action = 1",
                           "at_ms = 345600000000000",
                           "at_ms = -345600000000000",
                           "day = 4000000",
                           "day = -4000000",
                           "character = 1",
                           "character = 1114111",
                           "accepted = 0",
                           "accepted = 1",
                           "score = 0",
                           "score = 100",
                           "hints = 0",
                           "misses = 0",
                           "shown_strokes = 0",
                           "hints = 2147483647",
                           "misses = 2147483647",
                           "shown_strokes = 2147483647",
                           "strokes = 2147483647",
                           "duration_ms = 0",
                           "strokes = 1",
                           "interval_days = 1",
                           "interval_days = 36600",
                           "interval_days = NULL",
                           "faults = ''",
                           "faults = 'order:0 wrong:12'",
                           "speed = NULL",
                           "undoes = 1",
                           "undoes = NULL",
                           "until_day = 4000000",
                           "until_day = NULL"})
    EXPECT_TRUE(fits(fine, 1)) << fine;
  for (const char* damage : {"action = 0",
                             "action = 2",
                             "at_ms = 345600000000001",
                             "at_ms = -345600000000001",
                             "day = 4000001",
                             "day = -4000001",
                             "character = 0",
                             "character = 1114112",
                             "kind = 10",
                             "kind = -1",
                             "kind = 256",
                             "stage = 5",
                             "stage = NULL",
                             "rating = 0",
                             "rating = 5",
                             "proposed = NULL",
                             "accepted = 2",
                             "accepted = -1",
                             "accepted = NULL",
                             "score = 101",
                             "score = -1",
                             "score = NULL",
                             "hints = -1",
                             "hints = NULL",
                             "misses = -1",
                             "shown_strokes = -1",
                             "hints = 2147483648",
                             "misses = 2147483648",
                             "shown_strokes = 2147483648",
                             "strokes = 2147483648",
                             "duration_ms = -1",
                             "duration_ms = NULL",
                             "strokes = 0",
                             "strokes = NULL",
                             "interval_days = 0",
                             "interval_days = 36601",
                             "undoes = 0",
                             "undoes = 2",
                             "until_day = 4000001",
                             "faults = 'wrong'",
                             "faults = 'wrong:'",
                             "faults = 'wrong:x'",
                             "faults = 'wrong:1x'",
                             "faults = 'poor:1'",
                             "faults = ':1'",
                             "faults = 'wrong:99999999999'",
                             "faults = 'wrong:1  ending:0'"})
    EXPECT_FALSE(fits(damage, 1)) << damage;
}

TEST(StoreRows, ABackupWithADamagedEntryIsNotCounted) {
  ChangedFile changed;
  EXPECT_TRUE(look_into(changed.file()));
  changed.execute("UPDATE log SET score = 101 WHERE id = 1");
  const auto looked = look_into(changed.file());
  ASSERT_FALSE(looked);
  EXPECT_EQ(looked.error().code, base::Errc::parse);
}

TEST(StoreRows, EveryColumnOfACardHasItsRange) {
  ChangedFile changed;
  changed.execute("CREATE TABLE kept AS SELECT * FROM card");
  const auto fits = [&](const std::string& assignment) {
    changed.execute("UPDATE card SET " + assignment);
    const auto opened = LearnerStore::open(changed.file(), Access::read,
                                           MovedClock("2026-01-01T09:00:00Z").clock(), Upkeep::later);
    if (!opened) {
      EXPECT_EQ(opened.error().code, base::Errc::parse) << assignment;
    }
    changed.execute("DELETE FROM card; INSERT INTO card SELECT * FROM kept");
    return opened.has_value();
  };
  for (const char* fine : {"character = 1",
                           "character = 1114111",
                           "step = 0",
                           "step = 1000",
                           "scheduled_days = 0",
                           "scheduled_days = 40000",
                           "reps = 0",
                           "reps = 2147483647",
                           "lapses = 0",
                           "lapses = 2147483647",
                           "last_review_ms = NULL",
                           "introduced = NULL",
                           "due_day = 4000000",
                           "paused = 0",
                           "paused = 1",
                           "leech = 1",
                           "leech_at = 0",
                           "leech_at = 2147483647",
                           "practices = 0",
                           "practices = 2147483647"})
    EXPECT_TRUE(fits(fine)) << fine;
  for (const char* damage : {"character = 0",
                             "character = 1114112",
                             "phase = 4",
                             "phase = -1",
                             "step = -1",
                             "step = 1001",
                             "scheduled_days = -1",
                             "scheduled_days = 40001",
                             "reps = -1",
                             "reps = 2147483648",
                             "lapses = -1",
                             "lapses = 2147483648",
                             "due_ms = 345600000000001",
                             "last_review_ms = 345600000000001",
                             "introduced = 4000001",
                             "last_day = 4000001",
                             "due_day = -4000001",
                             "postponed_until = 4000001",
                             "paused = 2",
                             "paused = -1",
                             "leech = 2",
                             "leech = -1",
                             "leech_at = -1",
                             "leech_at = 2147483648",
                             "practices = -1",
                             "practices = 2147483648",
                             "next_stage = 4",
                             "next_stage = 5"})
    EXPECT_FALSE(fits(damage)) << damage;
}

TEST(StoreRows, EveryColumnOfTheReviewsWithTheBrushHasItsRange) {
  ChangedFile changed;
  changed.execute(
      "CREATE TABLE kept AS SELECT character, 2 AS phase, 3.0, 5.0, 0 AS step, 3 AS scheduled_days, 1 AS "
      "reps, "
      "0 AS lapses, 0 AS due_ms, 0 AS last_review_ms, 0 AS last_day, 3 AS due_day FROM card LIMIT 1");
  const auto fits = [&](const std::string& assignment) {
    changed.execute("INSERT INTO brush_card SELECT * FROM kept; UPDATE brush_card SET " + assignment);
    const auto opened = LearnerStore::open(changed.file(), Access::read,
                                           MovedClock("2026-01-01T09:00:00Z").clock(), Upkeep::later);
    if (!opened) {
      EXPECT_EQ(opened.error().code, base::Errc::parse) << assignment;
    }
    changed.execute("DELETE FROM brush_card");
    return opened.has_value();
  };
  for (const char* fine : {"reps = 0", "lapses = 2147483647", "last_review_ms = NULL", "last_day = NULL",
                           "due_day = NULL", "due_day = 4000000"})
    EXPECT_TRUE(fits(fine)) << fine;
  for (const char* damage : {"character = 0", "character = 1114111", "phase = 4", "step = -1",
                             "scheduled_days = 40001", "reps = -1", "lapses = -1", "due_ms = 345600000000001",
                             "last_review_ms = 345600000000001", "last_day = 4000001", "due_day = -4000001"})
    EXPECT_FALSE(fits(damage)) << damage;
}

TEST(StoreRows, EveryMemberOfACardIsKept) {
  ChangedFile changed;
  changed.execute(
      "UPDATE card SET character = 26408, phase = 3, stability = 1.5, difficulty = 2.5, step = 4, "
      "scheduled_days = 5, reps = 6, lapses = 7, due_ms = 8000, last_review_ms = 9000, introduced = 10, "
      "last_day = 11, due_day = 12, postponed_until = 13, paused = 1, leech = 0, leech_at = 16, "
      "practices = 17, next_stage = 2, help = 0.25");
  const auto day = [](int number) { return Day(std::chrono::days(number)); };
  Card expected;
  expected.character = U'木';
  expected.memory = {Phase::relearning,        1.5, 2.5, 4, 5, 6, 7, Time(milliseconds(8'000)),
                     Time(milliseconds(9'000))};
  expected.introduced = day(10);
  expected.last_day = day(11);
  expected.due_day = day(12);
  expected.postponed_until = day(13);
  expected.paused = true;
  expected.leech_at = 16;
  expected.practices = 17;
  expected.next_stage = Stage::guided;
  expected.help = 0.25;
  EXPECT_EQ(changed.opened().card(U'木'), expected);
  changed.execute("UPDATE card SET paused = 0, leech = 1");
  expected.paused = false;
  expected.leech = true;
  EXPECT_EQ(changed.opened().card(U'木'), expected);
}

TEST(StoreRows, EveryMemberOfAWritingIsKept) {
  const TemporaryFolder folder;
  const MovedClock clock("2026-01-01T09:00:00Z");
  Writing writing;
  writing.stage = Stage::guided;
  writing.rating = Rating::again;
  writing.proposed = Rating::easy;
  writing.result = {false,
                    7,
                    {{kanji::MistakeKind::split, 11}, {kanji::MistakeKind::other, 12}},
                    3,
                    4,
                    5,
                    0.125,
                    milliseconds(678)};
  {
    LearnerStore store = must(LearnerStore::open(folder / "learner.db", Access::write, clock.clock()));
    (void)must(store.add_writing(kRest, 6, writing));
    (void)must(store.add_writing(U'一', 1, Writing()));
  }
  const LearnerStore store = must(LearnerStore::open(folder / "learner.db", Access::read, clock.clock()));
  const auto first = must(store.writings_of(kRest));
  ASSERT_EQ(first.size(), 1U);
  const LogEntry& entry = first[0].entry;
  EXPECT_EQ(entry.writing, writing);
  EXPECT_EQ(entry.strokes, 6);
  EXPECT_EQ(entry.id, 1);
  EXPECT_EQ(entry.action, 1);
  EXPECT_EQ(entry.at, clock.now());
  EXPECT_EQ(entry.day, store.calendar().day_of(clock.now()));
  EXPECT_EQ(entry.kind, EntryKind::writing);
  EXPECT_EQ(entry.character, kRest);
  EXPECT_FALSE(entry.interval_days || entry.undoes || entry.until || first[0].has_ink || first[0].motion);
  EXPECT_EQ(entry.settings, "");
  const auto second = must(store.writings_of(U'一'));
  ASSERT_EQ(second.size(), 1U);
  EXPECT_EQ(second[0].entry.writing, Writing()) << "nothing is left over from the one before";
  EXPECT_EQ(second[0].entry.strokes, 1);
}

TEST(WritingsOn, AreThoseOfEveryCharacterOfTheDaysThatWereNotUndoneOldestFirst) {
  MovedClock clock("2026-01-01T09:00:00Z");
  LearnerStore store = must(LearnerStore::in_memory(clock.clock()));
  const Day first = store.today();
  (void)must(store.add_writing(kRest, 6, review(Rating::good)));  // 1
  clock.advance(days(1));
  (void)must(store.add_writing(U'一', 1, review(Rating::good)));  // 2
  ASSERT_TRUE(store.pause(std::array{kRest}));                    // 3
  (void)must(store.add_writing(kRest, 6, review(Rating::good)));  // 4
  ASSERT_TRUE(must(store.undo()));                                // 5
  (void)must(store.add_writing(kRest, 6, review(Rating::hard)));  // 6
  clock.advance(days(2));
  (void)must(store.add_writing(U'一', 1, review(Rating::good)));  // 7
  const auto on = [&store, first](int from, int to) {
    std::vector<std::int64_t> ids;
    for (const auto& one : must(store.writings_on(first + days(from), first + days(to))))
      ids.push_back(one.entry.id);
    return ids;
  };
  EXPECT_THAT(on(0, 0), ElementsAre(1));
  EXPECT_THAT(on(1, 1), ElementsAre(2, 6));
  EXPECT_THAT(on(2, 2), IsEmpty());
  EXPECT_THAT(on(1, 9), ElementsAre(2, 6, 7));
  EXPECT_THAT(on(-9, 9), ElementsAre(1, 2, 6, 7));
}

TEST(StoreRows, WhatAnActionIsAboutStandsInItsEntries) {
  const MovedClock clock("2026-01-01T09:00:00Z");
  LearnerStore store = must(LearnerStore::in_memory(clock.clock()));
  (void)must(store.add_writing(kRest, 6, review(Rating::good), some_ink()));
  const std::array three{U'一', U'二', U'三'};
  const Day until = store.today() + std::chrono::days(3);
  ASSERT_TRUE(store.postpone(three, until));
  ASSERT_TRUE(must(store.undo()));
  ASSERT_TRUE(store.pause(std::span(three).first(1)));
  std::vector<LogEntry> entries;
  std::vector<bool> has_ink;
  ASSERT_TRUE(store.for_each_entry(false, [&](const LearnerStore::LoggedEntry& one) {
    entries.push_back(one.entry);
    has_ink.push_back(one.has_ink);
    EXPECT_EQ(one.motion.has_value(), one.has_ink);
    return true;
  }));
  ASSERT_EQ(entries.size(), 6U);
  EXPECT_THAT(has_ink, ElementsAre(true, false, false, false, false, false));
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_EQ(entries[i].id, static_cast<std::int64_t>(i + 1));
    EXPECT_EQ(entries[i].action, 2);
    EXPECT_EQ(entries[i].character, three.at(i - 1));
    EXPECT_EQ(entries[i].until, until);
    EXPECT_EQ(entries[i].kind, EntryKind::postpone);
    EXPECT_EQ(entries[i].writing, Writing()) << "a note about nothing but the day";
  }
  EXPECT_EQ(entries[4].kind, EntryKind::undo);
  EXPECT_EQ(entries[4].undoes, 2);
  EXPECT_EQ(entries[4].action, 5);
  EXPECT_EQ(entries[4].character, char32_t{0});
  EXPECT_EQ(entries[5].kind, EntryKind::pause);
  EXPECT_EQ(entries[5].action, 6);
  int seen = 0;
  ASSERT_TRUE(store.for_each_entry(true, [&](const LearnerStore::LoggedEntry& one) {
    EXPECT_NE(one.entry.action, 2);
    ++seen;
    return seen < 2;
  }));
  EXPECT_EQ(seen, 2) << "it stops where it is told to";
}

}  // namespace
}  // namespace nazori::study
