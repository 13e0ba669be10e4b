// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/character_lists.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "learner_fixture.h"
#include "nazori/base/utf8.h"

namespace nazori::study {
namespace {

using test::must;
using testing::ElementsAre;
using testing::HasSubstr;

const kanji::KanjiDatabase& database() {
  static const kanji::KanjiDatabase opened =
      must(kanji::KanjiDatabase::open(must(kanji::KanjiDatabase::locate())));
  return opened;
}

LearnerStore learner_with_notes() {
  LearnerStore store = must(LearnerStore::in_memory());
  EXPECT_TRUE(store.save_list({"trees", {U'森', U'林'}}));
  EXPECT_TRUE(store.save_list({"none", {}}));
  const std::vector<std::string> tags{"exam"};
  for (const char32_t c : {U'木', U'一'}) EXPECT_TRUE(store.set_tags(c, tags));
  return store;
}

TEST(ReadyLists, AreTheSchoolYearsNamesKanaOldLevelsAndOwnCharacters) {
  std::vector<std::string> ids;
  for (const ReadyList& one : ready_lists()) ids.push_back(one.id);
  EXPECT_THAT(ids, ElementsAre("grade-1", "grade-2", "grade-3", "grade-4", "grade-5", "grade-6", "secondary",
                               "jinmeiyou", "hiragana", "katakana", "old-jlpt-4", "old-jlpt-3", "old-jlpt-2",
                               "old-jlpt-1", "own"));
  EXPECT_EQ(ready_lists()[0].name, "grade 1");
  EXPECT_EQ(ready_lists()[10].name, "old JLPT level 4 (before 2010)");
}

TEST(ListIds, AreTheBuiltInListsThenTheLearnersOwnAndTags) {
  const auto known = list_ids(learner_with_notes());
  ASSERT_EQ(known.ids.size(), ready_lists().size() + 3);
  EXPECT_EQ(known.ids.front(), "grade-1");
  EXPECT_THAT(std::vector(known.ids.end() - 3, known.ids.end()),
              ElementsAre("list:none", "list:trees", "tag:exam"));
  EXPECT_FALSE(known.unread);
}

TEST(ListIds, TheChosenOnesComeFirstAndThoseThatAreGoneAreLeftOut) {
  const ListIds known{{"grade-1", "grade-2", "list:a"}, std::nullopt};
  EXPECT_THAT(known.chosen_first({}), ElementsAre("grade-1", "grade-2", "list:a"));
  EXPECT_THAT(known.chosen_first({"list:a", "list:gone", "grade-2", "list:a"}),
              ElementsAre("list:a", "grade-2", "grade-1"));
  const ListIds partly{{"grade-1"}, base::Error{}};
  EXPECT_THAT(partly.chosen_first({"tag:unread", "grade-1"}), ElementsAre("tag:unread", "grade-1"))
      << "what cannot be read now may still be there";
}

TEST(ReadyLists, HoldAsManyCharactersAsThereAre) {
  const LearnerStore store = learner_with_notes();
  CharacterLists lists(database());
  // The kyouiku kanji since 2020, the other jouyou kanji.
  const std::array<std::pair<const char*, std::size_t>, 7> kCounts{{{"grade-1", 80U},
                                                                    {"grade-2", 160U},
                                                                    {"grade-3", 200U},
                                                                    {"grade-4", 202U},
                                                                    {"grade-5", 193U},
                                                                    {"grade-6", 191U},
                                                                    {"secondary", 1'110U}}};
  for (const auto& [id, count] : kCounts) EXPECT_EQ(must(lists.members(id, store)).size(), count) << id;
  EXPECT_THAT(must(lists.members("hiragana", store)), testing::Contains(U'あ'));
  EXPECT_THAT(must(lists.members("katakana", store)), testing::Contains(U'ア'));
  EXPECT_THAT(must(lists.members("jinmeiyou", store)), testing::Contains(U'彦')) << "for names";
  for (const char32_t c : must(lists.members("old-jlpt-2", store)))
    ASSERT_EQ(lists.facts(c)->old_jlpt_level, 2);
  // A second call gives the same.
  EXPECT_EQ(must(lists.members("grade-1", store)).size(), 80U);
  EXPECT_EQ(must(lists.members("list:trees", store)), (std::vector{U'森', U'林'}));
  EXPECT_EQ(must(lists.members("tag:exam", store)), (std::vector{U'一', U'木'}));
  EXPECT_TRUE(must(lists.members("list:none", store)).empty());
  for (const char* none : {"", "list:", "list:gone", "tag:", "tag:gone", "grade-0", "old-jlpt-5", "trees"})
    EXPECT_EQ(lists.members(none, store).error().code, base::Errc::not_found) << none;
}

TEST(CharacterFacts, AreThoseOfTheDatabase) {
  CharacterLists lists(database());
  // KANJIDIC2: 森 is of grade 1, the 609th in newspapers, old level 3, twelve strokes.
  const CharacterFacts* wood = lists.facts(U'森');
  ASSERT_NE(wood, nullptr);
  EXPECT_EQ(wood->character, U'森');
  EXPECT_EQ(wood->grade, 1);
  EXPECT_EQ(wood->strokes, 12);
  EXPECT_TRUE(wood->frequency && wood->old_jlpt_level);
  EXPECT_THAT(wood->components, testing::Contains(U'木'));
  EXPECT_THAT(wood->components, testing::Not(testing::Contains(U'森'))) << "it is no part of itself";
  EXPECT_TRUE(std::is_sorted(wood->components.begin(), wood->components.end()));
  EXPECT_EQ(lists.facts(U'森'), wood);
  for (int i = 0; i < 2; ++i) EXPECT_EQ(lists.facts(U'\x1F600'), nullptr) << "is not drawn";
  EXPECT_EQ(CharacterFacts().strokes, 0);
}

std::u32string learning_order(CharacterLists& lists, std::vector<std::string> chosen, NewOrder order) {
  Settings settings;
  settings.new_lists = std::move(chosen);
  settings.new_order = order;
  const auto all = must(lists.in_learning_order(settings, learner_with_notes()));
  return {all.begin(), all.end()};
}

TEST(LearningOrder, OfReadyGradesIsThatOfTheListsOthersAreSorted) {
  CharacterLists lists(database());
  const LearnerStore store = learner_with_notes();
  const auto members = [&](const char* id) {
    const auto all = must(lists.members(id, store));
    return std::u32string(all.begin(), all.end());
  };
  EXPECT_EQ(learning_order(lists, {"grade-1", "grade-2"}, NewOrder::grade),
            members("grade-1") + members("grade-2"));
  EXPECT_EQ(learning_order(lists, {"grade-2", "grade-1"}, NewOrder::own),
            members("grade-2") + members("grade-1"));
  // Chosen in reverse, the grades still come in their order.
  const std::u32string sorted = learning_order(lists, {"grade-2", "grade-1"}, NewOrder::grade);
  ASSERT_EQ(sorted.size(), 240U);
  for (std::size_t i = 0; i < sorted.size(); ++i) EXPECT_EQ(lists.facts(sorted[i])->grade, i < 80 ? 1 : 2);
  // A character in two lists comes once.
  EXPECT_EQ(learning_order(lists, {"list:trees", "tag:exam", "list:gone", "list:trees"}, NewOrder::own),
            U"森林一木");
  EXPECT_EQ(learning_order(lists, {"list:trees", "tag:exam"}, NewOrder::strokes), U"一木林森");
  EXPECT_EQ(learning_order(lists, {"list:trees", "tag:exam"}, NewOrder::components), U"一木林森");
  EXPECT_EQ(learning_order(lists, {"secondary"}, NewOrder::grade), members("secondary"));
  EXPECT_EQ(learning_order(lists, {}, NewOrder::grade), U"");
}

/// Invented facts: letters stand for characters.
const CharacterFacts* made_up(char32_t c) {
  static const std::map<char32_t, CharacterFacts> kFacts{{U'a', {U'a', 2, 5, 4, 3, {}}},
                                                         {U'b', {U'b', 1, 9, 4, 3, {}}},
                                                         {U'c', {U'c', 1, {}, 4, 2, {}}},
                                                         {U'd', {U'd', {}, 7, 4, 1, {}}},
                                                         {U'e', {U'e', {}, {}, 4, 9, {}}},
                                                         {U'f', {U'f', {}, {}, 4, 3, {}}},
                                                         {U'g', {U'g', 1, 9, 4, 3, {U'h', U'g', U'x', U'c'}}},
                                                         {U'h', {U'h', 3, 1, 4, 8, {U'a', U'g'}}}};
  const auto found = kFacts.find(c);
  return found == kFacts.end() ? nullptr : &found->second;
}

std::u32string sorted(std::u32string_view characters, NewOrder order) {
  const auto all = sort_for_learning({characters.begin(), characters.end()}, order, made_up);
  return {all.begin(), all.end()};
}

TEST(LearningOrder, WhatIsNotKnownComesLastAndEqualOnesStayAsTheyCame) {
  EXPECT_EQ(sorted(U"zcyaeb", NewOrder::own), U"zcyaeb");
  EXPECT_EQ(sorted(U"zceyadbg", NewOrder::frequency), U"adbgcezy");
  EXPECT_EQ(sorted(U"zceyagdbf", NewOrder::strokes), U"dcagbfezy");
  // Kana, which have neither grade nor rank, come first; a rank without a grade comes after the grades.
  EXPECT_EQ(sorted(U"zcfyaedb", NewOrder::grade), U"febcadzy");
}

TEST(LearningOrder, KanaComeFirstAndAsTheTableHasThemInEveryOrderButTheOwn) {
  for (const NewOrder order :
       {NewOrder::grade, NewOrder::frequency, NewOrder::strokes, NewOrder::components}) {
    EXPECT_EQ(sorted(U"aきがあゃんかアイ", order), U"あかきんゃがアイa") << name_of(order);
    EXPECT_EQ(sorted(U"イかアあ", order), U"アイあか") << "the syllabary that was chosen first";
  }
  EXPECT_EQ(sorted(U"aきがあ", NewOrder::own), U"aきがあ");
}

TEST(LearningOrder, PartsComeFirstByTheirStrokesAndRingsAreBroken) {
  // g is made of c (2 strokes), h (8) and itself; h of a and of g again.
  EXPECT_EQ(sorted(U"ahgc", NewOrder::components), U"cahg");
  EXPECT_EQ(sorted(U"gh", NewOrder::components), U"hg");
  EXPECT_EQ(sorted(U"hb", NewOrder::components), U"bh") << "parts that are not wanted do not come";
}

std::string refusal(const std::string& text) {
  const auto list = parse_list(text, [](char32_t c) { return c >= 0x3041; });
  return list ? std::string() : base::to_line(list.error());
}

TEST(ListText, NamesTheLineAndTheCharacterThatIsNone) {
  EXPECT_THAT(refusal("休\n\n木a"), testing::AllOf(HasSubstr("line 3"), HasSubstr("'a' (U+0061)")));
  EXPECT_THAT(refusal("休\x7F"), HasSubstr("'?' (U+007F)"));
  EXPECT_THAT(refusal("休\xC2\x80"), HasSubstr("'?' (U+0080)"));
  EXPECT_THAT(refusal("休\xC2\x9F"), HasSubstr("'?' (U+009F)"));
  EXPECT_THAT(refusal("休\xC2\xA0"), HasSubstr("'\xC2\xA0' (U+00A0)"));
  EXPECT_THAT(refusal("休\x1F"), HasSubstr("'?' (U+001F)"));
  EXPECT_THAT(refusal("休~"), HasSubstr("'~'"));
  EXPECT_THAT(refusal("休!"), HasSubstr("'!'"));
  EXPECT_EQ(refusal("休 \t\r,;　、，・木"), "");
  EXPECT_EQ(refusal("休"), "");
  EXPECT_THAT(refusal(""), HasSubstr("no character"));
  EXPECT_THAT(refusal("\n\n#休\n"), HasSubstr("no character"));
  EXPECT_EQ(must(parse_list("休木休#木\n林", [](char32_t) { return true; })),
            (std::vector{U'休', U'木', U'林'}));
}

TEST(ListText, HoldsTwentyThousandCharactersAtMost) {
  std::string text;
  for (char32_t c = 0x4E00; c < 0x4E00 + 20'000; ++c) text += base::encode_utf8(c);
  EXPECT_EQ(refusal(text), "");
  EXPECT_EQ(refusal(text + "\n一"), "") << "it stands there already";
  EXPECT_THAT(refusal(text + "\nあ"), testing::AllOf(HasSubstr("line 2"), HasSubstr("at most 20000")));
}

}  // namespace
}  // namespace nazori::study
