// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "nazori/base/result.h"

namespace nazori::functions {

/// The languages in which expressions, points and mistakes are told.
enum class Language : std::uint8_t { english, japanese };

/// What can be wrong with a text that is to be an expression.
enum class SyntaxFault : std::uint8_t {
  no_expression,
  operand_missing,       ///< after SyntaxError::subject
  not_an_operand,        ///< subject stands where an operand must be
  does_not_fit,          ///< subject, where an expression could have ended
  no_operator,           ///< between two numbers; subject is the second
  nested_too_deep,       ///< parentheses, bars, functions, powers or signs
  bar_open,              ///< the bar of column SyntaxError::number is not closed
  bracket_open,          ///< subject of column number is not closed by `closing`
  argument_missing,      ///< of the function subject
  argument_count,        ///< subject is given `number` arguments, not `wanted`
  unknown_character,     ///< subject
  two_decimal_signs,     ///< in one number
  number_too_large,      ///< subject
  raised_digit_missing,  ///< after a raised sign
  unknown_function,      ///< subject, before a parenthesis
  unknown_name,          ///< subject
  too_long,
  not_utf8,
  surface_not_alone,
  too_many_statements,
  range_empty,
  range_misplaced,   ///< not after the curve that it is for
  parameter_alone,   ///< t without both x and y
  polar_mixed,       ///< r and theta with the variable subject
  nothing_equal,     ///< an expression in r and theta without "="
  height_misplaced,  ///< z that does not stand alone on one side
};

/// Why a text cannot be read: what is wrong where, in parts, so that it can be told in any language.
struct SyntaxError {
  /// Of the place at fault: counted in characters from 1, past the end for a text cut short.
  int column = 1;
  SyntaxFault fault = SyntaxFault::no_expression;
  std::string subject{};  ///< what was typed and does not fit: a sign, a name, a number
  std::string closing{};  ///< of bracket_open: the sign that is missing
  int number = 0;         ///< of bar_open and bracket_open a column, of argument_count how many there are
  int wanted = 0;         ///< of argument_count: how many must be; below 0: that many or more

  /// As an Error of code parse whose `where` is "column 8", in English.
  [[nodiscard]] base::Error to_error() const;
};

/// A mistake in words, each part without a full stop.
struct SyntaxWords {
  std::string message;   ///< "an operand is missing after \"+\""
  std::string expected;  ///< "expected a number, a variable, a function or \"(\""
};
[[nodiscard]] SyntaxWords in_words(const SyntaxError& error, Language language);

}  // namespace nazori::functions
