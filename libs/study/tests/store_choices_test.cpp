// SPDX-License-Identifier: Apache-2.0
// What a learner chose to learn and knows already: one action, and no writing.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "learner_fixture.h"
#include "nazori/study/day_plan.h"
#include "nazori/study/exchange.h"
#include "nazori/study/statistics.h"

namespace nazori::study {
namespace {

using std::chrono::days;
using test::MovedClock;
using test::must;
using test::review;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr char32_t kRest = U'休';
constexpr char32_t kTree = U'木';

class Choices : public testing::Test {
 protected:
  /// A list of its own, four new characters a day, two characters known.
  [[nodiscard]] StudyChoices some() const {
    StudyChoices choices{store_.settings(), CustomList{"street", {U'道', U'車'}}, {}};
    choices.settings.new_lists = {"list:street"};
    choices.settings.new_order = NewOrder::own;
    choices.settings.new_per_day = 4;
    choices.known = {{kRest, store_.today() + days(12)}, {kTree, std::nullopt}};
    return choices;
  }

  MovedClock clock_{"2026-03-02T10:00:00Z"};
  LearnerStore store_ = must(LearnerStore::in_memory(clock_.clock()));
};

TEST_F(Choices, AreOneActionWithOneUndo) {
  const Settings before = store_.settings();
  ASSERT_TRUE(store_.choose(some()));
  EXPECT_EQ(store_.settings().new_per_day, 4);
  EXPECT_THAT(must(store_.lists()), ElementsAre(CustomList{"street", {U'道', U'車'}}));
  EXPECT_THAT(store_.cards(), SizeIs(2));
  const auto undone = must(store_.undo());
  ASSERT_TRUE(undone);
  EXPECT_EQ(undone->kind, EntryKind::choices);
  EXPECT_THAT(undone->characters, ElementsAre(kRest, kTree));
  EXPECT_EQ(store_.settings(), before);
  EXPECT_THAT(must(store_.lists()), IsEmpty());
  EXPECT_THAT(store_.cards(), IsEmpty());
  EXPECT_FALSE(must(store_.undo()));
}

TEST_F(Choices, OfEarlierAnswersComeBackWhenTheLaterOnesAreUndone) {
  StudyChoices first{store_.settings(), std::nullopt, {}};
  first.settings.new_per_day = 2;
  ASSERT_TRUE(store_.choose(first));
  ASSERT_TRUE(store_.choose(some()));
  ASSERT_TRUE(must(store_.undo()));
  EXPECT_EQ(store_.settings().new_per_day, 2);
  EXPECT_EQ(store_.settings().new_lists, Settings().new_lists);
}

TEST_F(Choices, WithoutAnyChangeAreNoAction) {
  ASSERT_TRUE(store_.choose({store_.settings(), std::nullopt, {}}));
  EXPECT_EQ(store_.last_entry(), 0);
}

TEST_F(Choices, ThatFailLeaveEverythingAsItWas) {
  const TemporaryFolder folder;
  LearnerStore store = must(LearnerStore::open(folder / "learner.db", Access::write, clock_.clock()));
  const StudyChoices choices = some();
  SQLite::Database other((folder / "learner.db").string(), SQLite::OPEN_READWRITE, 1'000);
  other.exec(
      "CREATE TRIGGER full BEFORE INSERT ON log WHEN NEW.kind = 8 BEGIN SELECT RAISE(ABORT, 'full'); END");
  EXPECT_FALSE(store.choose(choices));
  EXPECT_EQ(store.settings(), Settings());
  EXPECT_THAT(must(store.lists()), IsEmpty());
  EXPECT_THAT(store.cards(), IsEmpty());
  EXPECT_EQ(store.last_entry(), 0);
  other.exec("DROP TRIGGER full");
  ASSERT_TRUE(store.choose(choices));
  EXPECT_THAT(store.cards(), SizeIs(2));
}

TEST_F(Choices, MayNotReplaceAListNorChangeIntervalsOrDays) {
  ASSERT_TRUE(store_.save_list({"street", {U'町'}}));
  EXPECT_EQ(store_.choose(some()).error().what, "is the name of another list");
  EXPECT_THAT(must(store_.lists()), ElementsAre(CustomList{"street", {U'町'}}));
  for (const auto change :
       {+[](Settings& s) { s.fsrs.weights[3] = 20; }, +[](Settings& s) { s.day_starts_at = 6; },
        +[](Settings& s) { s.time_zone = "Asia/Tokyo"; }}) {
    StudyChoices choices{store_.settings(), std::nullopt, {}};
    change(choices.settings);
    EXPECT_EQ(store_.choose(choices).error().code, base::Errc::bad_argument);
  }
  StudyChoices choices = some();
  choices.list->name = " bad";
  EXPECT_FALSE(store_.choose(choices));
  choices = some();
  choices.list.reset();
  choices.known.push_back({0, std::nullopt});
  EXPECT_FALSE(store_.choose(choices));
  EXPECT_EQ(store_.last_entry(), 0);
}

TEST_F(Choices, UndoneKeepAListThatWasChangedOrIsStillChosen) {
  ASSERT_TRUE(store_.choose(some()));
  ASSERT_TRUE(store_.save_list({"street", {U'道'}}));
  ASSERT_TRUE(must(store_.undo()));
  EXPECT_THAT(must(store_.lists()), SizeIs(1)) << "the learner changed it";
  ASSERT_TRUE(store_.remove_list("street"));
  ASSERT_TRUE(store_.choose(some()));
  Settings settings = store_.settings();
  settings.new_per_day = 9;
  ASSERT_TRUE(store_.change_settings(settings));
  ASSERT_TRUE(must(store_.undo()));
  EXPECT_THAT(must(store_.lists()), SizeIs(1)) << "later settings name it";
  EXPECT_EQ(store_.settings().new_per_day, 9);
}

TEST_F(Choices, HoldAfterTheFileWasClosedAndAreUndoneThere) {
  const TemporaryFolder folder;
  const auto open = [&] {
    return must(LearnerStore::open(folder / "learner.db", Access::write, clock_.clock()));
  };
  std::optional<LearnerStore> store(open());
  ASSERT_TRUE(store->choose(some()));
  store.reset();
  store.emplace(open());
  EXPECT_EQ(store->settings().new_per_day, 4);
  EXPECT_EQ(store->card(kRest).due_day, store->today() + days(12));
  EXPECT_EQ(must(store->rebuild()).differences, 0);
  ASSERT_TRUE(must(store->undo()));
  store.reset();
  store.emplace(open());
  EXPECT_EQ(store->settings(), Settings());
  EXPECT_THAT(store->cards(), IsEmpty());
  EXPECT_EQ(must(store->rebuild()).differences, 0);
}

TEST_F(Choices, GoThroughAnExportUndoneOrNot) {
  ASSERT_TRUE(store_.choose(some()));
  LearnerStore other = must(LearnerStore::in_memory(clock_.clock()));
  ASSERT_TRUE(import_json(other, text_source(must(export_json(store_)))));
  EXPECT_EQ(other.cards(), store_.cards());
  EXPECT_EQ(other.settings(), store_.settings());
  EXPECT_EQ(must(export_json(other)), must(export_json(store_)));
  ASSERT_TRUE(must(other.undo()));
  EXPECT_THAT(must(other.lists()), IsEmpty());
  LearnerStore third = must(LearnerStore::in_memory(clock_.clock()));
  ASSERT_TRUE(import_json(third, text_source(must(export_json(other)))));
  EXPECT_EQ(third.settings(), Settings());
  EXPECT_THAT(third.cards(), IsEmpty());
}

TEST_F(Choices, KnownCharactersComeOnTheirDay) {
  ASSERT_TRUE(store_.choose(some()));
  const Card rest = store_.card(kRest);
  EXPECT_EQ(rest.memory.phase, Phase::review);
  EXPECT_EQ(rest.due_day, store_.today() + days(12));
  EXPECT_EQ(rest.memory.scheduled_days, 12);
  const Card as_rated_easy = must(store_.preview(U'川', Rating::easy));
  EXPECT_EQ(store_.card(kTree).due_day, as_rated_easy.due_day);
  EXPECT_EQ(store_.card(kTree).next_stage, Stage::memory);
  clock_.advance(days(12));
  const auto plan = must(plan_day(store_, {}));
  EXPECT_TRUE(std::any_of(plan.now.begin(), plan.now.end(),
                          [](const StudyTask& task) { return task.character == kRest; }));
}

TEST_F(Choices, KnownCharactersAreNoWritingOfTheDay) {
  ASSERT_TRUE(store_.know(std::vector<KnownCharacter>{{kRest, {}}, {kTree, {}}}));
  EXPECT_THAT(must(store_.study_days()), IsEmpty());
  EXPECT_THAT(must(store_.reviewed_on(store_.today())), IsEmpty());
  EXPECT_THAT(must(store_.introduced_on(store_.today())), IsEmpty());
  const Statistics statistics = must(statistics_of(store_));
  EXPECT_THAT(statistics.days, IsEmpty());
  EXPECT_EQ(statistics.streak.days, 0);
  EXPECT_EQ(statistics.reviews, 0);
  EXPECT_THAT(must(store_.writings_of(kRest)), IsEmpty());
  const auto plan = must(plan_day(store_, std::array{kRest, kTree, U'川'}));
  EXPECT_EQ(plan.new_done, 0) << "they take no place among the new characters of the day";
  EXPECT_EQ(plan.count(TaskKind::fresh), 1);
  EXPECT_EQ(plan.now.front().character, U'川');
}

TEST_F(Choices, AKnownCharacterThatIsWrittenIsAReviewAndNotNew) {
  ASSERT_TRUE(store_.know(std::vector<KnownCharacter>{{kRest, {}}}));
  clock_.advance(days(10));
  (void)must(store_.add_writing(kRest, 6, review(Rating::good)));
  const auto studied = must(store_.study_days());
  ASSERT_THAT(studied, SizeIs(1));
  EXPECT_EQ(studied.front().reviews, 1);
  EXPECT_THAT(must(store_.introduced_on(store_.today())), IsEmpty());
  EXPECT_EQ(must(plan_day(store_, {})).reviews_done, 1);
  EXPECT_EQ(must(store_.rebuild()).differences, 0);
  EXPECT_EQ(must(store_.study_days()), studied) << "also when the days are worked out again";
}

TEST_F(Choices, NewKanaTakeAMinuteUntilThePaceIsKnown) {
  EXPECT_EQ(must(plan_day(store_, std::array{U'あ', U'い'})).estimate, std::chrono::minutes(2));
  EXPECT_EQ(must(plan_day(store_, std::array{kRest, kTree})).estimate, std::chrono::minutes(6));
}

TEST_F(Choices, KnowingResumesAndEndsTheDifficulty) {
  ASSERT_TRUE(store_.pause(std::array{kRest}));
  Settings settings = store_.settings();
  settings.leech_lapses = 2;
  ASSERT_TRUE(store_.change_settings(settings));
  for (int i = 0; i < 3; ++i) {
    (void)must(store_.add_writing(kTree, 4, review(Rating::easy)));
    clock_.advance(days(30));
    (void)must(store_.add_writing(kTree, 4, review(Rating::again)));
    clock_.advance(days(30));
  }
  ASSERT_TRUE(store_.card(kTree).leech);
  ASSERT_TRUE(store_.know(std::vector<KnownCharacter>{{kRest, {}}, {kTree, {}}}));
  EXPECT_FALSE(store_.card(kRest).paused);
  EXPECT_FALSE(store_.card(kTree).leech);
  EXPECT_EQ(store_.card(kTree).memory.phase, Phase::review);
  ASSERT_TRUE(must(store_.undo()));
  EXPECT_TRUE(store_.card(kRest).paused);
  EXPECT_TRUE(store_.card(kTree).leech);
}

}  // namespace
}  // namespace nazori::study
