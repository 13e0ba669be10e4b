// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/dictation_words.h"

#include <algorithm>
#include <sstream>

#include "nazori/base/utf8.h"
#include "nazori/kanji/kana.h"
#include "nazori/kanji/kana_sound.h"

namespace nazori::practice {
namespace {

bool is_kana(char32_t character) {
  const auto script = kanji::script_of(character);
  return script == kanji::Script::hiragana || script == kanji::Script::katakana;
}

/// Nouns are what a beginner's first words are; particles and interjections are also in the lists.
bool is_noun(const kanji::Word& word) {
  std::istringstream marks(word.parts_of_speech);
  for (std::string mark; std::getline(marks, mark, ',');)
    if (mark == "n") return true;
  return false;
}

}  // namespace

bool DictationWord::is_in_kana() const { return std::all_of(characters.begin(), characters.end(), is_kana); }

std::string DictationWord::prompt() const {
  // The reading of a word in kana is the word itself, and its other syllabary would be a second question.
  return is_in_kana() ? kanji::romaji_of(word.text) : word.reading;
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
    if (std::all_of(characters.begin(), characters.end(), draws)) found.push_back({word, characters, false});
  }
  return found;
}

std::vector<DictationWord> kana_words(const std::vector<kanji::Word>& heard, char32_t kana,
                                      const std::function<bool(char32_t)>& draws) {
  std::vector<DictationWord> found;
  const auto add = [&](kanji::Word word, bool is_syllable) {
    const auto text = base::decode_utf8(word.text);
    if (!text || text->size() < kFewestDictated || text->size() > kMostDictated) return;
    DictationWord one{std::move(word), {text->begin(), text->end()}, is_syllable};
    const bool is_own = std::all_of(one.characters.begin(), one.characters.end(), [&](char32_t c) {
      return c == U'ー' || (is_kana(c) && kanji::script_of(c) == kanji::script_of(kana));
    });
    const bool is_new = std::none_of(found.begin(), found.end(), [&](const DictationWord& other) {
      return other.word.text == one.word.text;
    });
    if (is_own && is_new && std::all_of(one.characters.begin(), one.characters.end(), draws))
      found.push_back(std::move(one));
  };
  for (const auto& syllable : kanji::combinations_with(kana)) {
    kanji::Word word;
    word.text = word.reading = syllable;
    add(std::move(word), true);
  }
  for (const auto& word : heard) {
    if (!word.common || word.glosses.empty() || !is_noun(word)) continue;
    kanji::Word in_kana = word;
    in_kana.text = word.reading;
    add(std::move(in_kana), false);
  }
  return found;
}

std::vector<DictationWord> best_known_first(std::vector<DictationWord> words, char32_t character,
                                            const std::function<bool(char32_t)>& knows) {
  if (!knows) return words;
  const auto unknown = [&](const DictationWord& word) {
    return std::count_if(word.characters.begin(), word.characters.end(), [&](char32_t one) {
      const bool counts = is_kana(character) || !is_kana(one);
      return one != character && counts && !knows(one);
    });
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
