// SPDX-License-Identifier: Apache-2.0
// Slopes, against derivatives as tables have them.
#include "nazori/functions/dual.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "nazori/functions/plot.h"
#include "nazori/functions/tape.h"

namespace nazori::functions {
namespace {

struct Known {
  const char* text;
  std::function<double(double)> slope;
  std::vector<double> places;
};

const std::vector<Known>& table() {
  static const double kLn2 = std::numbers::ln2;
  static const std::vector<Known> all{
      {"-3x", [](double) { return -3.0; }, {-1, 2}},
      {"x^2 + x - 1", [](double x) { return 2 * x + 1; }, {-1, 0, 2}},
      {"1/x", [](double x) { return -1 / (x * x); }, {-2, 0.5}},
      {"(x+1)/(x^2+1)",
       [](double x) { return (x * x + 1 - 2 * x * (x + 1)) / std::pow(x * x + 1, 2); },
       {-2, 0.5, 3}},
      {"|x|", [](double x) { return x < 0 ? -1.0 : 1.0; }, {-2, 3}},
      {"sqrt(x)", [](double x) { return 0.5 / std::sqrt(x); }, {0.25, 4}},
      {"e^x", [](double x) { return std::exp(x); }, {-1, 2}},
      {"ln(x)", [](double x) { return 1 / x; }, {0.5, 4}},
      {"log2(x)", [](double x) { return 1 / (x * kLn2); }, {0.5, 4}},
      {"log(x)", [](double x) { return 1 / (x * std::log(10)); }, {0.5, 4}},
      {"sin(x)", [](double x) { return std::cos(x); }, {-1, 2}},
      {"cos(x)", [](double x) { return -std::sin(x); }, {-1, 2}},
      {"tan(x)", [](double x) { return 1 / std::pow(std::cos(x), 2); }, {-1, 1.2}},
      {"asin(x)", [](double x) { return 1 / std::sqrt(1 - x * x); }, {-0.8, 0.5}},
      {"acos(x)", [](double x) { return -1 / std::sqrt(1 - x * x); }, {-0.8, 0.5}},
      {"atan(x)", [](double x) { return 1 / (1 + x * x); }, {-2, 0.5}},
      {"sinh(x)", [](double x) { return std::cosh(x); }, {-1, 2}},
      {"cosh(x)", [](double x) { return std::sinh(x); }, {-1, 2}},
      {"tanh(x)", [](double x) { return 1 / std::pow(std::cosh(x), 2); }, {-1, 0.5}},
      {"asinh(x)", [](double x) { return 1 / std::sqrt(x * x + 1); }, {-1, 3}},
      {"acosh(x)", [](double x) { return 1 / std::sqrt(x * x - 1); }, {1.5, 3}},
      {"atanh(x)", [](double x) { return 1 / (1 - x * x); }, {-0.8, 0.5}},
      {"erf(x)", [](double x) { return 2 / std::sqrt(std::numbers::pi) * std::exp(-x * x); }, {-1, 0.5}},
      // The slope of gamma at a whole number n + 1 is n! (H_n - 0.5772...).
      {"gamma(x)",
       [](double x) {
         return (x == 1 ? 0 : x == 2 ? 1 : 2 * 1.5) - std::tgamma(x) * 0.5772156649015329;
       },
       {1, 2, 3}},
      {"floor(x)", [](double) { return 0.0; }, {-1.5, 2.5}},
      {"ceil(x)", [](double) { return 0.0; }, {-1.5, 2.5}},
      {"sign(x)", [](double) { return 0.0; }, {-1.5, 2.5}},
      {"x^3", [](double x) { return 3 * x * x; }, {-2, 1.5}},
      {"x^(-2)", [](double x) { return -2 / (x * x * x); }, {-2, 1.5}},
      {"x^(2/3)", [](double x) { return 2.0 / 3 / std::cbrt(x); }, {-8, 1.5}},
      {"x^(-1/3)", [](double x) { return -1.0 / 3 / std::pow(std::cbrt(x), 4); }, {-8, 1.5}},
      {"x^pi", [](double x) { return std::numbers::pi * std::pow(x, std::numbers::pi - 1); }, {0.5, 2}},
      {"2^x", [](double x) { return kLn2 * std::exp2(x); }, {-1, 3}},
      {"x^x", [](double x) { return std::pow(x, x) * (std::log(x) + 1); }, {0.5, 2}},
      {"min(x, x^2)", [](double x) { return x > 0 && x < 1 ? 2 * x : 1; }, {-1, 0.25, 3}},
      {"max(x, x^2)", [](double x) { return x > 0 && x < 1 ? 1 : 2 * x; }, {-1, 0.25, 3}},
      // The angle of (cos, sin) of twice x is twice x.
      {"atan2(3sin(2x), 3cos(2x))", [](double) { return 2.0; }, {0.3, -0.4, 1.2}},
      {"atan2(x, 2)", [](double x) { return 2 / (x * x + 4); }, {-1, 3}},
      {"atan2(2, x)", [](double x) { return -2 / (x * x + 4); }, {-1, 3}}};
  return all;
}

Tape tape_of(const char* text) {
  const auto plot = parse(std::string("y + x = ") + text);
  EXPECT_TRUE(plot) << text;
  return Tape::compile(std::array{plot->statements[0].terms[1]}, std::array{Variable::x});
}

TEST(Dual, SlopesOfNumbersAreTheDerivatives) {
  for (const Known& k : table()) {
    const Tape tape = tape_of(k.text);
    for (const double x : k.places) {
      const auto d = tape.evaluate_one<Dual<double, 1>>(std::array{Dual<double, 1>(x, 0)});
      EXPECT_NEAR(d.slopes[0], k.slope(x), 1e-12 * (1 + std::abs(k.slope(x)))) << k.text << " at " << x;
      EXPECT_NEAR(d.value, tape.evaluate_one<double>(std::array{x}), 1e-14 * (1 + std::abs(d.value)));
    }
  }
}

TEST(Dual, SlopesOfIntervalsEncloseTheDerivativesClosely) {
  for (const Known& k : table()) {
    const Tape tape = tape_of(k.text);
    for (const double x : k.places) {
      const double truth = k.slope(x);
      const double hair = 1e-12 * (1 + std::abs(truth));
      using D = Dual<Interval, 1>;
      const D point = tape.evaluate_one<D>(std::array{D(Interval(x), 0)});
      EXPECT_LE(point.slopes[0].lower, truth + hair) << k.text << " at " << x;
      EXPECT_GE(point.slopes[0].upper, truth - hair) << k.text << " at " << x;
      EXPECT_LT(point.slopes[0].width(), 1e-10 * (1 + std::abs(truth))) << k.text << " at " << x;
      using L = Dual<LongInterval, 1>;
      const L wide = tape.evaluate_one<L>(std::array{L(LongInterval(static_cast<long double>(x)), 0)});
      EXPECT_NEAR(static_cast<double>(wide.slopes[0].middle()), truth, 1e-10 * (1 + std::abs(truth)))
          << k.text;
      // A box holds the slopes at both of its ends.
      const D box = tape.evaluate_one<D>(std::array{D(Interval(x - 0.01, x + 0.01), 0)});
      for (const double end : {x - 0.01, x + 0.01}) {
        if (std::string(k.text) == "gamma(x)") continue;
        EXPECT_LE(box.slopes[0].lower, k.slope(end) + hair) << k.text << " at " << end;
        EXPECT_GE(box.slopes[0].upper, k.slope(end) - hair) << k.text << " at " << end;
      }
    }
  }
}

TEST(Dual, EachVariableHasItsOwnSlope) {
  const auto plot = parse("x + y = x^2 y - x/y + 3");
  ASSERT_TRUE(plot);
  const Tape tape =
      Tape::compile(std::array{plot->statements[0].terms[1]}, std::array{Variable::x, Variable::y});
  using D = Dual<double, 2>;
  const D f = tape.evaluate_one<D>(std::array{D(3, 0), D(2, 1)});
  EXPECT_DOUBLE_EQ(f.value, 18 - 1.5 + 3);
  EXPECT_DOUBLE_EQ(f.slopes[0], 2 * 3 * 2 - 0.5);
  EXPECT_DOUBLE_EQ(f.slopes[1], 9 + 3.0 / 4);
}

TEST(Dual, ACornerHasTheSlopesOfBothItsSidesAndNoneBesideIt) {
  using D = Dual<Interval, 1>;
  const auto slope = [](const char* text, Interval x) {
    return tape_of(text).evaluate_one<D>(std::array{D(x, 0)}).slopes[0];
  };
  EXPECT_EQ(slope("|x|", {0, 1}).lower, -1);
  EXPECT_EQ(slope("|x|", {0, 1}).upper, 1);
  EXPECT_EQ(slope("|x|", {-1, 0}).upper, 1);
  EXPECT_EQ(slope("|x|", {-1, 0}).lower, -1);
  EXPECT_EQ(slope("|x|", {0.5, 1}).lower, 1);
  EXPECT_EQ(slope("|x|", {-1, -0.5}).upper, -1);
  EXPECT_EQ(slope("min(x, 1)", {0, 0.5}).lower, 1);
  EXPECT_EQ(slope("min(x, 1)", {1.5, 2}).upper, 0);
  EXPECT_EQ(slope("min(x, 1)", {1, 2}).upper, 1);
  EXPECT_EQ(slope("min(x, 1)", {1, 2}).lower, 0);
  EXPECT_EQ(slope("min(x, 1)", {0, 1}).lower, 0);
  EXPECT_EQ(slope("min(x, 1)", {0, 1}).upper, 1);
  EXPECT_EQ(slope("max(x, 1)", {0, 0.5}).upper, 0);
  EXPECT_EQ(slope("max(x, 1)", {1.5, 2}).lower, 1);
}

TEST(Dual, AStepHasEverySlopeAndALevelPieceNone) {
  using D = Dual<Interval, 1>;
  for (const char* text : {"floor(x)", "ceil(x)", "sign(x - 1)"}) {
    const Tape tape = tape_of(text);
    const Interval jump = tape.evaluate_one<D>(std::array{D(Interval(0.5, 1.5), 0)}).slopes[0];
    EXPECT_FALSE(jump.is_bounded()) << text;
    const Interval level = tape.evaluate_one<D>(std::array{D(Interval(1.25, 1.75), 0)}).slopes[0];
    EXPECT_TRUE(level.is_point() && level.lower == 0) << text;
  }
}

TEST(Dual, APowerOfANegativeNumberHasASlopeWithoutALogarithm) {
  const Tape tape = Tape::compile(
      std::array{binary(NodeKind::power, variable(Variable::x), call(Function::floor, {number(2.5)}))},
      std::array{Variable::x});
  const auto d = tape.evaluate_one<Dual<double, 1>>(std::array{Dual<double, 1>(-3, 0)});
  EXPECT_EQ(d.value, 9);
  EXPECT_DOUBLE_EQ(d.slopes[0], -6);
}

}  // namespace
}  // namespace nazori::functions
