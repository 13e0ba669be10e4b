// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <string>

#include "nazori/functions/syntax_error.h"

namespace nazori::ui {

/// The language of the interface, as the module `functions` names it.
[[nodiscard]] functions::Language plot_language();
/// How much is said around the parts of an expression: a setting of the page for functions.
[[nodiscard]] functions::SpeechStyle plot_speech();
void set_plot_speech(functions::SpeechStyle style);
/// Whether the learner's desktop writes 1,5.
[[nodiscard]] bool uses_decimal_comma();

/// A text of the module `functions`, with the learner's decimal sign.
[[nodiscard]] QString localised(const std::string& words);
/// A number to read, with `digits` significant digits.
[[nodiscard]] QString number_text(double value, int digits = 6);
/// Why an expression cannot be read: "Column 5: an operand is missing after "+"; expected a number."
[[nodiscard]] QString syntax_error_words(const functions::SyntaxError& error);

}  // namespace nazori::ui
