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
      return {"a number has two decimal points",
              "expected a digit or an operator, and a space behind a comma between two numbers"};
    case SyntaxFault::number_too_large:
      return {"the number " + quoted + " is too large", "expected a number up to 1.7e308"};
    case SyntaxFault::raised_digit_missing:
      return {"a superscript digit is missing", "expected one of ⁰ to ⁹"};
    case SyntaxFault::unknown_function:
      return {
          "unknown function " + quoted,
          "expected a function such as sin, ln, sqrt, floor or gamma, or a definition such as f(x) = x^2"};
    case SyntaxFault::unknown_name:
      return {"unknown name " + quoted,
              "expected x, y, t, r, theta, pi, e, a function or a letter with a definition such as a = 2"};
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
    case SyntaxFault::condition_alone:
      return {"there is nothing in front of the condition", "expected y = x^2 {0 <= x <= 2}"};
    case SyntaxFault::condition_missing:
      return {"a condition is missing", "expected a comparison such as x < 0"};
    case SyntaxFault::value_missing:
      return {"the value of a case is missing", "expected {condition: value, condition: value}"};
    case SyntaxFault::defined_twice:
      return {quoted + " is defined twice", "expected one definition for each letter"};
    case SyntaxFault::defined_by_itself:
      return {quoted + " is defined by itself", "expected a definition without " + quoted};
    case SyntaxFault::not_a_number:
      return {quoted + " is not a number", "expected a value such as a = 2, or a function f(x) = ..."};
    case SyntaxFault::other_variable:
      return {quoted + " contains " + e.closing, "expected only the variable in its parentheses"};
    case SyntaxFault::other_variable_in_condition:
      return {"the condition contains " + e.subject, "expected x, y and t"};
    case SyntaxFault::outside_its_range:
      return {"the value of " + quoted + " is outside its range", "expected a value inside the range"};
    case SyntaxFault::integral_form:
      return {"an integral is not written like this", "expected integral(t^2, t, 0, x) or ∫_0^x t^2 dt"};
    case SyntaxFault::area_form:
      return {"an area is not written like this",
              "expected functions of x and two different numbers, area(x^2, 0, 2) or area(x^2, x, 0, 1)"};
    case SyntaxFault::other_variable_in_integral:
      return {"the function under the integral contains " + e.closing,
              "expected no variable but " + e.subject};
    case SyntaxFault::no_derivative:
      return {"the derivative of " + quoted + " is not known",
              "expected a function without gamma or factorial"};
    case SyntaxFault::too_many_parts:
      return {"the expression is too large when its functions are written out", "expected a simpler one"};
    case SyntaxFault::two_equations:
      return {"two equations joined by \"and\" have single points in common",
              "write \";\" between them: the points where they cross are listed"};
    case SyntaxFault::choice_in_region:
      return {"\"or\" cannot restrict an inequality",
              "write one inequality for each case, with \"or\" between them"};
    case SyntaxFault::point_not_two_numbers:
      return {"a point consists of two numbers", "expected (1, 2)"};
    case SyntaxFault::model_form:
      return {"a model cannot be read",
              "expected y ~ and an expression in x and letters, such as y ~ a x + b"};
    case SyntaxFault::no_letter:
      return {"the model has no letter to fit", "expected something like y ~ a x + b"};
    case SyntaxFault::too_few_points:
      return {fmt::format("a model with {} letter{} cannot be fitted to {} point{}", e.wanted,
                          e.wanted == 1 ? "" : "s", e.number, e.number == 1 ? "" : "s"),
              fmt::format("expected at least {}, such as (1, 2), (3, 4)", e.wanted)};
    case SyntaxFault::letters_undetermined:
      return {"the points do not determine the letters of the model",
              "expected fewer letters, or points with other x"};
    case SyntaxFault::model_undefined:
      return {"the model has no value at x = " + e.subject, "expected a model with a value at every point"};
    case SyntaxFault::letter_under_integral:
      return {fmt::format("the letter {} cannot be found where it stands under the integral", e.subject),
              "expected it as a factor, as in integral(a t^2, t, 0, x)"};
    case SyntaxFault::fit_not_found:
      return {"no values were found with which the model fits the points", "expected a simpler model"};
    case SyntaxFault::not_equal:
      return {"what should " + quoted + " draw? Points that are not on the curve fill the plane",
              "write y = x for the curve, or y < x or y > x for both sides"};
    case SyntaxFault::list:
      return {"a list contains numbers or expressions, not points",
              "write points as (1, 2), (3, 4), or as ([1, 3], [2, 4])"};
    case SyntaxFault::list_in_list:
      return {"a list cannot contain a list", "expected numbers or expressions, [1, 2, 3]"};
    case SyntaxFault::list_leads_nowhere:
      return {"the numbers of the list do not lead from the first to the last in equal steps",
              "expected something like [1...5] or [1, 3...9]"};
    case SyntaxFault::list_misplaced:
      return {"a list is not allowed here", "expected a single number"};
    case SyntaxFault::too_many_elements:
      return {"the list has more than 1000 elements", "expected fewer"};
    case SyntaxFault::too_many_curves:
      return {"the lists make more than 32 curves", "expected shorter lists"};
    case SyntaxFault::line_break:
      return {"does a new expression start at this line?",
              "write \";\" between two expressions, or an operator between two parts of one"};
    case SyntaxFault::ask_exponent:
      return {fmt::format("is {} a power of ten? It is read as a product with the number e", e.subject),
              "write 1000 or 10^3 for a power of ten, 1*e*3 for the product"};
    case SyntaxFault::ask_point:
      return {fmt::format("is ({}) a point? It is read as a number with a decimal comma", e.subject),
              "write a space behind the comma, (1, 2), for a point, and 1.2 for the number"};
    case SyntaxFault::ask_brackets:
      return {"do the square brackets mean the integer part? They are read as parentheses",
              "write floor(x) for the integer part, (x) for parentheses"};
    case SyntaxFault::ask_both:
      return {"must both inequalities hold? Each is drawn for itself",
              "write \"and\" where both hold, \"or\" where one is enough"};
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
      return {"1つの数に小数点が2つあります",
              "数字または演算記号が必要です。2つの数の間なら、コンマの後に空白を入れてください"};
    case SyntaxFault::number_too_large:
      return {"数" + quoted + "は大きすぎます", "1.7e308 までの数にしてください"};
    case SyntaxFault::raised_digit_missing:
      return {"上付きの数字がありません", "⁰ から ⁹ のどれかが必要です"};
    case SyntaxFault::unknown_function:
      return {quoted + "という関数はありません",
              "sin、ln、sqrt、floor、gamma などの関数か、「f(x) = x^2」のような定義が必要です"};
    case SyntaxFault::unknown_name:
      return {quoted + "という名前はありません",
              "x、y、t、r、theta、pi、e、関数、または「a = 2」のように定義した文字が必要です"};
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
    case SyntaxFault::condition_alone:
      return {"条件の前に式がありません", "「y = x^2 {0 <= x <= 2}」のように書いてください"};
    case SyntaxFault::condition_missing:
      return {"条件がありません", "「x < 0」のような比較が必要です"};
    case SyntaxFault::value_missing:
      return {"場合の値がありません", "「{条件: 値, 条件: 値}」のように書いてください"};
    case SyntaxFault::defined_twice:
      return {quoted + "が2回定義されています", "文字の定義は1回だけにしてください"};
    case SyntaxFault::defined_by_itself:
      return {quoted + "が" + quoted + "自身で定義されています", quoted + "を使わずに定義してください"};
    case SyntaxFault::not_a_number:
      return {quoted + "が数ではありません", "「a = 2」のような値か、「f(x) = …」のような関数が必要です"};
    case SyntaxFault::other_variable:
      return {quoted + "に " + e.closing + " が入っています", "括弧の中の変数だけを使ってください"};
    case SyntaxFault::other_variable_in_condition:
      return {"条件に " + e.subject + " が入っています", "x、y、t だけを使ってください"};
    case SyntaxFault::outside_its_range:
      return {quoted + "の値が範囲の外にあります", "範囲の中の値にしてください"};
    case SyntaxFault::integral_form:
      return {"積分はこの形では書けません",
              "「integral(t^2, t, 0, x)」または「∫_0^x t^2 dt」の形で書いてください"};
    case SyntaxFault::area_form:
      return {
          "面積はこの形では書けません",
          "x の関数と異なる 2 つの数で「area(x^2, 0, 2)」または「area(x^2, x, 0, 1)」の形で書いてください"};
    case SyntaxFault::other_variable_in_integral:
      return {"積分する関数に変数 " + e.closing + " が含まれています",
              "変数は " + e.subject + " だけにしてください"};
    case SyntaxFault::no_derivative:
      return {quoted + "の導関数が分かりません", "ガンマ関数や階乗のない関数にしてください"};
    case SyntaxFault::too_many_parts:
      return {"関数を展開すると式が大きすぎます", "もっと簡単な式にしてください"};
    case SyntaxFault::two_equations:
      return {"「and」で結んだ2つの等式の共通部分は点です", "間に「;」を書くと、交点が一覧に出ます"};
    case SyntaxFault::choice_in_region:
      return {"不等式の条件に「or」は使えません", "場合ごとに不等式を書き、間に「or」を置いてください"};
    case SyntaxFault::point_not_two_numbers:
      return {"点は2つの数で書きます", "「(1, 2)」のように書いてください"};
    case SyntaxFault::model_form:
      return {"近似式が読めません", "「y ~ a x + b」のように、x と文字の式を書いてください"};
    case SyntaxFault::no_letter:
      return {"近似式に、値を求める文字がありません", "「y ~ a x + b」のように書いてください"};
    case SyntaxFault::too_few_points:
      return {fmt::format("文字が {} 個の近似式に対して、点が {} 個しかありません", e.wanted, e.number),
              fmt::format("{} 個以上の点が必要です", e.wanted)};
    case SyntaxFault::letters_undetermined:
      return {"これらの点では近似式の文字の値が決まりません", "文字を減らすか、x の違う点を加えてください"};
    case SyntaxFault::model_undefined:
      return {fmt::format("近似式は x = {} で値がありません", e.subject),
              "すべての点で値がある近似式にしてください"};
    case SyntaxFault::letter_under_integral:
      return {fmt::format("積分の中のこの位置では、文字 {} の値を求められません", e.subject),
              "「integral(a t^2, t, 0, x)」のように、掛ける数として書いてください"};
    case SyntaxFault::fit_not_found:
      return {"近似式に合う値が見つかりません", "もっと簡単な近似式にしてください"};
    case SyntaxFault::not_equal:
      return {quoted + "では何をかきますか。等しくない点は平面全体に広がります",
              "曲線は「y = x」、両側の領域は「y < x or y > x」と書いてください"};
    case SyntaxFault::list:
      return {"リストに入れられるのは数か式です。点は入れられません",
              "点は「(1, 2), (3, 4)」か「([1, 3], [2, 4])」と書いてください"};
    case SyntaxFault::list_in_list:
      return {"リストの中にリストは入れられません", "「[1, 2, 3]」のように数か式を並べてください"};
    case SyntaxFault::list_leads_nowhere:
      return {"リストの数が、最初から最後まで等しい間隔で並びません",
              "「[1...5]」か「[1, 3...9]」のように書いてください"};
    case SyntaxFault::list_misplaced:
      return {"ここにリストは置けません", "1つの数が必要です"};
    case SyntaxFault::too_many_elements:
      return {"リストの要素が 1000 個を超えています", "要素を減らしてください"};
    case SyntaxFault::too_many_curves:
      return {"リストの作る曲線が 32 本を超えています", "リストを短くしてください"};
    case SyntaxFault::line_break:
      return {"この行から新しい式が始まりますか",
              "2つの式の間には「;」を、1つの式の中なら演算記号を書いてください"};
    case SyntaxFault::ask_exponent:
      return {fmt::format("{} は 10 の累乗ですか。今は数 e との積として読んでいます", e.subject),
              "10 の累乗は「1000」か「10^3」、積は「1*e*3」と書いてください"};
    case SyntaxFault::ask_point:
      return {fmt::format("({}) は点ですか。今は小数として読んでいます", e.subject),
              "点は「(1, 2)」のようにコンマの後に空白を、小数は「1.2」と書いてください"};
    case SyntaxFault::ask_brackets:
      return {"角括弧は整数部分（ガウス記号）ですか。今は普通の括弧として読んでいます",
              "整数部分は「floor(x)」、括弧は「(x)」と書いてください"};
    case SyntaxFault::ask_both:
      return {"2つの不等式は同時に成り立つものですか。今は別々の領域としてかいています",
              "同時なら「and」、どちらかなら「or」を間に書いてください"};
  }
  return {};
}

}  // namespace

SyntaxWords in_words(const SyntaxError& error, Language language) {
  return language == Language::english ? english(error) : japanese(error);
}

std::string question_words(const SyntaxError& question, Language language) {
  SyntaxWords words = in_words(question, language);
  if (language == Language::japanese) return words.message + "。" + words.expected + "。";
  for (std::string* s : {&words.message, &words.expected}) {
    if (!s->empty() && (*s)[0] >= 'a' && (*s)[0] <= 'z') (*s)[0] = static_cast<char>((*s)[0] - 'a' + 'A');
  }
  return words.message + ". " + words.expected + ".";
}

base::Error SyntaxError::to_error() const {
  SyntaxWords words = in_words(*this, Language::english);
  return {base::Errc::parse, std::move(words.message), "column " + std::to_string(column),
          std::move(words.expected)};
}

}  // namespace nazori::functions
