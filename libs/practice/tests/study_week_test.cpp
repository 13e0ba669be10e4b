// SPDX-License-Identifier: Apache-2.0
// A week of study and the weeks after it, on a clock that the test turns.
#include <gtest/gtest.h>

#include <map>

#include "nazori/study/backups.h"
#include "session_under_test.h"

namespace nazori::practice {
namespace {

using std::chrono::days;
using std::chrono::minutes;
using std::chrono::seconds;
using study::Rating;
using study::Stage;
using State = StudySession::State;

class StudyWeek : public SessionTest {
 protected:
  StudyWeek() {
    learn_from({U'一', U'二', U'十', U'人', U'八', U'入', U'丁'});
    auto settings = learner_->store().settings();
    settings.new_per_day = 1;
    EXPECT_TRUE(learner_->store().change_settings(settings));
  }

  /// Starts the program at 10:00 on a day.
  void start_program(study::Time morning) {
    clock_.set_calendar(morning);
    open();
    auto settings = learner_->store().settings();
    settings.new_per_day = new_per_day_;
    ASSERT_TRUE(learner_->store().change_settings(settings));
  }
  [[nodiscard]] int reviews_in_history() const {
    int count = 0;
    EXPECT_TRUE(learner_->store().for_each_entry(true, [&](const study::LearnerStore::LoggedEntry& logged) {
      const auto& entry = logged.entry;
      count += entry.kind == study::EntryKind::writing && entry.writing.stage == Stage::memory ? 1 : 0;
      return true;
    }));
    return count;
  }
  /// Completes the present stage in some seconds; in Memory correctly if `well`, with the proposed rating.
  void do_stage(bool well = true) {
    clock_.advance(seconds(20));
    if (session_->stage() != Stage::memory) {
      session_->finish_stage(session_->stage(), {});
      ASSERT_EQ(session_->state(), State::offered);
    } else {
      write(well);
      ASSERT_EQ(session_->state(), State::judged);
      ++rated_;
    }
    session_->go_on();
  }

  int new_per_day_ = 1;
  int rated_ = 0;
};

TEST_F(StudyWeek, LosesNothingThatWasRatedWhateverEndsItsDays) {
  std::map<char32_t, int> seen;
  const study::Time first = clock_.calendar();
  for (int day = 0; day < 7; ++day) {
    start_program(first + days(day));
    ASSERT_EQ(reviews_in_history(), rated_) << "day " << day;
    ASSERT_TRUE(session_->start()) << "day " << day;
    int steps = 0;
    while (session_->is_running() && ++steps < 60) {
      if (session_->stage() == Stage::memory) ++seen[session_->character()];
      // On the fourth day one is forgotten.
      do_stage(!(day == 3 && steps == 1));
      ASSERT_FALSE(HasFatalFailure()) << "day " << day << ", step " << steps;
      // On the third day the program ends in the middle.
      if (day == 2 && rated_ > 0 && steps == 2) break;
    }
    if (day != 2) {
      EXPECT_FALSE(session_->is_running());
      EXPECT_EQ(events_.back().kind, SessionFeedback::Kind::all_done);
    }
  }
  start_program(clock_.calendar());
  EXPECT_EQ(reviews_in_history(), rated_);
  EXPECT_EQ(seen.size(), 7U) << "one new a day";
  const auto studied = learner_->store().study_days();
  ASSERT_TRUE(studied);
  EXPECT_EQ(studied->size(), 7U);
  const auto rebuilt = learner_->store().rebuild();
  ASSERT_TRUE(rebuilt);
  EXPECT_EQ(rebuilt->differences, 0);

  // Six weeks later, for a learner of four reviews a day: half of them on the first day back.
  auto settings = learner_->store().settings();
  settings.reviews_per_day = 4;
  ASSERT_TRUE(learner_->store().change_settings(settings));
  new_per_day_ = 2;
  start_program(*study::parse_time("2026-04-20T10:00Z"));
  const auto plan = learner_->plan();
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->count(study::TaskKind::review), 2);
  EXPECT_EQ(plan->count(study::TaskKind::fresh), 0);
  ASSERT_TRUE(plan->gentle);
  EXPECT_EQ(plan->gentle->overdue, 7);
  EXPECT_EQ(plan->gentle->days, 3) << "two, three and then the last two";
  ASSERT_TRUE(session_->start());
  for (int review = 0; review < 2; ++review) {
    ASSERT_TRUE(session_->is_running());
    EXPECT_EQ(session_->task().kind, study::TaskKind::review);
    do_stage();
    ASSERT_FALSE(HasFatalFailure());
  }
  EXPECT_FALSE(session_->is_running());
  EXPECT_EQ(reviews_in_history(), rated_);

  // Every one of them can be undone, to the first.
  int undone = 0;
  while (reviews_in_history() > 0 && undone < 500) {
    session_->undo();
    EXPECT_EQ(events_.back().kind, SessionFeedback::Kind::undone);
    ++undone;
  }
  EXPECT_GE(undone, rated_);
}

TEST_F(StudyWeek, OfAProgramThatRunsThroughHasABackupOfEachDayAndCountsItsTime) {
  std::chrono::milliseconds time{0};
  for (int day = 0; day < 5; ++day) {
    learner_->tick();
    wait_for_upkeep();
    ASSERT_TRUE(session_->start()) << "day " << day;
    int steps = 0;
    while (session_->is_running() && ++steps < 60) {
      do_stage();
      ASSERT_FALSE(HasFatalFailure());
    }
    const auto& store = learner_->store();
    EXPECT_EQ(*store.time_on(store.today()), seconds(20) * steps);
    EXPECT_EQ(store.introduced_on(store.today())->size(), 1U);
    time += seconds(20) * steps;
    clock_.advance(days(1));
  }
  EXPECT_EQ(study::backups_of(learner_->file()).size(), 5U);
  std::chrono::milliseconds saved{0};
  EXPECT_TRUE(learner_->store().for_each_entry(true, [&](const study::LearnerStore::LoggedEntry& logged) {
    saved += logged.entry.writing.result.duration;
    return true;
  }));
  EXPECT_EQ(saved, time);
}

}  // namespace
}  // namespace nazori::practice
