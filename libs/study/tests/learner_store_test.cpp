// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/learner_store.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "learner_fixture.h"
#include "nazori/study/exchange.h"

namespace nazori::study {
namespace {

using std::chrono::days;
using std::chrono::hours;
using std::chrono::minutes;
using test::bytes_of;
using test::MovedClock;
using test::must;
using test::review;
using test::some_ink;
using test::study_at_random;
using test::TemporaryFolder;
using test::use_zone;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr char32_t kRest = U'休';
constexpr char32_t kTree = U'木';

LearnerStore open(const std::filesystem::path& file, const MovedClock& clock) {
  return must(LearnerStore::open(file, Access::write, clock.clock()));
}

TEST(LearnerStore, SchedulesAReviewAsTheSchedulerSays) {
  MovedClock clock("2026-01-01T09:00:00Z");
  LearnerStore store = must(LearnerStore::in_memory(clock.clock()));
  use_zone(store, "UTC");
  const Card card = must(store.add_writing(kRest, 6, review(Rating::easy)));
  EXPECT_EQ(card.memory, Fsrs().next({}, Rating::easy, clock.now(), 0));
  EXPECT_EQ(card.due_day, *parse_day("2026-01-09"));
  EXPECT_EQ(card.introduced, *parse_day("2026-01-01"));
  clock.advance(days(10));
  const Card later = must(store.add_writing(kRest, 6, review(Rating::good)));
  EXPECT_EQ(later.memory, Fsrs().next(card.memory, Rating::good, clock.now(), 10));
}

TEST(LearnerStore, CountsStudyDaysNotHours) {
  // 23:00 and 01:00 belong to the same study day; 03:00 and 05:00 are two days.
  MovedClock clock("2026-01-01T23:00:00Z");
  LearnerStore store = must(LearnerStore::in_memory(clock.clock()));
  use_zone(store, "UTC");
  const Card evening = must(store.add_writing(kRest, 6, review(Rating::easy)));
  clock.set("2026-01-02T01:00:00Z");
  EXPECT_EQ(must(store.add_writing(kRest, 6, review(Rating::good))).memory,
            Fsrs().next(evening.memory, Rating::good, clock.now(), 0));
  const Card night = must(store.add_writing(kTree, 4, review(Rating::easy)));
  clock.set("2026-01-02T05:00:00Z");
  EXPECT_EQ(must(store.add_writing(kTree, 4, review(Rating::good))).memory,
            Fsrs().next(night.memory, Rating::good, clock.now(), 1));
}

TEST(LearnerStore, AClockThatWasPutBackCountsAsNoTime) {
  MovedClock clock("2026-01-10T09:00:00Z");
  LearnerStore store = must(LearnerStore::in_memory(clock.clock()));
  const Card card = must(store.add_writing(kRest, 6, review(Rating::easy)));
  clock.set("2026-01-01T09:00:00Z");
  EXPECT_EQ(must(store.add_writing(kRest, 6, review(Rating::good))).memory,
            Fsrs().next(card.memory, Rating::good, clock.now(), 0));
}

TEST(LearnerStore, PracticeIsKeptButSchedulesNothing) {
  MovedClock clock("2026-01-01T09:00:00Z");
  LearnerStore store = must(LearnerStore::in_memory(clock.clock()));
  Writing trace = review(Rating::good);
  trace.stage = Stage::trace;
  const Card card = must(store.add_writing(kRest, 6, trace));
  EXPECT_EQ(card.memory, Memory{});
  EXPECT_EQ(card.practices, 1);
  EXPECT_EQ(card.next_stage, Stage::guided);
  EXPECT_EQ(must(store.writings_of(kRest)).size(), 1U);
}

TEST(LearnerStore, RemembersEverythingAcrossRestarts) {
  const TemporaryFolder folder;
  MovedClock clock("2026-01-01T09:00:00Z");
  Writing writing = review(Rating::hard);
  writing.result.hints = 1;
  writing.result.help = 0.25;
  Card card;
  {
    LearnerStore store = open(folder / "learner.db", clock);
    Settings settings = store.settings();
    settings.new_per_day = 7;
    ASSERT_TRUE(store.change_settings(settings));
    card = must(store.add_writing(kRest, 6, writing, some_ink()));
  }
  const LearnerStore store = open(folder / "learner.db", clock);
  EXPECT_EQ(store.settings().new_per_day, 7);
  EXPECT_EQ(store.card(kRest), card);
  const auto writings = must(store.writings_of(kRest));
  ASSERT_EQ(writings.size(), 1U);
  EXPECT_EQ(writings[0].entry.writing, writing);
  EXPECT_TRUE(writings[0].has_ink);
  EXPECT_TRUE(writings[0].motion);
  EXPECT_EQ(must(store.ink_of(writings[0].entry.id)), some_ink());
}

TEST(LearnerStore, UndoTakesBackAnyNumberAcrossRestarts) {
  const TemporaryFolder folder;
  MovedClock clock("2026-01-01T09:00:00Z");
  std::vector<Card> before;
  {
    LearnerStore store = open(folder / "learner.db", clock);
    for (const Rating rating : {Rating::good, Rating::good, Rating::again, Rating::easy}) {
      before.push_back(store.card(kRest));
      (void)must(store.add_writing(kRest, 6, review(rating)));
      clock.advance(hours(30));
    }
  }
  while (!before.empty()) {
    LearnerStore store = open(folder / "learner.db", clock);
    const auto undone = must(store.undo());
    ASSERT_TRUE(undone);
    EXPECT_THAT(undone->characters, ElementsAre(kRest));
    EXPECT_EQ(store.card(kRest), before.back());
    before.pop_back();
  }
  LearnerStore store = open(folder / "learner.db", clock);
  EXPECT_FALSE(must(store.undo()));
  EXPECT_TRUE(store.cards().empty());
  EXPECT_EQ(store.last_entry(), 8);  // nothing was ever removed from the log
}

TEST(LearnerStore, AnActionOnManyCharactersIsTakenBackAtOnce) {
  MovedClock clock("2026-01-01T09:00:00Z");
  LearnerStore store = must(LearnerStore::in_memory(clock.clock()));
  (void)must(store.add_writing(kRest, 6, review(Rating::easy)));
  (void)must(store.add_writing(kTree, 4, review(Rating::easy)));
  const Cards before = store.cards();
  const std::array both{kRest, kTree};
  ASSERT_TRUE(store.reset(both));
  EXPECT_EQ(store.card(kRest).memory, Memory{});
  EXPECT_FALSE(store.card(kTree).introduced);
  const auto undone = must(store.undo());
  ASSERT_TRUE(undone);
  EXPECT_EQ(undone->kind, EntryKind::reset);
  EXPECT_EQ(store.cards(), before);
}

/// Known for three weeks, and forgotten.
void forget(LearnerStore& store, MovedClock& clock) {
  (void)must(store.add_writing(kRest, 6, review(Rating::easy)));
  EXPECT_FALSE(store.card(kRest).leech);
  clock.advance(days(20));
  (void)must(store.add_writing(kRest, 6, review(Rating::again)));
  clock.advance(days(1));
}

TEST(LearnerStore, WhatIsForgottenTooOftenIsSetApartUntilItsLessonIsDone) {
  MovedClock clock("2026-01-01T09:00:00Z");
  LearnerStore store = must(LearnerStore::in_memory(clock.clock()));
  Settings settings = store.settings();
  settings.leech_lapses = 3;
  ASSERT_TRUE(store.change_settings(settings));
  for (int lapse = 0; lapse < 3; ++lapse) forget(store, clock);
  EXPECT_TRUE(store.card(kRest).leech);
  ASSERT_TRUE(store.leech_met(std::span(&kRest, 1)));
  EXPECT_FALSE(store.card(kRest).leech);
  EXPECT_EQ(store.card(kRest).leech_at, 5);
  EXPECT_EQ(store.card(kRest).next_stage, Stage::guided);
}

TEST(LearnerStore, ALowerNumberOfLapsesSetsApartWhatWasKnownBefore) {
  MovedClock clock("2026-01-01T09:00:00Z");
  LearnerStore store = must(LearnerStore::in_memory(clock.clock()));
  forget(store, clock);
  Settings settings = store.settings();
  settings.leech_lapses = 2;
  ASSERT_TRUE(store.change_settings(settings));
  EXPECT_FALSE(store.card(kRest).leech);
  forget(store, clock);
  EXPECT_TRUE(store.card(kRest).leech);
  EXPECT_EQ(must(store.rebuild()).differences, 0);
}

TEST(LearnerStore, NewWeightsChangeTheMemoryButNotTheDay) {
  MovedClock clock("2026-01-01T09:00:00Z");
  LearnerStore store = must(LearnerStore::in_memory(clock.clock()));
  (void)must(store.add_writing(kRest, 6, review(Rating::easy)));
  clock.advance(days(9));
  const Card before = must(store.add_writing(kRest, 6, review(Rating::good)));
  Settings settings = store.settings();
  settings.fsrs.weights[3] = 20;
  ASSERT_TRUE(store.change_settings(settings));
  const Card after = store.card(kRest);
  EXPECT_EQ(after.due_day, before.due_day);
  EXPECT_GT(after.memory.stability, before.memory.stability);
  EXPECT_EQ(must(store.rebuild()).differences, 0);
}

TEST(LearnerStore, EveryStateFollowsFromTheLog) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    MovedClock clock("2026-01-01T09:00:00Z");
    LearnerStore store = must(LearnerStore::in_memory(clock.clock()));
    study_at_random(store, clock, seed, 400);
    const Cards before = store.cards();
    const RebuildReport report = must(store.rebuild());
    EXPECT_EQ(report.differences, 0) << seed;
    EXPECT_EQ(store.cards(), before);
    EXPECT_GT(report.cards, 10);
  }
}

