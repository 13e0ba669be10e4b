// SPDX-License-Identifier: Apache-2.0
#include "nazori/kanji/part_picker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "small_database.h"

namespace nazori::kanji {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

PartPicker small_picker() {
  return PartPicker({{"日", 4, {U'日', U'明', U'林', U'晶'}},
                     {"月", 4, {U'月', U'明'}},
                     {"木", 4, {U'木', U'林', U'休'}},
                     {"亻", 2, {U'休'}}});
}

TEST(PartPicker, LeavesAllPartsPossibleWithoutAChoice) {
  const auto choice = small_picker().choose({});
  EXPECT_THAT(choice.characters, IsEmpty());
  EXPECT_THAT(choice.possible, ElementsAre(true, true, true, true));
}

TEST(PartPicker, FindsCharactersWithAllChosenParts) {
  EXPECT_THAT(small_picker().choose({"日"}).characters, ElementsAre(U'日', U'明', U'林', U'晶'));
  EXPECT_THAT(small_picker().choose({"月", "日"}).characters, ElementsAre(U'明'));
  EXPECT_THAT(small_picker().choose({"亻", "日"}).characters, IsEmpty());
  EXPECT_THAT(small_picker().choose({"亻", "亻"}).characters, ElementsAre(U'休'));
}

TEST(PartPicker, RulesOutPartsThatNoneOfTheCharactersHas) {
  EXPECT_THAT(small_picker().choose({"日"}).possible, ElementsAre(true, true, true, false));
  EXPECT_THAT(small_picker().choose({"月"}).possible, ElementsAre(true, true, false, false));
  EXPECT_THAT(small_picker().choose({"亻", "日"}).possible, ElementsAre(true, false, false, true))
      << "what is chosen can be taken back";
  EXPECT_THAT(small_picker().choose({"火"}).possible, ElementsAre(false, false, false, false));
}

class PartsOfADatabase : public test::SmallDatabase {};

TEST_F(PartsOfADatabase, AreDrawnCharactersThatEnoughOthersHaveByStrokes) {
  for (const auto& [c, strokes] : std::initializer_list<std::pair<char32_t, int>>{{U'明', 8},
                                                                                  {U'日', 4},
                                                                                  {U'晶', 12},
                                                                                  {U'人', 2},
                                                                                  {U'休', 6},
                                                                                  {U'何', 7},
                                                                                  {U'囗', 0},
                                                                                  {U'回', 6},
                                                                                  {U'国', 8},
                                                                                  {U'月', 4},
                                                                                  {U'朋', 8},
                                                                                  {U'朝', 12},
                                                                                  {U'期', 12}}) {
    Row row;
    row.strokes = strokes;
    add(c, row);
  }
  exec(
      "INSERT INTO element_of VALUES('日', 0), ('日', 2), ('人', 4), ('人', 5), ('囗', 7), ('囗', 8), ('月', "
      "0), ('月', 10),"
      "('月', 11), ('月', 12), ('朋', 12), ('none', 0)");
  const auto parts = open().parts(2);
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_EQ(parts[0], (PartUse{"人", 2, {U'人', U'休', U'何'}})) << "it is one of its characters";
  EXPECT_EQ(parts[1], (PartUse{"月", 4, {U'明', U'月', U'朋', U'朝', U'期'}}))
      << "the more used one comes first";
  EXPECT_EQ(parts[2], (PartUse{"日", 4, {U'明', U'日', U'晶'}}));
  EXPECT_EQ(open().parts(3).size(), 1U);
}

TEST_F(PartsOfADatabase, RadicalsAreFoundByAnyForm) {
  exec("INSERT INTO radical VALUES(9, '人', 2, 'person'), (85, '水', 4, 'water')");
  exec("INSERT INTO radical_form VALUES(9, 0, '亻'), (85, 0, '氵')");
  const auto database = open();
  EXPECT_EQ(database.radical_of_form("人"), 9);
  EXPECT_EQ(database.radical_of_form("氵"), 85);
  EXPECT_EQ(database.radical_of_form("木"), std::nullopt);
  // Signs for radicals, which some keyboards and dictionaries give.
  EXPECT_EQ(database.radical_of_form("⺅"), 9);
  EXPECT_EQ(database.radical_of_form("⺡"), 85);
  EXPECT_EQ(database.radical_of_form("⼀"), 1);
  EXPECT_EQ(database.radical_of_form("⽊"), 75);
  EXPECT_EQ(database.radical_of_form("⿕"), 214);
  EXPECT_EQ(database.radical_of_form("⿖"), std::nullopt) << "after the last one";
  EXPECT_EQ(database.radical_of_form("⺀"), std::nullopt);
  EXPECT_EQ(database.radical_of_form("⺅⺅"), std::nullopt);
  EXPECT_EQ(database.radical_of_form("\xFF"), std::nullopt);
  const auto all = database.radicals();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].number, 9);
  EXPECT_THAT(all[1].variant_forms, ElementsAre("氵"));
}

}  // namespace
}  // namespace nazori::kanji
