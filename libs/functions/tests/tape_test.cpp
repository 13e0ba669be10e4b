// SPDX-License-Identifier: Apache-2.0
// Tapes and the plain numbers that they compute with.
#include "nazori/functions/tape.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "nazori/functions/plot.h"

namespace nazori::functions {
namespace {

constexpr std::array kXY{Variable::x, Variable::y};
constexpr double kInf = std::numeric_limits<double>::infinity();

Expression read(const std::string& text) {
  const auto plot = parse("x + y = " + text);
  EXPECT_TRUE(plot) << text;
  return plot->statements[0].terms[1];
}
Tape tape_of(const std::string& text) { return Tape::compile(std::array{read(text)}, kXY); }
double at(const std::string& text, double x, double y = 0) {
  return tape_of(text).evaluate_one<double>(std::array{x, y});
}

TEST(Tape, EqualPartsAreDoneOnce) {
  EXPECT_EQ(tape_of("sin(x) + sin(x)^3 + sin(x)").size(), 5U) << "x, sin, cube, two sums";
  EXPECT_EQ(tape_of("x").size(), 1U);
  EXPECT_EQ(tape_of("x^1").size(), 1U);
  EXPECT_EQ(tape_of("x - y + (x - y)/2").size(), 6U) << "x, y, x - y, 2, quotient, sum";
  EXPECT_EQ(tape_of("0.1x + 0.1y").size(), 6U) << "x, y, 0.1, two products, sum";
}

TEST(Tape, ASquareIsNeverBelowZeroHoweverItIsTyped) {
  for (const char* text : {"x*x", "x^2", "x^2.0"}) {
    const Interval square = tape_of(text).evaluate_one<Interval>(std::array{Interval(-1, 2), Interval(0)});
    EXPECT_EQ(square.lower, 0) << text;
    EXPECT_EQ(square.upper, 4) << text;
  }
}

TEST(Tape, OutputsAndInputsKeepTheirOrder) {
  const std::array outputs{read("y - 3"), read("x"), read("2x")};
  const Tape tape = Tape::compile(outputs, std::array{Variable::y, Variable::x});
  ASSERT_EQ(tape.output_count(), 3U);
  std::vector<double> registers(tape.size());
  tape.evaluate<double>(std::array{10.0, 7.0}, registers);
  EXPECT_EQ(registers[tape.output(0)], 7);
  EXPECT_EQ(registers[tape.output(1)], 7);
  EXPECT_EQ(registers[tape.output(2)], 14);
}

TEST(Tape, KnowsWhatCanGrowOverTheFormat) {
  for (const char* text :
       {"e^x", "exp(x)", "2^x", "x^y", "x^3", "x^(2/3)", "sinh(x)", "cosh(x)", "gamma(x)", "x!", "sin(e^x)"})
    EXPECT_TRUE(tape_of(text).can_overflow()) << text;
  for (const char* text : {"x", "x^2", "sqrt(x)", "x^(1/2)", "sin(x)*y/x", "ln(x)", "tanh(x)", "erf(x)"})
    EXPECT_FALSE(tape_of(text).can_overflow()) << text;
}

TEST(Tape, VariablesThatAreNoInputsAreUndefined) {
  const Tape tape = Tape::compile(std::array{read("x + y")}, std::array{Variable::x});
  EXPECT_TRUE(std::isnan(tape.evaluate_one<double>(std::array{1.0})));
  EXPECT_TRUE(tape.evaluate_one<Interval>(std::array{Interval(1)}).is_empty());
}

TEST(Tape, ConstantsAreEnclosedByTheirNeighboursUnlessTheyAreExact) {
  const auto constant_of = [](const Expression& e) {
    return Tape::compile(std::array{e}, kXY).evaluate_one<Interval>(std::array{Interval(0), Interval(0)});
  };
  for (const auto& [which, value] :
       {std::pair{Constant::pi, std::numbers::pi}, std::pair{Constant::e, std::numbers::e},
        std::pair{Constant::tau, 2 * std::numbers::pi}}) {
    const Interval i = constant_of(constant(which));
    EXPECT_EQ(i.lower, std::nextafter(value, 0));
    EXPECT_EQ(i.upper, std::nextafter(value, 10));
    EXPECT_EQ(constant_value(constant(which)), value);
  }
  EXPECT_TRUE(constant_of(number(0.5, true)).is_point());
  EXPECT_EQ(constant_of(number(0.1, false)).lower, std::nextafter(0.1, 0));
  EXPECT_EQ(constant_of(number(0.1, false)).upper, std::nextafter(0.1, 1));
}

TEST(Tape, EveryFunctionIsTheOneThatItIsCalled) {
  const std::pair<const char*, double> values[] = {{"sin(x)", std::sin(0.4)},
                                                   {"cos(x)", std::cos(0.4)},
                                                   {"tan(x)", std::tan(0.4)},
                                                   {"asin(x)", std::asin(0.4)},
                                                   {"acos(x)", std::acos(0.4)},
                                                   {"atan(x)", std::atan(0.4)},
                                                   {"sinh(x)", std::sinh(0.4)},
                                                   {"cosh(x)", std::cosh(0.4)},
                                                   {"tanh(x)", std::tanh(0.4)},
                                                   {"asinh(x)", std::asinh(0.4)},
                                                   {"acosh(x+1)", std::acosh(1.4)},
                                                   {"atanh(x)", std::atanh(0.4)},
                                                   {"ln(x)", std::log(0.4)},
                                                   {"log2(x)", std::log2(0.4)},
                                                   {"log(x)", std::log10(0.4)},
                                                   {"sqrt(x)", std::sqrt(0.4)},
                                                   {"|-x|", 0.4},
                                                   {"sign(-x)", -1},
                                                   {"floor(-x)", -1},
                                                   {"ceil(x)", 1},
                                                   {"gamma(x)", std::tgamma(0.4)},
                                                   {"erf(x)", std::erf(0.4)},
                                                   {"min(x, y)", 0.4},
                                                   {"max(x, y)", 2},
                                                   {"atan2(x, y)", std::atan2(0.4, 2)},
                                                   {"-x", -0.4},
                                                   {"x^y", 0.4 * 0.4},
                                                   {"y^3", 8},
                                                   {"y^(2/3)", std::cbrt(4)},
                                                   {"x - y", -1.6},
                                                   {"x/y", 0.2},
                                                   {"x*y", 0.8},
                                                   {"2^x", std::exp2(0.4)}};
  for (const auto& [text, value] : values) {
    EXPECT_DOUBLE_EQ(at(text, 0.4, 2), value) << text;
    const auto l = tape_of(text).evaluate_one<long double>(std::array{0.4L, 2.0L});
    EXPECT_NEAR(static_cast<double>(l), value, 1e-14) << text;
    const Interval i = tape_of(text).evaluate_one<Interval>(std::array{Interval(0.4), Interval(2)});
    EXPECT_NEAR(i.lower, value, 1e-13) << text;
    EXPECT_NEAR(i.upper, value, 1e-13) << text;
  }
}

TEST(Tape, IsUndefinedWhereTheFunctionIs) {
  for (const auto& [text, x] :
       {std::pair{"1/x", 0.0}, std::pair{"ln(x)", 0.0}, std::pair{"ln(x)", -1.0}, std::pair{"log2(x)", 0.0},
        std::pair{"log(x)", 0.0}, std::pair{"sqrt(x)", -1.0}, std::pair{"x^(-2)", 0.0},
        std::pair{"x^(-1/3)", 0.0}, std::pair{"x^(1/4)", -1.0}, std::pair{"x^x", 0.0}, std::pair{"x^x", -0.5},
        std::pair{"gamma(x)", -3.0}, std::pair{"gamma(x)", 0.0}}) {
    EXPECT_TRUE(std::isnan(at(text, x))) << text << " at " << x;
  }
}

TEST(PlainNumbers, PowersFollowTheRealRoots) {
  EXPECT_EQ(power_rational(-8.0, 1, 3), -2);
  EXPECT_EQ(power_rational(-8.0, 2, 3), 4);
  EXPECT_EQ(power_rational(4.0, 3, 2), 8);
  EXPECT_EQ(power_rational(4.0, 1, 2), 2);
  EXPECT_DOUBLE_EQ(power_rational(32.0, 2, 5), 4);
  EXPECT_DOUBLE_EQ(power_rational(-32.0, 3, 5), -8);
  EXPECT_DOUBLE_EQ(power_rational(-32.0, -1, 5), -0.5);
  EXPECT_TRUE(std::isnan(power_rational(-4.0, 1, 2)));
  EXPECT_TRUE(std::isnan(power_rational(0.0, -1, 3)));
  EXPECT_EQ(power_rational(0.0, 1, 3), 0);
  EXPECT_DOUBLE_EQ(static_cast<double>(power_rational(-8.0L, 1, 3)), -2);
  EXPECT_EQ(power_integer(-2.0, 3), -8);
  EXPECT_EQ(power_integer(-2.0, -2), 0.25);
  EXPECT_EQ(power_integer(0.0, 0), 1);
  EXPECT_TRUE(std::isnan(power_integer(0.0, -1)));
  EXPECT_TRUE(std::isnan(power_integer(0.0L, -1)));
  EXPECT_EQ(power_integer(0.0L, 2), 0);
  EXPECT_EQ(power_integer(2.0L, -1), 0.5L);
  EXPECT_TRUE(std::isnan(power_integer(std::nan(""), 0)));
  EXPECT_TRUE(std::isnan(power(0.0, 0.0)));
  EXPECT_TRUE(std::isnan(power(0.0, -1.0)));
  EXPECT_EQ(power(0.0, 0.5), 0);
  EXPECT_TRUE(std::isnan(power(-2.0, 0.5)));
  EXPECT_EQ(power(-2.0, 3.0), -8);
  EXPECT_TRUE(std::isnan(power(1.0, std::nan(""))));
  EXPECT_TRUE(std::isnan(power(std::nan(""), 0.0)));
}

TEST(PlainNumbers, GammaAndItsSlopeHaveTheirKnownValues) {
  constexpr double kEuler = 0.57721566490153286;
  EXPECT_DOUBLE_EQ(gamma(0.5), std::sqrt(std::numbers::pi));
  EXPECT_DOUBLE_EQ(gamma(-0.5), -2 * std::sqrt(std::numbers::pi));
  EXPECT_DOUBLE_EQ(gamma(5.0), 24);
  EXPECT_TRUE(std::isnan(gamma(0.0)));
  EXPECT_TRUE(std::isnan(gamma(-2.0)));
  EXPECT_TRUE(std::isnan(gamma(-2.0L)));
  EXPECT_NEAR(digamma(1.0), -kEuler, 1e-14);
  EXPECT_NEAR(digamma(0.5), -kEuler - 2 * std::log(2), 1e-14);
  EXPECT_NEAR(digamma(-0.5), 2 - kEuler - 2 * std::log(2), 1e-13);
  EXPECT_NEAR(static_cast<double>(digamma(2.0L)), 1 - kEuler, 1e-14);
  EXPECT_NEAR(digamma(1e305), std::log(1e305), 1e-10);
  EXPECT_TRUE(std::isnan(digamma(0.0)));
  EXPECT_TRUE(std::isnan(digamma(-3.0)));
  EXPECT_TRUE(std::isnan(digamma(-kInf)));
  EXPECT_TRUE(std::isnan(digamma(std::nan(""))));
}

TEST(PlainNumbers, WhatIsNoNumberStaysNone) {
  const double nan = std::nan("");
  EXPECT_TRUE(std::isnan(sign(nan)));
  EXPECT_EQ(sign(-3.0), -1);
  EXPECT_EQ(sign(0.0), 0);
  EXPECT_EQ(sign(0.5L), 1);
  EXPECT_TRUE(std::isnan(min(nan, 1.0)));
  EXPECT_TRUE(std::isnan(min(1.0, nan)));
  EXPECT_TRUE(std::isnan(max(nan, 1.0)));
  EXPECT_TRUE(std::isnan(max(1.0, nan)));
  EXPECT_EQ(min(2.0, 1.0), 1);
  EXPECT_EQ(min(1.0, 2.0), 1);
  EXPECT_EQ(max(2.0, 1.0), 2);
  EXPECT_EQ(max(1.0L, 2.0L), 2);
  EXPECT_EQ(min(1.0L, 2.0L), 1);
  EXPECT_EQ(square(-3.0), 9);
}

}  // namespace
}  // namespace nazori::functions
