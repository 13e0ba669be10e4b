// SPDX-License-Identifier: Apache-2.0
// Words in searches, why an answer matches, and the conditions besides the text.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "small_database.h"

namespace nazori::kanji {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class WordSearch : public test::SmallDatabase {
 protected:
  // A smaller id is a commoner word.
  WordSearch() {
    exec(
        "INSERT INTO word VALUES(0, '休日', 'きゅうじつ', 'n', 2, 'holiday/day off'), (1, '休み', 'やすみ', "
        "'n', "
        "1, 'rest' || char(10) || 'holiday'), (2, '急実', 'きゅうじつ', 'n', 1, 'nothing'),"
        "(3, '祭', 'まつり', 'n', 1, 'holiday feast'), (4, '休日出勤', 'きゅうじつしゅっきん', 'n', 0, "
        "'work')");
    exec(
        "INSERT INTO word_key VALUES('休日', 0), ('きゅうじつ', 0), ('休み', 1), ('やすみ', 1), "
        "('きゅうじつ', 2),"
        "('まつり', 3), ('やすみや', 3), ('や', 3), ('休日出勤', 4), ('きゅうじつしゅっきん', 4)");
    exec(
        "INSERT INTO word_meaning_key VALUES('holiday', 0, 0), ('day off', 0, 1), ('off', 0, 2), ('holiday', "
        "1, "
        "1), ('rest', 1, 0), ('holidaymaker', 2, 0), ('holiday feast', 3, 0)");
  }
  [[nodiscard]] std::vector<std::string> words(const std::string& text, int limit = 10) const {
    std::vector<std::string> out;
    for (const WordMatch& match : open().search_words(text, limit))
      out.push_back(match.word.text + (match.whole ? "" : "…") + (match.by_meaning ? " by meaning" : ""));
    return out;
  }
};

TEST_F(WordSearch, FindsAWordByItsTextReadingRomajiAndMeaning) {
  EXPECT_THAT(words("休日"), ElementsAre("休日"));
  EXPECT_THAT(words("きゅうじつ"), ElementsAre("休日", "急実"));
  EXPECT_THAT(words("キュウジツ"), ElementsAre("休日", "急実"));
  EXPECT_THAT(words("kyuujitsu"), ElementsAre("休日", "急実"));
  EXPECT_THAT(words("day off"), ElementsAre("休日 by meaning"));
  EXPECT_THAT(words("to rest"), ElementsAre("休み by meaning"));
  EXPECT_THAT(words("holiday"),
              ElementsAre("休日 by meaning", "休み by meaning", "祭… by meaning", "急実… by meaning"))
      << "the whole first gloss, another gloss, words of a gloss, a beginning";
}

TEST_F(WordSearch, FindsCommonWordsByTheirBeginning) {
  EXPECT_THAT(words("きゅうじ"), ElementsAre("休日…", "急実…")) << "the uncommon one only as a whole";
  EXPECT_THAT(words("やす"), ElementsAre("休み…", "祭…"));
  EXPECT_THAT(words("や"), ElementsAre("祭")) << "one kana begins too many words";
  EXPECT_THAT(words("yas"), ElementsAre("休み…", "祭…")) << "the last syllable is still being typed";
  EXPECT_THAT(words("holi"),
              ElementsAre("休日… by meaning", "休み… by meaning", "急実… by meaning", "祭… by meaning"));
  EXPECT_THAT(words("ho"), IsEmpty()) << "two letters begin too many words";
}

TEST_F(WordSearch, GivesNoMoreThanTheLimit) {
  EXPECT_THAT(words("holiday", 2), ElementsAre("休日 by meaning", "休み by meaning"));
  EXPECT_THAT(words("holiday", 0), IsEmpty());
  EXPECT_THAT(words(""), IsEmpty());
  EXPECT_THAT(words("\xff"), IsEmpty());
}

TEST_F(WordSearch, ReadsRankGlossesAndSenses) {
  const auto found = open().search_words("やすみ", 1);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].word.common);
  EXPECT_FALSE(found[0].word.basic);
  EXPECT_THAT(found[0].word.senses, ElementsAre(1, 2));
  EXPECT_TRUE(open().search_words("きゅうじつ", 1)[0].word.basic);
}

