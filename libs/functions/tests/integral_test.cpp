// SPDX-License-Identifier: Apache-2.0
// Integrals, against closed forms and published values.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "nazori/functions/dual.h"
#include "nazori/functions/plot.h"
#include "nazori/functions/tape.h"

namespace nazori::functions {
namespace {

Expression read(const std::string& text) {
  const auto plot = parse(text);
  if (!plot) ADD_FAILURE() << text << ": " << in_words(plot.error(), Language::english).message;
  return plot ? plot->statements[0].terms[0] : number(0);
}

Tape tape_of(const std::string& text) {
  const Expression e = read(text);
  return Tape::compile(std::array{e}, std::array{Variable::x});
}

template <class T>
T value(const Tape& tape, T x) {
  return tape.evaluate_one<T>(std::array{x});
}

struct Known {
  const char* text;
  std::function<double(double)> closed;
  double from;
  double to;
};

double half_wave(double x) { return std::sqrt(std::numbers::pi) / 2 * std::erf(x); }

const std::vector<Known>& table() {
  using std::abs, std::cos, std::cosh, std::exp, std::floor, std::log, std::sin, std::sqrt;
  static const std::vector<Known> all{
      {"integral(cos(t), t, 0, x)", [](double x) { return sin(x); }, -10, 10},
      {"integral(1/t, t, 1, x)", [](double x) { return log(x); }, 1e-6, 100},
      {"integral(e^(-t^2), t, 0, x)", half_wave, -5, 5},
      {"integral(t^2, t, -1, x)", [](double x) { return (x * x * x + 1) / 3; }, -4, 4},
      {"integral(|t|, t, 0, x)", [](double x) { return x * abs(x) / 2; }, -3, 3},
      {"integral(|t - 1/3|, t, 0, x)",
       [](double x) { return (x - 1.0 / 3) * abs(x - 1.0 / 3) / 2 + 1.0 / 18; }, -3, 3},
      {"integral(floor(t), t, 0, x)",
       [](double x) { return floor(x) * (x - floor(x)) + floor(x) * (floor(x) - 1) / 2; }, -3, 5},
      {"integral(sign(t), t, 0, x)", [](double x) { return abs(x); }, -3, 3},
      {"integral({t < 1: t, t >= 1: 5}, t, 0, x)",
       [](double x) { return x < 1 ? x * x / 2 : 0.5 + 5 * (x - 1); }, -3, 3},
      {"integral(max(t, 1), t, 0, x)", [](double x) { return x < 1 ? x : 1 + (x * x - 1) / 2; }, -3, 3},
      {"integral(sqrt(t), t, 0, x)", [](double x) { return 2 * x * sqrt(x) / 3; }, 0, 9},
      {"integral(cbrt(t), t, 0, x)", [](double x) { return 0.75 * x * std::cbrt(x); }, -8, 8},
      {"integral(1/(1+t^2), t, 0, x)", [](double x) { return std::atan(x); }, -20, 20},
      {"integral(1/sqrt(1+t^2), t, 0, x)", [](double x) { return std::asinh(x); }, -20, 20},
      {"integral(1/cos(t)^2, t, 0, x)", [](double x) { return std::tan(x); }, -1.5, 1.5},
      {"integral(tan(t), t, 0, x)", [](double x) { return -log(cos(x)); }, -1.5, 1.5},
      {"integral(tanh(t), t, 0, x)", [](double x) { return log(cosh(x)); }, -9, 9},
      {"integral(sinh(t), t, 0, x)", [](double x) { return cosh(x) - 1; }, -4, 4},
      {"integral(ln(t), t, 1, x)", [](double x) { return x * log(x) - x + 1; }, 1e-3, 20},
      {"integral(log(t), t, 1, x)", [](double x) { return (x * log(x) - x + 1) / log(10); }, 1e-3, 20},
      {"integral(log2(t), t, 1, x)", [](double x) { return (x * log(x) - x + 1) / log(2); }, 1e-3, 20},
      {"integral(atan(t), t, 0, x)", [](double x) { return x * std::atan(x) - log(1 + x * x) / 2; }, -5, 5},
      {"integral(asin(t), t, 0, x)", [](double x) { return x * std::asin(x) + sqrt(1 - x * x) - 1; }, -1, 1},
      {"integral(acos(t), t, 0, x)", [](double x) { return x * std::acos(x) - sqrt(1 - x * x) + 1; }, -1, 1},
      {"integral(asinh(t), t, 0, x)", [](double x) { return x * std::asinh(x) - sqrt(1 + x * x) + 1; }, -5,
       5},
      {"integral(acosh(t), t, 1, x)", [](double x) { return x * std::acosh(x) - sqrt(x * x - 1); }, 1, 9},
      {"integral(atanh(t), t, 0, x)", [](double x) { return x * std::atanh(x) + log(1 - x * x) / 2; }, -0.99,
       0.99},
      {"integral(erf(t), t, 0, x)",
       [](double x) { return x * std::erf(x) + (exp(-x * x) - 1) / sqrt(std::numbers::pi); }, -4, 4},
      {"integral(2^t, t, 0, x)", [](double x) { return (std::exp2(x) - 1) / log(2); }, -8, 8},
      {"integral(t^2.5, t, 0, x)", [](double x) { return std::pow(x, 3.5) / 3.5; }, 0, 6},
      {"integral(t^(-3), t, 1, x)", [](double x) { return (1 - 1 / (x * x)) / 2; }, 0.01, 30},
      {"integral(t^t*(1+ln(t)), t, 1, x)", [](double x) { return std::pow(x, x) - 1; }, 0.1, 4},
      {"integral(atan2(t, 2), t, 0, x)", [](double x) { return x * std::atan2(x, 2) - log(1 + x * x / 4); },
       -5, 5},
      {"integral(atan2(t, -1), t, -1, x)",
       [](double x) {
         const auto part = [](double u) {
           return u * (std::numbers::pi - std::atan(u)) + log(1 + u * u) / 2;
         };
         return part(abs(x)) - part(1);
       },
       -3, 3},
      {"integral(|t|/t, t, -1, x)", [](double x) { return abs(x) - 1; }, -3, 3},
      {"integral((t^2-1)/(t-1), t, 0, x)", [](double x) { return x * x / 2 + x; }, -3, 3},
      {"integral((1-cos(2t))/t, t, 0, x) - integral((1-cos(t))/t, t, 0, 2x)", [](double) { return 0.0; }, -9,
       9},
      {"integral(cos(t), t, x, x+1)", [](double x) { return sin(x + 1) - sin(x); }, -9, 9},
      {"integral(cos(t), t, x^2, 0)", [](double x) { return -sin(x * x); }, -4, 4},
      {"integral(integral(cos(s), s, 0, t), t, 0, x)", [](double x) { return 1 - cos(x); }, -9, 9},
      {"x integral(t, t, 0, 2)", [](double x) { return 2 * x; }, -9, 9},
  };
  return all;
}

std::string with_variables(const std::string& text) {
  std::string r = text;  // s is no variable: the inner integral runs over r
  const auto swap_in = [&r](const std::string& a, const std::string& b) {
    for (std::size_t i = r.find(a); i != std::string::npos; i = r.find(a, i)) r.replace(i, a.size(), b);
  };
  swap_in("cos(s), s", "cos(r), r");
  return r;
}

TEST(Integral, EqualsItsClosedForm) {
  for (const Known& k : table()) {
    const Tape tape = tape_of(with_variables(k.text));
    for (int i = 0; i <= 200; ++i) {
      const double x = k.from + (k.to - k.from) * i / 200;
      const double wanted = k.closed(x);
      ASSERT_NEAR(value(tape, x), wanted, 2e-13 * (1 + std::abs(wanted))) << k.text << " at " << x;
    }
  }
}

TEST(Integral, EnclosuresContainTheValueAndAreNarrowAtAPlace) {
  std::mt19937 random(20'261'127);
  for (const Known& k : table()) {
    const Tape tape = tape_of(with_variables(k.text));
    std::uniform_real_distribution<double> place(k.from, k.to);
    for (int i = 0; i < 200; ++i) {
      const double x = place(random);
      const double wanted = k.closed(x);
      // The closed form is itself rounded.
      const double slack = 1e-13 * (1 + std::abs(wanted));
      const Interval at = value(tape, Interval(x));
      ASSERT_EQ(at.decoration, Decoration::continuous) << k.text << " at " << x;
      ASSERT_LE(at.lower, wanted + slack) << k.text << " at " << x;
      ASSERT_GE(at.upper, wanted - slack) << k.text << " at " << x;
      ASSERT_LE(at.width(), 1e-11 * (1 + std::abs(wanted))) << k.text << " at " << x;
      const double reach = (k.to - k.from) * std::exp2(-(i % 30));
      const Interval box(std::max(k.from, x - reach), std::min(k.to, x + reach));
      const Interval over = value(tape, box);
      for (int j = 0; j <= 10; ++j) {
        const double v = k.closed(std::min(box.upper, box.lower + box.width() * j / 10));
        ASSERT_LE(over.lower, v + 1e-13 * (1 + std::abs(v)))
            << k.text << " over " << box.lower << ", " << box.upper;
        ASSERT_GE(over.upper, v - 1e-13 * (1 + std::abs(v)))
            << k.text << " over " << box.lower << ", " << box.upper;
      }
    }
  }
}

TEST(Integral, SlopesAreTheFunctionUnderIt) {
  const Tape tape = tape_of("integral(e^t, t, x^2, 3x)");
  for (const double x : {-1.5, -0.3, 0.2, 1.7}) {
    const double wanted = 3 * std::exp(3 * x) - 2 * x * std::exp(x * x);
    const auto d = value(tape, Dual<double, 1>(x, 0));
    EXPECT_NEAR(d.slopes[0], wanted, 1e-13 * std::abs(wanted));
    const auto box = value(tape, Dual<Interval, 1>(Interval(x), 0));
    EXPECT_LE(box.slopes[0].lower, wanted + 1e-12);
    EXPECT_GE(box.slopes[0].upper, wanted - 1e-12);
  }
}

// Whatever the ends are, an enclosure is a range or empty, and a value lies in it.
TEST(Integral, HasBoundsThatAreNumbersForAllEnds) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  std::mt19937 random(20'261'128);
  const auto any = [&random] {
    switch (random() % 6) {
      case 0:
        return 0.0;
      case 1:
        return random() % 2 == 0 ? kInfinite : -kInfinite;
      case 2:
        return std::numeric_limits<double>::denorm_min();
      case 3:
        return std::ldexp(1.0, static_cast<int>(random() % 26) - 20);
      default:
        return std::uniform_real_distribution<double>(-20, 20)(random);
    }
  };
  for (const char* integrand :
       {"1/t", "sin(t)/t", "tan(t)", "e^(t^2)", "ln(t)", "floor(t)", "1/t^2", "gamma(t)", "sqrt(1-t^2)",
        "{t < 0: 1/t, t > 1: t}", "t^t", "acosh(t)", "0/t", "e^(1/t)"}) {
    const Expression e = read(fmt::format("integral({}, t, y, x)", integrand));
    const Tape tape = Tape::compile(std::array{e}, std::array{Variable::x, Variable::y});
    for (int i = 0; i < 100; ++i) {
      const std::array ends{any(), any(), any(), any()};
      const Interval to(std::min(ends[0], ends[1]), std::max(ends[0], ends[1]));
      const Interval from(std::min(ends[2], ends[3]), std::max(ends[2], ends[3]));
      const auto d =
          tape.evaluate_one<Dual<Interval, 1>>(std::array{Dual<Interval, 1>(to, 0), Dual<Interval, 1>(from)});
      ASSERT_FALSE(std::isnan(d.value.lower) || std::isnan(d.value.upper)) << integrand;
      ASSERT_FALSE(std::isnan(d.slopes[0].lower) || std::isnan(d.slopes[0].upper)) << integrand;
      const double v = tape.evaluate_one<double>(std::array{to.lower, from.upper});
      if (std::isnan(v)) continue;
      ASSERT_LE(d.value.lower, v + 1e-9 * std::abs(v)) << integrand << ' ' << from.upper << ' ' << to.lower;
      ASSERT_GE(d.value.upper, v - 1e-9 * std::abs(v)) << integrand << ' ' << from.upper << ' ' << to.lower;
    }
  }
}

struct Published {
  const char* text;
  double value;
};

// Abramowitz and Stegun, tables 5.1 and 7.7 (Si and the Fresnel integrals), with the further digits and the
// other values of mpmath 1.2 at 25 digits.
TEST(Integral, EqualsPublishedValues) {
  for (const Published& p : std::vector<Published>{
           {"integral(sin(t)/t, t, 0, 1)", 0.9460830703671830},
           {"integral(sin(t)/t, t, 0, 10)", 1.658347594218874},
           {"integral(sin(t)/t, t, -10, 0)", 1.658347594218874},
           {"integral((e^t-1)/t, t, 0, 1)", 1.317902151454404},
           {"integral((1-cos(t))/t^2, t, 0, 1)", 0.4863853762353227},
           {"integral(cos(pi t^2/2), t, 0, 1)", 0.7798934003768228},
           {"integral(sin(pi t^2/2), t, 0, 1)", 0.4382591473903548},
           {"integral(sin(pi t^2/2), t, 0, 5)", 0.4991913819171169},
           {"integral(1/ln(t), t, 2, 10)", 5.120435724669805},
           {"integral(t^t, t, 1, 2)", 2.0504462345347313},
       }) {
    const double v = constant_value(read(p.text));
    EXPECT_NEAR(v, p.value, 2e-13) << p.text;
  }
  // Of gamma only two derivatives are enclosed.
  EXPECT_NEAR(constant_value(read("integral(gamma(t), t, 1, 2)")), 0.922745950680631, 1e-12);
}

TEST(Integral, IsUndefinedAcrossAPoleAndWhereTheFunctionEnds) {
  const Tape log = tape_of("integral(1/t, t, 1, x)");
  EXPECT_TRUE(std::isnan(value(log, -1.0)));
  EXPECT_TRUE(std::isnan(value(log, 0.0)));
  EXPECT_TRUE(value(log, Interval(-3, -1)).is_empty());
  EXPECT_EQ(value(log, Interval(-1, 1)).decoration, Decoration::partial);
  const Tape below = tape_of("integral(1/t, t, -1, x)");
  EXPECT_NEAR(value(below, -2.0), std::log(2), 1e-14);
  EXPECT_TRUE(std::isnan(value(below, 1.0)));
  const Tape root = tape_of("integral(sqrt(t), t, 1, x)");
  EXPECT_TRUE(std::isnan(value(root, -0.5)));
  EXPECT_NEAR(value(root, 0.0), -2.0 / 3, 1e-14);
  // It has a limit there, but no bounded function under it.
  EXPECT_TRUE(std::isnan(constant_value(read("integral(1/sqrt(t), t, 0, 1)"))));
  EXPECT_TRUE(std::isnan(constant_value(read("integral(tan(t), t, 0, 3)"))));
}

std::string written(const char* text) {
  const auto plot = parse(text);
  return plot ? canonical(*plot) : "";
}

TEST(Integral, IsReadInEachOfItsForms) {
  const std::string text = "y = integral(t^2, t, 0, x)";
  for (const char* form : {"integral(t^2, t, 0, x)", "∫_0^x t^2 dt", "∫_0^x t^2dt", "int_0^x(t^2)dt",
                           "∫_{0}^{x} t² dt", "y = integral(t^2; t; 0; x)", "INTEGRAL(t^2,t,0,x)"}) {
    EXPECT_EQ(written(form), text) << form;
  }
  EXPECT_EQ(written("f(x) = x^2; y = integral(f, 0, x)"), "f(x) = x^2; y = integral(x^2, x, 0, x)");
  EXPECT_EQ(written("f(x) = x^2; y = integral(f', 0, x) + 1"), "f(x) = x^2; y = integral(2*x, x, 0, x) + 1");
  EXPECT_EQ(written("y = 2∫_-1^{2x} sin t dt + 1"), "y = 2*integral(sin(t), t, -1, 2*x) + 1");
  EXPECT_EQ(written("y = ∫_0^x ∫_0^t cos(r) dr dt"), "y = integral(integral(cos(r), r, 0, t), t, 0, x)");
  EXPECT_EQ(written("r = ∫_0^θ θ dθ"), "r = integral(theta, theta, 0, theta); 0 <= theta <= 2*pi");
  // Its commas separate also between two digits.
  EXPECT_EQ(written("y = integral(t,t,0,1)"), "y = integral(t, t, 0, 1)");
  EXPECT_EQ(written("y = ∫_0^x dt"), "y = integral(1, t, 0, x)");
}

TEST(Integral, RefusesWhatIsNoIntegralWithTheColumn) {
  struct Refused {
    const char* text;
    int column;
    SyntaxFault fault;
  };
  for (const Refused& r : std::vector<Refused>{
           {"integral(t^2)", 13, SyntaxFault::integral_form},
           {"integral(t^2, 0, x)", 15, SyntaxFault::integral_form},
           {"integral t", 10, SyntaxFault::integral_form},
           {"y = ∫ t dt", 7, SyntaxFault::integral_form},
           {"y = ∫_0^x t", 12, SyntaxFault::integral_form},
           {"y = integral(t x, t, 0, 1)", 5, SyntaxFault::other_variable_in_integral},
           {"y = integral(t, t, 0, )", 23, SyntaxFault::operand_missing},
           {"y = integral(t, t, 0, 1, 2)", 24, SyntaxFault::bracket_open},
           {"y = ∫_0^x ∫_0^t cos(r) dt dt", 11, SyntaxFault::other_variable_in_integral},
       }) {
    const auto plot = parse(r.text);
    ASSERT_FALSE(plot) << r.text;
    EXPECT_EQ(plot.error().fault, r.fault) << r.text;
    EXPECT_EQ(plot.error().column, r.column) << r.text;
  }
}

}  // namespace
}  // namespace nazori::functions
