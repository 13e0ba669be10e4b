// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "nazori/kanji/character.h"

namespace nazori::kanji {

/// A gloss of EDICT without the editors' marks in front of it: "(uk) (abbr) to exist" gives "to exist". A
/// bracket that is part of the English ("(someone's) family") stays.
/// @source the marks: www.edrdg.org/jmdict/edict_doc.html, and those that JMdict has added since.
[[nodiscard]] std::string plain_gloss(std::string_view gloss);

/// Whether the editors mark a gloss as archaic, obsolete, rare, irregular or vulgar.
[[nodiscard]] bool is_unusual_gloss(std::string_view gloss);

/// Whether the editors say that the word is usually written in kana: "(uk)".
[[nodiscard]] bool is_usually_kana(std::string_view gloss);

/// The first glosses of a word as a learner reads them: plain, without repetitions, unusual senses left out
/// where there are others.
/// @param most  maximum number of glosses.
[[nodiscard]] std::vector<std::string> plain_glosses(const Word& word, std::size_t most);

}  // namespace nazori::kanji
