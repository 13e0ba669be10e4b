// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/fsrs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace nazori::study {
namespace {

using std::chrono::days;
using std::chrono::minutes;

const Time kStart = *parse_time("2026-01-01T09:00:00Z");

TEST(Fsrs, AfterExactlyTheStabilityTheChanceOfRecallIsNineTenths) {
  const Fsrs fsrs;
  for (const double stability : {0.5, 1.0, 8.2956, 300.0, 36500.0}) {
    EXPECT_NEAR(fsrs.retrievability(stability, stability), 0.9, 1e-7) << stability;
  }
  EXPECT_EQ(fsrs.retrievability(5, 0), 1);
}

TEST(Fsrs, AtNineTenthsTheIntervalIsTheStability) {
  const Fsrs fsrs;
  EXPECT_EQ(fsrs.interval_days(8.2956), 8);
  EXPECT_EQ(fsrs.interval_days(300), 300);
  EXPECT_EQ(fsrs.interval_days(0.01), 1);
  EXPECT_EQ(fsrs.interval_days(1e6), 36500);
}

TEST(Fsrs, TheIntervalEndsWhereTheDesiredRetentionIsReached) {
  for (const double wanted : {0.80, 0.85, 0.9, 0.95, 0.97}) {
    FsrsSettings settings;
    settings.desired_retention = wanted;
    const auto fsrs = Fsrs::create(settings);
    ASSERT_TRUE(fsrs);
    const int interval = fsrs->interval_days(100);
    EXPECT_GE(fsrs->retrievability(100, interval - 0.51), wanted) << wanted;
    EXPECT_LE(fsrs->retrievability(100, interval + 0.51), wanted) << wanted;
  }
}

TEST(Fsrs, StepsLeadANewCardThroughMinutesToDays) {
  const Fsrs fsrs;
  Memory card = fsrs.next({}, Rating::again, kStart, 0);
  EXPECT_EQ(card.phase, Phase::learning);
  EXPECT_EQ(card.due - kStart, minutes(1));
  card = fsrs.next(card, Rating::good, kStart + minutes(1), 0);
  EXPECT_EQ(card.phase, Phase::learning);
  EXPECT_EQ(card.due - kStart, minutes(11));
  card = fsrs.next(card, Rating::good, kStart + minutes(11), 0);
  EXPECT_EQ(card.phase, Phase::review);
  EXPECT_GE(card.scheduled_days, 1);
  EXPECT_EQ(card.lapses, 0);
}

TEST(Fsrs, ForgettingIsALapseAndLeadsThroughTheRelearningStep) {
  const Fsrs fsrs;
  Memory card = fsrs.next({}, Rating::easy, kStart, 0);
  const double before = card.stability;
  card = fsrs.next(card, Rating::again, card.due, card.scheduled_days);
  EXPECT_EQ(card.phase, Phase::relearning);
  EXPECT_EQ(card.lapses, 1);
  EXPECT_LT(card.stability, before);
  EXPECT_EQ(card.due - *card.last_review, minutes(10));
}

TEST(Fsrs, AReviewAnsweredHardGoodEasyComesBackLaterEachTime) {
  const Fsrs fsrs;
  const Memory card = fsrs.next({}, Rating::easy, kStart, 0);
  int last = 0;
  for (const Rating rating : {Rating::hard, Rating::good, Rating::easy}) {
    const int interval = fsrs.next(card, rating, card.due, card.scheduled_days).scheduled_days;
    EXPECT_GT(interval, last);
    last = interval;
  }
}

TEST(Fsrs, StepsOfADayOrMoreAreIntervals) {
  FsrsSettings settings;
  settings.learning_steps = {minutes(10), minutes(2 * 24 * 60)};
  const auto fsrs = Fsrs::create(settings);
  ASSERT_TRUE(fsrs);
  const Memory card = fsrs->next({}, Rating::good, kStart, 0);
  EXPECT_EQ(card.phase, Phase::review);
  EXPECT_EQ(card.scheduled_days, 2);
  EXPECT_EQ(card.due - kStart, days(2));
}

TEST(Fsrs, WhatIsOutsideItsRangeIsNamed) {
  const auto refused = [](auto change) {
    FsrsSettings settings;
    change(settings);
    const auto fsrs = Fsrs::create(settings);
    EXPECT_FALSE(fsrs);
    return fsrs ? std::string() : fsrs.error().where;
  };
  EXPECT_EQ(refused([](auto& s) { s.desired_retention = 0.79; }), "desired retention");
  EXPECT_EQ(refused([](auto& s) { s.desired_retention = 0.98; }), "desired retention");
  EXPECT_EQ(refused([](auto& s) { s.desired_retention = NAN; }), "desired retention");
  EXPECT_EQ(refused([](auto& s) { s.maximum_interval_days = 0; }), "longest interval");
  EXPECT_EQ(refused([](auto& s) { s.learning_steps = {minutes(0)}; }), "learning steps");
  EXPECT_EQ(refused([](auto& s) { s.weights[3] = INFINITY; }), "weights");
}

TEST(Fsrs, IntervalsMayMoveByThePublishedRangesOnly) {
  // fuzz_range of the reference at these intervals, worked by hand: 1 + 0.15*4.5 + 0.1*3 = 1.975 at 10 days.
  const Fsrs fsrs;
  EXPECT_EQ(fsrs.fuzz_range(2, 0), (DayRange{2, 2}));
  EXPECT_EQ(fsrs.fuzz_range(10, 0), (DayRange{8, 12}));
  EXPECT_EQ(fsrs.fuzz_range(100, 0), (DayRange{93, 107}));
  EXPECT_EQ(fsrs.fuzz_range(10, 9), (DayRange{10, 12}));
  EXPECT_EQ(fsrs.fuzz_range(36500, 0).last, 36500);
  // 1 + 0.15*0.5, 1 + 0.15*2.5, 1 + 0.15*3.5, 1.675 + 0.1*8, 2.975 + 0.05*30.
  EXPECT_EQ(fsrs.fuzz_range(3, 0), (DayRange{2, 4}));
  EXPECT_EQ(fsrs.fuzz_range(5, 0), (DayRange{4, 6}));
  EXPECT_EQ(fsrs.fuzz_range(6, 0), (DayRange{4, 8}));
  EXPECT_EQ(fsrs.fuzz_range(15, 0), (DayRange{13, 17}));
  EXPECT_EQ(fsrs.fuzz_range(50, 0), (DayRange{46, 54}));
  // A review exactly after its interval has the same range as any other.
  EXPECT_EQ(fsrs.fuzz_range(10, 10), (DayRange{8, 12}));
}

TEST(FsrsWeights, AreReadAsAnkiShowsThem) {
  const auto weights = parse_weights(
      "[0.212, 1.2931, 2.3065, 8.2956, 6.4133, 0.8334, 3.0194,\n 0.001, 1.8722, 0.1666, 0.796, 1.4835,"
      " 0.0614, 0.2629, 1.6483, 0.6014, 1.8729, 0.5425, 0.0912, 0.0658, 0.1542]");
  ASSERT_TRUE(weights);
  EXPECT_EQ(*weights, kDefaultWeights);
}

TEST(FsrsWeights, OfOlderVersionsGetTheirDecay) {
  // Defaults of FSRS-5; the decay before FSRS-6 was 0.5 for all.
  const auto weights = parse_weights(
      "0.40255 1.18385 3.173 15.69105 7.1949 0.5345 1.4604 0.0046 1.54575 0.1192 1.01925 1.9395 "
      "0.11 0.29605 2.2698 0.2315 2.9898 0.51655 0.6621");
  ASSERT_TRUE(weights);
  EXPECT_EQ((*weights)[20], 0.5);
  EXPECT_EQ((*weights)[18], 0.6621);
}

TEST(FsrsWeights, BroughtToTheNewFormStayWithinTheirRange) {
  const auto weights = weights_from(std::array{0.4, 0.9, 2.3, 10.9, 4.93, 0.94, 3.9, 0.01, 1.49, 0.14, 0.94,
                                               2.18, 0.05, 0.34, 1.26, 0.29, 2.61});
  ASSERT_TRUE(weights);
  EXPECT_NEAR((*weights)[4], 6.81, 1e-12);
  EXPECT_NEAR((*weights)[5], std::log(3.82) / 3, 1e-12);
  EXPECT_EQ((*weights)[6], 4.0) << "3.9 + 0.5 is more than the optimiser allows";
  EXPECT_EQ(*weights_from(*weights), *weights);
}

TEST(FsrsWeights, ThatAreNoneAreRefusedWithTheReason) {
  EXPECT_EQ(parse_weights("1, 2, 3").error().what, "3 numbers");
  EXPECT_EQ(parse_weights("1, zwei").error().where, "zwei");
  EXPECT_EQ(parse_weights("").error().what, "0 numbers");
  EXPECT_FALSE(parse_weights("nan"));
}

}  // namespace
}  // namespace nazori::study
