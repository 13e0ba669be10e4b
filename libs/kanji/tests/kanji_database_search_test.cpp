// SPDX-License-Identifier: Apache-2.0
// Searches of the real kanji.db.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "nazori/base/utf8.h"
#include "published_database.h"

namespace nazori::kanji {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

/// 0-based position of a character among the answers; npos where it is not there.
std::size_t rank(std::string_view text, char32_t c) {
  Query query;
  query.text = text;
  return characters(database().search(query)).find(c);
}

TEST(Search, FindsTheCharacterItselfFirst) {
  for (const char32_t c : {U'休', U'あ', U'ア', U'A', U'3', U'々', U'！', U'ー'}) {
    EXPECT_EQ(rank(base::encode_utf8(c), c), 0U) << base::encode_utf8(c);
  }
}

TEST(Search, FindsEachKanjiOfAWordInItsOrder) {
  Query query;
  query.text = "休日";
  EXPECT_EQ(characters(database().search(query)), U"休日");
  query.text = " お休み ";
  EXPECT_EQ(characters(database().search(query)), U"休");
}

TEST(Search, FindsReadingsInKanaAndRomaji) {
  for (const char* text : {"やす", "やすむ", "やす.む", "ヤスム", "yasu", "yasumu", "きゅう", "キュウ", "ｷｭｳ",
                           "kyuu", "kyū", "kyû", "KYUU", "yasumeru"}) {
    EXPECT_NE(rank(text, U'休'), std::u32string::npos) << text;
  }
  EXPECT_LT(rank("yasu", U'休'), 5U);
  EXPECT_LT(rank("yasumu", U'休'), 2U);
  EXPECT_NE(rank("yas", U'休'), std::u32string::npos) << "while it is typed";
  EXPECT_LT(rank("shi", U'四'), rank("shi", U'静')) << "whole readings come before beginnings";
}

TEST(Search, KanaAreFoundByTheirRomaji) {
  EXPECT_EQ(rank("ka", U'か'), 0U);
  EXPECT_EQ(rank("ka", U'カ'), 1U);
}

TEST(Search, FindsEnglishMeaningsAndTheirBeginnings) {
  EXPECT_EQ(rank("rest", U'休'), 0U);
  EXPECT_EQ(rank("Day off", U'休'), 0U);
  EXPECT_EQ(rank("tree", U'木'), 0U);
  EXPECT_EQ(rank("water", U'水'), 0U);
  EXPECT_NE(rank("retir", U'休'), std::u32string::npos);
  EXPECT_NE(rank("off", U'休'), std::u32string::npos);
  EXPECT_EQ(rank("qqqq", U'休'), std::u32string::npos);
}

TEST(Search, EveryConditionHolds) {
  Query query;
  query.grade = 1;
  query.strokes = 6;
  const auto answers = database().search(query);
  EXPECT_NE(characters(answers).find(U'休'), std::u32string::npos);
  for (const Summary& s : answers) {
    EXPECT_EQ(s.grade, 1);
    EXPECT_EQ(s.strokes, 6);
  }
  query.radical = 9;
  EXPECT_EQ(characters(database().search(query)), U"休");
  query.text = "kyuu";
  EXPECT_EQ(characters(database().search(query)), U"休");
  query.text = "mizu";
  EXPECT_THAT(database().search(query), IsEmpty());
}

TEST(Search, LimitsAndDrawnOnlyHold) {
  Query query;
  query.limit = 20'000;
  EXPECT_THAT(database().search(query), SizeIs(6702));
  query.drawn_only = false;
  EXPECT_GT(database().search(query).size(), 13'108U);
  query.limit = 7;
  EXPECT_THAT(database().search(query), SizeIs(7));
  query.limit = 0;
  EXPECT_THAT(database().search(query), IsEmpty());
}

TEST(Search, TextThatIsNotUtf8FindsNothing) {
  Query query;
  query.text = "\xE4\xBC";
  EXPECT_THAT(database().search(query), IsEmpty());
}

TEST(Search, SummariesSayWhatAListShows) {
  Query query;
  query.text = "休";
  EXPECT_THAT(database().search(query), ElementsAre(Summary{U'休', "rest", "やす.む", 6, 1}));
}

TEST(Containing, FindsCharactersByTheirParts) {
  const auto tree = characters(database().containing("木", 3000));
  EXPECT_NE(tree.find(U'休'), std::u32string::npos);
  EXPECT_EQ(tree.find(U'木'), std::u32string::npos);
  EXPECT_NE(characters(database().containing("人", 3000)).find(U'休'), std::u32string::npos)
      << "亻 stands for 人";
  EXPECT_THAT(database().containing("木", 4), SizeIs(4));
  EXPECT_THAT(database().containing("nothing", 4), IsEmpty());
}

}  // namespace
}  // namespace nazori::kanji
