// SPDX-License-Identifier: Apache-2.0
// Characters that people made themselves, beside those of the real kanji.db.
#include "nazori/kanji/own_characters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "nazori/base/utf8.h"
#include "nazori/kanji/part_picker.h"
#include "published_database.h"

namespace nazori::kanji {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr char32_t kSchoolSign = 0xF1234;
constexpr char32_t kClubSign = 0xF0007;

Stroke bar(const std::string& path) {
  Stroke out;
  out.path = path;
  out.line.points = {{20, 30}, {80, 30}};
  out.line.ending = StrokeEnding::hook;
  return out;
}

Character school_sign() {
  Character sign;
  sign.code_point = kSchoolSign;
  sign.strokes = {bar("M20,30L80,30"), bar("M20,60L80,60")};
  sign.entry.kun_readings = {"まなびや"};
  sign.entry.meanings = {{"en", "xylophone school"}, {"en", "own xylophone"}};
  sign.entry.radical = 9;
  sign.components.element = "学";
  sign.components.strokes = {0, 1};
  Component part;
  part.element = "木";
  part.strokes = {1};
  part.first_stroke = 1;
  sign.components.children = {part};
  return sign;
}

Character club_sign() {
  Character sign;
  sign.code_point = kClubSign;
  sign.strokes = {bar("M10,10L90,90")};
  sign.entry.on_readings = {"クラブ"};
  return sign;
}

Query text(const std::string& typed) {
  Query query;
  query.text = typed;
  return query;
}
template <class Value>
Query with(Value Query::*condition, Value value) {
  Query query;
  query.*condition = std::move(value);
  return query;
}
Query part(const std::string& element) { return with(&Query::parts, std::vector<std::string>{element}); }
Query strokes(int count) { return with(&Query::strokes, std::optional(count)); }

KanjiDatabase with_signs() {
  auto opened =
      KanjiDatabase::open(published_database_file(), std::vector<Character>{school_sign(), club_sign()});
  EXPECT_TRUE(opened) << base::to_line(opened.error());
  return *std::move(opened);
}

std::u32string found(const KanjiDatabase& database, Query query) {
  query.limit = 10'000;
  return characters(database.search(query));
}

TEST(OwnCharacters, AreReadAsTheyWereGiven) {
  const KanjiDatabase database = with_signs();
  const auto sign = database.find(kSchoolSign);
  ASSERT_TRUE(sign);
  EXPECT_EQ(sign->strokes, school_sign().strokes);
  EXPECT_EQ(sign->components, school_sign().components);
  EXPECT_EQ(sign->entry, school_sign().entry);
  EXPECT_EQ(database.find(kClubSign)->strokes, club_sign().strokes);
  EXPECT_FALSE(database.find(kSchoolSign, "Kaisho"));
  EXPECT_FALSE(database.find(kSchoolSign + 1));
  EXPECT_EQ(database.find(U'休')->strokes.size(), 6U);
}

TEST(OwnCharacters, HaveAListInTheirOrderAndAreAmongAll) {
  const KanjiDatabase database = with_signs();
  EXPECT_EQ(characters(database.list(List::own)), (std::u32string{kSchoolSign, kClubSign}));
  const std::u32string all = characters(database.list(List::all));
  EXPECT_EQ(all.size(), 6704U);
  EXPECT_EQ(all.substr(6702), (std::u32string{kSchoolSign, kClubSign}));
  EXPECT_THAT(nazori::kanji::database().list(List::own), IsEmpty());
  EXPECT_EQ(database.list(List::grade_1).size(), 80U);
}

TEST(OwnCharacters, StandInListsWithReadingMeaningAndStrokes) {
  const KanjiDatabase database = with_signs();
  EXPECT_EQ(database.summary(kSchoolSign), (Summary{kSchoolSign, "xylophone school", "まなびや", 2, {}}));
  EXPECT_EQ(database.summary(kClubSign), (Summary{kClubSign, "", "クラブ", 1, {}}));
  EXPECT_THAT(database.readings(kClubSign), ElementsAre("クラブ"));
  EXPECT_TRUE(database.draws(kClubSign));
  EXPECT_FALSE(database.draws(kClubSign + 1));
}

TEST(OwnCharacters, AreFoundByReadingMeaningPartRadicalAndThemselves) {
  const KanjiDatabase database = with_signs();
  const auto finds = [&database](Query query) { return found(database, std::move(query)); };
  EXPECT_THAT(finds(text("まなびや")), Contains(kSchoolSign));
  EXPECT_THAT(finds(text("manabiya")), Contains(kSchoolSign));
  EXPECT_THAT(finds(text("クラ")), Contains(kClubSign));
  EXPECT_EQ(finds(text("xylophone")).front(), kSchoolSign);
  EXPECT_THAT(finds(text("school")), Contains(kSchoolSign));
  EXPECT_EQ(finds(text(base::encode_utf8(kClubSign))), (std::u32string{kClubSign}));
  EXPECT_THAT(finds(with(&Query::radical, std::optional(9))), Contains(kSchoolSign));
  EXPECT_THAT(finds(part("木")), Contains(kSchoolSign));
  EXPECT_THAT(characters(database.containing("木", 10'000)), Contains(kSchoolSign));
  EXPECT_THAT(finds(strokes(1)), Contains(kClubSign));
  EXPECT_THAT(finds(strokes(1)), testing::Not(Contains(kSchoolSign)));
  EXPECT_THAT(finds(with(&Query::grade, std::optional(1))), testing::Not(Contains(kSchoolSign)));
  EXPECT_FALSE(database.trouble());
}

TEST(OwnCharacters, ThatAreFormsOfACharacterComeAfterIt) {
  Character form = club_sign();
  Component whole;
  whole.element = "休";
  whole.strokes = {0};
  form.components.children = {whole};
  Character with_a_part = school_sign();
  with_a_part.components.children.front().element = "休";
  const auto opened =
      KanjiDatabase::open(published_database_file(), std::vector<Character>{with_a_part, form});
  ASSERT_TRUE(opened);
  EXPECT_EQ(found(*opened, text("休日")), (std::u32string{U'休', kClubSign, U'日'}));
}

TEST(OwnCharacters, SayWhyTheyWereFound) {
  const KanjiDatabase database = with_signs();
  const auto matches = database.matches(text("own xylophone"));
  ASSERT_FALSE(matches.empty());
  EXPECT_EQ(matches.front().summary.code_point, kSchoolSign);
  EXPECT_EQ(matches.front().reason, Reason::meaning);
  EXPECT_EQ(matches.front().text, "own xylophone");
  const auto read = database.matches(text("くらぶ"));
  ASSERT_FALSE(read.empty());
  EXPECT_EQ(read.back().text, "クラブ");
}

TEST(OwnCharacters, ChangeNothingThatIsFoundOfTheOthers) {
  const KanjiDatabase database = with_signs();
  const Query queries[] = {
      text("やすむ"), text("rest"), text("kyuu"), with(&Query::grade, std::optional(3)),
      part("木"),     text("休日"), strokes(2),   with(&Query::skip, std::string("1-2-4"))};
  for (Query query : queries) {
    query.limit = 10'000;
    std::u32string now = characters(database.search(query));
    std::erase_if(now, is_own);
    EXPECT_EQ(now, characters(nazori::kanji::database().search(query))) << query.text;
  }
}

TEST(OwnCharacters, AreAmongTheCharactersOfAPart) {
  const auto uses = with_signs().parts(15);
  const auto tree =
      std::find_if(uses.begin(), uses.end(), [](const PartUse& use) { return use.element == "木"; });
  ASSERT_NE(tree, uses.end());
  EXPECT_THAT(tree->characters, Contains(kSchoolSign));
}

TEST(OwnCharacters, PassTheirStrokesAfterAllOthers) {
  std::vector<std::pair<char32_t, std::string>> last;
  std::vector<int> places;
  std::size_t count = 0;
  with_signs().for_each_stroke([&](const StrokePath& stroke) {
    ++count;
    if (!is_own(stroke.code_point)) {
      EXPECT_THAT(last, IsEmpty());
      return;
    }
    last.emplace_back(stroke.code_point, stroke.path);
    places.push_back(stroke.place);
  });
  EXPECT_THAT(last,
              ElementsAre(std::pair(kSchoolSign, "M20,30L80,30"), std::pair(kSchoolSign, "M20,60L80,60"),
                          std::pair(kClubSign, "M10,10L90,90")));
  std::size_t published = 0;
  nazori::kanji::database().for_each_stroke([&published](const StrokePath&) { ++published; });
  EXPECT_EQ(count, published + 3);
  EXPECT_EQ(places[0], places[1]);
  EXPECT_EQ(places[2], places[0] + 1);
}

TEST(OwnCharacters, WithAnotherCodePointOrOneTwiceAreRefused) {
  const auto refused = [](std::vector<char32_t> code_points) {
    std::vector<Character> own;
    for (const char32_t c : code_points) {
      own.push_back(club_sign());
      own.back().code_point = c;
    }
    const auto opened = KanjiDatabase::open(published_database_file(), own);
    return !opened && opened.error().code == base::Errc::bad_argument;
  };
  EXPECT_TRUE(refused({U'休'}));
  EXPECT_TRUE(refused({kFirstOwn - 1}));
  EXPECT_TRUE(refused({kLastOwn + 1}));
  EXPECT_TRUE(refused({kFirstOwn, kClubSign, kFirstOwn}));
  EXPECT_FALSE(refused({kFirstOwn, kLastOwn}));
}

}  // namespace
}  // namespace nazori::kanji
