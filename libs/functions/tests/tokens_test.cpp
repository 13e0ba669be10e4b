// SPDX-License-Identifier: Apache-2.0
#include "../src/tokens.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "nazori/functions/tape.h"

namespace nazori::functions {
namespace {

using T = TokenKind;

std::vector<Token> tokens_of(std::string_view text, const ParseOptions& options = {}) {
  auto tokens = tokenize(text, options);
  EXPECT_TRUE(tokens) << text;
  return tokens ? *tokens : std::vector<Token>{};
}

std::vector<T> kinds_of(std::string_view text, const ParseOptions& options = {}) {
  std::vector<T> kinds;
  for (const Token& t : tokens_of(text, options)) kinds.push_back(t.kind);
  EXPECT_TRUE(!kinds.empty() && kinds.back() == T::end) << text;
  if (!kinds.empty()) kinds.pop_back();
  return kinds;
}

Token only(std::string_view text) {
  const auto tokens = tokens_of(text);
  EXPECT_EQ(tokens.size(), 2U) << text;
  return tokens.empty() ? Token{} : tokens[0];
}

std::vector<double> numbers_of(std::string_view text, const ParseOptions& options = {}) {
  std::vector<double> numbers;
  for (const Token& t : tokens_of(text, options)) {
    if (t.kind == T::number) numbers.push_back(t.value);
  }
  return numbers;
}

TEST(Tokens, EverySpellingOfASignMeansTheSame) {
  const std::pair<const char*, T> signs[] = {
      {"+", T::plus},      {"＋", T::plus},      {"-", T::minus},  {"−", T::minus},     {"–", T::minus},
      {"—", T::minus},     {"‐", T::minus},      {"‑", T::minus},  {"－", T::minus},    {"*", T::times},
      {"×", T::times},     {"·", T::times},      {"⋅", T::times},  {"∙", T::times},     {"∗", T::times},
      {"•", T::times},     {"・", T::times},     {"＊", T::times}, {"**", T::power},    {"^", T::power},
      {"/", T::divide},    {"÷", T::divide},     {"∕", T::divide}, {"⁄", T::divide},    {"！", T::factorial},
      {"!", T::factorial}, {"_", T::underscore}, {"|", T::bar},    {"∣", T::bar},       {"│", T::bar},
      {"｜", T::bar},      {",", T::comma},      {"、", T::comma}, {";", T::semicolon}, {"；", T::semicolon},
      {"(", T::open},      {"[", T::open},       {"{", T::open},   {")", T::close},     {"]", T::close},
      {"}", T::close},     {"（", T::open},      {"~", T::tilde},  {"～", T::tilde},    {"∼", T::tilde},
      {"〜", T::tilde},    {"...", T::dots},     {"..", T::dots},  {"…", T::dots},      {"＠", T::end}};
  for (const auto& [text, kind] : signs) {
    if (kind == T::end) {
      EXPECT_FALSE(tokenize(text, {})) << text;
    } else {
      EXPECT_EQ(only(text).kind, kind) << text;
    }
  }
  EXPECT_EQ(only("[").bracket, U'[');
  EXPECT_EQ(only("}").bracket, U'}');
  EXPECT_EQ(only("√").degree, 2);
  EXPECT_EQ(only("∛").degree, 3);
  EXPECT_EQ(only("∜").degree, 4);
  EXPECT_EQ(only("√").kind, T::root);
}

TEST(Tokens, PrimesAreCountedSignBySign) {
  for (const char* text : {"'", "’", "′"}) {
    EXPECT_EQ(only(text).kind, T::prime) << text;
    EXPECT_EQ(only(text).value, 1) << text;
    EXPECT_EQ(only(text).text, text);
  }
  EXPECT_EQ(only("″").kind, T::prime);
  EXPECT_EQ(only("″").value, 2);
  EXPECT_EQ(kinds_of("''x"), (std::vector{T::prime, T::prime, T::variable}));
  EXPECT_EQ(kinds_of("″x"), (std::vector{T::prime, T::variable}));
}

TEST(Tokens, OtherSignsOfOneLetterAreThemselves) {
  const std::pair<const char*, T> signs[] = {{"°", T::degree},  {"º", T::degree},  {":", T::colon},
                                             {"∧", T::both},    {"∨", T::either},  {"and", T::both},
                                             {"or", T::either}, {"∫", T::integral}};
  for (const auto& [text, kind] : signs) {
    EXPECT_EQ(only(text).kind, kind) << text;
    EXPECT_EQ(only(text).text, text);
    const auto twice = tokens_of(std::string(text) + " x");
    ASSERT_EQ(twice.size(), 3U) << text;
    EXPECT_EQ(twice[1].variable, Variable::x) << text;
  }
}

TEST(Tokens, NotEqualIsToldWithItsColumn) {
  for (const auto& [text, sign] : {std::pair{"y + 1 != x", "!="}, {"y + 1 ≠ x", "≠"}}) {
    const auto wrong = tokenize(text, {});
    ASSERT_FALSE(wrong) << text;
    EXPECT_EQ(wrong.error().fault, SyntaxFault::not_equal) << text;
    EXPECT_EQ(wrong.error().column, 7) << text;
    EXPECT_EQ(wrong.error().subject, sign);
  }
  EXPECT_EQ(kinds_of("x! = 2"), (std::vector{T::variable, T::factorial, T::comparison, T::number}));
}

TEST(Tokens, EverySpellingOfAComparisonMeansTheSame) {
  using C = Comparison;
  for (const auto& [text, which] :
       {std::pair{"=", C::equal}, std::pair{"==", C::equal}, std::pair{"=<", C::less_equal},
        std::pair{"=>", C::greater_equal}, std::pair{"<", C::less}, std::pair{"<=", C::less_equal},
        std::pair{"≤", C::less_equal}, std::pair{"≦", C::less_equal}, std::pair{"⩽", C::less_equal},
        std::pair{">", C::greater}, std::pair{">=", C::greater_equal}, std::pair{"≥", C::greater_equal},
        std::pair{"≧", C::greater_equal}, std::pair{"⩾", C::greater_equal}, std::pair{"＝", C::equal}}) {
    EXPECT_EQ(only(text).kind, T::comparison) << text;
    EXPECT_EQ(only(text).comparison, which) << text;
  }
  EXPECT_EQ(kinds_of("=x"), (std::vector{T::comparison, T::variable}));
  EXPECT_EQ(kinds_of("<>"), (std::vector{T::comparison, T::comparison}));
}

TEST(Tokens, SignsOfOneLetterAreVariablesConstantsAndGamma) {
  EXPECT_EQ(only("π").constant, Constant::pi);
  EXPECT_EQ(only("τ").constant, Constant::tau);
  EXPECT_EQ(only("ℯ").constant, Constant::e);
  EXPECT_EQ(only("ℯ").kind, T::constant);
  for (const char* text : {"θ", "ϑ", "Θ", "theta", "THETA"}) {
    EXPECT_EQ(only(text).kind, T::variable) << text;
    EXPECT_EQ(only(text).variable, Variable::theta) << text;
  }
  EXPECT_EQ(only("Γ").kind, T::function);
  EXPECT_EQ(only("Γ").function, Function::gamma);
  EXPECT_EQ(only("X").variable, Variable::x);
  EXPECT_EQ(only("Ｚ").variable, Variable::z);
  EXPECT_EQ(only("r").variable, Variable::r);
  EXPECT_EQ(only("pi").constant, Constant::pi);
}

TEST(Tokens, EveryNameIsItsFunction) {
  using F = Function;
  const std::pair<const char*, F> names[] = {
      {"sin", F::sin},       {"cos", F::cos},       {"tan", F::tan},      {"tg", F::tan},
      {"cot", F::cot},       {"ctg", F::cot},       {"sec", F::sec},      {"csc", F::csc},
      {"cosec", F::csc},     {"asin", F::asin},     {"arcsin", F::asin},  {"acos", F::acos},
      {"arccos", F::acos},   {"atan", F::atan},     {"arctan", F::atan},  {"acot", F::acot},
      {"arccot", F::acot},   {"sinh", F::sinh},     {"cosh", F::cosh},    {"tanh", F::tanh},
      {"coth", F::coth},     {"sech", F::sech},     {"csch", F::csch},    {"asinh", F::asinh},
      {"arsinh", F::asinh},  {"arcsinh", F::asinh}, {"acosh", F::acosh},  {"arcosh", F::acosh},
      {"arccosh", F::acosh}, {"atanh", F::atanh},   {"artanh", F::atanh}, {"arctanh", F::atanh},
      {"exp", F::exp},       {"ln", F::ln},         {"log", F::log10},    {"lg", F::log10},
      {"sqrt", F::sqrt},     {"cbrt", F::cbrt},     {"root", F::root},    {"abs", F::abs},
      {"sign", F::sign},     {"sgn", F::sign},      {"signum", F::sign},  {"floor", F::floor},
      {"ceil", F::ceil},     {"ceiling", F::ceil},  {"round", F::round},  {"trunc", F::trunc},
      {"frac", F::fraction}, {"gamma", F::gamma},   {"erf", F::erf},      {"factorial", F::factorial},
      {"min", F::min},       {"max", F::max},       {"mod", F::mod},      {"hypot", F::hypot}};
  for (const auto& [name, function] : names) {
    EXPECT_EQ(only(name).kind, T::function) << name;
    EXPECT_EQ(only(name).function, function) << name;
  }
}

TEST(Tokens, NamesThatEndInDigitsNeedTheirParenthesis) {
  EXPECT_EQ(tokens_of("log2(x)")[0].function, Function::log2);
  EXPECT_EQ(tokens_of("log10(x)")[0].function, Function::log10);
  EXPECT_EQ(tokens_of("log10(x)")[1].kind, T::open);
  EXPECT_EQ(tokens_of("atan2(y, x)")[0].function, Function::atan2);
  EXPECT_EQ(kinds_of("log2x"), (std::vector{T::function, T::number, T::variable}));
  EXPECT_EQ(kinds_of("log2 (x)").size(), 5U);
}

TEST(Tokens, RunsOfLettersAreCutIntoTheLongestNames) {
  EXPECT_EQ(kinds_of("xsinx"), (std::vector{T::variable, T::function, T::variable}));
  EXPECT_EQ(kinds_of("sinhx"), (std::vector{T::function, T::variable}));
  EXPECT_EQ(kinds_of("xyz"), (std::vector{T::variable, T::variable, T::variable}));
  EXPECT_EQ(kinds_of("pix"), (std::vector{T::constant, T::variable}));
  EXPECT_EQ(kinds_of("etheta"), (std::vector{T::constant, T::variable}));
  // "tanhx" is tanh of x. "tant" is tan of t, and fails where there is no t.
  EXPECT_EQ(kinds_of("tant"), (std::vector{T::function, T::variable}));
  // Taking the longest name first would leave an invalid rest: exp would leave "i".
  EXPECT_EQ(kinds_of("expi"), (std::vector{T::constant, T::variable, T::constant}));
  const auto wrong = tokenize("x + fooo(2)", {});
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().fault, SyntaxFault::unknown_function);
  EXPECT_EQ(wrong.error().subject, "fooo");
  EXPECT_EQ(wrong.error().column, 5);
  EXPECT_EQ(tokenize("q", {}).error().fault, SyntaxFault::unknown_name);
  // Long runs do not take long.
  std::string long_run(2000, 'e');
  long_run += 'q';
  EXPECT_FALSE(tokenize(long_run, {}));
}

TEST(Tokens, TellColumnsTextAndSpaces) {
  const auto t = tokens_of("θ ＋  2,5");
  ASSERT_EQ(t.size(), 4U);
  EXPECT_EQ(t[0].column, 1);
  EXPECT_FALSE(t[0].space_before);
  EXPECT_EQ(t[1].column, 3);
  EXPECT_EQ(t[1].text, "＋");
  EXPECT_TRUE(t[1].space_before);
  EXPECT_EQ(t[2].column, 6);
  EXPECT_EQ(t[2].text, "2,5");
  EXPECT_EQ(t[2].value, 2.5);
  EXPECT_EQ(t[3].column, 9);
  EXPECT_FALSE(t[3].space_before);
  const auto close = tokens_of(" x**y");
  EXPECT_EQ(close[1].column, 3);
  EXPECT_EQ(close[1].text, "**");
  EXPECT_EQ(close[2].column, 5);
}

TEST(Tokens, EverySpaceSeparates) {
  for (const char* space : {" ", "\t", "\n", "\r", "\u00A0", "\u3000", "\u2000", "\u2009", "\u200B", "\u202F",
                            "\u2060", "\uFEFF"}) {
    const std::string text = std::string("2") + space + "3";
    const auto tokens = tokenize(text, {});
    ASSERT_TRUE(tokens) << text;
    EXPECT_EQ(tokens->size(), 3U) << text;
  }
  EXPECT_FALSE(tokenize("2\u200C3", {}));
  EXPECT_FALSE(tokenize("2\u1FFF3", {}));
}

TEST(Tokens, AreExactWhereTheDoubleIsWhatWasTyped) {
  for (const char* text : {"0.5", "3", "0,125", "1.50", "8999999999999999", "0.0009765625", "2.", ".5"})
    EXPECT_TRUE(only(text).exact) << text;
  for (const char* text : {"0.1", "1.3", "123456789012345678", "9007199254740993", "0.30"})
    EXPECT_FALSE(only(text).exact) << text;
  EXPECT_EQ(only(".5").value, 0.5);
  EXPECT_EQ(only("2.").value, 2);
}

TEST(Tokens, ACommaIsADecimalSignUnlessItSeparatesArguments) {
  EXPECT_EQ(numbers_of("1,5"), (std::vector{1.5}));
  EXPECT_EQ(numbers_of(",5"), (std::vector{0.5}));
  EXPECT_EQ(numbers_of("min(1,5)"), (std::vector{1.0, 5.0}));
  EXPECT_EQ(numbers_of("min(x,5)"), (std::vector{5.0}));
  EXPECT_EQ(kinds_of("min(x,5)").size(), 6U);
  EXPECT_EQ(numbers_of("min((1,5), 2)"), (std::vector{1.5, 2.0})) << "inside other parentheses";
  EXPECT_EQ(numbers_of("min(1, 2) + 1,5"), (std::vector{1.0, 2.0, 1.5})) << "and after them";
  EXPECT_EQ(numbers_of("sin(1,5)"), (std::vector{1.5}));
  for (const char* name : {"min", "max", "mod", "atan2", "root", "hypot"})
    EXPECT_EQ(numbers_of(std::string(name) + "(1,5)"), (std::vector{1.0, 5.0})) << name;
  const ParseOptions comma{true};
  EXPECT_EQ(numbers_of("min(1,5; 2)", comma), (std::vector{1.5, 2.0}));
  EXPECT_EQ(numbers_of("min(1, 5)", comma), (std::vector{1.0, 5.0}));
  EXPECT_EQ(numbers_of("min(x;,5)", comma), (std::vector{0.5}));
  EXPECT_EQ(kinds_of("1, 5"), (std::vector{T::number, T::comma, T::number}));
  EXPECT_EQ(kinds_of("1,x"), (std::vector{T::number, T::comma, T::variable}));
  EXPECT_EQ(kinds_of(")1,5"), (std::vector{T::close, T::number})) << "too many closed is found later";
}

TEST(Tokens, ANumberHasOneDecimalSignAndFitsADouble) {
  const auto twice = tokenize("x+1.2.3", {});
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.error().fault, SyntaxFault::two_decimal_signs);
  EXPECT_EQ(twice.error().column, 6);
  EXPECT_FALSE(tokenize("1,2,3", {}));
  const auto large = tokenize("x + " + std::string(400, '9'), {});
  ASSERT_FALSE(large);
  EXPECT_EQ(large.error().fault, SyntaxFault::number_too_large);
  EXPECT_EQ(large.error().subject, std::string(40, '9'));
  EXPECT_EQ(large.error().column, 5);
}

