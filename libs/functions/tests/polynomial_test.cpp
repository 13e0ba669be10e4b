// SPDX-License-Identifier: Apache-2.0
// Polynomials multiplied out, and the equations that are taken apart with them.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "../src/algebra.h"
#include "../src/equation.h"
#include "nazori/functions/plot.h"
#include "nazori/functions/tape.h"

namespace nazori::functions {
namespace {

Expression read(const std::string& text) {
  const auto plot = parse("x + y = " + text);
  EXPECT_TRUE(plot) << text;
  return plot->statements[0].terms[1];
}

std::optional<Polynomial> of(const std::string& text) { return Polynomial::of(read(text)); }

TEST(Polynomial, IsMultipliedOutWithoutRounding) {
  for (const char* text :
       {"(x+y)^2 - x^2 - 2x y - y^2", "(x-1)(x+1) - x^2 + 1", "2x/4 - x/2",
        "sin(x)(1+sin(x)) - sin(x)^2 - sin(x)", "e^(2x) - e^x e^x", "e^x e^(-x) - 1", "2^(3x) - (2^x)^3",
        "e^(-(2x)) e^x e^x - 1", "-(x - y) - (y - x)", "x^0 - 1", "(x+1)^3 - x^3 - 3x^2 - 3x - 1",
        "0.1x - 0.1x", "e^(2*3x) - e^(3*2x)", "2(x/2) - x"})
    EXPECT_TRUE(of(text) && of(text)->is_zero()) << text;
  for (const char* text :
       {"x", "x - y", "x^2 - x", "0.3x - 0.1x", "1", "1/x - 1/y", "2^x - 3^x", "x^y - y^x"})
    EXPECT_TRUE(of(text) && !of(text)->is_zero()) << text;
  // A coefficient that would be rounded: a third.
  EXPECT_FALSE(of("x/3"));
  EXPECT_FALSE(Polynomial::of(binary(NodeKind::add, number(1e20), number(1))));
  EXPECT_FALSE(Polynomial::of(binary(NodeKind::multiply, number(1e300), number(1e300))));
  EXPECT_FALSE(of("(1 + x + y + sin(x) + cos(x) + ln(x))^8")) << "over a thousand terms";
  EXPECT_TRUE(of("(x + y)^40"));
  EXPECT_TRUE(of("(x + y)^41")) << "as one atom";
  EXPECT_TRUE(of("(x + y)^41")->in_one_atom());
  EXPECT_FALSE(of("(x + y)^40")->in_one_atom());
}

TEST(Polynomial, KnowsWhatItDependsOn) {
  EXPECT_TRUE(of("x y - x")->depends_on(Variable::y));
  EXPECT_FALSE(of("x y - y x + x")->depends_on(Variable::y)) << "it cancels";
  EXPECT_TRUE(of("sin(y) + x")->depends_on(Variable::y));
  EXPECT_EQ(of("x - x")->constant(), 0);
  EXPECT_EQ(of("x - x + 3")->constant(), 3);
  EXPECT_EQ(of("2*3 - 1")->constant(), 5);
  EXPECT_FALSE(of("x")->constant());
  EXPECT_FALSE(of("x + 3")->constant());
}

TEST(Polynomial, TellsALonePowerAndALinearFactor) {
  EXPECT_EQ(of("3y + x^2 - 1")->linear_factor(Variable::y), 3);
  EXPECT_EQ(of("x^2 - y/2")->linear_factor(Variable::y), -0.5);
  EXPECT_FALSE(of("y^2 + x")->linear_factor(Variable::y));
  EXPECT_FALSE(of("x y + 1")->linear_factor(Variable::y));
  EXPECT_FALSE(of("y + sin(y)")->linear_factor(Variable::y));
  EXPECT_FALSE(of("x + 1")->linear_factor(Variable::y));
  EXPECT_FALSE(of("y + y^2")->linear_factor(Variable::y));
  const auto lone = of("2y^3 - sin(x)")->lone_power(Variable::y);
  ASSERT_TRUE(lone);
  EXPECT_EQ(lone->power, 3);
  EXPECT_EQ(lone->factor, 2);
}

TEST(Polynomial, TellsTheCoefficientsOfOneAtom) {
  const auto cubic = of("2x^3 - 5x + 7")->in_one_atom();
  ASSERT_TRUE(cubic);
  EXPECT_EQ(to_text(cubic->atom), "x");
  EXPECT_EQ(cubic->lowest, 0);
  EXPECT_EQ(cubic->coefficients, (std::vector<double>{7, -5, 0, 2}));
  const auto wave = of("e^x - 3e^(-2x)")->in_one_atom();
  ASSERT_TRUE(wave);
  EXPECT_EQ(to_text(wave->atom), "e^x");
  EXPECT_EQ(wave->lowest, -2);
  EXPECT_EQ(wave->coefficients, (std::vector<double>{-3, 0, 0, 1}));
  const auto plain = of("4 + 1")->in_one_atom();
  ASSERT_TRUE(plain);
  EXPECT_EQ(plain->atom, nullptr);
  EXPECT_EQ(plain->coefficients, (std::vector<double>{5}));
  const auto high = of("x^3 + x^5")->in_one_atom();
  ASSERT_TRUE(high);
  EXPECT_EQ(high->lowest, 3);
  EXPECT_EQ(high->coefficients, (std::vector<double>{1, 0, 1}));
  EXPECT_FALSE(of("x + y")->in_one_atom());
  EXPECT_FALSE(of("x y")->in_one_atom());
  EXPECT_FALSE(of("x - x")->in_one_atom());
  EXPECT_TRUE(of("1 + x^40")->in_one_atom());
  EXPECT_FALSE(of("e^(16x)e^(16x) + e^(-(16x))")->in_one_atom()) << "48 powers";
}

TEST(Polynomial, ASquareIsKnownByItsRoot) {
  const auto at = [](const Expression& e, double x, double y) {
    return Tape::compile(std::array{e}, std::array{Variable::x, Variable::y})
        .evaluate_one<double>(std::array{x, y});
  };
  for (const char* text :
       {"x^2 - 2x y + y^2", "2x^2 - 4x y + 2y^2", "x^4 + 2x^2 y + y^2", "(x + y - 3)^2", "(x^2 + y^2 - 1)^2",
        "(x^3 - x y + 2y - 5)^2", "sin(x)^2 + 2sin(x) y + y^2", "4x^2 + 4x + 1", "3(x^2 y - y + 1)^2"}) {
    const Expression root = of(text)->square_root();
    ASSERT_TRUE(root) << text;
    // Its square is the whole but for one factor.
    const double factor = at(read(text), 0.3, 0.7) / std::pow(at(root, 0.3, 0.7), 2);
    for (const auto& [x, y] : {std::pair{-0.4, 1.3}, std::pair{2.1, -0.6}})
      EXPECT_NEAR(at(read(text), x, y), factor * std::pow(at(root, x, y), 2), 1e-9) << text;
  }
  EXPECT_EQ(to_text(of("x^2 - 2x y + y^2")->square_root()), "x + -1*y");
  EXPECT_EQ(to_text(of("4x^2 + 4x + 1")->square_root()), "0.5 + x");
  for (const char* text : {"x^2", "x^2 + y^2", "x^2 + 2x y + 2y^2", "x^2 - 2x y - y^2", "x^3 + 2x + 1",
                           "x^2 + x + 1", "x^2 - 2x + 2", "x^2 y + 2x y + y", "x^4 + 2x^3 + x^2 + 1"})
    EXPECT_FALSE(of(text)->square_root()) << text;
}

EquationParts parts_of(const std::string& text, const std::array<double, 2>& low = {-4, -4},
                       const std::array<double, 2>& high = {4, 4}) {
  const auto plot = parse(text);
  EXPECT_TRUE(plot) << text;
  const Statement& s = plot->statements[0];
  EXPECT_EQ(s.kind, StatementKind::implicit) << text;
  return split_equation(s.terms[0], s.terms[1], low, high);
}

TEST(TakeApart, SolvesWhatIsLinearInOneVariable) {
  const EquationParts y = parts_of("2y + x^2 = 4", {-1, -2}, {3, 5});
  ASSERT_EQ(y.arcs.size(), 1U);
  EXPECT_TRUE(y.equations.empty());
  EXPECT_EQ(y.arcs[0].parameter, Variable::x);
  EXPECT_EQ(to_text(y.arcs[0].x), "x");
  EXPECT_EQ(y.arcs[0].from, -1);
  EXPECT_EQ(y.arcs[0].to, 3);
  EXPECT_FALSE(y.arcs[0].ends_are_real);
  const auto at = [](const Expression& e, Variable v, double c) {
    return Tape::compile(std::array{e}, std::array{v}).evaluate_one<double>(std::array{c});
  };
  EXPECT_EQ(at(y.arcs[0].y, Variable::x, 2), 0);
  EXPECT_EQ(at(y.arcs[0].y, Variable::x, 1), 1.5);
  const EquationParts x = parts_of("y^3 - 3x = x + 2", {-1, -2}, {3, 5});
  ASSERT_EQ(x.arcs.size(), 1U);
  EXPECT_EQ(x.arcs[0].parameter, Variable::y);
  EXPECT_EQ(x.arcs[0].from, -2);
  EXPECT_EQ(x.arcs[0].to, 5);
  EXPECT_EQ(at(x.arcs[0].x, Variable::y, 2), 1.5);
  EXPECT_EQ(to_text(x.arcs[0].y), "y");
  for (const auto& [text, value] :
       {std::pair{"y - x^2 = sin(x)", 4 + std::sin(2.0)}, std::pair{"x^2 - y = 1", 3.0}})
    EXPECT_DOUBLE_EQ(at(parts_of(text).arcs[0].y, Variable::x, 2), value) << text;
}

TEST(TakeApart, FactorsInOneVariableAreLines) {
  const EquationParts p = parts_of("(x^2 - 4)(y - 1) = 0", {-3, -1}, {3, 2});
  ASSERT_EQ(p.arcs.size(), 3U);
  EXPECT_TRUE(p.equations.empty());
  EXPECT_EQ(to_text(p.arcs[0].x), "-2");
  EXPECT_EQ(to_text(p.arcs[0].y), "y");
  EXPECT_EQ(p.arcs[0].parameter, Variable::y);
  EXPECT_EQ(p.arcs[0].from, -1);
  EXPECT_EQ(p.arcs[0].to, 2);
  EXPECT_EQ(to_text(p.arcs[1].x), "2");
  EXPECT_EQ(p.arcs[2].parameter, Variable::x);
  EXPECT_EQ(p.arcs[2].from, -3);
  EXPECT_EQ(to_text(p.arcs[2].y), "1");
  EXPECT_EQ(parts_of("(x^2 - 4)(y - 1) = 0", {-1, -1}, {3, 0.5}).arcs.size(), 1U) << "the others are outside";
  EXPECT_EQ(parts_of("x^2 + x y = x y + 4").arcs.size(), 2U) << "y cancels";
}

TEST(TakeApart, SquaresAreReplacedByTheirRoots) {
  const EquationParts p = parts_of("x^2 + y^2 = 2x y");
  EXPECT_TRUE(p.equations.empty());
  EXPECT_EQ(p.arcs.size(), 1U);
}

TEST(TakeApart, TheRestGoesToThePlaneWithWhatMustBeDefined) {
  const EquationParts p = parts_of("(x^2 + y^2 - 1)/(x - y) = 0");
  ASSERT_EQ(p.equations.size(), 1U);
  EXPECT_TRUE(p.arcs.empty());
  const auto at = [](const Expression& e, double x, double y) {
    return Tape::compile(std::array{e}, std::array{Variable::x, Variable::y})
        .evaluate_one<double>(std::array{x, y});
  };
  EXPECT_EQ(at(p.equations[0].function, 2, 1), 4);
  EXPECT_TRUE(std::isnan(at(p.equations[0].whole, 1, 1)));
  EXPECT_FALSE(std::isnan(at(p.equations[0].whole, 1, 2)));
  // No root is taken of an expression equal to zero: rounding would make it undefined.
  const EquationParts root = parts_of("sqrt(x^2 + y^2 - 1) = 0");
  ASSERT_EQ(root.equations.size(), 1U);
  EXPECT_EQ(at(root.equations[0].whole, 0.1, 0.1), 0);
  EXPECT_EQ(parts_of("(x^2 + y^2 - 1)(x^2 + 2y^2 - 3)(x - y) = 0").equations.size(), 2U);
  EXPECT_EQ(parts_of("(x^2 + y^2 - 1)(x^2 + 2y^2 - 3)(x - y) = 0").arcs.size(), 1U);
}

TEST(TakeApart, SolutionsCountOnlyWhereTheEquationIsDefined) {
  const EquationParts p = parts_of("(y - 2)/(x - 1) = 0");
  ASSERT_FALSE(p.arcs.empty());
  for (const Arc& arc : p.arcs) {
    EXPECT_TRUE(std::isnan(
        Tape::compile(std::array{arc.y}, std::array{Variable::x}).evaluate_one<double>(std::array{1.0})));
  }
}

TEST(TakeApart, WhatHoldsOnAnAreaIsToldWithItsConditions) {
  const EquationParts p = parts_of("|x| + |y| = x + y");
  ASSERT_EQ(p.areas.size(), 1U);
  EXPECT_EQ(p.areas[0].size(), 2U);
  EXPECT_EQ(p.equations.size(), 1U);
  EXPECT_EQ(parts_of("x y = y x").areas.size(), 1U);
  EXPECT_TRUE(parts_of("x y = y x + 1").areas.empty());
  EXPECT_TRUE(parts_of("x y = y x + 1").arcs.empty());
  EXPECT_TRUE(parts_of("x y = y x + 1").equations.empty());
  // Straight pieces, each where its conditions hold: |x| + |y| = 2 has four.
  const EquationParts diamond = parts_of("|x| + |y| = 2");
  EXPECT_EQ(diamond.arcs.size(), 4U);
  EXPECT_TRUE(diamond.equations.empty());
  int defined = 0;
  for (const Arc& arc : diamond.arcs) {
    const double y =
        Tape::compile(std::array{arc.y}, std::array{Variable::x}).evaluate_one<double>(std::array{0.5});
    if (std::isnan(y)) continue;
    EXPECT_EQ(std::abs(y), 1.5);
    ++defined;
  }
  EXPECT_EQ(defined, 2);
}

}  // namespace
}  // namespace nazori::functions
