// SPDX-License-Identifier: Apache-2.0
#include "nazori/speech/spoken_kana.h"

#include <string>

#include "nazori/base/utf8.h"
#include "nazori/kanji/kana.h"
#include "nazori/kanji/romaji.h"

namespace nazori::speech {
namespace {

constexpr const char* kRemedy = "give hiragana or katakana, such as きゅうじつ";
constexpr char32_t kPause = U'、';
constexpr char32_t kLong = U'ー';

bool is_syllable(char32_t c) { return (c >= 0x3041 && c <= 0x3096) || c == kLong; }

/// The full-size kana of a small one; 0 for others.
char32_t full_size_of(char32_t small) {
  constexpr std::u32string_view kSmall = U"ぁぃぅぇぉっゃゅょゎゕゖ";
  constexpr std::u32string_view kFull = U"あいうえおつやゆよわかけ";
  const auto at = kSmall.find(small);
  return at == std::u32string_view::npos ? 0 : kFull[at];
}

/// Writes U+30F7..U+30FA (ヷ to ヺ), which have no hiragana, as two.
std::u32string_view pair_of(char32_t c) {
  switch (c) {
    case U'ヷ':
      return U"ゔぁ";
    case U'ヸ':
      return U"ゔぃ";
    case U'ヹ':
      return U"ゔぇ";
    case U'ヺ':
      return U"ゔぉ";
    default:
      return {};
  }
}

}  // namespace

base::Result<SpokenKana> spoken_kana(std::string_view text) {
  const auto decoded = base::decode_utf8(kanji::to_hiragana(text));
  if (!decoded) return base::fail(base::Errc::bad_argument, "is not UTF-8", {}, kRemedy);
  std::u32string name;
  std::size_t syllables = 0;
  for (const char32_t c : *decoded) {
    if (c == U'.' || c == U'．' || c == U'・' || c == U'･' || c == U'-' || c == U'~' || c == U'～' ||
        c == U'〜')
      continue;
    if (c == U' ' || c == U'　' || c == U'、' || c == U'､' || c == U',') {
      if (!name.empty() && name.back() != kPause) name += kPause;
      continue;
    }
    if (const char32_t marked = name.empty() ? 0 : kanji::with_sound_mark(name.back(), c); marked != 0) {
      name.back() = marked;
      continue;
    }
    if (const auto pair = pair_of(c); !pair.empty()) {
      name += pair;
      syllables += pair.size();
    } else if (is_syllable(c)) {
      name += c;
      ++syllables;
    } else {
      return base::fail(base::Errc::bad_argument, "only kana can be spoken", std::string(text), kRemedy);
    }
  }
  if (!name.empty() && name.back() == kPause) name.pop_back();
  if (syllables == 0)
    return base::fail(base::Errc::bad_argument, "there is nothing to speak", std::string(text), kRemedy);
  if (syllables > kMostSpokenKana)
    return base::fail(base::Errc::bad_argument, "is too long to be spoken", {}, "give at most 60 kana");
  SpokenKana spoken;
  spoken.name = base::encode_utf8(std::u32string_view(name));
  spoken.said = spoken.name;
  if (name.size() == 1) {
    if (const char32_t full = full_size_of(name.front()); full != 0)
      spoken.said = "ちいさい、" + base::encode_utf8(full);
    else if (name.front() == kLong)
      spoken.said = "のばすおん";
  }
  return spoken;
}

}  // namespace nazori::speech
