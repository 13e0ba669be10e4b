// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/helpful_words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "database_under_test.h"

namespace nazori::practice {
namespace {

using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::Not;

std::vector<std::string> texts(const std::vector<HelpfulWord>& words) {
  std::vector<std::string> all;
  for (const auto& one : words) all.push_back(one.word.text);
  return all;
}

class HelpfulWords : public testing::Test {
 protected:
  [[nodiscard]] CharacterWords words_of(char32_t character) const {
    return words_that_help(database_, *database_.find(character));
  }
  [[nodiscard]] std::vector<std::string> chosen(char32_t character,
                                                const std::function<bool(char32_t)>& knows = {}) const {
    return texts(choose_words(words_of(character).words, character, knows));
  }
  kanji::KanjiDatabase database_ = *kanji::KanjiDatabase::open(test::database());
};

TEST_F(HelpfulWords, OfATreeAreThoseAPupilKnows) {
  const auto tree = chosen(U'木');
  EXPECT_EQ(tree.size(), kMostHelpfulWords);
  EXPECT_EQ(tree.front(), "木");
  EXPECT_THAT(tree, Contains("木曜日"));
  EXPECT_THAT(tree, Contains("大木"));
  EXPECT_THAT(tree, Not(Contains("本木")));
  const auto beginner = chosen(U'木', [](char32_t) { return false; });
  EXPECT_THAT(beginner, Contains("木曜日")) << "also for somebody who knows no other kanji";
  EXPECT_THAT(beginner, Contains("大木"));
}

TEST_F(HelpfulWords, OfVerbsWithDifferentReadingsBothAreChosen) {
  EXPECT_THAT(chosen(U'行'), Contains("行く"));
  EXPECT_THAT(chosen(U'行'), Contains("行う"));
  const auto rest = chosen(U'休');
  EXPECT_THAT(rest, Contains("休む"));
  EXPECT_THAT(rest, Not(Contains("休み"))) << "it is nearly the same";
}

TEST_F(HelpfulWords, AKanjiThatIsAWordAndShortWordsComeFirst) {
  EXPECT_EQ(chosen(U'語').front(), "語");
  EXPECT_EQ(chosen(U'館').front(), "旅館") << "before 大使館 and 図書館";
}

TEST_F(HelpfulWords, OfEachReadingAreCommon) {
  for (const char32_t character : {U'鬱', U'生', U'上', U'繊'})
    for (const auto& use : words_of(character).uses) EXPECT_TRUE(use.word.word.common) << use.word.word.text;
}

TEST_F(HelpfulWords, HaveNoMarksOfTheEditorsAndAtMostThreeMeanings) {
  for (const char32_t character : {U'木', U'生', U'上', U'人', U'鬱', U'あ'})
    for (const auto& word : words_of(character).words) {
      EXPECT_LE(word.meanings.size(), 3U);
      EXPECT_FALSE(word.meanings.empty()) << word.word.text;
      for (const auto& meaning : word.meanings)
        for (const char* mark : {"(uk)", "(abbr)", "(arch)", "(col)", "(P)", "(hon)", "(ksb:)", "(1)"})
          EXPECT_EQ(meaning.find(mark), std::string::npos) << word.word.text << ": " << meaning;
    }
}

TEST_F(HelpfulWords, ShowEachReadingInAWord) {
  const auto uses = words_of(U'人').uses;
  ASSERT_GE(uses.size(), 3U);
  EXPECT_EQ(uses[0].reading, "ジン");
  EXPECT_EQ(uses[0].sound, "じん");
  EXPECT_EQ(uses[1].reading, "ニン");
  EXPECT_EQ(uses[1].sound, "にん");
  EXPECT_NE(uses[1].word.word.text.find("人"), std::string::npos);
  EXPECT_EQ(uses[2].reading, "ひと");
  EXPECT_EQ(uses[2].word.word.text, "人");
  for (const auto& use : uses) EXPECT_TRUE(use.word.word.common) << use.reading;
}

TEST_F(HelpfulWords, AreDividedAmongTheirCharacters) {
  for (const auto& word : words_of(U'休').words)
    if (word.word.text == "休日") {
      ASSERT_EQ(word.pieces.size(), 2U);
      EXPECT_EQ(word.pieces[0].reading, "きゅう");
      EXPECT_EQ(word.pieces[1].reading, "じつ");
      EXPECT_THAT(word.others, ElementsAre(U'日'));
      return;
    }
  FAIL() << "休日 is a word of 休";
}

TEST_F(HelpfulWords, CostWhatSpeaksAgainstThem) {
  struct Case {
    char32_t character;
    const char* text;
    double cost;
    const char* reason;
  };
  // 1.5 for each character; another kanji costs 1, and 3 for each school year by which it comes later.
  for (const Case& one : {
           Case{U'木', "木", 1.5 - 40 - 10 - 4 - 1, "basic, alone, means tree, read as the kanji is"},
           {U'木', "大木", 3 + 1 - 40 - 4, "大 is of the same year; a large tree"},
           {U'木', "木造", 3 + 1 + 3 * 4 - 40 - 4, "造 is of the fifth year; made of wood"},
           {U'木', "木曜日", 4.5 + 1 + 3 + 1 - 40, "曜 is of the second year; no tree"},
           {U'休', "休む", 3 - 40 - 4 - 1, "to take a day off, read as the kanji is"},
           {U'休', "休み", 3 - 40 - 4, "a rest"},
           {U'冊', "冊", 1.5 - 40 - 10 + 8 - 4 - 1, "a counter"},
           {U'鬱', "鬱", 1.5 - 10 + 20 - 4 - 1, "common, not basic, and usually in kana"},
           {U'人', "大人", 3 + 1 - 40 + 4, "no reading of 人 is in おとな"},
           {U'飢', "飢饉", 3 + 25, "饉 has no grade"},
           {U'祈', "祈祷", 3 + 1 + 3 * 2, "names come two years after secondary school"},
           {U'訪', "訪欧", 3 + 1 + 3 - 4, "from the sixth year to secondary school; a visit"},
           {U'蛮', "南蛮", 3 + 1 + 25 + 8, "an old word, and a prefix"},
       }) {
    const auto words = words_of(one.character).words;
    const auto found =
        std::ranges::find_if(words, [&](const auto& word) { return word.word.text == one.text; });
    ASSERT_NE(found, words.end()) << one.text;
    EXPECT_DOUBLE_EQ(found->cost, one.cost) << one.text << ": " << one.reason;
  }
}

TEST_F(HelpfulWords, OfAKanjiWithoutCommonWordsAreWhatThereIs) {
  EXPECT_FALSE(chosen(U'鬱').empty());
  EXPECT_TRUE(words_that_help(database_, kanji::Character{}).words.empty());
}

HelpfulWord word(const std::string& text, double cost, std::vector<char32_t> others = {},
                 const std::string& from = {}) {
  HelpfulWord made;
  made.word.text = text;
  made.word.reading = text + "よみ";
  made.cost = cost;
  made.others = std::move(others);
  if (!from.empty()) made.pieces = {{U'木', from, from}};
  return made;
}

TEST(ChosenWords, TheCheapestComeFirst) {
  EXPECT_THAT(texts(choose_words({word("木", 1), word("大木", 3), word("木本", 2)}, U'木', {})),
              ElementsAre("木", "木本", "大木"));
  EXPECT_THAT(texts(choose_words({word("木", 1), word("大木", 3), word("木本", 2)}, U'木', {}, 2)),
              ElementsAre("木", "木本"));
  EXPECT_THAT(texts(choose_words({}, U'木', {})), ElementsAre());
}

TEST(ChosenWords, ThoseOfKnownKanjiComeBeforeUnknownOnes) {
  const std::vector words{word("木造", 1, {U'造'}), word("大木", 3, {U'大'})};
  const auto knows = [](char32_t c) { return c == U'大'; };
  EXPECT_THAT(texts(choose_words(words, U'木', knows)), ElementsAre("大木", "木造"));
  EXPECT_THAT(texts(choose_words(words, U'木', {})), ElementsAre("木造", "大木"))
      << "nothing is known of the learner";
}

TEST(ChosenWords, AnotherReadingComesBeforeMoreOfTheSame) {
  const std::vector words{word("木", 1, {}, "き"), word("植木", 2, {}, "き"), word("大木", 4, {}, "ボク")};
  EXPECT_THAT(texts(choose_words(words, U'木', {})), ElementsAre("木", "大木", "植木"));
}

TEST(ChosenWords, NearlyTheSameWordComesLate) {
  const std::vector words{word("木曜", 1), word("木曜日", 2), word("大木", 9)};
  EXPECT_THAT(texts(choose_words(words, U'木', {})), ElementsAre("木曜", "大木", "木曜日"));
}

}  // namespace
}  // namespace nazori::practice
