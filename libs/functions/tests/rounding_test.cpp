// SPDX-License-Identifier: Apache-2.0
// Bounds of the four operations and of the functions, against MPFR's directed rounding: exact where the
// operation is, a few last places wide where libm is trusted.
#include <gtest/gtest.h>
#include <mpfr.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>

#include "nazori/functions/dual.h"
#include "nazori/functions/interval.h"

namespace nazori::functions {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

using Operation = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);

double rounded(Operation operation, double a, double b, mpfr_rnd_t way) {
  mpfr_t x, y, r;
  mpfr_inits2(53, x, y, r, static_cast<mpfr_ptr>(nullptr));
  mpfr_set_d(x, a, MPFR_RNDN);
  mpfr_set_d(y, b, MPFR_RNDN);
  operation(r, x, y, way);
  const double result = mpfr_get_d(r, way);
  mpfr_clears(x, y, r, static_cast<mpfr_ptr>(nullptr));
  return result;
}

/// The narrowest interval of doubles around an operation that has its extremes in the corners.
Interval corners(Operation operation, const Interval& a, const Interval& b) {
  double low = kInf;
  double high = -kInf;
  for (const double x : {a.lower, a.upper}) {
    for (const double y : {b.lower, b.upper}) {
      low = std::min(low, rounded(operation, x, y, MPFR_RNDD));
      high = std::max(high, rounded(operation, x, y, MPFR_RNDU));
    }
  }
  return {low, high};
}

/// Boxes of every sign, with and without zero on an end.
std::vector<Interval> boxes() {
  std::vector<Interval> all{{0, 0}, {-1, 0}, {0, 1}, {0.1, 0.3}, {-0.3, -0.1}, {-0.1, 0.7}, {-0.7, 0.1}};
  std::mt19937 random(20'050'401);
  std::uniform_real_distribution<double> any(-3, 3);
  for (int i = 0; i < 25; ++i) {
    const double a = any(random);
    const double b = any(random);
    all.emplace_back(std::min(a, b), std::max(a, b));
    all.emplace_back(a, a);
  }
  return all;
}

TEST(Rounding, SumsDifferencesAndProductsAreAsNarrowAsDoublesAllow) {
  for (const Interval& a : boxes()) {
    for (const Interval& b : boxes()) {
      const auto expect = [&](const Interval& got, const Interval& wanted, char sign) {
        EXPECT_EQ(got.lower, wanted.lower) << '[' << a.lower << ", " << a.upper << ']' << sign << b.lower;
        EXPECT_EQ(got.upper, wanted.upper) << '[' << a.lower << ", " << a.upper << ']' << sign << b.lower;
        EXPECT_TRUE(got.is_continuous());
      };
      expect(a + b, corners(mpfr_add, a, b), '+');
      expect(a - b, corners(mpfr_sub, a, b), '-');
      expect(a * b, corners(mpfr_mul, a, b), '*');
      if (!b.contains(0)) expect(a / b, corners(mpfr_div, a, b), '/');
      expect(min(a, b), {std::min(a.lower, b.lower), std::min(a.upper, b.upper)}, 'm');
      expect(max(a, b), {std::max(a.lower, b.lower), std::max(a.upper, b.upper)}, 'M');
      expect(hull(a, b), {std::min(a.lower, b.lower), std::max(a.upper, b.upper)}, 'h');
    }
    const double least = a.contains(0) ? 0 : std::min(std::abs(a.lower), std::abs(a.upper));
    EXPECT_EQ(abs(a).lower, least);
    EXPECT_EQ(abs(a).upper, a.magnitude());
    EXPECT_EQ(square(a).lower, rounded(mpfr_mul, least, least, MPFR_RNDD));
    EXPECT_EQ(square(a).upper, rounded(mpfr_mul, a.magnitude(), a.magnitude(), MPFR_RNDU));
  }
}

