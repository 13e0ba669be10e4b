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

TEST(DictationWords, OneInKanaIsAskedForInTheOtherSyllabary) {
  EXPECT_EQ(dictation_words({word("あの", "あの")}, U'あ', any).at(0).prompt(), "アノ");
  EXPECT_EQ(dictation_words({word("ケーキ", "ケーキ")}, U'ケ', any).at(0).prompt(), "けーき");
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
