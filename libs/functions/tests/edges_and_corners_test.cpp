// SPDX-License-Identifier: Apache-2.0
// What is told at the edges of steps and domains and in the corners of curves; each fact is derived by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "nazori/functions/points.h"

namespace nazori::functions {
namespace {

struct Told {
  std::vector<PointOfInterest> points;
  int pieces = 0;

  [[nodiscard]] std::vector<std::string> of(PointKind kind, Language language = Language::english) const {
    std::vector<std::string> all;
    for (const PointOfInterest& p : points) {
      if (p.kind == kind) all.push_back(in_words(p, language));
    }
    return all;
  }
};

Told told_of(const std::string& text, const Window& window) {
  const auto plot = parse(text);
  EXPECT_TRUE(plot) << text;
  if (!plot) return {};
  const auto tracing = trace(*plot, window);
  EXPECT_TRUE(tracing) << text;
  if (!tracing) return {};
  return {points_of_interest(*plot, *tracing), pieces(*plot, *tracing)};
}

using Lines = std::vector<std::string>;
constexpr Window kSmall{-2.1, 2, -2.2, 2};

TEST(EdgesOfSteps, TheValueAtAnIrrationalEdgeIsThatOfTheStepItself) {
  EXPECT_EQ(told_of("y = floor(x^2)", {-0.5, 1.6, -1, 5}).of(PointKind::jump),
            (Lines{"jump at x = 1, from y = 0 to y = 1, the value is 1",
                   "jump at x = the square root of 2, about 1.414, from y = 1 to y = 2, the value is 2"}));
  EXPECT_EQ(told_of("y = sign(sin(x))", {1, 5, -2, 2}).of(PointKind::jump),
            (Lines{"jump at x = pi, about 3.142, from y = 1 to y = minus 1, the value is 0"}));
}

TEST(EdgesOfSteps, RoundingStepsAtTheHalves) {
  const Lines jumps = told_of("y = round(x) + x/9", {0.1, 1.9, -1, 4}).of(PointKind::jump);
  ASSERT_EQ(jumps.size(), 2U);
  EXPECT_EQ(jumps[0].find("jump at x = 1 over 2"), 0U) << jumps[0];
  EXPECT_EQ(jumps[1].find("jump at x = 3 over 2"), 0U) << jumps[1];
}

TEST(SlantedAsymptotes, AreLinesInWords) {
  const auto line = [](const char* text) {
    const Lines lines = told_of(text, {-9, 9, -9, 9}).of(PointKind::slanted_asymptote);
    return lines.size() == 1 ? lines[0] : std::to_string(lines.size());
  };
  EXPECT_EQ(line("y = x^2/(x - 1)"), "slanted asymptote y = x plus 1");
  EXPECT_EQ(line("y = x^2/(x + 1)"), "slanted asymptote y = x minus 1");
  EXPECT_EQ(line("y = 2 - x + 1/x"), "slanted asymptote y = minus x plus 2");
  EXPECT_EQ(line("y = 3x + 1/x"), "slanted asymptote y = 3 times x");
}

TEST(EdgesOfSteps, AStepThatIsOnlyTouchedLeavesAHoleAndAPoint) {
  const Told told = told_of("y = floor(sin(x))", {0.5, 3, -2, 2});
  EXPECT_EQ(told.of(PointKind::hole), (Lines{"hole at x = pi over 2, about 1.571; y = 0"}));
  EXPECT_EQ(told.of(PointKind::isolated), (Lines{"isolated point at x = pi over 2, about 1.571; y = 1"}));
}

TEST(EdgesOfSteps, BesideATouchedStepTheOtherEdgesAreTold) {
  EXPECT_EQ(told_of("y = floor(sin(x))", {-7.7, 7.7, -3, 3}).of(PointKind::jump).size(), 5U);
}

TEST(EdgesOfSteps, AZeroThatIsTakenOnlyAtTheEdgeCounts) {
  const Told told = told_of("y = ceil(x) - floor(x)", {-1.5, 1.5, -1, 2});
  EXPECT_EQ(told.of(PointKind::zero),
            (Lines{"zero at x = minus 1; y = 0", "zero at x = 0; y = 0", "zero at x = 1; y = 0"}));
  EXPECT_EQ(told.of(PointKind::y_intercept), (Lines{"y intercept at x = 0; y = 0"}));
}

TEST(EdgesOfSteps, AStepInADenominatorIsUndefinedOnlyWhereItIsZero) {
  EXPECT_EQ(told_of("y = x/floor(x)", {1.5, 2.5, 0, 3}).of(PointKind::jump),
            (Lines{"jump at x = 2, from y = 2 to y = 1, the value is 1"}));
}

TEST(EdgesOfSteps, TheSidesOfAJumpAreLimitsAndNotNeighbouringValues) {
  EXPECT_EQ(told_of("y = sqrt(x - floor(x))", {0.5, 1.5, -1, 2}).of(PointKind::jump),
            (Lines{"jump at x = 1, from y = 1 to y = 0, the value is 0"}));
  EXPECT_TRUE(told_of("y = sign(x)*sqrt(|x|)", {-4, 4, -3, 3}).of(PointKind::jump).empty());
}

TEST(EdgesOfSteps, ALevelPieceThatRoundingMovesOffTheAxisHasNoZero) {
  EXPECT_TRUE(told_of("y = sin(floor(x)*pi/2)", {-4.4, 4.4, -2, 2}).of(PointKind::zero).empty());
}

TEST(EdgesOfDomains, HolesHaveExactPlacesAndLimits) {
  EXPECT_EQ(told_of("y = (x^2 - x - 6)/(x^2 - 4x + 3)", {-6, 8, -7, 7}).of(PointKind::hole),
            (Lines{"hole at x = 3; y = 5 over 2, about 2.5"}));
  EXPECT_EQ(told_of("y = (x - pi)/sin(x)", {1, 5, -8, 8}).of(PointKind::hole),
            (Lines{"hole at x = pi, about 3.142; y = minus 1"}));
}

TEST(EdgesOfDomains, AZeroAtTheEndOfTheDomainCounts) {
  EXPECT_EQ(told_of("y = acosh(x)", {-1, 4, -1, 4}).of(PointKind::zero), (Lines{"zero at x = 1; y = 0"}));
  EXPECT_EQ(told_of("y = acos(x^2)", {-2, 2, -1, 3}).of(PointKind::zero),
            (Lines{"zero at x = minus 1; y = 0", "zero at x = 1; y = 0"}));
  EXPECT_EQ(told_of("y = sin(x) {pi <= x <= 2pi}", {2, 8, -2, 2}).of(PointKind::zero),
            (Lines{"zero at x = pi, about 3.142; y = 0", "zero at x = 2 pi, about 6.283; y = 0"}));
}

TEST(EdgesOfDomains, EveryPoleOfADenominatorThatTouchesZeroIsTold) {
  EXPECT_EQ(told_of("y = 1/(1 + sin(x))", {-8.5, 8, -1, 9}).of(PointKind::vertical_asymptote).size(), 3U);
  EXPECT_EQ(told_of("y = sin(x)/(1 - cos(x))", {-8, 8, -7, 7}).of(PointKind::vertical_asymptote).size(), 3U);
}

TEST(EdgesOfDomains, AJumpOverZeroIsNoZero) {
  EXPECT_TRUE(told_of("y = |sin(x)|/sin(x)", {-5, 5, -2, 2}).of(PointKind::zero).empty());
  EXPECT_EQ(told_of("y = sqrt(1 - floor(x)^2)", {-3.3, 3.3, -1, 2}).of(PointKind::y_intercept),
            (Lines{"y intercept at x = 0; y = 1"}));
}

TEST(EdgesOfDomains, AnEndThatIsReachedSlowlyIsTold) {
  EXPECT_EQ(told_of("y = 1/ln(x)", {-1, 7, -6, 6}).of(PointKind::end), (Lines{"end at x = 0; y = 0"}));
}

TEST(EdgesOfDomains, BesideHolesAndVanishingValuesThereAreNoFalsePoints) {
  EXPECT_TRUE(told_of("y = (1 - sin(x))/cos(x)", {-8, 8, -6, 6}).of(PointKind::inflection).empty());
  EXPECT_TRUE(told_of("y = x e^(1/x)", {-5, 5, -6, 9}).of(PointKind::maximum).empty());
}

TEST(Zeros, OfHighOrderAtMultiplesOfPiHaveTheirNames) {
  EXPECT_EQ(told_of("y = 2sin(x) - sin(2x)", {5, 8, -4, 4}).of(PointKind::zero),
            (Lines{"zero at x = 2 pi, about 6.283; y = 0"}));
}

TEST(Corners, OfAnEquationAreExtremaAndNoCusps) {
  const Told rhombus = told_of("|x| + |y| = 1", kSmall);
  EXPECT_EQ(rhombus.of(PointKind::maximum), (Lines{"maximum at x = 0; y = 1"}));
  EXPECT_EQ(rhombus.of(PointKind::minimum), (Lines{"minimum at x = 0; y = minus 1"}));
  EXPECT_TRUE(rhombus.of(PointKind::cusp).empty());
  EXPECT_TRUE(told_of("max(|x|, |y|) = 1", {-2, 2, -2, 2}).of(PointKind::cusp).empty());
  // Above the origin the two circles meet in a corner that points down.
  const Told circles = told_of("x^2 + y^2 = |x| + |y|", kSmall);
  EXPECT_EQ(circles.of(PointKind::minimum).size(), 3U);
  EXPECT_TRUE(std::any_of(circles.points.begin(), circles.points.end(), [](const PointOfInterest& p) {
    return p.kind == PointKind::minimum && p.x == 0 && std::abs(p.y - 1) < 1e-12;
  }));
}

TEST(Corners, WhereTheGradientIsInfiniteCuspsAreTold) {
  EXPECT_EQ(told_of("x^(2/3) + y^(2/3) = 1", kSmall).of(PointKind::cusp).size(), 4U);
  EXPECT_EQ(told_of("sqrt(|x|) + sqrt(|y|) = 1", kSmall).of(PointKind::cusp).size(), 4U);
  EXPECT_TRUE(told_of("sqrt(x) + sqrt(y) = 1", kSmall).of(PointKind::isolated).empty());
}

TEST(Corners, ACuspThatPointsDownIsAMinimum) {
  EXPECT_EQ(told_of("y^3 = x^2", {-3, 3, -3, 3}).of(PointKind::minimum), (Lines{"minimum at x = 0; y = 0"}));
}

TEST(LevelPlaces, BesideADegeneratePointAllAreFound) {
  EXPECT_EQ(told_of("(x^2 + y^2)^2 = x y", {-1, 1, -1, 1}).of(PointKind::maximum).size(), 1U);
  const Told leaves = told_of("(x^2 + y^2)^3 = 4x^2 y^2", {-1.5, 1.5, -1.5, 1.5});
  EXPECT_EQ(leaves.of(PointKind::maximum).size(), 2U);
  EXPECT_EQ(leaves.of(PointKind::self_crossing), (Lines{"self-crossing at x = 0; y = 0"}));
}

TEST(LevelPlaces, AFlatTopIsAMaximum) {
  EXPECT_EQ(told_of("x^4 + y^4 = 1", kSmall).of(PointKind::maximum), (Lines{"maximum at x = 0; y = 1"}));
}

TEST(LevelPlaces, WhereACurveTurnsRoundAndGoesBackItEnds) {
  const Told told = told_of("x = cos(t)^2; y = sin(t)", {-2, 2, -2, 2});
  EXPECT_TRUE(told.of(PointKind::maximum).empty());
  EXPECT_EQ(told.of(PointKind::end).size(), 2U);
}

TEST(Pieces, RegionsThatMeetInAPointAreOneOnlyIfItBelongsToThem) {
  EXPECT_EQ(told_of("x y > 0", kSmall).pieces, 2);
  EXPECT_EQ(told_of("x y >= 0", kSmall).pieces, 1);
  EXPECT_EQ(told_of("(y - 0.21)^2 < (x - 0.4)^2", kSmall).pieces, 2);
  EXPECT_EQ(told_of("x^2 + y^2 < 1", kSmall).pieces, 1);
}

TEST(Pieces, TheTipOfANarrowCuspBelongsToItsArms) {
  EXPECT_EQ(told_of("y^2 = x^7", {-1, 2, -3, 3}).pieces, 1);
}

TEST(SidesOfAsymptotes, OfACurveOverYAreAboveAndBelow) {
  const Told exponential = told_of("x = e^y", {-2, 6, -4, 4});
  EXPECT_EQ(exponential.of(PointKind::vertical_asymptote),
            (Lines{"vertical asymptote at x = 0, far below only"}));
  EXPECT_EQ(exponential.of(PointKind::vertical_asymptote, Language::japanese),
            (Lines{"垂直漸近線: x = 0（下の遠くだけ）"}));
  EXPECT_EQ(told_of("x = ln(y)", {-4, 4, -2, 6}).of(PointKind::horizontal_asymptote),
            (Lines{"horizontal asymptote at y = 0, above it only"}));
}

TEST(NumbersInWords, AreNeverPowersOfTen) {
  EXPECT_EQ(told_of("y = 10^6 sin(x)", {0.5, 3, -2e6, 2e6}).of(PointKind::maximum),
            (Lines{"maximum at x = pi over 2, about 1.571; y = 1000000"}));
  EXPECT_EQ(place_in_words(0.0000012345, 1234567, Language::english),
            "x = about 0.000001234; y = about 1235000");
}

}  // namespace
}  // namespace nazori::functions
