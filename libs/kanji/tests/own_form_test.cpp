// SPDX-License-Identifier: Apache-2.0
// Forms that people made, used instead of the published ones of the real kanji.db.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "nazori/base/utf8.h"
#include "nazori/kanji/own_characters.h"
#include "published_database.h"

namespace nazori::kanji {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;

constexpr char32_t kForm = 0xF6C38;
constexpr char32_t kSign = 0xF0009;

/// 木 under an own roof: three strokes, none of which is one of the published 永.
Character other_form() {
  Character form;
  form.code_point = U'永';
  form.own_form = kForm;
  for (const double y : {20.0, 50.0, 80.0}) {
    Stroke stroke;
    stroke.path = "M90," + std::to_string(y);
    stroke.line.points = {{90, y}, {15, y + 3}};
    stroke.line.ending = StrokeEnding::taper;
    form.strokes.push_back(stroke);
  }
  Component whole;
  whole.element = "永";
  whole.strokes = {0, 1, 2};
  Component part;
  part.element = "三";
  part.strokes = {0, 1, 2};
  whole.children = {part};
  form.components.strokes = {0, 1, 2};
  form.components.children = {whole};
  form.entry.meanings = {{"en", "not what the dictionary says"}};
  form.entry.kun_readings = {"ちがう"};
  return form;
}

/// The published strokes, moved a little, as somebody corrects them.
Character corrected(char32_t character) {
  Character form;
  form.code_point = character;
  form.own_form = kForm;
  form.strokes = find(character).strokes;
  for (Stroke& stroke : form.strokes) {
    stroke.type.clear();
    for (auto& point : stroke.line.points) point = point + geometry::GlyphPoint{1.5, -1};
  }
  return form;
}

KanjiDatabase with(std::vector<Character> own) {
  auto opened = KanjiDatabase::open(published_database_file(), std::move(own));
  EXPECT_TRUE(opened) << base::to_line(opened.error());
  return *std::move(opened);
}

Character changed(const Character& form) { return with({form}).find(form.code_point).value(); }

Query part(const std::string& element) {
  Query query;
  query.parts = {element};
  query.limit = 10'000;
  return query;
}

TEST(OwnForm, TakesThePlaceOfThePublishedStrokes) {
  const KanjiDatabase database = with({other_form()});
  const auto form = database.find(U'永');
  ASSERT_TRUE(form);
  EXPECT_EQ(form->strokes, other_form().strokes);
  EXPECT_EQ(form->own_form, kForm);
  EXPECT_EQ(form->code_point, U'永');
  EXPECT_FALSE(database.find(kForm)) << "it has no code point of its own";
  EXPECT_FALSE(database.find(U'休')->own_form);
  EXPECT_FALSE(nazori::kanji::database().find(U'永')->own_form);
  EXPECT_FALSE(database.trouble());
}

TEST(OwnForm, LeavesWhatTheDictionarySays) {
  const KanjiDatabase database = with({other_form()});
  EXPECT_EQ(database.find(U'永')->entry, find(U'永').entry);
  EXPECT_EQ(database.find(U'永')->variants, find(U'永').variants);
  EXPECT_EQ(database.readings(U'永'), nazori::kanji::database().readings(U'永'));
  EXPECT_EQ(database.words(U'永', 10), nazori::kanji::database().words(U'永', 10));
  Query meaning;
  meaning.text = "not what the dictionary says";
  EXPECT_THAT(database.search(meaning), IsEmpty());
}

TEST(OwnForm, LeavesTheVariantsOfTheSource) {
  const KanjiDatabase database = with({[] {
    Character form = other_form();
    form.code_point = U'休';
    return form;
  }()});
  const auto variants = find(U'休').variants;
  ASSERT_FALSE(variants.empty());
  const auto variant = database.find(U'休', variants.front());
  ASSERT_TRUE(variant);
  EXPECT_EQ(variant->strokes, nazori::kanji::database().find(U'休', variants.front())->strokes);
  EXPECT_FALSE(variant->own_form);
}

TEST(OwnForm, StandsInListsAtThePublishedPlaceWithItsOwnStrokes) {
  const KanjiDatabase database = with({other_form()});
  Summary expected = nazori::kanji::database().summary(U'永').value();
  EXPECT_EQ(expected.strokes, 5);
  expected.strokes = 3;
  EXPECT_EQ(database.summary(U'永'), expected);
  for (const List list : {List::all, List::grade_5, List::grade_1})
    EXPECT_EQ(characters(database.list(list)), characters(nazori::kanji::database().list(list)));
  EXPECT_EQ(database.list(List::all).size(), 6702U);
  EXPECT_EQ(characters(database.list(List::own)), U"永");
}

TEST(OwnForm, IsListedBeforeTheOwnCharactersThatStandBeside) {
  Character sign = other_form();
  sign.code_point = kSign;
  sign.own_form.reset();
  const KanjiDatabase database = with({sign, other_form()});
  EXPECT_EQ(characters(database.list(List::own)), (std::u32string{U'永', kSign}));
  EXPECT_EQ(database.find(kSign)->strokes.size(), 3U);
  EXPECT_FALSE(database.find(kSign)->own_form);
  EXPECT_EQ(characters(database.list(List::all)).back(), kSign);
}

TEST(OwnForm, IsFoundByItsStrokesAndPartsAndByThePublishedParts) {
  const KanjiDatabase database = with({other_form()});
  Query strokes;
  strokes.limit = 10'000;
  strokes.strokes = 3;
  EXPECT_THAT(characters(database.search(strokes)), Contains(U'永'));
  EXPECT_THAT(characters(database.search(part("三"))), Contains(U'永'));
  EXPECT_THAT(characters(nazori::kanji::database().search(part("三"))), Not(Contains(U'永')));
  EXPECT_THAT(characters(database.search(part("水"))), Contains(U'永'));
  Query typed;
  typed.text = "永遠";
  EXPECT_EQ(characters(database.search(typed)), U"永遠");
}

TEST(OwnForm, IsOnceAmongTheCharactersOfAPart) {
  Character form = corrected(U'休');
  Component tree;
  tree.element = "木";
  tree.strokes = {2, 3, 4, 5};
  form.components.children = {tree};
  const auto all = characters(with({form}).containing("木", 10'000));
  EXPECT_EQ(std::ranges::count(all, U'休'), 1);
  EXPECT_EQ(all, characters(nazori::kanji::database().containing("木", 10'000)));
}

TEST(OwnForm, PassesItsStrokesInsteadOfThePublishedOnes) {
  std::vector<std::string> of_form;
  std::size_t count = 0;
  int place = -1;
  with({other_form()}).for_each_stroke([&](const StrokePath& stroke) {
    ++count;
    if (stroke.code_point != U'永') return;
    of_form.emplace_back(stroke.path);
    place = stroke.place;
  });
  ASSERT_EQ(of_form.size(), 3U);
  EXPECT_EQ(of_form.front(), other_form().strokes.front().path);
  std::size_t published = 0;
  int published_place = -2;
  nazori::kanji::database().for_each_stroke([&](const StrokePath& stroke) {
    ++published;
    if (stroke.code_point == U'永') published_place = stroke.place;
  });
  EXPECT_EQ(count + 2, published);
  EXPECT_EQ(place, published_place);
}

TEST(OwnForm, OfACharacterThatOnlyTheDictionaryKnowsIsDrawn) {
  const auto& published = nazori::kanji::database();
  char32_t bare = 0;
  for (char32_t c = 0x4E00; c < 0x9FFF && bare == 0; ++c)
    if (published.summary(c) && !published.draws(c)) bare = c;
  ASSERT_NE(bare, 0U);
  Character form = other_form();
  form.code_point = bare;
  const KanjiDatabase database = with({form});
  EXPECT_TRUE(database.draws(bare));
  EXPECT_EQ(database.find(bare)->strokes.size(), 3U);
  EXPECT_EQ(database.list(List::all).size(), 6703U);
}

TEST(OwnForm, WhoseCharacterIsNotInTheDatabaseStandsBesideTheOthers) {
  Character form = other_form();
  form.code_point = 0x2B820;
  ASSERT_FALSE(nazori::kanji::database().summary(form.code_point));
  const KanjiDatabase database = with({form});
  EXPECT_FALSE(database.find(form.code_point));
  ASSERT_TRUE(database.find(kForm));
  EXPECT_FALSE(database.find(kForm)->own_form);
  EXPECT_EQ(characters(database.list(List::own)), (std::u32string{kForm}));
}

TEST(OwnForm, NeedsACodePointOfItsOwnAndOneOfAPublishedCharacter) {
  const auto refused = [](std::vector<std::pair<char32_t, char32_t>> code_points) {
    std::vector<Character> own;
    for (const auto& [at, form] : code_points) {
      own.push_back(other_form());
      own.back().code_point = at;
      own.back().own_form = form;
    }
    const auto opened = KanjiDatabase::open(published_database_file(), own);
    return !opened && opened.error().code == base::Errc::bad_argument;
  };
  EXPECT_TRUE(refused({{U'永', U'休'}}));
  EXPECT_TRUE(refused({{kSign, kForm}}));
  EXPECT_TRUE(refused({{U'永', kForm}, {U'永', kSign}}));
  EXPECT_TRUE(refused({{U'永', kForm}, {U'休', kForm}}));
  EXPECT_FALSE(refused({{U'永', kForm}, {U'休', kSign}}));
}

// 上 has another accepted order.
TEST(OwnForm, KeepsOrdersTypesAndPartsWhileTheStrokesAreThoseOfTheSource) {
  const Character published = find(U'上');
  ASSERT_FALSE(published.alternative_orders.empty());
  ASSERT_FALSE(published.strokes.front().type.empty());
  Character form = corrected(U'上');
  for (const auto& [element, strokes] :
       {std::pair<std::string, std::vector<int>>{"卜", {0, 1}}, {"一", {2}}}) {
    Component one;
    one.element = element;
    one.strokes = strokes;
    form.components.children.push_back(one);
  }
  const Character now = changed(form);
  EXPECT_EQ(now.alternative_orders, published.alternative_orders);
  EXPECT_EQ(now.strokes.front().type, published.strokes.front().type);
  EXPECT_EQ(now.strokes.front().line, form.strokes.front().line);

  Character other_ending = form;
  other_ending.strokes.front().line.ending = StrokeEnding::hook;
  EXPECT_EQ(changed(other_ending).strokes.front().type, "");
  EXPECT_EQ(changed(other_ending).strokes.back().type, published.strokes.back().type);
}

TEST(OwnForm, LosesTheOtherOrdersWithAnotherOrderDirectionOrCount) {
  const Character form = corrected(U'上');
  Character reordered = form;
  std::swap(reordered.strokes[0], reordered.strokes[1]);
  EXPECT_THAT(changed(reordered).alternative_orders, IsEmpty());
  EXPECT_EQ(changed(reordered).strokes[0].type, "");
  Character turned = form;
  std::ranges::reverse(turned.strokes[0].line.points);
  EXPECT_THAT(changed(turned).alternative_orders, IsEmpty());
  // Where no other stroke could be meant.
  Character one = corrected(U'一');
  EXPECT_EQ(changed(one).strokes[0].type, find(U'一').strokes[0].type);
  std::ranges::reverse(one.strokes[0].line.points);
  EXPECT_EQ(changed(one).strokes[0].type, "");
  Character three = corrected(U'三');
  EXPECT_EQ(changed(three).strokes[0].type, find(U'三').strokes[0].type);
  std::swap(three.strokes[0], three.strokes[1]);
  EXPECT_EQ(changed(three).strokes[0].type, "") << "of the same kind, in another order";
  Character shorter = form;
  shorter.strokes.pop_back();
  EXPECT_THAT(changed(shorter).alternative_orders, IsEmpty());
  EXPECT_EQ(changed(shorter).strokes.size(), 2U);
}

// As a copy in the workshop has them: all named parts in one list, the pieces of one joined.
TEST(OwnForm, KeepsTheTreeOfPartsUntilSomebodyChangesTheParts) {
  for (const char32_t c : U"休国林街") {
    if (c == 0) continue;
    const Character published = find(c);
    Character form = corrected(c);
    Component whole;
    whole.element = base::encode_utf8(c);
    for (int i = 0; i < static_cast<int>(published.strokes.size()); ++i) whole.strokes.push_back(i);
    const auto add = [&whole](const auto& self, const Component& group) -> void {
      for (const Component& child : group.children) {
        if (!child.element.empty()) {
          const auto same = std::ranges::find_if(whole.children, [&child](const Component& one) {
            return child.part.value_or(1) > 1 && one.element == child.element;
          });
          if (same == whole.children.end()) {
            Component one;
            one.element = child.element;
            one.strokes = child.strokes;
            whole.children.push_back(one);
          } else {
            std::set<int> both(same->strokes.begin(), same->strokes.end());
            both.insert(child.strokes.begin(), child.strokes.end());
            same->strokes.assign(both.begin(), both.end());
          }
        }
        self(self, child);
      }
    };
    add(add, published.components);
    form.components.strokes = whole.strokes;
    form.components.children = {whole};
    EXPECT_EQ(changed(form).components, published.components) << base::encode_utf8(c);

    form.components.children.front().children.front().element = "々";
    const Component now = changed(form).components;
    EXPECT_EQ(now.element, base::encode_utf8(c));
    EXPECT_EQ(now.children.front().element, "々");
    EXPECT_EQ(now.strokes, whole.strokes);
  }
}

TEST(OwnForm, WithOtherStrokesHasItsOwnParts) {
  const Component now = changed(other_form()).components;
  EXPECT_EQ(now.element, "永");
  ASSERT_EQ(now.children.size(), 1U);
  EXPECT_EQ(now.children.front().element, "三");
  // One stroke more, in no part.
  Character longer = corrected(U'休');
  longer.strokes.push_back(longer.strokes.back());
  for (int i = 0; i < 7; ++i) longer.components.strokes.push_back(i);
  longer.components.children = find(U'休').components.children;
  EXPECT_EQ(changed(longer).components.strokes.size(), 7U);
  Character nameless = other_form();
  nameless.components = nameless.components.children.front();
  nameless.components.element = "our way";
  EXPECT_EQ(changed(nameless).components.element, "永");
}

}  // namespace
}  // namespace nazori::kanji
