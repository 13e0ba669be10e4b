// SPDX-License-Identifier: Apache-2.0
// Every column of a kanji.db comes out where it belongs.
#include "small_database.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <string>
#include <tuple>
#include <vector>

#include "nazori/geometry/polyline.h"
#include "nazori/geometry/svg_path.h"

namespace nazori::kanji {
namespace {

using test::SmallDatabase;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST_F(SmallDatabase, ACharacterHasWhatItsRowSays) {
  add(U'休', {CharacterKind::ideograph, 6, 7, "1", "642", "4", "9", "rest", "やす.む"});
  add(U'々', {});
  exec("INSERT INTO stroke_count VALUES(20241, 0, 6), (20241, 1, 7)");
  exec("INSERT INTO reading VALUES(20241, 0, 0, 'on'), (20241, 1, 1, 'kun'), (20241, 2, 2, 'name')");
  exec("INSERT INTO meaning VALUES(20241, 0, 'en', 'rest'), (20241, 1, 'fr', 'repos')");
  exec("INSERT INTO code VALUES(20241, 0, 'skip', '1-2-4'), (20241, 1, 'deroo', '2164')");
  exec("INSERT INTO alternative_order VALUES(20241, 0, '1 3 2', 'a list'), (20241, 1, '2 x 1', 'damaged')");
  exec("INSERT INTO form VALUES(0, 20241, ''), (1, 20241, 'B'), (2, 20241, 'A')");
  const KanjiDatabase database = open();
  const auto rest = database.find(U'休');
  ASSERT_TRUE(rest);
  EXPECT_EQ(rest->code_point, U'休');
  EXPECT_EQ(rest->variant, "");
  EXPECT_EQ(rest->entry.grade, 1);
  EXPECT_EQ(rest->entry.frequency, 642);
  EXPECT_EQ(rest->entry.old_jlpt_level, 4);
  EXPECT_EQ(rest->entry.radical, 9);
  EXPECT_THAT(rest->entry.stroke_counts, ElementsAre(6, 7));
  EXPECT_THAT(rest->entry.on_readings, ElementsAre("on"));
  EXPECT_THAT(rest->entry.kun_readings, ElementsAre("kun"));
  EXPECT_THAT(rest->entry.nanori, ElementsAre("name"));
  EXPECT_THAT(rest->entry.meanings, ElementsAre(Meaning{"en", "rest"}, Meaning{"fr", "repos"}));
  EXPECT_THAT(rest->entry.codes, ElementsAre(Code{"skip", "1-2-4"}, Code{"deroo", "2164"}));
  EXPECT_THAT(rest->variants, ElementsAre("B", "A")) << "in the order of the forms";
  EXPECT_THAT(rest->alternative_orders,
              ElementsAre(AlternativeOrder{{1, 3, 2}, "a list"}, AlternativeOrder{{2}, "damaged"}));
  const auto variant = database.find(U'休', "B");
  ASSERT_TRUE(variant);
  EXPECT_EQ(variant->variant, "B");
  EXPECT_EQ(variant->entry, rest->entry);
  EXPECT_THAT(variant->variants, IsEmpty()) << "only the main form names them";
  EXPECT_THAT(variant->alternative_orders, IsEmpty());
  EXPECT_FALSE(database.find(U'休', "C"));
  const auto mark = database.find(U'々');
  ASSERT_TRUE(mark);
  EXPECT_EQ(mark->entry, DictionaryEntry{});
  EXPECT_THAT(mark->strokes, IsEmpty());
  EXPECT_EQ(mark->components, Component{});
  EXPECT_FALSE(database.trouble());
}

TEST_F(SmallDatabase, AStrokeHasItsPathFlattenedToATwentiethAndANumberWhereBothOfItsPlacesAreKnown) {
  add(U'休');
  const std::string path = "M10,10C30,90,60,-20,90,80";
  exec("INSERT INTO form VALUES(7, 20241, '')");
  exec("INSERT INTO stroke VALUES(7, 0, '" + path + "', '㇒', 2, 3.5, 4.5)");
  exec("INSERT INTO stroke VALUES(7, 1, 'M1,2L3,4', '', 0, 3.5, NULL)");
  exec("INSERT INTO stroke VALUES(7, 2, 'M1,2L3,4', '', 3, NULL, 4.5)");
  const auto character = open().find(U'休');
  ASSERT_TRUE(character);
  ASSERT_EQ(character->strokes.size(), 3U);
  const Stroke& first = character->strokes[0];
  EXPECT_EQ(first.path, path);
  EXPECT_EQ(first.type, "㇒");
  EXPECT_EQ(first.line.ending, StrokeEnding::taper);
  EXPECT_EQ(first.line.number_position, (geometry::GlyphPoint{3.5, 4.5}));
  EXPECT_EQ(first.line.points, geometry::flatten(*geometry::parse_svg_path(path), 0.05));
  EXPECT_EQ(character->strokes[1].line.number_position, std::nullopt);
  EXPECT_EQ(character->strokes[2].line.number_position, std::nullopt);
  EXPECT_EQ(character->strokes[2].line.ending, StrokeEnding::either);
}

TEST_F(SmallDatabase, GroupsAreATreeWithAllThatTheirRowsSay) {
  add(U'休');
  exec("INSERT INTO form VALUES(0, 20241, '')");
  // position, parent, first stroke, count, element, original, place, radical, phon, part, number, flags
  exec("INSERT INTO component VALUES(0, 0, -1, 0, 6, 'root', 'o', 'left', 'general', 'p', 3, 4, 0)");
  exec("INSERT INTO component VALUES(0, 1, 0, 0, 2, 'a', '', '', '', '', NULL, NULL, 1)");
  exec("INSERT INTO component VALUES(0, 2, 1, 1, 1, 'b', '', '', '', '', NULL, NULL, 2)");
  exec("INSERT INTO component VALUES(0, 3, 0, 2, 4, 'c', '', '', '', '', NULL, NULL, 4)");
  exec("INSERT INTO component VALUES(0, 4, 3, 2, 0, 'd', '', '', '', '', NULL, NULL, 8)");
  exec("INSERT INTO component VALUES(0, 5, 3, 2, 1, 'e', '', '', '', '', NULL, NULL, 15)");
  const auto root = open().find(U'休').value().components;
  EXPECT_EQ(std::tie(root.element, root.original, root.position, root.radical, root.phon),
            std::make_tuple("root", "o", "left", "general", "p"));
  EXPECT_EQ(root.part, 3);
  EXPECT_EQ(root.number, 4);
  EXPECT_EQ(root.first_stroke, 0);
  EXPECT_THAT(root.strokes, ElementsAre(0, 1, 2, 3, 4, 5));
  ASSERT_EQ(root.children.size(), 2U);
  const Component& a = root.children[0];
  const Component& c = root.children[1];
  EXPECT_EQ(a.element, "a");
  EXPECT_EQ(a.part, std::nullopt);
  EXPECT_EQ(a.number, std::nullopt);
  ASSERT_EQ(a.children.size(), 1U);
  EXPECT_THAT(a.children[0].strokes, ElementsAre(1));
  EXPECT_EQ(c.first_stroke, 2);
  ASSERT_EQ(c.children.size(), 2U);
  EXPECT_EQ(c.children[0].element, "d");
  EXPECT_THAT(c.children[0].strokes, IsEmpty());
  EXPECT_EQ(c.children[1].element, "e");
  const auto marks = [](const Component& g) {
    return std::string(g.variant ? "v" : "") + (g.partial ? "p" : "") + (g.trad_form ? "t" : "") +
           (g.radical_form ? "r" : "");
  };
  EXPECT_EQ(marks(root), "");
  EXPECT_EQ(marks(a), "v");
  EXPECT_EQ(marks(a.children[0]), "p");
  EXPECT_EQ(marks(c), "t");
  EXPECT_EQ(marks(c.children[0]), "r");
  EXPECT_EQ(marks(c.children[1]), "vptr");
}

TEST_F(SmallDatabase, AGroupWhoseParentIsNotBeforeItIsLeftOut) {
  add(U'休');
  exec("INSERT INTO form VALUES(0, 20241, '')");
  exec("INSERT INTO component VALUES(0, 0, -1, 0, 1, 'root', '', '', '', '', NULL, NULL, 0)");
  for (const int parent : {-1, 1, 2, 99}) {
    exec("DELETE FROM component WHERE position > 0");
    exec("INSERT INTO component VALUES(0, 1, " + std::to_string(parent) +
         ", 0, 1, 'lost', '', '', '', '', NULL, NULL, 0)");
    const auto root = open().find(U'休').value().components;
    EXPECT_EQ(root.element, "root");
    EXPECT_THAT(root.children, IsEmpty()) << parent;
  }
}

TEST_F(SmallDatabase, ASummarySaysWhatIsDrawnElseWhatIsCounted) {
  add(U'一', {CharacterKind::ideograph, 1, 5, "8", "NULL", "NULL", "NULL", "one", "ひと"});
  add(U'二', {CharacterKind::ideograph, 0, 2, "NULL", "NULL", "NULL", "NULL", "", ""});
  Query query;
  query.drawn_only = false;
  EXPECT_THAT(open().search(query),
              ElementsAre(Summary{U'一', "one", "ひと", 1, 8}, Summary{U'二', "", "", 2, std::nullopt}));
}

TEST_F(SmallDatabase, EachListHasItsMembersOnly) {
  for (int grade = 1; grade <= 11; ++grade)
    add(U'a' + static_cast<char32_t>(grade),
        {CharacterKind::ideograph, 1, 1, std::to_string(grade), "NULL", "NULL", "NULL", "", ""});
  add(U'あ', {CharacterKind::hiragana});
  add(U'ア', {CharacterKind::katakana});
  add(U'A', {CharacterKind::latin});
  add(U'、', {CharacterKind::other});
  add(U'鬱', {CharacterKind::ideograph, 0, 29});
  const KanjiDatabase database = open();
  const std::pair<List, std::u32string> expected[] = {
      {List::grade_1, U"b"},   {List::grade_2, U"c"},          {List::grade_3, U"d"},
      {List::grade_4, U"e"},   {List::grade_5, U"f"},          {List::grade_6, U"g"},
      {List::secondary, U"i"}, {List::jinmeiyou, U"jk"},       {List::hiragana, U"あ"},
      {List::katakana, U"ア"}, {List::latin_and_digits, U"A"}, {List::all, U"bcdefghijklあアA、"}};
  for (const auto& [list, members] : expected)
    EXPECT_EQ(characters(database.list(list)), members) << static_cast<int>(list);
}

TEST_F(SmallDatabase, AWordHasItsSensesAndGlosses) {
  add(U'休');
  exec(
      "INSERT INTO word VALUES(3, '休む', 'やすむ', 'v5m', 1, 'to rest/to stop\nto sleep'),"
      "(5, 'ああ', NULL, 'int', 0, 'ah'), (8, '休', '', '', 2, '')");
  exec("INSERT INTO word_of VALUES(20241, 8), (20241, 3), (20241, 5)");
  const auto words = open().words(U'休', 9);
  EXPECT_THAT(words,
              ElementsAre(Word{"休む", "やすむ", {"to rest", "to stop", "to sleep"}, {1, 1, 2}, "v5m", true},
                          Word{"ああ", "ああ", {"ah"}, {1}, "int", false},
                          Word{"休", "", {""}, {1}, "", true, true}));
  EXPECT_EQ(open().words(U'休', 2).size(), 2U);
}

TEST_F(SmallDatabase, PartsAreFoundByPlaceAndPlacesBeyondTheListAreLeftOut) {
  add(U'一');
  add(U'二');
  exec("INSERT INTO element_of VALUES('x', 1), ('x', 0), ('x', 2), ('y', 1)");
  const KanjiDatabase database = open();
  EXPECT_EQ(characters(database.containing("x", 9)), U"一二");
  EXPECT_EQ(characters(database.containing("x", 1)), U"一");
  EXPECT_EQ(characters(database.containing("y", 9)), U"二");
  EXPECT_EQ(characters(database.containing("x", 0)), U"");
  EXPECT_EQ(characters(database.containing("x", -1)), U"");
}

TEST_F(SmallDatabase, ARadicalAndTheSourcesHaveTheirColumns) {
  exec("INSERT INTO radical VALUES(9, '人', 2, 'person'), (10, '儿', 3, 'legs')");
  exec("INSERT INTO radical_form VALUES(9, 1, 'b'), (9, 0, 'a'), (10, 0, 'c')");
  exec("INSERT INTO radical_name VALUES(9, 1, 'n2'), (9, 0, 'n1'), (10, 0, 'n3')");
  exec("INSERT INTO source VALUES(1, 'B', '2', 'sum2', 'free'), (0, 'A', '1', 'sum1', 'open')");
  const KanjiDatabase database = open();
  EXPECT_EQ(database.radical(9), (Radical{9, "人", {"a", "b"}, {"n1", "n2"}, "person", 2}));
  EXPECT_EQ(database.radical(10), (Radical{10, "儿", {"c"}, {"n3"}, "legs", 3}));
  EXPECT_EQ(database.radical(11), std::nullopt);
  const auto sources = database.sources();
  ASSERT_EQ(sources.size(), 2U);
  EXPECT_EQ(std::tie(sources[0].name, sources[0].version, sources[0].sha256, sources[0].licence),
            std::make_tuple("A", "1", "sum1", "open"));
  EXPECT_EQ(sources[1].name, "B");
}

TEST_F(SmallDatabase, EveryStrokeOfTheMainFormsIsHandedOnInItsOrder) {
  add(U'二');
  add(U'一');
  exec("INSERT INTO form VALUES(0, 19968, ''), (1, 19968, 'V'), (2, 20108, '')");
  exec(
      "INSERT INTO stroke VALUES(2, 1, 'd', '', 0, 0, 0), (2, 0, 'c', '', 0, 0, 0), (0, 0, 'a', '', 0, 0, 0),"
      "(1, 0, 'b', '', 0, 0, 0)");
  std::vector<std::tuple<char32_t, int, std::string>> got;
  open().for_each_stroke(
      [&](const StrokePath& stroke) { got.emplace_back(stroke.code_point, stroke.place, stroke.path); });
  EXPECT_THAT(got, ElementsAre(std::make_tuple(U'一', 1, "a"), std::make_tuple(U'二', 0, "c"),
                               std::make_tuple(U'二', 0, "d")));
}

TEST_F(SmallDatabase, PlacesWithGapsAreDamage) {
  add(U'一');
  add(U'二');
  EXPECT_TRUE(KanjiDatabase::open(path_));
  for (const int place : {2, -1}) {
    exec("UPDATE character SET place = " + std::to_string(place) + " WHERE code_point = 20108");
    const auto opened = KanjiDatabase::open(path_);
    ASSERT_FALSE(opened) << place;
    EXPECT_EQ(opened.error().code, base::Errc::schema);
    EXPECT_THAT(opened.error().what, HasSubstr("places have gaps"));
  }
}

TEST_F(SmallDatabase, TheFirstTroubleIsKept) {
  add(U'一');
  exec("INSERT INTO form VALUES(0, 19968, '')");
  exec("INSERT INTO stroke VALUES(0, 0, 'M1,2L3,4', '', 4, 0, 0)");
  const KanjiDatabase database = open();
  EXPECT_FALSE(database.find(U'一'));
  const base::Error first{base::Errc::io, "cannot be read: a stroke ends in no known way", path_.string(),
                          "build it again: nazori-cli database build"};
  EXPECT_EQ(database.trouble(), first);
  exec("UPDATE stroke SET ending = 0, path = 'none'");
  EXPECT_FALSE(database.find(U'一'));
  EXPECT_EQ(database.trouble(), first);
  const KanjiDatabase again = open();
  EXPECT_FALSE(again.find(U'一'));
  EXPECT_EQ(again.trouble()->what, "cannot be read: a stroke is no path");
}

TEST_F(SmallDatabase, WhatIsNoKanjiDatabaseIsRefusedByWhatItIs) {
  const auto refusal = [](const std::filesystem::path& path) {
    const auto opened = KanjiDatabase::open(path);
    return opened ? base::Error{} : opened.error();
  };
  const auto error = [](base::Errc code, const std::string& what, const std::filesystem::path& path) {
    return base::Error{code, what, path.string(), "build it again: nazori-cli database build"};
  };
  EXPECT_EQ(refusal(folder_ / "none"), error(base::Errc::not_found, "does not exist", folder_ / "none"));
  EXPECT_EQ(refusal(folder_), error(base::Errc::schema, "is a folder, not a kanji database", folder_));
  const auto pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(refusal(pipe), error(base::Errc::schema, "is not a regular file", pipe));
  exec("PRAGMA application_id = 1");
  EXPECT_EQ(refusal(path_), error(base::Errc::schema, "is not a kanji database", path_));
  exec("PRAGMA application_id = " + std::to_string(kSchemaApplicationId) + "; PRAGMA user_version = 77");
  EXPECT_EQ(refusal(path_),
            error(base::Errc::schema,
                  "has version 77, this program reads version " + std::to_string(kSchemaVersion), path_));
}

// The sanitizer inspects objects through a pipe, which a program that may not open files cannot have.
#if defined(__has_feature)
#if __has_feature(undefined_behavior_sanitizer)
#define NAZORI_LOOKS_AT_OBJECTS
#endif
#endif
#ifndef NAZORI_LOOKS_AT_OBJECTS
using SmallDatabaseDeathTest = SmallDatabase;

TEST_F(SmallDatabaseDeathTest, AFileThatTheSystemRefusesToOpenIsNotCalledDamaged) {
  const auto without_files = [path = path_] {
    const rlimit none{0, 0};
    (void)::setrlimit(RLIMIT_NOFILE, &none);
    const auto opened = KanjiDatabase::open(path);
    ::_exit(opened ? 1 : opened.error().code == base::Errc::io ? 7 : 2);
  };
  EXPECT_EXIT(without_files(), testing::ExitedWithCode(7), "");
}
#endif

}  // namespace
}  // namespace nazori::kanji