TEST(Rounding, LongDoublesHoldTheSameSumsProductsAndQuotients) {
  for (const Interval& a : boxes()) {
    for (const Interval& b : boxes()) {
      const LongInterval la(a.lower, a.upper);
      const LongInterval lb(b.lower, b.upper);
      const auto inside = [](const LongInterval& wide, const Interval& narrow) {
        // Wider format, narrower interval, but for its own rounding.
        EXPECT_NEAR(static_cast<double>(wide.lower), narrow.lower, 1e-15 * (1 + std::abs(narrow.lower)));
        EXPECT_NEAR(static_cast<double>(wide.upper), narrow.upper, 1e-15 * (1 + std::abs(narrow.upper)));
        EXPECT_LE(wide.lower, wide.upper);
      };
      inside(la + lb, a + b);
      inside(la * lb, a * b);
      if (!b.contains(0)) inside(la / lb, a / b);
    }
  }
}

TEST(Rounding, ADivisorThatContainsZeroLeavesWhatIsCertain) {
  const Interval whole = Interval(1, 2) / Interval(-1, 4);
  EXPECT_EQ(whole.lower, -kInf);
  EXPECT_EQ(whole.upper, kInf);
  EXPECT_EQ(whole.decoration, Decoration::partial);
  EXPECT_TRUE(has(whole.cause, Cause::pole));
  EXPECT_FALSE(has(whole.cause, Cause::overflow));
  const auto expect = [](const Interval& a, const Interval& b, double low, double high) {
    const Interval q = a / b;
    EXPECT_EQ(q.lower, low) << a.lower << ' ' << b.lower;
    EXPECT_EQ(q.upper, high) << a.lower << ' ' << b.lower;
    EXPECT_EQ(q.decoration, Decoration::partial);
    EXPECT_TRUE(has(q.cause, Cause::pole));
  };
  expect({1, 2}, {0, 4}, 0.25, kInf);
  expect({-2, -1}, {0, 4}, -kInf, -0.25);
  expect({1, 2}, {-4, 0}, -kInf, -0.25);
  expect({-2, -1}, {-4, 0}, 0.25, kInf);
  expect({-1, 1}, {0, 4}, -kInf, kInf);
  expect({-1, 1}, {-4, 0}, -kInf, kInf);
  expect({0, 1}, {0, 4}, 0, kInf);
  expect({-1, 0}, {0, 4}, -kInf, 0);
  expect({0, 0}, {-1, 1}, 0, 0);
  EXPECT_TRUE((Interval(1, 2) / Interval(0)).is_empty());
  EXPECT_TRUE(has((Interval(1, 2) / Interval(0)).cause, Cause::pole));
  // So small that it may have underflowed.
  EXPECT_TRUE(has((Interval(1) / Interval(0, 1e-290)).cause, Cause::overflow));
  EXPECT_FALSE(has((Interval(1) / Interval(0, 2e-290)).cause, Cause::overflow));
  EXPECT_FALSE(has((Interval(1) / Interval(-2e-290, 0)).cause, Cause::overflow));
}

TEST(Rounding, NothingAndAnythingIsNothingAndKeepsItsCause) {
  const Interval none = Interval::empty(Cause::pole);
  for (const Interval& r : {none + Interval(1), Interval(1) + none, none * Interval(1), Interval(1) * none,
                            none / Interval(1), Interval(1) / none, min(none, Interval(1)),
                            max(Interval(1), none), abs(none), square(none), -none, Interval(1) - none}) {
    EXPECT_TRUE(r.is_empty());
    EXPECT_TRUE(has(r.cause, Cause::pole));
    EXPECT_EQ(r.decoration, Decoration::undefined);
  }
  EXPECT_EQ(hull(none, Interval(1, 2)).upper, 2);
  EXPECT_EQ(hull(Interval(1, 2), none).lower, 1);
}

