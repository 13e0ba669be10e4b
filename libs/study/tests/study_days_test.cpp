// SPDX-License-Identifier: Apache-2.0
// The sums that a store keeps of each study day.
#include "nazori/study/study_days.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <map>
#include <set>

#include "../src/store_days.h"
#include "../src/store_schema.h"
#include "learner_fixture.h"
#include "nazori/study/day_plan.h"
#include "nazori/study/exchange.h"
#include "nazori/study/pace.h"
#include "nazori/study/statistics.h"
#include "test_paths.h"

namespace nazori::study {
namespace {

using std::chrono::milliseconds;
using test::MovedClock;
using test::must;
using test::review;
using test::study_at_random;
using test::TemporaryFolder;
using testing::ElementsAre;

LogEntry written(int day, Stage stage, Rating rating, int time_ms) {
  LogEntry entry;
  entry.day = Day(std::chrono::days(day));
  entry.character = U'木';
  entry.writing.stage = stage;
  entry.writing.rating = rating;
  entry.writing.result.duration = milliseconds(time_ms);
  return entry;
}

CharacterDay on(int day, std::optional<DayOutcome> outcome, int time_ms, int writings, int reviews) {
  return {Day(std::chrono::days(day)), outcome, milliseconds(time_ms), writings, reviews};
}

TEST(CharacterDays, TheFirstReviewOfADayDecidesHowItWent) {
  CharacterDays days;
  days.take(written(1, Stage::trace, Rating::good, 5));
  days.take(written(1, Stage::memory, Rating::again, 7));
  days.take(written(4, Stage::memory, Rating::again, 11));
  days.take(written(4, Stage::memory, Rating::good, 13));
  days.take(written(9, Stage::guided, Rating::good, 17));
  days.take(written(9, Stage::memory, Rating::hard, 19));
  days.take(written(12, Stage::trace, Rating::good, 23));
  EXPECT_THAT(days.days(),
              ElementsAre(on(1, DayOutcome::introduced, 12, 2, 1), on(4, DayOutcome::failed, 24, 2, 2),
                          on(9, DayOutcome::recalled, 36, 2, 1), on(12, std::nullopt, 23, 1, 0)));
}

TEST(CharacterDays, ACharacterThatStartsOverIsNewOnTheSameDayToo) {
  CharacterDays days;
  days.take(written(1, Stage::memory, Rating::good, 5));
  LogEntry reset = written(1, Stage::memory, Rating::good, 0);
  reset.kind = EntryKind::reset;
  days.take(reset);
  days.take(reset);
  days.take(written(1, Stage::memory, Rating::again, 7));
  LogEntry pause = reset;
  pause.kind = EntryKind::pause;
  days.take(pause);
  days.take(written(2, Stage::memory, Rating::again, 9));
  EXPECT_THAT(days.days(),
              ElementsAre(on(1, DayOutcome::introduced, 5, 1, 1), on(1, DayOutcome::introduced, 7, 1, 1),
                          on(2, DayOutcome::failed, 9, 1, 1)));
}

TEST(CharacterDays, ACharacterThatWasMarkedAsKnownWasNotWritten) {
  LogEntry known = written(1, Stage::memory, Rating::easy, 0);
  known.kind = EntryKind::known;
  CharacterDays days;
  days.take(known);
  EXPECT_TRUE(days.days().empty());
  days.take(written(1, Stage::memory, Rating::good, 5));
  days.take(known);
  EXPECT_THAT(days.days(), ElementsAre(on(1, DayOutcome::recalled, 5, 1, 1))) << "nor introduced";
}

TEST(CharacterDays, AnEasyWritingWhoseTimeIsNotKnownIsAWriting) {
  LogEntry easy = written(1, Stage::memory, Rating::easy, 0);
  easy.writing.proposed = Rating::easy;
  CharacterDays days;
  days.take(easy);
  EXPECT_THAT(days.days(), ElementsAre(on(1, DayOutcome::introduced, 0, 1, 1)));
}

/// The sums that the file keeps: day and writings of each study day.
std::vector<std::pair<int, int>> kept_sums(SQLite::Database& db) {
  std::vector<std::pair<int, int>> sums;
  SQLite::Statement rows(db, "SELECT day, writings FROM study_day ORDER BY day");
  while (rows.executeStep()) sums.emplace_back(rows.getColumn(0).getInt(), rows.getColumn(1).getInt());
  return sums;
}

TEST(CharacterDays, ADayThatARowNoLongerHasIsAddedUpAgain) {
  SQLite::Database db(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  migrate_store(db, 0, *parse_time("2026-01-01T09:00Z"));
  put_character_days(db, U'木', std::vector{on(1, DayOutcome::introduced, 5, 2, 1)});
  put_character_days(db, U'林',
                     std::vector{on(1, DayOutcome::introduced, 5, 3, 1), on(4, std::nullopt, 5, 1, 0)});
  EXPECT_THAT(kept_sums(db), ElementsAre(std::pair(1, 5), std::pair(4, 1)));
  put_character_days(db, U'林',
                     std::vector{on(2, DayOutcome::introduced, 5, 3, 1), on(4, std::nullopt, 5, 1, 0)});
  EXPECT_THAT(kept_sums(db), ElementsAre(std::pair(1, 2), std::pair(2, 3), std::pair(4, 1)));
  put_character_days(db, U'林', std::vector{on(2, DayOutcome::introduced, 5, 3, 1)});
  EXPECT_THAT(kept_sums(db), ElementsAre(std::pair(1, 2), std::pair(2, 3))) << "a day that is gone";
}

/// The sums by their definition, from the whole log.
struct FromTheLog {
  std::map<Day, StudyDay> days;
  std::map<Day, milliseconds> spent;
  std::map<Day, std::set<char32_t>> reviewed;
  std::map<DayOutcome, std::vector<std::tuple<Day, char32_t, milliseconds>>> times;

  explicit FromTheLog(const LearnerStore& store) {
    std::map<char32_t, CharacterDays> histories;
    const auto read = store.for_each_entry(true, [&](const LearnerStore::LoggedEntry& logged) {
      const LogEntry& entry = logged.entry;
      histories[entry.character].take(entry);
      if (entry.kind != EntryKind::writing) return true;
      StudyDay& day = days[entry.day];
      day.day = entry.day;
      ++day.writings;
      spent[entry.day] += entry.writing.result.duration;
      if (entry.writing.stage != Stage::memory) return true;
      ++day.reviews;
      reviewed[entry.day].insert(entry.character);
      return true;
    });
    EXPECT_TRUE(read);
    for (const auto& [character, history] : histories) {
      for (const CharacterDay& day : history.days()) {
        if (!day.outcome || day.time.count() == 0) continue;
        times[*day.outcome].emplace_back(day.day, character, day.time);
        if (*day.outcome == DayOutcome::introduced) ++days[day.day].introduced;
      }
    }
    for (auto& [outcome, all] : times) {
      std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
        return std::get<0>(a) != std::get<0>(b) ? std::get<0>(a) > std::get<0>(b)
                                                : std::get<1>(a) < std::get<1>(b);
      });
    }
  }
};

void expect_sums_of_the_log(const LearnerStore& store) {
  const FromTheLog expected(store);
  std::vector<StudyDay> days;
  for (const auto& [day, sums] : expected.days) days.push_back(sums);
  EXPECT_EQ(must(store.study_days()), days);
  for (const auto& [day, sums] : expected.days) {
    EXPECT_EQ(must(store.time_on(day)), expected.spent.at(day));
    const auto reviewed = expected.reviewed.find(day);
    const std::set<char32_t> characters =
        reviewed == expected.reviewed.end() ? std::set<char32_t>() : reviewed->second;
    EXPECT_EQ(must(store.reviewed_on(day)), std::vector<char32_t>(characters.begin(), characters.end()));
  }
  for (const DayOutcome outcome : {DayOutcome::recalled, DayOutcome::failed, DayOutcome::introduced}) {
    OutcomeTimes times;
    if (const auto all = expected.times.find(outcome); all != expected.times.end()) {
      times.days = static_cast<int>(all->second.size());
      for (const auto& one : all->second)
        if (times.newest.size() < 5) times.newest.push_back(std::get<2>(one));
    }
    EXPECT_EQ(must(store.newest_times(outcome, 5)), times) << static_cast<int>(outcome);
  }
}

TEST(StudyDays, FollowFromTheLogAfterEveryKindOfAction) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    SCOPED_TRACE(seed);
    MovedClock clock("2026-01-01T09:00:00Z");
    LearnerStore store = must(LearnerStore::in_memory(clock.clock()));
    for (int part = 0; part < 8; ++part) {
      study_at_random(store, clock, 10 * seed + static_cast<unsigned>(part), 50);
      expect_sums_of_the_log(store);
    }
    ASSERT_TRUE(store.rebuild());
    expect_sums_of_the_log(store);
  }
}