/// The cards of a file in which sixty actions were written and which is closed again.
Cards kept_after_study(const std::filesystem::path& file, MovedClock& clock, unsigned seed) {
  LearnerStore store = open(file, clock);
  study_at_random(store, clock, seed, 60);
  return store.cards();
}

TEST(LearnerStore, RebuildingMendsCardsThatWereChanged) {
  const TemporaryFolder folder;
  MovedClock clock("2026-01-01T09:00:00Z");
  const Cards before = kept_after_study(folder / "learner.db", clock, 4);
  {
    SQLite::Database db((folder / "learner.db").string(), SQLite::OPEN_READWRITE);
    db.exec(
        "UPDATE card SET stability = 1 WHERE character = (SELECT min(character) FROM card WHERE stability > "
        "0);"
        "DELETE FROM card WHERE character = (SELECT max(character) FROM card)");
  }
  LearnerStore store = open(folder / "learner.db", clock);
  EXPECT_EQ(must(store.rebuild()).differences, 2);
  EXPECT_EQ(store.cards(), before);
}

TEST(LearnerStore, RebuildingMendsCardsThatCannotBeRead) {
  const TemporaryFolder folder;
  MovedClock clock("2026-01-01T09:00:00Z");
  const Cards before = kept_after_study(folder / "learner.db", clock, 6);
  {
    SQLite::Database db((folder / "learner.db").string(), SQLite::OPEN_READWRITE);
    db.exec("UPDATE card SET phase = 9");
  }
  for (const Access access : {Access::read, Access::write}) {
    const auto refused = LearnerStore::open(folder / "learner.db", access, clock.clock());
    ASSERT_FALSE(refused);
    EXPECT_THAT(base::to_line(refused.error()), HasSubstr("study rebuild"));
  }
  {
    LearnerStore store = must(LearnerStore::open(folder / "learner.db", Access::rebuild, clock.clock()));
    const RebuildReport report = must(store.rebuild());
    EXPECT_EQ(report.differences, report.cards);
    EXPECT_EQ(store.cards(), before);
  }
  EXPECT_EQ(open(folder / "learner.db", clock).cards(), before);
}

