// SPDX-License-Identifier: Apache-2.0
// Integrals in all that is done with a curve: slopes, words, braille, points of interest, values.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <thread>
#include <vector>

#include "../src/algebra.h"
#include "nazori/functions/braille.h"
#include "nazori/functions/points.h"
#include "nazori/functions/tape.h"
#include "nazori/functions/value_table.h"
#include "typed_plots.h"

namespace nazori::functions {
namespace {

using test::read;

std::string last_text(const std::string& text) { return canonical(read(text).statements.back()); }

TEST(IntegralCurve, HasTheFunctionUnderItAsItsSlope) {
  EXPECT_EQ(last_text("f(x) = integral(sin(t)/t, t, 0, x); y = f'(x)"), "y = sin(x)/x");
  EXPECT_EQ(last_text("f(x) = integral(t, t, x, 0); y = f'(x)"), "y = -x");
  EXPECT_EQ(last_text("f(x) = integral(t, t, 0, x^2); y = f'(x)"), "y = x^2*(2*x)");
  EXPECT_EQ(last_text("f(x) = integral(t, t, 0, 1); y = f'(x)"), "y = 0");
}

TEST(IntegralCurve, HasNoSlopeWhereTheFunctionUnderItJumps) {
  EXPECT_EQ(last_text("f(x) = integral(floor(t), t, 0, x); y = f'(x)"), "y = floor(x) {x > floor(x)}");
  EXPECT_EQ(last_text("f(x) = integral(ceil(t), t, 0, x); y = f'(x)"), "y = ceil(x) {ceil(x) > x}");
  EXPECT_EQ(last_text("f(x) = integral(sign(t), t, 0, x); y = f'(x)"), "y = sign(x) {|x| > 0}");
  EXPECT_EQ(last_text("f(x) = integral({t < 1: t, t >= 1: 5}, t, 0, x); y = f'(x)"),
            "y = {x < 1: x, x > 1: 5}");
  // These meet: |t| has a corner, its integral has none.
  EXPECT_EQ(last_text("f(x) = integral(|t|, t, 0, x); y = f'(x)"), "y = |x|");
  EXPECT_EQ(last_text("f(x) = integral({t < 1: t, t >= 1: t^2}, t, 0, x); y = f'(x)"), "y = {x < 1: x, x^2}");
}

TEST(IntegralCurve, IsSaidWithItsVariableAndEnds) {
  const Plot p = read("y = integral(t^2, t, 0, x)");
  EXPECT_EQ(in_words(p, Language::english),
            "y equals the integral of t squared with respect to t from 0 up to x end integral");
  EXPECT_EQ(in_words(p, Language::english, SpeechStyle::brief),
            "y equals integral t squared with respect to t from 0 up to x end integral");
  EXPECT_EQ(in_words(p, Language::english, SpeechStyle::superbrief),
            "y equals integral t squared by t from 0 up to x end integral");
  EXPECT_EQ(in_words(p, Language::japanese), "y イコール 積分 t の 2 乗 変数 t 下端 0 上端 x 積分終わり");
}

TEST(IntegralCurve, IsWrittenInBrailleWithTheSignAndItsEnds) {
  const auto braille = [](const char* text, BrailleCode code) {
    return in_braille(read(text).statements[0].terms[0], code);
  };
  EXPECT_EQ(braille("∫_0^1 x^2 dx", BrailleCode::nemeth), "⠮⠰⠴⠘⠂⠐⠭⠘⠆⠐⠙⠭");
  EXPECT_EQ(braille("∫_0^1 x^2 dx", BrailleCode::ueb), "⠰⠰⠰⠮⠢⠼⠚⠔⠼⠁⠭⠔⠼⠃⠰⠙⠭⠰⠄");
  EXPECT_EQ(braille("∫_0^{x^2} (t + 1) dt", BrailleCode::nemeth), "⠮⠰⠴⠘⠭⠘⠘⠆⠐⠷⠞⠬⠂⠾⠙⠞");
  EXPECT_EQ(braille("∫_{-x}^x t dt", BrailleCode::ueb), "⠰⠰⠰⠮⠢⠣⠐⠤⠭⠜⠔⠭⠞⠙⠞⠰⠄");
  // With a factor behind it, it keeps its own dt.
  EXPECT_EQ(braille("(∫_0^1 t dt) x", BrailleCode::nemeth), "⠷⠮⠰⠴⠘⠂⠐⠞⠙⠞⠾⠭");
}

TEST(IntegralCurve, HasExtremesAtTheZerosOfTheFunctionUnderIt) {
  const Plot p = read("y = integral(sin(t)/t, t, 0, x)");
  const auto tracing = trace(p, Window{1, 8, -1, 3});
  ASSERT_TRUE(tracing);
  std::vector<PointOfInterest> found = points_of_interest(p, *tracing);
  std::erase_if(found,
                [](const auto& q) { return q.kind != PointKind::maximum && q.kind != PointKind::minimum; });
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].kind, PointKind::maximum);
  EXPECT_NEAR(found[0].x, std::numbers::pi, 1e-12);
  // Abramowitz and Stegun, table 5.1, and mpmath 1.2.
  EXPECT_NEAR(found[0].y, 1.851937051982466, 1e-12);
  EXPECT_EQ(found[1].kind, PointKind::minimum);
  EXPECT_NEAR(found[1].x, 2 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(found[1].y, 1.418151576132628, 1e-12);
}

TEST(IntegralCurve, FollowsAParameterUnderIt) {
  for (const double a : {1.0, 2.0, 3.0}) {
    const auto text = with_parameter("a = 2; y = integral(a t, t, 0, x)", "a", a);
    ASSERT_TRUE(text);
    const Expression e = read(*text).statements[0].terms[0];
    EXPECT_NEAR(constant_value(substitute(e, Variable::x, number(3))), a * 4.5, 1e-13);
  }
}

TEST(IntegralCurve, AppliesDefinedFunctionsInItsEnds) {
  const Expression e = read("f(x) = integral(cos(t), t, 0, x); y = f(2x) + f(f(x))").statements[1].terms[0];
  const double x = 0.7;
  EXPECT_NEAR(constant_value(substitute(e, Variable::x, number(x))), std::sin(2 * x) + std::sin(std::sin(x)),
              1e-14);
}

TEST(IntegralCurve, KeepsItsOwnVariableApartFromTheOneOutside) {
  EXPECT_EQ(last_text("f(t) = integral(t^2, t, 0, t); y = f(2x)"), "y = integral(t^2, t, 0, 2*x)");
  const Expression e = read("y = integral(|x|, x, 0, |x|)").statements[0].terms[0];
  EXPECT_EQ(to_text(replaced(e, variable(Variable::x), number(3))), "integral(|x|, x, 0, |3|)");
  // Only the |x| outside has two cases.
  const std::vector<Case> cases = cases_of(e);
  ASSERT_EQ(cases.size(), 2U);
  EXPECT_EQ(to_text(cases[0].expression), "integral(|x|, x, 0, x)");
  EXPECT_TRUE(variables_of(read("y = integral(x, x, 0, 2)").statements[0].terms[0]).empty());
}

// The leaves are computed by whichever thread needs them first.
TEST(IntegralCurve, HasTheSameValuesOnEveryThread) {
  const Expression e = read("y = integral(sin(t^2), t, 0, x)").statements[0].terms[0];
  const Tape tape = Tape::compile(std::array{e}, std::array{Variable::x});
  const auto values = [&tape] {
    std::vector<double> all;
    for (int i = -100; i <= 100; ++i) all.push_back(tape.evaluate_one<double>(std::array{i / 10.0}));
    return all;
  };
  std::array<std::vector<double>, 4> seen;
  std::vector<std::thread> threads;
  threads.reserve(seen.size());
  for (auto& s : seen) threads.emplace_back([&s, &values] { s = values(); });
  for (std::thread& t : threads) t.join();
  for (const auto& s : seen) EXPECT_EQ(s, values());
}

TEST(IntegralCurve, OfAListIsOneCurveForEachElement) {
  const Plot p = read("y = integral([2, 6] t, t, 0, x)");
  ASSERT_EQ(p.statements.size(), 2U);
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    const double at_3 = constant_value(substitute(p.statements[i].terms[0], Variable::x, number(3)));
    EXPECT_NEAR(at_3, i == 0 ? 9 : 27, 1e-12);
  }
}

}  // namespace
}  // namespace nazori::functions
