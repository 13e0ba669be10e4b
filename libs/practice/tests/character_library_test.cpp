// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/character_library.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "database_under_test.h"

namespace nazori::practice {
namespace {

/// A library, and all its answers.
struct LibraryUnderTest {
  explicit LibraryUnderTest(const std::filesystem::path& path = test::database()) : library(inbox, path) {
    library.opened.connect([this](const std::vector<kanji::Source>& from) { sources.push_back(from); });
    library.failed.connect([this](const base::Error& error) { failures.push_back(error); });
    library.listed.connect(
        [this](kanji::List which, const Summaries& all) { lists.emplace_back(which, all); });
    library.found.connect(
        [this](const std::string& text, const auto& answer) { searches.emplace_back(text, answer); });
    library.tables_ready.connect([this](const auto& all) { tables.push_back(all); });
    library.drill_ready.connect([this](const auto& facts) { drills.push_back(facts); });
    library.sheet_ready.connect(
        [this](const std::shared_ptr<const CharacterSheet>& sheet) { sheets.push_back(sheet); });
    library.sheet_missing.connect([this](char32_t character) { missing.push_back(character); });
  }
  template <class List>
  void wait_for(const List& list, std::size_t count) {
    inbox.run_until([&] { return list.size() >= count; });
  }

  std::vector<std::vector<kanji::Source>> sources;
  std::vector<base::Error> failures;
  std::vector<std::pair<kanji::List, Summaries>> lists;
  std::vector<std::pair<std::string, std::shared_ptr<const SearchAnswer>>> searches;
  std::vector<std::shared_ptr<const CharacterSheet>> sheets;
  std::vector<char32_t> missing;
  std::vector<std::shared_ptr<const CharacterTables>> tables;
  std::vector<std::vector<ConfusableFacts>> drills;
  base::Inbox inbox;
  CharacterLibrary library;
};

TEST(CharacterLibrary, NamesTheSourcesOfItsDatabaseOnceItIsOpen) {
  LibraryUnderTest under;
  under.wait_for(under.sources, 1);
  EXPECT_TRUE(std::any_of(under.sources[0].begin(), under.sources[0].end(),
                          [](const kanji::Source& source) { return source.name == "KanjiVG"; }));
}

TEST(CharacterLibrary, ASheetHasTheStrokesPartsRadicalAndWordsOfACharacter) {
  LibraryUnderTest under;
  under.library.request_sheet(U'休');
  under.wait_for(under.sheets, 1);
  const auto& sheet = *under.sheets[0];
  EXPECT_EQ(sheet.character.code_point, U'休');
  EXPECT_EQ(sheet.character.strokes.size(), 6U);
  ASSERT_EQ(sheet.parts.size(), 2U);
  EXPECT_EQ(sheet.parts[0].element, "亻");
  EXPECT_EQ(sheet.parts[0].target, U'亻') << "it can be shown itself";
  EXPECT_EQ(sheet.parts[0].original, "人");
  EXPECT_EQ(sheet.parts[1].element, "木");
  EXPECT_EQ(sheet.parts[1].target, U'木');
  EXPECT_NE(sheet.parts[1].meaning.find("tree"), std::string::npos);
  ASSERT_TRUE(sheet.radical);
  EXPECT_EQ(sheet.radical->number, 9);
  EXPECT_TRUE(std::any_of(sheet.words.begin(), sheet.words.end(),
                          [](const kanji::Word& word) { return word.text == "休日"; }));
  EXPECT_LE(sheet.words.size(), static_cast<std::size_t>(CharacterLibrary::kMaxWords));
}

TEST(CharacterLibrary, ASheetHasTheWordsThatCanBeDictated) {
  LibraryUnderTest under;
  under.library.request_sheet(U'休');
  under.wait_for(under.sheets, 1);
  const auto& words = under.sheets[0]->dictation;
  EXPECT_TRUE(std::any_of(words.begin(), words.end(),
                          [](const DictationWord& one) { return one.word.text == "休日"; }));
  for (const auto& word : words) EXPECT_LE(word.characters.size(), kMostDictated) << word.word.text;
}

TEST(CharacterLibrary, CharactersComeInTheOrderThatWasAskedForWithoutThoseThatCannotBeDrawn) {
  LibraryUnderTest under;
  std::vector<std::vector<char32_t>> answers;
  under.library.characters_ready.connect([&](const std::vector<kanji::Character>& found) {
    auto& answer = answers.emplace_back();
    for (const auto& one : found) answer.push_back(one.code_point);
  });
  under.library.request_characters({U'日', U'☃', U'休'});
  under.wait_for(answers, 1);
  EXPECT_EQ(answers[0], (std::vector<char32_t>{U'日', U'休'}));
}

TEST(CharacterLibrary, ACharacterWithoutStrokesIsMissing) {
  LibraryUnderTest under;
  under.library.request_sheet(U'☃');
  under.wait_for(under.missing, 1);
  EXPECT_EQ(under.missing, std::vector{U'☃'});
  EXPECT_TRUE(under.sheets.empty());
}

TEST(CharacterLibrary, ListsAndSearchesCarryWhatWasAskedFor) {
  LibraryUnderTest under;
  under.library.request_list(kanji::List::grade_1);
  under.library.request_search("yasumu");
  under.wait_for(under.lists, 1);
  under.wait_for(under.searches, 1);
  EXPECT_EQ(under.lists[0].first, kanji::List::grade_1);
  EXPECT_EQ(under.lists[0].second->size(), 80U) << "the kanji of the first school year";
  EXPECT_EQ(under.searches[0].first, "yasumu");
  ASSERT_FALSE(under.searches[0].second->rows.empty());
  EXPECT_EQ(under.searches[0].second->rows.front().character.code_point, U'休');
}

TEST(CharacterLibrary, ASearchMayBeAmongCharactersOfTheLearner) {
  LibraryUnderTest under;
  under.library.request_search("list:mine", std::vector<char32_t>{U'木', U'休'});
  under.wait_for(under.searches, 1);
  EXPECT_EQ(under.searches[0].second->characters, 2);
}

TEST(CharacterLibrary, ReadsTheTablesAndWhatADrillNeeds) {
  LibraryUnderTest under;
  under.library.request_tables();
  under.library.request_drill({U'待', U'持'});
  under.wait_for(under.tables, 1);
  under.wait_for(under.drills, 1);
  EXPECT_EQ(under.tables[0]->radicals.size(), 214U);
  const auto choice = under.tables[0]->picker.choose({"木", "亻"});
  EXPECT_NE(std::find(choice.characters.begin(), choice.characters.end(), U'休'), choice.characters.end());
  ASSERT_EQ(under.drills[0].size(), 2U);
  EXPECT_EQ(under.drills[0][0].meaning, "wait");
}

TEST(CharacterLibrary, ASheetHasWordsThatHelpAndCharactersThatAreConfused) {
  LibraryUnderTest under;
  under.library.request_sheet(U'土');
  under.wait_for(under.sheets, 1);
  EXPECT_FALSE(under.sheets[0]->helpful.words.empty());
  ASSERT_FALSE(under.sheets[0]->confusables.empty());
  EXPECT_EQ(under.sheets[0]->confusables[0].code_point, U'士');
  EXPECT_EQ(under.sheets[0]->confusables[0].strokes.size(), 3U);
}

TEST(CharacterLibrary, OfSeveralRequestsOfOneKindTheNewestIsAnswered) {
  LibraryUnderTest under;
  for (const char32_t character : {U'木', U'人', U'永', U'休'}) under.library.request_sheet(character);
  under.library.request_list(kanji::List::grade_2);
  under.wait_for(under.lists, 1);
  ASSERT_FALSE(under.sheets.empty()) << "another kind of request does not replace it";
  EXPECT_EQ(under.sheets.back()->character.code_point, U'休');
}

TEST(CharacterLibrary, WithoutADatabaseItFailsOnceAndAnswersNothing) {
  LibraryUnderTest under("/nowhere/kanji.db");
  under.library.request_list(kanji::List::grade_1);
  under.library.request_sheet(U'休');
  under.wait_for(under.failures, 1);
  bool is_past = false;
  under.inbox.post([&] { is_past = true; });
  under.inbox.run_until([&] { return is_past; });
  EXPECT_EQ(under.failures.size(), 1U);
  EXPECT_TRUE(under.lists.empty());
  EXPECT_TRUE(under.sheets.empty());
  EXPECT_TRUE(under.missing.empty());
}

TEST(CharacterLibrary, MayEndWhileItAnswers) {
  for (int round = 0; round < 3; ++round) {
    LibraryUnderTest under;
    for (const char32_t character : {U'休', U'木'}) {
      under.library.request_search("mountain");
      under.library.request_sheet(character);
    }
    if (round > 0) under.wait_for(under.sheets, 1);
    under.library.request_sheet(U'休');
  }
}

}  // namespace
}  // namespace nazori::practice
