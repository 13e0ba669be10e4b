// SPDX-License-Identifier: Apache-2.0
// Models fitted to points: y ~ a x + b. The truth is that of others: closed forms, data sets with certified
// values (NIST Statistical Reference Datasets, https://www.itl.nist.gov/div898/strd/), Anscombe's quartet.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "nazori/functions/braille.h"
#include "nazori/functions/data_points.h"
#include "nazori/functions/plot.h"
#include "nazori/functions/tracing.h"
#include "test_paths.h"
#include "typed_plots.h"

namespace nazori::functions {
namespace {

using F = SyntaxFault;

/// The fit of the only model of a text.
Fit fit_of(const std::string& typed, const std::vector<DataPoint>& data = {}) {
  const auto plot = parse(typed, {}, data);
  EXPECT_TRUE(plot) << typed << (plot ? "" : plot.error().to_error().what);
  if (!plot) return {};
  for (const Statement& s : plot->statements) {
    if (s.fit) return *s.fit;
  }
  ADD_FAILURE() << typed << " has no model";
  return {};
}

double value_of(const Fit& fit, const std::string& letter) {
  for (const FittedLetter& l : fit.letters) {
    if (l.name == letter) return l.value;
  }
  return std::nan("");
}

/// Agreement to this many significant digits.
void expect_digits(double value, double certified, double digits) {
  EXPECT_NEAR(value, certified, std::abs(certified) * std::pow(10.0, -digits));
}

TEST(Fits, NorrisHasItsCertifiedLine) {
  const auto data = load_data_points(std::string(test_paths::kFixtures) + "/norris.csv");
  ASSERT_TRUE(data);
  ASSERT_EQ(data->size(), 36U);
  const Fit fit = fit_of("y ~ a x + b", *data);
  expect_digits(value_of(fit, "b"), -0.262323073774029, 12);
  expect_digits(value_of(fit, "a"), 1.00211681802045, 13);
  expect_digits(fit.r_squared, 0.999993745883712, 14);
  expect_digits(fit.residual_sum, 26.6173985294224, 11);
  EXPECT_EQ(fit.points, 36U);
}

TEST(Fits, WamplersPolynomialsOfDegree5HaveTheirCertifiedCoefficients) {
  // Wampler 1: y = 1 + x + ... + x^5 at 0 to 20; Wampler 2 with 0.1^k. Double precision loses digits here.
  std::vector<DataPoint> one;
  std::vector<DataPoint> two;
  for (int i = 0; i <= 20; ++i) {
    double y1 = 0;
    long double y2 = 0;
    for (int k = 5; k >= 0; --k) {
      y1 = y1 * i + 1;
      y2 = y2 * i + std::pow(0.1L, k);
    }
    one.push_back({static_cast<double>(i), y1});
    // The data set has 5 decimals, which are exact.
    two.push_back({static_cast<double>(i), std::stod(std::to_string(static_cast<double>(y2)))});
  }
  const std::string model = "y ~ a + b x + c x^2 + d x^3 + f x^4 + g x^5";
  for (const FittedLetter& l : fit_of(model, one).letters) EXPECT_NEAR(l.value, 1, 1e-12) << l.name;
  double certified = 1;
  for (const FittedLetter& l : fit_of(model, two).letters) {
    expect_digits(l.value, certified, 9);
    certified /= 10;
  }
}

TEST(Fits, Misra1aHasItsCertifiedExponential) {
  const std::vector<DataPoint> data{{77.6, 10.07},  {114.9, 14.73}, {141.1, 17.94}, {190.8, 23.93},
                                    {239.9, 29.61}, {289.0, 35.18}, {332.8, 40.02}, {378.4, 44.82},
                                    {434.8, 50.76}, {477.3, 55.05}, {536.8, 61.01}, {593.1, 66.40},
                                    {689.1, 75.47}, {760.0, 81.78}};
  const Fit fit = fit_of("y ~ a (1 - e^(-b x))", data);
  expect_digits(value_of(fit, "a"), 238.94212918, 8);
  expect_digits(value_of(fit, "b"), 5.5015643181e-4, 8);
  expect_digits(fit.residual_sum, 0.12455138894, 9);
}

TEST(Fits, AnscombesQuartetHasOneLine) {
  // F. J. Anscombe, Graphs in Statistical Analysis, The American Statistician 27 (1973).
  const std::string x = "[10,8,13,9,11,14,6,4,12,7,5]";
  const std::string points[] = {
      "(" + x + ", [8.04,6.95,7.58,8.81,8.33,9.96,7.24,4.26,10.84,4.82,5.68])",
      "(" + x + ", [9.14,8.14,8.74,8.77,9.26,8.10,6.13,3.10,9.13,7.26,4.74])",
      "(" + x + ", [7.46,6.77,12.74,7.11,7.81,8.84,6.08,5.39,8.15,6.42,5.73])",
      "([8,8,8,8,8,8,8,19,8,8,8], [6.58,5.76,7.71,8.84,8.47,7.04,5.25,12.50,5.56,7.91,6.89])"};
  for (const std::string& one : points) {
    const Fit fit = fit_of(one + "; y ~ m x + b");
    EXPECT_NEAR(value_of(fit, "m"), 0.500, 5e-4) << one;
    EXPECT_NEAR(value_of(fit, "b"), 3.00, 5e-3) << one;
    EXPECT_NEAR(fit.r_squared, 0.67, 5e-3) << one;
  }
}

TEST(Fits, AsManyPointsAsLettersAreMetExactly) {
  const Fit line = fit_of("(1, 5), (3, 9); y ~ a x + b");
  EXPECT_EQ(value_of(line, "a"), 2);
  EXPECT_EQ(value_of(line, "b"), 3);
  EXPECT_EQ(line.residual_sum, 0);
  EXPECT_EQ(line.r_squared, 1);
  const Fit parabola = fit_of("(0, 1), (1, 2), (2, 5); y ~ a x^2 + b x + c");
  EXPECT_NEAR(value_of(parabola, "a"), 1, 1e-15);
  EXPECT_NEAR(value_of(parabola, "b"), 0, 1e-15);
  EXPECT_NEAR(value_of(parabola, "c"), 1, 1e-15);
}

TEST(Fits, AMeanIsAModel) {
  const Fit fit = fit_of("([1, 2, 3, 4], [2, 4, 4, 10]); y ~ m");
  EXPECT_NEAR(value_of(fit, "m"), 5, 1e-15);
  EXPECT_NEAR(fit.residual_sum, 9 + 1 + 1 + 25, 1e-13);
  EXPECT_NEAR(fit.r_squared, 0, 1e-15);
}

TEST(Fits, OfEqualHeightsHaveNoRSquared) {
  const Fit fit = fit_of("([1, 2, 3], 5); y ~ a x + b");
  EXPECT_EQ(value_of(fit, "a"), 0);
  EXPECT_TRUE(std::isnan(fit.r_squared));
}

TEST(Fits, TheLettersOfCurvedModelsAreFound) {
  const Fit growth = fit_of("([0...5], 3 e^(-0.4[0...5])); y ~ a e^(b x)");
  EXPECT_NEAR(value_of(growth, "a"), 3, 1e-9);
  EXPECT_NEAR(value_of(growth, "b"), -0.4, 1e-9);
  const Fit wave = fit_of("([0...20], 2 sin(0.7[0...20] + 1)); y ~ a sin(b x + c)");
  EXPECT_NEAR(value_of(wave, "a"), 2, 1e-8);
  EXPECT_NEAR(value_of(wave, "b"), 0.7, 1e-8);
  EXPECT_NEAR(value_of(wave, "c"), 1, 1e-7);
  const Fit power = fit_of("([1...9], 2 [1...9]^1.5); y ~ a x^b");
  EXPECT_NEAR(value_of(power, "a"), 2, 1e-9);
  EXPECT_NEAR(value_of(power, "b"), 1.5, 1e-9);
  const Fit bell = fit_of("([-3...3], 4 e^(-([-3...3] - 1)^2/2)); y ~ a e^(-(x - b)^2/(2 c^2))");
  EXPECT_NEAR(value_of(bell, "a"), 4, 1e-8);
  EXPECT_NEAR(value_of(bell, "b"), 1, 1e-8);
  EXPECT_NEAR(std::abs(value_of(bell, "c")), 1, 1e-8);
  const Fit logistic = fit_of("([0...10], 5/(1 + 9e^(-[0...10]))); y ~ a/(1 + b e^(-c x))");
  EXPECT_NEAR(value_of(logistic, "a"), 5, 1e-7);
  EXPECT_NEAR(value_of(logistic, "b"), 9, 1e-6);
  EXPECT_NEAR(value_of(logistic, "c"), 1, 1e-7);
}

TEST(Fits, TheSameTextAlwaysHasTheSameFit) {
  const std::string typed = "([0...6], [1, 3, 2, 5, 4, 9, 7]); y ~ a sin(b x + c) + d x";
  const Fit first = fit_of(typed);
  const Fit second = fit_of(typed);
  for (std::size_t i = 0; i < first.letters.size(); ++i)
    EXPECT_EQ(first.letters[i].value, second.letters[i].value);
}

TEST(Fits, ALetterWithADefinitionIsGiven) {
  const Fit fit = fit_of("(1, 5), (3, 11); b = 2; y ~ a x + b");
  ASSERT_EQ(fit.letters.size(), 1U);
  EXPECT_NEAR(value_of(fit, "a"), 3, 1e-15);
  const Fit own = fit_of("f(x) = x^2; ([1, 2], [3, 9]); y ~ k f(x) + m");
  EXPECT_NEAR(value_of(own, "k"), 2, 1e-14);
  EXPECT_NEAR(value_of(own, "m"), 1, 1e-14);
}

TEST(Fits, AConditionChoosesThePointsAndThePartThatIsDrawn) {
  const auto plot = parse("([1, 2, 3, 4], [1, 2, 3, 100]); y ~ a x + b {x < 3.5}");
  ASSERT_TRUE(plot);
  const Statement& curve = plot->statements[1];
  ASSERT_TRUE(curve.fit);
  EXPECT_EQ(curve.fit->points, 3U);
  EXPECT_NEAR(value_of(*curve.fit, "a"), 1, 1e-15);
  EXPECT_EQ(canonical(*plot), "([1, 2, 3, 4], [1, 2, 3, 100]); y ~ a*x + b {x < 3.5}");
  const auto tracing = trace(*plot, {-10, 10, -10, 10});
  ASSERT_TRUE(tracing);
  double last = 0;
  for (const Branch& b : tracing->branches) last = std::max(last, b.points.back().u);
  EXPECT_NEAR(last, (3.5 + 10) / 20, 1e-6);
}

TEST(Fits, AreWrittenAsTypedAndDrawnAsTheirCurve) {
  const auto plot = parse("(1, 2), (3, -4); y ~ ax + b");
  ASSERT_TRUE(plot);
  EXPECT_EQ(canonical(*plot), "(1, 2); (3, -4); y ~ a*x + b");
  const Statement& curve = plot->statements[2];
  EXPECT_EQ(canonical(curve), "y = -3*x + 5");
  EXPECT_EQ(curve.kind, StatementKind::explicit_y);
  EXPECT_EQ(canonical(*parse("(1, 1), (3, 7); y～mx+c")), "(1, 1); (3, 7); y ~ m*x + c");
  EXPECT_EQ(canonical(parse("(1, 1), (3, 7); y ~ m x + c")->statements[2]), "y = 3*x - 2");
  EXPECT_TRUE(plot->parameters.empty());
}

TEST(Fits, AreSpokenWithRoundedValues) {
  const auto plot = parse("(1, 2.1), (2, 3.9), (3, 6.2); y ~ a x + b");
  ASSERT_TRUE(plot);
  EXPECT_EQ(
      in_words(plot->statements[3], Language::english),
      "y is fitted by a x plus b, a is 2.05, b is about minus 0.03333, R squared is about 0.9951, the sum of "
      "squared residuals is about 0.04167, from 3 points");
  EXPECT_EQ(in_words(plot->statements[3], Language::japanese),
            "y の近似式 a x 足す b、a は 2.05、b は 約マイナス0.03333、決定係数は 約0.9951、残差平方和は "
            "約0.04167、点 3 個");
  // What is very small has a power of ten, and what is not 1 does not sound like 1.
  const std::string words = in_words(*parse("([1, 2], [0.0000012, 0.0000024]); y ~ a x"), Language::english);
  EXPECT_NE(words.find("a is 1.2 times 10 to the power of minus 6"), std::string::npos) << words;
  const auto data = load_data_points(std::string(test_paths::kFixtures) + "/norris.csv");
  const auto norris = parse("y ~ a x + b", {}, *data);
  EXPECT_NE(in_words(*norris, Language::english).find("R squared is about 0.99999,"), std::string::npos);
  EXPECT_EQ(in_words(norris->statements[1], Language::english),
            "36 data points, x from 0.2 to 999, y from 0.1 to 998.5");
}

TEST(Fits, AreInBrailleWithATildeAndTheirValues) {
  const auto plot = parse("(1, 5), (3, 9); y ~ a x + b");
  ASSERT_TRUE(plot);
  // The tilde: Nemeth § 148, and UEB.
  EXPECT_EQ(in_braille(plot->statements[2], BrailleCode::nemeth), "⠽⠀⠈⠱⠀⠁⠭⠬⠃\n⠁⠀⠨⠅⠀⠼⠆\n⠃⠀⠨⠅⠀⠼⠒");
  EXPECT_EQ(in_braille(plot->statements[2], BrailleCode::ueb), "⠰⠰⠰⠽⠀⠈⠔⠀⠁⠭⠐⠖⠃⠰⠄\n⠰⠰⠰⠁⠀⠐⠶⠀⠼⠃⠰⠄\n⠰⠰⠰⠃⠀⠐⠶⠀⠼⠉⠰⠄");
}

TEST(Fits, LettersThatAreFactorsUnderAnIntegralAreFound) {
  // The integral of 3t + 1 is 1.5 x^2 + x.
  const Fit line = fit_of("([1, 2, 3, 4], [2.5, 8, 16.5, 28]); y ~ integral(a t + b, t, 0, x)");
  EXPECT_NEAR(value_of(line, "a"), 3, 1e-12);
  EXPECT_NEAR(value_of(line, "b"), 1, 1e-12);
  EXPECT_NEAR(line.residual_sum, 0, 1e-20);
  // x^2 + e^(x/2): one letter under the integral, another one that is searched.
  std::vector<DataPoint> data;
  for (double x = -2; x <= 2; x += 0.5) data.push_back({x, x * x + std::exp(x / 2)});
  const Fit both = fit_of("y ~ integral(a t, t, 0, x) + e^(c x)", data);
  EXPECT_NEAR(value_of(both, "a"), 2, 1e-8);
  EXPECT_NEAR(value_of(both, "c"), 0.5, 1e-8);
}

TEST(Fits, MistakesAreNamedWithTheirColumn) {
  const test::Mistake mistakes[] = {
      {"(1, 2); y ~ a x + b", F::too_few_points, 9},
      {"y ~ a x", F::too_few_points, 1},
      {"(1, 2), (1, 3); y ~ a x + b", F::letters_undetermined, 17},
      {"([1, 2, 3], [1, 2, 4]); y ~ a x + b x", F::letters_undetermined, 25},
      {"([1, 2, 3], [1, 2, 4]); y ~ a b x", F::letters_undetermined, 25},
      {"([0, 1, 2], [1, 2, 3]); y ~ a ln(x)", F::model_undefined, 25},
      {"([0, 1, 2], [1, 2, 3]); y ~ integral(e^(a t), t, 0, x)", F::letter_under_integral, 25},
      {"([0, 1, 2], [1, 2, 3]); y ~ b + integral(sin(a t), t, 0, x)", F::letter_under_integral, 25},
      {"(1, 2); y ~ 2x", F::no_letter, 9},
      {"(1, 2); x ~ a y", F::model_form, 9},
      {"(1, 2); y ~ a t", F::model_form, 9},
      {"(1, 2); y ~ a x and y > 1", F::model_form, 9},
      {"(1, 2); y ~ [a, 1] x", F::list_misplaced, 9},
      {"(1, 2); y ~ a x {x < b}", F::unknown_name, 22},
      {"(1, 2); y ~ a x; y = a", F::unknown_name, 22},
      {"(1, 2); y ~", F::operand_missing, 12},
      {"(1, 2), f(x) = x ~ a", F::unknown_name, 9},
      {"(1, 2); y = a ~ x", F::unknown_name, 13},
  };
  test::expect_refused(mistakes);
}

}  // namespace
}  // namespace nazori::functions
