// SPDX-License-Identifier: Apache-2.0
// Braille against published examples: the numbers are the sections of the Nemeth Code (1972 revision) and of
// the Guidelines for Technical Material of Unified English Braille (2014), with BANA's guidance of 2019.
#include <gtest/gtest.h>

#include <string>

#include "nazori/functions/braille.h"

namespace nazori::functions {
namespace {

std::string braille(const std::string& text, BrailleCode code) {
  const auto plot = parse(text);
  EXPECT_TRUE(plot) << text;
  return plot ? in_braille(*plot, code) : "";
}

/// The right side only: the examples are expressions.
std::string expression(const std::string& text, BrailleCode code) {
  const auto plot = parse(text + "; a = 3; b = 4; c = 5; d = 6; n = 7; m = 8; p = 9; q = 2; i = 1; k = 1");
  EXPECT_TRUE(plot) << text;
  return plot ? in_braille(plot->statements[0].terms[0], code) : "";
}

struct Example {
  const char* section;
  const char* typed;
  const char* cells;
};

TEST(Nemeth, WritesThePublishedExpressions) {
  const Example examples[] = {
      {"9 a", "27", "⠼⠆⠶"},
      {"9 a", "sin 1", "⠎⠊⠝⠀⠼⠂"},
      {"9 a", "-1", "⠤⠼⠂"},
      {"62 a", "(a + b)/c", "⠹⠁⠬⠃⠌⠉⠼"},
      {"66", "(3/8)/5", "⠠⠹⠹⠒⠌⠦⠼⠠⠌⠢⠠⠼"},
      {"67", "a/b^((3/4)/(5/6))", "⠹⠁⠌⠃⠘⠠⠹⠹⠒⠌⠲⠼⠠⠌⠹⠢⠌⠖⠼⠠⠼⠐⠼"},
      {"74 b", "n^x^y", "⠝⠘⠭⠘⠘⠽"},
      {"77", "log_2 x", "⠇⠕⠛⠆⠀⠭"},
      {"79 a", "e^(x^2)/2", "⠹⠑⠘⠭⠘⠘⠆⠐⠌⠆⠼"},
      {"79 d", "cos^2 x", "⠉⠕⠎⠘⠆⠀⠭"},
      {"79 d", "e^(cos^2 x)", "⠑⠘⠉⠕⠎⠘⠘⠆⠀⠭"},
      {"80 a", "sqrt(x^2 + y^2)", "⠜⠭⠘⠆⠐⠬⠽⠘⠆⠐⠻"},
      {"80 a", "e^sqrt(x^2 + y^2)", "⠑⠘⠜⠭⠘⠘⠆⠘⠬⠽⠘⠘⠆⠘⠻"},
      {"103 a", "sqrt(x + y)", "⠜⠭⠬⠽⠻"},
      {"104", "cbrt(2)", "⠣⠒⠜⠆⠻"},
      {"104", "root(m + n; p + q)", "⠣⠍⠬⠝⠜⠏⠬⠟⠻"},
      {"105", "sqrt(x + sqrt(x + y) + a)", "⠜⠭⠬⠨⠜⠭⠬⠽⠨⠻⠬⠁⠻"},
      {"105", "sqrt(x + sqrt(y + sqrt(a)))", "⠜⠭⠬⠨⠜⠽⠬⠨⠨⠜⠁⠨⠨⠻⠨⠻⠻"},
      {"119 c", "sin(30°) + cos(45°)", "⠎⠊⠝⠀⠼⠒⠴⠘⠨⠡⠐⠬⠉⠕⠎⠀⠼⠲⠢⠘⠨⠡"},
      {"134, lesson 5.2", "10 + -5", "⠼⠂⠴⠬⠐⠤⠢"},
      {"134, lesson 5.2", "10 - -5", "⠼⠂⠴⠤⠐⠤⠢"},
  };
  for (const Example& e : examples)
    EXPECT_EQ(expression(e.typed, BrailleCode::nemeth), e.cells)
        << "section " << e.section << ": " << e.typed;
}

TEST(Nemeth, WritesThePublishedStatements) {
  const Example examples[] = {
      {"9 a", "y = 2 sin x", "⠽⠀⠨⠅⠀⠼⠆⠎⠊⠝⠀⠭"},
      {"79 g", "2^x < 3^x", "⠼⠆⠘⠭⠀⠐⠅⠀⠼⠒⠘⠭"},
      {"11 a", "(1, 2)", "⠷⠂⠠⠀⠆⠾"},
      {"11 a", "(-1, -2)", "⠷⠤⠂⠠⠀⠤⠆⠾"},
  };
  for (const Example& e : examples)
    EXPECT_EQ(braille(e.typed, BrailleCode::nemeth), e.cells) << "section " << e.section << ": " << e.typed;
}

TEST(Ueb, WritesThePublishedExpressionsInAPassageOfGradeOne) {
  const Example examples[] = {
      {"1.7.3", "3x - 4y + y^2 = x^2", "⠰⠰⠰⠼⠉⠭⠐⠤⠼⠙⠽⠐⠖⠽⠔⠼⠃⠀⠐⠶⠀⠭⠔⠼⠃⠰⠄"},
      {"6.4", "y = x/2", "⠰⠰⠰⠽⠀⠐⠶⠀⠷⠭⠨⠌⠼⠃⠾⠰⠄"},
      {"1.7.3", "(x^2 + 2x)/(1 + x^2) = 1 + y", "⠰⠰⠰⠷⠭⠔⠼⠃⠐⠖⠼⠃⠭⠨⠌⠼⠁⠐⠖⠭⠔⠼⠃⠾⠀⠐⠶⠀⠼⠁⠐⠖⠽⠰⠄"},
  };
  for (const Example& e : examples)
    EXPECT_EQ(braille(e.typed, BrailleCode::ueb), e.cells) << "section " << e.section << ": " << e.typed;
  EXPECT_EQ(expression("5/8", BrailleCode::ueb), "⠰⠰⠰⠼⠑⠌⠓⠰⠄");            // 6.1
  EXPECT_EQ(expression("x^(n + m)", BrailleCode::ueb), "⠰⠰⠰⠭⠔⠣⠝⠐⠖⠍⠜⠰⠄");  // BANA 5.4
  EXPECT_EQ(expression("sqrt(y - x^2)", BrailleCode::ueb), "⠰⠰⠰⠩⠽⠐⠤⠭⠔⠼⠃⠬⠰⠄");
  // A letter from a to j behind a digit (1.7.2).
  EXPECT_EQ(expression("4c", BrailleCode::ueb), "⠰⠰⠰⠼⠙⠰⠉⠰⠄");
  EXPECT_EQ(expression("0.7", BrailleCode::ueb), "⠰⠰⠰⠼⠚⠲⠛⠰⠄");  // 2.2
}

TEST(Nemeth, KeepsDifferentTreesApart) {
  const auto cells = [](const char* text) { return expression(text, BrailleCode::nemeth); };
  EXPECT_NE(cells("sin(x)^2"), cells("sin(x^2)"));
  EXPECT_NE(cells("sin(x) y"), cells("sin(x y)"));
  EXPECT_NE(cells("sin(2x)"), cells("sin(2)x"));
  EXPECT_NE(cells("(x + 1)/2"), cells("x + 1/2"));
  EXPECT_NE(cells("x^(y + 1)"), cells("x^y + 1"));
  EXPECT_NE(cells("2^x 3"), cells("2^(3x)"));
  EXPECT_NE(cells("x*2"), cells("x + 2"));
  EXPECT_EQ(cells("x*2"), "⠭⠡⠆");
  EXPECT_EQ(cells("sin(x) y"), "⠎⠊⠝⠀⠷⠭⠾⠽");
  EXPECT_EQ(cells("|x| + floor(x) + ceil(x) + x!"), "⠳⠭⠳⠬⠈⠰⠷⠭⠈⠰⠾⠬⠈⠘⠷⠭⠈⠘⠾⠬⠭⠯");
}

TEST(Nemeth, ASpaceFollowsTheNameOfAFunction) {
  const auto cells = [](const char* text) { return expression(text, BrailleCode::nemeth); };
  // § 119: also before a parenthesis.
  EXPECT_EQ(cells("max(x, y)"), "⠍⠁⠭⠀⠷⠭⠠⠀⠽⠾");
  EXPECT_EQ(cells("max(x, y) + 1"), "⠍⠁⠭⠀⠷⠭⠠⠀⠽⠾⠬⠂");
  EXPECT_EQ(expression("max(x, y)", BrailleCode::ueb), "⠰⠰⠰⠍⠁⠭⠐⠣⠭⠂⠀⠽⠐⠜⠰⠄");
}

TEST(Nemeth, WritesConditionsCasesAndParameters) {
  EXPECT_EQ(braille("y = x^2 {0<=x<=2}", BrailleCode::nemeth), "⠽⠀⠨⠅⠀⠭⠘⠆⠀⠨⠷⠴⠀⠐⠅⠱⠀⠭⠀⠐⠅⠱⠀⠼⠆⠨⠾");
  EXPECT_EQ(braille("y = {x<0: -x, x}", BrailleCode::nemeth), "⠽⠀⠨⠅⠀⠨⠷⠭⠀⠐⠅⠀⠼⠴⠸⠒⠀⠤⠭⠠⠀⠭⠨⠾");
  EXPECT_EQ(braille("f(x) = a x; a = 2", BrailleCode::nemeth), "⠋⠷⠭⠾⠀⠨⠅⠀⠁⠭\n⠁⠀⠨⠅⠀⠼⠆");
  EXPECT_EQ(braille("x = cos t; y = t; 0 <= t < pi", BrailleCode::nemeth),
            "⠭⠀⠨⠅⠀⠉⠕⠎⠀⠞⠠⠀⠽⠀⠨⠅⠀⠞⠠⠀⠼⠴⠀⠐⠅⠱⠀⠞⠀⠐⠅⠀⠨⠏");
  EXPECT_EQ(braille("y > x and y < 2", BrailleCode::nemeth), "⠽⠀⠨⠂⠀⠭⠀⠁⠝⠙⠀⠽⠀⠐⠅⠀⠼⠆");
}

TEST(Braille, HasOnlyCellsOfSixDots) {
  for (const char* text : {"y = sin(x)^2/(x+1) {x>0 or x<-1}", "z = max(x, y)! - gamma(x)", "r = 2theta^3",
                           "y = log_b(x+1, 3) + root(4, x) - 1.5e^-x"}) {
    for (const BrailleCode code : {BrailleCode::nemeth, BrailleCode::ueb}) {
      const std::string cells = braille(text, code);
      ASSERT_EQ(cells.size() % 3, 0U) << text;
      for (std::size_t i = 0; i < cells.size(); i += 3) {
        EXPECT_EQ(static_cast<unsigned char>(cells[i]), 0xE2) << text;
        EXPECT_EQ(static_cast<unsigned char>(cells[i + 1]), 0xA0) << text << " " << cells.substr(i, 3);
      }
    }
  }
}

}  // namespace
}  // namespace nazori::functions
