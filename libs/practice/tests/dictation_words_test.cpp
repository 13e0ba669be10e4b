// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/dictation_words.h"

#include <gtest/gtest.h>

#include "nazori/base/utf8.h"

namespace nazori::practice {
namespace {

kanji::Word word(const char* text, const char* reading) {
  return {text, reading, {"meaning"}, {1}, "n", true};
}

std::vector<std::string> texts(const std::vector<DictationWord>& words) {
  std::vector<std::string> all;
  for (const auto& one : words) all.push_back(one.word.text);
  return all;
}

bool any(char32_t /*character*/) { return true; }

TEST(DictationWords, HaveTwoOrThreeCharactersOneOfThemTheCurrentOne) {
  const std::vector words{word("休", "きゅう"), word("休日", "きゅうじつ"), word("お休み", "おやすみ"),
                          word("夏休みの", "なつやすみの"), word("日本", "にほん")};
  EXPECT_EQ(texts(dictation_words(words, U'休', any)), (std::vector<std::string>{"休日", "お休み"}));
}

TEST(DictationWords, AreLeftOutWhereACharacterHasNoStrokesOrTheWordNoMeaning) {
  auto silent = word("休学", "きゅうがく");
  silent.glosses.clear();
  const std::vector words{word("休日", "きゅうじつ"), silent, word("連休", "れんきゅう")};
  EXPECT_EQ(texts(dictation_words(words, U'休', [](char32_t one) { return one != U'日'; })),
            (std::vector<std::string>{"連休"}));
}

TEST(DictationWords, KnowTheirCharacters) {
  const auto found = dictation_words({word("休日", "きゅうじつ")}, U'日', any);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].characters, (std::vector<char32_t>{U'休', U'日'}));
  EXPECT_EQ(found[0].prompt(), "きゅうじつ");
}

TEST(DictationWords, OneInKanaIsAskedForInRomajiNeverInTheOtherSyllabary) {
  const auto found = dictation_words({word("あの", "あの")}, U'あ', any);
  EXPECT_EQ(found.at(0).prompt(), "ano");
  EXPECT_EQ(found.at(0).spoken(), "あの");
  EXPECT_TRUE(found.at(0).is_in_kana());
  EXPECT_EQ(dictation_words({word("ケーキ", "ケーキ")}, U'ケ', any).at(0).prompt(), "kēki");
  EXPECT_FALSE(dictation_words({word("休み", "やすみ")}, U'休', any).at(0).is_in_kana());
}

TEST(KanaWords, AreTheSyllablesWithASmallKanaThenNounsByTheirReading) {
  auto particle = word("きに", "きに");
  particle.parts_of_speech = "exp,prt";
  auto rare = word("木目", "きめ");
  rare.common = false;
  const std::vector heard{word("秋", "あき"),           particle,          rare, word("空き", "あき"),
                          word("木曜日", "もくようび"), word("駅", "えき")};
  const auto found = kana_words(heard, U'き', any);
  EXPECT_EQ(texts(found), (std::vector<std::string>{"きゃ", "きゅ", "きょ", "あき", "えき"}));
  EXPECT_TRUE(found[0].is_syllable);
  EXPECT_EQ(found[0].prompt(), "kya");
  EXPECT_FALSE(found[3].is_syllable);
  EXPECT_EQ(found[3].prompt(), "aki");
  EXPECT_EQ(found[3].characters, (std::vector<char32_t>{U'あ', U'き'}));
  EXPECT_EQ(found[3].word.glosses.front(), "meaning");
}

TEST(KanaWords, StayInTheSyllabaryAndLeaveOutWhatCannotBeDrawn) {
  const std::vector heard{word("カー", "カー"), word("カに", "カに")};
  EXPECT_EQ(texts(kana_words(heard, U'カ', any)), (std::vector<std::string>{"カー"}));
  EXPECT_EQ(texts(kana_words({}, U'キ', [](char32_t one) { return one != U'ュ'; })),
            (std::vector<std::string>{"キャ", "キョ"}));
}

TEST(KanaWords, ThoseOfKnownKanaComeFirst) {
  const auto words = kana_words({word("秋", "あき"), word("駅", "えき")}, U'き', any);
  const auto knows = [](char32_t one) { return one == U'え' || one == U'ゃ'; };
  EXPECT_EQ(texts(best_known_first(words, U'き', knows)),
            (std::vector<std::string>{"きゃ", "えき", "きゅ", "きょ", "あき"}));
}

TEST(DictationWords, ThoseOfKanjiThatTheLearnerKnowsComeFirstInTheirOldOrder) {
  const auto words =
      dictation_words({word("休日", ""), word("連休", ""), word("休学", ""), word("休み", "")}, U'休', any);
  const auto knows = [](char32_t one) { return one == U'学' || one == U'連'; };
  EXPECT_EQ(texts(best_known_first(words, U'休', knows)),
            (std::vector<std::string>{"連休", "休学", "休み", "休日"}));
  EXPECT_EQ(texts(best_known_first(words, U'休', {})), texts(words)) << "nothing is known of the learner";
}

}  // namespace
}  // namespace nazori::practice
