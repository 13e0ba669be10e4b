// SPDX-License-Identifier: Apache-2.0
// Reviews with the brush: apart from those from memory in every respect.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "learner_fixture.h"
#include "nazori/study/day_plan.h"
#include "nazori/study/exchange.h"
#include "nazori/study/statistics.h"

namespace nazori::study {
namespace {

using std::chrono::days;
using std::chrono::seconds;
using test::MovedClock;
using test::must;
using test::review;
using test::some_ink;
using test::TemporaryFolder;
using test::use_zone;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr char32_t kWritten = U'休';

Writing with_brush(Rating rating) {
  Writing writing = review(rating);
  writing.stage = Stage::brush;
  writing.result.duration = seconds(50);
  return writing;
}

struct BrushLearner {
  MovedClock clock{"2026-01-01T09:00:00Z"};
  LearnerStore store = must(LearnerStore::in_memory(clock.clock()));
  BrushLearner() { use_zone(store, "UTC"); }

  void allow(int per_day) {
    Settings settings = store.settings();
    settings.brush_per_day = per_day;
    ASSERT_TRUE(store.change_settings(settings));
  }
  Card brush(char32_t character, Rating rating = Rating::good) {
    return must(store.add_writing(character, 6, with_brush(rating), some_ink()));
  }
  /// Makes it well known from memory: reviewed for the first time today, again after `wait` days with Easy.
  void know_well(char32_t character) {
    (void)must(store.add_writing(character, 6, review(Rating::easy)));
    for (int i = 0; store.card(character).memory.stability < 21; ++i) {
      clock.advance(days(8));
      (void)must(store.add_writing(character, 6, review(Rating::easy)));
      ASSERT_LT(i, 10);
    }
    ASSERT_EQ(strength_of(store.card(character)), Strength::mature);
  }
  [[nodiscard]] DayPlan plan() const { return must(plan_day(store, {})); }
};

TEST(BrushReviews, ComeBackAfterTheFirstIntervalsOfFsrsWithoutSteps) {
  // The stabilities of FSRS-6 after the first review are its first four weights; at 90 % they are the
  // intervals, and each rating comes at least a day after the one below it.
  const std::array<std::pair<Rating, int>, 4> first{
      {{Rating::again, 1}, {Rating::hard, 2}, {Rating::good, 3}, {Rating::easy, 8}}};
  char32_t character = U'一';
  for (const auto& [rating, wait] : first) {
    BrushLearner learner;
    const BrushReviews brush = learner.brush(character, rating).brush;
    EXPECT_EQ(brush.memory.phase, Phase::review);
    EXPECT_DOUBLE_EQ(brush.memory.stability, kDefaultWeights[static_cast<std::size_t>(rating) - 1]);
    EXPECT_EQ(brush.due_day, learner.store.today() + days(wait));
    EXPECT_EQ(brush.last_day, learner.store.today());
    EXPECT_EQ(brush.memory.reps, 1);
    EXPECT_EQ(review_delay(brush, learner.store.today()), (ReviewDelay{ReviewDelay::Unit::days, 1.0 * wait}));
    ++character;
  }
}

TEST(BrushReviews, ElapsedDaysCountFromTheLastOneWithTheBrush) {
  BrushLearner learner;
  const double first = learner.brush(kWritten).brush.memory.stability;
  learner.clock.advance(days(3));
  // A review from memory in between is none with the brush.
  (void)must(learner.store.add_writing(kWritten, 6, review(Rating::good)));
  learner.clock.advance(days(3));
  Fsrs without_steps = must(Fsrs::create([] {
    FsrsSettings settings;
    settings.short_term_steps = false;
    return settings;
  }()));
  Memory expected = without_steps.next({}, Rating::good, learner.clock.now() - days(6), 0);
  expected = without_steps.next(expected, Rating::good, learner.clock.now(), 6);
  const BrushReviews after = learner.brush(kWritten).brush;
  EXPECT_GT(after.memory.stability, first);
  EXPECT_EQ(after.memory, expected);
  EXPECT_EQ(after.due_day, learner.store.today() + days(expected.scheduled_days));
}

TEST(BrushReviews, ChangeNothingAboutTheLessonAndTheReviewsFromMemory) {
  BrushLearner learner;
  (void)must(learner.store.add_writing(kWritten, 6, review(Rating::good)));
  Card before = learner.store.card(kWritten);
  learner.clock.advance(days(1));
  Card after = learner.brush(kWritten, Rating::again);
  EXPECT_NE(after.brush, before.brush);
  after.brush = before.brush;
  EXPECT_EQ(after, before);
  // The other way round, too.
  const BrushReviews brush = learner.store.card(kWritten).brush;
  learner.clock.advance(days(2));
  (void)must(learner.store.add_writing(kWritten, 6, review(Rating::again)));
  EXPECT_EQ(learner.store.card(kWritten).brush, brush);
}

TEST(BrushReviews, IntroduceNoCharacter) {
  BrushLearner learner;
  EXPECT_FALSE(learner.brush(kWritten).introduced);
  EXPECT_THAT(must(learner.store.introduced_on(learner.store.today())), IsEmpty());
  const Statistics statistics = must(statistics_of(learner.store));
  ASSERT_EQ(statistics.days.size(), 1U);
  EXPECT_EQ(statistics.days[0].introduced, 0);
  EXPECT_EQ(statistics.days[0].practices, 1);
  EXPECT_EQ(statistics.days[0].reviews, 0);
  EXPECT_EQ(statistics.days[0].time, seconds(50));
  EXPECT_THAT(statistics.motion, IsEmpty()) << "the brush moves in another way than the stylus";
  EXPECT_EQ(must(learner.store.study_days()).size(), 1U) << "it was a day of study nevertheless";
  // The first writing with the stylus does.
  Writing watched;
  watched.stage = Stage::watch;
  watched.result.duration = seconds(5);
  EXPECT_TRUE(must(learner.store.add_writing(kWritten, 6, watched)).introduced);
  EXPECT_THAT(must(learner.store.introduced_on(learner.store.today())), ElementsAre(kWritten));
}

TEST(BrushReviews, AreNotInThePaceOfTheDaysReviews) {
  BrushLearner learner;
  Writing from_memory = review(Rating::good);
  from_memory.result.duration = seconds(20);
  (void)must(learner.store.add_writing(kWritten, 6, from_memory));
  (void)learner.brush(kWritten);
  EXPECT_EQ(must(learner.store.time_on(learner.store.today())), seconds(20));
  const auto studied = must(learner.store.study_days());
  ASSERT_EQ(studied.size(), 1U);
  EXPECT_EQ(studied[0].writings, 2);
  EXPECT_EQ(studied[0].reviews, 1);
  EXPECT_THAT(must(learner.store.writings_of(kWritten)), testing::SizeIs(2));
}

TEST(BrushReviews, AreUndoneAndPreviewedLikeOthers) {
  BrushLearner learner;
  (void)must(learner.store.add_writing(kWritten, 6, review(Rating::good)));
  const Card before = learner.store.card(kWritten);
  const Card foretold = must(learner.store.preview(kWritten, Rating::hard, Stage::brush));
  EXPECT_EQ(learner.store.card(kWritten), before) << "a preview changes nothing";
  const Card after = learner.brush(kWritten, Rating::hard);
  EXPECT_EQ(after.brush, foretold.brush);
  const auto undone = must(learner.store.undo());
  ASSERT_TRUE(undone);
  EXPECT_EQ(undone->kind, EntryKind::writing);
  EXPECT_THAT(undone->characters, ElementsAre(kWritten));
  EXPECT_EQ(learner.store.card(kWritten), before);
}

TEST(BrushReviews, AreThereAgainWhenTheFileIsOpenedAndFollowFromTheLog) {
  const TemporaryFolder folder;
  const MovedClock clock("2026-01-01T09:00:00Z");
  Cards cards;
  {
    LearnerStore store = must(LearnerStore::open(folder / "learner.db", Access::write, clock.clock()));
    (void)must(store.add_writing(kWritten, 6, review(Rating::good)));
    (void)must(store.add_writing(kWritten, 6, with_brush(Rating::easy), some_ink()));
    (void)must(store.add_writing(U'木', 4, with_brush(Rating::good)));
    (void)must(store.undo());
    cards = store.cards();
    ASSERT_EQ(cards.size(), 1U);
    EXPECT_EQ(must(store.ink_of(2)), must(unpack_handwriting(must(pack(some_ink())))));
  }
  {
    LearnerStore again = must(LearnerStore::open(folder / "learner.db", Access::write, clock.clock()));
    EXPECT_EQ(again.cards(), cards);
    const auto report = must(again.rebuild());
    EXPECT_EQ(report.differences, 0);
    EXPECT_EQ(again.cards(), cards);
    ASSERT_TRUE(again.reset(std::array{kWritten}));
    EXPECT_EQ(again.card(kWritten).brush, BrushReviews());
  }
  const LearnerStore last = must(LearnerStore::open(folder / "learner.db", Access::read, clock.clock()));
  EXPECT_EQ(last.card(kWritten).brush, BrushReviews()) << "starting over leaves no row behind";
}

TEST(BrushReviews, FollowOtherWeights) {
  BrushLearner learner;
  (void)learner.brush(kWritten, Rating::good);
  const std::optional<Day> due = learner.store.card(kWritten).brush.due_day;
  Settings settings = learner.store.settings();
  settings.fsrs.weights[2] = 7.5;
  ASSERT_TRUE(learner.store.change_settings(settings));
  const Card card = learner.store.card(kWritten);
  EXPECT_DOUBLE_EQ(card.brush.memory.stability, 7.5);
  EXPECT_EQ(card.brush.due_day, due) << "days that are set stay";
  // What was before a new beginning does not count any more.
  ASSERT_TRUE(learner.store.reset(std::array{kWritten}));
  (void)learner.brush(kWritten, Rating::easy);
  settings.fsrs.weights[3] = 9.5;
  ASSERT_TRUE(learner.store.change_settings(settings));
  EXPECT_DOUBLE_EQ(learner.store.card(kWritten).brush.memory.stability, 9.5);
  EXPECT_EQ(card.memory, Memory());
}

TEST(BrushReviews, AreInEveryExport) {
  BrushLearner learner;
  (void)must(learner.store.add_writing(kWritten, 6, review(Rating::good)));
  (void)learner.brush(kWritten, Rating::hard);
  const std::string json = must(export_json(learner.store));
  EXPECT_THAT(json, HasSubstr("\"stage\":\"brush\""));
  EXPECT_THAT(must(export_csv(learner.store)), HasSubstr("\"休\",brush,hard,"));
  LearnerStore copy = must(LearnerStore::in_memory(learner.clock.clock()));
  ASSERT_TRUE(import_json(copy, text_source(json)));
  EXPECT_EQ(copy.cards(), learner.store.cards());
  EXPECT_EQ(must(export_json(copy)), json);
}

TEST(BrushReviews, ComeOnlyForWhatIsWellKnownAndOnlyIfTheLearnerWantsThem) {
  BrushLearner learner;
  learner.know_well(kWritten);
  (void)must(learner.store.add_writing(U'木', 4, review(Rating::good)));
  EXPECT_THAT(learner.plan().brush, IsEmpty()) << "off by default";
  learner.allow(3);
  EXPECT_THAT(learner.plan().brush, ElementsAre(kWritten));
  for (const StudyTask& task : learner.plan().now) EXPECT_NE(task.stage, Stage::brush);
  ASSERT_TRUE(learner.store.pause(std::array{kWritten}));
  EXPECT_THAT(learner.plan().brush, IsEmpty());
  ASSERT_TRUE(learner.store.resume(std::array{kWritten}));
  ASSERT_TRUE(learner.store.postpone(std::array{kWritten}, learner.store.today() + days(1)));
  EXPECT_THAT(learner.plan().brush, IsEmpty());
  learner.clock.advance(days(1));
  EXPECT_THAT(learner.plan().brush, ElementsAre(kWritten));
  // The model would answer the question of the review from memory.
  learner.clock.advance(days(4000));
  ASSERT_LE(*learner.store.card(kWritten).due_day, learner.store.today());
  EXPECT_THAT(learner.plan().brush, IsEmpty());
}

TEST(BrushReviews, ComeBackOnTheirDayTheEarliestFirstAndBeforeThoseNeverWrittenWithIt) {
  BrushLearner learner;
  for (const char32_t one : {U'一', U'二', U'三', U'四'}) learner.know_well(one);
  learner.clock.advance(days(3));
  (void)must(learner.store.add_writing(U'四', 5, review(Rating::easy)));
  learner.allow(10);
  // Good: three days; Again: one day.
  (void)learner.brush(U'一', Rating::good);
  (void)learner.brush(U'二', Rating::again);
  EXPECT_EQ(learner.plan().brush_done, 2);
  EXPECT_THAT(learner.plan().brush, ElementsAre(U'四', U'三')) << "not twice a day; the best known first";
  learner.clock.advance(days(1));
  EXPECT_EQ(learner.plan().brush_done, 0);
  EXPECT_THAT(learner.plan().brush, ElementsAre(U'二', U'四', U'三'));
  learner.clock.advance(days(2));
  EXPECT_THAT(learner.plan().brush, ElementsAre(U'二', U'一', U'四', U'三'));
}

TEST(BrushReviews, AreNoMoreADayThanWasChosen) {
  BrushLearner learner;
  for (const char32_t one : {U'一', U'二', U'三', U'四'}) learner.know_well(one);
  learner.allow(3);
  EXPECT_EQ(learner.plan().brush.size(), 3U);
  (void)learner.brush(learner.plan().brush.front());
  EXPECT_EQ(learner.plan().brush.size(), 2U);
  learner.allow(1);
  EXPECT_THAT(learner.plan().brush, IsEmpty());
}

TEST(BrushReviews, TheirNumberADayIsASettingFrom0To100) {
  Settings settings;
  EXPECT_EQ(settings.brush_per_day, 0);
  settings.brush_per_day = 100;
  EXPECT_TRUE(check(settings));
  EXPECT_EQ(must(parse_settings(to_json(settings))).brush_per_day, 100);
  settings.brush_per_day = 101;
  EXPECT_FALSE(check(settings));
  settings.brush_per_day = -1;
  EXPECT_FALSE(check(settings));
}

}  // namespace
}  // namespace nazori::study
