// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/day_outlook.h"

#include <gtest/gtest.h>

#include "session_under_test.h"

namespace nazori::practice {
namespace {

using std::chrono::days;
using study::Rating;
using Kind = DayOutlook::Kind;

class Outlook : public SessionTest {
 protected:
  Outlook() {
    learn_from({U'一', U'二'});
    new_a_day(0);
  }
  void new_a_day(int count) {
    auto settings = learner_->store().settings();
    settings.new_per_day = count;
    ASSERT_TRUE(learner_->store().change_settings(settings));
  }
  void review(char32_t character, Rating rating) {
    study::Writing writing;
    writing.rating = rating;
    ASSERT_TRUE(learner_->store().add_writing(character, 1, writing));
  }
  [[nodiscard]] DayOutlook outlook() { return outlook_of(learner_->store(), *learner_->plan()); }
  /// Advances the clock to the day before this character is due.
  void pass_until_eve_of(char32_t character) {
    const auto& store = learner_->store();
    clock_.advance(*store.card(character).due_day - store.today() - days(1));
  }
};

TEST_F(Outlook, SaysWhatComesNext) {
  EXPECT_EQ(outlook().kind, Kind::nothing_to_learn);
  review(U'一', Rating::easy);
  EXPECT_EQ(outlook().kind, Kind::nothing_tomorrow);
  new_a_day(1);
  EXPECT_EQ(outlook().kind, Kind::new_tomorrow) << "today's is done";
  new_a_day(0);
  pass_until_eve_of(U'一');
  EXPECT_EQ(outlook(), (DayOutlook{Kind::reviews_tomorrow, 1, {}}));
  ASSERT_TRUE(learner_->store().pause(std::vector<char32_t>{U'一'}));
  EXPECT_EQ(outlook().kind, Kind::nothing_tomorrow) << "what is paused does not come";
}

TEST_F(Outlook, WhatIsPostponedComesOnItsDay) {
  review(U'一', Rating::easy);
  pass_until_eve_of(U'一');
  const std::vector<char32_t> one{U'一'};
  const auto today = learner_->store().today();
  ASSERT_TRUE(learner_->store().postpone(one, today + days(2)));
  EXPECT_EQ(outlook().kind, Kind::nothing_tomorrow);
  clock_.advance(days(1));
  EXPECT_EQ(outlook(), (DayOutlook{Kind::reviews_tomorrow, 1, {}}));
}

TEST_F(Outlook, APostponedCharacterThatIsStillNewIsNoReviewOfTomorrow) {
  study::Writing watched;
  watched.stage = study::Stage::watch;
  ASSERT_TRUE(learner_->store().add_writing(U'一', 1, watched));
  ASSERT_TRUE(learner_->store().postpone(std::vector<char32_t>{U'一'}, learner_->store().today() + days(1)));
  EXPECT_EQ(outlook().kind, Kind::nothing_tomorrow);
}

TEST_F(Outlook, StepsOfTodayComeBeforeTheLimitThatIsReached) {
  study::DayPlan plan;
  plan.day = learner_->store().today();
  plan.held_back = 3;
  EXPECT_EQ(outlook_of(learner_->store(), plan), (DayOutlook{Kind::limit_reached, 3, {}}));
  study::StudyTask later;
  later.due = clock_.calendar();
  plan.later_today = {later, later};
  EXPECT_EQ(outlook_of(learner_->store(), plan), (DayOutlook{Kind::later_today, 2, clock_.calendar()}));
}

TEST_F(Outlook, TheDayIsGreetedByTheLearnersClock) {
  const auto at = [this](const char* zone, const char* now) {
    clock_.set_calendar(*study::parse_time(now));
    auto settings = learner_->store().settings();
    settings.time_zone = zone;
    EXPECT_TRUE(learner_->store().change_settings(settings));
    return part_of_day(learner_->store());
  };
  EXPECT_EQ(at("UTC", "2026-03-02T04:00Z"), PartOfDay::morning);
  EXPECT_EQ(at("UTC", "2026-03-02T11:59Z"), PartOfDay::morning);
  EXPECT_EQ(at("UTC", "2026-03-02T12:00Z"), PartOfDay::afternoon);
  EXPECT_EQ(at("UTC", "2026-03-02T17:59Z"), PartOfDay::afternoon);
  EXPECT_EQ(at("UTC", "2026-03-02T18:00Z"), PartOfDay::evening);
  EXPECT_EQ(at("UTC", "2026-03-03T03:59Z"), PartOfDay::evening) << "the study day is not over";
  EXPECT_EQ(at("Asia/Tokyo", "2026-03-02T03:00Z"), PartOfDay::afternoon) << "noon in Tokyo";
}

TEST_F(Outlook, DaysInARowAreCountedUpToToday) {
  EXPECT_EQ(streak_now(learner_->store()).days, 0);
  for (int day = 1; day <= 3; ++day) {
    review(U'一', Rating::good);
    EXPECT_EQ(streak_now(learner_->store()).days, day);
    clock_.advance(days(1));
  }
  EXPECT_EQ(streak_now(learner_->store()).days, 3) << "today is not over";
}

}  // namespace
}  // namespace nazori::practice