class Matches : public test::SmallDatabase {
 protected:
  [[nodiscard]] std::vector<std::string> reasons(const std::string& text) const {
    Query query;
    query.text = text;
    std::vector<std::string> out;
    for (const Match& match : open().matches(query)) {
      static constexpr const char* kNames[] = {"condition", "itself", "reading", "name", "meaning"};
      out.push_back(std::string(kNames[static_cast<int>(match.reason)]) + " " + match.text +
                    (match.whole ? "" : "…"));
    }
    return out;
  }
};

TEST_F(Matches, SayWhichReadingOrMeaningMatches) {
  add(U'休');
  exec("INSERT INTO reading VALUES(" + std::to_string(static_cast<int>(U'休')) + ", 0, 0, 'キュウ'), (" +
       std::to_string(static_cast<int>(U'休')) + ", 1, 1, 'やす.む'), (" +
       std::to_string(static_cast<int>(U'休')) + ", 2, 2, 'のぶ')");
  exec("INSERT INTO meaning VALUES(" + std::to_string(static_cast<int>(U'休')) + ", 0, 'fr', 'repos'), (" +
       std::to_string(static_cast<int>(U'休')) + ", 1, 'en', 'rest'), (" +
       std::to_string(static_cast<int>(U'休')) + ", 2, 'en', 'day off')");
  exec("INSERT INTO reading_key VALUES('きゅう', 0, 0), ('やすむ', 0, 0), ('やす', 0, 1), ('のぶ', 0, 2)");
  exec("INSERT INTO meaning_key VALUES('rest', 0, 0), ('day off', 0, 1), ('off', 0, 2)");
  EXPECT_THAT(reasons("きゅう"), ElementsAre("reading キュウ"));
  EXPECT_THAT(reasons("yasumu"), ElementsAre("reading やす.む"));
  EXPECT_THAT(reasons("やす"), ElementsAre("reading やす.む"));
  EXPECT_THAT(reasons("やすm"), IsEmpty());
  EXPECT_THAT(reasons("nobu"), ElementsAre("name のぶ…"));
  EXPECT_THAT(reasons("rest"), ElementsAre("meaning rest"));
  EXPECT_THAT(reasons("off"), ElementsAre("meaning day off…"));
  EXPECT_THAT(reasons("da"), ElementsAre("meaning day off…"));
  EXPECT_THAT(reasons("休"), ElementsAre("itself "));
  EXPECT_THAT(reasons(""), ElementsAre("condition …"));
}

class Conditions : public test::SmallDatabase {
 protected:
  Conditions() {
    const auto row = [](int strokes, const char* grade, const char* frequency, const char* level,
                        const char* radical) {
      Row out;
      out.strokes = out.counted = strokes;
      out.grade = grade;
      out.frequency = frequency;
      out.old_jlpt = level;
      out.radical = radical;
      return out;
    };
    add(U'休', row(6, "1", "642", "4", "9"));
    add(U'林', row(8, "1", "656", "3", "75"));
    add(U'鬱', row(29, "8", "NULL", "NULL", "192"));
    const auto code = [](char32_t c) { return std::to_string(static_cast<std::uint32_t>(c)); };
    exec("INSERT INTO code VALUES(" + code(U'休') + ", 0, 'skip', '1-2-4'), (" + code(U'林') +
         ", 0, 'skip', '1-4-4'), (" + code(U'鬱') + ", 0, 'skip', '1-22-4'), (" + code(U'休') +
         ", 1, 'four_corner', '2429.0'), (" + code(U'林') + ", 1, 'four_corner', '4499.0'), (" + code(U'鬱') +
         ", 1, 'deroo', '2429')");
    exec("INSERT INTO radical VALUES(9, '人', 2, 'person')");
    exec("INSERT INTO radical_form VALUES(9, 0, '亻')");
    exec("INSERT INTO element_of VALUES('木', 0), ('木', 1), ('木', 2), ('亻', 0), ('林', 2)");
  }
  template <class Set>
  [[nodiscard]] std::u32string found(Set set) const {
    Query query;
    set(query);
    return characters(open().search(query));
  }
};

