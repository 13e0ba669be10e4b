// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/practice_speech.h"

#include "nazori/base/utf8.h"
#include "nazori/kanji/kana_sound.h"
#include "nazori/kanji/kun_reading.h"
#include "nazori/practice/dictation_stage.h"

namespace nazori::practice {

std::string reading_to_speak(const CharacterSheet& sheet) {
  const auto& character = sheet.character;
  if (kanji::kana_sound(character.code_point)) return base::encode_utf8(character.code_point);
  const auto& entry = character.entry;
  std::string spoken = entry.on_readings.empty() ? std::string() : entry.on_readings.front();
  for (const auto& one : entry.kun_readings) {
    const auto kun = kanji::split_kun(one);
    if (kun.as_prefix || kun.as_suffix) continue;
    if (!spoken.empty()) spoken += "、";
    spoken += kun.stem + kun.okurigana;
    break;
  }
  return spoken;
}

PracticeSpeech::PracticeSpeech(CharacterPractice& practice, const StudySession& session)
    : practice_(practice), session_(session) {
  connections_.emplace_back(practice.feedback.connect(
      [this](const PracticeStage& stage, const StageFeedback& what) { follow(stage, what); }));
  connections_.emplace_back(practice.character_shown.connect([this](char32_t character) {
    // From memory the stage itself asks.
    if (asks_kana() && session_.character() == character && !session_.asks_from_memory())
      say(Cause::question);
  }));
  connections_.emplace_back(practice.get<DictationStage>().speech_wanted.connect(
      [this](const std::string& kana) { wanted(kana, Cause::wanted); }));
}

bool PracticeSpeech::asks_kana() const {
  return session_.is_running() && !session_.is_away() && kanji::kana_sound(session_.character()).has_value();
}

std::string PracticeSpeech::reading() const {
  if (practice_.current_stage().id() == DictationStage::kId) {
    const auto* word = practice_.get<DictationStage>().word();
    if (word != nullptr) return word->spoken();
  }
  const auto& sheet = practice_.sheet();
  if (!sheet) return {};
  const bool is_asked =
      session_.is_running() && !session_.is_away() && session_.stage() == study::Stage::memory;
  if (is_asked && session_.word() != nullptr) return session_.word()->reading;
  return reading_to_speak(*sheet);
}

void PracticeSpeech::say(Cause cause) {
  if (const std::string kana = reading(); !kana.empty()) wanted(kana, cause);
}

bool PracticeSpeech::speak() {
  const bool is_any = !reading().empty();
  if (practice_.current_stage().id() == DictationStage::kId && is_any) {
    // It also shows the question again.
    practice_.get<DictationStage>().speak();
    return true;
  }
  say(Cause::wanted);
  return is_any;
}

void PracticeSpeech::follow(const PracticeStage& stage, const StageFeedback& what) {
  if (what.event == StageEvent::judged || what.event == StageEvent::answer_shown) {
    // In a dictation the answer is the whole word.
    if (stage.id() != DictationStage::kId) say(Cause::answer);
  } else if (what.event == StageEvent::write_character && asks_kana()) {
    say(Cause::question);
  } else if (what.own == DictationStage::kWordAsked) {
    say(Cause::question);
  } else if (what.own == DictationStage::kWordJudged) {
    say(Cause::answer);
  }
}

}  // namespace nazori::practice
