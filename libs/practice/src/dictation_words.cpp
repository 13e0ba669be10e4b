// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/dictation_words.h"

#include <algorithm>

#include "nazori/base/utf8.h"
#include "nazori/kanji/kana.h"

namespace nazori::practice {
namespace {

bool is_kana(char32_t character) {
  const auto script = kanji::script_of(character);
  return script == kanji::Script::hiragana || script == kanji::Script::katakana;
}

}  // namespace

std::string DictationWord::prompt() const {
  // The reading of a word in kana is the word itself.
  if (!std::all_of(characters.begin(), characters.end(), is_kana)) return word.reading;
  std::string other;
  for (const char32_t kana : characters) {
    const char32_t in_other = kanji::in_other_syllabary(kana);
    other += base::encode_utf8(in_other != 0 ? in_other : kana);
  }
  return other;
}

std::vector<DictationWord> dictation_words(const std::vector<kanji::Word>& words, char32_t character,
                                           const std::function<bool(char32_t)>& draws) {
  std::vector<DictationWord> found;
  for (const auto& word : words) {
    const auto text = base::decode_utf8(word.text);
    if (!text || text->size() < kFewestDictated || text->size() > kMostDictated || word.glosses.empty())
      continue;
    const std::vector<char32_t> characters(text->begin(), text->end());
    if (std::find(characters.begin(), characters.end(), character) == characters.end()) continue;
    if (std::all_of(characters.begin(), characters.end(), draws)) found.push_back({word, characters});
  }
  return found;
}

std::vector<DictationWord> best_known_first(std::vector<DictationWord> words, char32_t character,
                                            const std::function<bool(char32_t)>& knows) {
  if (!knows) return words;
  const auto unknown = [&](const DictationWord& word) {
    return std::count_if(word.characters.begin(), word.characters.end(),
                         [&](char32_t one) { return one != character && !is_kana(one) && !knows(one); });
  };
  std::vector<std::pair<std::ptrdiff_t, DictationWord>> counted;
  counted.reserve(words.size());
  for (auto& word : words) {
    const auto count = unknown(word);
    counted.emplace_back(count, std::move(word));
  }
  std::stable_sort(counted.begin(), counted.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  words.clear();
  for (auto& [count, word] : counted) words.push_back(std::move(word));
  return words;
}

}  // namespace nazori::practice
