// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <utility>

#include "nazori/functions/syntax_error.h"

namespace nazori::functions {
namespace {

SyntaxWords english(const SyntaxError& e) {
  const std::string quoted = "\"" + e.subject + "\"";
  switch (e.fault) {
    case SyntaxFault::no_expression:
      return {"there is no expression", "expected something like y = sin(x)"};
    case SyntaxFault::operand_missing:
      return {"something is missing after " + quoted, "expected a number, a variable, a function or \"(\""};
    case SyntaxFault::not_an_operand:
      return {quoted + " is not allowed here", "expected a number, a variable, a function or \"(\""};
    case SyntaxFault::does_not_fit:
      return {quoted + " does not fit here", "expected an operator, \"=\", \";\" or the end"};
    case SyntaxFault::no_operator:
      return {quoted + " does not fit here", "expected an operator between two numbers"};
    case SyntaxFault::nested_too_deep:
      return {"parentheses or functions are nested too deep", "expected a simpler expression"};
    case SyntaxFault::bar_open:
      return {fmt::format("the bar opened in column {} is not closed", e.number), "expected \"|\""};
    case SyntaxFault::bracket_open:
      return {fmt::format("the {} in column {} is not closed", quoted, e.number),
              "expected \"" + e.closing + "\""};
    case SyntaxFault::argument_missing:
      return {"the argument of " + quoted + " is missing", "expected \"(\" or an operand"};
    case SyntaxFault::argument_count:
      return {fmt::format("{} has {} argument{}", quoted, e.number, e.number == 1 ? "" : "s"),
              e.wanted == 1   ? "expected one argument"
              : e.wanted == 2 ? "expected two arguments"
                              : "expected two arguments or more"};
    case SyntaxFault::unknown_character:
      return {"the character " + quoted + " is not allowed here",
              "expected a number, a variable, a function or an operator"};
    case SyntaxFault::two_decimal_signs:
      return {"a number has two decimal points", "expected a digit or an operator"};
    case SyntaxFault::number_too_large:
      return {"the number " + quoted + " is too large", "expected a number up to 1.7e308"};
    case SyntaxFault::raised_digit_missing:
      return {"a superscript digit is missing", "expected one of ⁰ to ⁹"};
    case SyntaxFault::unknown_function:
      return {"unknown function " + quoted, "expected a function such as sin, ln, sqrt, floor or gamma"};
    case SyntaxFault::unknown_name:
      return {"unknown name " + quoted, "expected x, y, t, r, theta, pi, e or a function"};
    case SyntaxFault::too_long:
      return {"the text is longer than 10000 bytes", "expected a shorter expression"};
    case SyntaxFault::not_utf8:
      return {"the text is not valid UTF-8", "expected UTF-8"};
    case SyntaxFault::surface_not_alone:
      return {"a surface z = f(x, y) must be the only expression", "expected only the surface"};
    case SyntaxFault::too_many_statements:
      return {"there are more than 32 expressions", "expected fewer"};
    case SyntaxFault::range_empty:
      return {"the range of the parameter is empty or unbounded",
              "expected a smaller number before a larger one"};
    case SyntaxFault::range_misplaced:
      return {"write a range after its curve", "expected x = ...; y = ...; range, or r = ...; range"};
    case SyntaxFault::parameter_alone:
      return {"t needs x and y to be given together", "expected x = f(t); y = g(t); a <= t <= b"};
    case SyntaxFault::polar_mixed:
      return {"r and theta cannot be mixed with " + e.subject, "expected only r and theta, or only x and y"};
    case SyntaxFault::nothing_equal:
      return {"the equation has only one side", "expected r = f(theta)"};
    case SyntaxFault::height_misplaced:
      return {"z can only appear alone on one side", "expected z = f(x, y)"};
  }
  return {};
}

SyntaxWords japanese(const SyntaxError& e) {
  const std::string quoted = "「" + e.subject + "」";
  switch (e.fault) {
    case SyntaxFault::no_expression:
      return {"式がありません", "y = sin(x) のように書いてください"};
    case SyntaxFault::operand_missing:
      return {quoted + "の後に数や文字がありません", "数、変数、関数、または「(」が必要です"};
    case SyntaxFault::not_an_operand:
      return {"数や文字があるべき所に" + quoted + "があります", "数、変数、関数、または「(」が必要です"};
    case SyntaxFault::does_not_fit:
      return {quoted + "はここに置けません", "演算記号、「=」、「;」、または式の終わりが必要です"};
    case SyntaxFault::no_operator:
      return {quoted + "はここに置けません", "2つの数の間に演算記号が必要です"};
    case SyntaxFault::nested_too_deep:
      return {"括弧や関数の重なりが深すぎます", "もっと簡単な式にしてください"};
    case SyntaxFault::bar_open:
      return {fmt::format("{}文字目の絶対値記号が閉じていません", e.number), "「|」が必要です"};
    case SyntaxFault::bracket_open:
      return {fmt::format("{}文字目の{}が閉じていません", e.number, quoted),
              "「" + e.closing + "」が必要です"};
    case SyntaxFault::argument_missing:
      return {quoted + "の引数がありません", "「(」、数、または文字が必要です"};
    case SyntaxFault::argument_count:
      return {fmt::format("{}の引数が{}個です", quoted, e.number),
              e.wanted < 0 ? fmt::format("{} 個以上の引数が必要です", -e.wanted)
                           : fmt::format("{} 個の引数が必要です", e.wanted)};
    case SyntaxFault::unknown_character:
      return {"文字" + quoted + "はここでは使えません", "数、変数、関数、または演算記号が必要です"};
    case SyntaxFault::two_decimal_signs:
      return {"1つの数に小数点が2つあります", "数字または演算記号が必要です"};
    case SyntaxFault::number_too_large:
      return {"数" + quoted + "は大きすぎます", "1.7e308 までの数にしてください"};
    case SyntaxFault::raised_digit_missing:
      return {"上付きの数字がありません", "⁰ から ⁹ のどれかが必要です"};
    case SyntaxFault::unknown_function:
      return {quoted + "という関数はありません", "sin、ln、sqrt、floor、gamma などの関数が必要です"};
    case SyntaxFault::unknown_name:
      return {quoted + "という名前はありません", "x、y、t、r、theta、pi、e、または関数が必要です"};
    case SyntaxFault::too_long:
      return {"式が 10000 バイトを超えています", "もっと短い式にしてください"};
    case SyntaxFault::not_utf8:
      return {"文字が正しい UTF-8 ではありません", "UTF-8 が必要です"};
    case SyntaxFault::surface_not_alone:
      return {"曲面 z = f(x, y) はほかの式と並べられません", "曲面のときは式を1つだけにしてください"};
    case SyntaxFault::too_many_statements:
      return {"式が 32 個を超えています", "式を減らしてください"};
    case SyntaxFault::range_empty:
      return {"媒介変数の範囲が空か、上限・下限がありません", "小さい数を先に、大きい数を後に書いてください"};
    case SyntaxFault::range_misplaced:
      return {"範囲はその曲線の後に書きます", "「x = …; y = …; 範囲」か「r = …; 範囲」にしてください"};
    case SyntaxFault::parameter_alone:
      return {"t を使うときは x と y を両方書きます", "「x = f(t); y = g(t); a <= t <= b」にしてください"};
    case SyntaxFault::polar_mixed:
      return {"r と theta は " + e.subject + " と混ぜられません",
              "r と theta だけ、または x と y だけにしてください"};
    case SyntaxFault::nothing_equal:
      return {"等式の片側がありません", "「r = f(theta)」にしてください"};
    case SyntaxFault::height_misplaced:
      return {"z は片側に単独で書きます", "「z = f(x, y)」にしてください"};
  }
  return {};
}

}  // namespace

SyntaxWords in_words(const SyntaxError& error, Language language) {
  return language == Language::english ? english(error) : japanese(error);
}

base::Error SyntaxError::to_error() const {
  SyntaxWords words = in_words(*this, Language::english);
  return {base::Errc::parse, std::move(words.message), "column " + std::to_string(column),
          std::move(words.expected)};
}

}  // namespace nazori::functions
