// SPDX-License-Identifier: Apache-2.0
#include "nazori/model/kana_braille.h"

#include <array>
#include <string>

#include "nazori/base/utf8.h"

namespace nazori::model {
namespace {

constexpr BrailleCell dots(std::initializer_list<int> numbers) {
  unsigned cell = 0;
  for (const int dot : numbers) cell |= 1U << static_cast<unsigned>(dot - 1);
  return static_cast<BrailleCell>(cell);
}

constexpr std::u32string_view kFiftySounds =
    U"あいうえおかきくけこさしすせそたちつてとなにぬねのはひふへほまみむめもらりるれろ";
constexpr std::array<BrailleCell, 5> kVowels{dots({1}), dots({1, 2}), dots({1, 4}), dots({1, 2, 4}),
                                             dots({2, 4})};
constexpr std::array<BrailleCell, 8> kRows{0,         dots({6}),    dots({5, 6}),    dots({3, 5}),
                                           dots({3}), dots({3, 6}), dots({3, 5, 6}), dots({5})};
constexpr std::u32string_view kOthers = U"やゆよわゐゑをんっー";
constexpr std::array<BrailleCell, 10> kOtherCells{
    dots({3, 4}),    dots({3, 4, 6}), dots({3, 4, 5}), dots({3}), dots({2, 3}),
    dots({2, 3, 5}), dots({3, 5}),    dots({3, 5, 6}), dots({2}), dots({2, 5})};
constexpr std::u32string_view kVoiced = U"がぎぐげござじずぜぞだぢづでどばびぶべぼゔ";
constexpr std::u32string_view kUnvoiced = U"かきくけこさしすせそたちつてとはひふへほう";
constexpr std::u32string_view kHalfVoiced = U"ぱぴぷぺぽ";
constexpr std::u32string_view kHalfUnvoiced = U"はひふへほ";
constexpr std::u32string_view kSmallY = U"ゃゅょ";
constexpr std::array<std::size_t, 3> kVowelsOfSmallY{0, 2, 4};
constexpr BrailleCell kVoice = dots({5});
constexpr BrailleCell kHalfVoice = dots({6});
constexpr BrailleCell kGlide = dots({4});
constexpr BrailleCell kJoin = dots({3, 6});
constexpr std::size_t kU = 2;
constexpr std::size_t kO = 4;

char32_t hiragana(char32_t c) { return c >= U'ァ' && c <= U'ヴ' ? c - (U'ァ' - U'ぁ') : c; }

/// A kana without its sound mark, and the cell that stands for the mark.
struct Plain {
  char32_t kana;
  BrailleCell mark;
};
Plain plain(char32_t c) {
  if (const auto at = kVoiced.find(c); at != kVoiced.npos) return {kUnvoiced[at], kVoice};
  if (const auto at = kHalfVoiced.find(c); at != kHalfVoiced.npos) return {kHalfUnvoiced[at], kHalfVoice};
  return {c, 0};
}

/// Whether an う after this kana only makes it longer.
bool ends_in_u_or_o(char32_t c) {
  c = plain(hiragana(c)).kana;
  if (c == U'ゅ' || c == U'ょ' || c == U'ゆ' || c == U'よ') return true;
  const auto at = kFiftySounds.find(c);
  return at != kFiftySounds.npos && (at % 5 == kU || at % 5 == kO);
}

std::optional<std::vector<BrailleCell>> cells_of(std::u32string_view text) {
  std::vector<BrailleCell> cells;
  bool after_digit = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] >= U'0' && text[i] <= U'9') {
      const char digit = static_cast<char>(text[i]);
      // The first of these cells is the sign for numbers.
      const auto number = braille_cells(std::string_view(&digit, 1)).value_or(std::vector<BrailleCell>(2));
      cells.insert(cells.end(), number.begin() + (after_digit ? 1 : 0), number.end());
      after_digit = true;
      continue;
    }
    const auto [kana, mark] = plain(hiragana(text[i]));
    const auto small = i + 1 < text.size() ? kSmallY.find(hiragana(text[i + 1])) : kSmallY.npos;
    const auto sound = kFiftySounds.find(kana);
    const auto other = kOthers.find(kana);
    if (text[i] == U' ' || text[i] == U'　') {
      cells.push_back(0);
    } else if (sound != kFiftySounds.npos) {
      const BrailleCell row = kRows[sound / 5];
      const bool glides = small != kSmallY.npos;
      // A digit's cell is a vowel or one of the row of ra: what follows must not be read as another digit.
      if (after_digit && !glides && mark == 0 && (sound / 5 == 0 || sound / 5 == 7)) cells.push_back(kJoin);
      const auto before = static_cast<BrailleCell>(mark | (glides ? kGlide : 0));
      if (before != 0) cells.push_back(before);
      cells.push_back(static_cast<BrailleCell>(row | kVowels[glides ? kVowelsOfSmallY[small] : sound % 5]));
      if (glides) ++i;
    } else if (other != kOthers.npos) {
      cells.push_back(kOtherCells[other]);
    } else {
      return std::nullopt;
    }
    after_digit = false;
  }
  return cells;
}

}  // namespace

std::optional<std::vector<BrailleCell>> kana_braille(std::string_view text) {
  const auto letters = base::decode_utf8(text);
  return letters ? cells_of(*letters) : std::nullopt;
}

std::optional<std::vector<BrailleCell>> reading_braille(std::string_view reading) {
  const auto letters = base::decode_utf8(reading);
  if (!letters) return std::nullopt;
  std::u32string spelled;
  bool is_stem = true;
  for (const char32_t c : *letters) {
    if (c == U'.') {
      is_stem = false;
    } else if (c != U'-') {
      const bool is_long =
          is_stem && hiragana(c) == U'う' && !spelled.empty() && ends_in_u_or_o(spelled.back());
      spelled += is_long ? U'ー' : c;
    }
  }
  return cells_of(spelled);
}

}  // namespace nazori::model
