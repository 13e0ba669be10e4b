// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "nazori/base/result.h"

namespace nazori::functions {

/// The languages of texts about expressions, points and errors.
enum class Language : std::uint8_t { english, japanese };

/// How much is said around the parts of a spoken expression. Each form is unambiguous: different trees never
/// sound alike. The levels are those of MathSpeak; the words are those of ClearSpeak.
/// @source ClearSpeak Rules and Preferences (ETS); The MathSpeak Grammar Rules (gh, LLC).
enum class SpeechStyle : std::uint8_t {
  verbose,     ///< "the quantity x plus 1 end quantity squared"
  brief,       ///< "quantity x plus 1 end squared"
  superbrief,  ///< "open x plus 1 close squared"
};

/// The errors in a text that should be an expression.
enum class SyntaxFault : std::uint8_t {
  no_expression,
  operand_missing,       ///< after SyntaxError::subject
  not_an_operand,        ///< subject is where an operand must be
  does_not_fit,          ///< subject, where an expression could have ended
  no_operator,           ///< between two numbers; subject is the second
  nested_too_deep,       ///< parentheses, bars, functions, powers or signs
  bar_open,              ///< the bar of column SyntaxError::number is not closed
  bracket_open,          ///< subject of column number is not closed by `closing`
  argument_missing,      ///< of the function subject
  argument_count,        ///< subject has `number` arguments, not `wanted`
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
  range_misplaced,   ///< not after the curve it belongs to
  parameter_alone,   ///< t without both x and y
  polar_mixed,       ///< r and theta with the variable subject
  nothing_equal,     ///< an expression in r and theta without "="
  height_misplaced,  ///< z is not alone on one side
  condition_alone,   ///< a condition in braces without an expression in front of it
  condition_missing,
  value_missing,                ///< of a case: the ":" after the condition
  defined_twice,                ///< the letter subject
  defined_by_itself,            ///< the letter subject
  not_a_number,                 ///< the parameter subject is no finite number
  other_variable,               ///< the function subject contains the variable `closing`
  other_variable_in_condition,  ///< subject; of a curve with a parameter
  outside_its_range,            ///< the value of the parameter subject
  no_derivative,                ///< of the function subject
  integral_form,                ///< an integral is not written as one can be
  area_form,                    ///< an area is not written as one can be
  other_variable_in_integral,   ///< over subject: the function also contains the variable `closing`
  too_many_parts,               ///< of an expression, once its functions are written out
  two_equations,                ///< joined by "and"
  choice_in_region,             ///< "or" in the braces of an inequality
  point_not_two_numbers,
  model_form,             ///< not y ~ an expression in x
  no_letter,              ///< of a model without letters to fit
  too_few_points,         ///< `number` of them for a model of `wanted` letters
  letters_undetermined,   ///< of a model: other values fit as well
  model_undefined,        ///< at x = subject
  letter_under_integral,  ///< subject, of a model, is in what is integrated, and not as a factor
  fit_not_found,          ///< the search for the letters does not end
  not_equal,              ///< subject is the sign
  list,                   ///< square brackets around points
  list_in_list,
  list_leads_nowhere,  ///< the numbers of [1...5]
  list_misplaced,      ///< where a single number must be
  too_many_elements,   ///< of a list
  too_many_curves,     ///< of all lists of a text
  line_break,          ///< between two parts that would be multiplied, before subject
  // Questions: what can be read in two ways. They do not stop reading.
  ask_exponent,  ///< subject is a number such as 1e3
  ask_point,     ///< subject is a number with a comma, alone in parentheses
  ask_brackets,  ///< square brackets
  ask_both,      ///< ";" between two inequalities
};

/// Why a text cannot be parsed: the kind and place of the error, as data that can be expressed in any
/// language.
struct SyntaxError {
  /// Column of the error: counted in characters from 1, after the end for an incomplete text.
  int column = 1;
  SyntaxFault fault = SyntaxFault::no_expression;
  std::string subject{};  ///< the typed text that is wrong: a sign, a name, a number
  std::string closing{};  ///< of bracket_open: the sign that is missing; of other_variable: the variable
  int number = 0;  ///< bar_open and bracket_open: a column; argument_count: the number of arguments given;
                   ///< too_few_points: the points
  /// argument_count: the number required; below 0: that many or more; too_few_points: the letters
  int wanted = 0;

  /// As an Error of code parse whose `where` is "column 8", in English.
  [[nodiscard]] base::Error to_error() const;
};

/// An error in words, each part without a full stop.
struct SyntaxWords {
  std::string message;   ///< "an operand is missing after \"+\""
  std::string expected;  ///< "expected a number, a variable, a function or \"(\""
};
[[nodiscard]] SyntaxWords in_words(const SyntaxError& error, Language language);
/// A question about what can be read in two ways, as whole sentences: "Must both inequalities hold? ...".
[[nodiscard]] std::string question_words(const SyntaxError& question, Language language);

}  // namespace nazori::functions
