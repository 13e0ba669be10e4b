// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "nazori/functions/plot.h"

namespace nazori::functions {

enum class TokenKind : std::uint8_t {
  number,
  variable,
  constant,
  function,
  plus,
  minus,
  times,
  divide,
  power,
  superscript,
  factorial,
  root,
  open,
  close,
  bar,
  comma,
  underscore,
  comparison,
  semicolon,
  colon,
  both,          ///< "and"
  either,        ///< "or"
  degree,        ///< the raised circle
  prime,         ///< of a derivative; `value` counts them
  tilde,         ///< of a model: y ~ a x + b
  dots,          ///< "..." of a range: [1...5]
  integral,      ///< the sign, or "int_"
  differential,  ///< behind it: dt
  area,          ///< the word, in front of a parenthesis
  name,          ///< of a parameter or a function of the text: Token::text
  end
};

/// One word of an expression.
struct Token {
  TokenKind kind = TokenKind::end;
  int column = 1;
  std::string text;  ///< as typed, for messages
  double value = 0;  ///< of a number or superscript
  bool exact = true;
  Variable variable = Variable::x;
  Constant constant = Constant::pi;
  Function function = Function::sin;
  Comparison comparison = Comparison::equal;
  char32_t bracket = 0;  ///< of open and close: ( [ {
  int degree = 2;        ///< of a root sign
  bool space_before = false;
  bool line_before = false;  ///< a line break stands before it
};

/// The letters that a text defines: "a = 2", "0 <= b <= 3", "f(x) = x^2".
struct DefinedLetters {
  std::u32string parameters;
  std::u32string functions;
  /// Where models stand, y ~ a x + b, from the first character to the one behind the last: there every letter
  /// has a meaning.
  std::vector<std::pair<std::size_t, std::size_t>> models;
  [[nodiscard]] bool contains(char32_t letter) const {
    return (parameters + functions).find(letter) != std::u32string::npos;
  }
};
/// Whether a letter can be given a meaning: not x, y, z, t, r and e.
[[nodiscard]] bool can_be_defined(char32_t letter);
/// @param text  in small letters, with one spelling for each sign.
[[nodiscard]] DefinedLetters defined_letters(std::u32string_view text);

/// Splits text into tokens, the last of kind `end`. Runs of letters are cut into known names, longest first:
/// "xsinx" is x, sin, x.
[[nodiscard]] tl::expected<std::vector<Token>, SyntaxError> tokenize(std::string_view text,
                                                                     const ParseOptions& options);

}  // namespace nazori::functions
