// SPDX-License-Identifier: Apache-2.0
#include "nazori/kanji/meaning_text.h"

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

}  // namespace nazori::kanji
