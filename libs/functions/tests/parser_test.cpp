// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "nazori/functions/plot.h"
#include "nazori/functions/tape.h"

namespace nazori::functions {
namespace {

using testing::HasSubstr;

struct Reading {
  std::string typed;
  std::string canonical;
};

TEST(Parser, ReadsWhatPeopleType) {
  const Reading readings[] = {
      {"y = 2x", "y = 2*x"},
      {"y = 2sin x", "y = 2*sin(x)"},
      {"y = sin^2 x", "y = sin(x)^2"},
      {"y = sin² x", "y = sin(x)^2"},
      {"y = sin^-1 x", "y = asin(x)"},
      {"y = -x^2", "y = -x^2"},
      {"y = 2^-x", "y = 2^(-x)"},
      {"y = x^2^3", "y = x^(2^3)"},
      {"y = ||x| - 2|", "y = ||x| - 2|"},
      {"y = 1,5x", "y = 1.5*x"},
      {"y = x(x-2)", "y = x*(x - 2)"},
      {"x = 2", "x = 2"},
      {"y = x² − √(x)·π", "y = x^2 - sqrt(x)*pi"},
      {"y = 1/2x", "y = (1/2)*x"},
      {"y = e^-x^2", "y = e^(-x^2)"},
      {"y = sin 2x", "y = sin(2*x)"},
      {"sin(x)", "y = sin(x)"},
      {"y = sin x cos x", "y = sin(x)*cos(x)"},
      {"y = sqrt x + 1", "y = sqrt(x) + 1"},
      {"y = xsinx", "y = x*sin(x)"},
      {"xy = 1", "x*y = 1"},
      {"y = 2e3", "y = 2*e*3"},
      {"y = min(1, x)", "y = min(1, x)"},
      {"y = max(1,2)", "y = max(1, 2)"},
      {"y = 2|x|", "y = 2*|x|"},
      {"y = log_2 x", "y = log_b(2, x)"},
      {"y = x!", "y = x!"},
      {"ｙ＝２ｘ", "y = 2*x"},
      {"y(x) = x", "y = x"},
      {"1 < x^2 + y^2 ≤ 4", "1 < x^2 + y^2 <= 4"},
      {"r = 1 + cos θ", "r = 1 + cos(theta); 0 <= theta <= 2*pi"},
      {"x = cos(t); y = sin(t); 0 <= t <= pi", "x = cos(t); y = sin(t); 0 <= t <= pi"},
      {"y = x; y = 2x;", "y = x; y = 2*x"},
      {"z = x y", "z = x*y"},
  };
  for (const Reading& r : readings) {
    const auto plot = parse(r.typed);
    ASSERT_TRUE(plot) << r.typed << ": " << plot.error().to_error().what;
    EXPECT_EQ(canonical(*plot), r.canonical) << r.typed;
  }
}

TEST(Parser, ReadsItsOwnCanonicalTextBack) {
  for (const char* typed :
       {"y = -x^2", "y = 1/2x", "y = 2^-x", "x^2 + y^2 = 1", "y = |x - |x||", "y = (x+1)/(x-1)",
        "y = x - (1 - x)", "y = (x^2)^3", "y = -(-x)", "y = 999999999999999999999999x",
        "y = 0.000000000000000000025x", "y = e^(1/x)", "r^2 = cos(2theta)"}) {
    const auto plot = parse(typed);
    ASSERT_TRUE(plot) << typed;
    const auto again = parse(canonical(*plot));
    ASSERT_TRUE(again) << canonical(*plot) << ": " << again.error().to_error().what;
    EXPECT_EQ(canonical(*again), canonical(*plot));
  }
}

double at(const std::string& text, double x) {
  const auto plot = parse(text);
  EXPECT_TRUE(plot) << text;
  if (!plot) return std::nan("");
  const Tape tape = Tape::compile(std::span(plot->statements[0].terms).first(1), std::array{Variable::x});
  return tape.evaluate_one<double>(std::array{x});
}

TEST(Parser, FollowsTheConventionsOfSchool) {
  EXPECT_DOUBLE_EQ(at("y = -2^2", 0), -4);
  EXPECT_DOUBLE_EQ(at("y = 2^3^2", 0), 512);
  EXPECT_DOUBLE_EQ(at("y = 1/2x", 4), 2);
  EXPECT_DOUBLE_EQ(at("y = log(1000)", 0), 3);
  EXPECT_DOUBLE_EQ(at("y = ln e", 0), 1);
  EXPECT_DOUBLE_EQ(at("y = x^(2/3)", -8), 4);
  EXPECT_DOUBLE_EQ(at("y = cbrt(x)", -27), -3);
  EXPECT_TRUE(std::isnan(at("y = sqrt(x)", -1)));
  EXPECT_TRUE(std::isnan(at("y = 1/x", 0)));
  EXPECT_DOUBLE_EQ(at("y = 5!", 0), 120);
  EXPECT_DOUBLE_EQ(at("y = mod(x, 3)", 7), 1);
}

struct Mistake {
  std::string typed;
  int column;
  std::string message;
};

TEST(Parser, NamesTheColumnAndWhatWasExpected) {
  const Mistake mistakes[] = {
      {"y = 2 +", 8, "missing after \"+\""},
      {"y = foo(x)", 5, "unknown function \"foo\""},
      {"y = (x+1", 9, "not closed"},
      {"y = |x", 7, "not closed"},
      {"", 1, "no expression"},
      {"y = 2 3", 7, "does not fit"},
      {"y = x)", 6, "does not fit"},
      {"y = sin", 8, "argument of \"sin\" is missing"},
      {"y = 1.2.3", 8, "two decimal points"},
      {"y = mod(x)", 5, "1 argument"},
      {"y = x $ 2", 7, "is not allowed here"},
      {"0 <= t <= 1", 1, "write a range after its curve"},
      {"y = t", 1, "t needs x and y"},
      {"z = x; y = x", 1, "must be the only expression"},
      {"\xff", 1, "UTF-8"},
  };
  for (const Mistake& m : mistakes) {
    const auto plot = parse(m.typed);
    ASSERT_FALSE(plot) << m.typed;
    EXPECT_EQ(plot.error().column, m.column) << m.typed;
    const SyntaxWords words = in_words(plot.error(), Language::english);
    EXPECT_THAT(words.message, HasSubstr(m.message));
    EXPECT_THAT(words.expected, HasSubstr("expected"));
  }
}

TEST(Parser, TellsEveryMistakeInJapaneseToo) {
  const std::pair<std::string, std::string> mistakes[] = {
      {"y = 2 +", "「+」の後に数や文字がありません"},      {"y = foo(x)", "「foo」という関数はありません"},
      {"y = (x+1", "5文字目の「(」が閉じていません"},      {"y = mod(x)", "「mod」の引数が1個です"},
      {"r = x theta", "r と theta は x と混ぜられません"},
  };
  for (const auto& [typed, message] : mistakes) {
    const auto plot = parse(typed);
    ASSERT_FALSE(plot) << typed;
    EXPECT_EQ(in_words(plot.error(), Language::japanese).message, message);
  }
  // Every kind has its own words.
  std::set<std::string> texts;
  for (int fault = 0; fault <= static_cast<int>(SyntaxFault::height_misplaced); ++fault) {
    const SyntaxWords words = in_words({1, static_cast<SyntaxFault>(fault), "x"}, Language::japanese);
    EXPECT_FALSE(words.message.empty()) << fault;
    EXPECT_TRUE(texts.insert(words.message + words.expected).second) << fault;
  }
}

TEST(Parser, ANegativeNumberThatIsRaisedIsHeardAsOne) {
  // Made by superscripts: its own sign must not be taken for that of the power.
  const auto power = binary(NodeKind::power, number(-2), number(4));
  EXPECT_EQ(in_words(power, Language::english), "the quantity minus 2 end quantity to the power of 4");
  EXPECT_EQ(to_text(power), "(-2)^4");
  const auto plot = parse("y = x⁻²");
  ASSERT_TRUE(plot);
  EXPECT_EQ(in_words(*plot, Language::english), "y equals x to the power of minus 2");
}

TEST(Parser, ADeepNestIsAnErrorAndNotTheEndOfTheStack) {
  EXPECT_FALSE(parse("y = " + std::string(3000, '(')));
  EXPECT_FALSE(parse("y = " + std::string(3000, '-') + "x"));
  std::string powers = "y = x";
  for (int i = 0; i < 2000; ++i) powers += "^x";
  EXPECT_FALSE(parse(powers));
}

TEST(Parser, EchoesTheReadingInWords) {
  const auto plot = parse("y = 1/2x");
  ASSERT_TRUE(plot);
  EXPECT_EQ(in_words(*plot, Language::english), "y equals the quantity 1 over 2 end quantity times x");
  EXPECT_EQ(in_words(*plot, Language::japanese), "y イコール 括弧 2 分の 1 括弧閉じ かける x");
  const auto other = parse("y = 1/(2x)");
  ASSERT_TRUE(other);
  EXPECT_EQ(in_words(*other, Language::english),
            "y equals the fraction with numerator 1 and denominator 2 x end fraction");
}

TEST(Parser, KeepsWhichEndsOfARangeAreLeftOut) {
  struct Case {
    const char* range;
    bool from_is_open;
    bool to_is_open;
    const char* canonical;
    const char* english;
  };
  for (const Case& c : {Case{"0 <= t <= 3", false, false, "0 <= t <= 3", "for t from 0 to 3"},
                        Case{"0 <= t < 3", false, true, "0 <= t < 3", "for t from 0 to 3, 3 excluded"},
                        Case{"0 < t <= 3", true, false, "0 < t <= 3", "for t from 0 to 3, 0 excluded"},
                        Case{"3 > t >= 0", false, true, "0 <= t < 3", "for t from 0 to 3, 3 excluded"},
                        Case{"3 >= t > 0", true, false, "0 < t <= 3", "for t from 0 to 3, 0 excluded"},
                        Case{"0 < t < 3", true, true, "0 < t < 3", "for t from 0 to 3, both excluded"}}) {
    const auto plot = parse(std::string("x = t; y = t; ") + c.range);
    ASSERT_TRUE(plot) << c.range;
    EXPECT_EQ(plot->statements[0].from_is_open, c.from_is_open) << c.range;
    EXPECT_EQ(plot->statements[0].to_is_open, c.to_is_open) << c.range;
    EXPECT_EQ(canonical(*plot), std::string("x = t; y = t; ") + c.canonical);
    const std::string words = in_words(*plot, Language::english);
    EXPECT_TRUE(words.ends_with(c.english)) << words;
  }
  const auto japanese = parse("r = 1; 0 < theta < 3");
  ASSERT_TRUE(japanese);
  EXPECT_TRUE(in_words(*japanese, Language::japanese).ends_with("、両端を除く"));
  EXPECT_TRUE(parse("x = t; y = t; 1 <= t <= 1")) << "a single point";
  EXPECT_FALSE(parse("x = t; y = t; 1 <= t < 1")) << "no point at all";
}

TEST(Parser, ReadsRegionsInRAndThetaWithTheirRange) {
  const auto plot = parse("1 < r <= 2; 0 <= theta <= pi/2");
  ASSERT_TRUE(plot);
  ASSERT_EQ(plot->statements.size(), 1U);
  EXPECT_EQ(plot->statements[0].kind, StatementKind::inequality);
  EXPECT_EQ(canonical(*plot), "1 < r <= 2; 0 <= theta <= pi/2");
  const auto again = parse(canonical(*plot));
  ASSERT_TRUE(again);
  EXPECT_EQ(canonical(*again), canonical(*plot));
}

}  // namespace
}  // namespace nazori::functions
