// SPDX-License-Identifier: Apache-2.0
// Cases and conditions in braces, "and" and "or": how they are read, written, spoken and evaluated.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "nazori/functions/plate.h"
#include "nazori/functions/plot.h"
#include "nazori/functions/points.h"
#include "nazori/functions/tape.h"
#include "typed_plots.h"

namespace nazori::functions {
namespace {

using F = SyntaxFault;
using K = StatementKind;

struct Reading {
  const char* typed;
  K kind;
  const char* canonical;
};

TEST(Conditions, AreReadAndWrittenBack) {
  const Reading readings[] = {
      {"y = x^2 {0<=x<=2}", K::explicit_y, "y = x^2 {0 <= x <= 2}"},
      {"y = {x<0: -x, x>=0: x}", K::explicit_y, "y = {x < 0: -x, x >= 0: x}"},
      {"y = {x<0:1,0<=x<1:2,5}", K::explicit_y, "y = {x < 0: 1, 0 <= x < 1: 2, 5}"},
      {"y = {x<0: 1; 2}", K::explicit_y, "y = {x < 0: 1, 2}"},
      {"y = {x<-1 or x>1: x, 0}", K::explicit_y, "y = {x < -1 or x > 1: x, 0}"},
      {"y = {x>0 and x<1: x}", K::explicit_y, "y = x {x > 0 and x < 1}"},
      {"y = {0<x and x<1: x}", K::explicit_y, "y = x {0 < x < 1}"},
      {"y = {0<x and 1<x<2: x}", K::explicit_y, "y = x {0 < x and 1 < x < 2}"},
      {"y = x {x>0}{x<2}", K::explicit_y, "y = x {x > 0} {x < 2}"},
      {"y = 2{x+1}", K::explicit_y, "y = 2*(x + 1)"},
      {"y = x^2 {y<4}", K::explicit_y, "y = x^2 {x^2 < 4}"},
      {"x = 2 {0<y<1}", K::explicit_x, "x = 2 {0 < y < 1}"},
      {"x^2 {x>0}", K::explicit_y, "y = x^2 {x > 0}"},
      {"y = x and x > 0", K::explicit_y, "y = x {x > 0}"},
      {"x^2+y^2=4 {x>0}", K::implicit, "x^2 + y^2 = 4 {x > 0}"},
      {"x = cos(t); y = sin(t) {x>0}; 0 <= t <= pi", K::parametric,
       "x = cos(t); y = sin(t) {cos(t) > 0}; 0 <= t <= pi"},
      {"r = 2 {0<theta<1}", K::polar, "r = 2 {0 < theta < 1}; 0 <= theta <= 2*pi"},
      {"z = x + y {x^2+y^2<1}", K::surface, "z = x + y {x^2 + y^2 < 1}"},
      {"y > x^2 and y < 2", K::inequality, "y > x^2 and y < 2"},
      {"y > x^2 {y<2}", K::inequality, "y > x^2 and y < 2"},
      {"y > 0 ∧ x > 0 ∧ x + y < 1", K::inequality, "y > 0 and x > 0 and x + y < 1"},
      {"(1, 2)", K::parametric, "(1, 2)"},
      {"(1/2, -3)", K::parametric, "(1/2, -3)"},
      {"y = sin(30°)x", K::explicit_y, "y = sin(30°)*x"},
      {"y = 2x°", K::explicit_y, "y = 2*x°"},
  };
  for (const Reading& r : readings) {
    const auto plot = parse(r.typed);
    ASSERT_TRUE(plot) << r.typed << ": " << plot.error().to_error().what;
    ASSERT_EQ(plot->statements.size(), 1U) << r.typed;
    EXPECT_EQ(plot->statements[0].kind, r.kind) << r.typed;
    EXPECT_EQ(canonical(*plot), r.canonical) << r.typed;
    const auto again = parse(r.canonical);
    ASSERT_TRUE(again) << r.canonical;
    EXPECT_EQ(canonical(*again), r.canonical);
    EXPECT_TRUE(plot->questions.empty()) << r.typed;
  }
}

TEST(Conditions, SeparatePlotsStaySeparate) {
  const auto either = parse("y > x or y < -x");
  ASSERT_TRUE(either);
  EXPECT_EQ(either->statements.size(), 2U);
  EXPECT_TRUE(either->questions.empty());
  EXPECT_EQ(canonical(*either), "y > x or y < -x");
  const auto points = parse("(1, 2), (3, 4); y = x");
  ASSERT_TRUE(points);
  EXPECT_EQ(canonical(*points), "(1, 2); (3, 4); y = x");
}

TEST(Conditions, ThatCannotBeReadAreRefusedWithTheirColumn) {
  const test::Mistake mistakes[] = {
      {"{x>0}", F::condition_alone, 1},
      {"y = {x>0}", F::condition_alone, 5},
      {"y = {1: 2}", F::condition_missing, 7},
      {"y = {x<0: 1, x: 2}", F::condition_missing, 15},
      {"y = {x<0: }", F::operand_missing, 11},
      {"y = {x<0, 2: 3}", F::value_missing, 9},
      {"y = x {x>0", F::bracket_open, 11},
      {"y = x and y = 2", F::two_equations, 11},
      {"y > x {x<0 or x>1}", F::choice_in_region, 1},
      {"x = t; y = t {r>0}", F::other_variable_in_condition, 8},
      {"y = x {t>0}", F::parameter_alone, 1},
      {"y = x {theta>0}", F::polar_mixed, 1},
      {"(1, 2, 3)", F::point_not_two_numbers, 1},
      {"(x, 2)", F::point_not_two_numbers, 1},
      {"[(1, 2), (3, 4)]", F::list, 1},
      {"[(1,2), (3,4)]", F::list, 1},
      {"y = [1", F::bracket_open, 7},
      {"y = (1, 2", F::bracket_open, 7},
      {"y != x", F::not_equal, 3},
      {"y ≠ x", F::not_equal, 3},
      {"y = x\ny = 2", F::line_break, 7},
      {"y > x or", F::operand_missing, 9},
      {"y > x and", F::operand_missing, 10},
  };
  test::expect_refused(mistakes);
}

TEST(Conditions, ALineMayBreakBesideASign) {
  for (const char* typed : {"\ny = x\n", "y = x;\ny = 2", "y = x\n; y = 2", "y =\nx", "y = x +\n1",
                            "y = x\n{x>0}", "y = (\nx\n)"})
    EXPECT_TRUE(parse(typed)) << typed;
}

struct Doubt {
  const char* typed;
  F question;
  int column;
};

TEST(Questions, AreAskedAboutWhatCanBeReadInTwoWays) {
  const Doubt doubts[] = {
      {"y = 1e3x", F::ask_exponent, 5}, {"y = 1e-3x", F::ask_exponent, 5}, {"(1,2)", F::ask_point, 1},
      {"y = x(1,5)", F::ask_point, 6},  {"y = [x]", F::ask_brackets, 5},   {"y > x; y < 2", F::ask_both, 8},
  };
  for (const Doubt& d : doubts) {
    const auto plot = parse(d.typed);
    ASSERT_TRUE(plot) << d.typed;
    ASSERT_EQ(plot->questions.size(), 1U) << d.typed;
    EXPECT_EQ(plot->questions[0].fault, d.question) << d.typed;
    EXPECT_EQ(plot->questions[0].column, d.column) << d.typed;
    EXPECT_NE(question_words(plot->questions[0], Language::english).find('?'), std::string::npos) << d.typed;
    EXPECT_NE(question_words(plot->questions[0], Language::japanese).find("か。"), std::string::npos);
  }
}

TEST(Questions, AreNotAskedAboutWhatIsClear) {
  for (const char* typed : {"y = 2e^x", "y = 2e x", "y = 2e + 1", "y = 1*e*3", "y = (1.5)x", "y = sin(1,5)",
                            "(1, 2)", "y > x; y = 2", "y > x and y < 2", "y = floor(x)", "y = x!"}) {
    const auto plot = parse(typed);
    ASSERT_TRUE(plot) << typed;
    EXPECT_TRUE(plot->questions.empty()) << typed;
  }
  EXPECT_TRUE(parse("y = (1,5)x", {true})->questions.empty());
}

double at(const std::string& text, double x) {
  const auto plot = parse(text);
  EXPECT_TRUE(plot) << text;
  if (!plot) return 0;
  const Tape tape = Tape::compile(std::span(plot->statements[0].terms).first(1), std::array{Variable::x});
  return tape.evaluate_one<double>(std::array{x});
}

TEST(Conditions, TheFirstCaseThatHoldsIsTaken) {
  const std::string steps = "y = {x<0: -x, x<2: 10, x=5: 7, x>6 and x<7 or x>=8: 1}";
  EXPECT_EQ(at(steps, -3), 3);
  EXPECT_EQ(at(steps, 0), 10);
  EXPECT_EQ(at(steps, 1.5), 10);
  EXPECT_TRUE(std::isnan(at(steps, 2)));
  EXPECT_EQ(at(steps, 5), 7);
  EXPECT_TRUE(std::isnan(at(steps, 6)));
  EXPECT_EQ(at(steps, 6.5), 1);
  EXPECT_TRUE(std::isnan(at(steps, 7)));
  EXPECT_EQ(at(steps, 8), 1);
  // A case that is undefined is not replaced by the next one.
  EXPECT_TRUE(std::isnan(at("y = {x<1: ln(x), 5}", -1)));
  EXPECT_TRUE(std::isnan(at("y = {ln(x)<1: 2, 5}", -1)));
  EXPECT_EQ(at("y = {x<1: ln(x), 5}", 1), 5);
}

Interval enclosure(const std::string& text, double low, double high) {
  const auto plot = parse(text);
  EXPECT_TRUE(plot) << text;
  const Tape tape = Tape::compile(std::span(plot->statements[0].terms).first(1), std::array{Variable::x});
  return tape.evaluate_one<Interval>(std::array{Interval(low, high)});
}

TEST(Conditions, AreProvenByIntervals) {
  const std::string part = "y = x^2 {0<=x<2}";
  EXPECT_TRUE(enclosure(part, -2, -1).is_empty());
  EXPECT_TRUE(enclosure(part, 2, 3).is_empty());
  EXPECT_EQ(enclosure(part, 0, 1).decoration, Decoration::continuous);
  EXPECT_EQ(enclosure(part, 0, 2).decoration, Decoration::partial);
  EXPECT_EQ(enclosure(part, -1, 1).decoration, Decoration::partial);
  const std::string cases = "y = {x<0: -x, x>=0: x+1}";
  EXPECT_EQ(enclosure(cases, -2, -1).decoration, Decoration::continuous);
  EXPECT_EQ(enclosure(cases, -2, -1).lower, 1);
  EXPECT_EQ(enclosure(cases, 0, 1).decoration, Decoration::continuous);
  // The last case has a condition of its own: the enclosure cannot prove that one of the two holds.
  EXPECT_LT(enclosure(cases, -1, 1).decoration, Decoration::continuous);
  EXPECT_EQ(enclosure(cases, -1, 1).lower, -1);
  EXPECT_EQ(enclosure(cases, -1, 1).upper, 2);
  EXPECT_EQ(enclosure("y = {x<0: -x, x+1}", -1, 1).decoration, Decoration::defined);
  // Constant conditions of a function with jumps.
  EXPECT_EQ(enclosure("y = {floor(x)>=0: x, 0}", 0.5, 2.5).decoration, Decoration::continuous);
}

Dual<Interval, 1> slope(const std::string& text, double low, double high) {
  const auto plot = parse(text);
  const Tape tape = Tape::compile(std::span(plot->statements[0].terms).first(1), std::array{Variable::x});
  return tape.evaluate_one<Dual<Interval, 1>>(std::array{Dual<Interval, 1>(Interval(low, high), 0)});
}

TEST(Conditions, SlopesBelongToTheCaseThatHolds) {
  const std::string cases = "y = {x<0: -3x, 2x}";
  EXPECT_EQ(slope(cases, -2, -1).slopes[0].upper, -3);
  EXPECT_EQ(slope(cases, 1, 2).slopes[0].lower, 2);
  EXPECT_FALSE(slope(cases, -1, 1).slopes[0].is_bounded());
}

std::vector<PointOfInterest> points_of(const std::string& text, const Window& window, PointKind kind) {
  const auto plot = parse(text);
  EXPECT_TRUE(plot) << text;
  const auto tracing = trace(*plot, window);
  EXPECT_TRUE(tracing) << text;
  EXPECT_EQ(tracing->undecided_cells, 0) << text;
  std::vector<PointOfInterest> some;
  for (const PointOfInterest& p : points_of_interest(*plot, *tracing)) {
    if (p.kind == kind) some.push_back(p);
  }
  return some;
}

TEST(Conditions, ARestrictedCircleEndsWhereItsConditionDoes) {
  const auto plot = parse("x^2 + y^2 = 4 {x > 0}");
  ASSERT_TRUE(plot);
  const auto tracing = trace(*plot, {-3, 3, -3, 3});
  ASSERT_TRUE(tracing);
  EXPECT_EQ(pieces(*plot, *tracing), 1);
  double length = 0;
  for (const Branch& b : tracing->branches) {
    for (std::size_t i = 0; i + 1 < b.points.size(); ++i)
      length += 6 * std::hypot(b.points[i + 1].u - b.points[i].u, b.points[i + 1].v - b.points[i].v);
    for (const CurvePoint& p : b.points) EXPECT_GE(p.u, 0.5 - 0.002);
  }
  EXPECT_NEAR(length, 2 * 3.14159265, 0.02);  // half of a circle of radius 2
}

TEST(Conditions, ASystemIsWhereAllOfItHolds) {
  const auto plot = parse("y > x^2 and y < 2");
  ASSERT_TRUE(plot);
  const auto tracing = trace(*plot, {-3, 3, -1, 5});
  ASSERT_TRUE(tracing);
  double area = 0;
  for (const Fill& f : tracing->fills) area += 36 * (f.high.u - f.low.u) * (f.high.v - f.low.v);
  EXPECT_NEAR(area, 8 * std::sqrt(2) / 3, 0.02);  // 2 * (2 sqrt 2) * 2/3
  // The border of each is drawn only beside the other's inside.
  for (const Branch& b : tracing->branches) {
    for (const CurvePoint& p : b.points) {
      const double x = -3 + 6 * p.u;
      const double y = -1 + 6 * p.v;
      EXPECT_LE(y, 2.02);
      EXPECT_GE(y, x * x - 0.05);
    }
  }
}

TEST(Conditions, APointIsOneDot) {
  const auto plot = parse("(1, 2), (-1, 3)");
  ASSERT_TRUE(plot);
  const auto tracing = trace(*plot, {-5, 5, -5, 5});
  ASSERT_TRUE(tracing);
  ASSERT_EQ(tracing->dots.size(), 2U);
  EXPECT_NEAR(tracing->window.x(tracing->dots[0].at.u), 1, 1e-12);
  EXPECT_NEAR(tracing->window.y(tracing->dots[0].at.v), 2, 1e-12);
  EXPECT_EQ(in_words(*plot, Language::english),
            "the point with x 1 and y 2; the point with x minus 1 and y 3");
}

TEST(Conditions, AreSpokenWithTheirEnds) {
  const auto restricted = parse("y = x^2 {0<=x<=2}");
  const auto cases = parse("y = {x<0: -x, x=1: 5, 2x}");
  ASSERT_TRUE(restricted && cases);
  EXPECT_EQ(in_words(*restricted, Language::english),
            "y equals x squared, only where 0 is at most x is at most 2");
  EXPECT_EQ(in_words(*restricted, Language::english, SpeechStyle::superbrief),
            "y equals x squared, only where 0 is at most x is at most 2");
  EXPECT_EQ(in_words(*restricted, Language::japanese),
            "y イコール x の 2 乗、ただし 0 小なりイコール x 小なりイコール 2");
  const auto inner = parse("y = 1 + {x>0: x+1}");
  EXPECT_EQ(in_words(*inner, Language::english),
            "y equals 1 plus the part of x plus 1 where x is greater than 0 end part");
  EXPECT_EQ(in_words(*inner, Language::english, SpeechStyle::superbrief),
            "y equals 1 plus part x plus 1 where x is greater than 0 end part");
  EXPECT_EQ(in_words(*inner, Language::japanese),
            "y イコール 1 足す 部分 x 足す 1 ただし x 大なり 0 部分終わり");
  EXPECT_EQ(in_words(*cases, Language::english),
            "y equals the cases minus x if x is less than 0; 5 if x equals 1; otherwise 2 x end cases");
  EXPECT_EQ(
      in_words(*cases, Language::japanese),
      "y イコール 場合分け x 小なり 0 のとき マイナス x、x イコール 1 のとき 5、その他 2 x 場合分け終わり");
  EXPECT_EQ(in_words(*parse("y = sin(30°)"), Language::english), "y equals sine of 30 degrees");
  EXPECT_EQ(in_words(*parse("y = (x+1)°"), Language::japanese), "y イコール 括弧 x 足す 1 括弧閉じ 度");
}

TEST(Conditions, DegreesAreTheAnglesOfSchool) {
  EXPECT_NEAR(at("y = sin(30°)", 0), 0.5, 1e-15);
  EXPECT_NEAR(at("y = cos(x°)", 60), 0.5, 1e-15);
  EXPECT_NEAR(at("y = 180°^2", 0), 9.869604401089358, 1e-14);  // pi squared
  const auto zeros = points_of("y = sin(x°)", {-400, 400, -2, 2}, PointKind::zero);
  ASSERT_EQ(zeros.size(), 5U);
  EXPECT_EQ(zeros[0].x_name, "-360");
  EXPECT_EQ(zeros[3].x_name, "180");
}

TEST(Conditions, CasesThatMeetHaveACornerAndNoHole) {
  const std::string text = "y = {x<1: 3-2x, x>=1: x^2}";
  EXPECT_EQ(points_of(text, {-3, 3, -1, 9}, PointKind::minimum).size(), 1U);
  EXPECT_TRUE(points_of(text, {-3, 3, -1, 9}, PointKind::hole).empty());
  EXPECT_TRUE(points_of(text, {-3, 3, -1, 9}, PointKind::jump).empty());
  EXPECT_TRUE(points_of(text, {-3, 3, -1, 9}, PointKind::inflection).empty());
  EXPECT_TRUE(points_of(text, {-3, 3, -1, 9}, PointKind::end).empty());
}

TEST(Conditions, CasesThatDoNotMeetJump) {
  const auto jumps = points_of("y = {x<1: x, x>=1: x+2}", {-3, 3, -3, 5}, PointKind::jump);
  ASSERT_EQ(jumps.size(), 1U);
  EXPECT_EQ(jumps[0].x, 1);
  ASSERT_TRUE(jumps[0].jump);
  EXPECT_NEAR(jumps[0].jump->y_before, 1, 1e-9);
  EXPECT_NEAR(jumps[0].jump->y_after, 3, 1e-9);
  EXPECT_NEAR(jumps[0].jump->y_at, 3, 1e-9);
}

TEST(Conditions, ARestrictedCurveHasTwoEnds) {
  const auto ends = points_of("y = x^2 {0.5<=x<=2}", {-3, 3, -1, 5}, PointKind::end);
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_EQ(ends[0].x_name, "1/2");
  EXPECT_NEAR(ends[0].y, 0.25, 1e-9);
  EXPECT_NEAR(ends[1].x, 2, 1e-9);
  EXPECT_NEAR(ends[1].y, 4, 1e-9);
}

}  // namespace
}  // namespace nazori::functions
