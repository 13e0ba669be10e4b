// SPDX-License-Identifier: Apache-2.0
#include "../src/width_profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace nazori::carving {
namespace {

/// A profile whose width and, as a part of that, depth are given at some places.
WidthProfile profile(const std::vector<double>& s, const std::vector<double>& values) {
  std::vector<WidthKnot> knots;
  for (std::size_t i = 0; i < s.size(); ++i) knots.push_back({s[i], values[i], 0.1 * values[i]});
  return WidthProfile(std::move(knots));
}

/// The slope of the width at a place, to one side.
double slope(const WidthProfile& p, double s, double side) {
  constexpr double kStep = 1e-6;
  return (p.at(s + side * kStep).half_width - p.at(s).half_width) / (side * kStep);
}

TEST(WidthProfile, OfTwoKnotsIsALine) {
  const WidthProfile p = profile({2, 6}, {1, 3});
  for (const double t : {0.0, 0.25, 0.5, 0.9, 1.0}) {
    EXPECT_NEAR(p.at(2 + 4 * t).half_width, 1 + 2 * t, 1e-12);
    EXPECT_NEAR(p.at(2 + 4 * t).depth, 0.1 + 0.2 * t, 1e-12);
  }
  EXPECT_EQ(p.at(-7).half_width, 1);
  EXPECT_EQ(p.at(9).half_width, 3);
  EXPECT_DOUBLE_EQ(p.at(9).depth, 0.3);
  const WidthProfile one = profile({4}, {2});
  for (const double s : {0.0, 4.0, 8.0}) EXPECT_EQ(one.at(s).half_width, 2);
}

TEST(WidthProfile, AtAKnotItsSlopeIsTheWeightedHarmonicMeanOfThoseBesideIt) {
  // Pieces of 2 and 6 with the slopes 1 and 3; the longer one beyond weighs less.
  const double mean = 24 / (14 / 1.0 + 10 / 3.0);
  const WidthProfile p = profile({0, 2, 8}, {1, 3, 21});
  EXPECT_NEAR(slope(p, 2, 1), mean, 1e-4);
  EXPECT_NEAR(slope(p, 2, -1), mean, 1e-4);
  const WidthProfile falling = profile({0, 2, 8}, {21, 19, 1});
  EXPECT_NEAR(slope(falling, 2, 1), -mean, 1e-4);
  // A peak and the edge of a level piece are level.
  EXPECT_NEAR(slope(profile({0, 2, 8}, {1, 3, 2}), 2, 1), 0, 1e-4);
  EXPECT_NEAR(slope(profile({0, 2, 8}, {1, 3, 3}), 2, -1), 0, 1e-4);
}

TEST(WidthProfile, AnEndHasTheSlopeOfTheParabolaThroughThreeKnots) {
  const auto square = [](const std::vector<double>& s) {
    std::vector<double> values;
    for (const double x : s) values.push_back(x * x);
    return profile(s, values);
  };
  EXPECT_NEAR(slope(square({1, 2, 5}), 1, 1), 2, 1e-4);
  EXPECT_NEAR(slope(square({1, 3, 3.5}), 1, 1), 2, 1e-4);
  EXPECT_NEAR(slope(square({1, 2, 5}), 5, -1), 10, 1e-4);
  EXPECT_NEAR(slope(square({1, 4, 5, 5.5}), 5.5, -1), 11, 1e-4);
}

TEST(WidthProfile, AnEndOvershootsNeither) {
  // The parabolas would begin with the slopes 6, -6 and against the first piece.
  EXPECT_NEAR(slope(profile({0, 1, 2}, {10, 11, 2}), 0, 1), 3, 1e-4);
  EXPECT_NEAR(slope(profile({0, 1, 2}, {10, 9, 18}), 0, 1), -3, 1e-4);
  EXPECT_NEAR(slope(profile({0, 1, 2}, {10, 11, 16}), 0, 1), 0, 1e-4);
  EXPECT_NEAR(slope(profile({0, 1, 2}, {2, 11, 10}), 2, -1), -3, 1e-4);
  EXPECT_NEAR(slope(profile({0, 1, 2}, {18, 9, 10}), 2, -1), 3, 1e-4);
  EXPECT_NEAR(slope(profile({0, 1, 2}, {16, 11, 10}), 2, -1), 0, 1e-4);
}

TEST(WidthProfile, BetweenKnotsIsTheCubicOfTheirValuesAndSlopes) {
  const std::vector<double> s{0, 2, 3, 7, 8, 12}, values{1, 4, 4.5, 5, 2, 2.5};
  const WidthProfile p = profile(s, values);
  for (std::size_t i = 0; i + 1 < s.size(); ++i) {
    const double h = s[i + 1] - s[i];
    const double m0 = slope(p, s[i], 1), m1 = slope(p, s[i + 1], -1);
    for (const double t : {0.2, 0.5, 0.7}) {
      // A cubic in the form of Bernstein.
      const double u = 1 - t;
      const double wanted = u * u * u * values[i] + 3 * u * u * t * (values[i] + h * m0 / 3) +
                            3 * u * t * t * (values[i + 1] - h * m1 / 3) + t * t * t * values[i + 1];
      EXPECT_NEAR(p.at(s[i] + t * h).half_width, wanted, 1e-4) << i << " " << t;
      EXPECT_NEAR(p.at(s[i] + t * h).depth, 0.1 * wanted, 1e-5) << i << " " << t;
    }
    EXPECT_EQ(p.at(s[i]).half_width, values[i]);
  }
}

TEST(WidthProfile, RisesAndFallsAsItsKnots) {
  const WidthProfile p = profile({0, 1, 1.5, 6, 6.2, 9}, {1, 1, 5, 5.1, 0.2, 0.1});
  double before = 1;
  for (double s = 0; s <= 9; s += 0.01) {
    const double now = p.at(s).half_width;
    if (s < 6) {
      EXPECT_GE(now, before - 1e-12) << s;
    } else if (s > 6.02) {
      EXPECT_LE(now, before + 1e-12) << s;
    }
    before = now;
  }
}

TEST(WidthProfile, TheUsualWidthIsExceededByHalfOfTheLine) {
  // A narrow begin of 5, a body of 40 and a broad end of 30.
  EXPECT_DOUBLE_EQ(profile({0, 5, 5.001, 45, 45.001, 75}, {1, 1, 4, 4, 9, 9}).usual_half_width(), 4);
  EXPECT_DOUBLE_EQ(profile({0, 30, 30.001, 70, 70.001, 75}, {9, 9, 4, 4, 1, 1}).usual_half_width(), 4);
  // A piece counts with the mean of its ends.
  EXPECT_DOUBLE_EQ(profile({0, 10, 14}, {2, 5, 9}).usual_half_width(), 3.5);
  EXPECT_DOUBLE_EQ(profile({0, 10, 20}, {2, 2, 6}).usual_half_width(), 2) << "of two halves the narrower";
  EXPECT_DOUBLE_EQ(profile({3}, {2.5}).usual_half_width(), 2.5);
}

}  // namespace
}  // namespace nazori::carving
