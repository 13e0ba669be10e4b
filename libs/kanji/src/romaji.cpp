// SPDX-License-Identifier: Apache-2.0
#include "nazori/kanji/romaji.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include "nazori/base/utf8.h"

namespace nazori::kanji {
namespace {

struct Syllable {
  std::string_view romaji;
  std::string_view kana;
};

/// Sorted by romaji, so that entries with the same beginning are adjacent.
constexpr auto kSyllables = [] {
  auto table = std::to_array<Syllable>({
      {"a", "あ"},     {"i", "い"},     {"u", "う"},     {"e", "え"},     {"o", "お"},     {"ka", "か"},
      {"ki", "き"},    {"ku", "く"},    {"ke", "け"},    {"ko", "こ"},    {"ga", "が"},    {"gi", "ぎ"},
      {"gu", "ぐ"},    {"ge", "げ"},    {"go", "ご"},    {"sa", "さ"},    {"si", "し"},    {"shi", "し"},
      {"su", "す"},    {"se", "せ"},    {"so", "そ"},    {"za", "ざ"},    {"zi", "じ"},    {"ji", "じ"},
      {"zu", "ず"},    {"ze", "ぜ"},    {"zo", "ぞ"},    {"ta", "た"},    {"ti", "ち"},    {"chi", "ち"},
      {"tu", "つ"},    {"tsu", "つ"},   {"te", "て"},    {"to", "と"},    {"da", "だ"},    {"di", "ぢ"},
      {"du", "づ"},    {"dzu", "づ"},   {"de", "で"},    {"do", "ど"},    {"na", "な"},    {"ni", "に"},
      {"nu", "ぬ"},    {"ne", "ね"},    {"no", "の"},    {"ha", "は"},    {"hi", "ひ"},    {"hu", "ふ"},
      {"fu", "ふ"},    {"he", "へ"},    {"ho", "ほ"},    {"ba", "ば"},    {"bi", "び"},    {"bu", "ぶ"},
      {"be", "べ"},    {"bo", "ぼ"},    {"pa", "ぱ"},    {"pi", "ぴ"},    {"pu", "ぷ"},    {"pe", "ぺ"},
      {"po", "ぽ"},    {"ma", "ま"},    {"mi", "み"},    {"mu", "む"},    {"me", "め"},    {"mo", "も"},
      {"ya", "や"},    {"yu", "ゆ"},    {"yo", "よ"},    {"ra", "ら"},    {"ri", "り"},    {"ru", "る"},
      {"re", "れ"},    {"ro", "ろ"},    {"wa", "わ"},    {"wi", "ゐ"},    {"we", "ゑ"},    {"wo", "を"},
      {"kya", "きゃ"}, {"kyu", "きゅ"}, {"kyo", "きょ"}, {"gya", "ぎゃ"}, {"gyu", "ぎゅ"}, {"gyo", "ぎょ"},
      {"sya", "しゃ"}, {"syu", "しゅ"}, {"syo", "しょ"}, {"sha", "しゃ"}, {"shu", "しゅ"}, {"sho", "しょ"},
      {"she", "しぇ"}, {"zya", "じゃ"}, {"zyu", "じゅ"}, {"zyo", "じょ"}, {"ja", "じゃ"},  {"ju", "じゅ"},
      {"jo", "じょ"},  {"je", "じぇ"},  {"jya", "じゃ"}, {"jyu", "じゅ"}, {"jyo", "じょ"}, {"tya", "ちゃ"},
      {"tyu", "ちゅ"}, {"tyo", "ちょ"}, {"cha", "ちゃ"}, {"chu", "ちゅ"}, {"cho", "ちょ"}, {"che", "ちぇ"},
      {"cya", "ちゃ"}, {"cyu", "ちゅ"}, {"cyo", "ちょ"}, {"dya", "ぢゃ"}, {"dyu", "ぢゅ"}, {"dyo", "ぢょ"},
      {"nya", "にゃ"}, {"nyu", "にゅ"}, {"nyo", "にょ"}, {"hya", "ひゃ"}, {"hyu", "ひゅ"}, {"hyo", "ひょ"},
      {"bya", "びゃ"}, {"byu", "びゅ"}, {"byo", "びょ"}, {"pya", "ぴゃ"}, {"pyu", "ぴゅ"}, {"pyo", "ぴょ"},
      {"mya", "みゃ"}, {"myu", "みゅ"}, {"myo", "みょ"}, {"rya", "りゃ"}, {"ryu", "りゅ"}, {"ryo", "りょ"},
      {"fa", "ふぁ"},  {"fi", "ふぃ"},  {"fe", "ふぇ"},  {"fo", "ふぉ"},  {"thi", "てぃ"}, {"dhi", "でぃ"},
      {"va", "ゔぁ"},  {"vi", "ゔぃ"},  {"vu", "ゔ"},    {"ve", "ゔぇ"},  {"vo", "ゔぉ"},  {"kwa", "くゎ"},
      {"gwa", "ぐゎ"}, {"xa", "ぁ"},    {"xi", "ぃ"},    {"xu", "ぅ"},    {"xe", "ぇ"},    {"xo", "ぉ"},
      {"xya", "ゃ"},   {"xyu", "ゅ"},   {"xyo", "ょ"},   {"xtu", "っ"},   {"xtsu", "っ"},  {"xwa", "ゎ"},
      {"la", "ぁ"},    {"li", "ぃ"},    {"lu", "ぅ"},    {"le", "ぇ"},    {"lo", "ぉ"},    {"lya", "ゃ"},
      {"lyu", "ゅ"},   {"lyo", "ょ"},   {"ltu", "っ"},   {"ltsu", "っ"},
  });
  std::sort(table.begin(), table.end(),
            [](const Syllable& a, const Syllable& b) { return a.romaji < b.romaji; });
  return table;
}();
constexpr std::size_t kLongestSyllable = 4;
/// Each long vowel doubles the number of spellings; text with more than this is not a word.
constexpr std::size_t kMostSpellings = 64;

bool is_vowel(char c) { return c == 'a' || c == 'i' || c == 'u' || c == 'e' || c == 'o'; }
bool is_consonant(char c) { return c >= 'a' && c <= 'z' && !is_vowel(c); }

/// A vowel with macron or circumflex: the plain vowel, else nothing.
std::optional<char> long_vowel(char32_t c) {
  switch (c) {
    case U'ā':
    case U'â':
    case U'Ā':
    case U'Â':
      return 'a';
    case U'ī':
    case U'î':
    case U'Ī':
    case U'Î':
      return 'i';
    case U'ū':
    case U'û':
    case U'Ū':
    case U'Û':
      return 'u';
    case U'ē':
    case U'ê':
    case U'Ē':
    case U'Ê':
      return 'e';
    case U'ō':
    case U'ô':
    case U'Ō':
    case U'Ô':
      return 'o';
    default:
      return std::nullopt;
  }
}

/// How a long vowel may be written after the syllable that holds the vowel.
std::vector<std::string_view> lengthenings(char vowel) {
  switch (vowel) {
    case 'a':
      return {"あ", "ー"};
    case 'i':
      return {"い", "ー"};
    case 'u':
      return {"う", "ー"};
    case 'e':
      return {"い", "え", "ー"};
    default:
      return {"う", "お", "ー"};
  }
}

/// Lower-case letters, with ':' after each vowel that is long; nothing where the text is not romaji.
std::optional<std::string> letters_of(std::string_view romaji) {
  const auto decoded = base::decode_utf8(romaji);
  if (!decoded || decoded->size() > 64) return std::nullopt;
  std::string out;
  for (char32_t c : *decoded) {
    if (c >= 0xFF01 && c <= 0xFF5E) c -= 0xFEE0;
    if (const auto vowel = long_vowel(c)) {
      out += *vowel;
      out += ':';
    } else if (c >= U'A' && c <= U'Z') {
      out += static_cast<char>(c - U'A' + U'a');
    } else if ((c >= U'a' && c <= U'z') || c == U'\'' || c == U'-') {
      out += static_cast<char>(c);
    } else if (c == U'’') {
      out += '\'';
    } else if (c != U' ' && c != U'.') {
      return std::nullopt;
    }
  }
  return out;
}

const Syllable* syllable_at(std::string_view letters) {
  for (std::size_t n = std::min(kLongestSyllable, letters.size()); n > 0; --n) {
    const auto key = letters.substr(0, n);
    const auto found = std::lower_bound(kSyllables.begin(), kSyllables.end(), key,
                                        [](const Syllable& s, std::string_view k) { return s.romaji < k; });
    if (found != kSyllables.end() && found->romaji == key) return &*found;
  }
  return nullptr;
}

struct Spelling {
  std::vector<std::string> kana;  ///< every spelling of the part that could be read
  std::string_view rest;          ///< letters of an incomplete last syllable
  bool ends_in_n = false;         ///< the last ん was a single n at the very end
};

void append(std::vector<std::string>& spellings, std::string_view kana) {
  for (std::string& s : spellings) s += kana;
}

/// ん where the letters here do not begin a な syllable: the number of letters it takes, or 0.
std::size_t moraic_nasal(std::string_view letters) {
  const char next = letters.size() > 1 ? letters[1] : '\0';
  if (letters[0] == 'm' && (next == 'b' || next == 'p' || next == 'm')) return 1;
  if (letters[0] != 'n' || is_vowel(next) || next == 'y') return 0;
  if (next == '\'') return 2;
  // "nn" is one ん before a consonant and at the end, and ん + な row before a vowel or y.
  if (next == 'n') return letters.size() > 2 && (is_vowel(letters[2]) || letters[2] == 'y') ? 1 : 2;
  return 1;
}

std::optional<Spelling> spell(std::string_view letters) {
  Spelling out{{std::string()}, {}, false};
  char vowel = '\0';
  while (!letters.empty()) {
    const char c = letters.front();
    if (c == ':') {
      std::vector<std::string> longer;
      for (const std::string_view tail : lengthenings(vowel)) {
        for (const std::string& s : out.kana) longer.push_back(s + std::string(tail));
      }
      if (longer.size() > kMostSpellings) return std::nullopt;
      out.kana = std::move(longer);
      letters.remove_prefix(1);
      continue;
    }
    if (c == '-') {
      append(out.kana, "ー");
      letters.remove_prefix(1);
      continue;
    }
    if (const Syllable* syllable = syllable_at(letters)) {
      append(out.kana, syllable->kana);
      vowel = syllable->romaji.back();
      letters.remove_prefix(syllable->romaji.size());
      continue;
    }
    if (const std::size_t n = moraic_nasal(letters); n > 0) {
      append(out.kana, "ん");
      out.ends_in_n = letters == "n";
      letters.remove_prefix(n);
      continue;
    }
    const bool doubled = is_consonant(c) && (letters.substr(1).starts_with(c) || letters.starts_with("tch"));
    if (doubled) {
      append(out.kana, "っ");
      letters.remove_prefix(1);
      continue;
    }
    if (std::all_of(letters.begin(), letters.end(), is_consonant)) {
      out.rest = letters;
      return out;
    }
    return std::nullopt;
  }
  return out;
}

/// Half-width katakana U+FF66..FF9D in order; the voicing marks U+FF9E and U+FF9F belong to the preceding
/// letter.
constexpr std::u32string_view kHalfWidth =
    U"ヲァィゥェォャュョッーアイウエオカキクケコサシスセソタチツテトナニヌネノハヒフヘホマミムメモヤユヨラリ"
    U"ルレロワン";
constexpr std::u32string_view kVoiceable = U"カキクケコサシスセソタチツテトハヒフヘホ";

std::u32string widen_half_width(std::u32string_view text) {
  std::u32string out;
  for (const char32_t c : text) {
    if (c >= 0xFF66 && c <= 0xFF9D) {
      out += kHalfWidth[c - 0xFF66];
    } else if (c == 0xFF9E && !out.empty() && kVoiceable.find(out.back()) != std::u32string_view::npos) {
      out.back() += 1;
    } else if (c == 0xFF9F && !out.empty() && out.back() >= U'ハ' && out.back() <= U'ホ' &&
               kVoiceable.find(out.back()) != std::u32string_view::npos) {
      out.back() += 2;
    } else {
      out += c;
    }
  }
  return out;
}

}  // namespace

std::vector<std::string> romaji_to_hiragana(std::string_view romaji) {
  const auto letters = letters_of(romaji);
  if (!letters || letters->empty()) return {};
  auto spelling = spell(*letters);
  if (!spelling || !spelling->rest.empty()) return {};
  return std::move(spelling->kana);
}

std::vector<std::string> romaji_beginnings(std::string_view romaji) {
  const auto letters = letters_of(romaji);
  if (!letters || letters->empty()) return {};
  const auto spelling = spell(*letters);
  if (!spelling) return {};
  std::vector<std::string> out;
  const auto add_syllables = [&](std::string_view beginning, const std::string& before) {
    for (const auto& [text, kana] : kSyllables) {
      if (!text.starts_with(beginning)) continue;
      std::string whole = before + std::string(kana);
      if (std::find(out.begin(), out.end(), whole) == out.end()) out.push_back(std::move(whole));
    }
  };
  for (const std::string& kana : spelling->kana) {
    if (!spelling->rest.empty()) {
      add_syllables(spelling->rest, kana);
      continue;
    }
    out.push_back(kana);
    constexpr std::size_t kBytesOfN = 3;
    if (spelling->ends_in_n) add_syllables("n", kana.substr(0, kana.size() - kBytesOfN));
  }
  return out;
}

std::string to_hiragana(std::string_view text) {
  const auto decoded = base::decode_utf8(text);
  if (!decoded) return std::string(text);
  std::u32string out = widen_half_width(*decoded);
  for (char32_t& c : out) {
    if (c >= U'ァ' && c <= U'ヶ') c -= U'ァ' - U'ぁ';
  }
  return base::encode_utf8(std::u32string_view(out));
}

std::string fold_reading(std::string_view reading) {
  const auto decoded = base::decode_utf8(to_hiragana(reading));
  if (!decoded) return {};
  std::u32string out;
  for (const char32_t c : *decoded) {
    if (c != U'.' && c != U'．' && c != U'-' && c != U'・' && c != U'･' && c != U' ' && c != U'　') out += c;
  }
  return base::encode_utf8(std::u32string_view(out));
}

}  // namespace nazori::kanji
