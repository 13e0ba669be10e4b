// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace nazori::kanji {

/// Normalises an English meaning for searching: lower case, each run of anything but letters, digits and
/// apostrophes becomes one space, none at the ends. Letters beyond ASCII are unchanged. "Day off (work)"
/// gives "day off work".
[[nodiscard]] std::string fold_meaning(std::string_view meaning);

/// A gloss of EDICT normalised for searching: without the marks of the editors, brackets and a "to", "a",
/// "an" or "the" in front: "(uk) to rest (a while)" gives "rest".
[[nodiscard]] std::string fold_gloss(std::string_view gloss);

}  // namespace nazori::kanji