TEST(StudyDays, AreThereAfterAnImport) {
  MovedClock clock("2026-01-01T09:00:00Z");
  LearnerStore store = must(LearnerStore::in_memory(clock.clock()));
  study_at_random(store, clock, 7, 300);
  LearnerStore other = must(LearnerStore::in_memory(clock.clock()));
  const std::string json = must(export_json(store));
  ASSERT_TRUE(import_json(other, text_source(json)));
  expect_sums_of_the_log(other);
  EXPECT_EQ(must(other.study_days()), must(store.study_days()));
}

TEST(StudyDays, RebuildingMendsThem) {
  const TemporaryFolder folder;
  MovedClock clock("2026-01-01T09:00:00Z");
  {
    LearnerStore store = must(LearnerStore::open(folder / "learner.db", Access::write, clock.clock()));
    study_at_random(store, clock, 8, 100);
  }
  {
    SQLite::Database db((folder / "learner.db").string(), SQLite::OPEN_READWRITE);
    db.exec("UPDATE character_day SET writings = writings + 1; DELETE FROM study_day");
  }
  LearnerStore store = must(LearnerStore::open(folder / "learner.db", Access::write, clock.clock()));
  ASSERT_TRUE(store.rebuild());
  expect_sums_of_the_log(store);
}

TEST(StudyDays, OfAFileOfVersionOneAreWorkedOut) {
  const TemporaryFolder folder;
  const auto file = folder / "learner.db";
  {
    SQLite::Database db(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    db.exec(test::bytes_of(std::string(test_paths::kFixtures) + "/learner-v1.sql"));
  }
  // Reading leaves the file as it is.
  const std::string before = test::bytes_of(file);
  const StudyDay only{*parse_day("2026-01-01"), 1, 1, 1};
  EXPECT_THAT(must(must(LearnerStore::open(file, Access::read)).study_days()), ElementsAre(only));
  EXPECT_EQ(test::bytes_of(file), before);
  EXPECT_THAT(must(must(LearnerStore::open(file, Access::write)).study_days()), ElementsAre(only));
  expect_sums_of_the_log(must(LearnerStore::open(file, Access::write)));
}

// Steps of SQLite's virtual machine, counted: they do not depend on the machine.
std::int64_t g_steps = 0;

int count_steps_of(sqlite3* database, char**, const sqlite3_api_routines*) {
  sqlite3_progress_handler(
      database, 1, [](void*) { return ++g_steps, 0; }, nullptr);
  return SQLITE_OK;
}

/// Counts the steps of all connections that are opened while it lives.
class StepCount {
 public:
  StepCount() { sqlite3_auto_extension(reinterpret_cast<void (*)()>(count_steps_of)); }
  ~StepCount() { sqlite3_cancel_auto_extension(reinterpret_cast<void (*)()>(count_steps_of)); }
  template <class Work>
  std::int64_t of(Work work) {
    g_steps = 0;
    work();
    return g_steps;
  }
};

/// The cost of each operation for a learner with a history of this length, in steps.
std::map<std::string, std::int64_t> costs(int entries) {
  StepCount steps;
  const TemporaryFolder folder;
  const auto file = folder / "learner.db";
  MovedClock clock("2041-06-01T09:00:00Z");
  {
    LearnerStore store = must(LearnerStore::open(file, Access::write, clock.clock()));
    EXPECT_TRUE(store.fill(test::long_history(entries)));
  }
  std::map<std::string, std::int64_t> costs;
  std::optional<LearnerStore> store;
  costs["opening"] = steps.of(
      [&] { store.emplace(must(LearnerStore::open(file, Access::write, clock.clock(), Upkeep::later))); });
  costs["a step"] = steps.of([&] { (void)must(store->add_writing(U'一', 8, review(Rating::good))); });
  costs["undo"] = steps.of([&] { (void)must(store->undo()); });
  costs["the plan"] = steps.of([&] { (void)must(plan_day(*store, {})); });
  costs["the days"] = steps.of([&] { (void)must(store->study_days()); });
  return costs;
}

TEST(StudyDays, MakeADayCostTheSameWithALongHistory) {
  // The same characters, three times as many entries. Reading every entry would take many steps for each of
  // them.
  constexpr int kSome = 8'000;
  constexpr int kMany = 24'000;
  const auto some = costs(kSome);
  const auto many = costs(kMany);
  for (const auto& [what, steps] : some) EXPECT_LT(many.at(what) - steps, kMany - kSome) << what;
}

}  // namespace
}  // namespace nazori::study
