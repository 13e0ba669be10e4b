// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/placement_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>

namespace nazori::practice {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

std::vector<char32_t> list_of(int count) {
  std::vector<char32_t> list(static_cast<std::size_t>(count));
  std::iota(list.begin(), list.end(), U'一');
  return list;
}

/// Asks a learner until the check is over, at eight seconds an answer.
template <class Answers>
PlacementCheck check(int count, Answers&& answers, const PlacementRates& rates = {}) {
  PlacementCheck check(list_of(count), rates);
  milliseconds elapsed(0);
  while (const auto question = check.question())
    check.answer(answers(static_cast<int>(*question - U'一')), elapsed += seconds(8));
  return check;
}

/// A learner who can write the first `ability` characters, no others, and never makes a mistake in them.
auto exact_learner(int ability) {
  return [ability](int position) {
    return position < ability ? PlacementAnswer::written : PlacementAnswer::unknown;
  };
}

/// Rates that leave no doubt: every answer is the truth.
constexpr PlacementRates kNoDoubt{0, 0, 0, 0};

TEST(PlacementCheck, FindsTheExactPlaceByHalvingWhereEveryAnswerIsTrue) {
  for (const int count : {20, 200, 2'136})
    for (int ability = 0; ability <= count; ability += std::max(1, count / 61)) {
      const auto done = check(count, exact_learner(ability), kNoDoubt);
      // Twelve halvings of the scale leave no more than two positions near the end of the longest list.
      EXPECT_NEAR(done.ability(), ability, count > 1'000 ? 2 : 0) << count;
      EXPECT_LE(done.answered(), PlacementCheck::kMost);
    }
}

TEST(PlacementCheck, BeginsWhereTheScaleIsHalved) {
  // u(x) = log(1 + 16 x / n) is half of u(n) at x = n (sqrt(17) - 1) / 16.
  const int count = 2'136;
  const PlacementCheck check(list_of(count));
  EXPECT_NEAR(static_cast<int>(*check.question() - U'一'), count * (std::sqrt(17.0) - 1) / 16, 1.5);
}

TEST(PlacementCheck, EndsAfterTwelveToFourteenQuestionsAndAsksNoneTwice) {
  for (int ability = 0; ability <= 2'136; ability += 89) {
    std::vector<int> asked;
    const auto done = check(2'136, [&](int position) {
      asked.push_back(position);
      return exact_learner(ability)(position);
    });
    EXPECT_GE(done.answered(), PlacementCheck::kFewest);
    EXPECT_LE(done.answered(), PlacementCheck::kMost);
    std::sort(asked.begin(), asked.end());
    EXPECT_EQ(std::adjacent_find(asked.begin(), asked.end()), asked.end());
  }
}

/// Calls `look` after each answer of learners who know the first characters of a list with some luck.
template <class Look>
void answer_at_random(int count, int ability, Look&& look) {
  for (unsigned learner = 0; learner < 30; ++learner) {
    std::mt19937 random(learner);
    PlacementCheck check(list_of(count));
    while (const auto question = check.question()) {
      const bool knows = static_cast<int>(*question - U'一') < ability;
      const bool is_luck = random() % 10 == 0;
      check.answer(knows != is_luck ? PlacementAnswer::written : PlacementAnswer::unknown, seconds(1));
      look(check);
    }
  }
}

TEST(PlacementCheck, EndsFromTheTwelfthAnswerOnWhereHalfOfWhatIsProbableIsNarrow) {
  const int count = 2'136;
  const auto scale = [](int position) { return std::log1p(16.0 * position / count); };
  int early = 0, late = 0;
  for (const int ability : {20, 150, 700, 1'500})
    answer_at_random(count, ability, [&](const PlacementCheck& check) {
      const bool is_narrow = scale(check.quantile(0.75)) - scale(check.quantile(0.25)) < 0.15;
      const bool ends = check.answered() == 14 || (check.answered() >= 12 && is_narrow);
      EXPECT_EQ(check.is_over(), ends) << check.answered();
      if (check.is_over()) ++(check.answered() < 14 ? early : late);
    });
  EXPECT_GT(early, 5);
  EXPECT_GT(late, 5);
}

TEST(PlacementCheck, SaysNoneWhereItIsNotCertainThatAnyCanBeWritten) {
  int doubtful = 0, certain = 0;
  for (const int ability : {0, 1, 2, 4, 9})
    answer_at_random(46, ability, [&](const PlacementCheck& check) {
      if (check.ability() == 0) return;
      const bool may_be_none = check.quantile(0.05) == 0;
      EXPECT_EQ(check.rounded_ability() == 0, may_be_none) << check.ability();
      ++(may_be_none ? doubtful : certain);
    });
  EXPECT_GT(doubtful, 5);
  EXPECT_GT(certain, 5);
}

TEST(PlacementCheck, AfterTwoMinutesTheEighthQuestionIsTheLast) {
  PlacementCheck check(list_of(500));
  check.answer(PlacementAnswer::written, seconds(60));
  check.answer(PlacementAnswer::unknown, seconds(119));
  ASSERT_FALSE(check.is_over());
  for (int i = 3; i <= 8; ++i) {
    ASSERT_FALSE(check.is_over()) << "fewer than eight answers place nobody well";
    check.answer(PlacementAnswer::written, seconds(120 + i));
  }
  EXPECT_TRUE(check.is_over());
  EXPECT_EQ(check.answered(), 8);
  check.answer(PlacementAnswer::written, seconds(140));
  EXPECT_EQ(check.answered(), 8) << "what comes later does not count";
}

TEST(PlacementCheck, OfAShortListAsksForEachCharacterOnce) {
  EXPECT_TRUE(PlacementCheck({}).is_over());
  EXPECT_EQ(PlacementCheck({}).ability(), 0);
  EXPECT_EQ(check(1, exact_learner(1)).ability(), 1);
  EXPECT_EQ(check(1, exact_learner(0)).ability(), 0);
  EXPECT_EQ(check(5, exact_learner(3)).answered(), 5);
  EXPECT_EQ(check(5, exact_learner(3)).ability(), 3);
}

TEST(PlacementCheck, SaysTheSameToTheSameAnswers) {
  const auto answers = [](int position) {
    return position % 3 == 0 ? PlacementAnswer::refused : PlacementAnswer::written;
  };
  EXPECT_EQ(check(700, answers).ability(), check(700, answers).ability());
}

TEST(PlacementCheck, OneSlipDoesNotThrowTheLearnerBackToTheBeginning) {
  for (int slip = 0; slip < 5; ++slip) {
    int question = 0;
    const auto done = check(2'136, [&](int position) {
      return question++ == slip && position < 1'000 ? PlacementAnswer::refused
                                                    : exact_learner(1'000)(position);
    });
    EXPECT_NEAR(done.ability(), 1'000, 300) << slip;
  }
}

TEST(PlacementCheck, NobodyWhoWritesNothingIsSaidToKnowAnything) {
  for (const int count : {46, 200, 2'136}) EXPECT_EQ(check(count, exact_learner(0)).rounded_ability(), 0);
  EXPECT_NEAR(check(2'136, exact_learner(2'136)).ability(), 2'136, 150);
}

TEST(PlacementCheck, IsRoundedAsPeopleSayIt) {
  const auto rounded = [](int ability, int count) {
    return check(count, exact_learner(ability), kNoDoubt).rounded_ability();
  };
  EXPECT_EQ(rounded(7, 500), 7);
  EXPECT_EQ(rounded(42, 500), 40);
  EXPECT_EQ(rounded(43, 500), 45);
  EXPECT_EQ(rounded(314, 500), 310);
  EXPECT_EQ(rounded(316, 500), 320);
  EXPECT_EQ(rounded(118, 118), 118) << "not more than there are";
}

/// The share of simulated learners who are placed within share * (ability + n / 16) + 1 of the truth.
double placed_within(double share, int count, int ability, double spread) {
  // The numbers of mt19937 are the same on every computer, those of distributions are not.
  std::mt19937 random(static_cast<unsigned>(count * 31 + ability));
  const auto chance = [&random] { return static_cast<double>(random()) / 4294967296.0; };
  const auto scale = [count](double position) { return std::log1p(16.0 * position / count); };
  const PlacementRates rates;
  int within = 0;
  constexpr int kLearners = 200;
  for (int learner = 0; learner < kLearners; ++learner) {
    const auto done = check(count, [&](int position) {
      const double known = spread > 0 ? 1 / (1 + std::exp((scale(position + 0.5) - scale(ability)) / spread))
                                      : (position < ability ? 1 : 0);
      const bool knows = chance() < known;
      if (chance() < (knows ? 1 - rates.slip - rates.modest : rates.luck)) return PlacementAnswer::written;
      return chance() < (knows ? rates.modest / (rates.slip + rates.modest) : 0.5) ? PlacementAnswer::unknown
                                                                                   : PlacementAnswer::refused;
    });
    if (std::abs(done.ability() - ability) <= share * (ability + count / 16.0) + 1) ++within;
  }
  return within / static_cast<double>(kLearners);
}

TEST(PlacementCheck, PlacesNineOfTenLearnersWhoSlipAndAreLuckyWithinATenth) {
  for (const int count : {46, 2'136})
    for (const int ability : {0, count / 27, count / 7, count / 3, count / 2, count * 3 / 4})
      EXPECT_GE(placed_within(0.1, count, ability, 0), 0.85) << ability << " of " << count;
}

TEST(PlacementCheck, PlacesNineOfTenLearnersWhoseKnowledgeEndsGraduallyWithinAQuarter) {
  for (const int count : {46, 2'136})
    for (const int ability : {0, count / 27, count / 7, count / 3, count / 2, count * 3 / 4, count})
      EXPECT_GE(placed_within(0.25, count, ability, PlacementRates{}.spread), 0.85)
          << ability << " of " << count;
}

}  // namespace
}  // namespace nazori::practice
