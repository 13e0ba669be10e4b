// SPDX-License-Identifier: Apache-2.0
#include "nazori/kanji/meaning_text.h"

#include "nazori/kanji/gloss.h"

namespace nazori::kanji {

std::string fold_meaning(std::string_view meaning) {
  std::string out;
  bool gap = false;
  for (char c : meaning) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    const bool kept = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '\'' ||
                      static_cast<unsigned char>(c) >= 0x80;
    if (kept) {
      if (gap && !out.empty()) out += ' ';
      out += c;
    }
    gap = !kept;
  }
  return out;
}

std::string fold_gloss(std::string_view gloss) {
  std::string open;
  int depth = 0;
  for (const char c : plain_gloss(gloss)) {
    if (c == '(') ++depth;
    if (depth == 0) open += c;
    if (c == ')' && depth > 0) --depth;
  }
  std::string folded = fold_meaning(open);
  for (const std::string_view article : {"to ", "a ", "an ", "the "}) {
    if (folded.starts_with(article)) {
      folded.erase(0, article.size());
      break;
    }
  }
  return folded;
}

}  // namespace nazori::kanji
