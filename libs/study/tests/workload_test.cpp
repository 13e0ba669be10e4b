// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "../src/usual_ratings.h"
#include "nazori/study/statistics.h"

namespace nazori::study {
namespace {

using std::chrono::milliseconds;

/// Counts the results of a quarter of a million equally spaced random numbers.
template <class Rate>
std::array<double, 5> shares(Rate rate) {
  constexpr int kDice = 250'000;
  std::array<double, 5> counts{};
  for (int i = 0; i < kDice; ++i) counts.at(static_cast<std::size_t>(rate((i + 0.5) / kDice))) += 1.0 / kDice;
  return counts;
}

TEST(UsualRatings, AreThoseOfTheFsrsOptimizer) {
  // Its simulator: first_rating_prob = [0.24, 0.094, 0.495, 0.171], review_rating_prob = [0.224, 0.631,
  // 0.145].
  const auto first = shares(first_rating);
  EXPECT_NEAR(first[1], 0.24, 1e-5);
  EXPECT_NEAR(first[2], 0.094, 1e-5);
  EXPECT_NEAR(first[3], 0.495, 1e-5);
  EXPECT_NEAR(first[4], 0.171, 1e-5);
  const auto recalled = shares([](double grade) { return next_rating(0.9, 0.5, grade); });
  EXPECT_EQ(recalled[1], 0);
  EXPECT_NEAR(recalled[2], 0.224, 1e-5);
  EXPECT_NEAR(recalled[3], 0.631, 1e-5);
  EXPECT_NEAR(recalled[4], 0.145, 1e-5);
  EXPECT_NEAR(shares([](double dice) { return next_rating(0.9, dice, 0.5); })[1], 0.1, 1e-5);
  EXPECT_EQ(next_rating(1, 0.999, 0.5), Rating::good);
  EXPECT_EQ(next_rating(0, 0, 0.5), Rating::again) << "what is surely forgotten";
}

/// After the first answer, whichever it is, the stability is so high that nothing is due within a year.
FsrsSettings known_at_once() {
  FsrsSettings settings;
  settings.desired_retention = 0.8;
  for (const std::size_t i : {0U, 1U, 2U, 3U}) settings.weights[i] = 100;
  settings.weights[17] = settings.weights[18] = 0;
  settings.weights[19] = 0.01;
  settings.weights[20] = 0.1;
  return settings;
}

TEST(Workload, OfWhatIsNotReviewedIsMeetingItOnly) {
  FsrsSettings settings = known_at_once();
  settings.learning_steps.clear();
  const Fsrs fsrs = *Fsrs::create(settings);
  ASSERT_GT(fsrs.interval_days(100), 365);
  const Pace pace{milliseconds(0), milliseconds(0), milliseconds(90'000)};
  const auto workload = expected_workload(settings, 3, pace);
  ASSERT_TRUE(workload);
  EXPECT_EQ(workload->reviews_per_day, 0);
  EXPECT_NEAR(workload->minutes_per_day, 4.5, 1e-9);
  // Those of the first day were introduced 365 days ago, those of the last one yesterday.
  double known = 0;
  for (int ago = 1; ago <= 365; ++ago) known += 3 * fsrs.retrievability(100, ago);
  EXPECT_NEAR(workload->known, known, 1e-6);
}

TEST(Workload, StepsAreReviewsOfTheDayTheCharacterIsMet) {
  // A step succeeds in nine of ten cases, otherwise the card starts over. Expected reviews from the first and
  // from the second of two steps: e0 = 1 + 0.9 e1 + 0.1 e0 and e1 = 1 + 0.1 e0.
  const double e0 = (1 + 0.9) / (1 - 0.1 - 0.9 * 0.1);
  const double e1 = 1 + 0.1 * e0;
  const double each = (0.24 + 0.094) * e0 + 0.495 * e1;
  constexpr int kNew = 100;
  const auto workload = expected_workload(known_at_once(), kNew, {});
  ASSERT_TRUE(workload);
  EXPECT_NEAR(workload->reviews_per_day, kNew * each, 3);  // four standard deviations
  // A card or two fails again and again, and comes back within the year.
  EXPECT_NEAR(workload->minutes_per_day, kNew * 3, 0.1) << "they take no time of their own";
}

TEST(Workload, EachReviewTakesAsLongAsItsOutcome) {
  FsrsSettings settings;
  settings.learning_steps.clear();
  settings.relearning_steps.clear();
  const auto seconds = [&](int recalled, int failed) {
    const Pace pace{milliseconds(recalled), milliseconds(failed), milliseconds(0)};
    return expected_workload(settings, 20, pace)->minutes_per_day * 60;
  };
  const double reviews = expected_workload(settings, 20)->reviews_per_day;
  const double recalled = seconds(1'000, 0);
  const double failed = seconds(0, 1'000);
  EXPECT_NEAR(recalled + failed, reviews, 1e-6);
  // Each is due when its probability has fallen to nine tenths; with short intervals a little later or
  // earlier.
  EXPECT_NEAR(failed / reviews, 0.1, 0.03);
  EXPECT_NEAR(seconds(2'000, 3'000), 2 * recalled + 3 * failed, 1e-6);
}

TEST(Workload, IsAskedForUpToAHundredNewCharacters) {
  EXPECT_TRUE(expected_workload({}, 0));
  EXPECT_TRUE(expected_workload(known_at_once(), 100));
  EXPECT_EQ(expected_workload({}, 101).error().where, "new characters a day");
  EXPECT_EQ(expected_workload({}, -1).error().where, "new characters a day");
  FsrsSettings wrong;
  wrong.desired_retention = 0.5;
  EXPECT_FALSE(expected_workload(wrong, 5));
}

}  // namespace
}  // namespace nazori::study