TEST(Tokens, RaisedDigitsMakeASignedNumber) {
  EXPECT_EQ(only("⁰").value, 0);
  EXPECT_EQ(only("¹²³⁴⁵⁶⁷⁸⁹").value, 123456789);
  EXPECT_EQ(only("⁻²").value, -2);
  EXPECT_EQ(only("⁺⁷").value, 7);
  EXPECT_EQ(only("²").kind, T::superscript);
  EXPECT_EQ(kinds_of("x²y"), (std::vector{T::variable, T::superscript, T::variable}));
  const auto bare = tokenize("x⁻", {});
  ASSERT_FALSE(bare);
  EXPECT_EQ(bare.error().fault, SyntaxFault::raised_digit_missing);
  EXPECT_EQ(bare.error().column, 3);
}

TEST(Tokens, TenThousandBytesAreReadAndNoMore) {
  EXPECT_TRUE(tokenize(std::string(10'000, ' '), {}));
  const auto longer = tokenize(std::string(10'001, ' '), {});
  ASSERT_FALSE(longer);
  EXPECT_EQ(longer.error().fault, SyntaxFault::too_long);
  EXPECT_EQ(longer.error().column, 1);
  EXPECT_EQ(tokenize("x\xff", {}).error().fault, SyntaxFault::not_utf8);
  EXPECT_EQ(tokenize("x + é", {}).error().fault, SyntaxFault::unknown_character);
  EXPECT_EQ(tokenize("x + é", {}).error().subject, "é");
  EXPECT_EQ(tokenize("x + é", {}).error().column, 5);
}

}  // namespace
}  // namespace nazori::functions
