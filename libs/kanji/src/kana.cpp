// SPDX-License-Identifier: Apache-2.0
#include "nazori/kanji/kana.h"

#include <string_view>

namespace nazori::kanji {
namespace {

constexpr char32_t kDakuten = 0x3099;
constexpr char32_t kHandakuten = 0x309A;
constexpr char32_t kToKatakana = U'ア' - U'あ';

}  // namespace

Script script_of(char32_t c) {
  if (c >= 0x3041 && c <= 0x309F) return Script::hiragana;
  if (c >= 0x30A0 && c <= 0x30FF) return Script::katakana;
  if (c < 0x250 || (c >= 0xFF01 && c <= 0xFF5E)) return Script::latin;
  return Script::other;
}

char32_t with_sound_mark(char32_t kana, char32_t mark) {
  constexpr std::u32string_view kVoiced =
      U"かきくけこさしすせそたちつてとはひふへほカキクケコサシスセソタチツテトハヒフヘホゝヽ";
  constexpr std::u32string_view kHalfVoiced = U"はひふへほハヒフヘホ";
  if (mark == kDakuten) {
    if (kana == U'う') return U'ゔ';
    if (kana == U'ウ') return U'ヴ';
    if (kVoiced.find(kana) != std::u32string_view::npos) return kana + 1;
  }
  if (mark == kHandakuten && kHalfVoiced.find(kana) != std::u32string_view::npos) return kana + 2;
  return 0;
}

char32_t in_other_syllabary(char32_t kana) {
  if (kana >= 0x3041 && kana <= 0x3096) return kana + kToKatakana;
  if (kana >= 0x30A1 && kana <= 0x30F6) return kana - kToKatakana;
  return 0;
}

}  // namespace nazori::kanji
