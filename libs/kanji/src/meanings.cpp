// SPDX-License-Identifier: Apache-2.0
#include "nazori/kanji/meanings.h"

namespace nazori::kanji {

std::vector<std::string> meanings_in(std::string_view language, const DictionaryEntry& entry) {
  std::vector<std::string> texts;
  for (const auto& meaning : entry.meanings)
    if (meaning.language == language) texts.push_back(meaning.text);
  return texts;
}

}  // namespace nazori::kanji
