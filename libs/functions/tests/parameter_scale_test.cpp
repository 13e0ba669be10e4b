// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/parameter_scale.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace nazori::functions {
namespace {

ParameterScale scale(double from, double to) { return ParameterScale({"a", from, from, to, true}); }

TEST(ParameterScale, StepsAreTheFinestRoundNumbersOfWhichTwoHundredSuffice) {
  struct Case {
    double from, to, step;
    int steps, decimals;
  };
  for (const Case& c : {Case{-10, 10, 0.1, 200, 1}, Case{0, 3, 0.02, 150, 2}, Case{0, 1, 0.005, 200, 3},
                        Case{0, 1.1, 0.01, 110, 2}, Case{1, 201, 1, 200, 0}, Case{0, 201, 2, 101, 0},
                        Case{0, 1e6, 5000, 200, 0}, Case{-2e-9, 2e-9, 2e-11, 200, 11}}) {
    const auto s = scale(c.from, c.to);
    EXPECT_DOUBLE_EQ(s.step(), c.step) << c.from << " to " << c.to;
    EXPECT_EQ(s.steps(), c.steps) << c.from << " to " << c.to;
    EXPECT_EQ(s.decimals(), c.decimals) << c.from << " to " << c.to;
  }
}

TEST(ParameterScale, ValuesAreTheDecimalNumbersThatOneWouldType) {
  EXPECT_EQ(scale(0, 3).value_at(15), 0.3);
  EXPECT_EQ(scale(-10, 10).value_at(103), 0.3);
  EXPECT_EQ(scale(-10, 10).value_at(100), 0.0);
  EXPECT_EQ(scale(-10, 10).value_at(97), -0.3);
  EXPECT_EQ(scale(0, 1).value_at(147), 0.735);
  EXPECT_EQ(scale(0, 1e6).value_at(3), 15000);
}

TEST(ParameterScale, TheEndsAreThoseOfTheRangeAlsoWhereTheyAreNotRound) {
  const auto s = scale(std::numbers::pi / 7, std::numbers::pi);
  EXPECT_EQ(s.value_at(0), std::numbers::pi / 7);
  EXPECT_EQ(s.value_at(-1), std::numbers::pi / 7);
  EXPECT_EQ(s.value_at(s.steps()), std::numbers::pi);
  EXPECT_EQ(s.value_at(s.steps() + 1), std::numbers::pi);
  EXPECT_EQ(s.value_at(1), 0.46);  // pi / 7 = 0.4488, steps of 0.02
}

TEST(ParameterScale, EachPlaceHasAGreaterValueThanTheOneBeforeAndIsFoundByIt) {
  for (const auto& s : {scale(-10, 10), scale(0, std::numbers::pi), scale(-1e308, 1e308), scale(-2.7, 1e-3),
                        scale(1e-300, 2e-300)}) {
    for (int place = 1; place <= s.steps(); ++place) {
      ASSERT_TRUE(std::isfinite(s.value_at(place)));
      ASSERT_GT(s.value_at(place), s.value_at(place - 1)) << place;
      ASSERT_EQ(s.place_of(s.value_at(place)), place);
    }
  }
}

TEST(ParameterScale, AValueBetweenTwoPlacesBelongsToTheNearerOne) {
  const auto s = scale(-10, 10);
  EXPECT_EQ(s.place_of(0.149), 101);
  EXPECT_EQ(s.place_of(0.151), 102);
  EXPECT_EQ(s.place_of(-11), 0);
  EXPECT_EQ(s.place_of(11), 200);
}

TEST(ParameterScale, AnEmptyRangeHasOnePlace) {
  const auto s = scale(2, 2);
  EXPECT_EQ(s.steps(), 0);
  EXPECT_EQ(s.value_at(0), 2);
  EXPECT_EQ(s.place_of(5), 0);
}

}  // namespace
}  // namespace nazori::functions