TEST(LearnerStore, RebuildingTellsWhoIsStudiedFromWhoIsOnlyPaused) {
  MovedClock clock("2026-01-01T09:00:00Z");
  LearnerStore store = must(LearnerStore::in_memory(clock.clock()));
  for (char32_t c = U'一'; c < U'一' + 6; ++c) (void)must(store.add_writing(c, 4, review(Rating::good)));
  ASSERT_TRUE(store.pause(std::array{kRest}));
  (void)must(store.add_writing(kTree, 4, review(Rating::good)));
  (void)must(store.undo());
  const RebuildReport report = must(store.rebuild());
  EXPECT_EQ(report.cards, 7);
  EXPECT_EQ(report.studied, 6);
  EXPECT_EQ(report.differences, 0);
}

TEST(LearnerStore, ChangedClocksAndJourneysMoveNoDueDay) {
  // Moments at which the clocks change: Berlin forward and back, Sao Paulo back and forward at midnight.
  struct Change {
    const char* zone;
    const char* evening_before;  // UTC
  };
  for (const Change change :
       {Change{"Europe/Berlin", "2026-03-28T20:00:00Z"}, Change{"Europe/Berlin", "2026-10-24T20:00:00Z"},
        Change{"America/Sao_Paulo", "2018-02-17T22:00:00Z"},
        Change{"America/Sao_Paulo", "2018-11-03T22:00:00Z"}, Change{"Asia/Tokyo", "2026-03-28T11:00:00Z"}}) {
    MovedClock clock(change.evening_before);
    LearnerStore store = must(LearnerStore::in_memory(clock.clock()));
    use_zone(store, change.zone);
    const Day evening = store.today();
    const Card card = must(store.add_writing(kRest, 6, review(Rating::easy)));
    ASSERT_TRUE(card.due_day) << change.zone;
    EXPECT_EQ(*card.due_day, evening + days(card.memory.scheduled_days)) << change.zone;
    // Days are counted by the calendar even when the clocks change: due when that day begins, not before.
    const Time due = store.calendar().begin_of(*card.due_day);
    clock.set(to_text(due - std::chrono::minutes(1)).c_str());
    EXPECT_EQ(store.today() + days(1), *card.due_day) << change.zone;
    clock.set(to_text(due).c_str());
    EXPECT_EQ(store.today(), *card.due_day) << change.zone;
    // In another time zone the day of the log is kept, and rebuilding changes nothing.
    use_zone(store, "Pacific/Auckland");
    EXPECT_EQ(store.card(kRest).due_day, card.due_day) << change.zone;
    EXPECT_EQ(must(store.rebuild()).differences, 0) << change.zone;
  }
}