TEST_F(Conditions, OfStrokesMayBeARange) {
  EXPECT_EQ(found([](Query& q) { q.strokes = 6; }), U"休");
  EXPECT_EQ(found([](Query& q) { q.strokes = 6, q.most_strokes = 8; }), U"休林");
  EXPECT_EQ(found([](Query& q) { q.strokes = 7, q.most_strokes = 29; }), U"林鬱");
}

TEST_F(Conditions, OfLevelAndFrequencyLeaveOutWhatHasNone) {
  EXPECT_EQ(found([](Query& q) { q.old_jlpt_level = 3; }), U"林");
  EXPECT_EQ(found([](Query& q) { q.frequency = 642; }), U"休");
  EXPECT_EQ(found([](Query& q) { q.frequency = 3000; }), U"休林");
}

TEST_F(Conditions, OfCodesMayBeTheirBeginning) {
  EXPECT_EQ(found([](Query& q) { q.skip = "1-2-4"; }), U"休");
  EXPECT_EQ(found([](Query& q) { q.skip = "1-2"; }), U"休") << "22 does not begin with 2";
  EXPECT_EQ(found([](Query& q) { q.skip = "1-2-"; }), U"休");
  EXPECT_EQ(found([](Query& q) { q.skip = "1-"; }), U"休林鬱");
  EXPECT_EQ(found([](Query& q) { q.skip = "1"; }), U"休林鬱");
  EXPECT_EQ(found([](Query& q) { q.skip = "1-2-"; }), U"休");
  EXPECT_EQ(found([](Query& q) { q.four_corner = "24290"; }), U"休");
  EXPECT_EQ(found([](Query& q) { q.four_corner = "2429.0"; }), U"休");
  EXPECT_EQ(found([](Query& q) { q.four_corner = "2429"; }), U"休") << "another kind of code is not meant";
  EXPECT_EQ(found([](Query& q) { q.four_corner = "2"; }), U"休");
  EXPECT_EQ(found([](Query& q) { q.four_corner = "24291"; }), U"");
}

TEST_F(Conditions, OfPartsMustAllHold) {
  EXPECT_EQ(found([](Query& q) { q.parts = {"木"}; }), U"休林鬱");
  EXPECT_EQ(found([](Query& q) { q.parts = {"木", "亻"}; }), U"休");
  EXPECT_EQ(found([](Query& q) { q.parts = {"林"}; }), U"林鬱") << "a character is a part of itself";
  EXPECT_EQ(found([](Query& q) { q.parts = {"火"}; }), U"");
}

TEST_F(Conditions, OfARadicalTakeAnyForm) {
  EXPECT_EQ(found([](Query& q) { q.radical_form = "亻"; }), U"休");
  EXPECT_EQ(found([](Query& q) { q.radical_form = "木"; }), U"");
  EXPECT_EQ(found([](Query& q) { q.radical_form = "亻", q.radical = 75; }), U"");
  EXPECT_EQ(found([](Query& q) { q.radical_form = "亻", q.radical = 9; }), U"休");
}

TEST_F(Conditions, OfAListLeaveOnlyItsMembers) {
  EXPECT_EQ(found([](Query& q) { q.among = {U'鬱', U'林'}; }), U"林鬱");
  EXPECT_EQ(found([](Query& q) { q.among.emplace(); }), U"");
  EXPECT_EQ(found([](Query& q) { q.among = {U'鬱', U'休'}, q.parts = {"木"}, q.skip = "1-2"; }), U"休");
}

}  // namespace
}  // namespace nazori::kanji
