// SPDX-License-Identifier: Apache-2.0
// What intervals prove at the borders of domains, at extremes and at poles.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "nazori/functions/dual.h"
#include "nazori/functions/interval.h"

namespace nazori::functions {
namespace {

using D = Decoration;
constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kPi = std::numbers::pi;

void expect(const Interval& i, double low, double high, D proven, Cause why = Cause::none) {
  const auto near = [](double a, double b) { return a == b || std::abs(a - b) <= 1e-14 * (1 + std::abs(b)); };
  EXPECT_TRUE(near(i.lower, low)) << i.lower << " not " << low;
  EXPECT_TRUE(near(i.upper, high)) << i.upper << " not " << high;
  EXPECT_EQ(i.decoration, proven);
  EXPECT_EQ(i.cause, why);
}

void expect_empty(const Interval& i, Cause why = Cause::domain) {
  EXPECT_TRUE(i.is_empty());
  EXPECT_EQ(i.decoration, D::undefined);
  EXPECT_TRUE(has(i.cause, why));
}

TEST(IntervalDomain, WhatLiesOutsideIsCutOff) {
  const Cause domain = Cause::domain;
  expect(sqrt(Interval(-1, 4)), 0, 2, D::partial, domain);
  expect(sqrt(Interval(0, 4)), 0, 2, D::continuous);
  expect_empty(sqrt(Interval(-2, -1e-300)));
  expect(asin(Interval(-2, 0.5)), -kPi / 2, std::asin(0.5), D::partial, domain);
  expect(asin(Interval(0.5, 2)), std::asin(0.5), kPi / 2, D::partial, domain);
  expect(asin(Interval(-1, 1)), -kPi / 2, kPi / 2, D::continuous);
  expect_empty(asin(Interval(1.1, 2)));
  expect_empty(asin(Interval(-2, -1.1)));
  expect(acos(Interval(-2, 0.5)), std::acos(0.5), kPi, D::partial, domain);
  expect(acos(Interval(0, 1)), 0, kPi / 2, D::continuous);
  EXPECT_GE(acos(Interval(0, 1)).lower, 0);
  expect_empty(acos(Interval(1.1, 2)));
  expect(acosh(Interval(0, 2)), 0, std::acosh(2), D::partial, domain);
  expect(acosh(Interval(1, 2)), 0, std::acosh(2), D::continuous);
  expect_empty(acosh(Interval(0, 0.9)));
}

TEST(IntervalDomain, AnOpenEndIsNoPartOfTheDomain) {
  const Cause pole = Cause::domain | Cause::pole;
  expect(log(Interval(0, 1)), -kInf, 0, D::partial, pole);
  expect(log(Interval(-1, 1)), -kInf, 0, D::partial, pole);
  expect(log2(Interval(0.5, 8)), -1, 3, D::continuous);
  expect(log10(Interval(0.1, 1)), -1, 0, D::continuous);
  EXPECT_EQ(log(Interval(1)).lower, 0) << "exact";
  EXPECT_EQ(log(Interval(1)).upper, 0);
  expect_empty(log(Interval(-1, 0)));
  expect_empty(log10(Interval(-2, -1)));
  expect(log(Interval(1, kInf)), 0, kInf, D::continuous);
  expect(atanh(Interval(-0.5, 0.5)), -std::atanh(0.5), std::atanh(0.5), D::continuous);
  EXPECT_EQ(atanh(Interval(-1, 0.5)).decoration, D::partial);
  EXPECT_EQ(atanh(Interval(-1, 0.5)).lower, -kInf);
  EXPECT_EQ(atanh(Interval(0.5, 1)).decoration, D::partial);
  EXPECT_EQ(atanh(Interval(-2, 2)).upper, kInf);
  expect_empty(atanh(Interval(1, 2)));
  expect_empty(atanh(Interval(-2, -1)));
  EXPECT_FALSE(atanh(Interval(0.9, 2)).is_empty());
}

TEST(IntervalDomain, WavesKnowTheirExtremes) {
  expect(sin(Interval(1, 2)), std::sin(1), 1, D::continuous);
  expect(sin(Interval(-2, -1)), -1, std::sin(-1), D::continuous);
  expect(sin(Interval(2, 4)), std::sin(4), std::sin(2), D::continuous);
  expect(sin(Interval(-1, 1.5)), std::sin(-1), std::sin(1.5), D::continuous);
  EXPECT_LT(sin(Interval(-1, 1.57)).upper, 1);
  EXPECT_LT(sin(Interval(1.58, 2)).upper, 1);
  EXPECT_EQ(sin(Interval(1.5, 1.5708)).upper, 1);
  expect(sin(Interval(100, 104)), std::sin(100), 1, D::continuous);
  expect(sin(Interval(98, 104)), -1, 1, D::continuous);
  expect(cos(Interval(-1, 2)), std::cos(2), 1, D::continuous);
  expect(cos(Interval(3, 4)), -1, std::cos(4), D::continuous);
  expect(cos(Interval(0.5, 3)), std::cos(3), std::cos(0.5), D::continuous);
  expect(cos(Interval(4, 6)), std::cos(4), std::cos(6), D::continuous);
  expect(cos(Interval(6, 6.5)), std::cos(6), 1, D::continuous);
  expect(sin(Interval(0, 6.3)), -1, 1, D::continuous);
  expect(cos(Interval(-kInf, 0)), -1, 1, D::continuous);
  expect(sin(Interval(1.1e12)), -1, 1, D::continuous);
  EXPECT_LT(sin(Interval(0.9e12)).width(), 1e-14);
  EXPECT_EQ(sin(Interval(0)).upper, 0) << "exact";
  EXPECT_EQ(tan(Interval(0)).lower, 0);
  EXPECT_EQ(exp(Interval(0)).lower, 1);
  EXPECT_EQ(erf(Interval(0)).upper, 0);
}

TEST(IntervalDomain, TangentsHavePoles) {
  expect(tan(Interval(-1.5, 1.5)), std::tan(-1.5), std::tan(1.5), D::continuous);
  expect(tan(Interval(1.5, 1.6)), -kInf, kInf, D::partial, Cause::pole);
  expect(tan(Interval(4.7, 4.72)), -kInf, kInf, D::partial, Cause::pole);
  expect(tan(Interval(0, 3.2)), -kInf, kInf, D::partial, Cause::pole);
  expect(tan(Interval(1.1e12)), -kInf, kInf, D::partial, Cause::pole);
  expect(tan(Interval(-kInf, 0)), -kInf, kInf, D::partial, Cause::pole);
}

TEST(IntervalDomain, BoundedFunctionsKeepTheirBounds) {
  EXPECT_EQ(exp(Interval(-800, 0)).lower, 0);
  EXPECT_EQ(exp(Interval(0, 800)).upper, kInf);
  EXPECT_EQ(exp(Interval(0, 800)).cause, Cause::overflow);
  EXPECT_EQ(exp(Interval(0, kInf)).cause, Cause::none);
  EXPECT_EQ(tanh(Interval(-50, 50)).lower, -1);
  EXPECT_EQ(tanh(Interval(-50, 50)).upper, 1);
  EXPECT_EQ(erf(Interval(-50, 50)).lower, -1);
  EXPECT_EQ(erf(Interval(-50, 50)).upper, 1);
  EXPECT_EQ(cosh(Interval(0)).lower, 1);
  EXPECT_EQ(cosh(Interval(-1, 0.5)).lower, 1);
  EXPECT_EQ(atan(Interval(-kInf, kInf)).is_bounded(), true);
}

TEST(IntervalDomain, AnglesTurnRoundTheOrigin) {
  expect(atan2(Interval(1, 2), Interval(1, 3)), std::atan2(1, 3), std::atan2(2, 1), D::continuous);
  expect(atan2(Interval(-2, -1), Interval(-3, -1)),
         std::atan2(-1, -3) - 0 < std::atan2(-2, -1) ? std::atan2(-1, -3) : std::atan2(-2, -1),
         std::max(std::atan2(-1, -3), std::atan2(-2, -1)), D::continuous);
  expect(atan2(Interval(-1, 1), Interval(1, 2)), -kPi / 4, kPi / 4, D::continuous);
  expect(atan2(Interval(1, 2), Interval(-1, 1)), kPi / 4, 3 * kPi / 4, D::continuous);
  expect(atan2(Interval(-1, 1), Interval(-1, 1)), -kPi, kPi, D::partial, Cause::domain);
  expect(atan2(Interval(0, 1), Interval(-1, 1)), 0, kPi, D::partial, Cause::domain);
  expect(atan2(Interval(-1, 1), Interval(-2, -1)), -kPi, kPi, D::defined, Cause::jump);
  expect(atan2(Interval(0, 1), Interval(-2, -1)), 3 * kPi / 4, kPi, D::continuous);
  expect(atan2(Interval(0), Interval(-2, -1)), kPi, kPi, D::continuous);
  expect_empty(atan2(Interval(0), Interval(0)));
  EXPECT_EQ(atan2(Interval(-1, 1), Interval(0, 1)).decoration, D::partial);
}

TEST(IntervalDomain, StepsAreTornWhereTheyStep) {
  expect(floor(Interval(0.25, 0.75)), 0, 0, D::continuous);
  expect(floor(Interval(0.5, 2.5)), 0, 2, D::defined, Cause::jump);
  expect(floor(Interval(1, 1)), 1, 1, D::continuous);
  expect(ceil(Interval(0.5, 1.5)), 1, 2, D::defined, Cause::jump);
  expect(ceil(Interval(1.25, 1.5)), 2, 2, D::continuous);
  expect(sign(Interval(0.5, 2)), 1, 1, D::continuous);
  expect(sign(Interval(-1, 2)), -1, 1, D::defined, Cause::jump);
  expect(sign(Interval(0, 2)), 0, 1, D::defined, Cause::jump);
  expect(sign(Interval(0)), 0, 0, D::continuous);
  EXPECT_TRUE(floor(Interval::empty()).is_empty());
  EXPECT_TRUE(sign(Interval::empty()).is_empty());
}

TEST(IntervalDomain, GammaHasItsLeastValueAndItsPoles) {
  expect(gamma(Interval(1, 2)), 0.8856031944108887, 1, D::continuous);
  EXPECT_LE(gamma(Interval(1.4616, 1.4617)).lower, 0.88560319441088871);
  EXPECT_GT(gamma(Interval(1.5, 2)).lower, 0.8862);
  EXPECT_GT(gamma(Interval(1, 1.4)).lower, 0.8872);
  EXPECT_NEAR(gamma(Interval(0.5, 1)).upper, std::sqrt(kPi), 1e-13);
  expect(gamma(Interval(-0.5, 0.5)), -kInf, kInf, D::partial, Cause::pole);
  expect(gamma(Interval(-1.5, -0.5)), -kInf, kInf, D::partial, Cause::pole);
  expect(gamma(Interval(-2, -1.5)), -kInf, kInf, D::partial, Cause::pole);
  expect(gamma(Interval(-1.5, -1)), -kInf, kInf, D::partial, Cause::pole);
  expect(gamma(Interval(0, 1)), -kInf, kInf, D::partial, Cause::pole);
  expect_empty(gamma(Interval(-2)), Cause::pole);
  expect_empty(gamma(Interval(0)), Cause::pole);
  // Below zero between 0 and -1, above it between -1 and -2: the values of -1/2 and -3/2 in closed form.
  EXPECT_TRUE(gamma(Interval(-0.6, -0.4)).contains(-2 * std::sqrt(kPi)));
  EXPECT_LT(gamma(Interval(-0.6, -0.4)).upper, 0);
  EXPECT_TRUE(gamma(Interval(-1.6, -1.4)).contains(4 * std::sqrt(kPi) / 3));
  EXPECT_GT(gamma(Interval(-1.6, -1.4)).lower, 0);
  EXPECT_EQ(gamma(Interval(100, 200)).cause, Cause::overflow);
}

TEST(IntervalDomain, DigammaRisesBetweenItsPoles) {
  constexpr double kEuler = 0.57721566490153286;
  const Interval d = digamma(Interval(1, 2));
  EXPECT_NEAR(d.lower, -kEuler, 1e-12);
  EXPECT_NEAR(d.upper, 1 - kEuler, 1e-12);
  EXPECT_LT(d.lower, -kEuler);
  EXPECT_GT(d.upper, 1 - kEuler);
  EXPECT_EQ(digamma(Interval(-0.5, 0.5)).lower, -kInf);
  EXPECT_EQ(digamma(Interval(-0.5, 0.5)).decoration, D::partial);
  EXPECT_EQ(digamma(Interval(1, kInf)).upper, kInf);
  EXPECT_NEAR(digamma(Interval(-0.5)).lower, 2 - kEuler - 2 * std::log(2), 1e-11);
  EXPECT_TRUE(digamma(Interval::empty()).is_empty());
}

TEST(IntervalPower, WholePowersOfEveryBase) {
  expect(power_integer(Interval(-2, 3), 2), 0, 9, D::continuous);
  expect(power_integer(Interval(-2, 3), 3), -8, 27, D::continuous);
  expect(power_integer(Interval(-2, 1), 4), 0, 16, D::continuous);
  expect(power_integer(Interval(-3, -2), 4), 16, 81, D::continuous);
  expect(power_integer(Interval(2, 3), 4), 16, 81, D::continuous);
  expect(power_integer(Interval(-3, -2), 5), -243, -32, D::continuous);
  expect(power_integer(Interval(0, 2), 3), 0, 8, D::continuous);
  expect(power_integer(Interval(-2, 0), 3), -8, 0, D::continuous);
  expect(power_integer(Interval(0, 2), 4), 0, 16, D::continuous);
  expect(power_integer(Interval(0), 4), 0, 0, D::continuous);
  expect(power_integer(Interval(2, 4), -1), 0.25, 0.5, D::continuous);
  expect(power_integer(Interval(2, 4), -2), 1.0 / 16, 0.25, D::continuous);
  expect(power_integer(Interval(-1, 1), -2), 1, kInf, D::partial, Cause::pole);
  expect(power_integer(Interval(-5, 5), 0), 1, 1, D::continuous);
  expect(power_integer(Interval(-5, 5), 1), -5, 5, D::continuous);
  EXPECT_EQ(power_integer(Interval(-1e200, 1e200), 3).cause, Cause::overflow);
  EXPECT_TRUE(power_integer(Interval::empty(), 3).is_empty());
}

TEST(IntervalPower, RationalPowersFollowTheRealRoots) {
  expect(power_rational(Interval(-8, 27), 1, 3), -2, 3, D::continuous);
  expect(power_rational(Interval(-8, 27), 2, 3), 0, 9, D::continuous);
  expect(power_rational(Interval(-27, -8), 2, 3), 4, 9, D::continuous);
  expect(power_rational(Interval(-27, -8), 1, 3), -3, -2, D::continuous);
  expect(power_rational(Interval(-27, -8), 5, 3), -243, -32, D::continuous);
  expect(power_rational(Interval(4, 9), 3, 2), 8, 27, D::continuous);
  expect(power_rational(Interval(0, 9), 1, 2), 0, 3, D::continuous);
  expect(power_rational(Interval(-1, 9), 1, 2), 0, 3, D::partial, Cause::domain);
  expect_empty(power_rational(Interval(-9, -1), 1, 2));
  expect(power_rational(Interval(4, 9), -1, 2), 1.0 / 3, 0.5, D::continuous);
  expect(power_rational(Interval(8, 27), -2, 3), 1.0 / 9, 0.25, D::continuous);
  expect(power_rational(Interval(2, 3), 2, 1), 4, 9, D::continuous);
  EXPECT_TRUE(power_rational(Interval::empty(), 1, 3).is_empty());
}

TEST(IntervalPower, ComputedExponentsAreTakenByTheLogarithm) {
  expect(power(Interval(2, 3), Interval(1.5, 2.5)), std::pow(2, 1.5), std::pow(3, 2.5), D::continuous);
  expect(power(Interval(0.25, 0.5), Interval(1.5, 2)), 1.0 / 16, std::pow(0.5, 1.5), D::continuous);
  expect(power(Interval(0.5, 2), Interval(-1.5, 1.5)), std::pow(2, -1.5), std::pow(2, 1.5), D::continuous);
  expect(power(Interval(0, 2), Interval(1.5, 2.5)), 0, std::pow(2, 2.5), D::continuous);
  expect(power(Interval(-1, 2), Interval(1.5, 2.5)), 0, std::pow(2, 2.5), D::partial, Cause::domain);
  EXPECT_EQ(power(Interval(0, 2), Interval(-0.5, 1.5)).decoration, D::partial);
  EXPECT_TRUE(has(power(Interval(0, 2), Interval(-0.5, 1.5)).cause, Cause::pole));
  EXPECT_TRUE(has(power(Interval(0, 2), Interval(0, 1.5)).cause, Cause::domain));
  EXPECT_FALSE(has(power(Interval(0, 2), Interval(0, 1.5)).cause, Cause::pole));
  expect(power(Interval(0), Interval(0.5, 1.5)), 0, 0, D::continuous);
  EXPECT_EQ(power(Interval(0), Interval(0, 1.5)).decoration, D::partial);
  expect_empty(power(Interval(0), Interval(-1.5, 0)));
  expect_empty(power(Interval(-2, -1), Interval(0.25, 0.5)));
  EXPECT_EQ(power(Interval(10), Interval(300, 400)).cause, Cause::overflow);
  EXPECT_TRUE(power(Interval::empty(), Interval(1)).is_empty());
  EXPECT_TRUE(power(Interval(1), Interval::empty()).is_empty());
}

TEST(IntervalPower, ANegativeBaseTakesWholePowersAndStepsOfThem) {
  expect(power(Interval(-3, -2), Interval(2)), 4, 9, D::continuous);
  expect(power(Interval(-3, 2), Interval(3)), -27, 8, D::continuous);
  expect(power(Interval(-3, -2), Interval(-1)), -0.5, -1.0 / 3, D::continuous);
  const Interval step(2, 3, D::defined, Cause::jump);
  expect(power(Interval(-3, -2), step), -27, 9, D::partial, Cause::jump);
  expect_empty(power(Interval(-3, -2), Interval(2, 3)));
  expect_empty(power(Interval(-3, -2), Interval(2, 4, D::defined, Cause::jump)));
  expect_empty(power(Interval(-3, -2), Interval(2.5, 3.5, D::defined, Cause::jump)));
  expect_empty(power(Interval(-3, -2), Interval(2, 3, D::defined, Cause::pole)));
  EXPECT_TRUE(power(Interval(-1.0000001, -1), Interval(1'000'001.0)).is_empty()) << "too large to tell";
}

}  // namespace
}  // namespace nazori::functions