TEST(Rounding, WhatGrowsOverTheFormatSaysSoAndStaysAnEnclosure) {
  constexpr double kMax = std::numeric_limits<double>::max();
  const Interval big = Interval(1e200) * Interval(1e200);
  EXPECT_EQ(big.lower, kMax);
  EXPECT_EQ(big.upper, kInf);
  EXPECT_TRUE(has(big.cause, Cause::overflow));
  const Interval small = Interval(1e200) * Interval(-1e200);
  EXPECT_EQ(small.lower, -kInf);
  EXPECT_EQ(small.upper, -kMax);
  const Interval quotient = Interval(1e200) / Interval(1e-200);
  EXPECT_EQ(quotient.lower, kMax);
  EXPECT_TRUE(has(quotient.cause, Cause::overflow));
  const Interval sum = Interval(kMax) + Interval(kMax);
  EXPECT_EQ(sum.lower, kMax);
  EXPECT_EQ(sum.upper, kInf);
  const Interval unbounded(0, kInf);
  EXPECT_EQ((unbounded + Interval(1)).upper, kInf);
  EXPECT_EQ((unbounded * Interval(2)).upper, kInf);
  EXPECT_FALSE(has((unbounded * Interval(2)).cause, Cause::overflow));
  EXPECT_EQ((Interval(1) / Interval(1, kInf)).lower, -std::numeric_limits<double>::denorm_min());
  EXPECT_TRUE(has(square(Interval(1e200)).cause, Cause::overflow));
}

TEST(Rounding, TinyProductsAndQuotientsStillContainTheTruth) {
  for (const double a : {3e-200, -3e-200, 5e-310}) {
    for (const double b : {7e-150, 1.1e-120, -1.3e-100}) {
      const Interval p = Interval(a) * Interval(b);
      EXPECT_LE(p.lower, rounded(mpfr_mul, a, b, MPFR_RNDD));
      EXPECT_GE(p.upper, rounded(mpfr_mul, a, b, MPFR_RNDU));
      const Interval q = Interval(a) / Interval(1 / b);
      EXPECT_LE(q.lower, rounded(mpfr_div, a, 1 / b, MPFR_RNDD));
      EXPECT_GE(q.upper, rounded(mpfr_div, a, 1 / b, MPFR_RNDU));
    }
  }
}

TEST(Rounding, TheWeakerProofOfTwoIsThatOfTheResult) {
  const Interval torn(1, 2, Decoration::defined, Cause::jump);
  const Interval partial(1, 2, Decoration::partial, Cause::domain);
  const Interval sound(1, 2);
  EXPECT_EQ((torn + sound).decoration, Decoration::defined);
  EXPECT_EQ((sound * partial).decoration, Decoration::partial);
  EXPECT_TRUE(has((torn * partial).cause, Cause::jump) && has((torn * partial).cause, Cause::domain));
  EXPECT_EQ(hull(torn, sound).decoration, Decoration::defined);
  EXPECT_EQ(sound.weakened(Decoration::defined, Cause::pole).decoration, Decoration::defined);
  EXPECT_EQ(partial.weakened(Decoration::defined, Cause::pole).decoration, Decoration::partial);
  EXPECT_EQ((-torn).decoration, Decoration::defined);
  EXPECT_EQ(sound.middle(), 1.5);
  EXPECT_EQ(sound.width(), 1);
  EXPECT_EQ(Interval(-3, 2).magnitude(), 3);
}

struct Elementary {
  const char* name;
  std::function<Interval(const Interval&)> of;
  std::function<LongInterval(const LongInterval&)> of_long;
  int (*truth)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
  std::vector<double> places;
};

#define NAZORI_OF(f) #f, [](const Interval& i) { return f(i); }, [](const LongInterval& i) { return f(i); }

