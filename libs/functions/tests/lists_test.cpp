// SPDX-License-Identifier: Apache-2.0
// Lists: y = [1, 2, 3] x stands for three curves, and stays one statement in text, words and braille.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "nazori/functions/braille.h"
#include "nazori/functions/plot.h"
#include "nazori/functions/points.h"
#include "nazori/functions/tracing.h"
#include "nazori/functions/value_table.h"
#include "typed_plots.h"

namespace nazori::functions {
namespace {

using F = SyntaxFault;
using Texts = std::vector<std::string>;

/// Each curve as text.
Texts curves(const char* typed) {
  const auto plot = parse(typed);
  if (!plot) return {plot.error().to_error().what};
  Texts texts;
  for (const Statement& s : plot->statements) texts.push_back(canonical(s));
  return texts;
}

TEST(Lists, StandForOneCurveWithEachElement) {
  EXPECT_EQ(curves("y = [1, 2, 3] x"), (Texts{"y = 1*x", "y = 2*x", "y = 3*x"}));
  EXPECT_EQ(curves("y = x + [-1,0,1]"), (Texts{"y = x + -1", "y = x + 0", "y = x + 1"}));
  EXPECT_EQ(curves("y = [x, x^2]"), (Texts{"y = x", "y = x^2"}));
  EXPECT_EQ(curves("x^2 + y^2 = [1, 4]"), (Texts{"x^2 + y^2 = 1", "x^2 + y^2 = 4"}));
  EXPECT_EQ(curves("y > [1; 2]"), (Texts{"y > 1", "y > 2"}));
  EXPECT_EQ(curves("y = [2] x"), (Texts{"y = 2*x"}));
  EXPECT_EQ(curves("y = x {x > [0, 1]}"), (Texts{"y = x {x > 0}", "y = x {x > 1}"}));
  EXPECT_EQ(curves("x = [1, 2] cos(t); y = sin(t); 0 <= t <= 1"),
            (Texts{"x = 1*cos(t); y = sin(t); 0 <= t <= 1", "x = 2*cos(t); y = sin(t); 0 <= t <= 1"}));
}

TEST(Lists, TwoListsGoTogetherAsFarAsTheShorterOneReaches) {
  EXPECT_EQ(curves("y = [1, 2, 3] x + [4, 5, 6]"), (Texts{"y = 1*x + 4", "y = 2*x + 5", "y = 3*x + 6"}));
  EXPECT_EQ(curves("y = [1, 2, 3] x + [4, 5]"), (Texts{"y = 1*x + 4", "y = 2*x + 5"}));
  EXPECT_EQ(curves("y = [1, 2, 3] x {x < [4, 5]}"), (Texts{"y = 1*x {x < 4}", "y = 2*x {x < 5}"}));
}

TEST(Lists, HaveRangesInEqualSteps) {
  EXPECT_EQ(curves("y = [1...3]"), (Texts{"y = 1", "y = 2", "y = 3"}));
  EXPECT_EQ(curves("y = [1,3...8]"), (Texts{"y = 1", "y = 3", "y = 5", "y = 7"}));
  EXPECT_EQ(curves("y = [1, 3, ..., 7]"), curves("y = [1,3…7]"));
  EXPECT_EQ(curves("y = [3...1]"), (Texts{"y = 3", "y = 2", "y = 1"}));
  EXPECT_EQ(curves("y = [1, 0.5...0]"), (Texts{"y = 1", "y = 0.5", "y = 0"}));
  // In tenths that add up their rounding, 0.3 would be 0.30000000000000004.
  EXPECT_EQ(curves("y = [0.1, 0.2...0.4]"), (Texts{"y = 0.1", "y = 0.2", "y = 0.3", "y = 0.4"}));
  EXPECT_EQ(curves("y = [0, 1/3...1]"), (Texts{"y = 0", "y = 1/3", "y = 2/3", "y = 1"}));
  EXPECT_EQ(curves("y = [0, pi/2...pi]"), (Texts{"y = 0", "y = pi/2", "y = 2*(pi/2)"}));
  EXPECT_EQ(curves("n = 2; y = [1...n] x"), (Texts{"y = 1*x", "y = 2*x"}));
}

TEST(Lists, HaveALetter) {
  EXPECT_EQ(curves("a = [1, 2]; y = a x^2"), (Texts{"y = 1*x^2", "y = 2*x^2"}));
  EXPECT_EQ(curves("y = b; b = 2a; a = [1, 2]"), (Texts{"y = 2*1", "y = 2*2"}));
  EXPECT_EQ(curves("f(x) = a x^2; a = [1, 2]; y = f'(x)").back(), "y = 2*(2*x)");
  const auto plot = parse("y = a x + c; a = [1...3]; c = 2");
  ASSERT_TRUE(plot);
  ASSERT_EQ(plot->lists.size(), 1U);
  EXPECT_EQ(plot->lists[0].name, "a");
  EXPECT_EQ(plot->lists[0].values(), (std::vector<double>{1, 2, 3}));
  // A list has no slider.
  ASSERT_EQ(plot->parameters.size(), 1U);
  EXPECT_EQ(plot->parameters[0].name, "c");
  EXPECT_FALSE(with_parameter("a = [1, 2]; y = a x", "a", 3));
  EXPECT_EQ(with_parameter("n = 2; y = [1...n] x", "n", 3), "n = 3; y = [1...n] x");
}

TEST(Lists, StayAsTypedInTheTextOfThePlot) {
  for (const char* text : {"y = [1, 2, 3]*x", "y = [1, 3...9]*x + [1...5]", "y = a*x^2; a = [1, 2, 3]",
                           "([1, 2, 3], [1, 4, 9])", "([1, 2], 0)", "y > [1, 2] or y < x", "y = [1, 2]^2",
                           "y = n*[1...n]; n = 3; 1 <= n <= 5", "f(x) = [1, 2]*x {x > [0, 1]}"}) {
    const auto plot = parse(text);
    ASSERT_TRUE(plot) << text;
    EXPECT_EQ(canonical(*plot), text);
  }
}

TEST(Lists, AreSpokenWithTheNumberOfCurves) {
  const auto plot = parse("y = [1, 2, 3] x");
  ASSERT_TRUE(plot);
  EXPECT_EQ(in_words(*plot, Language::english), "y equals the list 1, 2, 3 end list times x, 3 curves");
  EXPECT_EQ(in_words(*plot, Language::japanese),
            "y イコール リスト 1、2、3 リスト終わり かける x、曲線 3 本");
  EXPECT_EQ(in_words(plot->statements[1], Language::english), "y equals 2 x");
  EXPECT_EQ(in_words(*parse("y < a; a = [1, 3...9]"), Language::english),
            "y is less than a, 5 regions; a equals the list 1, 3 and so on to 9 end list");
  EXPECT_EQ(in_words(*parse("([1, 2], [3, 4])"), Language::english),
            "the 2 points with x the list 1, 2 end list and y the list 3, 4 end list");
}

TEST(Lists, AreInSquareBracketsInBraille) {
  // Nemeth: brackets § 121, numbers of an enclosed list without indicator § 11, ellipsis § 43. UEB: § 7.9,
  // § 7.3.
  const auto plot = parse("y = [1, 2] x");
  ASSERT_TRUE(plot);
  EXPECT_EQ(in_braille(*plot, BrailleCode::nemeth), "⠽⠀⠨⠅⠀⠈⠷⠂⠠⠀⠆⠈⠾⠭");
  EXPECT_EQ(in_braille(*plot, BrailleCode::ueb), "⠰⠰⠰⠽⠀⠐⠶⠀⠨⠣⠼⠁⠂⠀⠼⠃⠨⠜⠭⠰⠄");
  EXPECT_EQ(in_braille(*parse("y = [1...4]"), BrailleCode::nemeth), "⠽⠀⠨⠅⠀⠈⠷⠂⠠⠀⠄⠄⠄⠠⠀⠲⠈⠾");
  EXPECT_EQ(in_braille(*parse("y = a; a = [1]"), BrailleCode::nemeth), "⠽⠀⠨⠅⠀⠁\n⠁⠀⠨⠅⠀⠈⠷⠂⠈⠾");
}

TEST(Lists, OfCoordinatesArePoints) {
  const auto plot = parse("([1,2,3], [1,4,9])");
  ASSERT_TRUE(plot);
  ASSERT_EQ(plot->statements.size(), 1U);
  EXPECT_EQ(typed_points(plot->statements[0]).size(), 3U);
  const auto tracing = trace(*plot, {-10, 10, -10, 10});
  ASSERT_TRUE(tracing);
  EXPECT_EQ(tracing->dots.size(), 3U);
  const auto points = points_of_interest(*plot, *tracing);
  ASSERT_EQ(points.size(), 3U);
  EXPECT_EQ(points[2].kind, PointKind::isolated);
  EXPECT_EQ(points[2].x, 3);
  EXPECT_EQ(points[2].y, 9);
  const auto table = value_table(plot->statements[0], {});
  ASSERT_TRUE(table);
  ASSERT_EQ(table->size(), 3U);
  EXPECT_EQ((*table)[1].x, 2);
  EXPECT_EQ((*table)[1].y, 4);
  EXPECT_EQ(typed_points(parse("([1, 2, 3], [4, 5])")->statements[0]).size(), 2U);
  EXPECT_EQ(typed_points(parse("([1, 2, 3], 0)")->statements[0]).size(), 3U);
}

TEST(Lists, CurvesMeetLikeCurvesThatAreTypedOneByOne) {
  const auto of = [](const char* typed) {
    const auto plot = parse(typed);
    std::vector<double> places;
    const auto tracing = trace(*plot, {-10, 10, -10, 10});
    for (const PointOfInterest& p : points_of_interest(*plot, *tracing)) places.push_back(p.x);
    return places;
  };
  EXPECT_EQ(of("y = [1, 2] x + [0, 1]"), of("y = x; y = 2x + 1"));
}

TEST(Lists, OneExpressionInSquareBracketsIsStillAQuestion) {
  const auto plot = parse("y = [x]");
  ASSERT_TRUE(plot);
  ASSERT_EQ(plot->questions.size(), 1U);
  EXPECT_EQ(plot->questions[0].fault, F::ask_brackets);
  EXPECT_TRUE(parse("y = [1] x")->questions.empty());
}

TEST(Lists, AreAskedAboutTwoRegionsOnlyWhereTwoAreTyped) {
  EXPECT_TRUE(parse("y > [1, 2]")->questions.empty());
  EXPECT_EQ(parse("y > [1, 2]; y < x")->questions.size(), 1U);
}

TEST(Lists, MistakesAreNamedWithTheirColumn) {
  const test::Mistake mistakes[] = {
      {"y = [1, [2, 3]]", F::list_in_list, 5},
      {"a = [1, 2]; y = [a, 3]", F::list_in_list, 17},
      {"y = [1, 2, 4...8]", F::list_leads_nowhere, 5},
      {"y = [1, 1...2]", F::list_leads_nowhere, 5},
      {"y = [2, 3...1]", F::list_leads_nowhere, 5},
      {"y = [1...x]", F::list_leads_nowhere, 5},
      {"y = [1...2000]", F::too_many_elements, 5},
      {"y = [1...33]", F::too_many_curves, 1},
      {"y = [1...20]; y = [1...20] x", F::too_many_curves, 15},
      {"a = [1, 2]; 0 <= a <= 3; y = a", F::list_misplaced, 1},
      {"r = theta; 0 <= theta <= [1, 2]", F::list_misplaced, 12},
      {"z = [1, 2] x y", F::surface_not_alone, 1},
      {"a = [1, x]; y = a", F::not_a_number, 1},
      {"a = [1, 1/0]; y = a", F::not_a_number, 1},
      {"y = [1...]", F::operand_missing, 10},
      {"y = [...3]", F::operand_missing, 6},
      {"y = []", F::operand_missing, 6},
      {"y = [1, 2", F::bracket_open, 10},
      {"y = 1...2", F::does_not_fit, 6},
  };
  test::expect_refused(mistakes);
}

TEST(Lists, ACommaBetweenDigitsSeparatesUnlessTheDesktopWritesDecimalCommas) {
  EXPECT_EQ(curves("y = [1,5]"), (Texts{"y = 1", "y = 5"}));
  const auto plot = parse("y = [1,5; 2]", {true});
  ASSERT_TRUE(plot);
  EXPECT_EQ(canonical(*plot), "y = [1.5, 2]");
}

}  // namespace
}  // namespace nazori::functions