TEST(LearnerStore, TheLogCanOnlyBeAddedTo) {
  const TemporaryFolder folder;
  MovedClock clock("2026-01-01T09:00:00Z");
  {
    LearnerStore store = open(folder / "learner.db", clock);
    (void)must(store.add_writing(kRest, 6, review(Rating::good)));
  }
  SQLite::Database db((folder / "learner.db").string(), SQLite::OPEN_READWRITE);
  EXPECT_THROW(db.exec("UPDATE log SET rating = 4"), SQLite::Exception);
  EXPECT_THROW(db.exec("DELETE FROM log"), SQLite::Exception);
}

TEST(LearnerStore, AnExportFillsAnotherStoreExactly) {
  MovedClock clock("2026-01-01T09:00:00Z");
  LearnerStore store = must(LearnerStore::in_memory(clock.clock()));
  study_at_random(store, clock, 5, 200);
  ASSERT_TRUE(store.save_list({"trees", {kTree, kRest}}));
  const std::vector<std::string> tags{"hard", "school"};
  ASSERT_TRUE(store.set_tags(kRest, tags));
  LearnerStore other = must(LearnerStore::in_memory(clock.clock()));
  const std::string text = must(export_json(store));
  const auto filled = import_json(other, text_source(text));
  ASSERT_TRUE(filled) << base::to_line(filled.error());
  EXPECT_EQ(other.cards(), store.cards());
  EXPECT_EQ(other.settings(), store.settings());
  EXPECT_EQ(must(other.lists()), must(store.lists()));
  EXPECT_EQ(must(other.tags_of(kRest)), tags);
  EXPECT_EQ(must(other.tags()), must(store.tags()));
  EXPECT_EQ(must(other.rebuild()).differences, 0);
  const auto again = import_json(other, text_source(text));
  EXPECT_FALSE(again);
  EXPECT_THAT(again.error().what, HasSubstr("not empty"));
}