TEST(Rounding, FunctionsAtAPointAreOnlyAFewLastPlacesWide) {
  const Elementary all[] = {
      {NAZORI_OF(sqrt), mpfr_sqrt, {0.5, 2, 1e20}},
      {NAZORI_OF(exp), mpfr_exp, {-3, 0.5, 10}},
      {NAZORI_OF(log), mpfr_log, {0.1, 2, 1e10}},
      {NAZORI_OF(log2), mpfr_log2, {0.1, 3, 1e10}},
      {NAZORI_OF(log10), mpfr_log10, {0.1, 2, 1e10}},
      {NAZORI_OF(sin), mpfr_sin, {-2, 0.5, 100, 9e11}},
      {NAZORI_OF(cos), mpfr_cos, {-2, 0.5, 100, 9e11}},
      {NAZORI_OF(tan), mpfr_tan, {-1, 0.5, 100}},
      {NAZORI_OF(asin), mpfr_asin, {-0.9, 0.5, 1}},
      {NAZORI_OF(acos), mpfr_acos, {-0.9, 0.5, -1}},
      {NAZORI_OF(atan), mpfr_atan, {-2, 0.5, 1e9}},
      {NAZORI_OF(sinh), mpfr_sinh, {-2, 0.5, 20}},
      {NAZORI_OF(cosh), mpfr_cosh, {-2, 0.5, 20}},
      {NAZORI_OF(tanh), mpfr_tanh, {-2, 0.5}},
      {NAZORI_OF(asinh), mpfr_asinh, {-2, 0.5, 1e9}},
      {NAZORI_OF(acosh), mpfr_acosh, {1.5, 20}},
      {NAZORI_OF(atanh), mpfr_atanh, {-0.9, 0.5}},
      {NAZORI_OF(erf), mpfr_erf, {-2, 0.5}},
      {NAZORI_OF(gamma), mpfr_gamma, {0.5, 1.4, 1.5, 5.5, 20, -0.5, -1.5, -2.25, -3.75}}};
  for (const Elementary& f : all) {
    for (const double x : f.places) {
      mpfr_t v;
      mpfr_init2(v, 120);
      mpfr_set_d(v, x, MPFR_RNDN);
      f.truth(v, v, MPFR_RNDN);
      const Interval i = f.of(Interval(x));
      EXPECT_LE(mpfr_cmp_d(v, i.upper), 0) << f.name << ' ' << x;
      EXPECT_GE(mpfr_cmp_d(v, i.lower), 0) << f.name << ' ' << x;
      const bool is_gamma = std::string(f.name) == "gamma";
      EXPECT_LE(i.width(), (is_gamma ? 80 : 8) * kEpsilon * i.magnitude()) << f.name << ' ' << x;
      EXPECT_TRUE(i.is_continuous()) << f.name << ' ' << x;
      EXPECT_EQ(i.cause, Cause::none);
      const LongInterval l = f.of_long(LongInterval(static_cast<long double>(x)));
      EXPECT_LE(mpfr_cmp_ld(v, l.upper), 0) << f.name << ' ' << x;
      EXPECT_GE(mpfr_cmp_ld(v, l.lower), 0) << f.name << ' ' << x;
      EXPECT_LE(static_cast<double>(l.width()), 0.1 * kEpsilon * i.magnitude()) << f.name << ' ' << x;
      mpfr_clear(v);
    }
  }
}

TEST(Rounding, RisingFunctionsOverABoxEndWhereTheyDoAtItsEnds) {
  const std::pair<const char*, Interval (*)(const Interval&)> all[] = {
      {"exp", exp},     {"log", log}, {"sqrt", sqrt}, {"atan", atan},   {"sinh", sinh},   {"tanh", tanh},
      {"asinh", asinh}, {"erf", erf}, {"log2", log2}, {"log10", log10}, {"floor", floor}, {"ceil", ceil}};
  for (const auto& [name, f] : all) {
    const Interval box = f(Interval(0.25, 1.75));
    EXPECT_EQ(box.lower, f(Interval(0.25)).lower) << name;
    EXPECT_EQ(box.upper, f(Interval(1.75)).upper) << name;
  }
  EXPECT_EQ(cosh(Interval(-2, 1)).lower, 1);
  EXPECT_EQ(cosh(Interval(-2, 1)).upper, cosh(Interval(2)).upper);
  EXPECT_EQ(acos(Interval(-0.5, 0.5)).lower, acos(Interval(0.5)).lower);
  EXPECT_EQ(acos(Interval(-0.5, 0.5)).upper, acos(Interval(-0.5)).upper);
}

#undef NAZORI_OF

}  // namespace
}  // namespace nazori::functions
