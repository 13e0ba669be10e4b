// SPDX-License-Identifier: Apache-2.0
// Steps, intervals and limits of the scheduler, with weights and steps of the learner's own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "nazori/study/fsrs.h"

namespace nazori::study {
namespace {

using std::chrono::days;
using std::chrono::minutes;

const Time kStart = *parse_time("2026-01-01T09:00:00Z");
constexpr int kDay = 24 * 60;

template <class Change>
Fsrs with(Change change) {
  FsrsSettings settings;
  change(settings);
  const auto fsrs = Fsrs::create(settings);
  EXPECT_TRUE(fsrs) << base::to_line(fsrs.error());
  return fsrs ? *fsrs : Fsrs();
}

Memory known(double stability, double difficulty) {
  Memory memory;
  memory.phase = Phase::review;
  memory.stability = stability;
  memory.difficulty = difficulty;
  memory.reps = 3;
  memory.lapses = 1;
  memory.last_review = kStart;
  return memory;
}

TEST(FsrsDefaults, AreThoseOfTheReference) {
  const FsrsSettings settings;
  EXPECT_EQ(settings.desired_retention, 0.9);
  EXPECT_TRUE(settings.short_term_steps);
  EXPECT_EQ(settings.learning_steps, (std::vector{minutes(1), minutes(10)}));
  EXPECT_EQ(settings.relearning_steps, std::vector{minutes(10)});
  EXPECT_EQ(settings.maximum_interval_days, 36'500);
  EXPECT_EQ(Fsrs().settings(), settings);
}

TEST(FsrsDefaults, ACardThatWasNeverSeenHasNoNumbers) {
  const Memory fresh;
  EXPECT_EQ(fresh.phase, Phase::fresh);
  EXPECT_EQ(fresh.stability, 0);
  EXPECT_EQ(fresh.difficulty, 0);
  EXPECT_EQ(fresh.step, 0);
  EXPECT_EQ(fresh.scheduled_days, 0);
  EXPECT_EQ(fresh.reps, 0);
  EXPECT_EQ(fresh.lapses, 0);
  EXPECT_EQ(fresh.due, Time());
  EXPECT_FALSE(fresh.last_review);
}

TEST(FsrsNames, AreReadBack) {
  for (const Rating rating : kRatings) EXPECT_EQ(rating_named(name_of(rating)), rating);
  for (const Phase phase : {Phase::fresh, Phase::learning, Phase::review, Phase::relearning})
    EXPECT_EQ(phase_named(name_of(phase)), phase);
  EXPECT_EQ(phase_named("new"), Phase::fresh);
  EXPECT_EQ(rating_named("again"), Rating::again);
  EXPECT_FALSE(rating_named(""));
  EXPECT_FALSE(phase_named("gone"));
}

TEST(FsrsLimits, StepsAreOneMinuteToAHundredDaysAndTwentyAtMost) {
  const auto accepted = [](std::vector<minutes> steps) {
    FsrsSettings learning;
    learning.learning_steps = steps;
    FsrsSettings relearning;
    relearning.relearning_steps = steps;
    const bool fits = Fsrs::create(learning).has_value();
    const auto other = Fsrs::create(relearning);
    EXPECT_EQ(other.has_value(), fits);
    if (!other) {
      EXPECT_EQ(other.error().where, "relearning steps");
    }
    return fits;
  };
  EXPECT_TRUE(accepted({}));
  EXPECT_TRUE(accepted({minutes(1), minutes(100 * kDay)}));
  EXPECT_FALSE(accepted({minutes(10), minutes(0)}));
  EXPECT_FALSE(accepted({minutes(100 * kDay + 1)}));
  EXPECT_TRUE(accepted(std::vector(20, minutes(5))));
  EXPECT_FALSE(accepted(std::vector(21, minutes(5))));
}

TEST(FsrsLimits, TheLongestIntervalIsADayToAHundredYears) {
  const auto accepted = [](int longest) {
    FsrsSettings settings;
    settings.maximum_interval_days = longest;
    return Fsrs::create(settings).has_value();
  };
  EXPECT_FALSE(accepted(0));
  EXPECT_TRUE(accepted(1));
  EXPECT_TRUE(accepted(36'500));
  EXPECT_FALSE(accepted(36'501));
}

TEST(FsrsLimits, WithoutStabilityNothingIsRecalledAndNoTimeIsNegative) {
  const Fsrs fsrs;
  EXPECT_EQ(fsrs.retrievability(0, 0), 0);
  EXPECT_EQ(fsrs.retrievability(0, 5), 0);
  EXPECT_EQ(fsrs.retrievability(5, -3), 1);
}

TEST(FsrsLimits, StabilityStaysBetweenAThousandthOfADayAndAHundredYears) {
  EXPECT_EQ(Fsrs().next(known(36'000, 1), Rating::easy, kStart, 36'000).stability, 36'500);
  const Fsrs forgetful = with([](FsrsSettings& s) {
    s.weights[11] = s.weights[13] = 0.001;
    s.weights[14] = 0;
  });
  EXPECT_EQ(forgetful.next(known(1, 10), Rating::again, kStart, 1).stability, 0.001);
  // A lapse would give 0.002 here, but not more than the stability before it.
  EXPECT_EQ(Fsrs().next(known(0.001, 1), Rating::again, kStart, 1'000).stability, 0.001);
  const Fsrs dropping = with([](FsrsSettings& s) {
    s.weights[17] = 2;
    s.weights[18] = 0;
  });
  EXPECT_EQ(dropping.next(known(0.002, 5), Rating::again, kStart, 0).stability, 0.001);
}

TEST(FsrsLimits, AFirstStabilityIsATenthOfADayAtLeast) {
  const Fsrs fsrs = with([](FsrsSettings& s) {
    s.weights[0] = 0.001;
    s.weights[1] = 0.11;
  });
  EXPECT_EQ(fsrs.next({}, Rating::again, kStart, 0).stability, 0.1);
  EXPECT_EQ(fsrs.next({}, Rating::hard, kStart, 0).stability, 0.11);
}

TEST(FsrsLimits, ForgettingLeavesNoMoreThanALapseAndAStepWould) {
  // Forgotten much later: the lapse alone would give 0.02 days.
  const FsrsWeights& w = kDefaultWeights;
  const double with_steps = Fsrs().next(known(0.01, 1), Rating::again, kStart, 10'000).stability;
  EXPECT_NEAR(with_steps, 0.01 / std::exp(w[17] * w[18]), 1e-8);
  const Fsrs in_days = with([](FsrsSettings& s) { s.short_term_steps = false; });
  EXPECT_EQ(in_days.next(known(0.01, 1), Rating::again, kStart, 10'000).stability, 0.01);
}

TEST(FsrsLimits, SeveralRelearningStepsLeaveNoMoreThanThereWas) {
  const auto same_day_weights = [](std::size_t steps, double w11) {
    return with([&](FsrsSettings& s) {
             s.relearning_steps.assign(steps, minutes(5));
             s.weights[11] = w11;
             s.weights[17] = s.weights[18] = 2;
           })
        .settings()
        .weights;
  };
  for (const std::size_t steps : {std::size_t{0}, std::size_t{1}}) {
    EXPECT_EQ(same_day_weights(steps, 1.4835)[17], 2);
    EXPECT_EQ(same_day_weights(steps, 1.4835)[18], 2);
  }
  for (const std::size_t steps : {std::size_t{2}, std::size_t{5}}) {
    const FsrsWeights w = same_day_weights(steps, 1.4835);
    EXPECT_EQ(w[17], w[18]);
    // One day with a probability of 0.7, lapsed at the lowest difficulty, then every step good.
    const double left = w[11] * (std::pow(2, w[13]) - 1) * std::exp(0.3 * w[14]) *
                        std::exp(w[17] * w[18] * static_cast<double>(steps));
    EXPECT_NEAR(left, 1, 1e-6) << steps;
  }
  // Here the lapse alone gives more than that, so hardly any gain is allowed.
  EXPECT_EQ(same_day_weights(2, 5)[17], 0.01);
  EXPECT_EQ(same_day_weights(2, 5)[18], 0.01);
}

TEST(FsrsLimits, TheGainOfOneDayAlwaysEndsWhereThereAreSteps) {
  const auto weight = [](bool steps, double given) {
    return with([&](FsrsSettings& s) {
             s.short_term_steps = steps;
             s.weights[19] = given;
           })
        .settings()
        .weights[19];
  };
  EXPECT_EQ(weight(true, 0), 0.01);
  EXPECT_EQ(weight(true, 0.02), 0.02);
  EXPECT_EQ(weight(false, 0), 0);
}

TEST(FsrsIntervals, HalfADayGoesUp) {
  const Fsrs fsrs;
  EXPECT_EQ(fsrs.interval_days(2.49), 2);
  EXPECT_EQ(fsrs.interval_days(2.51), 3);
  const Fsrs short_ones = with([](FsrsSettings& s) { s.maximum_interval_days = 100; });
  EXPECT_EQ(short_ones.interval_days(99), 99);
  EXPECT_EQ(short_ones.interval_days(101), 100);
}

TEST(FsrsIntervals, MayMoveByWhatIsPublishedWhateverTheirLength) {
  // 15 % of the part over 2.5 days, 10 % over 7, 5 % over 20, and one day: in two hundredths of a day.
  const Fsrs fsrs;
  const auto rounded = [](int parts) { return (parts + 100) / 200; };
  for (int interval = 3; interval <= 1'000; ++interval) {
    const int delta = 200 + 15 * (2 * std::min(interval, 7) - 5) + 20 * std::clamp(interval - 7, 0, 13) +
                      10 * std::max(interval - 20, 0);
    // A half can be rounded to either side, because the shares are not binary fractions.
    if ((delta + 100) % 200 == 0) continue;
    const DayRange expected{std::max(2, rounded(200 * interval - delta)), rounded(200 * interval + delta)};
    EXPECT_EQ(fsrs.fuzz_range(interval, 0), expected) << interval;
  }
}

TEST(FsrsIntervals, MoveNeitherBeyondTheLongestNorToADayThatHasPassed) {
  const Fsrs short_ones = with([](FsrsSettings& s) { s.maximum_interval_days = 11; });
  EXPECT_EQ(short_ones.fuzz_range(10, 0), (DayRange{8, 11}));
  // 40 days become 11 first, and move as far as 40 would: by 3.975.
  EXPECT_EQ(short_ones.fuzz_range(40, 0), (DayRange{7, 11}));
  const Fsrs daily = with([](FsrsSettings& s) { s.maximum_interval_days = 1; });
  EXPECT_EQ(daily.fuzz_range(3, 0), (DayRange{1, 1}));
  EXPECT_EQ(Fsrs().fuzz_range(1, 0), (DayRange{1, 1}));
  EXPECT_EQ(Fsrs().fuzz_range(10, 8), (DayRange{9, 12}));
  EXPECT_EQ(Fsrs().fuzz_range(10, 5), (DayRange{8, 12}));
  EXPECT_EQ(DayRange(), (DayRange{1, 1}));
}

TEST(FsrsIntervals, HardGoodAndEasyDifferByADayAtLeast) {
  // With these weights all three give the same stability.
  const Fsrs fsrs = with([](FsrsSettings& s) { s.weights[15] = s.weights[16] = 1; });
  const Memory memory = known(30, 5);
  const auto interval = [&](Rating rating) { return fsrs.next(memory, rating, kStart, 30).scheduled_days; };
  const int hard = interval(Rating::hard);
  EXPECT_EQ(hard, fsrs.interval_days(fsrs.next(memory, Rating::hard, kStart, 30).stability));
  EXPECT_EQ(interval(Rating::good), hard + 1);
  EXPECT_EQ(interval(Rating::easy), hard + 2);
}

TEST(FsrsIntervals, InDaysOnlyEachAnswerWaitsLongerThanTheOneBefore) {
  const Fsrs fsrs = with([](FsrsSettings& s) { s.short_term_steps = false; });
  // So weak that each stability is worth one day.
  const Memory weak = known(0.1, 10);
  int expected = 1;
  for (const Rating rating : kRatings) {
    const Memory next = fsrs.next(weak, rating, kStart, 0);
    EXPECT_EQ(next.scheduled_days, expected);
    EXPECT_EQ(next.due, kStart + days(expected++));
    EXPECT_EQ(next.phase, Phase::review);
    EXPECT_EQ(next.step, 0);
  }
  // Where the stabilities are further apart, each interval is that of its own.
  const Memory strong = known(100, 3);
  for (const Rating rating : kRatings) {
    const Memory next = fsrs.next(strong, rating, kStart, 100);
    EXPECT_EQ(next.scheduled_days, fsrs.interval_days(next.stability)) << name_of(rating);
  }
}

TEST(FsrsSteps, ShorterThanADayAreMinutesAndFromADayOnIntervals) {
  const auto first = [](int step) {
    return with([&](FsrsSettings& s) { s.learning_steps = {minutes(step)}; })
        .next({}, Rating::again, kStart, 0);
  };
  EXPECT_EQ(first(kDay - 1).phase, Phase::learning);
  EXPECT_EQ(first(kDay - 1).scheduled_days, 0);
  EXPECT_EQ(first(kDay - 1).due, kStart + minutes(kDay - 1));
  EXPECT_EQ(first(kDay).phase, Phase::review);
  EXPECT_EQ(first(kDay).scheduled_days, 1);
  EXPECT_EQ(first(3 * kDay - 1).scheduled_days, 2);
  EXPECT_EQ(first(3 * kDay - 1).due, kStart + minutes(3 * kDay - 1));
}

TEST(FsrsSteps, GoodGoesOnHardStaysAgainBeginsAnew) {
  const Fsrs fsrs = with([](FsrsSettings& s) { s.learning_steps = {minutes(4), minutes(11), minutes(30)}; });
  const auto wait = [](const Memory& memory) { return memory.due - *memory.last_review; };
  Memory card = fsrs.next({}, Rating::good, kStart, 0);
  EXPECT_EQ(card.step, 1);
  EXPECT_EQ(wait(card), minutes(11));
  EXPECT_EQ(card.reps, 1);
  card = fsrs.next(card, Rating::good, kStart, 0);
  EXPECT_EQ(card.step, 2);
  EXPECT_EQ(wait(card), minutes(30));
  // The mean of the first two steps, whichever is present: 7.5 minutes, rounded up.
  const Memory hard = fsrs.next(card, Rating::hard, kStart, 0);
  EXPECT_EQ(hard.step, 2);
  EXPECT_EQ(wait(hard), minutes(8));
  const Memory again = fsrs.next(card, Rating::again, kStart, 0);
  EXPECT_EQ(again.step, 0);
  EXPECT_EQ(wait(again), minutes(4));
  EXPECT_EQ(again.phase, Phase::learning);
  EXPECT_EQ(again.lapses, 0);
  for (const Rating rating : {Rating::good, Rating::easy}) {
    const Memory done = fsrs.next(card, rating, kStart, 0);
    EXPECT_EQ(done.phase, Phase::review);
    EXPECT_EQ(done.step, 0);
    EXPECT_EQ(done.scheduled_days, fsrs.interval_days(done.stability));
    EXPECT_EQ(done.reps, 3);
  }
}

TEST(FsrsSteps, HardOnTheOnlyStepWaitsHalfAsLongAgain) {
  const auto wait = [](int step) {
    const Fsrs fsrs = with([&](FsrsSettings& s) { s.learning_steps = {minutes(step)}; });
    return fsrs.next({}, Rating::hard, kStart, 0).due - kStart;
  };
  EXPECT_EQ(wait(4), minutes(6));
  EXPECT_EQ(wait(5), minutes(8));
}

TEST(FsrsSteps, WhatWasForgottenHasStepsOfItsOwn) {
  const Fsrs fsrs = with([](FsrsSettings& s) {
    s.learning_steps = {minutes(3)};
    s.relearning_steps = {minutes(17), minutes(40)};
  });
  Memory card = fsrs.next(known(20, 5), Rating::again, kStart, 20);
  EXPECT_EQ(card.phase, Phase::relearning);
  EXPECT_EQ(card.due, kStart + minutes(17));
  EXPECT_EQ(card.lapses, 2);
  EXPECT_EQ(card.scheduled_days, 0);
  card = fsrs.next(card, Rating::good, kStart, 0);
  EXPECT_EQ(card.phase, Phase::relearning);
  EXPECT_EQ(card.due, kStart + minutes(40));
  card = fsrs.next(card, Rating::again, kStart, 0);
  EXPECT_EQ(card.due, kStart + minutes(17));
  EXPECT_EQ(card.lapses, 2) << "forgotten while it is learnt again is no other lapse";
}

TEST(FsrsSteps, WithoutAnyOrBeyondTheLastACardGetsDays) {
  const Fsrs none = with([](FsrsSettings& s) {
    s.learning_steps.clear();
    s.relearning_steps.clear();
  });
  EXPECT_EQ(none.next({}, Rating::again, kStart, 0).phase, Phase::review);
  const Memory lapsed = none.next(known(20, 5), Rating::again, kStart, 20);
  EXPECT_EQ(lapsed.phase, Phase::review);
  EXPECT_EQ(lapsed.lapses, 2);
  EXPECT_GE(lapsed.scheduled_days, 1);
  // The number of steps was reduced meanwhile.
  Memory late = known(1, 5);
  late.phase = Phase::learning;
  late.step = 2;
  EXPECT_EQ(Fsrs().next(late, Rating::again, kStart, 0).phase, Phase::review);
  late.step = 1;
  EXPECT_EQ(Fsrs().next(late, Rating::again, kStart, 0).phase, Phase::learning);
}

TEST(FsrsSteps, InDaysEveryForgettingButTheFirstAnswerIsALapse) {
  const Fsrs fsrs = with([](FsrsSettings& s) { s.short_term_steps = false; });
  EXPECT_EQ(fsrs.next({}, Rating::again, kStart, 0).lapses, 0);
  for (const Phase phase : {Phase::learning, Phase::review, Phase::relearning}) {
    Memory memory = known(5, 5);
    memory.phase = phase;
    EXPECT_EQ(fsrs.next(memory, Rating::again, kStart, 5).lapses, 2) << name_of(phase);
    EXPECT_EQ(fsrs.next(memory, Rating::hard, kStart, 5).lapses, 1) << name_of(phase);
    EXPECT_EQ(fsrs.next(memory, Rating::hard, kStart, 5).phase, Phase::review) << name_of(phase);
  }
}

}  // namespace
}  // namespace nazori::study
