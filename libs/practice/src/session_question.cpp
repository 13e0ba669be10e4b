// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/session_question.h"

#include <string_view>

#include "nazori/base/utf8.h"
#include "nazori/kanji/kun_reading.h"

namespace nazori::practice {
namespace {

constexpr std::size_t kMostMeanings = 4;
constexpr std::size_t kMostGlosses = 3;
constexpr std::size_t kMostReadings = 2;  ///< of each kind
constexpr std::size_t kMostLookalikes = 3;
constexpr std::string_view kGap = "◯";

std::string with_gap(std::string word, const std::string& character) {
  for (auto at = word.find(character); at != std::string::npos; at = word.find(character, at + kGap.size()))
    word.replace(at, character.size(), kGap);
  return word;
}

template <class List>
std::vector<std::string> first_of(const List& list, std::size_t most) {
  std::vector<std::string> found(list.begin(), list.end());
  if (found.size() > most) found.resize(most);
  return found;
}

std::vector<std::string> meanings_of(const kanji::DictionaryEntry& entry) {
  std::vector<std::string> found;
  for (const auto& meaning : entry.meanings)
    if (meaning.language == "en" && found.size() < kMostMeanings) found.push_back(meaning.text);
  return found;
}

std::vector<std::string> readings_of(const kanji::DictionaryEntry& entry) {
  std::vector<std::string> found = first_of(entry.on_readings, kMostReadings);
  const std::size_t most = found.size() + kMostReadings;
  for (const auto& one : entry.kun_readings) {
    const auto reading = kanji::split_kun(one);
    if (!reading.as_suffix && !reading.as_prefix && found.size() < most)
      found.push_back(kanji::kun_text(reading));
  }
  return found;
}

std::vector<char32_t> nearest_lookalikes(char32_t character) {
  auto similar = kanji::similar_kana(character);
  if (similar.size() > kMostLookalikes) similar.resize(kMostLookalikes);
  return similar;
}

}  // namespace

SessionQuestion question_about(const kanji::Character& character) {
  SessionQuestion question;
  question.script = kanji::script_of(character.code_point);
  question.sound = kanji::kana_sound(character.code_point);
  question.strokes = static_cast<int>(character.strokes.size());
  question.meanings = meanings_of(character.entry);
  question.readings = readings_of(character.entry);
  return question;
}

SessionQuestion question_of(const StudySession& session, const CharacterSheet& sheet) {
  const auto& character = sheet.character;
  SessionQuestion question = question_about(character);
  if (const auto* word = session.word(); word != nullptr && session.stage() == study::Stage::memory) {
    question.gap = with_gap(word->text, base::encode_utf8(character.code_point));
    question.reading = question.sound ? kanji::romaji_of(word->reading) : word->reading;
    question.meanings = first_of(word->glosses, kMostGlosses);
    question.readings.clear();
    return question;
  }
  if (!session.asks_from_memory()) {
    question.shown = character.code_point;
    question.lookalikes = nearest_lookalikes(character.code_point);
  }
  return question;
}

}  // namespace nazori::practice