/// Every enumerator that has a name, whatever the header lists.
template <class Enum>
std::vector<Enum> all_of() {
  std::vector<Enum> all;
  for (int number = 0; number <= UINT8_MAX; ++number)
    if (!name_of(static_cast<Enum>(number)).empty()) all.push_back(static_cast<Enum>(number));
  return all;
}

TEST(LearnerStore, EveryStageRatingAndMistakeThereIsComesBack) {
  const TemporaryFolder folder;
  const MovedClock clock("2026-01-01T09:00:00Z");
  std::vector<Writing> written;
  {
    LearnerStore store = open(folder / "learner.db", clock);
    for (const Stage stage : all_of<Stage>()) {
      for (const Rating rating : all_of<Rating>()) {
        Writing& writing = written.emplace_back(review(rating));
        writing.stage = stage;
        writing.result.mistakes.clear();
        for (const kanji::MistakeKind kind : all_of<kanji::MistakeKind>())
          writing.result.mistakes.push_back({kind, 1});
        (void)must(store.add_writing(kRest, 6, writing));
      }
    }
  }
  // The stages of a lesson, and the brush.
  ASSERT_EQ(written.size(), (kStages.size() + 1) * kRatings.size()) << "the lists in the headers are whole";
  std::vector<Writing> read;
  for (const auto& one : must(open(folder / "learner.db", clock).writings_of(kRest)))
    read.push_back(one.entry.writing);
  EXPECT_EQ(read, written);
}

TEST(LearnerStore, ANumberThatIsNoStageRatingKindOrPhaseIsDamage) {
  const MovedClock clock("2026-01-01T09:00:00Z");
  const auto number_after = [](const auto& all) { return static_cast<int>(all.back()) + 1; };
  const std::array<std::pair<std::string, int>, 5> columns{{{"kind", number_after(all_of<EntryKind>())},
                                                            {"stage", number_after(all_of<Stage>())},
                                                            {"rating", number_after(all_of<Rating>())},
                                                            {"rating", 0},
                                                            {"proposed", 300}}};
  for (const auto& [column, number] : columns) {
    const TemporaryFolder folder;
    (void)must(open(folder / "learner.db", clock).add_writing(kRest, 6, review(Rating::good)));
    {
      SQLite::Database db((folder / "learner.db").string(), SQLite::OPEN_READWRITE);
      db.exec("DROP TRIGGER log_is_not_changed");
      db.exec("UPDATE log SET " + column + " = " + std::to_string(number));
    }
    const auto read =
        open(folder / "learner.db", clock).for_each_entry(false, [](const auto&) { return true; });
    ASSERT_FALSE(read) << column;
    EXPECT_EQ(read.error().code, base::Errc::parse) << column;
  }
  for (const auto& [column, number] : {std::pair("phase", number_after(all_of<Phase>())),
                                       std::pair("next_stage", number_after(all_of<Stage>()))}) {
    const TemporaryFolder folder;
    (void)must(open(folder / "learner.db", clock).add_writing(kRest, 6, review(Rating::good)));
    SQLite::Database((folder / "learner.db").string(), SQLite::OPEN_READWRITE)
        .exec(std::string("UPDATE card SET ") + column + " = " + std::to_string(number));
    const auto opened = LearnerStore::open(folder / "learner.db", Access::write, clock.clock());
    ASSERT_FALSE(opened) << column;
    EXPECT_EQ(opened.error().code, base::Errc::parse) << column;
  }
}

