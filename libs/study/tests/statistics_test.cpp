// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/statistics.h"

#include <gtest/gtest.h>

#include "learner_fixture.h"
#include "nazori/study/backups.h"
#include "nazori/study/day_plan.h"
#include "nazori/study/periods.h"

namespace nazori::study {
namespace {

using std::chrono::days;
using std::chrono::hours;
using std::chrono::milliseconds;
using test::MovedClock;
using test::must;
using test::review;
using test::use_zone;

Day day(const char* text) { return *parse_day(text); }

Writing timed(Stage stage, Rating rating, int seconds) {
  Writing writing = review(rating);
  writing.stage = stage;
  writing.result.duration = std::chrono::seconds(seconds);
  return writing;
}

struct Learner {
  MovedClock clock{"2026-01-01T09:00:00Z"};
  LearnerStore store = must(LearnerStore::in_memory(clock.clock()));
  Learner() { use_zone(store, "UTC"); }
  void write(char32_t c, Stage stage, Rating rating, int seconds) {
    (void)must(store.add_writing(c, 4, timed(stage, rating, seconds)));
  }
};

/// Ten characters introduced on the first day with three writings of 20 s each, then reviewed once.
void act_out(Learner& learner, int characters, Rating later) {
  for (int i = 0; i < characters; ++i) {
    const auto c = U'一' + static_cast<char32_t>(i);
    learner.write(c, Stage::watch, Rating::good, 20);
    learner.write(c, Stage::trace, Rating::good, 20);
    learner.write(c, Stage::memory, Rating::easy, 20);
  }
  learner.clock.advance(days(20));
  for (int i = 0; i < characters; ++i) {
    const auto c = U'一' + static_cast<char32_t>(i);
    learner.write(c, Stage::memory, later, 5 + i);
    // Writing again on the same day belongs to the same piece of work.
    if (later == Rating::again) learner.write(c, Stage::memory, Rating::good, 30);
  }
}

TEST(Pace, IsAnAssumptionUntilThereAreTenDaysOfItsKind) {
  Learner learner;
  act_out(learner, kPaceNeeds - 1, Rating::good);
  const Pace pace = must(pace_of(learner.store));
  EXPECT_EQ(pace.recalled, Pace().recalled);
  EXPECT_EQ(pace.introduced, Pace().introduced);
  EXPECT_EQ(pace.recalled_days, 9);
  EXPECT_EQ(pace.introduced_days, 9);
}

TEST(Pace, IsTheMedianOfADaysWorkOnACharacter) {
  Learner learner;
  act_out(learner, 11, Rating::good);
  const Pace pace = must(pace_of(learner.store));
  EXPECT_EQ(pace.introduced, milliseconds(60'000));
  EXPECT_EQ(pace.recalled, milliseconds(10'000));  // of 5, 6, ... 15 s
  EXPECT_EQ(pace.failed, Pace().failed);
  EXPECT_EQ(pace.failed_days, 0);
}

TEST(Pace, AFailedReviewTakesInWritingItAgain) {
  Learner learner;
  act_out(learner, 11, Rating::again);
  const Pace pace = must(pace_of(learner.store));
  EXPECT_EQ(pace.failed, milliseconds(40'000));
  EXPECT_EQ(pace.recalled_days, 0);
}

TEST(Pace, GoesByTheNewestTwoHundredDays) {
  // 150 characters took 60 s each; since then 101 took 5 s: of the newest 200 these are more than half.
  Learner learner;
  const auto write_all = [&learner](int from, int to, Rating rating, int seconds) {
    for (int i = from; i < to; ++i)
      learner.write(U'一' + static_cast<char32_t>(i), Stage::memory, rating, seconds);
  };
  write_all(0, 251, Rating::easy, 20);
  learner.clock.advance(days(20));
  write_all(0, 150, Rating::good, 60);
  learner.clock.advance(days(1));
  write_all(150, 250, Rating::good, 5);
  EXPECT_EQ(must(pace_of(learner.store)).recalled, milliseconds(60'000)) << "100 of 200";
  write_all(250, 251, Rating::good, 5);
  EXPECT_EQ(must(pace_of(learner.store)).recalled, milliseconds(5'000)) << "101 of 200";
}

TEST(Pace, TellsWhatADayAndAYearTake) {
  Learner learner;
  act_out(learner, 11, Rating::good);
  const std::vector<char32_t> fresh{U'休', U'木'};
  EXPECT_EQ(must(plan_day(learner.store, fresh)).estimate, milliseconds(120'000));
  const Pace quick{milliseconds(1'000), milliseconds(1'000), milliseconds(0)};
  const Workload workload = must(expected_workload({}, 5, quick));
  EXPECT_GT(workload.reviews_per_day, 60 * workload.minutes_per_day);  // steps take no extra time
  EXPECT_GT(must(expected_workload({}, 5)).minutes_per_day, 15 * workload.minutes_per_day);
}

TEST(Statistics, RetentionOfTheDaysAddsUpToThatOfAllTime) {
  Learner learner;
  learner.write(U'一', Stage::memory, Rating::easy, 5);
  learner.write(U'二', Stage::memory, Rating::easy, 5);
  learner.clock.advance(days(8));
  learner.write(U'一', Stage::memory, Rating::good, 5);
  learner.clock.advance(days(3));
  learner.write(U'二', Stage::memory, Rating::again, 5);
  const Statistics statistics = must(statistics_of(learner.store));
  ASSERT_EQ(statistics.retention_days.size(), 2U);
  EXPECT_EQ(statistics.retention_days[0].day, day("2026-01-09"));
  EXPECT_EQ(statistics.retention_days[0].retention.recalled, 1);
  EXPECT_EQ(statistics.retention_days[1].retention.recalled, 0);
  EXPECT_NEAR(
      statistics.retention.predicted,
      (statistics.retention_days[0].retention.predicted + statistics.retention_days[1].retention.predicted) /
          2,
      1e-12);
}

TEST(Statistics, PredictionsAreThoseOfTheWeightsInForce) {
  Learner learner;
  learner.write(U'一', Stage::memory, Rating::easy, 5);
  learner.clock.advance(days(8));
  Settings settings = learner.store.settings();
  settings.fsrs.weights[20] = 0.6;  // forgetting is steeper
  ASSERT_TRUE(learner.store.change_settings(settings));
  const double chance =
      Fsrs::create(settings.fsrs)->retrievability(learner.store.card(U'一').memory.stability, 8);
  learner.write(U'一', Stage::memory, Rating::good, 5);
  ASSERT_TRUE(learner.store.change_settings(Settings(settings)));
  EXPECT_NEAR(must(statistics_of(learner.store)).retention.predicted, chance, 1e-9);
}

TEST(Statistics, TheLastThirtyDaysAreTodayAndTheTwentyNineBefore) {
  for (const int ago : {29, 30}) {
    Learner learner;
    learner.write(U'一', Stage::memory, Rating::easy, 5);
    learner.clock.advance(days(8));
    learner.write(U'一', Stage::memory, Rating::good, 5);
    learner.clock.advance(days(ago));
    const Statistics statistics = must(statistics_of(learner.store));
    EXPECT_EQ(statistics.retention.reviews, 1);
    EXPECT_EQ(statistics.last_30_days.reviews, ago < 30 ? 1 : 0) << ago;
  }
}

TEST(Statistics, TwoMistakesOfAStrokeInOneWritingAreOneWritingThatWentWrong) {
  Learner learner;
  Writing writing = review(Rating::hard);
  writing.result.mistakes = {{kanji::MistakeKind::wrong, 2}, {kanji::MistakeKind::ending, 2}};
  for (int i = 0; i < 2; ++i) (void)must(learner.store.add_writing(U'一', 4, writing));
  const Statistics statistics = must(statistics_of(learner.store));
  ASSERT_EQ(statistics.hard_strokes.size(), 1U);
  EXPECT_EQ(statistics.hard_strokes[0].stroke, 2);
  EXPECT_EQ(statistics.hard_strokes[0].mistakes, 2);
  EXPECT_EQ(statistics.hard_strokes[0].writings, 2);
  EXPECT_EQ(
      statistics.hard_strokes[0].kinds,
      (std::map<kanji::MistakeKind, int>{{kanji::MistakeKind::wrong, 2}, {kanji::MistakeKind::ending, 2}}));
}

TEST(Statistics, CanBeStopped) {
  Learner learner;
  for (int i = 0; i < 600; ++i) learner.write(U'一', Stage::trace, Rating::good, 1);
  double last = 0;
  EXPECT_TRUE(statistics_of(learner.store, [&](double done, std::string_view) {
    EXPECT_GE(done, last);
    last = done;
    return true;
  }));
  EXPECT_GT(last, 0.5);
  const auto stopped = statistics_of(learner.store, [](double, std::string_view) { return false; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, base::Errc::cancelled);
}

TEST(Periods, BeginOnMondaysAndOnTheFirst) {
  // 2026-01-01 was a Thursday.
  EXPECT_EQ(begin_of(Period::week, day("2026-01-01")), day("2025-12-29"));
  EXPECT_EQ(begin_of(Period::week, day("2025-12-29")), day("2025-12-29"));
  EXPECT_EQ(next_of(Period::week, day("2026-01-04")), day("2026-01-05"));
  EXPECT_EQ(begin_of(Period::month, day("2026-02-28")), day("2026-02-01"));
  EXPECT_EQ(next_of(Period::month, day("2025-12-31")), day("2026-01-01"));
  EXPECT_EQ(next_of(Period::day, day("2026-02-28")), day("2026-03-01"));
}

TEST(Periods, DaysWithoutStudyAreThereAsNothing) {
  Statistics statistics;
  const auto one = [](const char* text, int reviews) {
    return DayActivity{day(text), reviews, 1, 0, milliseconds(500)};
  };
  statistics.days = {one("2025-12-30", 2), one("2026-01-01", 3), one("2026-01-13", 5)};
  const auto by_day = activity_by(Period::day, statistics, day("2025-12-31"));
  ASSERT_EQ(by_day.size(), 13U);
  EXPECT_EQ(by_day[0], (DayActivity{day("2026-01-01"), 3, 1, 0, milliseconds(500)}));
  EXPECT_EQ(by_day[1], (DayActivity{day("2026-01-02"), 0, 0, 0, milliseconds(0)}));
  const auto by_week = activity_by(Period::week, statistics, Day());
  ASSERT_EQ(by_week.size(), 3U);
  EXPECT_EQ(by_week[0], (DayActivity{day("2025-12-29"), 5, 2, 0, milliseconds(1'000)}));
  EXPECT_EQ(by_week[1].reviews, 0);
  EXPECT_EQ(by_week[2].reviews, 5);
  EXPECT_EQ(activity_by(Period::month, statistics, Day()).size(), 2U);
  EXPECT_TRUE(activity_by(Period::day, statistics, day("2026-02-01")).empty());
}

TEST(Periods, MeansAreOverWritingsNotOverDays) {
  Statistics statistics;
  statistics.motion = {{day("2026-01-05"), 1, 100, -2}, {day("2026-01-06"), 3, 200, -4}};
  statistics.retention_days = {{day("2026-01-05"), {1, 1, 0.8}}, {day("2026-01-06"), {3, 2, 0.9}}};
  const auto motion = motion_by(Period::week, statistics, Day());
  ASSERT_EQ(motion.size(), 1U);
  EXPECT_EQ(motion[0].writings, 4);
  EXPECT_NEAR(motion[0].speed, 175, 1e-9);
  EXPECT_NEAR(motion[0].smoothness, -3.5, 1e-9);
  const auto retention = retention_by(Period::week, statistics, Day());
  ASSERT_EQ(retention.size(), 1U);
  EXPECT_EQ(retention[0].retention.recalled, 3);
  EXPECT_NEAR(retention[0].retention.predicted, 0.875, 1e-12);
}

TEST(Backups, TellWhatTheyHold) {
  const test::TemporaryFolder folder;
  MovedClock clock("2026-01-10T09:00:00Z");
  const auto file = folder / "learner.db";
  auto store = must(LearnerStore::open(file, Access::write, clock.clock()));
  EXPECT_EQ(make_backup(store, file).error().code, base::Errc::not_found);
  use_zone(store, "UTC");
  (void)must(store.add_writing(U'一', 1, review(Rating::good)));
  clock.advance(days(1));
  (void)must(store.add_writing(U'二', 2, review(Rating::good)));
  (void)must(store.add_writing(U'二', 2, review(Rating::good)));
  (void)must(store.undo());
  const auto first = must(make_backup(store, file));
  const auto second = must(make_backup(store, file));
  EXPECT_NE(first, second);
  EXPECT_EQ(must(look_into(first)), (BackupContents{2, 2, day("2026-01-11"), clock.now()}));
  EXPECT_EQ(look_into(folder / "none.db").error().code, base::Errc::not_found);
}

}  // namespace
}  // namespace nazori::study
