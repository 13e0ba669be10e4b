// SPDX-License-Identifier: Apache-2.0
// What each action leaves behind, also where it fails halfway.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "learner_fixture.h"

namespace nazori::study {
namespace {

using std::chrono::days;
using test::MovedClock;
using test::must;
using test::review;
using test::TemporaryFolder;
using test::use_zone;
using testing::ElementsAre;

constexpr char32_t kRest = U'休';
constexpr char32_t kTree = U'木';

LearnerStore in_memory(const MovedClock& clock) { return must(LearnerStore::in_memory(clock.clock())); }

Settings with_other_weights(const LearnerStore& store) {
  Settings settings = store.settings();
  settings.fsrs.weights[3] = 20;
  return settings;
}

TEST(Undo, PassesOverSettingsAndWhatWasUndone) {
  MovedClock clock("2026-01-01T09:00:00Z");
  LearnerStore store = in_memory(clock);
  EXPECT_FALSE(must(store.undo()));
  (void)must(store.add_writing(kRest, 6, review(Rating::good)));
  ASSERT_TRUE(store.pause(std::array{kTree, kRest, kTree}));
  Settings settings = store.settings();
  settings.new_per_day = 9;
  ASSERT_TRUE(store.change_settings(settings));
  auto undone = must(store.undo());
  ASSERT_TRUE(undone);
  EXPECT_EQ(undone->kind, EntryKind::pause);
  EXPECT_THAT(undone->characters, ElementsAre(kRest, kTree)) << "each once, in order";
  undone = must(store.undo());
  ASSERT_TRUE(undone);
  EXPECT_EQ(undone->kind, EntryKind::writing);
  EXPECT_THAT(undone->characters, ElementsAre(kRest));
  EXPECT_FALSE(must(store.undo()));
  EXPECT_EQ(store.settings().new_per_day, 9);
  EXPECT_TRUE(store.cards().empty());
  EXPECT_EQ(store.last_entry(), 7);
}

TEST(Undo, ThatFailsChangesNothing) {
  const TemporaryFolder folder;
  const MovedClock clock("2026-01-01T09:00:00Z");
  LearnerStore store = must(LearnerStore::open(folder / "learner.db", Access::write, clock.clock()));
  (void)must(store.add_writing(kRest, 6, review(Rating::good)));
  const Cards before = store.cards();
  SQLite::Database other((folder / "learner.db").string(), SQLite::OPEN_READWRITE, 1'000);
  other.exec("ALTER TABLE card RENAME TO gone");
  EXPECT_FALSE(store.undo());
  EXPECT_FALSE(store.change_settings(with_other_weights(store)));
  EXPECT_FALSE(store.add_writing(kRest, 6, review(Rating::good)));
  EXPECT_EQ(store.cards(), before);
  EXPECT_EQ(store.last_entry(), 1);
  EXPECT_EQ(store.settings(), Settings());
  EXPECT_EQ(must(store.writings_of(kRest)).size(), 1U) << "still in force";
  other.exec("ALTER TABLE gone RENAME TO card");
  EXPECT_TRUE(must(store.undo()));
  EXPECT_TRUE(store.cards().empty());
  EXPECT_EQ(store.last_entry(), 2);
}

TEST(ChangeSettings, OfNothingIsNoEntry) {
  const MovedClock clock("2026-01-01T09:00:00Z");
  LearnerStore store = in_memory(clock);
  ASSERT_TRUE(store.change_settings(store.settings()));
  EXPECT_EQ(store.last_entry(), 0);
  Settings wrong = store.settings();
  wrong.new_per_day = -1;
  EXPECT_FALSE(store.change_settings(wrong));
  EXPECT_EQ(store.last_entry(), 0);
}

TEST(ChangeSettings, TellsHowManyCardsAreWorkedOutAndIsTakenBackWhereItIsStopped) {
  MovedClock clock("2026-01-01T09:00:00Z");
  LearnerStore store = in_memory(clock);
  for (const char32_t c : {U'一', U'二', U'三', U'四'})
    (void)must(store.add_writing(c, 4, review(Rating::easy)));
  const Cards before = store.cards();
  const Settings settings = with_other_weights(store);
  for (int asked = 1; asked <= 4; ++asked) {
    int left = asked;
    const auto stopped =
        store.change_settings(settings, [&](double, std::string_view) { return --left > 0; });
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().code, base::Errc::cancelled);
    EXPECT_EQ(store.cards(), before);
    EXPECT_EQ(store.settings(), Settings());
    EXPECT_EQ(store.last_entry(), 4);
  }
  std::vector<double> reported;
  ASSERT_TRUE(store.change_settings(settings, [&](double done, std::string_view step) {
    EXPECT_EQ(step, "cards");
    reported.push_back(done);
    return true;
  }));
  EXPECT_THAT(reported, ElementsAre(0.25, 0.5, 0.75, 1));
  EXPECT_EQ(store.card(U'一').memory.stability, 20);
  EXPECT_EQ(store.last_entry(), 5);
  // Settings that change no numbers do not cause cards to be computed again.
  Settings more = store.settings();
  more.new_per_day = 1;
  ASSERT_TRUE(store.change_settings(more, [](double, std::string_view) {
    ADD_FAILURE();
    return false;
  }));
}

TEST(ChangeSettings, OfTheDayMoveTheCalendarAtOnce) {
  const MovedClock clock("2026-01-02T03:00:00Z");
  LearnerStore store = in_memory(clock);
  use_zone(store, "UTC");
  EXPECT_EQ(store.today(), *parse_day("2026-01-01"));
  Settings settings = store.settings();
  settings.day_starts_at = 2;
  ASSERT_TRUE(store.change_settings(settings));
  EXPECT_EQ(store.today(), *parse_day("2026-01-02"));
  use_zone(store, "America/New_York");
  EXPECT_EQ(store.today(), *parse_day("2026-01-01"));
  EXPECT_EQ(store.calendar().zone(), "America/New_York");
}

TEST(ChangeSettings, CountFromTheirEntryOn) {
  // Retention 0.8 from the second review on: the first interval is unchanged, also after rebuilding.
  MovedClock clock("2026-01-01T09:00:00Z");
  LearnerStore store = in_memory(clock);
  use_zone(store, "UTC");
  (void)must(store.add_writing(kRest, 6, review(Rating::easy)));
  Settings settings = store.settings();
  settings.fsrs.desired_retention = 0.8;
  ASSERT_TRUE(store.change_settings(settings));
  EXPECT_EQ(store.card(kRest).memory.scheduled_days, 8);
  clock.advance(days(8));
  const Card after = must(store.add_writing(kRest, 6, review(Rating::good)));
  EXPECT_EQ(after.memory.scheduled_days,
            must(Fsrs::create(settings.fsrs)).interval_days(after.memory.stability));
  EXPECT_EQ(must(store.rebuild()).differences, 0);
}

TEST(Preview, ChangesNothingAndCountsStudyDays) {
  MovedClock clock("2026-01-10T09:00:00Z");
  LearnerStore store = in_memory(clock);
  use_zone(store, "UTC");
  const Card card = must(store.add_writing(kRest, 6, review(Rating::easy)));
  EXPECT_EQ(must(store.preview(kTree, Rating::good)).memory, Fsrs().next({}, Rating::good, clock.now(), 0));
  clock.advance(days(3));
  EXPECT_EQ(must(store.preview(kRest, Rating::again)).memory,
            Fsrs().next(card.memory, Rating::again, clock.now(), 3));
  EXPECT_EQ(must(store.preview(kRest, Rating::again)).next_stage, Stage::guided)
      << "as one that was not accepted";
  clock.advance(-days(9));
  EXPECT_EQ(must(store.preview(kRest, Rating::good)).memory,
            Fsrs().next(card.memory, Rating::good, clock.now(), 0));
  EXPECT_EQ(store.last_entry(), 2);
}

TEST(Rebuild, CountsCardsThatAreMissingTooManyOrOtherwise) {
  const TemporaryFolder folder;
  const MovedClock clock("2026-01-01T09:00:00Z");
  {
    LearnerStore store = must(LearnerStore::open(folder / "learner.db", Access::write, clock.clock()));
    for (const char32_t c : {U'一', U'二', U'三'}) (void)must(store.add_writing(c, 4, review(Rating::good)));
    Writing watched = review(Rating::good);
    watched.stage = Stage::watch;
    (void)must(store.add_writing(U'四', 4, watched));
    ASSERT_TRUE(store.pause(std::array{U'五'}));
  }
  const auto differences = [&](const char* sql) {
    { SQLite::Database((folder / "learner.db").string(), SQLite::OPEN_READWRITE).exec(sql); }
    LearnerStore store = must(LearnerStore::open(folder / "learner.db", Access::write, clock.clock()));
    const RebuildReport report = must(store.rebuild());
    EXPECT_EQ(report.entries, 5);
    EXPECT_EQ(report.cards, 5);
    EXPECT_EQ(report.studied, 4);
    EXPECT_EQ(store.cards().size(), 5U);
    return report.differences;
  };
  EXPECT_EQ(differences("SELECT 1"), 0);
  EXPECT_EQ(differences("DELETE FROM card WHERE reps > 0"), 3);
  EXPECT_EQ(differences("UPDATE card SET reps = 9 WHERE reps > 0"), 3);
  EXPECT_EQ(differences("UPDATE card SET character = 20000 WHERE character = 19968"), 2)
      << "one too many, one missing";
  EXPECT_EQ(
      RebuildReport().entries + RebuildReport().cards + RebuildReport().studied + RebuildReport().differences,
      0);
}

TEST(Rebuild, TellsHowFarItIsAndStops) {
  const MovedClock clock("2026-01-01T09:00:00Z");
  LearnerStore store = in_memory(clock);
  ASSERT_TRUE(store.fill(test::long_history(1'023)));
  std::vector<double> reported;
  ASSERT_TRUE(store.rebuild([&](double done, std::string_view step) {
    EXPECT_EQ(step, "rebuild");
    reported.push_back(done);
    return true;
  }));
  EXPECT_THAT(reported, ElementsAre(0.25, 0.5, 0.75));
  const Cards before = store.cards();
  EXPECT_EQ(store.rebuild([](double, std::string_view) { return false; }).error().code,
            base::Errc::cancelled);
  EXPECT_EQ(store.cards(), before);
}

TEST(Lists, ThatAreSavedAgainAreReplacedAndThoseRemovedAreGone) {
  const MovedClock clock("2026-01-01T09:00:00Z");
  LearnerStore store = in_memory(clock);
  ASSERT_TRUE(store.save_list({"a", {U'三', U'一', U'二'}}));
  ASSERT_TRUE(store.save_list({"b", {U'四'}}));
  ASSERT_TRUE(store.save_list({"a", {U'二', U'五'}}));
  EXPECT_THAT(must(store.lists()), ElementsAre(CustomList{"a", {U'二', U'五'}}, CustomList{"b", {U'四'}}));
  ASSERT_TRUE(store.remove_list("a"));
  ASSERT_TRUE(store.save_list({"a", {}}));
  EXPECT_THAT(must(store.lists()), ElementsAre(CustomList{"a", {}}, CustomList{"b", {U'四'}}));
  EXPECT_EQ(store.save_list({" a", {}}).error().where, " a");
  EXPECT_EQ(store.last_entry(), 0) << "they are notes";
}

TEST(Tags, OfACharacterAreReplacedTogether) {
  const MovedClock clock("2026-01-01T09:00:00Z");
  LearnerStore store = in_memory(clock);
  const auto set = [&](char32_t c, std::vector<std::string> tags) {
    return store.set_tags(c, tags).has_value();
  };
  EXPECT_TRUE(set(kTree, {"b", "a", "b"}));
  EXPECT_TRUE(set(kRest, {"a"}));
  EXPECT_THAT(must(store.tags_of(kTree)), ElementsAre("a", "b"));
  EXPECT_THAT(must(store.tags()),
              ElementsAre(std::pair("a", std::vector{kRest, kTree}), std::pair("b", std::vector{kTree})));
  EXPECT_FALSE(set(kTree, {"c", "two\nlines"}));
  EXPECT_THAT(must(store.tags_of(kTree)), ElementsAre("a", "b")) << "as they were";
  EXPECT_TRUE(set(kTree, {"c"}));
  EXPECT_THAT(must(store.tags_of(kTree)), ElementsAre("c"));
  EXPECT_TRUE(set(kTree, {}));
  EXPECT_TRUE(must(store.tags_of(kTree)).empty());
  EXPECT_THAT(must(store.tags_of(kRest)), ElementsAre("a"));
}

}  // namespace
}  // namespace nazori::study
