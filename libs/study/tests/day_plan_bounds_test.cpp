// SPDX-License-Identifier: Apache-2.0
// Days, limits and orders of the day's plan, on both sides of each bound.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "learner_fixture.h"
#include "nazori/study/day_plan.h"
#include "nazori/study/pace.h"

namespace nazori::study {
namespace {

using std::chrono::days;
using std::chrono::milliseconds;
using std::chrono::minutes;
using std::chrono::seconds;
using test::MovedClock;
using test::must;
using test::review;
using test::use_zone;
using testing::ElementsAre;
using testing::IsEmpty;

const std::vector<char32_t> kOrder{U'一', U'二', U'三', U'四', U'五', U'六', U'七', U'八', U'九', U'十'};

struct Learner {
  MovedClock clock{"2026-01-01T09:00:00Z"};
  LearnerStore store = must(LearnerStore::in_memory(clock.clock()));
  explicit Learner(int new_per_day = 0, int reviews_per_day = 100) {
    use_zone(store, "UTC");
    settings([=](Settings& s) {
      s.new_per_day = new_per_day;
      s.reviews_per_day = reviews_per_day;
    });
  }
  template <class Change>
  void settings(Change change) {
    Settings settings = store.settings();
    change(settings);
    EXPECT_TRUE(store.change_settings(settings));
  }
  void write(char32_t c, Rating rating) { (void)must(store.add_writing(c, 4, review(rating))); }
  /// Learns `count` characters from 亜 on; each is due in eight days.
  void learn(int count) {
    for (int i = 0; i < count; ++i) write(U'亜' + static_cast<char32_t>(i), Rating::easy);
  }
  [[nodiscard]] DayPlan plan() const { return must(plan_day(store, kOrder)); }
};

std::u32string characters(const std::vector<StudyTask>& tasks) {
  std::u32string all;
  for (const StudyTask& task : tasks) all += task.character;
  return all;
}

TEST(DayPlanReturn, SevenDaysWithoutAReviewHalveTheLimitSixDoNot) {
  for (const int away : {6, 7, 8}) {
    Learner learner(0, 9);
    learner.learn(20);
    learner.clock.advance(days(5));
    learner.write(U'龍', Rating::easy);
    learner.clock.advance(days(away));
    // Half of nine is five: what is begun counts.
    EXPECT_EQ(learner.plan().count(TaskKind::review), away < 7 ? 9 : 5) << away;
  }
}

TEST(DayPlanReturn, TheThreeDaysBackAreThoseWithAReview) {
  Learner learner(0, 100);
  learner.learn(500);
  learner.clock.advance(days(30));
  for (const int limit : {50, 75, 90, 100, 100}) {
    EXPECT_EQ(learner.plan().count(TaskKind::review), limit);
    EXPECT_EQ(learner.plan().gentle->per_day, limit);
    // After one review, the rest of the day still counts as the same day of the return.
    learner.write(learner.plan().now.front().character, Rating::easy);
    EXPECT_EQ(learner.plan().count(TaskKind::review), limit - 1);
    EXPECT_EQ(learner.plan().reviews_done, 1);
    learner.clock.advance(days(2));
  }
}

TEST(DayPlanReturn, OnlyTheLastAbsenceCounts) {
  Learner learner(0, 10);
  learner.learn(100);
  learner.clock.advance(days(10));
  learner.write(U'龍', Rating::easy);
  learner.clock.advance(days(7));
  EXPECT_EQ(learner.plan().count(TaskKind::review), 5) << "a return again";
  // Without any earlier review it is not a return.
  Learner first(20, 10);
  EXPECT_EQ(first.plan().count(TaskKind::fresh), 10);
}

TEST(DayPlanGentle, IsMadeOnlyForWhatIsOverdue) {
  Learner learner(0, 3);
  learner.learn(5);
  learner.clock.advance(days(5));
  learner.write(U'龍', Rating::easy);
  learner.clock.advance(days(3));
  // Due today and no earlier: more than the limit, but not a backlog.
  ASSERT_EQ(learner.store.today(), *learner.store.card(U'亜').due_day);
  DayPlan plan = learner.plan();
  EXPECT_EQ(plan.held_back, 2);
  EXPECT_FALSE(plan.gentle);
  learner.clock.advance(days(1));
  plan = learner.plan();
  ASSERT_TRUE(plan.gentle);
  EXPECT_EQ(*plan.gentle, (GentlePlan{5, 3, 2, learner.store.today() + days(1)}));
  // If the limit allows all of it, no plan is needed.
  learner.settings([](Settings& s) { s.reviews_per_day = 5; });
  EXPECT_FALSE(learner.plan().gentle);
  EXPECT_EQ(learner.plan().held_back, 0);
}

/// Length in days of the gentle plan of a learner with a limit of ten reviews a day: 5 today, 8 tomorrow, 9
/// on the third day, then 10.
/// @param overdue, tomorrow  reviews overdue, and due tomorrow.
int planned_days(int overdue, int tomorrow, void (*change)(Learner&) = nullptr) {
  Learner learner(0, 10);
  learner.learn(overdue);
  learner.clock.advance(days(2));
  for (int i = 0; i < tomorrow; ++i) learner.write(U'一' + static_cast<char32_t>(i), Rating::easy);
  learner.clock.advance(days(7));
  if (change != nullptr) change(learner);
  const DayPlan plan = learner.plan();
  EXPECT_EQ(plan.gentle->overdue, overdue);
  EXPECT_EQ(plan.gentle->per_day, 5);
  EXPECT_EQ(plan.gentle->last_day, learner.store.today() + days(plan.gentle->days - 1));
  return plan.gentle->days;
}

TEST(DayPlanGentle, WhatFallsDueMeanwhileLengthensIt) {
  EXPECT_EQ(planned_days(13, 0), 2);
  EXPECT_EQ(planned_days(14, 0), 3);
  EXPECT_EQ(planned_days(13, 1), 3);
  EXPECT_EQ(planned_days(13, 9), 3);
  EXPECT_EQ(planned_days(13, 10), 4);
  EXPECT_EQ(planned_days(13, 20), 5) << "9 on the third day, 10 on the fourth, 1";
}

TEST(DayPlanGentle, PausedCharactersAndLeechesAreNoWork) {
  EXPECT_EQ(planned_days(13, 1, [](Learner& one) { EXPECT_TRUE(one.store.pause(std::array{U'一'})); }), 2);
  const auto with_a_leech = [](Learner& one) {
    one.settings([](Settings& s) {
      s.leech_lapses = 2;
      s.fsrs.relearning_steps.clear();
    });
    one.write(U'龍', Rating::easy);
    one.write(U'龍', Rating::again);
    one.write(U'龍', Rating::again);
    EXPECT_TRUE(one.store.card(U'龍').leech);
    EXPECT_EQ(one.store.card(U'龍').due_day, one.store.today() + days(1));
  };
  EXPECT_EQ(planned_days(13, 0, with_a_leech), 2);
}

TEST(DayPlanSteps, ThatAreNearlyDueComeUpToTwentyMinutesEarly) {
  for (const bool near : {true, false}) {
    Learner learner;
    learner.settings([](Settings& s) { s.fsrs.learning_steps = {minutes(21)}; });
    learner.write(U'一', Rating::again);
    learner.clock.advance(near ? minutes(1) : minutes(1) - milliseconds(1));
    const DayPlan plan = learner.plan();
    EXPECT_EQ(characters(plan.now), near ? U"一" : U"");
    EXPECT_EQ(characters(plan.later_today), near ? U"" : U"一");
  }
}

TEST(DayPlanSteps, AreDueFromTheirMinuteToTheEndOfTheDay) {
  Learner learner;
  learner.settings([](Settings& s) { s.fsrs.learning_steps = {minutes(30)}; });
  learner.write(U'一', Rating::again);
  learner.clock.advance(minutes(30) - milliseconds(1));
  learner.write(U'二', Rating::again);
  EXPECT_EQ(characters(learner.plan().now), U"一") << "early, with nothing else to do";
  EXPECT_EQ(characters(learner.plan().later_today), U"二");
  learner.clock.advance(milliseconds(1));
  EXPECT_EQ(characters(learner.plan().now), U"一");
  EXPECT_EQ(learner.plan().now[0].due, learner.clock.now());
  // The study day ends at four in the morning.
  Learner night;
  night.settings([](Settings& s) { s.fsrs.learning_steps = {minutes(30)}; });
  night.clock.set("2026-01-02T03:30:00Z");
  night.write(U'一', Rating::again);
  EXPECT_THAT(night.plan().later_today, IsEmpty()) << "due at four, on another day";
  night.clock.set("2026-01-02T03:29:59Z");
  night.write(U'二', Rating::again);
  EXPECT_EQ(characters(night.plan().later_today), U"二");
}

TEST(DayPlanOrder, StepsComeByTheirMinuteThenByCharacter) {
  Learner learner;
  learner.write(U'三', Rating::again);
  learner.write(U'二', Rating::again);
  learner.clock.advance(seconds(-1));
  learner.write(U'四', Rating::again);
  learner.clock.advance(minutes(5));
  // Of code points 三 (4E09), 二 (4E8C), 四 (56DB).
  EXPECT_EQ(characters(learner.plan().now), U"四三二");
}

TEST(DayPlanOrder, ReviewsComeBestKnownFirstThenLongestDueThenByCharacter) {
  Learner learner;
  learner.learn(2);
  learner.write(U'九', Rating::easy);
  learner.clock.advance(days(1));
  learner.write(U'一', Rating::easy);
  learner.clock.advance(days(9));
  const DayPlan plan = learner.plan();
  // 一 was reviewed a day later, so it is the best known; 九 (4E5D) comes before 亜 (4E9C).
  EXPECT_EQ(characters(plan.now), (std::u32string{U'一', U'九', U'亜', U'亝'}));
  EXPECT_EQ(plan.now[0].due, learner.store.calendar().begin_of(*parse_day("2026-01-10")));
  EXPECT_EQ(plan.now[1].due, learner.store.calendar().begin_of(*parse_day("2026-01-09")));
  EXPECT_EQ(plan.now[0].retrievability, Fsrs().retrievability(8.2956, 9));
  EXPECT_EQ(plan.now[1].retrievability, Fsrs().retrievability(8.2956, 10));
  EXPECT_EQ(plan.now[0].stage, Stage::memory);
}

TEST(DayPlanOrder, WhatWasBegunComesAfterReviewsAndBeforeNewOnes) {
  Learner learner(2);
  learner.learn(1);
  learner.clock.advance(days(7));
  Writing watched = review(Rating::good);
  watched.stage = Stage::watch;
  (void)must(learner.store.add_writing(U'五', 4, watched));
  learner.clock.advance(days(1));
  const DayPlan plan = learner.plan();
  EXPECT_EQ(characters(plan.now), U"亜五一二");
  EXPECT_EQ(plan.now[1], (StudyTask{TaskKind::fresh, U'五', Stage::trace,
                                    learner.store.calendar().begin_of(*parse_day("2026-01-08")), 0}));
  EXPECT_EQ(plan.now[2], (StudyTask{TaskKind::fresh, U'一', Stage::watch,
                                    learner.store.calendar().begin_of(*parse_day("2026-01-09")), 0}));
  EXPECT_EQ(plan.count(TaskKind::fresh), 3);
  EXPECT_EQ(plan.count(TaskKind::review), 1);
  EXPECT_EQ(plan.day, *parse_day("2026-01-09"));
}

TEST(DayPlanNew, PausedPostponedAndKnownCharactersArePassedOver) {
  Learner learner(3);
  const Day today = learner.store.today();
  ASSERT_TRUE(learner.store.pause(std::array{U'一', U'六'}));
  ASSERT_TRUE(learner.store.resume(std::array{U'六'}));
  ASSERT_TRUE(learner.store.postpone(std::array{U'二'}, today + days(1)));
  ASSERT_TRUE(learner.store.postpone(std::array{U'三'}, today));
  learner.write(U'四', Rating::easy);
  EXPECT_EQ(characters(learner.plan().now), U"三五");
  EXPECT_EQ(learner.plan().new_done, 1);
  learner.clock.advance(days(1));
  EXPECT_EQ(characters(learner.plan().now), U"二三五");
  ASSERT_TRUE(learner.store.reset(std::array{U'四'}));
  EXPECT_EQ(characters(learner.plan().now), U"二三四") << "it is new again";
  // More than the day's number have already been introduced.
  learner.settings([](Settings& s) { s.new_per_day = 1; });
  for (const char32_t c : {U'七', U'八'}) learner.write(c, Rating::easy);
  EXPECT_EQ(learner.plan().count(TaskKind::fresh), 0);
}

TEST(DayPlanNew, NothingNewComesWhileReviewsAreHeldBack) {
  Learner learner(3, 2);
  learner.learn(3);
  learner.clock.advance(days(2));
  learner.write(U'龍', Rating::easy);
  learner.clock.advance(days(6));
  ASSERT_EQ(learner.plan().held_back, 1);
  EXPECT_EQ(learner.plan().count(TaskKind::fresh), 0);
  learner.settings([](Settings& s) { s.reviews_per_day = 3; });
  EXPECT_EQ(learner.plan().held_back, 0);
  EXPECT_EQ(learner.plan().count(TaskKind::fresh), 3);
}

TEST(DayPlanLimit, MoreDoneThanAskedLeavesNoRoom) {
  Learner learner(0, 5);
  learner.learn(9);
  learner.clock.advance(days(2));
  learner.write(U'龍', Rating::easy);
  learner.clock.advance(days(6));
  learner.settings([](Settings& s) { s.reviews_per_day = 1; });
  for (char32_t c = U'亜'; c < U'亜' + 4; ++c) learner.write(c, Rating::easy);
  const DayPlan plan = learner.plan();
  EXPECT_EQ(plan.reviews_done, 4);
  EXPECT_EQ(plan.held_back, 5);
  EXPECT_EQ(plan.count(TaskKind::review), 0);
}

TEST(DayPlanLimit, WhatIsMetTodayIsNoReviewDone) {
  Learner learner(5, 5);
  learner.write(U'一', Rating::good);
  learner.write(U'一', Rating::good);
  EXPECT_EQ(learner.plan().reviews_done, 0);
  EXPECT_EQ(learner.plan().new_done, 1);
  // Practice is none either.
  learner.clock.advance(days(1));
  Writing trace = review(Rating::good);
  trace.stage = Stage::trace;
  (void)must(learner.store.add_writing(U'一', 4, trace));
  EXPECT_EQ(learner.plan().reviews_done, 0);
  EXPECT_EQ(learner.plan().new_done, 0);
  learner.write(U'一', Rating::easy);
  learner.write(U'一', Rating::easy);
  EXPECT_EQ(learner.plan().reviews_done, 1) << "a character, however often";
}

TEST(DayPlanLimit, LeechesAreNamedAndPausedOnesAreNot) {
  Learner learner(0, 100);
  learner.settings([](Settings& s) { s.leech_lapses = 2; });
  for (int lapse = 0; lapse < 2; ++lapse) {
    for (const char32_t c : {U'二', U'一', U'三'}) learner.write(c, Rating::easy);
    learner.clock.advance(days(30));
    for (const char32_t c : {U'二', U'一', U'三'}) learner.write(c, Rating::again);
    learner.clock.advance(days(1));
  }
  ASSERT_TRUE(learner.store.pause(std::array{U'三'}));
  EXPECT_THAT(learner.plan().leeches, ElementsAre(U'一', U'二'));
  EXPECT_THAT(learner.plan().now, IsEmpty());
}

TEST(DayPlanEstimate, AReviewTakesLongerTheLessItIsKnown) {
  Learner learner;
  learner.learn(1);
  learner.clock.advance(days(20));
  const double chance = Fsrs().retrievability(8.2956, 20);
  const Pace pace;
  EXPECT_EQ(learner.plan().estimate,
            pace.recalled + std::chrono::round<milliseconds>((1 - chance) * milliseconds(40'000)));
  // With something new.
  learner.settings([](Settings& s) { s.new_per_day = 1; });
  const milliseconds before = learner.plan().estimate;
  EXPECT_EQ(before, std::chrono::round<milliseconds>((1 - chance) * milliseconds(40'000)) + pace.recalled +
                        pace.introduced);
}

TEST(DayPlan, BeginsEmpty) {
  const DayPlan plan;
  EXPECT_EQ(plan.reviews_done, 0);
  EXPECT_EQ(plan.new_done, 0);
  EXPECT_EQ(plan.held_back, 0);
  EXPECT_EQ(plan.estimate, milliseconds(0));
  EXPECT_EQ(StudyTask(), (StudyTask{TaskKind::review, 0, Stage::memory, Time(), 0}));
  EXPECT_EQ(GentlePlan(), (GentlePlan{0, 0, 0, Day()}));
}

TEST(RetrievabilityNow, IsNothingBeforeTheFirstReviewAndWholeOnItsDay) {
  const Fsrs fsrs;
  const Day today = *parse_day("2026-01-10");
  Card card;
  card.memory.stability = 8;
  EXPECT_EQ(retrievability_now(card, fsrs, today), 0);
  card.last_day = today - days(8);
  EXPECT_NEAR(retrievability_now(card, fsrs, today), 0.9, 1e-7);
  card.last_day = today;
  EXPECT_EQ(retrievability_now(card, fsrs, today), 1);
  card.last_day = today + days(3);
  EXPECT_EQ(retrievability_now(card, fsrs, today), 1) << "the clock was put back";
}

}  // namespace
}  // namespace nazori::study
