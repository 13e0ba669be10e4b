// SPDX-License-Identifier: Apache-2.0
#include "learning_order.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include "basic_words.h"
#include "nazori/base/utf8.h"

namespace nazori::ingest {
namespace {

using kanji::CharacterKind;

constexpr std::u32string_view kKanaOrder =
    U"あいうえおかきくけこさしすせそたちつてとなにぬねのはひふへほまみむめもやゆよらりるれろわをん"
    U"がぎぐげござじずぜぞだぢづでどばびぶべぼぱぴぷぺぽぁぃぅぇぉっゃゅょゎゐゑゔゕゖ";

constexpr int kNoFrequency = 2502;  ///< KANJIDIC2 ranks 2,501 kanji
constexpr int kNoGrade = 99;

/// Position in the table of sounds; characters not in it come after it.
int kana_position(char32_t c) {
  constexpr char32_t kKatakanaToHiragana = U'ア' - U'あ';
  if (c >= U'ァ' && c <= U'ヶ') c -= kKatakanaToHiragana;
  const auto at = kKanaOrder.find(c);
  return static_cast<int>(at == std::u32string_view::npos ? kKanaOrder.size() : at);
}

}  // namespace

CharacterKind kind_of(char32_t c) {
  if (c >= 0x3041 && c <= 0x3096) return CharacterKind::hiragana;
  if ((c >= 0x30A1 && c <= 0x30FA) || c == 0x30FC) return CharacterKind::katakana;
  if ((c >= U'0' && c <= U'9') || (c >= U'A' && c <= U'Z') || (c >= U'a' && c <= U'z'))
    return CharacterKind::latin;
  const bool ideograph = (c >= 0x2E80 && c <= 0x2FDF) || (c >= 0x3005 && c <= 0x3007) ||
                         (c >= 0x3400 && c <= 0x9FFF) || (c >= 0xF900 && c <= 0xFAFF) ||
                         (c >= 0x20000 && c <= 0x3FFFF);
  return ideograph ? CharacterKind::ideograph : CharacterKind::other;
}

std::vector<char32_t> learning_order(const std::set<char32_t>& drawn,
                                     const std::map<char32_t, kanji::DictionaryEntry>& dictionary) {
  using Place = std::tuple<int, int, int, char32_t>;
  std::vector<Place> places;
  const auto add = [&](char32_t c, bool is_drawn) {
    const auto entry = dictionary.find(c);
    int frequency = kNoFrequency;
    int grade = kNoGrade;
    if (entry != dictionary.end()) {
      frequency = entry->second.frequency.value_or(kNoFrequency);
      grade = entry->second.grade.value_or(kNoGrade);
    }
    if (!is_drawn) {
      places.emplace_back(5, frequency, grade, c);
      return;
    }
    switch (kind_of(c)) {
      case CharacterKind::hiragana:
        places.emplace_back(0, kana_position(c), 0, c);
        break;
      case CharacterKind::katakana:
        places.emplace_back(1, kana_position(c), 0, c);
        break;
      case CharacterKind::latin:
        places.emplace_back(2, 0, 0, c);
        break;
      case CharacterKind::ideograph:
        places.emplace_back(3, frequency, grade, c);
        break;
      case CharacterKind::other:
        places.emplace_back(4, 0, 0, c);
        break;
    }
  };
  for (const char32_t c : drawn) add(c, true);
  for (const auto& [c, entry] : dictionary) {
    if (!drawn.contains(c)) add(c, false);
  }
  std::sort(places.begin(), places.end());
  std::vector<char32_t> out;
  out.reserve(places.size());
  for (const Place& place : places) out.push_back(std::get<3>(place));
  return out;
}

WordPlace place_of_word(const EdictEntry& word,
                        const std::map<char32_t, kanji::DictionaryEntry>& dictionary) {
  constexpr auto kUnusual = std::to_array<std::string_view>(
      {"(arch)", "(obs)", "(obsc)", "(rare)", "(ok)", "(oK)", "(ik)", "(iK)", "(io)", "(X)"});
  WordPlace place;
  place.advanced = !is_basic(word);
  place.uncommon = !word.common;
  const std::string& gloss = word.senses.front().front();
  place.unusual = std::any_of(kUnusual.begin(), kUnusual.end(),
                              [&](std::string_view mark) { return gloss.find(mark) != std::string::npos; });
  const std::u32string text = base::decode_utf8(word.text).value_or(std::u32string());
  for (const char32_t c : text) {
    const bool hiragana = kind_of(c) == CharacterKind::hiragana;
    place.length += hiragana ? 1 : 2;
    const auto entry = dictionary.find(c);
    if (entry != dictionary.end()) {
      place.frequency_sum += entry->second.frequency.value_or(kNoFrequency);
    } else if (!hiragana) {
      place.frequency_sum += kNoFrequency;
    }
  }
  return place;
}

}  // namespace nazori::ingest
