// SPDX-License-Identifier: Apache-2.0
// Exact names of numbers. The values are worked out here from what the names say.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "nazori/functions/points.h"

namespace nazori::functions {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kE = std::numbers::e;
const std::optional<std::string> kNone;

double root(int n) { return std::sqrt(static_cast<double>(n)); }

/// The names must be read back by the parser as the number they name.
void expect_name(double value, const std::string& name) {
  EXPECT_EQ(exact_name(value), name) << value;
  const auto plot = parse("y = " + name);
  ASSERT_TRUE(plot) << name;
  EXPECT_NEAR(constant_value(plot->statements[0].terms[0]), value, 1e-12 * std::max(1.0, std::abs(value)));
}

TEST(ExactName, WholeNumbersUpToAMillionAndFractionsUpToFortieths) {
  expect_name(0, "0");
  expect_name(-7, "-7");
  expect_name(1e6, "1000000");
  expect_name(-1e6, "-1000000");
  EXPECT_EQ(exact_name(1'000'001), kNone);
  expect_name(1.0 / 3, "1/3");
  expect_name(-7.0 / 40, "-7/40");
  expect_name(39.0 / 40, "39/40");
  EXPECT_EQ(exact_name(1.0 / 41), kNone);
  expect_name(2.5, "5/2");
}

TEST(ExactName, WhatRoundingLeavesOfZeroIsZero) {
  expect_name(std::sin(kPi), "0");
  expect_name(-1.9e-13, "0");
  // Nor is what is a little larger 0 times some root or pi.
  for (const double little : {2.3e-13, 4e-13, 8e-13, 1.2e-12, 1e-7}) {
    EXPECT_EQ(exact_name(little), kNone) << little;
    EXPECT_EQ(exact_name(-little), kNone) << little;
  }
}

TEST(ExactName, ANumberIsMeantOnlyWithinItsLastPlaces) {
  EXPECT_EQ(exact_name(1.0 / 3 + 1.9e-13), "1/3");
  EXPECT_EQ(exact_name(1.0 / 3 + 2.3e-13), kNone);
  EXPECT_EQ(exact_name(1.0 / 3 - 2.3e-13), kNone);
  // Of larger numbers in proportion.
  EXPECT_EQ(exact_name(1000 + 1.0 / 3 + 1.9e-10), "3001/3");
  EXPECT_EQ(exact_name(1000 + 1.0 / 3 + 2.3e-10), kNone);
  EXPECT_EQ(exact_name(3 + root(2) + 0.8e-12), "3 + sqrt(2)");
  EXPECT_EQ(exact_name(3 + root(2) + 1.1e-12), kNone);
}

TEST(ExactName, NoNumberHasNoName) {
  EXPECT_EQ(exact_name(std::numeric_limits<double>::infinity()), kNone);
  EXPECT_EQ(exact_name(-std::numeric_limits<double>::infinity()), kNone);
  EXPECT_EQ(exact_name(std::numeric_limits<double>::quiet_NaN()), kNone);
}

TEST(ExactName, PartsOfPiUpToTwelfths) {
  expect_name(kPi, "pi");
  expect_name(-kPi, "-pi");
  expect_name(2 * kPi, "2*pi");
  expect_name(3 * kPi / 4, "3*pi/4");
  expect_name(-kPi / 2, "-pi/2");
  expect_name(kPi / 12, "pi/12");
  expect_name(-5 * kPi / 12, "-5*pi/12");
  EXPECT_EQ(exact_name(kPi / 13), kNone);
}

TEST(ExactName, RootsOfWholeNumbersUpToThirtyAreTakenApart) {
  for (int n = 2; n <= 30; ++n) {
    int outside = 1;
    int inside = n;
    for (int k = 5; k > 1; --k) {
      if (inside % (k * k) == 0) {
        outside *= k;
        inside /= k * k;
      }
    }
    const std::string symbol = fmt::format("sqrt({})", inside);
    const std::string name = inside == 1    ? fmt::format("{}", outside)
                             : outside == 1 ? symbol
                                            : fmt::format("{}*{}", outside, symbol);
    expect_name(root(n), name);
  }
  EXPECT_EQ(exact_name(root(31)), kNone);
  expect_name(-root(3) / 12, "-sqrt(3)/12");
  EXPECT_EQ(exact_name(root(3) / 13), kNone);
  expect_name(100 * root(2), "100*sqrt(2)");
  EXPECT_EQ(exact_name(101 * root(2)), kNone);
  // Not as 60 sqrt(8), 51 sqrt(12), 60 sqrt(18) or 50 sqrt(27).
  EXPECT_EQ(exact_name(120 * root(2)), kNone);
  EXPECT_EQ(exact_name(102 * root(3)), kNone);
  EXPECT_EQ(exact_name(180 * root(2)), kNone);
  EXPECT_EQ(exact_name(150 * root(3)), kNone);
}

TEST(ExactName, MultiplesAndPartsOfE) {
  expect_name(kE, "e");
  expect_name(-kE / 6, "-e/6");
  EXPECT_EQ(exact_name(kE / 7), kNone);
  expect_name(20 * kE, "20*e");
  EXPECT_EQ(exact_name(21 * kE), kNone);
  expect_name(1 / kE, "1/e");
  expect_name(-20 / kE, "-20/e");
  EXPECT_EQ(exact_name(21 / kE), kNone);
  expect_name(5 / (6 * kE), "5/(6*e)");
  EXPECT_EQ(exact_name(5 / (7 * kE)), kNone);
}

TEST(ExactName, LogarithmsOfSmallNumbers) {
  for (const int n : {2, 3, 5, 7, 10}) expect_name(std::log(n), fmt::format("ln({})", n));
  expect_name(-std::log(3) / 6, "-ln(3)/6");
  EXPECT_EQ(exact_name(std::log(3) / 7), kNone);
  expect_name(20 * std::log(5), "20*ln(5)");
  EXPECT_EQ(exact_name(21 * std::log(5)), kNone);
  EXPECT_EQ(exact_name(std::log(11)), kNone);
}

TEST(ExactName, RootsOfPartsOfPi) {
  expect_name(std::sqrt(kPi), "sqrt(pi)");
  expect_name(std::sqrt(2 * kPi), "sqrt(2*pi)");
  expect_name(std::sqrt(5 * kPi / 6), "sqrt(5*pi/6)");
  EXPECT_EQ(exact_name(std::sqrt(kPi / 7)), kNone);
  expect_name(std::sqrt(100 * kPi), "sqrt(100*pi)");
  EXPECT_EQ(exact_name(std::sqrt(101 * kPi)), kNone);
  EXPECT_EQ(exact_name(-std::sqrt(kPi)), kNone);
}

TEST(ExactName, PowersOfE) {
  expect_name(kE * kE, "e^2");
  expect_name(std::exp(6), "e^6");
  expect_name(std::exp(-6), "e^-6");
  EXPECT_EQ(exact_name(std::exp(7)), kNone);
  EXPECT_EQ(exact_name(std::exp(-7)), kNone);
  expect_name(std::exp(-0.5), "e^(-1/2)");
  expect_name(std::exp(5.0 / 6), "e^(5/6)");
  EXPECT_EQ(exact_name(std::exp(1.0 / 7)), kNone);
  EXPECT_EQ(exact_name(-kE * kE), kNone);
}

TEST(ExactName, SolutionsOfQuadraticEquations) {
  for (const int n : {2, 3, 5, 6, 7, 10, 11, 13, 17}) {
    expect_name(1 + root(n), fmt::format("1 + sqrt({})", n));
    expect_name(-2 - 3 * root(n), fmt::format("-2 - 3*sqrt({})", n));
    expect_name((3 - 2 * root(n)) / 4, fmt::format("(3 - 2*sqrt({}))/4", n));
  }
  for (const int n : {14, 15, 19}) EXPECT_EQ(exact_name(1 + root(n)), kNone);
  expect_name((1 - root(5)) / 2, "(1 - sqrt(5))/2");
  expect_name((1 + root(5)) / 3, "(1 + sqrt(5))/3");
  EXPECT_EQ(exact_name((1 + root(5)) / 5), kNone);
  EXPECT_EQ(exact_name(1 + 4 * root(5)), kNone);
  EXPECT_EQ(exact_name(1 - 4 * root(5)), kNone);
  expect_name(20 + root(2), "20 + sqrt(2)");
  expect_name(-20 + root(2), "-20 + sqrt(2)");
  EXPECT_EQ(exact_name(21 + root(2)), kNone);
  EXPECT_EQ(exact_name(-21 + root(2)), kNone);
}

}  // namespace
}  // namespace nazori::functions
