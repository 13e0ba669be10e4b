// SPDX-License-Identifier: Apache-2.0
// Random texts of the words of the grammar: each is read or refused with its column, and what is read is
// written as text that is read back as the same.
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>
#include <string_view>

#include "nazori/functions/plot.h"

namespace nazori::functions {
namespace {

constexpr std::array<std::string_view, 73> kWords{"x",
                                                  "y",
                                                  "z",
                                                  "t",
                                                  "r",
                                                  "theta",
                                                  "2",
                                                  "0.5",
                                                  "1e3",
                                                  "pi",
                                                  "e",
                                                  "a",
                                                  "b",
                                                  "f",
                                                  "f(x)",
                                                  "=",
                                                  "<",
                                                  "<=",
                                                  ">",
                                                  ">=",
                                                  "+",
                                                  "-",
                                                  "*",
                                                  "/",
                                                  "^",
                                                  "(",
                                                  ")",
                                                  "{",
                                                  "}",
                                                  "[",
                                                  "]",
                                                  "|",
                                                  ",",
                                                  ";",
                                                  ":",
                                                  " and ",
                                                  " or ",
                                                  "°",
                                                  "'",
                                                  "!",
                                                  "sin",
                                                  "ln",
                                                  "min",
                                                  "\n",
                                                  "f'(x)",
                                                  "a = 2",
                                                  "0 <= a <= 3",
                                                  "f(x) = x^2",
                                                  "{x<0: -x, x}",
                                                  "{x>0}",
                                                  "(1, 2)",
                                                  "x^2",
                                                  " ",
                                                  "; ",
                                                  "y = ",
                                                  "x = ",
                                                  "0 <= t <= 1",
                                                  "z = ",
                                                  "b = a",
                                                  "floor",
                                                  "≠",
                                                  "r < 1",
                                                  "[1, 2]",
                                                  "[1...4]",
                                                  "[1, 3...9]",
                                                  "...",
                                                  "c = [1, 2, 3]",
                                                  "c",
                                                  "([1, 2], [3, 4])",
                                                  "~",
                                                  "y ~ a x + b",
                                                  "y ~ ",
                                                  "a e^(b x)"};

/// Half of the texts begin as something that can be read, so that the deeper rules are reached.
std::string text(std::mt19937& random) {
  const auto below = [&random](std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
  };
  constexpr std::array<std::string_view, 12> kStarts{"y = x {",
                                                     "y = {x<0: ",
                                                     "f(x) = a x^2; a = 2; ",
                                                     "y > x and ",
                                                     "f(x) = {x<1: x, 2}; y = f'(",
                                                     "(1, 2), ",
                                                     "x^2 + y^2 = 4 {",
                                                     "x = cos(t); y = sin(t) {",
                                                     "c = [1, 2, 3]; y = c",
                                                     "y = [1, 2] x + ",
                                                     "([1, 2, 3], [2, 4, 7]); y ~ ",
                                                     "(1, 2), (2, 3); y ~ a x + "};
  std::string all;
  if (below(2) == 0) all = kStarts[below(kStarts.size())];
  const std::size_t words = 1 + below(4);
  for (std::size_t i = 0; i < words; ++i) all += kWords[below(kWords.size())];
  if (below(3) == 0) all += "}";
  return all;
}

TEST(Grammar, RandomTextsAreRefusedWithWordsOrReadBackTheSame) {
  std::mt19937 random(20'261'125);
  int read = 0;
  for (int i = 0; i < 60'000; ++i) {
    const std::string typed = text(random);
    const auto plot = parse(typed);
    if (!plot) {
      ASSERT_GE(plot.error().column, 1) << typed;
      for (const Language language : {Language::english, Language::japanese}) {
        const SyntaxWords words = in_words(plot.error(), language);
        ASSERT_FALSE(words.message.empty() || words.expected.empty()) << typed;
      }
      continue;
    }
    ++read;
    ASSERT_FALSE(in_words(*plot, Language::english).empty()) << typed;
    const std::string written = canonical(*plot);
    const auto again = parse(written);
    ASSERT_TRUE(again) << typed << "  ->  " << written << ": " << again.error().to_error().what;
    ASSERT_EQ(canonical(*again), written) << typed;
    ASSERT_EQ(in_words(*again, Language::english), in_words(*plot, Language::english)) << typed;
  }
  EXPECT_GT(read, 2'000);
}

}  // namespace
}  // namespace nazori::functions