TEST(LearnerStore, APreviewIsWhatTheReviewThenGives) {
  MovedClock clock("2026-01-01T09:00:00Z");
  LearnerStore store = must(LearnerStore::in_memory(clock.clock()));
  (void)must(store.add_writing(kRest, 6, review(Rating::easy)));
  clock.advance(days(8));
  for (const Rating rating : kRatings) {
    const Card seen = must(store.preview(kRest, rating));
    EXPECT_EQ(must(store.add_writing(kRest, 6, review(rating))).memory, seen.memory);
    (void)must(store.undo());
  }
}

TEST(LearnerStore, WhereIntervalsVaryAPreviewTellsTheDayThatIsKept) {
  for (const bool balance : {false, true}) {
    MovedClock clock("2026-01-01T09:00:00Z");
    LearnerStore store = must(LearnerStore::in_memory(clock.clock()));
    Settings settings = store.settings();
    (balance ? settings.load_balance : settings.fuzz) = true;
    ASSERT_TRUE(store.change_settings(settings));
    for (char32_t c = U'一'; c < U'一' + 12; ++c) (void)must(store.add_writing(c, 4, review(Rating::easy)));
    clock.advance(days(8));
    int moved = 0;
    const Fsrs fsrs = must(Fsrs::create(settings.fsrs));
    for (char32_t c = U'一'; c < U'一' + 12; ++c) {
      for (const Rating rating : kRatings) {
        const Card before = store.card(c);
        const Card seen = must(store.preview(c, rating));
        EXPECT_EQ(store.card(c), before) << "a preview keeps nothing";
        const Card kept = must(store.add_writing(c, 4, review(rating)));
        EXPECT_EQ(seen.due_day, kept.due_day)
            << static_cast<int>(rating) << (balance ? " balanced" : " fuzz");
        EXPECT_EQ(seen.memory, kept.memory);
        if (kept.due_day && kept.memory.scheduled_days != fsrs.interval_days(kept.memory.stability)) ++moved;
        // Characters rated Easy stay, so that there is a load to balance.
        if (rating != Rating::easy) (void)must(store.undo());
      }
    }
    EXPECT_GT(moved, 3) << "else nothing was tried";
  }
}

TEST(LearnerStore, LoadIsBalancedWithinTheRange) {
  MovedClock clock("2026-01-01T09:00:00Z");
  LearnerStore store = must(LearnerStore::in_memory(clock.clock()));
  Settings settings = store.settings();
  settings.load_balance = true;
  ASSERT_TRUE(store.change_settings(settings));
  std::map<Day, int> load;
  for (char32_t c = U'一'; c < U'一' + 30; ++c)
    ++load[*must(store.add_writing(c, 4, review(Rating::easy))).due_day];
  // 8 days may become 6 to 10: thirty characters, five days.
  EXPECT_EQ(load.size(), 5U);
  for (const auto& [day, count] : load) EXPECT_EQ(count, 6) << to_text(day);
  EXPECT_EQ(must(store.rebuild()).differences, 0);
}

