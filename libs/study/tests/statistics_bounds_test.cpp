// SPDX-License-Identifier: Apache-2.0
// What the statistics count and what not, streaks, strengths and periods.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "learner_fixture.h"
#include "nazori/study/day_plan.h"
#include "nazori/study/periods.h"
#include "nazori/study/statistics.h"

namespace nazori::study {
namespace {

using std::chrono::days;
using std::chrono::hours;
using std::chrono::milliseconds;
using test::MovedClock;
using test::must;
using test::review;
using test::some_ink;
using test::use_zone;
using testing::ElementsAre;

Day day(const char* text) { return *parse_day(text); }

struct Learner {
  MovedClock clock{"2026-01-01T09:00:00Z"};
  LearnerStore store = must(LearnerStore::in_memory(clock.clock()));
  Learner() { use_zone(store, "UTC"); }
  void write(char32_t c, Rating rating, Stage stage = Stage::memory, const Handwriting& ink = {}) {
    Writing writing = review(rating);
    writing.stage = stage;
    (void)must(store.add_writing(c, 4, writing, ink));
  }
  void write_with_mistakes(char32_t c, std::vector<StrokeMistake> mistakes, Stage stage = Stage::memory) {
    Writing writing = review(Rating::good);
    writing.stage = stage;
    writing.result.mistakes = std::move(mistakes);
    (void)must(store.add_writing(c, 4, writing));
  }
  [[nodiscard]] Statistics statistics() const { return must(statistics_of(store)); }
};

TEST(StatisticsForecast, HoldsTodayWithWhatIsOverdueAndTheNextTwentyNineDays) {
  Learner learner;
  const auto due_after = [&](char32_t c, int wait) {
    // A moved interval is the one in the log.
    learner.write(c, Rating::easy);
    EXPECT_TRUE(learner.store.postpone(std::span(&c, 1), learner.store.today() + days(wait)));
  };
  due_after(U'一', 29);
  due_after(U'二', 30);
  due_after(U'三', 0);  // in eight days, the normal interval
  due_after(U'四', 8);
  due_after(U'五', 9);
  learner.write(U'六', Rating::again);  // in its steps
  learner.write(U'七', Rating::easy);
  ASSERT_TRUE(learner.store.pause(std::array{U'七'}));
  learner.write(U'八', Rating::good, Stage::trace);
  Statistics statistics = learner.statistics();
  ASSERT_EQ(statistics.forecast.size(), 30U);
  for (std::size_t i = 0; i < 30; ++i) {
    EXPECT_EQ(statistics.forecast[i].day, day("2026-01-01") + days(i));
    const int expected = i == 0 || i == 9 || i == 29 ? 1 : i == 8 ? 2 : 0;
    EXPECT_EQ(statistics.forecast[i].reviews, expected) << i;
  }
  learner.clock.advance(days(10));
  statistics = learner.statistics();
  EXPECT_EQ(statistics.forecast[0].reviews, 4) << "overdue";
  EXPECT_EQ(statistics.forecast[19].reviews, 1);
  EXPECT_EQ(statistics.forecast[20].reviews, 1);
}

TEST(StatisticsForecast, LeechesDoNotCome) {
  Learner learner;
  Settings settings = learner.store.settings();
  settings.leech_lapses = 2;
  ASSERT_TRUE(learner.store.change_settings(settings));
  for (int i = 0; i < 2; ++i) {
    learner.write(U'一', Rating::easy);
    learner.clock.advance(days(30));
    learner.write(U'一', Rating::again);
  }
  ASSERT_TRUE(learner.store.card(U'一').leech);
  const Statistics statistics = learner.statistics();
  for (const DayForecast& one : statistics.forecast) EXPECT_EQ(one.reviews, 0);
  ASSERT_EQ(statistics.characters.size(), 1U);
  EXPECT_EQ(statistics.characters[0].strength, Strength::leech);
}

TEST(StatisticsRetention, CountsReviewsOfKnownCharactersOnLaterDays) {
  Learner learner;
  learner.write(U'一', Rating::easy);
  learner.write(U'一', Rating::good);   // on the same day
  learner.write(U'二', Rating::again);  // in its steps
  learner.clock.advance(days(1));
  learner.write(U'二', Rating::good);  // was in its steps
  EXPECT_EQ(learner.statistics().retention, Retention());
  EXPECT_EQ(learner.statistics().retention.actual(), 0);
  const double stability = learner.store.card(U'一').memory.stability;
  learner.write(U'一', Rating::hard);
  Retention retention = learner.statistics().retention;
  EXPECT_EQ(retention.reviews, 1);
  EXPECT_EQ(retention.recalled, 1);
  EXPECT_NEAR(retention.predicted, Fsrs().retrievability(stability, 1), 1e-12);
  EXPECT_EQ(retention.actual(), 1);
  learner.clock.advance(days(30));
  for (int i = 0; i < 3; ++i) learner.write(U'一', Rating::again);
  retention = learner.statistics().retention;
  EXPECT_EQ(retention.reviews, 2) << "once a day";
  EXPECT_EQ(retention.recalled, 1);
  EXPECT_EQ(retention.actual(), 0.5);
}

TEST(StatisticsActivity, TellsReviewsPracticeAndNewOnesApart) {
  Learner learner;
  learner.write(U'一', Rating::good, Stage::watch);
  learner.write(U'一', Rating::good, Stage::trace);
  learner.write(U'一', Rating::easy);
  learner.write(U'二', Rating::easy);
  learner.clock.advance(days(2));
  learner.write(U'一', Rating::easy);
  const Statistics statistics = learner.statistics();
  const milliseconds each(12'345);
  EXPECT_THAT(statistics.days, ElementsAre(DayActivity{day("2026-01-01"), 2, 2, 2, 4 * each},
                                           DayActivity{day("2026-01-03"), 1, 0, 0, each}));
  EXPECT_EQ(statistics.reviews, 3);
  EXPECT_EQ(statistics.time, 5 * each);
  EXPECT_EQ(statistics.today, day("2026-01-03"));
  EXPECT_EQ(statistics.streak, (Streak{2, 2, true, true}));
}

TEST(StatisticsActivity, BeginsWithNothing) {
  const Statistics statistics = Learner().statistics();
  EXPECT_EQ(statistics.reviews, 0);
  EXPECT_EQ(statistics.time, milliseconds(0));
  EXPECT_EQ(statistics.retention, (Retention{0, 0, 0}));
  EXPECT_EQ(statistics.streak, (Streak{0, 0, false, false}));
  EXPECT_TRUE(statistics.days.empty() && statistics.characters.empty() && statistics.hard_strokes.empty() &&
              statistics.motion.empty() && statistics.retention_days.empty());
  EXPECT_EQ(DayActivity(), (DayActivity{Day(), 0, 0, 0, milliseconds(0)}));
  EXPECT_EQ(Retention(), (Retention{0, 0, 0}));
  EXPECT_EQ(HardStroke(), (HardStroke{0, 0, 0, 0, {}}));
  EXPECT_EQ(DayMotion(), (DayMotion{Day(), 0, 0, 0}));
  EXPECT_EQ(DayForecast(), (DayForecast{Day(), 0}));
  EXPECT_EQ(CharacterState(), (CharacterState{0, Strength::unseen, 0}));
  EXPECT_EQ(Workload(), (Workload{0, 0, 0}));
  EXPECT_EQ(CharacterDay(), (CharacterDay{Day(), std::nullopt, milliseconds(0), 0, 0}));
  EXPECT_EQ(StudyDay(), (StudyDay{Day(), 0, 0}));
  EXPECT_EQ(OutcomeTimes().days, 0);
}

TEST(StatisticsStrokes, ThatWentWrongTwiceComeWorstFirst) {
  Learner learner;
  const auto wrong = [](int stroke) { return StrokeMistake{kanji::MistakeKind::wrong, stroke}; };
  for (int i = 0; i < 3; ++i) learner.write_with_mistakes(U'一', {wrong(1), wrong(0)});
  for (int i = 0; i < 2; ++i) learner.write_with_mistakes(U'二', {wrong(5)});
  for (int i = 0; i < 2; ++i) learner.write_with_mistakes(U'三', {wrong(5)}, Stage::trace);
  learner.write_with_mistakes(U'二', {});
  learner.write_with_mistakes(U'四', {wrong(0)});                                            // once only
  for (int i = 0; i < 2; ++i) learner.write_with_mistakes(U'五', {wrong(0)}, Stage::watch);  // only watched
  std::vector<std::tuple<char32_t, int, int, int>> hard;
  for (const HardStroke& one : learner.statistics().hard_strokes)
    hard.emplace_back(one.character, one.stroke, one.mistakes, one.writings);
  using Hard = std::tuple<char32_t, int, int, int>;
  EXPECT_THAT(hard, ElementsAre(Hard(U'一', 0, 3, 3), Hard(U'一', 1, 3, 3), Hard(U'三', 5, 2, 2),
                                Hard(U'二', 5, 2, 3)));
}

TEST(StatisticsStrokes, AreAHundredAtMost) {
  Learner learner;
  std::vector<StrokeMistake> mistakes;
  for (int stroke = 0; stroke < 101; ++stroke) mistakes.push_back({kanji::MistakeKind::order, stroke});
  for (int i = 0; i < 2; ++i) learner.write_with_mistakes(U'一', mistakes);
  const auto hard = learner.statistics().hard_strokes;
  ASSERT_EQ(hard.size(), 100U);
  EXPECT_EQ(hard.back().stroke, 99);
}

TEST(StatisticsMotion, IsTheMeanOfTheDay) {
  Learner learner;
  learner.write(U'一', Rating::good, Stage::memory, some_ink(1));
  learner.write(U'二', Rating::good, Stage::trace, some_ink(5));
  learner.write(U'三', Rating::good);
  const PenMotion first = *motion_of(some_ink(1));
  const PenMotion second = *motion_of(some_ink(5));
  ASSERT_NE(first, second);
  const auto motion = learner.statistics().motion;
  ASSERT_EQ(motion.size(), 1U);
  EXPECT_EQ(motion[0].writings, 2);
  EXPECT_NEAR(motion[0].speed, (first.speed + second.speed) / 2, 1e-9);
  EXPECT_NEAR(motion[0].smoothness, (first.smoothness + second.smoothness) / 2, 1e-9);
}

TEST(StatisticsCharacters, HaveTheirStrength) {
  Card card;
  EXPECT_EQ(strength_of(card), Strength::unseen);
  card.introduced = day("2026-01-01");
  EXPECT_EQ(strength_of(card), Strength::learning);
  for (const Phase phase : {Phase::learning, Phase::relearning}) {
    card.memory.phase = phase;
    card.memory.stability = 100;
    EXPECT_EQ(strength_of(card), Strength::learning);
  }
  card.memory.phase = Phase::review;
  card.memory.stability = 20.999;
  EXPECT_EQ(strength_of(card), Strength::young);
  card.memory.stability = 21;
  EXPECT_EQ(strength_of(card), Strength::mature);
  card.leech = true;
  EXPECT_EQ(strength_of(card), Strength::leech);
  card.paused = true;
  EXPECT_EQ(strength_of(card), Strength::paused);
  EXPECT_EQ(name_of(Strength::unseen), "unseen");
  EXPECT_EQ(name_of(Strength::paused), "paused");
  EXPECT_EQ(name_of(static_cast<Strength>(99)), "");
}

TEST(StatisticsProgress, TellsTheShareOfTheLog) {
  Learner learner;
  for (int i = 0; i < 1'023; ++i) learner.write(U'一', Rating::good, Stage::trace);
  ASSERT_EQ(learner.store.last_entry(), 1'024);
  std::vector<double> reported;
  ASSERT_TRUE(statistics_of(learner.store, [&](double done, std::string_view step) {
    EXPECT_EQ(step, "statistics");
    reported.push_back(done);
    return true;
  }));
  EXPECT_THAT(reported, ElementsAre(0.25, 0.5, 0.75, 1));
}

Streak streak(std::initializer_list<int> studied, int today) {
  std::vector<Day> all;
  for (const int n : studied) all.push_back(day("2026-01-01") + days(n));
  return streak_of(all, day("2026-01-01") + days(today));
}

TEST(Streak, ADayOffIsForgivenSevenDaysAfterTheLastOne) {
  // No study on day 3, then on day 9 or on day 10.
  EXPECT_EQ(streak({1, 2, 4, 5, 6, 7, 8, 10}, 10), (Streak{1, 7, true, false}));
  EXPECT_EQ(streak({1, 2, 4, 5, 6, 7, 8, 9, 11}, 11), (Streak{9, 9, true, true}));
  // Two days off in a row always break the streak.
  EXPECT_EQ(streak({1, 2, 5}, 5), (Streak{1, 2, true, false}));
}

TEST(Streak, ADayOffIsUsedForSevenDays) {
  EXPECT_EQ(streak({1, 3, 4, 5, 6, 7, 8}, 8), (Streak{7, 7, true, true}));
  EXPECT_EQ(streak({1, 3, 4, 5, 6, 7, 8, 9}, 9), (Streak{8, 8, true, false}));
}

TEST(Streak, TodayMayStillBeDone) {
  EXPECT_EQ(streak({3}, 4), (Streak{1, 1, false, false}));
  EXPECT_EQ(streak({3}, 5), (Streak{1, 1, false, true})) << "the day off would be used by today";
  EXPECT_EQ(streak({3}, 6), (Streak{0, 1, false, false}));
  EXPECT_EQ(streak({3}, 3), (Streak{1, 1, true, false}));
  // The day off was used already.
  EXPECT_EQ(streak({1, 3, 4}, 6), (Streak{0, 3, false, false}));
}

TEST(Streak, CountsADayOnceAndNothingAfterToday) {
  EXPECT_EQ(streak({1, 1, 2, 2, 3}, 3), (Streak{3, 3, true, false}));
  EXPECT_EQ(streak({1, 2, 3, 4, 5}, 3), (Streak{3, 3, true, false}));
  EXPECT_EQ(streak({1, 2, 3, 4, 7, 8}, 8), (Streak{2, 4, true, false})) << "the longest is an older one";
  EXPECT_EQ(streak({1, 3, 6, 8}, 8), (Streak{2, 2, true, true})) << "a new one may have its own day off";
  EXPECT_EQ(streak({}, 8), (Streak{0, 0, false, false}));
}

TEST(PeriodsOf, EachBeginOnTheirFirstDay) {
  EXPECT_EQ(begin_of(Period::day, day("2026-03-05")), day("2026-03-05"));
  // 2026-03-02 was a Monday.
  for (int i = 0; i < 7; ++i) {
    EXPECT_EQ(begin_of(Period::week, day("2026-03-02") + days(i)), day("2026-03-02")) << i;
    EXPECT_EQ(next_of(Period::week, day("2026-03-02") + days(i)), day("2026-03-09")) << i;
  }
  for (const char* one : {"2026-02-01", "2026-02-14", "2026-02-28"}) {
    EXPECT_EQ(begin_of(Period::month, day(one)), day("2026-02-01"));
    EXPECT_EQ(next_of(Period::month, day(one)), day("2026-03-01"));
  }
  EXPECT_EQ(next_of(Period::month, day("2024-02-29")), day("2024-03-01"));
  EXPECT_EQ(next_of(Period::month, day("2026-01-31")), day("2026-02-01"));
  EXPECT_EQ(next_of(Period::month, day("2026-04-30")), day("2026-05-01"));
}

TEST(PeriodsOf, TheFirstDayIsTakenAndTheOneBeforeIsNot) {
  Statistics statistics;
  for (const char* one : {"2026-03-04", "2026-03-05", "2026-03-06"}) {
    statistics.days.push_back({day(one), 1, 2, 3, milliseconds(4)});
    statistics.retention_days.push_back({day(one), {2, 1, 0.75}});
    statistics.motion.push_back({day(one), 1, 30, -3});
  }
  const auto activity = activity_by(Period::week, statistics, day("2026-03-05"));
  EXPECT_THAT(activity, ElementsAre(DayActivity{day("2026-03-02"), 2, 4, 6, milliseconds(8)}));
  const auto by_day = activity_by(Period::day, statistics, day("2026-03-05"));
  EXPECT_THAT(by_day, ElementsAre(DayActivity{day("2026-03-05"), 1, 2, 3, milliseconds(4)},
                                  DayActivity{day("2026-03-06"), 1, 2, 3, milliseconds(4)}));
  const auto retention = retention_by(Period::month, statistics, day("2026-03-05"));
  EXPECT_THAT(retention, ElementsAre(DayRetention{day("2026-03-01"), {4, 2, 0.75}}));
  EXPECT_EQ(retention_by(Period::day, statistics, day("2026-03-05")).size(), 2U);
  const auto motion = motion_by(Period::month, statistics, day("2026-03-05"));
  EXPECT_THAT(motion, ElementsAre(DayMotion{day("2026-03-01"), 2, 30, -3}));
  EXPECT_EQ(motion_by(Period::day, statistics, day("2026-03-05")).size(), 2U);
  EXPECT_TRUE(motion_by(Period::day, statistics, day("2026-03-07")).empty());
}

TEST(PeriodsOf, MonthsWithoutStudyAreThere) {
  Statistics statistics;
  statistics.days = {{day("2025-11-30"), 1, 0, 0, {}}, {day("2026-02-01"), 2, 0, 0, {}}};
  const auto months = activity_by(Period::month, statistics, Day());
  EXPECT_THAT(
      months,
      ElementsAre(DayActivity{day("2025-11-01"), 1, 0, 0, {}}, DayActivity{day("2025-12-01"), 0, 0, 0, {}},
                  DayActivity{day("2026-01-01"), 0, 0, 0, {}}, DayActivity{day("2026-02-01"), 2, 0, 0, {}}));
}

TEST(UsualWriting, IsTheMedianOfTheLastTenAcceptedFromMemory) {
  Learner learner;
  const auto took = [&](int seconds, Stage stage = Stage::memory, bool accepted = true) {
    Writing writing = review(Rating::good);
    writing.stage = stage;
    writing.result.accepted = accepted;
    writing.result.duration = std::chrono::seconds(seconds);
    (void)must(learner.store.add_writing(U'一', 4, writing));
  };
  EXPECT_EQ(must(learner.store.usual_writing(U'一')).count, 0);
  took(7);
  EXPECT_EQ(must(learner.store.usual_writing(U'一')).duration, std::chrono::seconds(7));
  took(9);
  took(8);
  took(0);
  took(99, Stage::guided);
  took(99, Stage::memory, false);
  EXPECT_EQ(must(learner.store.usual_writing(U'一')).count, 3);
  EXPECT_EQ(must(learner.store.usual_writing(U'一')).duration, std::chrono::seconds(8));
  for (int i = 1; i < 10; ++i) took(20 + i);
  // 8 and the nine: of ten the upper middle.
  EXPECT_EQ(must(learner.store.usual_writing(U'一')).count, 10);
  EXPECT_EQ(must(learner.store.usual_writing(U'一')).duration, std::chrono::seconds(25));
  took(30);
  EXPECT_EQ(must(learner.store.usual_writing(U'一')).duration, std::chrono::seconds(26)) << "8 is out";
}

}  // namespace
}  // namespace nazori::study
