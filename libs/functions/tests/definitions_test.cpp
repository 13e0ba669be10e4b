// SPDX-License-Identifier: Apache-2.0
// Letters that a text defines: parameters with values and ranges, functions and their derivatives.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "nazori/functions/plot.h"
#include "nazori/functions/tape.h"
#include "nazori/functions/tracing.h"
#include "nazori/functions/value_table.h"
#include "typed_plots.h"

namespace nazori::functions {
namespace {

using F = SyntaxFault;

struct Reading {
  const char* typed;
  const char* canonical;
};

TEST(Definitions, AreReadInAnyOrderAndWrittenBack) {
  const Reading readings[] = {
      {"f(x) = a x^2; a = 2; 0 <= a <= 3", "f(x) = a*x^2; a = 2; 0 <= a <= 3"},
      {"a = 2; y = ax", "y = a*x; a = 2"},
      {"y = ax + b; b = -1; a = 0.5", "y = a*x + b; b = -1; a = 0.5"},
      {"3 >= a >= 0; y = a x", "y = a*x; a = 1.5; 0 <= a <= 3"},
      {"f(x) = x^2; y = f(x-1) + 2", "f(x) = x^2; y = (x - 1)^2 + 2"},
      {"f(t) = t^2; y = 3f(x)", "f(x) = x^2; y = 3*x^2"},
      {"g(x) = f(x) + 1; f(x) = x^3", "g(x) = x^3 + 1; f(x) = x^3"},
      {"+a = 2x; a = 2", "(a) = 2*x; a = 2"},
      {"f(x) = x^3; y = f'(x)", "f(x) = x^3; y = 3*x^2"},
      {"f(x) = x^3; y = f''(x)", "f(x) = x^3; y = 3*(2*x)"},
      {"f(x) = x^3; y = f'(2)", "f(x) = x^3; y = 3*2^2"},
      {"f(x) = ln(x); y = f'(x)", "f(x) = ln(x); y = 1/x {x > 0}"},
      {"f(x) = x {x>0}; y = f(x)", "f(x) = x {x > 0}; y = x {x > 0}"},
      {"a = 2; b = a + 1; y = b x", "y = b*x; a = 2; b = 3"},
      {"a = pi/2; y = sin(x + a)", "y = sin(x + pi/2); a = 1.5707963267948966"},
      {"x = cos(bt); y = sin(t); b = 3", "x = cos(b*t); y = sin(t); 0 <= t <= 2*pi; b = 3"},
      {"a = -2; y = a x - a", "y = a*x - a; a = -2"},
      {"y = A x; a = 2", "y = a*x; a = 2"},
  };
  for (const Reading& r : readings) {
    const auto plot = parse(r.typed);
    ASSERT_TRUE(plot) << r.typed << ": " << plot.error().to_error().what;
    EXPECT_EQ(canonical(*plot), r.canonical) << r.typed;
    const auto again = parse(canonical(*plot));
    ASSERT_TRUE(again) << r.canonical;
    EXPECT_EQ(canonical(*again), r.canonical);
  }
}

TEST(Definitions, ThatCannotBeReadAreRefusedWithTheirColumn) {
  const test::Mistake mistakes[] = {
      {"y = a x", F::unknown_name, 5},
      {"a = 2", F::no_expression, 6},
      {"a = 2; y = x; a = 3", F::defined_twice, 15},
      {"a = b; b = a; y = a x", F::defined_by_itself, 1},
      {"f(x) = f(x-1)", F::defined_by_itself, 1},
      {"f(x) = g(x); g(x) = f(x)", F::defined_by_itself, 14},
      {"a <= a <= 3; y = a x", F::defined_by_itself, 1},
      {"a = x; y = a", F::not_a_number, 1},
      {"a = 1/0; y = a x", F::not_a_number, 1},
      {"f(x) = x y; y = f(x)", F::other_variable, 1},
      {"a = 5; 0 <= a <= 3; y = a x", F::outside_its_range, 1},
      {"a = 5; 3 <= a <= 3; y = a x", F::range_empty, 8},
      {"f(x) = gamma(x); y = f'(x)", F::no_derivative, 22},
      {"f(x) = x; y = f", F::argument_missing, 16},
      {"f(x) = x; y = f(1; 2)", F::argument_count, 15},
      {"f(x) = x; y = f'''''(x)", F::nested_too_deep, 21},
      {"0 <= a <= 1; 0 <= a <= 2; y = a", F::defined_twice, 14},
      {"y = x'", F::does_not_fit, 6},
  };
  test::expect_refused(mistakes);
}

TEST(Definitions, FunctionsOfFunctionsAreRefusedBeforeTheyFillTheMemory) {
  std::string text = "f(x) = x + x + x + x";
  std::string before = "f";
  for (const char letter : std::string("ghijklmnopqsuvw")) {
    const std::string name(1, letter);
    text.append("; ").append(name).append("(x) = ").append(before).append("(").append(before).append("(x))");
    before = name;
  }
  const auto plot = parse(text);
  ASSERT_FALSE(plot);
  EXPECT_EQ(plot.error().fault, F::too_many_parts);
}

TEST(Definitions, SayTheirParameters) {
  const auto plot = parse("f(x) = a x^2; a = -2; -3 <= a <= 3; b = 4");
  ASSERT_TRUE(plot);
  ASSERT_EQ(plot->parameters.size(), 2U);
  EXPECT_EQ(plot->parameters[0].name, "a");
  EXPECT_EQ(plot->parameters[0].value, -2);
  EXPECT_EQ(plot->parameters[0].from, -3);
  EXPECT_EQ(plot->parameters[0].to, 3);
  EXPECT_TRUE(plot->parameters[0].range_given);
  EXPECT_EQ(plot->parameters[1].from, -10);
  EXPECT_EQ(plot->parameters[1].to, 10);
  EXPECT_FALSE(plot->parameters[1].range_given);
  EXPECT_EQ(in_words(*plot, Language::english),
            "f of x equals a times x squared; a equals minus 2, from minus 3 to 3; b equals 4");
  EXPECT_EQ(
      in_words(*plot, Language::japanese),
      "f、x の関数 イコール a かける x の 2 乗。a イコール マイナス2、マイナス3 から 3 まで。b イコール 4");
  EXPECT_EQ(parse("a = 20; y = a x")->parameters[0].to, 20);
  EXPECT_EQ(parse("a = -20; y = a x")->parameters[0].from, -20);
}

TEST(Definitions, AValueIsChangedInTheText) {
  EXPECT_EQ(with_parameter("y = a x; a = 2; 0 <= a <= 3", "a", 1.5), "y = a x; a = 1.5; 0 <= a <= 3");
  EXPECT_EQ(with_parameter("a = 2 ; y = a x", "a", -0.25), "a = -0.25 ; y = a x");
  EXPECT_EQ(with_parameter("y = a x²; 0 <= a <= 3", "a", 1), "y = a x²; 0 <= a <= 3; a = 1");
  EXPECT_EQ(with_parameter("y = π a; a = 2", "a", 3), "y = π a; a = 3");
  EXPECT_EQ(with_parameter("y = a x; a = 2", "b", 1), std::nullopt);
  EXPECT_EQ(with_parameter("f(x) = x", "f", 1), std::nullopt);
  EXPECT_EQ(with_parameter("y = ", "a", 1), std::nullopt);
  EXPECT_EQ(with_parameter("a = 2; y = a", "a", std::nan("")), std::nullopt);
}

double second(const std::string& text, double x) {
  const auto plot = parse(text);
  EXPECT_TRUE(plot) << text;
  if (!plot || plot->statements.size() < 2) return 0;
  const Tape tape = Tape::compile(std::span(plot->statements[1].terms).first(1), std::array{Variable::x});
  return tape.evaluate_one<double>(std::array{x});
}

TEST(Definitions, ADerivativeIsDefinedOnlyWhereItExists) {
  const auto slope = [](const std::string& f, double x) { return second("f(x) = " + f + "; y = f'(x)", x); };
  EXPECT_DOUBLE_EQ(slope("sin(x)^2", 0.7), std::sin(1.4));
  EXPECT_DOUBLE_EQ(slope("ln(x)", 2), 0.5);
  EXPECT_TRUE(std::isnan(slope("ln(x)", -2)));
  EXPECT_TRUE(std::isnan(slope("log(x)", -2)));
  EXPECT_DOUBLE_EQ(slope("|x|", -2), -1);
  EXPECT_TRUE(std::isnan(slope("|x|", 0)));
  EXPECT_TRUE(std::isnan(slope("sqrt(x)", 0)));
  EXPECT_TRUE(std::isnan(slope("acosh(x)", -2)));
  EXPECT_NEAR(slope("acosh(x)", 2), 1 / std::sqrt(3), 1e-15);
  EXPECT_TRUE(std::isnan(slope("atanh(x)", 2)));
  EXPECT_EQ(slope("floor(x)", 1.5), 0);
  EXPECT_TRUE(std::isnan(slope("floor(x)", 1)));
  EXPECT_TRUE(std::isnan(slope("ceil(x)", 1)));
  EXPECT_TRUE(std::isnan(slope("sign(x)", 0)));
  EXPECT_EQ(slope("max(x, 2x)", 3), 2);
  EXPECT_TRUE(std::isnan(slope("max(x, 2x)", 0)));
  // Two cases with a corner, and two that are smooth where they meet.
  EXPECT_TRUE(std::isnan(slope("{x<0: -x, x}", 0)));
  EXPECT_EQ(slope("{x<0: -x, x}", -1), -1);
  EXPECT_EQ(slope("{x<0: -x, x}", 1), 1);
  EXPECT_EQ(slope("{x<0: x^2, x^3}", 0), 0);
  EXPECT_TRUE(std::isnan(slope("{x<0: x^2, x^2+1}", 0)));
  EXPECT_EQ(slope("{0<=x<=2: x^2}", 1), 2);
  EXPECT_TRUE(std::isnan(slope("{0<=x<=2: x^2}", 2)));
  EXPECT_TRUE(std::isnan(slope("{x=1: x^2}", 1)));
}

TEST(Definitions, AParameterIsAsExactAsItsNumber) {
  // 1/2 is a double, 0.1 is not: its enclosure has two ends.
  const auto ends = [](const std::string& text) {
    const auto plot = parse(text);
    const Tape tape = Tape::compile(std::span(plot->statements[0].terms).first(1), std::array{Variable::x});
    const Interval v = tape.evaluate_one<Interval>(std::array{Interval(1.0)});
    return v.upper - v.lower;
  };
  EXPECT_EQ(ends("y = a; a = 1/2"), 0);
  EXPECT_EQ(ends("y = a; a = -0.5"), 0);
  EXPECT_GT(ends("y = a; a = 0.1"), 0);
  EXPECT_GT(ends("y = a; a = 1/3"), 0);
  EXPECT_GT(ends("y = a; a = -0.1"), 0);
}

TEST(Definitions, AParameterKeepsItsLetterWhateverItsNumber) {
  for (const char* value : {"2", "-2", "0.3333333333333333", "-0.3333333333333333", "33333333333"}) {
    const std::string text = fmt::format("y = x; x = a*y*a; a = {}", value);
    const auto plot = parse(text);
    ASSERT_TRUE(plot) << text;
    EXPECT_EQ(canonical(*plot), text);
  }
}

TEST(ValueTable, HasARowForEachStep) {
  const auto plot = parse("y = 1/x");
  const auto rows = value_table(plot->statements[0], {-1, 1, 0.5});
  ASSERT_TRUE(rows);
  ASSERT_EQ(rows->size(), 5U);
  EXPECT_EQ((*rows)[0].y, -1);
  EXPECT_EQ((*rows)[3].x, 0.5);
  EXPECT_EQ((*rows)[3].y, 2);
  EXPECT_TRUE(std::isnan((*rows)[2].y));
  EXPECT_EQ(value_table(plot->statements[0], {0, 1, 0.1})->size(), 11U);
  EXPECT_EQ((*value_table(plot->statements[0], {0, 1, 0.1}))[7].x, 7 * 0.1);
  const auto circle = parse("x = cos(t); y = sin(t)");
  const auto turn = value_table(circle->statements[0], {0, 3, 3});
  ASSERT_TRUE(turn);
  EXPECT_EQ((*turn)[1].parameter, 3);
  EXPECT_EQ((*turn)[1].x, std::cos(3.0));
  EXPECT_EQ((*turn)[1].y, std::sin(3.0));
}

TEST(ValueTable, RefusesStepsThatLeadNowhereAndWhatHasNoCourse) {
  const Statement line = parse("y = x")->statements[0];
  EXPECT_FALSE(value_table(line, {0, 1, 0}));
  EXPECT_FALSE(value_table(line, {0, 1, -1}));
  EXPECT_FALSE(value_table(line, {1, 0, 1}));
  EXPECT_FALSE(value_table(line, {0, 10'000, 1}));
  EXPECT_TRUE(value_table(line, {0, 9'999, 1}));
  EXPECT_TRUE(value_table(line, {1, 1, 1}));
  EXPECT_FALSE(value_table(parse("x^2 + y^2 = 1")->statements[0], {0, 1, 1}));
}

}  // namespace
}  // namespace nazori::functions
