// SPDX-License-Identifier: Apache-2.0
// Which kind of statement a text is, with its range, and what is refused where.
#include <gtest/gtest.h>

#include <string>

#include "nazori/functions/plot.h"

namespace nazori::functions {
namespace {

using K = StatementKind;
using F = SyntaxFault;

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

struct Reading {
  const char* typed;
  K kind;
  const char* canonical;
};

TEST(Statements, AreOfTheKindThatTheyLookLike) {
  const Reading readings[] = {
      {"sin x", K::explicit_y, "y = sin(x)"},
      {"2", K::explicit_y, "y = 2"},
      {"y^2", K::explicit_x, "x = y^2"},
      {"x y", K::surface, "z = x*y"},
      {"x^2 = y", K::explicit_y, "y = x^2"},
      {"y^2 = x", K::explicit_x, "x = y^2"},
      {"y = x", K::explicit_y, "y = x"},
      {"x = y", K::explicit_x, "x = y"},
      {"x = 3", K::explicit_x, "x = 3"},
      {"3 = y", K::explicit_y, "y = 3"},
      {"x = x y", K::implicit, "x = x*y"},
      {"y = x y", K::implicit, "y = x*y"},
      {"x + y = 1", K::implicit, "x + y = 1"},
      {"y < x", K::inequality, "y < x"},
      {"0 <= y = x", K::inequality, "0 <= y = x"},
      {"y(x) = 2x", K::explicit_y, "y = 2*x"},
      {"y(x) + 1 = 2", K::implicit, "y*x + 1 = 2"},
      {"z = x + y", K::surface, "z = x + y"},
      {"x^2 = z", K::surface, "z = x^2"},
      {"r = theta", K::polar, "r = theta; 0 <= theta <= 2*pi"},
      {"2 cos theta = r", K::polar, "r = 2*cos(theta); 0 <= theta <= 2*pi"},
      {"theta", K::polar, "r = theta; 0 <= theta <= 2*pi"},
      {"r = r^2 theta", K::polar_implicit, "r = r^2*theta; 0 <= theta <= 2*pi"},
      {"r^2 = theta; 0 <= theta <= 1", K::polar_implicit, "r^2 = theta; 0 <= theta <= 1"},
      {"r <= theta", K::inequality, "r <= theta"},
      {"x = t; y = 2t", K::parametric, "x = t; y = 2*t; 0 <= t <= 2*pi"},
      {"y = 2t; x = t", K::parametric, "x = t; y = 2*t; 0 <= t <= 2*pi"},
      {"x = 1; y = 2; 0 <= t <= 1", K::parametric, "x = 1; y = 2; 0 <= t <= 1"}};
  for (const Reading& r : readings) {
    const auto plot = parse(r.typed);
    ASSERT_TRUE(plot) << r.typed;
    ASSERT_EQ(plot->statements.size(), 1U) << r.typed;
    EXPECT_EQ(plot->statements[0].kind, r.kind) << r.typed;
    EXPECT_EQ(canonical(*plot), r.canonical) << r.typed;
    EXPECT_EQ(plot->is_surface(), r.kind == K::surface) << r.typed;
  }
}

TEST(Statements, TwoLinesStandBesideEachOtherUnlessTheyShareAParameter) {
  EXPECT_EQ(canonical(*parse("x = 1; y = 2")), "x = 1; y = 2");
  EXPECT_EQ(parse("x = 1; y = 2")->statements.size(), 2U);
  EXPECT_EQ(parse("x = y; y = 2")->statements.size(), 2U);
  EXPECT_EQ(parse("x = t; y = 2; y = 3")->statements.size(), 2U);
  EXPECT_EQ(parse("x = 1; y = t; 0 <= t <= 1; y = x")->statements.size(), 2U);
  EXPECT_EQ(parse("r = 1; 0 <= theta <= 1; r = 2; 1 <= theta <= 2")->statements.size(), 2U);
  EXPECT_EQ(parse(";;y = x;; y = 1;")->statements.size(), 2U);
  EXPECT_EQ(parse("y = x; y = 2x")->statements[1].column, 8);
}

TEST(Statements, ARangeIsKeptWithItsEnds) {
  const auto given = parse("x = t; y = t; 3 >= t > 1");
  ASSERT_TRUE(given);
  const Statement& s = given->statements[0];
  EXPECT_TRUE(s.range_given);
  EXPECT_EQ(to_text(s.from), "1");
  EXPECT_EQ(to_text(s.to), "3");
  const auto customary = parse("x = t; y = t");
  ASSERT_TRUE(customary);
  EXPECT_FALSE(customary->statements[0].range_given);
  EXPECT_FALSE(customary->statements[0].from_is_open);
  EXPECT_EQ(to_text(customary->statements[0].to), "2*pi");
  EXPECT_TRUE(parse("r < 2; 0 <= theta <= 1")->statements[0].range_given);
  EXPECT_FALSE(parse("r < 2")->statements[0].range_given);
}

struct Mistake {
  std::string typed;
  F fault;
  int column;
  std::string subject;
};

TEST(Statements, EveryMistakeIsToldWithItsPlace) {
  const Mistake mistakes[] = {
      {"; ;", F::no_expression, 4, ""},
      {"y = 2 * ; x", F::operand_missing, 9, "*"},
      {"y = x; *2", F::not_an_operand, 8, "*"},
      {"* 2", F::not_an_operand, 1, "*"},
      {"y = x )", F::does_not_fit, 7, ")"},
      {"y = 2 3", F::no_operator, 7, "3"},
      {"y = sin 2 3", F::no_operator, 11, "3"},
      {"y = |x + 1", F::bar_open, 11, ""},
      {"y = (x + 1]", F::bracket_open, 11, "("},
      {"y = min(x, 1", F::bracket_open, 13, "("},
      {"y = [x + 1)", F::bracket_open, 11, "["},
      {"y = {x + 1", F::bracket_open, 11, "{"},
      {"y = sin", F::argument_missing, 8, "sin"},
      {"y = sin * 2", F::argument_missing, 9, "sin"},
      {"y = mod(x)", F::argument_count, 5, "mod"},
      {"y = sin(x, 1)", F::argument_count, 5, "sin"},
      {"y = min(x)", F::argument_count, 5, "min"},
      {"y = mod(x, 1, 2)", F::argument_count, 5, "mod"},
      {"y = x; z = x", F::surface_not_alone, 8, ""},
      {"z = x z", F::height_misplaced, 1, ""},
      {"z < x", F::height_misplaced, 1, ""},
      {"z", F::height_misplaced, 1, ""},
      {"x = t; y = t; 1 <= t <= 0", F::range_empty, 15, ""},
      {"x = t; y = t; 0 <= t <= 1/0", F::range_empty, 15, ""},
      {"x = t; y = t; 1/0 <= t <= 1", F::range_empty, 15, ""},
      {"r = 1; 2 < theta < 2", F::range_empty, 8, ""},
      {"r = 1; 2 < theta <= 2", F::range_empty, 8, ""},
      {"0 <= theta <= 1; r = 1", F::range_misplaced, 1, ""},
      {"y = x; 0 <= t <= 1", F::range_misplaced, 8, ""},
      {"r = 1; 0 <= t <= 1", F::range_misplaced, 8, ""},
      {"0 <= t < 1", F::range_misplaced, 1, ""},
      {"x = t; y = x t", F::parameter_alone, 1, ""},
      {"x = t", F::parameter_alone, 1, ""},
      {"x = t; y < t", F::parameter_alone, 1, ""},
      {"x < t; y = t", F::parameter_alone, 1, ""},
      {"x = t; x = t", F::parameter_alone, 1, ""},
      {"y = t; y = t", F::parameter_alone, 1, ""},
      // Not ranges: a third comparison, one that turns round, an end that is not fixed.
      {"0 <= t >= 1", F::parameter_alone, 1, ""},
      {"0 = t <= 1", F::parameter_alone, 1, ""},
      {"0 <= t <= x", F::parameter_alone, 1, ""},
      {"x <= t <= 1", F::parameter_alone, 1, ""},
      {"0 <= t <= 1 <= 2", F::parameter_alone, 1, ""},
      {"r = x", F::polar_mixed, 1, "x"},
      {"theta + y = 2", F::polar_mixed, 1, "y"},
      {"r + theta", F::nothing_equal, 1, ""}};
  for (const Mistake& m : mistakes) {
    const auto plot = parse(m.typed);
    ASSERT_FALSE(plot) << m.typed;
    EXPECT_EQ(plot.error().fault, m.fault) << m.typed;
    EXPECT_EQ(plot.error().column, m.column) << m.typed;
    EXPECT_EQ(plot.error().subject, m.subject) << m.typed;
  }
}

TEST(Statements, WhatIsNotClosedIsToldWithWhereItWasOpened) {
  const SyntaxError bracket = parse("y = 2[x + (1)").error();
  EXPECT_EQ(bracket.number, 6);
  EXPECT_EQ(bracket.closing, "]");
  EXPECT_EQ(parse("y = (x").error().closing, ")");
  EXPECT_EQ(parse("y = {x").error().closing, "}");
  EXPECT_EQ(parse("y = 2 + |x").error().number, 9);
  const SyntaxError count = parse("y = hypot(1; 2; 3)").error();
  EXPECT_EQ(count.number, 3);
  EXPECT_EQ(count.wanted, 2);
  EXPECT_EQ(parse("y = max(1)").error().wanted, -2);
  EXPECT_EQ(parse("y = ln(1, 2)").error().wanted, 1);
}

TEST(Statements, ThirtyTwoAreReadAndNoMore) {
  EXPECT_EQ(parse(repeated("y = x;", 32))->statements.size(), 32U);
  const auto more = parse(repeated("y = x;", 34));
  ASSERT_FALSE(more);
  EXPECT_EQ(more.error().fault, F::too_many_statements);
  EXPECT_EQ(more.error().column, 32 * 6 + 1);
}

TEST(Statements, EveryKindOfNestIsReadUntilItIsTooDeep) {
  for (const auto& [open, close] : {std::pair<std::string, std::string>{"(", ")"},
                                    {"sin(", ")"},
                                    {"-", ""},
                                    {"2^", ""},
                                    {"sin ", ""},
                                    {"√", ""},
                                    {"2^-", ""},
                                    {"|(", ")|"},
                                    {"sin -", ""}}) {
    EXPECT_TRUE(parse("y = " + repeated(open, 60) + "x" + repeated(close, 60))) << open;
    const auto deep = parse("y = " + repeated(open, 250) + "x" + repeated(close, 250));
    ASSERT_FALSE(deep) << open;
    EXPECT_EQ(deep.error().fault, F::nested_too_deep) << open;
  }
  // Beside each other is not inside each other.
  EXPECT_TRUE(parse("y = " + repeated("(x)+|x|-√x+sin x+2^x+", 300) + "x"));
}

TEST(Statements, FunctionsAreReadWithOrWithoutParentheses) {
  const std::pair<const char*, const char*> readings[] = {{"sin^2 x", "sin(x)^2"},
                                                          {"sin^-1(x)", "asin(x)"},
                                                          {"cos^-1 x", "acos(x)"},
                                                          {"tan⁻¹ x", "atan(x)"},
                                                          {"cot^(-1) x", "acot(x)"},
                                                          {"sinh^-1 x", "asinh(x)"},
                                                          {"cosh^-1 x", "acosh(x)"},
                                                          {"tanh^-1 x", "atanh(x)"},
                                                          {"ln^-1 x", "ln(x)^(-1)"},
                                                          {"sin^-2 x", "sin(x)^(-2)"},
                                                          {"log_3 x", "log_b(3, x)"},
                                                          {"log_3^2(x)", "log_b(3, x)^2"},
                                                          {"sin -x", "sin(-x)"},
                                                          {"sin +x", "sin(x)"},
                                                          {"sin 2x cos 3x", "sin(2*x)*cos(3*x)"},
                                                          {"sin 2pi x", "sin(2*pi*x)"},
                                                          {"sin x^2", "sin(x^2)"},
                                                          {"sin |x|", "sin(|x|)"},
                                                          {"sin (x) x", "sin(x)*x"},
                                                          {"ln x/2", "ln(x)/2"},
                                                          {"min(1, 2, x)", "min(min(1, 2), x)"},
                                                          {"max(x; 1; 2; 3)", "max(max(max(x, 1), 2), 3)"},
                                                          {"√x", "sqrt(x)"},
                                                          {"∛x", "cbrt(x)"},
                                                          {"∜x", "root(4, x)"},
                                                          {"√2x", "sqrt(2)*x"},
                                                          {"√x^2", "sqrt(x^2)"},
                                                          {"|x||2|", "|x|*|2|"},
                                                          {"|(|x|)|", "||x||"},
                                                          {"2(x)(3)", "2*x*3"},
                                                          {"x!!", "x!!"},
                                                          {"x²!", "(x^2)!"},
                                                          {"x^-y", "x^(-y)"},
                                                          {"x^+2", "x^2"},
                                                          {"x^2^3", "x^(2^3)"},
                                                          {"2^-x^2", "2^(-x^2)"},
                                                          {"+x - -x", "x - -x"},
                                                          {"x**2", "x^2"}};
  for (const auto& [typed, written] : readings) {
    const auto plot = parse(std::string("y + x = ") + typed);
    ASSERT_TRUE(plot) << typed << ": " << plot.error().to_error().what;
    EXPECT_EQ(to_text(plot->statements[0].terms[1]), written) << typed;
  }
}

}  // namespace
}  // namespace nazori::functions