TEST(LearnerStore, ListsAndTagsAreKept) {
  MovedClock clock("2026-01-01T09:00:00Z");
  LearnerStore store = must(LearnerStore::in_memory(clock.clock()));
  ASSERT_TRUE(store.save_list({"b", {kTree, kRest, kTree}}));
  ASSERT_TRUE(store.save_list({"a", {kRest}}));
  EXPECT_THAT(must(store.lists()), ElementsAre(CustomList{"a", {kRest}}, CustomList{"b", {kTree, kRest}}));
  ASSERT_TRUE(store.remove_list("a"));
  EXPECT_EQ(store.remove_list("a").error().code, base::Errc::not_found);
  EXPECT_FALSE(store.save_list({"", {kRest}}));
  EXPECT_FALSE(store.save_list({"two\nlines", {kRest}}));
  EXPECT_FALSE(store.save_list({"\xFF", {kRest}}));
}

TEST(LearnerStore, WhatCannotBeReadIsAnErrorNotNothing) {
  for (const char* table : {"log", "list", "list_member", "tag"}) {
    const TemporaryFolder folder;
    const MovedClock clock("2026-01-01T09:00:00Z");
    LearnerStore store = open(folder / "learner.db", clock);
    (void)must(store.add_writing(kRest, 6, review(Rating::good)));
    SQLite::Database((folder / "learner.db").string(), SQLite::OPEN_READWRITE, 1'000)
        .exec(std::string("ALTER TABLE ") + table + " RENAME TO gone");
    const bool log = table == std::string("log");
    const bool tag = table == std::string("tag");
    EXPECT_EQ(store.preview(kRest, Rating::good).has_value(), !log) << table;
    EXPECT_EQ(store.usual_writing(kRest).has_value(), !log) << table;
    EXPECT_EQ(store.lists().has_value(), log || tag) << table;
    EXPECT_EQ(store.tags().has_value(), !tag) << table;
    EXPECT_EQ(store.tags_of(kRest).has_value(), !tag) << table;
  }
}

TEST(LearnerStore, ACardIsNotWorkedOutWithoutAnEntryThatIsDamaged) {
  const TemporaryFolder folder;
  const MovedClock clock("2026-01-01T09:00:00Z");
  LearnerStore store = open(folder / "learner.db", clock);
  (void)must(store.add_writing(kRest, 6, review(Rating::good)));
  (void)must(store.add_writing(kTree, 4, review(Rating::good)));
  const Cards before = store.cards();
  {
    SQLite::Database db((folder / "learner.db").string(), SQLite::OPEN_READWRITE, 1'000);
    db.exec("DROP TRIGGER log_is_not_changed; UPDATE log SET score = 999 WHERE id = 1");
  }
  EXPECT_EQ(store.preview(kRest, Rating::good).error().code, base::Errc::parse);
  const auto added = store.add_writing(kRest, 6, review(Rating::good));
  ASSERT_FALSE(added);
  EXPECT_EQ(added.error().code, base::Errc::parse);
  EXPECT_THAT(base::to_line(added.error()), HasSubstr("entry 1"));
  EXPECT_EQ(store.writings_of(kRest).error().code, base::Errc::parse);
  EXPECT_EQ(store.cards(), before);
  EXPECT_TRUE(store.add_writing(kTree, 4, review(Rating::good))) << "others can be studied";
}

TEST(LearnerStore, WhatIsNoWritingIsRefused) {
  MovedClock clock("2026-01-01T09:00:00Z");
  LearnerStore store = must(LearnerStore::in_memory(clock.clock()));
  EXPECT_EQ(store.add_writing(0, 6, review(Rating::good)).error().where, "character");
  EXPECT_EQ(store.add_writing(0xD800, 6, review(Rating::good)).error().where, "character");
  EXPECT_EQ(store.add_writing(kRest, 0, review(Rating::good)).error().where, "strokes");
  Writing writing = review(Rating::good);
  writing.result.score = 101;
  EXPECT_EQ(store.add_writing(kRest, 6, writing).error().where, "score");
  EXPECT_EQ(store.last_entry(), 0);
}

}  // namespace
}  // namespace nazori::study
