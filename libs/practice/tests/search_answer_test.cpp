// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/search_answer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "database_under_test.h"
#include "learner_under_test.h"
#include "nazori/base/utf8.h"

namespace nazori::practice {
namespace {

using testing::Contains;
using testing::ElementsAre;

class Searched : public LearnerTest {
 protected:
  [[nodiscard]] SearchAnswer search(const std::string& typed) {
    const auto query = kanji::read_query(typed);
    auto among = members_of(query, *learner_);
    EXPECT_TRUE(among);
    return search_answer(*learner_->database(), query, among.value_or(std::nullopt));
  }
  static std::string text_of(const SearchRow& row) {
    return row.word ? row.word->text : base::encode_utf8(row.character.code_point);
  }
  [[nodiscard]] std::vector<std::string> rows(const std::string& typed) {
    std::vector<std::string> out;
    for (const auto& row : search(typed).rows) out.push_back(text_of(row));
    return out;
  }
};

TEST_F(Searched, AWordIsFoundByReadingRomajiAndMeaning) {
  for (const std::string typed : {"きゅうじつ", "kyuujitsu", "キュウジツ", "holiday", "休日"})
    EXPECT_THAT(rows(typed), Contains("休日")) << typed;
  const auto answer = search("きゅうじつ");
  ASSERT_FALSE(answer.rows.empty());
  const auto& row = answer.rows.front();
  ASSERT_TRUE(row.word);
  EXPECT_EQ(row.word->reading, "きゅうじつ");
  EXPECT_THAT(row.word->meanings, Contains("holiday"));
  EXPECT_EQ(row.character.code_point, U'休') << "it leads to its first kanji";
}

TEST_F(Searched, AWordBeginsWithTheMeaningThatWasSearchedFor) {
  for (const auto& row : search("holiday").rows)
    if (row.word) {
      EXPECT_NE(row.word->meanings.front().find("holiday"), std::string::npos) << row.word->text;
    }
}

TEST_F(Searched, ATypedWordComesBeforeItsCharacters) {
  const auto found = rows("休日");
  ASSERT_GE(found.size(), 3U);
  EXPECT_EQ(found[0], "休日");
  EXPECT_THAT(found, Contains("休"));
  EXPECT_THAT(found, Contains("日"));
  EXPECT_EQ(rows("休み").front(), "休み");
  EXPECT_EQ(rows("休").front(), "休") << "a character is itself";
  EXPECT_EQ(rows("き").front(), "き");
}

TEST_F(Searched, CharactersThatMatchAsAWholeComeBeforeWords) {
  const auto found = rows("rest");
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.front(), "休");
  const auto answer = search("yasumu");
  EXPECT_EQ(answer.rows.front().reason, kanji::Reason::reading);
  EXPECT_EQ(answer.rows.front().text, "やす.む");
}

TEST_F(Searched, WordsAreLeftOutWhereThereAreOtherConditions) {
  for (const auto& row : search("rest strokes:6").rows) {
    EXPECT_FALSE(row.word);
    EXPECT_EQ(row.character.strokes, 6);
  }
  const auto answer = search("6画 grade:1");
  EXPECT_EQ(static_cast<std::size_t>(answer.characters), answer.rows.size());
  EXPECT_THAT(rows("6画 grade:1 radical:亻"), ElementsAre("休"));
}

TEST_F(Searched, CodesOfThePublishedDictionaryFindTheirKanji) {
  // KANJIDIC2 (EDRDG, CC BY-SA 4.0): 休 has SKIP 1-2-4 and the four-corner code 2429.0.
  EXPECT_THAT(rows("1-2-4"), Contains("休"));
  EXPECT_THAT(rows("24290"), Contains("休"));
  EXPECT_THAT(rows("parts:亻木"), Contains("休"));
  EXPECT_THAT(rows("jlpt:4 grade:1"), Contains("休"));
}

TEST_F(Searched, ListsAndTagsOfTheLearnerAreConditions) {
  ASSERT_TRUE(learner_->store().save_list({"exam", {U'木', U'休', U'林'}}));
  const std::vector<std::string> tags{"hard"};
  ASSERT_TRUE(learner_->store().set_tags(U'休', tags));
  EXPECT_THAT(rows("list:exam"), testing::UnorderedElementsAre("木", "休", "林"));
  EXPECT_THAT(rows("tag:hard"), ElementsAre("休"));
  EXPECT_THAT(rows("list:exam tag:hard"), ElementsAre("休"));
  EXPECT_THAT(rows("list:exam 8画"), ElementsAre("林"));
  const auto missing = members_of(kanji::read_query("list:none"), *learner_);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, base::Errc::not_found);
  EXPECT_FALSE(members_of(kanji::read_query("rest"), *learner_)->has_value());
}

TEST_F(Searched, NothingIsFoundForNonsense) { EXPECT_TRUE(rows("xyzzyplugh").empty()); }

}  // namespace
}  // namespace nazori::practice
