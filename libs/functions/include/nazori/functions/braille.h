// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "nazori/functions/plot.h"

namespace nazori::functions {

/// The Braille codes for mathematics.
enum class BrailleCode : std::uint8_t {
  /// @source The Nemeth Braille Code for Mathematics and Science Notation, 1972 revision.
  nemeth,
  /// @source Unified English Braille, Guidelines for Technical Material, 2014 (grade 1 mode throughout).
  ueb,
};

/// The expression in Unicode Braille patterns of six dots, without line breaks. Products without a sign,
/// fractions, powers and roots are laid out as in print; what is read is the same tree as canonical().
[[nodiscard]] std::string in_braille(const Expression& expression, BrailleCode code);
/// The statement, with its conditions and the range of its parameter.
[[nodiscard]] std::string in_braille(const Statement& statement, BrailleCode code);
/// One line for each statement, then one for each parameter.
[[nodiscard]] std::string in_braille(const Plot& plot, BrailleCode code);

}  // namespace nazori::functions
