// SPDX-License-Identifier: Apache-2.0
// Derivatives, limits, common zeros and pieces: the mathematics behind points of interest.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "../src/derivative.h"
#include "../src/equation_points.h"
#include "../src/far_out.h"
#include "../src/one_variable.h"
#include "../src/place_grid.h"
#include "../src/plane_system.h"
#include "../src/zeros.h"
#include "nazori/functions/points.h"

namespace nazori::functions {
namespace {

Expression read(const std::string& text) {
  const auto plot = parse("x + y = " + text);
  EXPECT_TRUE(plot) << text;
  return plot->statements[0].terms[1];
}

double value(const Expression& e, double x) { return OneVariable(e, Variable::x).value(x); }

TEST(Derivative, IsThatOfTheTables) {
  // Function and derivative, both typed.
  const std::pair<const char*, const char*> all[] = {{"x^5", "5x^4"},
                                                     {"x^-2", "-2x^-3"},
                                                     {"x^(2/3)", "(2/3) x^(-1/3)"},
                                                     {"3x - x^2", "3 - 2x"},
                                                     {"x sin(x)", "sin(x) + x cos(x)"},
                                                     {"cos(2x)", "-2 sin(2x)"},
                                                     {"tan(x)", "1/cos(x)^2"},
                                                     {"(x+1)/(x+3)", "2/(x+3)^2"},
                                                     {"2^x", "2^x ln(2)"},
                                                     {"e^(x^2)", "2x e^(x^2)"},
                                                     {"x^x", "x^x (ln(x) + 1)"},
                                                     {"ln(3x)", "1/x"},
                                                     {"log(x)", "1/(x ln(10))"},
                                                     {"log_2 x", "1/(x ln(2))"},
                                                     {"sqrt(x)", "1/(2 sqrt(x))"},
                                                     {"cbrt(x)", "x^(-2/3)/3"},
                                                     {"asin(x/2)", "1/sqrt(4 - x^2)"},
                                                     {"acos(x/2)", "-1/sqrt(4 - x^2)"},
                                                     {"atan(x)", "1/(1 + x^2)"},
                                                     {"sinh(x)", "cosh(x)"},
                                                     {"cosh(x)", "sinh(x)"},
                                                     {"tanh(x)", "1/cosh(x)^2"},
                                                     {"asinh(x)", "1/sqrt(x^2 + 1)"},
                                                     {"acosh(x + 1)", "1/sqrt((x + 1)^2 - 1)"},
                                                     {"atanh(x/2)", "2/(4 - x^2)"},
                                                     {"|x|", "sign(x)"},
                                                     {"floor(x)", "0"},
                                                     {"erf(x)", "2 e^(-x^2)/sqrt(pi)"},
                                                     {"min(x, 1)", "(1 - sign(x - 1))/2"},
                                                     {"max(x^2, x)", "(2x + 1 + sign(x^2 - x)(2x - 1))/2"},
                                                     {"atan2(x, 2)", "2/(x^2 + 4)"}};
  for (const auto& [f, slope] : all) {
    const Expression d = derivative(read(f), Variable::x);
    ASSERT_TRUE(d) << f;
    for (const double x : {0.3, 0.7, 1.4}) {
      const double expected = value(read(slope), x);
      EXPECT_NEAR(value(d, x), expected, 1e-12 * std::max(1.0, std::abs(expected))) << f << " at " << x;
    }
  }
  EXPECT_FALSE(derivative(read("gamma(x)"), Variable::x));
  EXPECT_EQ(to_text(derivative(read("y^2 + 3"), Variable::x)), "0");
}

TEST(FarOut, LimitsLinesAndGrowthAreToldApart) {
  struct Known {
    const char* f;
    int direction;
    FarOut kind;
    double slope, intercept;
  };
  const double pi = std::numbers::pi;
  const Known all[] = {{"1/x", 1, FarOut::level, 0, 0},
                       {"(2x^2 + 1)/(x^2 - 1)", -1, FarOut::level, 0, 2},
                       {"atan(x)", 1, FarOut::level, 0, pi / 2},
                       {"atan(x)", -1, FarOut::level, 0, -pi / 2},
                       {"(1 + 1/x)^x", 1, FarOut::level, 0, std::numbers::e},
                       {"1/ln(x)", 1, FarOut::level, 0, 0},
                       {"ln(x)/x", 1, FarOut::level, 0, 0},
                       {"sin(x)/x", 1, FarOut::level, 0, 0},
                       {"sqrt(x^2 + 4x) - x", 1, FarOut::level, 0, 2},
                       {"e^x", -1, FarOut::level, 0, 0},
                       {"e^x", 1, FarOut::rises, 0, 0},
                       {"x + 1/x", 1, FarOut::slanted, 1, 0},
                       {"sqrt(x^2 + 1)", -1, FarOut::slanted, -1, 0},
                       {"x atan(x)", 1, FarOut::slanted, pi / 2, -1},
                       {"x^3/(2x^2 + 1) - 3", -1, FarOut::slanted, 0.5, -3},
                       {"ln(x)", 1, FarOut::rises, 0, 0},
                       {"ln(x)", -1, FarOut::undefined, 0, 0},
                       {"-x^2", 1, FarOut::falls, 0, 0},
                       {"x^3", -1, FarOut::falls, 0, 0},
                       {"sqrt(x)", 1, FarOut::rises, 0, 0},
                       {"sin(x)", 1, FarOut::unknown, 0, 0},
                       {"x sin(x)", 1, FarOut::unknown, 0, 0},
                       {"x + sin(x)", 1, FarOut::rises, 0, 0},
                       // Ripples of two millionths of the slope, which never fade.
                       {"1000x + sin(x)/500", 1, FarOut::rises, 0, 0}};
  for (const Known& k : all) {
    const FarBehaviour far = far_behaviour(read(k.f), Variable::x, k.direction);
    EXPECT_EQ(static_cast<int>(far.kind), static_cast<int>(k.kind)) << k.f << ' ' << k.direction;
    if (far.kind != k.kind) continue;
    EXPECT_NEAR(far.slope, k.slope, 1e-12) << k.f;
    EXPECT_NEAR(far.intercept, k.intercept, 1e-12) << k.f;
  }
  EXPECT_TRUE(far_behaviour(read("|x| + 1"), Variable::x, 1).coincides);
  EXPECT_FALSE(far_behaviour(read("tanh(x)"), Variable::x, 1).coincides);
}

TEST(FarOut, OneSidedLimitsAtAPlace) {
  const auto at = [](const char* f, double x, int side) { return limit_at(read(f), Variable::x, x, side); };
  EXPECT_EQ(at("e^(1/x)", 0, -1), 0);
  EXPECT_FALSE(at("e^(1/x)", 0, 1));
  EXPECT_EQ(at("1/ln(x)", 0, 1), 0);
  EXPECT_EQ(at("sin(x)/x", 0, 1), 1);
  EXPECT_EQ(at("(1 - cos(x))/x^2", 0, -1), 0.5);
  EXPECT_EQ(at("(x^2 - 1)/(x - 1)", 1, 1), 2);
  EXPECT_EQ(at("x ln(x)", 0, 1), 0);
}

std::vector<SystemRoot> common(const char* f, const char* g) {
  const std::array<Expression, 2> both{read(f), read(g)};
  auto found = solve_system(both, {Variable::x, Variable::y}, {-3, -3}, {3, 3});
  EXPECT_TRUE(found.complete);
  std::sort(found.roots.begin(), found.roots.end(), [](const SystemRoot& a, const SystemRoot& b) {
    return std::pair(a.a, a.b) < std::pair(b.a, b.b);
  });
  return found.roots;
}

TEST(PlaneSystem, FindsCrossingsAndContacts) {
  const auto crossing = common("x^2 + y^2 - 2", "x - y");
  ASSERT_EQ(crossing.size(), 2U);
  EXPECT_NEAR(crossing[0].a, -1, 1e-14);
  EXPECT_NEAR(crossing[1].b, 1, 1e-14);
  EXPECT_TRUE(crossing[0].simple);
  const auto contact = common("x^2 + y^2 - 1", "(x - 2)^2 + y^2 - 1");
  ASSERT_EQ(contact.size(), 1U);
  EXPECT_EQ(contact[0].a, 1);
  EXPECT_EQ(contact[0].b, 0);
  EXPECT_FALSE(contact[0].simple);
  EXPECT_TRUE(common("x^2 + y^2 + 1", "x - y").empty());
  // Three circles of radius 1 around corners of a triangle have no point in common, though two do.
  const std::array<Expression, 3> three{read("x^2 + y^2 - 1"), read("(x - 1)^2 + y^2 - 1"), read("y - 0.5")};
  EXPECT_TRUE(solve_system(three, {Variable::x, Variable::y}, {-3, -3}, {3, 3}).roots.empty());
}

TEST(SquareFree, KeepsEachFactorOnce) {
  const Expression f = square_free(read("(x - y)^2 (x + y)^3 (x - y)"));
  const auto at = [&](double x, double y) {
    return constant_value(substitute(substitute(f, Variable::x, number(x)), Variable::y, number(y)));
  };
  EXPECT_EQ(at(2, 2), 0);
  EXPECT_EQ(at(2, -2), 0);
  // It changes its sign at both lines.
  EXPECT_LT(at(2, 1.9) * at(2, 2.1), 0);
  EXPECT_LT(at(2, -1.9) * at(2, -2.1), 0);
}

TEST(ZerosOf, OfHighOrderAreExact) {
  EXPECT_EQ(zeros_of(read("cos(x) - 1 + x^2/2"), Variable::x, -3, 3), std::vector<double>{0});
  EXPECT_EQ(zeros_of(read("x^3/(x^2 + 1)"), Variable::x, -3, 3), std::vector<double>{0});
  EXPECT_EQ(zeros_of(read("(x - 2)^2 (x + 1)"), Variable::x, -3, 3), (std::vector<double>{-1, 2}));
  EXPECT_TRUE(zeros_of(read("x - x"), Variable::x, -3, 3).empty());
}

int pieces_in(const std::string& text, const Window& window) {
  const auto plot = parse(text);
  EXPECT_TRUE(plot) << text;
  const auto tracing = trace(*plot, window);
  EXPECT_TRUE(tracing) << text;
  return pieces(*plot, *tracing);
}

TEST(Pieces, AreCountedAsAPersonCountsThem) {
  EXPECT_EQ(pieces_in("|x| + |y| = 1", {-2, 2, -2, 2}), 1);
  EXPECT_EQ(pieces_in("y = 1/x", {-3, 3, -3, 3}), 2);
  EXPECT_EQ(pieces_in("x y = 0", {-3, 3, -3, 3}), 1);
  EXPECT_EQ(pieces_in("x^2 + y^2 < 1", {-3, 3, -3, 3}), 1);
  EXPECT_EQ(pieces_in("x y >= 1", {-3, 3, -3, 3}), 2);
  EXPECT_EQ(pieces_in("(x^2 + y^2 - 1)((x-4)^2 + y^2 - 1) = 0", {-2, 6, -4, 4}), 2);
  // Above and below the window it is joined, inside there are three parts of a wave.
  EXPECT_EQ(pieces_in("y = 5 sin(x)", {0.5, 5.5, -1, 1}), 1);
  EXPECT_EQ(pieces_in("y = 5 sin(x)", {-4, 4, -1, 1}), 3);
  EXPECT_EQ(pieces_in("y = 1; y = 2", {-4, 4, -3, 3}), 2);
  EXPECT_EQ(pieces_in("x^2 + y^2 = -1", {-4, 4, -3, 3}), 0);
  EXPECT_EQ(pieces_in("x^2 + y^2 = 0", {-4, 4, -3, 3}), 1);
}

TEST(PlaceGrid, FindsNeighboursOverTheBordersOfItsSquares) {
  PlaceGrid grid(0.1);
  EXPECT_FALSE(grid.is_any_near({0.5, 0.5}));
  grid.add({0.0999, 0.1});
  EXPECT_TRUE(grid.is_any_near({0.1001, 0.1}));
  EXPECT_TRUE(grid.is_any_near({0.15, 0.18}));
  EXPECT_FALSE(grid.is_any_near({0.25, 0.1}));
  EXPECT_FALSE(grid.is_any_near({0.0999, 0.1}, 1e-7));
}

}  // namespace
}  // namespace nazori::functions
