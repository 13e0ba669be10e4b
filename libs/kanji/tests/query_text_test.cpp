// SPDX-License-Identifier: Apache-2.0
#include "nazori/kanji/query_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace nazori::kanji {
namespace {

using testing::ElementsAre;

TEST(TypedQuery, WithoutConditionsIsTheText) {
  for (const std::string text :
       {"休",           "yasumu",      "day off",    "きゅうじつ", "24",        "1-2",
        "画",           "a画",         "0画",        "201画",      "strokes:x", "strokes:6-5",
        "strokes:6-x",  "radical:215", "radical:0",  "radical:ab", "grade:11",  "jlpt:5",
        "jlpt:0",       "freq:0",      "skip:5-1-1", "skip:x",     "corner:x",  "corner:2429.00",
        "corner:242.9", "other:1",     "other:",     ":",          "1-2-x",     "5-2-3",
        "123456",       "\xff:\xff"}) {
    TypedQuery expected;
    expected.query.text = text;
    EXPECT_EQ(read_query(text), expected) << text;
  }
  EXPECT_EQ(read_query("  day   off "), read_query("day off"));
  EXPECT_EQ(read_query(""), TypedQuery());
}

TEST(TypedQuery, TakesTheNumberOfStrokes) {
  for (const std::string text : {"6画", "６画", "strokes:6", "STROKES:6", "画数:6", "画数：６", "総画:6"}) {
    const auto query = read_query(text).query;
    EXPECT_EQ(query.strokes, 6) << text;
    EXPECT_EQ(query.most_strokes, std::nullopt) << text;
    EXPECT_EQ(query.text, "") << text;
  }
  for (const std::string text : {"6-8画", "6～8画", "strokes:6-8"}) {
    const auto query = read_query(text).query;
    EXPECT_EQ(query.strokes, 6) << text;
    EXPECT_EQ(query.most_strokes, 8) << text;
  }
  EXPECT_EQ(read_query("strokes:200").query.strokes, 200);
  EXPECT_EQ(read_query("strokes:6-6").query.most_strokes, 6);
}

TEST(TypedQuery, LeavesOutAConditionWhoseValueIsStillBeingTyped) {
  for (const std::string text : {"strokes:", "画数：", "radical:", "parts:", "skip:", "corner:", "grade:",
                                 "jlpt:", "freq:", "list:", "tag:"})
    EXPECT_EQ(read_query(text), TypedQuery()) << text;
  EXPECT_EQ(read_query("rest strokes:").query.text, "rest");
}

TEST(TypedQuery, TakesRadicalsAndParts) {
  EXPECT_EQ(read_query("radical:9").query.radical, 9);
  EXPECT_EQ(read_query("部首:214").query.radical, 214);
  EXPECT_EQ(read_query("radical:亻").query.radical_form, "亻");
  EXPECT_THAT(read_query("parts:木日").query.parts, ElementsAre("木", "日"));
  EXPECT_THAT(read_query("パーツ:木、日 part:亻").query.parts, ElementsAre("木", "日", "亻"));
}

TEST(TypedQuery, TakesCodesWithAndWithoutTheirName) {
  for (const std::string text : {"skip:1-2-4", "1-2-4", "１－２－４"})
    EXPECT_EQ(read_query(text).query.skip, "1-2-4") << text;
  EXPECT_EQ(read_query("skip:1-2").query.skip, "1-2");
  EXPECT_EQ(read_query("skip:4").query.skip, "4");
  for (const std::string text : {"2429.0", "24290", "2429"}) {
    EXPECT_EQ(read_query(text).query.four_corner, text);
    EXPECT_EQ(read_query("corner:" + text).query.four_corner, text);
    EXPECT_EQ(read_query("四角:" + text).query.four_corner, text);
  }
  EXPECT_EQ(read_query("corner:24").query.four_corner, "24");
}

TEST(TypedQuery, TakesGradeLevelAndFrequency) {
  const auto query = read_query("grade:3 jlpt:4 freq:500").query;
  EXPECT_EQ(query.grade, 3);
  EXPECT_EQ(query.old_jlpt_level, 4);
  EXPECT_EQ(query.frequency, 500);
  EXPECT_EQ(read_query("学年:10").query.grade, 10);
  EXPECT_EQ(read_query("頻度:1").query.frequency, 1);
  EXPECT_EQ(read_query("freq:99999").query.frequency, 99'999);
  EXPECT_EQ(read_query("freq:100000").query.frequency, std::nullopt);
  EXPECT_EQ(read_query("grade:10").query.grade, 10);
}

TEST(TypedQuery, TakesListsAndTagsAlsoWithBlanksInTheirNames) {
  EXPECT_THAT(read_query("list:exam").lists, ElementsAre("list:exam"));
  EXPECT_THAT(read_query("tag:\"hard ones\" リスト:試験").lists, ElementsAre("tag:hard ones", "list:試験"));
}

TEST(TypedQuery, KeepsTheRestAsText) {
  const auto typed = read_query("6画　rest grade:1 day");
  EXPECT_EQ(typed.query.text, "rest day");
  EXPECT_EQ(typed.query.strokes, 6);
  EXPECT_EQ(typed.query.grade, 1);
}

TEST(TypedQuery, GetsAnotherValueOfACondition) {
  EXPECT_EQ(with_condition("rest parts:木", "parts", "木日"), "rest parts:木日");
  EXPECT_EQ(with_condition("PARTS：木 rest", "parts", ""), "rest");
  EXPECT_EQ(with_condition("", "radical", "9"), "radical:9");
  EXPECT_EQ(with_condition("list:\"my list\" a:b", "radical", "9"), "\"list:my list\" a:b radical:9");
  EXPECT_EQ(read_query("\"list:my list\"").lists, std::vector<std::string>{"list:my list"});
}

TEST(Codes, AreToldByTheirForm) {
  for (const std::string code : {"1", "4-", "1-2", "1-2-", "1-12-34"}) EXPECT_TRUE(is_skip(code)) << code;
  for (const std::string code :
       {"", "-", "0-1-1", "1--2", "1-2-3-", "1-2-3-4", "1 2", "12-1-1", "1-0-1", "1-1-0"})
    EXPECT_FALSE(is_skip(code)) << code;
  for (const std::string code : {"2", "2429", "24290", "2429.", "2429.0"})
    EXPECT_TRUE(is_four_corner(code)) << code;
  for (const std::string code : {"", ".", "2429.01", "242900", "24.0", "24x9", "2429.x", "24290.1"})
    EXPECT_FALSE(is_four_corner(code)) << code;
}

}  // namespace
}  // namespace nazori::kanji
