// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/expression.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "../src/strength.h"
#include "nazori/functions/plot.h"

namespace nazori::functions {
namespace {

const Expression kX = variable(Variable::x);
const Expression kY = variable(Variable::y);

Expression read(const std::string& text) {
  const auto plot = parse("x + y = " + text);
  EXPECT_TRUE(plot) << text;
  return plot->statements[0].terms[1];
}

double value_of(Function f, std::vector<double> arguments) {
  std::vector<Expression> numbers;
  for (const double a : arguments) numbers.push_back(number(a));
  return constant_value(call(f, numbers));
}

TEST(Expression, EveryFunctionHasTheNameThatIsTyped) {
  using F = Function;
  const std::pair<F, std::string_view> names[] = {
      {F::sin, "sin"},     {F::cos, "cos"},     {F::tan, "tan"},       {F::cot, "cot"},
      {F::sec, "sec"},     {F::csc, "csc"},     {F::asin, "asin"},     {F::acos, "acos"},
      {F::atan, "atan"},   {F::acot, "acot"},   {F::sinh, "sinh"},     {F::cosh, "cosh"},
      {F::tanh, "tanh"},   {F::coth, "coth"},   {F::sech, "sech"},     {F::csch, "csch"},
      {F::asinh, "asinh"}, {F::acosh, "acosh"}, {F::atanh, "atanh"},   {F::exp, "exp"},
      {F::ln, "ln"},       {F::log10, "log"},   {F::log2, "log2"},     {F::log_base, "log_b"},
      {F::sqrt, "sqrt"},   {F::cbrt, "cbrt"},   {F::root, "root"},     {F::abs, "abs"},
      {F::sign, "sign"},   {F::floor, "floor"}, {F::ceil, "ceil"},     {F::round, "round"},
      {F::trunc, "trunc"}, {F::gamma, "gamma"}, {F::fraction, "frac"}, {F::factorial, "factorial"},
      {F::erf, "erf"},     {F::min, "min"},     {F::max, "max"},       {F::mod, "mod"},
      {F::atan2, "atan2"}, {F::hypot, "hypot"}};
  EXPECT_EQ(std::size(names), static_cast<std::size_t>(F::hypot) + 1);
  for (const auto& [f, name] : names) EXPECT_EQ(name_of(f), name);
  EXPECT_EQ(name_of(Variable::theta), "theta");
  EXPECT_EQ(name_of(Variable::r), "r");
  EXPECT_EQ(name_of(Constant::e), "e");
  EXPECT_EQ(name_of(Constant::tau), "tau");
}

TEST(Expression, NumbersAreWrittenOutWithoutAnExponent) {
  EXPECT_EQ(to_text(number(1e24)), "1" + std::string(24, '0'));
  EXPECT_EQ(to_text(number(-1.5e25)), "-15" + std::string(24, '0'));
  EXPECT_EQ(to_text(number(2.5e-20)), "0." + std::string(19, '0') + "25");
  EXPECT_EQ(to_text(number(-1e-7)), "-0.0000001");
  EXPECT_EQ(to_text(number(12345678901234568.0)), "12345678901234568");
  EXPECT_EQ(to_text(number(0.5)), "0.5");
}

TEST(Expression, IsWrittenWithTheParenthesesThatItNeedsAndNoOthers) {
  for (const char* text :
       {"x + y - 1",     "x - (y - 1)", "x - (y + 1)", "x*y*2",     "x*(y*2)", "x/(y/2)",  "x/y/2",
        "(x/y)*2",       "x*(y/2)",     "(x + 1)*y",   "x*(y + 1)", "-x",      "-(x + 1)", "-(x*y)",
        "--x",           "x^2",         "(x^2)^3",     "x^(2^3)",   "x^(-2)",  "x^(1/2)",  "(-x)^2",
        "-x^2",          "(x + 1)^2",   "2^x!",        "(x + 1)!",  "x!^2",    "|x + 1|",  "sin(x)^2",
        "mod(x + 1, y)", "x*-y",        "x + -y",      "(x*y)^2",   "(x/y)!"}) {
    const std::string written = to_text(read(text));
    const std::string again = to_text(read(written));
    EXPECT_EQ(again, written);
    EXPECT_EQ(written, std::string(text)) << "one reading, one text";
  }
}

TEST(Expression, TheStrengthOfEveryKindIsKnown) {
  EXPECT_EQ(strength(*read("x + y")), 1);
  EXPECT_EQ(strength(*read("x - y")), 1);
  EXPECT_EQ(strength(*read("x*y")), 2);
  EXPECT_EQ(strength(*read("x/y")), 2);
  EXPECT_EQ(strength(*read("-x")), 3);
  EXPECT_EQ(strength(*number(-1)), 3);
  EXPECT_EQ(strength(*read("x^y")), 4);
  EXPECT_EQ(strength(*number(0)), 5);
  EXPECT_EQ(strength(*number(1)), 5);
  EXPECT_EQ(strength(*kX), 5);
  EXPECT_EQ(strength(*read("sin(x)")), 5);
}

TEST(Expression, KnowsItsVariablesAndPutsOthersInTheirPlaces) {
  const Expression e = read("x*sin(y) + x^2");
  EXPECT_EQ(variables_of(e), (std::set{Variable::x, Variable::y}));
  EXPECT_TRUE(variables_of(read("pi + 2")).empty());
  EXPECT_TRUE(depends_on(e, Variable::y));
  EXPECT_FALSE(depends_on(e, Variable::t));
  EXPECT_FALSE(depends_on(number(2), Variable::x));
  EXPECT_EQ(to_text(substitute(e, Variable::x, read("y + 1"))), "(y + 1)*sin(y) + (y + 1)^2");
  // What does not depend on it is shared.
  EXPECT_EQ(substitute(e, Variable::t, kX), e);
  EXPECT_EQ(substitute(kY, Variable::x, kX), kY);
  EXPECT_EQ(substitute(e, Variable::x, kY)->arguments[0]->arguments[1], e->arguments[0]->arguments[1]);
}

TEST(Expression, FractionsAreComputedWithoutRounding) {
  const auto is = [](const std::string& text, std::int64_t p, std::int64_t q) {
    const auto r = rational_value(read(text));
    return r && *r == Rational{p, q};
  };
  EXPECT_TRUE(is("0.2", 1, 5));
  EXPECT_TRUE(is("0.75", 3, 4));
  EXPECT_TRUE(is("-4/6", -2, 3));
  EXPECT_TRUE(is("4/(-6)", -2, 3));
  EXPECT_TRUE(is("1/3 + 1/6", 1, 2));
  EXPECT_TRUE(is("1/3 - 1/2", -1, 6));
  EXPECT_TRUE(is("(2/3)*(3/4)", 1, 2));
  EXPECT_TRUE(is("(2/3)/(4/9)", 3, 2));
  EXPECT_TRUE(is("(-2/3)^3", -8, 27));
  EXPECT_TRUE(is("(2/3)^(-2)", 9, 4));
  EXPECT_TRUE(is("(2/3)^0", 1, 1));
  EXPECT_TRUE(is("0/5", 0, 1));
  EXPECT_TRUE(is("1^64", 1, 1));
  EXPECT_TRUE(is("1^(-63)", 1, 1));
  EXPECT_TRUE(is("2^39", 549'755'813'888, 1));
  EXPECT_TRUE(is("2^(-39)", 1, 549'755'813'888));
  EXPECT_TRUE(is("999999*1000001", 999'999'999'999, 1));
  EXPECT_TRUE(is("999999999999", 999'999'999'999, 1));
  EXPECT_TRUE(is("0.000000001", 1, 1'000'000'000));
  EXPECT_TRUE(is("500000000000 + 499999999999", 999'999'999'999, 1));
}

TEST(Expression, WhatIsNoFractionOrTooLargeOneIsNone) {
  for (const char* text : {"x", "pi", "1/0", "0^(-1)", "2^(1/2)", "sin(0)", "1^65", "1^(-64)", "2^40",
                           "2^(-40)", "1000000*1000001", "999999999999*999999999999", "1000000000001",
                           "0.0000000001", "1/1000000*1/1000001", "1/3 + x", "-x", "x*2",
                           // Only their denominators are beyond 64 bits.
                           "(1/10000000000)^2", "(3/10000000000)^4", "1/10000000000 + 1/10000000001",
                           "7/99999999999 - 1/99999999998"})
    EXPECT_FALSE(rational_value(read(text))) << text;
  EXPECT_FALSE(rational_value(number(std::nan(""))));
  EXPECT_FALSE(rational_value(number(std::numeric_limits<double>::infinity())));
}

TEST(Expression, FunctionsThatAreMadeOfOthersHaveTheirValues) {
  using F = Function;
  EXPECT_DOUBLE_EQ(value_of(F::cot, {0.7}), 1 / std::tan(0.7));
  EXPECT_DOUBLE_EQ(value_of(F::sec, {0.7}), 1 / std::cos(0.7));
  EXPECT_DOUBLE_EQ(value_of(F::csc, {0.7}), 1 / std::sin(0.7));
  EXPECT_DOUBLE_EQ(value_of(F::coth, {0.7}), 1 / std::tanh(0.7));
  EXPECT_DOUBLE_EQ(value_of(F::sech, {0.7}), 1 / std::cosh(0.7));
  EXPECT_DOUBLE_EQ(value_of(F::csch, {0.7}), 1 / std::sinh(0.7));
  EXPECT_DOUBLE_EQ(value_of(F::acot, {1}), std::numbers::pi / 4);
  EXPECT_DOUBLE_EQ(value_of(F::acot, {-1}), 3 * std::numbers::pi / 4);
  EXPECT_DOUBLE_EQ(value_of(F::log_base, {3, 81}), 4);
  EXPECT_DOUBLE_EQ(value_of(F::root, {5, 32}), 2);
  EXPECT_DOUBLE_EQ(value_of(F::cbrt, {-27}), -3);
  EXPECT_DOUBLE_EQ(value_of(F::exp, {2}), std::exp(2));
  EXPECT_EQ(value_of(F::round, {2.5}), 3);
  EXPECT_EQ(value_of(F::round, {2.4}), 2);
  EXPECT_EQ(value_of(F::round, {-2.5}), -2);
  EXPECT_EQ(value_of(F::trunc, {-2.75}), -2);
  EXPECT_EQ(value_of(F::trunc, {2.75}), 2);
  EXPECT_EQ(value_of(F::fraction, {-2.25}), 0.75);
  EXPECT_EQ(value_of(F::mod, {-7, 3}), 2);
  EXPECT_EQ(value_of(F::mod, {7, -3}), -2);
  EXPECT_DOUBLE_EQ(value_of(F::factorial, {5}), 120);
  EXPECT_DOUBLE_EQ(value_of(F::hypot, {3, -4}), 5);
  EXPECT_TRUE(std::isnan(constant_value(read("1/0"))));
  EXPECT_TRUE(std::isnan(constant_value(kX)));
}

TEST(Expression, ReducedHasNoneOfTheFunctionsThatAreMadeOfOthers) {
  EXPECT_EQ(to_text(reduced(read("2cot(sec(x))"))), "2*(cos(1/cos(x))/sin(1/cos(x)))");
  EXPECT_EQ(to_text(reduced(read("sin(x) + y"))), "sin(x) + y");
  EXPECT_EQ(to_text(reduced(read("exp(x)"))), "e^x");
  EXPECT_EQ(reduced(kX), kX);
}

}  // namespace
}  // namespace nazori::functions
