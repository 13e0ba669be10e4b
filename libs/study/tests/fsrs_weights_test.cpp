// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "nazori/study/fsrs.h"

namespace nazori::study {
namespace {

/// The ranges of ts-fsrs 5.4.2 (CLAMP_PARAMETERS) and fsrs-rs, where the ceiling of w17 and w18 is 2.
struct Range {
  double lowest, highest;
};
constexpr std::array<Range, 21> kPublished{
    {{0.001, 100.0}, {0.001, 100.0}, {0.001, 100.0}, {0.001, 100.0}, {1.0, 10.0},  {0.001, 4.0},
     {0.001, 4.0},   {0.001, 0.75},  {0.0, 4.5},     {0.0, 0.8},     {0.001, 3.5}, {0.001, 5.0},
     {0.001, 0.25},  {0.001, 0.9},   {0.0, 4.0},     {0.0, 1.0},     {1.0, 6.0},   {0.0, 2.0},
     {0.0, 2.0},     {0.0, 0.8},     {0.1, 0.8}}};

TEST(FsrsWeights, AreBroughtIntoThePublishedRanges) {
  const auto low = weights_from(std::vector<double>(21, -1'000));
  const auto high = weights_from(std::vector<double>(21, 1'000));
  ASSERT_TRUE(low && high);
  for (std::size_t i = 0; i < kPublished.size(); ++i) {
    EXPECT_EQ(low->at(i), kPublished.at(i).lowest) << i;
    EXPECT_EQ(high->at(i), kPublished.at(i).highest) << i;
  }
  const auto own = weights_from(kDefaultWeights);
  ASSERT_TRUE(own);
  EXPECT_EQ(*own, kDefaultWeights) << "those of the optimiser stay";
}

TEST(FsrsWeights, OfNineteenKeepTheirNumbersAndGetNoOthers) {
  std::vector<double> numbers(kDefaultWeights.begin(), kDefaultWeights.begin() + 19);
  const auto weights = weights_from(numbers);
  ASSERT_TRUE(weights);
  for (std::size_t i = 0; i < numbers.size(); ++i) EXPECT_EQ(weights->at(i), numbers[i]) << i;
  EXPECT_EQ((*weights)[19], 0);
  EXPECT_EQ((*weights)[20], 0.5);
}

TEST(FsrsWeights, OfSeventeenAreBroughtToTheNewForm) {
  // As fsrs-rs does: w4 + 2 w5, ln(3 w5 + 1) / 3, w6 + 0.5; no gain on the same day.
  std::vector<double> numbers(kDefaultWeights.begin(), kDefaultWeights.begin() + 17);
  numbers[4] = 5;
  numbers[5] = 1.5;
  numbers[6] = 2;
  const auto weights = weights_from(numbers);
  ASSERT_TRUE(weights);
  for (const std::size_t i : {0U, 1U, 2U, 3U, 7U, 8U, 9U, 10U, 11U, 12U, 13U, 14U, 15U, 16U})
    EXPECT_EQ(weights->at(i), numbers.at(i)) << i;
  EXPECT_EQ((*weights)[4], 8);
  EXPECT_NEAR((*weights)[5], std::log(5.5) / 3, 1e-12);
  EXPECT_EQ((*weights)[6], 2.5);
  for (const std::size_t i : {17U, 18U, 19U}) EXPECT_EQ(weights->at(i), 0) << i;
  EXPECT_EQ((*weights)[20], 0.5);
  // Values far outside are first limited to their range.
  numbers[5] = 1'000;
  EXPECT_NEAR((*weights_from(numbers))[5], std::log(13) / 3, 1e-12);
  EXPECT_EQ((*weights_from(numbers))[4], 10);
}

TEST(FsrsWeights, OfAnotherCountAreNone) {
  for (std::size_t count = 0; count < 30; ++count) {
    const auto weights = weights_from(std::vector<double>(count, 1));
    EXPECT_EQ(weights.has_value(), count == 17 || count == 19 || count == 21) << count;
    if (!weights) {
      EXPECT_EQ(weights.error().what, std::to_string(count) + " numbers");
    }
  }
}

TEST(FsrsWeights, ThatNeverEndAreNotReadToTheirEnd) {
  std::string text;
  for (int i = 0; i < 22; ++i) text += "0.5,";
  EXPECT_EQ(parse_weights(text).error().what, "22 numbers");
  EXPECT_EQ(parse_weights(text + "0.75, 0.5").error().where, "0.75");
}

TEST(FsrsWeights, AreTakenWithWhateverStandsBetweenThem) {
  std::string text = "[";
  for (int i = 0; i < 21; ++i) text += std::string("1") + ",; \t\r\n][,"[i % 9] + " ";
  EXPECT_EQ(parse_weights(text), weights_from(std::vector<double>(21, 1)));
  EXPECT_EQ(parse_weights("1.5x, 2").error().where, "1.5x");
  EXPECT_EQ(parse_weights("2 x").error().where, "x");
  EXPECT_EQ(parse_weights("1e999").error().where, "1e999");
  // A very long word is not repeated completely.
  EXPECT_EQ(parse_weights("1, " + std::string(50, 'y')).error().where, std::string(40, 'y'));
}

}  // namespace
}  // namespace nazori::study
