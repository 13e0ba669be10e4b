// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/session_question.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "nazori/base/utf8.h"
#include "nazori/kanji/kun_reading.h"

namespace nazori::practice {
namespace {

constexpr std::size_t kMostMeanings = 4;
constexpr std::size_t kMostGlosses = 3;
constexpr std::size_t kMostReadings = 2;  ///< of each kind
constexpr std::size_t kMostLookalikes = 3;
constexpr std::size_t kLongestWord = 5;  ///< characters of a word beside the question
constexpr std::string_view kRepeats = "々";
constexpr double kFull_em = 36;
constexpr double kLines_em = 30;

std::size_t times_in(const std::string& text, const std::string& part) {
  std::size_t times = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++times;
  return times;
}

std::string with_gap(std::string word, const std::string& character) {
  constexpr std::string_view kGap = SessionQuestion::kGap;
  for (auto at = word.find(character); at != std::string::npos; at = word.find(character, at + kGap.size()))
    word.replace(at, character.size(), kGap);
  return word;
}

/// The first of a list, without those that contain `secret`. @param secret  empty: nothing is secret.
template <class List>
std::vector<std::string> first_of(const List& list, std::size_t most, const std::string& secret) {
  std::vector<std::string> found;
  for (const std::string& one : list)
    if (found.size() < most && (secret.empty() || one.find(secret) == std::string::npos))
      found.push_back(one);
  return found;
}

std::vector<std::string> meanings_of(const kanji::DictionaryEntry& entry, const std::string& secret) {
  std::vector<std::string> all;
  for (const auto& meaning : entry.meanings)
    if (meaning.language == "en") all.push_back(meaning.text);
  return first_of(all, kMostMeanings, secret);
}

std::vector<std::string> readings_of(const kanji::DictionaryEntry& entry, const std::string& secret) {
  std::vector<std::string> found = first_of(entry.on_readings, kMostReadings, secret);
  std::vector<std::string> kun;
  for (const auto& one : entry.kun_readings) {
    const auto reading = kanji::split_kun(one);
    if (!reading.as_suffix && !reading.as_prefix) kun.push_back(kanji::kun_text(reading));
  }
  for (auto& one : first_of(kun, kMostReadings, secret)) found.push_back(std::move(one));
  return found;
}

std::vector<char32_t> nearest_lookalikes(char32_t character) {
  auto similar = kanji::similar_kana(character);
  if (similar.size() > kMostLookalikes) similar.resize(kMostLookalikes);
  return similar;
}

/// A short word that has the character once, and others beside it.
bool asks_well(const HelpfulWord& word, const std::string& own) {
  const std::string& text = word.word.text;
  const auto letters = base::decode_utf8(text);
  return letters && letters->size() > 1 && letters->size() <= kLongestWord && times_in(text, own) == 1 &&
         text.find(kRepeats) == std::string::npos && word.word.reading.find(own) == std::string::npos;
}

std::optional<QuestionWord> helpful_word(const StudySession& session, const CharacterSheet& sheet,
                                         const std::string& own) {
  const auto knows = [&session](char32_t c) { return session.knows(c); };
  const bool is_shown = !session.asks_from_memory();
  auto words = choose_words(sheet.helpful.words, sheet.character.code_point, knows, kMostHelpfulWords);
  // A word with another kanji says more than the kun reading, which is part of the question already.
  std::stable_partition(words.begin(), words.end(),
                        [](const HelpfulWord& one) { return !one.others.empty(); });
  for (const auto& one : words) {
    if (!asks_well(one, own)) continue;
    QuestionWord word;
    word.meanings = first_of(one.meanings, 1, is_shown ? std::string() : own);
    if (word.meanings.empty()) continue;
    word.text = is_shown ? one.word.text : with_gap(one.word.text, own);
    word.reading = one.word.reading;
    const bool is_known = !one.others.empty() && std::all_of(one.others.begin(), one.others.end(), knows);
    word.reason = is_known ? WordReason::known : WordReason::helps;
    return word;
  }
  return std::nullopt;
}

/// What the character is, without a word about how it is asked for.
SessionQuestion facts_of(const kanji::Character& character) {
  SessionQuestion question;
  question.script = kanji::script_of(character.code_point);
  question.sound = kanji::kana_sound(character.code_point);
  question.strokes = static_cast<int>(character.strokes.size());
  return question;
}

/// Meanings and readings without `secret`, and how the question then asks.
void ask_about(const kanji::Character& character, const std::string& secret, SessionQuestion& question) {
  question.meanings = meanings_of(character.entry, secret);
  question.readings = readings_of(character.entry, secret);
  if (secret.empty())
    question.prompt = Prompt::character;
  else if (question.sound)
    question.prompt = Prompt::sound;
  else if (!question.meanings.empty() || !question.readings.empty())
    question.prompt = Prompt::meaning;
}

}  // namespace

SessionQuestion question_about(const kanji::Character& character) {
  SessionQuestion question = facts_of(character);
  ask_about(character, base::encode_utf8(character.code_point), question);
  return question;
}

SessionQuestion question_of(const StudySession& session, const CharacterSheet& sheet) {
  const auto& character = sheet.character;
  const std::string own = base::encode_utf8(character.code_point);
  const bool is_secret = session.asks_from_memory();
  const std::string secret = is_secret ? own : std::string();
  SessionQuestion question = facts_of(character);
  if (!is_secret) {
    question.shown = character.code_point;
    question.lookalikes = nearest_lookalikes(character.code_point);
  }
  if (const auto* word = session.word(); word != nullptr && session.stage() == study::Stage::memory) {
    QuestionWord asked;
    asked.text = is_secret ? with_gap(word->text, own) : word->text;
    asked.reading = question.sound ? kanji::romaji_of(word->reading) : word->reading;
    asked.meanings = first_of(word->glosses, kMostGlosses, secret);
    asked.reason = WordReason::asked;
    question.word = std::move(asked);
    question.prompt = is_secret ? Prompt::word : Prompt::character;
    return question;
  }
  ask_about(character, secret, question);
  if (!question.sound) question.word = helpful_word(session, sheet, own);
  if (question.prompt == Prompt::strokes && question.word) question.prompt = Prompt::word;
  return question;
}

QuestionRoom room_for_question(double height_em) {
  if (height_em >= kFull_em) return QuestionRoom::full;
  return height_em >= kLines_em ? QuestionRoom::lines : QuestionRoom::line;
}

SessionQuestion shortened(SessionQuestion question, QuestionRoom room) {
  const auto keep = [](auto& list, std::size_t most) {
    if (list.size() > most) list.resize(most);
  };
  if (room == QuestionRoom::full) return question;
  const bool is_one_line = room == QuestionRoom::line;
  keep(question.meanings, is_one_line ? 1 : 2);
  keep(question.lookalikes, is_one_line ? 1 : 3);
  // A kun reading says more than an on reading: it stands for the meaning in a sentence.
  if (is_one_line && question.readings.size() > 1)
    question.readings = {question.readings.back()};
  else
    keep(question.readings, 3);
  if (question.word) keep(question.word->meanings, 1);
  if (is_one_line && question.prompt != Prompt::word) question.word.reset();
  return question;
}

}  // namespace nazori::practice
