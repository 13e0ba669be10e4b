// SPDX-License-Identifier: Apache-2.0
#include "nazori/writing/among.h"

namespace nazori::writing {

bool is_among(char32_t character, Among among) {
  const auto within = [character](char32_t first, char32_t last) {
    return character >= first && character <= last;
  };
  switch (among) {
    case Among::all:
      return true;
    case Among::kana:
      return within(0x3041, 0x3096) || within(0x309B, 0x309F) || within(0x30A1, 0x30FA) ||
             within(0x30FC, 0x30FF);
    case Among::kanji:
      return within(0x2E80, 0x2FDF) || within(0x3005, 0x3007) || within(0x3400, 0x9FFF) ||
             within(0xF900, 0xFAFF) || within(0x20000, 0x3FFFF);
    case Among::letters:
      return within(U'A', U'Z') || within(U'a', U'z') || within(U'0', U'9');
  }
  return false;
}

}  // namespace nazori::writing
