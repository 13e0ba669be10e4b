// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/confusables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "database_under_test.h"

namespace nazori::practice {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;

class Confusables : public testing::Test {
 protected:
  [[nodiscard]] StrokeContrast contrast(char32_t a, char32_t b) const {
    return contrast_of(*database_.find(a), *database_.find(b));
  }
  kanji::KanjiDatabase database_ = *kanji::KanjiDatabase::open(test::database());
};

TEST_F(Confusables, AreThoseThatLearnersTakeForEachOther) {
  for (const auto& [a, b] :
       {std::pair(U'土', U'士'), {U'未', U'末'}, {U'待', U'持'}, {U'人', U'入'}, {U'ソ', U'ン'}}) {
    EXPECT_THAT(confusables_of(database_, a), Contains(b));
    EXPECT_THAT(confusables_of(database_, b), Contains(a));
  }
  EXPECT_THAT(confusables_of(database_, U'鬱'), IsEmpty());
}

TEST_F(Confusables, AreFewDifferentAndDrawn) {
  for (const auto& one : database_.list(kanji::List::all)) {
    const auto found = confusables_of(database_, one.code_point);
    EXPECT_LE(found.size(), 4U);
    EXPECT_THAT(found, Not(Contains(one.code_point)));
    const auto table = confusables_in_table(one.code_point);
    for (const char32_t other : found) {
      EXPECT_TRUE(database_.draws(other));
      // What only looks alike must be a kanji that a learner meets.
      if (std::find(table.begin(), table.end(), other) == table.end()) {
        EXPECT_TRUE(database_.summary(other)->grade) << static_cast<std::uint32_t>(other);
      }
    }
    auto sorted = found;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(std::adjacent_find(sorted.begin(), sorted.end()), sorted.end());
  }
  EXPECT_EQ(confusables_of(database_, U'待', 1).size(), 1U);
}

TEST_F(Confusables, DifferInTheStrokesThatASchoolbookMarks) {
  EXPECT_THAT(contrast(U'土', U'士').first, ElementsAre(true, false, true)) << "the two bars";
  EXPECT_THAT(contrast(U'未', U'末').first, ElementsAre(true, true, false, false, false));
  const auto wait = contrast(U'待', U'持');
  EXPECT_THAT(wait.first, ElementsAre(true, true, true, false, false, false, false, false, false))
      << "亻 with two strokes more at the left, 寺 is the same";
  EXPECT_THAT(wait.second, ElementsAre(true, true, true, false, false, false, false, false, false));
}

TEST_F(Confusables, AnExtraStrokeIsADifference) {
  const auto dog = contrast(U'大', U'犬');
  EXPECT_THAT(dog.first, ElementsAre(false, false, false));
  EXPECT_THAT(dog.second, ElementsAre(false, false, false, true));
  const auto same = contrast(U'大', U'大');
  EXPECT_THAT(same.first, ElementsAre(false, false, false));
  EXPECT_THAT(contrast_of({}, {}).first, IsEmpty());
}

TEST_F(Confusables, FactsAreMeaningReadingAndWords) {
  const auto facts = confusable_facts(database_, U'待');
  EXPECT_EQ(facts.meaning, "wait");
  EXPECT_EQ(facts.reading, "ま.つ");
  EXPECT_FALSE(facts.words.empty());
}

ConfusableFacts facts(char32_t character, const std::string& meaning, std::vector<kanji::Word> words) {
  return {character, meaning, "よみ", std::move(words)};
}

std::vector<ConfusableFacts> wait_and_hold() {
  return {facts(U'待', "wait",
                {{"待つ", "まつ", {}, {}, "", true},
                 {"待", "まち", {}, {}, "", true},
                 {"期待", "きたい", {}, {}, "", true},
                 {"招待", "しょうたい", {}, {}, "", true}}),
          facts(U'持', "hold", {{"待持", "x", {}, {}, "", true}, {"持つ", "もつ", {}, {}, "", true}})};
}

TEST(ConfusableDrill, AsksThreeTimesForEachAlsoByWordsWithAGap) {
  ConfusableDrill drill(wait_and_hold(), 1);
  EXPECT_EQ(drill.total(), 6);
  std::map<char32_t, int> asked;
  std::vector<std::string> gaps;
  while (const auto* question = drill.question()) {
    ++asked[question->answer];
    if (!question->gap.empty()) gaps.push_back(question->gap);
    EXPECT_EQ(question->meaning, question->answer == U'待' ? "wait" : "hold");
    EXPECT_TRUE(drill.answer(question->answer));
  }
  EXPECT_EQ(asked, (std::map<char32_t, int>{{U'待', 3}, {U'持', 3}}));
  EXPECT_THAT(gaps, testing::UnorderedElementsAre("◯つ", "期◯", "◯つ"))
      << "not the character alone, and not a word with both";
  EXPECT_EQ(drill.right(), 6);
  EXPECT_FALSE(drill.answer(U'待')) << "it is over";
  EXPECT_EQ(drill.asked(), 6);
}

TEST(ConfusableDrill, WhatWasWrongComesOnceMore) {
  ConfusableDrill drill(wait_and_hold(), 1);
  const auto first = *drill.question();
  EXPECT_FALSE(drill.answer(first.answer == U'待' ? U'持' : U'待'));
  EXPECT_EQ(drill.total(), 7);
  for (int i = 0; i < 5; ++i) drill.answer(drill.question()->answer);
  ASSERT_NE(drill.question(), nullptr);
  EXPECT_EQ(*drill.question(), first);
  EXPECT_FALSE(drill.answer(0));
  EXPECT_EQ(drill.question(), nullptr) << "not a third time";
  EXPECT_EQ(drill.right(), 5);
}

TEST(ConfusableDrill, TheSeedDecidesTheOrder) {
  const auto order = [](unsigned seed) {
    std::string answers;
    ConfusableDrill drill(wait_and_hold(), seed);
    while (const auto* question = drill.question()) {
      answers += question->answer == U'待' ? "w" : "h";
      answers += question->gap;
      drill.answer(question->answer);
    }
    return answers;
  };
  EXPECT_EQ(order(1), order(1));
  EXPECT_TRUE(order(1) != order(2) || order(2) != order(3));
}

}  // namespace
}  // namespace nazori::practice
