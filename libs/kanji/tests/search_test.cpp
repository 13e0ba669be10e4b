// SPDX-License-Identifier: Apache-2.0
// What a search finds in a database of a few rows, and in which order.
#include <gtest/gtest.h>

#include <string>

#include "nazori/base/utf8.h"
#include "small_database.h"

namespace nazori::kanji {
namespace {

class SmallSearch : public test::SmallDatabase {
 protected:
  [[nodiscard]] std::u32string found(const std::string& text) const {
    Query query;
    query.text = text;
    return characters(open().search(query));
  }
  [[nodiscard]] std::u32string found(const std::u32string& text) const {
    return found(base::encode_utf8(std::u32string_view(text)));
  }
};

TEST_F(SmallSearch, TheBetterFitComesFirstAndAmongEqualsTheCommoner) {
  // Common characters match worse here, so that only the match decides the order.
  for (const char32_t c : std::u32string(U"一二三四五六七八")) add(c);
  exec(
      "INSERT INTO reading_key VALUES('ねこみ', 0, 0), ('ねこあ', 1, 0), ('ねこ', 2, 2), ('ねこ', 3, 2),"
      "('ねこ', 4, 1), ('ねこ', 5, 0), ('ねこ', 6, 0), ('ねごと', 7, 0), ('ねけ', 7, 0)");
  EXPECT_EQ(found("ねこ"), U"六七五三四一二");
  EXPECT_EQ(found("neko"), U"六七五三四一二");
  EXPECT_EQ(found("ネコ"), U"六七五三四一二");
  EXPECT_EQ(found("ね.こ"), U"六七五三四一二");
  EXPECT_EQ(found("-ねこ"), U"六七五三四一二");
  EXPECT_EQ(found("ねごと"), U"八");
  EXPECT_EQ(found("ねこみや"), U"");
}

TEST_F(SmallSearch, OfTwoFitsOfOneCharacterTheBetterCounts) {
  add(U'一');
  add(U'二');
  exec("INSERT INTO reading_key VALUES('ねこ', 0, 2), ('ねこあ', 1, 0), ('ねこ', 1, 1), ('ねこみ', 0, 0)");
  EXPECT_EQ(found("ねこ"), U"二一");
}

TEST_F(SmallSearch, MeaningsFitAsAWholeThenFromALaterWordThenByTheirBeginnings) {
  for (const char32_t c : std::u32string(U"一二三四五六")) add(c);
  exec(
      "INSERT INTO meaning_key VALUES('catfish', 0, 0), ('cat food', 1, 0), ('cat', 2, 2), ('cat', 3, 1),"
      "('cat', 4, 0), ('bobcat', 5, 0)");
  EXPECT_EQ(found("cat"), U"五四二三一");
  EXPECT_EQ(found(" CAT "), U"五四二三一");
  EXPECT_EQ(found("cat f"), U"二");
  EXPECT_EQ(found("b"), U"六");
}

TEST_F(SmallSearch, WhatIsStillBeingTypedIsOnlyABeginning) {
  for (const char32_t c : std::u32string(U"一二三")) add(c);
  exec("INSERT INTO reading_key VALUES('やすみ', 0, 0), ('やす', 1, 0), ('やし', 2, 0)");
  EXPECT_EQ(found("yas"), U"一二三") << "none of them is whole yet";
  EXPECT_EQ(found("yasu"), U"二一");
}

TEST_F(SmallSearch, BothReadingsAndMeaningsAreFoundByLatinLetters) {
  for (const char32_t c : std::u32string(U"一二三")) add(c);
  exec("INSERT INTO reading_key VALUES('ひ', 0, 1)");
  exec("INSERT INTO meaning_key VALUES('hi', 1, 0), ('high', 2, 0)");
  EXPECT_EQ(found("hi"), U"二一三");
}

TEST_F(SmallSearch, ACharacterIsFoundByItselfFirst) {
  add(U'一');
  add(U'a');
  add(U'ａ');
  add(U'ね');
  exec("INSERT INTO reading_key VALUES('ね', 0, 0), ('あ', 0, 0)");
  EXPECT_EQ(found("ね"), U"ね一");
  EXPECT_EQ(found("a"), U"a一");
  EXPECT_EQ(found("ａ"), U"ａ一") << "the wide one is a character of its own here";
  exec("DELETE FROM character WHERE place = 2; UPDATE character SET place = 2 WHERE place = 3");
  EXPECT_EQ(found("ａ"), U"a一") << "else it is the plain one";
}

TEST_F(SmallSearch, WideLettersAndMarksAreThePlainOnes) {
  for (const char32_t c : {U'!', U'~', U' ', U'\x7F'}) add(c);
  EXPECT_EQ(found("！"), U"!");
  EXPECT_EQ(found(std::u32string(1, 0xFF5E)), U"~");
  EXPECT_EQ(found(std::u32string(1, 0xFF5F)), U"");
  EXPECT_EQ(found(std::u32string(1, 0xFF00)), U"");
}

TEST_F(SmallSearch, KanaBesideKanjiAreOkurigana) {
  add(U'休');
  const std::u32string kana{0x3041, 0x309F, 0x30A0, 0x30FF, 0xFF66, 0xFF9F};
  const std::u32string others{0x3040, 0x3100, 0xFF65, 0xFFA0};
  for (const char32_t c : kana + others) add(c);
  for (const char32_t c : kana) EXPECT_EQ(found(std::u32string{c, U'休'}), U"休") << static_cast<int>(c);
  for (const char32_t c : others) EXPECT_EQ(found(std::u32string{c, U'休'}), (std::u32string{c, U'休'}));
}

TEST_F(SmallSearch, EachCharacterOfATextIsFoundOnce) {
  add(U'休');
  add(U'日');
  EXPECT_EQ(found("日休日本日"), U"日休");
}

TEST_F(SmallSearch, LettersEndBeforeTheSigns) {
  // U+024F is the last letter of Latin Extended-B; the letters after it are phonetic symbols.
  for (const char32_t c : {char32_t{0x24F}, char32_t{0x250}, U'’'}) add(c);
  EXPECT_EQ(found(std::u32string{0x250, 0x250}), (std::u32string{0x250}));
  EXPECT_EQ(found(std::u32string{0x24F, 0x24F}), U"") << "a word, not a list of characters";
  EXPECT_EQ(found(U"a’"), U"");
}

TEST_F(SmallSearch, BlanksAroundTheTextDoNotCount) {
  add(U'休');
  for (const char* blank : {" ", "　", "\t", "\n", "\r", "\r\n "}) {
    EXPECT_EQ(found(std::string(blank) + "休"), U"休");
    EXPECT_EQ(found("休" + std::string(blank)), U"休");
    EXPECT_EQ(found(std::string(blank)), U"休") << "nothing is asked for";
  }
}

TEST_F(SmallSearch, EachConditionLeavesOutWhatDoesNotMeetIt) {
  add(U'一', {CharacterKind::ideograph, 3, 4, "1", "NULL", "NULL", "9", "", ""});
  add(U'二', {CharacterKind::ideograph, 4, 5, "2", "NULL", "NULL", "8", "", ""});
  add(U'三', {CharacterKind::ideograph, 0, 4, "1", "NULL", "NULL", "8", "", ""});
  add(U'四', {CharacterKind::ideograph, 1, 1, "NULL", "NULL", "NULL", "NULL", "", ""});
  const KanjiDatabase database = open();
  const auto with = [&](auto set) {
    Query query;
    set(query);
    return characters(database.search(query));
  };
  EXPECT_EQ(with([](Query&) {}), U"一二四");
  EXPECT_EQ(with([](Query& q) { q.drawn_only = false; }), U"一二三四");
  EXPECT_EQ(with([](Query& q) { q.grade = 1; }), U"一");
  EXPECT_EQ(with([](Query& q) { q.strokes = 4; }), U"一二");
  EXPECT_EQ(with([](Query& q) { q.radical = 8; }), U"二");
  EXPECT_EQ(with([](Query& q) { q.radical = 8, q.drawn_only = false; }), U"二三");
  EXPECT_EQ(with([](Query& q) { q.limit = 1; }), U"一");
  EXPECT_EQ(with([](Query& q) { q.limit = 1, q.grade = 2; }), U"二");
  EXPECT_EQ(with([](Query& q) { q.limit = 0; }), U"");
}

TEST_F(SmallSearch, FiveHundredAnswersAreEnoughUnlessMoreAreAskedFor) {
  exec(
      "WITH RECURSIVE n(i) AS (SELECT 0 UNION ALL SELECT i + 1 FROM n WHERE i < 599) "
      "INSERT INTO character SELECT 20000 + i, i, 0, 1, 1, NULL, NULL, NULL, NULL, '', '' FROM n");
  const KanjiDatabase database = open();
  EXPECT_EQ(database.search({}).size(), 500U);
  Query query;
  query.limit = 1000;
  EXPECT_EQ(database.search(query).size(), 600U);
}

TEST_F(SmallSearch, AKeyOfNoCharacterIsPassedOver) {
  add(U'一');
  exec("INSERT INTO reading_key VALUES('ねこ', 1, 0), ('ねこ', 0, 0), ('ねこ', 99, 0)");
  EXPECT_EQ(found("ねこ"), U"一");
}

}  // namespace
}  // namespace nazori::kanji
