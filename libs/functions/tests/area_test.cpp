// SPDX-License-Identifier: Apache-2.0
// Areas between curves, against their integrals in closed form.
#include "nazori/functions/area.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "nazori/functions/braille.h"
#include "nazori/functions/points.h"
#include "typed_plots.h"

namespace nazori::functions {
namespace {

using test::read;

TEST(Area, HasItsIntegralAndItsSizeWithTheirNames) {
  struct Known {
    const char* text;
    double integral;
    double area;
    const char* area_name;
  };
  for (const Known& k : std::vector<Known>{
           {"area(x^2, 0, 2)", 8.0 / 3, 8.0 / 3, "8/3"},
           {"area(x^2, 2, 0)", -8.0 / 3, 8.0 / 3, "8/3"},
           {"area(x^2, x, 0, 1)", -1.0 / 6, 1.0 / 6, "1/6"},
           {"area(sin(x), 0, 2pi)", 0, 4, "4"},
           {"area(sin(x), cos(x), pi/4, 5pi/4)", 2 * std::sqrt(2.0), 2 * std::sqrt(2.0), "2*sqrt(2)"},
           {"area(floor(x), -1, 2)", 0, 2, "2"},
           {"area(1/x, 1, 2)", std::log(2), std::log(2), "ln(2)"},
           {"a = 3; area(a x, 0, 2)", 6, 6, "6"},
           {"f(x) = x^3; g(t) = t; area(f, g, -1, 1)", 0, 0.5, "1/2"}}) {
    const auto v = area_value(read(k.text).statements.back());
    ASSERT_TRUE(v) << k.text;
    EXPECT_NEAR(v->integral, k.integral, 1e-13) << k.text;
    EXPECT_NEAR(v->area, k.area, 1e-13) << k.text;
    EXPECT_EQ(v->area_name.value_or(""), k.area_name) << k.text;
  }
}

TEST(Area, IsNotDefinedAcrossAPoleAndOfNoOtherStatement) {
  EXPECT_FALSE(area_value(read("area(1/x, -1, 1)").statements[0]));
  EXPECT_FALSE(area_value(read("area(ln(x), -1, 1)").statements[0]));
  EXPECT_FALSE(area_value(read("y < x^2").statements[0]));
}

TEST(Area, IsTheRegionBetweenTheCurvesAndTheEnds) {
  const Window window{-3, 3, -3, 3};
  const auto tracing = trace(read("area(x, 2, -1)"), window);
  ASSERT_TRUE(tracing);
  const auto is_filled = [&](double x, double y) {
    for (const Fill& f : tracing->fills) {
      if (f.low.u <= window.u(x) && window.u(x) <= f.high.u && f.low.v <= window.v(y) &&
          window.v(y) <= f.high.v)
        return true;
    }
    return false;
  };
  EXPECT_TRUE(is_filled(1.5, 1));
  EXPECT_TRUE(is_filled(-0.8, -0.4));
  EXPECT_FALSE(is_filled(1, 1.5));
  EXPECT_FALSE(is_filled(1.5, -0.2));
  EXPECT_FALSE(is_filled(2.2, 1));
  EXPECT_FALSE(is_filled(-1.2, -0.4));
}

TEST(Area, IsWrittenAndSaidAsItIsTyped) {
  const Plot p = read("area( x² ; 0 ; 2 )");
  EXPECT_EQ(canonical(p), "area(x^2, 0, 2)");
  EXPECT_EQ(in_words(p, Language::english),
            "the area between y equals x squared and the x axis, for x from 0 to 2");
  EXPECT_EQ(in_words(p, Language::japanese), "y イコール x の 2 乗 と x 軸 の間の面積、x は 0 から 2 まで");
  EXPECT_EQ(in_braille(p, BrailleCode::nemeth), "⠮⠰⠴⠘⠆⠐⠳⠭⠘⠆⠐⠳⠙⠭");
  EXPECT_EQ(canonical(read("area(x,0,1)")), "area(x, 0, 1)");
  const Plot two = read("area(x^2, x, 0, 1)");
  EXPECT_EQ(canonical(two), "area(x^2, x, 0, 1)");
  EXPECT_EQ(in_words(two, Language::english),
            "the area between y equals x squared and y equals x, for x from 0 to 1");
  const Plot both = read("area(x, 0, 1); area(-x, 0, 1); y > 2");
  EXPECT_EQ(canonical(both), "area(x, 0, 1); area(-x, 0, 1); y > 2");
  EXPECT_TRUE(both.questions.empty());
}

TEST(Area, IsToldInTheSummary) {
  const auto told = [](const char* text, Language language) {
    const Plot p = read(text);
    const auto tracing = trace(p, Window{});
    return tracing ? summary(p, *tracing, {}, language) : "";
  };
  EXPECT_EQ(told("area(x^2, 0, 2)", Language::english),
            "the area between y equals x squared and the x axis, for x from 0 to 2: 1 piece, area 8 over 3, "
            "about 2.667.");
  EXPECT_EQ(told("area(x^3, -1, 1)", Language::english),
            "the area between y equals x cubed and the x axis, for x from minus 1 to 1: 1 piece, area 1 over "
            "2, about 0.5, integral 0.");
  EXPECT_EQ(
      told("area(x^2, 0, 2)", Language::japanese),
      "y イコール x の 2 乗 と x 軸 の間の面積、x は 0 から 2 まで。1つの部分、面積 3 分の 8、約2.667。");
  EXPECT_EQ(told("area(1/x, -1, 1)", Language::english).find(", area not defined.") != std::string::npos,
            true);
}

TEST(Area, RefusesWhatHasNoEndsOrOtherVariables) {
  for (const char* text : {"area(x^2)", "area(x^2, 0)", "area(x^2, 0, x)", "area(x y, 0, 1)", "area(x, 1, 1)",
                           "area(x, y, 0, 1)", "area(x, 0, 1/0)", "area(x, x^2, x^3, 0, 1)"}) {
    const auto plot = parse(text);
    ASSERT_FALSE(plot) << text;
    EXPECT_EQ(plot.error().fault, SyntaxFault::area_form) << text;
    EXPECT_EQ(plot.error().column, 1) << text;
  }
  EXPECT_EQ(parse("y = 2 area(x, 0, 1)").error().fault, SyntaxFault::does_not_fit);
}

}  // namespace
}  // namespace nazori::functions
