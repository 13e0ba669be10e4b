// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/curve_kinds.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

#include "nazori/functions/tape.h"
#include "nazori/functions/tracing.h"

namespace nazori::functions {
namespace {

Statement statement_of(const std::string& text) {
  const auto plot = parse(text);
  EXPECT_TRUE(plot) << text;
  return plot ? plot->statements.at(0) : Statement{};
}

/// One of each kind, in the order of the table.
const char* const kOneOfEach[] = {"y = x^2 - 1",
                                  "x = y^2 - 1",
                                  "x^2 + x*y + y^2 = 1",
                                  "y > x^2",
                                  "x = t^2; y = t^3; -1 <= t <= 1",
                                  "r = 1 + cos theta",
                                  "r^2*theta = r + 1",
                                  "z = x*y"};

TEST(CurveKinds, StandInTheOrderOfTheirEnumeration) {
  ASSERT_EQ(curve_kinds().size(), std::size(kOneOfEach));
  for (std::size_t i = 0; i < curve_kinds().size(); ++i) {
    EXPECT_EQ(curve_kinds()[i].kind, static_cast<StatementKind>(i));
    EXPECT_EQ(statement_of(kOneOfEach[i]).kind, curve_kinds()[i].kind) << kOneOfEach[i];
  }
}

TEST(CurveKinds, EachHasANameAndOneWayToBeDrawn) {
  for (const CurveKind& kind : curve_kinds()) {
    EXPECT_FALSE(kind.name.empty());
    EXPECT_EQ(kind.course != nullptr, kind.drawn_by == DrawnBy::course) << kind.name;
    EXPECT_TRUE(kind.course == nullptr || kind.range != RangeFrom::nothing) << kind.name;
    EXPECT_EQ(kind.range == RangeFrom::window, kind.is_graph_of_x() || kind.is_graph_of_y()) << kind.name;
  }
}

TEST(CurveKinds, TheTextOfEachIsReadAsTheSameStatement) {
  for (const char* const text : kOneOfEach) {
    const Statement once = statement_of(text);
    const Statement again = statement_of(canonical(once));
    EXPECT_EQ(again.kind, once.kind) << text;
    EXPECT_EQ(canonical(again), canonical(once)) << text;
  }
}

TEST(CurveKinds, TheCourseOfAKindLiesOnTheCurveOfItsEquation) {
  int checked = 0;
  for (std::size_t i = 0; i < curve_kinds().size(); ++i) {
    const CurveKind& kind = curve_kinds()[i];
    if (kind.course == nullptr || kind.equation == nullptr) continue;
    const Statement s = statement_of(kOneOfEach[i]);
    const Course course = kind.course(s);
    const Tape at = Tape::compile(std::array{course.x, course.y}, std::array{kind.parameter});
    const Tape equation = Tape::compile(std::array{kind.equation(s)}, std::array{Variable::x, Variable::y});
    for (const double t : {-2.0, 0.5, 3.0}) {
      std::vector<double> registers(at.size());
      at.evaluate<double>(std::array{t}, registers);
      const double x = registers[at.output(0)];
      const double y = registers[at.output(1)];
      EXPECT_NEAR(equation.evaluate_one<double>(std::array{x, y}), 0, 1e-12) << kOneOfEach[i];
      ++checked;
    }
  }
  EXPECT_EQ(checked, 6);
}

TEST(CurveKinds, APolarCurveIsAsFarFromTheOriginAsItsRadius) {
  const Statement s = statement_of("r = 1 + cos theta");
  const Course course = curve_kind(s.kind).course(s);
  const Tape at = Tape::compile(std::array{course.x, course.y}, std::array{Variable::theta});
  for (const double angle : {0.0, 1.0, 2.5}) {
    std::vector<double> registers(at.size());
    at.evaluate<double>(std::array{angle}, registers);
    const double r = 1 + std::cos(angle);
    EXPECT_NEAR(registers[at.output(0)], r * std::cos(angle), 1e-14);
    EXPECT_NEAR(registers[at.output(1)], r * std::sin(angle), 1e-14);
  }
}

TEST(CurveKinds, EveryCurveAndRegionIsTraced) {
  for (std::size_t i = 0; i < curve_kinds().size(); ++i) {
    Plot plot;
    plot.statements.push_back(statement_of(kOneOfEach[i]));
    const auto tracing = trace(plot, {-3, 3, -3, 3});
    ASSERT_TRUE(tracing) << kOneOfEach[i];
    EXPECT_EQ(tracing->branches.empty(), curve_kinds()[i].drawn_by == DrawnBy::heights) << kOneOfEach[i];
  }
}

}  // namespace
}  // namespace nazori::functions
