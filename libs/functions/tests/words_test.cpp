// SPDX-License-Identifier: Apache-2.0
// Expressions, points, summaries and mistakes as they are told, in English and Japanese.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "nazori/functions/points.h"

namespace nazori::functions {
namespace {

constexpr Language kEnglish = Language::english;
constexpr Language kJapanese = Language::japanese;

Expression read(const std::string& text) {
  const auto plot = parse("x + y = " + text);
  EXPECT_TRUE(plot) << text;
  return plot->statements[0].terms[1];
}

struct Said {
  const char* typed;
  const char* english;
  const char* japanese;
};

TEST(Words, ExpressionsAreSaidAsTheyAreRead) {
  const Said all[] = {
      {"x + y", "x plus y", "x 足す y"},
      {"x - (y - 1)", "x minus the quantity y minus 1 end quantity", "x 引く 括弧 y 引く 1 括弧閉じ"},
      {"x - y + 1", "x minus y plus 1", "x 引く y 足す 1"},
      {"2x", "2 x", "2 x"},
      {"2x y", "2 x times y", "2 x かける y"},
      {"2(x y)", "2 times the quantity x times y end quantity", "2 かける 括弧 x かける y 括弧閉じ"},
      {"2(x+1)", "2 times the quantity x plus 1 end quantity", "2 かける 括弧 x 足す 1 括弧閉じ"},
      {"(x+1)2", "the quantity x plus 1 end quantity times 2", "括弧 x 足す 1 括弧閉じ かける 2"},
      {"x/y", "x over y", "y 分の x"},
      {"1 - x/2", "1 minus x over 2", "1 引く 2 分の x"},
      {"x y/2", "the fraction with numerator x times y and denominator 2 end fraction",
       "分数 分母 2 分子 x かける y 分数終わり"},
      {"x/y/2",
       "the fraction with numerator the fraction with numerator x and denominator y end fraction and "
       "denominator 2 end fraction",
       "分数 分母 2 分子 分数 分母 y 分子 x 分数終わり 分数終わり"},
      {"(x/y)*2", "the quantity x over y end quantity times 2", "括弧 y 分の x 括弧閉じ かける 2"},
      {"-x", "minus x", "マイナス x"},
      {"-(x+1)", "minus the quantity x plus 1 end quantity", "マイナス 括弧 x 足す 1 括弧閉じ"},
      {"x^2", "x squared", "x の 2 乗"},
      {"x^3", "x cubed", "x の 3 乗"},
      {"x^4", "x to the power of 4", "x の 4 乗"},
      {"x^-2", "x to the power of minus 2", "x の マイナス 2 乗"},
      {"x^y", "x to the power of y", "x の y 乗"},
      {"x^(y+1)", "x to the power of y plus 1 end power", "x の 括弧 y 足す 1 括弧閉じ 乗"},
      {"x^(y^2)", "x to the power of y squared end power", "x の 括弧 y の 2 乗 括弧閉じ 乗"},
      {"(x^y)^2", "the quantity x to the power of y end quantity squared", "括弧 x の y 乗 括弧閉じ の 2 乗"},
      {"(x+1)^2", "the quantity x plus 1 end quantity squared", "括弧 x 足す 1 括弧閉じ の 2 乗"},
      {"(-x)^3", "the quantity minus x end quantity cubed", "括弧 マイナス x 括弧閉じ の 3 乗"},
      {"-x^3", "minus x cubed", "マイナス x の 3 乗"},
      {"pi e", "pi times e", "パイ かける e"},
      {"x + theta", "x plus theta", "x 足す シータ"},
      {"sin x", "sine of x", "サイン x"},
      {"sin 2x", "sine of 2 x", "サイン 2 x"},
      {"sin(2) x", "sine of 2 times x", "サイン 2 かける x"},
      {"cos(x+1)", "cosine of the quantity x plus 1 end quantity", "コサイン 括弧 x 足す 1 括弧閉じ"},
      {"sin(x)^2", "sine squared of x", "サイン 2 乗 x"},
      {"sin(x^2)", "sine of the quantity x squared end quantity", "サイン 括弧 x の 2 乗 括弧閉じ"},
      {"ln(x)^2", "natural logarithm squared of x", "自然対数 2 乗 x"},
      {"ln(x^2)", "the natural logarithm of the quantity x squared end quantity",
       "自然対数 括弧 x の 2 乗 括弧閉じ"},
      {"sin(x)/x", "the fraction with numerator sine of x and denominator x end fraction",
       "分数 分母 x 分子 サイン x 分数終わり"},
      {"sin(x/x)", "sine of the quantity x over x end quantity", "サイン 括弧 x 分の x 括弧閉じ"},
      {"cos(x) sin(x)", "cosine of x times sine of x", "コサイン x かける サイン x"},
      {"cos(x sin(x))", "cosine of the quantity x times sine of x end quantity",
       "コサイン 括弧 x かける サイン x 括弧閉じ"},
      {"sin(cos(x))", "sine of cosine of x", "サイン 括弧 コサイン x 括弧閉じ"},
      {"x!", "x factorial", "x の階乗"},
      {"(x+1)!", "the quantity x plus 1 end quantity factorial", "括弧 x 足す 1 括弧閉じ の階乗"},
      {"gamma(x)", "gamma of x", "ガンマ関数 x"},
      {"log_2 x", "logarithm to base 2 of x", "底 2 の対数 x"},
      {"log_b(2, x)", "logarithm to base 2 of x", "底 2 の対数 x"},
      {"log_(x+1)2", "logarithm to base the quantity x plus 1 end quantity of 2",
       "底 括弧 x 足す 1 括弧閉じ の対数 2"},
      {"root(3, x)", "the third root of x", "3 乗根 x"},
      {"root(4, x y)", "the fourth root of the quantity x times y end quantity",
       "4 乗根 括弧 x かける y 括弧閉じ"},
      {"root(21, x)", "the 21st root of x", "21 乗根 x"},
      {"root(12, x)", "the 12th root of x", "12 乗根 x"},
      {"root(y, x)", "the root with index y of x", "y 乗根 x"},
      {"cbrt(x)", "the cube root of x", "立方根 x"},
      {"sqrt(x)", "the square root of x", "平方根 x"},
      {"sqrt(x+1)", "the square root of the quantity x plus 1 end quantity", "平方根 括弧 x 足す 1 括弧閉じ"},
      {"sqrt(x)+1", "the square root of x plus 1", "平方根 x 足す 1"},
      {"min(x, y+1)", "the minimum of x and y plus 1 end minimum", "最小値 x と y 足す 1 最小値 終わり"},
      {"atan2(y, x)", "the angle of y and x end angle", "偏角 y と x 偏角 終わり"}};
  for (const Said& s : all) {
    const Expression e = s.typed == std::string("x + theta")
                             ? binary(NodeKind::add, variable(Variable::x), variable(Variable::theta))
                             : read(s.typed);
    EXPECT_EQ(in_words(e, kEnglish), s.english) << s.typed;
    EXPECT_EQ(in_words(e, kJapanese), s.japanese) << s.typed;
  }
  EXPECT_EQ(in_words(number(-2.5), kEnglish), "minus 2.5");
  EXPECT_EQ(in_words(number(-2.5), kJapanese), "マイナス2.5");
  EXPECT_EQ(in_words(number(0), kEnglish), "0");
}

TEST(Words, EveryFunctionHasItsOwn) {
  const std::pair<Function, const char*> names[] = {{Function::tan, "tangent"},
                                                    {Function::cot, "cotangent"},
                                                    {Function::sec, "secant"},
                                                    {Function::csc, "cosecant"},
                                                    {Function::asin, "arc sine"},
                                                    {Function::acos, "arc cosine"},
                                                    {Function::atan, "arc tangent"},
                                                    {Function::acot, "arc cotangent"},
                                                    {Function::sinh, "hyperbolic sine"},
                                                    {Function::cosh, "hyperbolic cosine"},
                                                    {Function::tanh, "hyperbolic tangent"},
                                                    {Function::coth, "hyperbolic cotangent"},
                                                    {Function::sech, "hyperbolic secant"},
                                                    {Function::csch, "hyperbolic cosecant"}};
  for (const auto& [f, name] : names)
    EXPECT_EQ(in_words(call(f, {variable(Variable::x)}), kEnglish), std::string(name) + " of x");
  const std::pair<Function, const char*> others[] = {{Function::asinh, "inverse hyperbolic sine"},
                                                     {Function::exp, "exponential"},
                                                     {Function::ln, "natural logarithm"},
                                                     {Function::log10, "logarithm to base 10"},
                                                     {Function::log2, "logarithm to base 2"},
                                                     {Function::cbrt, "cube root"},
                                                     {Function::abs, "absolute value"},
                                                     {Function::floor, "floor"},
                                                     {Function::round, "rounding"},
                                                     {Function::fraction, "fractional part"},
                                                     {Function::gamma, "gamma"},
                                                     {Function::erf, "error function"}};
  for (const auto& [f, name] : others)
    EXPECT_EQ(in_words(call(f, {variable(Variable::x)}), kEnglish),
              (f == Function::asinh || f == Function::gamma ? "" : "the ") + std::string(name) + " of x");
}

TEST(Words, StatementsAreSaidWithTheirComparisonsAndRanges) {
  const Said all[] = {
      {"y = x", "y equals x", "y イコール x"},
      {"x = y^2", "x equals y squared", "x イコール y の 2 乗"},
      {"z = x y", "z equals x times y", "z イコール x かける y"},
      {"x + y = 1", "x plus y equals 1", "x 足す y イコール 1"},
      {"y < x", "y is less than x", "y 小なり x"},
      {"y <= x", "y is at most x", "y 小なりイコール x"},
      {"y > x", "y is greater than x", "y 大なり x"},
      {"1 >= y > x", "1 is at least y is greater than x", "1 大なりイコール y 大なり x"},
      {"x = t; y = 2; 0 <= t <= 1", "x equals t and y equals 2, for t from 0 to 1",
       "x イコール t、y イコール 2、t は 0 から 1 まで"},
      {"r = 2; 0 < theta <= pi", "r equals 2, for theta from 0 to pi, 0 excluded",
       "r イコール 2、シータ は 0 から パイ まで、0 を除く"},
      {"r^2 = theta; 0 <= theta < 1", "r squared equals theta, for theta from 0 to 1, 1 excluded",
       "r の 2 乗 イコール シータ、シータ は 0 から 1 まで、1 を除く"},
      {"r < 2", "r is less than 2", "r 小なり 2"},
      {"r < 2; 0 <= theta <= 1", "r is less than 2, for theta from 0 to 1",
       "r 小なり 2、シータ は 0 から 1 まで"},
      {"y = x; y = 1", "y equals x; y equals 1", "y イコール x。y イコール 1"}};
  for (const Said& s : all) {
    const auto plot = parse(s.typed);
    ASSERT_TRUE(plot) << s.typed;
    EXPECT_EQ(in_words(*plot, kEnglish), s.english) << s.typed;
    EXPECT_EQ(in_words(*plot, kJapanese), s.japanese) << s.typed;
  }
}

PointOfInterest point(PointKind kind, double x, double y, const char* x_name = "", const char* y_name = "") {
  PointOfInterest p;
  p.kind = kind;
  p.x = x;
  p.y = y;
  p.x_name = x_name;
  p.y_name = y_name;
  return p;
}

TEST(Words, PointsAreSaidWithExactNamesFirst) {
  const double nan = std::nan("");
  const auto sentence = [](const PointOfInterest& p) { return in_words(p, kEnglish); };
  EXPECT_EQ(sentence(point(PointKind::maximum, 1.5707963, 1, "pi/2", "1")),
            "maximum at x = pi over 2, about 1.571; y = 1");
  EXPECT_EQ(sentence(point(PointKind::zero, -2.34567, 0, "", "0")), "zero at x = about minus 2.346; y = 0");
  EXPECT_EQ(sentence(point(PointKind::zero, -2, 1e-13, "-2", "")), "zero at x = minus 2; y = about 0");
  EXPECT_EQ(sentence(point(PointKind::vertical_asymptote, 0.5, nan, "1/2")),
            "vertical asymptote at x = 1 over 2, about 0.5");
  EXPECT_EQ(sentence(point(PointKind::horizontal_asymptote, nan, 3, "", "3")),
            "horizontal asymptote at y = 3");
  EXPECT_EQ(in_words(point(PointKind::maximum, 1.5707963, -1, "pi/2", "-1"), kJapanese),
            "極大: x = 2 分の パイ、約1.571、y = マイナス1");
  EXPECT_EQ(in_words(point(PointKind::horizontal_asymptote, nan, 3.25), kJapanese), "水平漸近線: y = 約3.25");
}

TEST(Words, EveryKindOfPointHasItsName) {
  const char* english[] = {"zero",
                           "y intercept",
                           "maximum",
                           "minimum",
                           "inflection point",
                           "crossing",
                           "point of contact",
                           "vertical asymptote",
                           "horizontal asymptote",
                           "hole",
                           "jump",
                           "end",
                           "self-crossing",
                           "singular point",
                           "isolated point",
                           "cusp",
                           "slanted asymptote"};
  std::set<std::string> japanese;
  for (int k = 0; k < 17; ++k) {
    EXPECT_EQ(in_words(static_cast<PointKind>(k), kEnglish), english[k]);
    EXPECT_TRUE(japanese.insert(in_words(static_cast<PointKind>(k), kJapanese)).second);
  }
  EXPECT_EQ(static_cast<int>(PointKind::slanted_asymptote), 16);
  EXPECT_EQ(in_words(PointKind::zero, kJapanese), "零点");
}

TEST(Words, APlaceIsSaidInFourDigitsAndWholeNumbersAsTheyAre) {
  EXPECT_EQ(place_in_words(1.23456, -12.3456, kEnglish), "x = about 1.235; y = about minus 12.35");
  EXPECT_EQ(place_in_words(0, -0.0, kEnglish), "x = 0; y = 0");
  EXPECT_EQ(place_in_words(9999, -9999, kEnglish), "x = 9999; y = minus 9999");
  EXPECT_EQ(place_in_words(10000, 12345, kEnglish), "x = about 10000; y = about 12350");
  EXPECT_EQ(place_in_words(1.5, 2, kJapanese), "x = 約1.5、y = 2");
}

TEST(Words, ASummaryCountsWhatIsThere) {
  const auto plot = parse("y = x");
  ASSERT_TRUE(plot);
  Tracing t;
  t.window = {-1, 1, -1, 1};
  const auto sentence = [&](const std::vector<PointOfInterest>& points = {}) {
    return summary(*plot, t, points, kEnglish);
  };
  EXPECT_EQ(sentence(), "y equals x: no points in this range.");
  EXPECT_EQ(summary(*plot, t, {}, kJapanese), "y イコール x。この範囲に点はありません。");
  t.dots.push_back({});
  EXPECT_EQ(sentence(),
            "y equals x, far to the left y falls without bound, far to the right y rises without bound.");
  t.dots.clear();
  t.fills.push_back({});
  EXPECT_EQ(sentence(),
            "y equals x, far to the left y falls without bound, far to the right y rises without bound.");
  t.fills.clear();
  t.bars.push_back({});
  EXPECT_EQ(sentence(),
            "y equals x, far to the left y falls without bound, far to the right y rises without bound.");
  t.bars.clear();
  // Straight lines across the window, one above the other.
  const auto line_at = [](double v) {
    Branch branch;
    branch.points.resize(2);
    branch.points[0].v = branch.points[1].v = v;
    branch.points[1].u = 1;
    return branch;
  };
  t.branches = {line_at(0.5)};
  EXPECT_EQ(
      sentence(),
      "y equals x: 1 piece, far to the left y falls without bound, far to the right y rises without bound.");
  t.branches = {line_at(0.2), line_at(0.5), line_at(0.8)};
  EXPECT_EQ(
      sentence({point(PointKind::maximum, 0, 0), point(PointKind::zero, 0, 0), point(PointKind::zero, 1, 0)}),
      "y equals x: 3 pieces, 2 zeros, 1 maximum, far to the left y falls without bound, far to the right y "
      "rises without bound.");
  EXPECT_EQ(summary(*plot, t, {point(PointKind::zero, 0, 0)}, kJapanese),
            "y イコール x。3つの部分、零点 1個、左の遠くでは y は 限りなく小さくなります、右の遠くでは y は "
            "限りなく大きくなります。");
  t.dense = true;
  t.complete = false;
  EXPECT_EQ(sentence(),
            "y equals x: 3 pieces, far to the left y falls without bound, far to the right y rises without "
            "bound, a dense band, not finished yet.");
  EXPECT_EQ(summary(*plot, t, {}, kJapanese),
            "y イコール x。3つの部分、左の遠くでは y は 限りなく小さくなります、右の遠くでは y は "
            "限りなく大きくなります、密な帯、まだ途中です。");
}

TEST(Words, ASummarySaysWhatIsUndecidedAboveATenthOfAPercent) {
  const auto plot = parse("y = x");
  ASSERT_TRUE(plot);
  Tracing t;
  t.window = {-1, 1, -2, 2};
  Branch branch;
  branch.points.resize(2);
  branch.points[1].u = branch.points[1].v = 1;
  t.branches.push_back(branch);
  t.cells = 10'000;
  t.undecided_cells = 10;
  EXPECT_EQ(
      summary(*plot, t, {}, kEnglish),
      "y equals x: 1 piece, far to the left y falls without bound, far to the right y rises without bound.");
  t.undecided_cells = 11;
  EXPECT_EQ(t.undecided_share(), 0.0011);
  EXPECT_EQ(summary(*plot, t, {}, kEnglish),
            "y equals x: 1 piece, far to the left y falls without bound, far to the right y rises without "
            "bound, part of the plot could not be determined.");
  t.undecided_places.push_back({0.75, 0.25});
  t.undecided_places.push_back({0.1, 0.1});
  EXPECT_EQ(summary(*plot, t, {}, kEnglish),
            "y equals x: 1 piece, far to the left y falls without bound, far to the right y rises without "
            "bound, part of the plot could not be determined, first near x = about 0.5; y = minus 1.");
  EXPECT_EQ(summary(*plot, t, {}, kJapanese),
            "y イコール x。1つの部分、左の遠くでは y は 限りなく小さくなります、右の遠くでは y は "
            "限りなく大きくなります、一部は判定できませんでした（x = 約0.5、y = マイナス1 の近くなど）。");
  const auto surface = parse("z = x y");
  ASSERT_TRUE(surface);
  EXPECT_EQ(summary(*surface, t, {}, kEnglish), "z equals x times y.");
}

TEST(Words, MistakesAreToldWithTheirNumbers) {
  const auto error_text = [](const char* typed) { return in_words(parse(typed).error(), kEnglish); };
  EXPECT_EQ(error_text("y = mod(x)").message, "\"mod\" has 1 argument");
  EXPECT_EQ(error_text("y = mod(x)").expected, "expected two arguments");
  EXPECT_EQ(error_text("y = mod(x,1,2)").message, "\"mod\" has 3 arguments");
  EXPECT_EQ(error_text("y = sin(x; 1)").expected, "expected one argument");
  EXPECT_EQ(error_text("y = min(x)").expected, "expected two arguments or more");
  EXPECT_EQ(error_text("y = |x").message, "the bar opened in column 5 is not closed");
  EXPECT_EQ(error_text("y = (x").message, "the \"(\" in column 5 is not closed");
  EXPECT_EQ(error_text("y = (x").expected, "expected \")\"");
  EXPECT_EQ(in_words(parse("y = min(x)").error(), kJapanese).expected, "2 個以上の引数が必要です");
  EXPECT_EQ(in_words(parse("y = mod(x)").error(), kJapanese).expected, "2 個の引数が必要です");
  const base::Error error = parse("y = mod(x)").error().to_error();
  EXPECT_EQ(error.code, base::Errc::parse);
  EXPECT_EQ(error.where, "column 5");
  EXPECT_EQ(error.what, "\"mod\" has 1 argument");
}

}  // namespace
}  // namespace nazori::functions
