// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "nazori/kanji/character.h"

namespace nazori::kanji {

/// The meanings of a character in one language, in the order of the dictionary.
/// @param language  ISO 639-1: "en", "fr". Empty for a language that the dictionary does not have.
[[nodiscard]] std::vector<std::string> meanings_in(std::string_view language, const DictionaryEntry& entry);

}  // namespace nazori::kanji
